"""Which links of an arm an equation tells of, and of which another one would make it right."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.rigid import is_none_by_a_slip, is_rotation
from armproof.verification.equations.sides import Members
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.tables.arms.turns import lengths_alike, links_of_one_entry, rows_told
from armproof.verification.verdict import AXES, Verdict

# beside its links: where a chain's frames lie, which of its joints comes first, and how the joint before an inner one turns
FRAMES, ORDER, TOLD = 0, -1, -2
HEIGHTS = -6  # of which coordinates an equation tells what they hold without a joint, x first
# how the frames between base and tool lie, the first one's next to it: the tool's pose tells nothing of them
INNER = -9
OF_TOOL = ("closed form", "description")  # sources that tell nothing of the frames between base and tool
_MOVES = ("jacobian", "velocity", "determinant")
_TURNS = frozenset(["rotation", "axis"])


def links_of(outcome: Outcome, members: Members, source: str = "", told_by: str = "") -> frozenset[int]:
    """Return the links of the arm that an equation tells of: those that its quantities span, beside a formula without any.

    One that is wrong of an angle of the table tells of that row. A closed form leaves open the frames of the arm, and the
    order of joints without numbers; a law of cosines leaves open the joint before the one whose cosine it is.
    """
    if told_by and told_by in map(bare_key, outcome.nodes):
        return frozenset({TOLD})
    if outcome.conditions:  # where det J = 0 holds of many arms: that confirms none of its links
        nodes = outcome.conditions if outcome.verdict is Verdict.REFUTED else ()
        return _links([each for node in nodes for each in _quantities(node, members)], members, source)
    if outcome.verdict is Verdict.REFUTED and (rows := _angle_rows(outcome, members)):
        return rows
    if outcome.true is None or outcome.printed is None:
        return frozenset()
    one, other = outcome.true.node, outcome.printed.node
    told, others = _quantities(one, members), _quantities(other, members)
    if source == "figure":  # which tells all axes: a vector along them tells of these
        return _links([*told, *others], members, source)
    if source in OF_TOOL:  # q_3 = h - z tells of z
        told, others = [*told, *_rates(one, members)], [*others, *_rates(other, members)]
        is_of_one = not (told and others) or outcome.verdict is Verdict.REFUTED
        is_linear = not any(_multiplies_moves(below, members) for side in (one, other) for below in n.walk(side))
        links = _links([*told, *others], members, source, is_linear) if is_of_one else frozenset()
        heights = range(HEIGHTS - 2, HEIGHTS + 1)
        return links - frozenset(heights) if _moves_otherwise(outcome, members) else links
    if others or _rates(other, members):
        return frozenset()
    links = _links(told, members, source)
    if source == "table" and outcome.verdict is Verdict.REFUTED and outcome.pair is not None:
        return links - lengths_alike(outcome.pair, links, members)
    only_turns = source == "matrices" and outcome.verdict is Verdict.PROVED and {each.kind for each in told} <= _TURNS
    return frozenset(link for link in links if not (only_turns and _is_long(link, members)))


def _is_long(link: int, members: Members) -> bool:
    """Whether a link has a length, of which the rotations of its arm tell nothing."""
    assert members.names.arm is not None
    frames = members.names.arm.frames
    return not is_zero(members.exact.quantity(Quantity("origin", frames[link], frames[link - 1])))


def _is_hand(link: int, members: Members) -> bool:
    """Whether a joint turns a link about the origin of its frame: where a point is tells nothing of it."""
    assert members.names.arm is not None
    frames, depth = members.names.arm.frames, trace_of(members.names.arm).depth
    return depth(frames[link]) > depth(frames[link - 1]) and not _is_long(link, members)


def _moves_otherwise(outcome: Outcome, members: Members) -> bool:
    """Whether what is printed for a coordinate differs by what a joint moves: its rate tells that it is wrong, whatever is constant in it."""
    pair, arm = outcome.pair, members.names.arm
    if outcome.verdict is not Verdict.REFUTED or outcome.true is None or pair is None or not pair.is_scalar:
        return False
    quantity = members.quantity_of(bare(outcome.true.node))
    if arm is None or quantity is None or quantity.kind != "origin":
        return False
    apart = pair.true.rows[0][0] - pair.printed.rows[0][0]
    return not symbols_in([apart.normal()]).isdisjoint(joint.symbol for joint in arm.joints)


def _multiplies_moves(node: n.Node, members: Members) -> bool:
    """Whether a node multiplies a Jacobian or a velocity by one, or takes its size: J J^T and |v| are the same of -x."""
    if isinstance(node, n.Power):
        return _moves(node.base, members)
    if n.is_call(node, "abs", "norm"):
        return any(_moves(each, members) for each in node.arguments)
    factors = node.factors if isinstance(node, n.Product) else ()
    return sum(_moves(factor, members) for factor in factors) > 1


def _moves(node: n.Node, members: Members) -> bool:
    return any(quantity.kind in _MOVES for quantity in (*_quantities(node, members), *_rates(node, members)))


def _links(quantities: Sequence[Quantity], members: Members, source: str, is_linear: bool = False) -> frozenset[int]:
    if source == "table":
        return frozenset(link for each in quantities for link in rows_told(each, _span(each, members), members))
    links = frozenset(link for quantity in quantities for link in _span(quantity, members))
    if source not in OF_TOOL:
        return links
    if links and all(map(_is_of_place, quantities)) and _is_hand(max(links), members):
        links -= {max(links)}
    axes = (_axes(quantity, members) for quantity in quantities if is_linear)
    return links.union(*(_untold(quantity, members) for quantity in quantities), *axes)


def _is_of_place(quantity: Quantity) -> bool:
    """Whether a quantity tells where a point is or how it moves, and of no turn."""
    return quantity.kind == "origin" or (quantity.kind in _MOVES and max(quantity.rows or (6,)) <= 3)


def _axes(quantity: Quantity, members: Members) -> Iterator[int]:
    """Yield the coordinates of the tool that a quantity tells of, and of which it tells what they hold without a joint: its rates do not."""
    arm = members.names.arm
    if arm is None or (quantity.frame, quantity.reference) != (arm.frames[-1], arm.frames[0]):
        return
    if quantity.kind not in ("origin", "pose", *_MOVES):
        return
    place = members.exact.quantity(Quantity("origin", quantity.frame, quantity.reference))
    axes = [row - 1 for row in quantity.rows or (1, 2, 3) if row <= 3 and not place.rows[row - 1][0].is_zero()]
    yield from (AXES - axis for axis in axes)
    if quantity.kind in ("origin", "pose"):
        joints = {joint.symbol for joint in arm.joints}
        yield from (HEIGHTS - axis for axis in axes if _has_constant(place.rows[axis][0], joints))


def _has_constant(value: Scalar, joints: set[str]) -> bool:
    """Whether a coordinate has a term without any joint."""
    terms = value.ring.terms(value.normal().numerator)
    return any(joints.isdisjoint(name for _, name in powers) for powers, _ in terms)


def _untold(quantity: Quantity, members: Members) -> Iterable[int]:
    """Yield what the coordinates of a tool do not tell of a quantity."""
    arm = members.names.arm
    if arm is None or quantity.kind in ("joint", "link", "vector"):
        return
    of_tool = ("origin", "jacobian", "velocity", "angle", "task", "determinant", "manipulability")
    if quantity.kind not in of_tool or (quantity.frame, quantity.reference) != (arm.frames[-1], arm.frames[0]):
        yield FRAMES
    yield from (INNER - k for k, frame in enumerate(arm.frames[1:-1]) if frame in (quantity.frame, quantity.reference))
    has_columns = quantity.kind in ("jacobian", "determinant", "vector")
    if has_columns and not all(joint.symbol[-1].isdigit() for joint in arm.joints):
        yield ORDER


def _angle_rows(outcome: Outcome, members: Members) -> frozenset[int]:
    """Return the links of the table's angles in an equation that tells of no quantity: θ_2 = q_2 + π/2."""
    arm, names = members.names.arm, members.names
    if arm is None or any(_quantities(node, members) for node in outcome.nodes):
        return frozenset()
    keys = {below.key for node in outcome.nodes for below in n.names(node)}
    symbols = {s for key in keys if (s := names.known_symbol(key)) is not None and names.table_row(s, key) is not None}
    depths = [trace_of(arm).depth(frame) for frame in arm.frames]
    return frozenset(depths.index(arm.joint(symbol).index) for symbol in symbols)


def links_that_explain(outcome: Outcome, members: Members) -> frozenset[int]:
    """Return the links of which another than the arm's would make a printed pose right: it depends on their joint alone.

    Of what is no pose that is told of one entry alone; else only that no one link's angle does, 0.
    """
    if rows := _angle_rows(outcome, members):
        return rows
    arm, value = members.names.arm, outcome.printed.value if outcome.printed is not None else None
    quantity = members.quantity_of(outcome.true.node) if outcome.true is not None else None
    if (
        arm is None
        or quantity is None
        or not isinstance(value, Matrix)
        or (quantity.kind, value.shape) not in (("pose", (4, 4)), ("rotation", (3, 3)))
    ):
        return links_of_one_entry(outcome, quantity, members)
    if not is_rigid(value):
        return frozenset()
    size, whole = value.shape[0], value if quantity.kind == "pose" else _about_origin(value, members)
    frames, pose, depth = arm.frames, members.exact.pose, trace_of(arm).depth
    links = {k: (frames[k - 1], frames[k]) for k in _span(quantity, members)}
    ends = (frames[min(links) - 1], frames[max(links)]) if links else ("", "")
    if (quantity.reference, quantity.frame) != ends:
        return frozenset(links)
    sides = {k: (pose(ends[0], near), pose(far, ends[1])) for k, (near, far) in links.items()}
    left_over = {k: (one @ whole @ other).block(range(size), range(size)) for k, (one, other) in sides.items()}
    moving = {joint.symbol for joint in arm.joints}
    own = {k: {joint.symbol for joint in arm.joints[depth(near) : depth(far)]} for k, (near, far) in links.items()}
    may_be = {k: link for k, link in left_over.items() if moving & _symbols(link) <= own[k]}
    convention = arm.dh.convention if arm.dh is not None else ""
    return frozenset(k for k, link in may_be.items() if not own[k] or not convention or _has_row(link, convention))


def is_of_no_arm(outcome: Outcome, members: Members) -> bool:
    """Whether what is printed for a rotation, a pose or an axis of the arm is none, by a slip: it is wrong whatever the arm is."""
    quantity = members.quantity_of(outcome.true.node) if outcome.true is not None else None
    if quantity is None or quantity.kind not in ("pose", "rotation", "axis") or outcome.pair is None:
        return False
    return not quantity.scalar and is_none_by_a_slip(outcome.pair.true, outcome.pair.printed)


def _about_origin(rotation: Matrix, members: Members) -> Matrix:
    """Return the pose that turns as a rotation does, and shifts nothing."""
    nought, one = (members.exact.rational(Fraction(k)) for k in (0, 1))
    return Matrix((*((*row, nought) for row in rotation.rows), (nought, nought, nought, one)))


def _has_row(link: Matrix, convention: str) -> bool:
    """Whether a pose, or its rotation, may be that of a row in a DH table: it shifts along the new x and the old z, or the old x and the new z."""
    rows = link.rows
    if link.shape == (3, 3):
        return (rows[2][0] if convention == "classic" else rows[0][2]).is_zero()
    flat, (one, other) = (rows[2][0], (0, 1)) if convention == "classic" else (rows[0][2], (1, 2))
    along = 0 if convention == "classic" else 2
    beside = rows[one][3] * rows[other][along] - rows[other][3] * rows[one][along]
    return flat.is_zero() and beside.normal().is_zero()


def is_rigid(pose: Matrix) -> bool:
    """Whether a 4×4 matrix may be a pose: its rotation is one, or has decimals that may be rounded."""
    rotation = pose.block(range(3), range(3))
    if any(number is not None and number.denominator > 1 for number in (cell.as_fraction() for cell in rotation.cells)):
        return True
    return is_rotation(rotation)


def _symbols(value: Matrix) -> set[str]:
    return symbols_in([cell.normal() for cell in value.cells])


def _quantities(side: n.Node, members: Members) -> list[Quantity]:
    found = (members.quantity_of(node) or _up_to_the_arm(node, members) for node in n.walk(side))
    return [quantity for quantity in found if quantity is not None]


def _rates(side: n.Node, members: Members) -> list[Quantity]:
    """Return the velocities of the places whose rates stand in a side."""
    dotted = (node for node in n.names(side) if node.dots)
    found = (members.quantity_of(replace(name, dots=0)) for name in dotted)
    return [
        replace(quantity, kind="velocity", rows=quantity.rows or (1, 2, 3))
        for quantity in found
        if quantity is not None and quantity.kind == "origin"
    ]


def _up_to_the_arm(node: n.Node, members: Members) -> Quantity | None:
    """Return the pose of the arm's frame within one of a frame that the document fixed on it: {}^0T_6 of {}^0T_G."""
    added = members.names.added_frame(node) if isinstance(node, n.Name) else None
    return Quantity("pose", added[1], added[0]) if added is not None else None


def _span(quantity: Quantity, members: Members) -> Iterable[int]:
    arm = members.names.arm
    if arm is None or quantity.kind in ("joint", "link", "vector"):
        return ()
    ends = [arm.frames.index(frame) for frame in (quantity.frame, quantity.reference)]
    return range(min(ends) + 1, max(ends) + 1)
