"""Whether a refuted equation was understood: what may be meant otherwise is left open, and not refuted."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

from armproof.verification.algebra.calculus import angles_in, are_rates, is_rate, symbol_of, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix, as_scalar, is_zero
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.stages import goes_on
from armproof.verification.equations.alignment import is_constant, is_near
from armproof.verification.equations.given_values import keys_alone
from armproof.verification.equations.other_screws import of_other_screws
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.rigid import is_rotation, misses_group
from armproof.verification.equations.shorthands import digits_of
from armproof.verification.equations.sides import Member
from armproof.verification.equations.unit_vectors import holds_for_unit_vector
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Role

SIZES = (
    Kind.WRONG_SIZE, Kind.WRONG_SIZE_OF_VALUE, Kind.SUM_OF_SIZES, Kind.PRODUCT_OF_SIZES, Kind.SUM_WITH_SCALAR,
    Kind.NO_INVERSE_OF_SIZE, Kind.NO_DETERMINANT, Kind.NO_COFACTORS, Kind.SCALAR_FOR_BLOCK,
)  # fmt: skip
BLOCKS = (Kind.SCALAR_FOR_BLOCK, Kind.RAGGED_BLOCKS, Kind.RAGGED_BLOCK_ROWS)
ELEMENTARY = ("Rot", "Rot3", "Trans")
TRIGONOMETRY = ("cos", "sin", "tan", "cot", "sec", "csc", "acos", "asin", "atan", "atan2", *ELEMENTARY)


def without_misreading(outcome: Outcome, chain: n.Chain, names: Names, erratum: bool, is_closed: bool) -> Outcome:
    """Return a refuted outcome, or an unchecked one where it was not understood.

    An erratum is said to be more than a slip; where `is_closed`, each letter is known to have one meaning.
    """
    reason = _rotation_for_pose(outcome, names) or _own_name(chain, names) or _determinant(outcome, names)
    reason = reason or _numbered_twice(chain) or _turned_tool(outcome, names) or _on_both_sides(outcome, names)
    reason = reason or _function_or_factor(chain) or _power_of_angle(chain) or _of_other_size(chain, names)
    if names.arm is None and not is_closed:
        reason = reason or holds_for_unit_vector(outcome)
        is_open = reason is None and bool(names.reader.spelling.screws)
        reason = of_other_screws(outcome) if is_open else reason
    if names.arm is not None or not erratum:
        reason = reason or sizes_of_convention(outcome, chain, names)
    if not is_closed:
        reason = reason or _gives_rates(outcome, names) or _nothing_to_compare(outcome, chain, names, erratum)
    return outcome if reason is None else outcome.left_open(reason)


def _rotation_for_pose(outcome: Outcome, names: Names) -> Finding | None:
    """A 3×3 matrix without a translation may be the rotation of what convention calls a pose."""
    if [value.shape for value in outcome.matrices] != [(4, 4), (3, 3)]:
        return None
    (true, printed), name = outcome.matrices, bare(outcome.nodes[0])
    by_convention = isinstance(name, n.Name) and _quantity(name, names) and name.key not in names.quantities
    if not by_convention or not all(is_zero(row[2]) for row in printed.rows[:2]):
        return None
    return say(Kind.SIZES_OF_CONVENTION, reason=say(Kind.WRONG_SIZE, printed=printed.size, correct=true.size))


def _determinant(outcome: Outcome, names: Names) -> Finding | None:
    """J = l_1 l_2 s_2: a scalar beside the name of a Jacobian may be its determinant."""
    if outcome.true is None or outcome.printed is None or not isinstance(as_scalar(outcome.printed.value), Scalar):
        return None
    name = bare(outcome.true.node)
    is_matrix = isinstance(outcome.true.value, Matrix)  # J_{11} is an entry
    quantity = names.quantity(name) if isinstance(name, n.Name) and is_matrix else None
    is_jacobian = quantity is not None and quantity.kind == "jacobian" and name.key not in names.quantities  # type: ignore[attr-defined]
    return say(Kind.DETERMINANT_MEANT, name=name.text) if is_jacobian else None  # type: ignore[attr-defined]


def _turned_tool(outcome: Outcome, names: Names) -> Finding | None:
    """A second {}^0T_G = {}^0T_G R, with quarter turns R: the axes of a tool may be placed in several ways."""
    shapes, name = [value.shape for value in outcome.matrices], bare(outcome.nodes[0]) if outcome.nodes else None
    if shapes not in ([(3, 3)] * 2, [(4, 4)] * 2) or not isinstance(name, n.Name) or names.added_frame(name) is None:
        return None
    return say(Kind.TURNED_TOOL, name=name.text) if _differ_by_quarter_turns(*outcome.matrices) else None


def _differ_by_quarter_turns(true: Matrix, printed: Matrix) -> bool:
    """Whether two poses or rotations of a frame have one origin, and axes that quarter turns bring upon each other."""
    rotation = range(3)
    turn = true.block(rotation, rotation).transpose @ printed.block(rotation, rotation)
    beside = [(true.rows[r][c], printed.rows[r][c]) for r, c in true.places if r > 2 or c > 2]
    if not is_constant(turn) or not all(is_zero(one - other) for one, other in beside):
        return False
    numbers = [[cell.as_fraction() for cell in row] for row in turn.rows]
    permutes = all(sorted(map(abs, row)) == [0, 0, 1] for row in [*numbers, *zip(*numbers, strict=True)])
    return permutes and turn.determinant().as_fraction() == 1


def _gives_rates(outcome: Outcome, names: Names) -> Finding | None:
    """q̇ = J^{-1} (0.1, 0.2)^T says how fast the joints are to move: rates alone on one side, on the other numbers or angles and no rate.

    So does ‖q̇‖ = 1, which is said of all rates together, and the law of one joint alone, q̇_1 = -q_1.
    """
    if outcome.pair is None:
        return None
    numbers = any(isinstance(b, n.Number) and b.value for node in outcome.nodes for b in n.walk(node))
    sides = [outcome.pair.true.cells, outcome.pair.printed.cells]
    for rates, others in (sides, sides[::-1]):
        if symbols_in(rates) and all(map(is_rate, symbols_in(rates))) and not symbols_in(others) and len(rates) == 1:
            return say(Kind.GIVES_RATES)
        if not are_rates(rates) or any(map(is_rate, symbols_in(others))):
            continue
        if numbers or any(map(angles_in, others)) or any(_is_rate_of_joint(each, names) for each in outcome.nodes):
            return say(Kind.GIVES_RATES)
    return None


def _is_rate_of_joint(node: n.Node, names: Names) -> bool:
    """Whether a side is the rate of a joint alone: ω_z = θ_1 + θ_2 lacks dots, and is no law."""
    name = bare(node)
    return isinstance(name, n.Name) and name.dots > 0 and names.known_symbol(name.undotted.key) in names.joints


def _numbered_twice(chain: n.Chain) -> Finding | None:
    """T_2^1 = T_1^0 = […]: two names of one link, whose frames are counted from another number in each."""
    alone = [name for name in map(bare, chain.members) if isinstance(name, n.Name) and name.base in "TAHR"]
    for one, other in pairwise(alone):
        scripts = [(name.pre_sup, name.sup, name.pre_sub, name.sub) for name in (one, other)]
        steps = [(int(b) - int(a)) if a.isdigit() and b.isdigit() else a == b for a, b in zip(*scripts, strict=True)]
        numbers = [step for step in steps if not isinstance(step, bool)]
        if len(numbers) == 2 and len(set(numbers)) == 1 and numbers[0] and all(steps):
            return say(Kind.NUMBERED_TWICE, one=one.text, other=other.text)
    return None


def _on_both_sides(outcome: Outcome, names: Names) -> Finding | None:
    """x = x + 1, sin θ = θ, 𝐱 = (x, y): a letter alone and on the other side too has a new value there, or means two things.

    What is known of the arm has one value: d_3 = d_3 + 2π is wrong. A matrix may be a product of itself and of others: J = J J^+ J.
    """
    for alone, other in (outcome.nodes, outcome.nodes[::-1]) if len(outcome.nodes) == 2 else ():
        name = _of_degrees(bare(alone))
        again = [below for below in n.names(other) if below == name]
        if again and name is not bare(alone):  # θ^∘ = θ · 180/π: how many degrees it is
            return say(Kind.ON_BOTH_SIDES, name=name.text or name.key)  # type: ignore[attr-defined]
        if not again or names.known_symbol(again[0].key) is not None:
            continue
        is_scalar = all(isinstance(side.value, Scalar) for side in outcome.sides)
        is_formula = isinstance(bare(other), n.Sum | n.Call | n.Quotient | n.Product) and not outcome.matrices
        definition = names.state.definitions.get(again[0].key)
        unknown = definition is None or definition.node is None
        is_open = names.arm is None and (is_scalar or is_formula or unknown)
        if is_open or any(bare(cell) == name for cell in _cells(other)):
            return say(Kind.ON_BOTH_SIDES, name=name.text or name.key)  # type: ignore[attr-defined]
    return None


def _function_or_factor(chain: n.Chain) -> Finding | None:
    """x(t + 2) = x(t), u(-t) = -u(t): what is applied in one place is no factor of the brackets behind it in another."""
    below = [each for member in chain.members for each in n.walk(member)]
    applied = {bare_key(each.arguments[0]) for each in below if n.is_call(each, "name")}
    pairs = (
        (pair for each in below if isinstance(each, n.Product) for pair in pairwise(each.factors)) if applied else ()
    )
    factors = (bare_key(first) for first, behind in pairs if isinstance(behind, n.Group))
    found = next((key for key in factors if key is not None and key in applied), None)
    return say(Kind.FUNCTION_OR_FACTOR, name=found) if found is not None else None


def _power_of_angle(chain: n.Chain) -> Finding | None:
    r"""\sin\theta_2^2: the power behind an angle may be that of its sine."""
    calls = (each for member in chain.members for each in n.walk(member) if n.is_call(each, "sin", "cos", "tan"))
    return say(Kind.POWER_OF_ANGLE) if any(isinstance(each.arguments[0], n.Power) for each in calls) else None


def _of_degrees(node: n.Node) -> n.Node:
    return bare(node.base) if isinstance(node, n.Postfix) and node.operator == "deg" else node


def _cells(node: n.Node) -> Iterator[n.Node]:
    """Yield the entries of the matrices and the lists that are written out."""
    for below in n.walk(node):
        yield from below.cells if isinstance(below, n.Matrix) else below.items if isinstance(below, n.Sequence) else ()


def _own_name(chain: n.Chain, names: Names) -> Finding | None:
    """S_1 = π r²: a letter that is a sine elsewhere, equated to what is no expression of joints and has names of its own.

    So is C_{02} = [...]: no cosine is a matrix, or of a joint that the arm lacks.
    """
    for member in chain.members:
        alone = bare(member)
        if not (isinstance(alone, n.Call) and alone.style == "index" and alone.head in ("s", "S", "c", "C")):
            continue
        others = [below for other in chain.members if other is not member for below in n.walk(other)]
        moves = any(isinstance(b, n.JointAngles) or n.is_call(b, *TRIGONOMETRY) for b in others)
        unknown = any(isinstance(b, n.Name) and b.key != "pi" and not _is_bound(b, names) for b in others)
        is_no_cosine = any(isinstance(b, n.Matrix) for b in others) or not _has_its_joints(alone, names)
        if is_no_cosine or (unknown and not moves):
            return say(Kind.OWN_NAME, text=f"{alone.head}_{digits_of(alone)}")
    return None


def _has_its_joints(call: n.Call, names: Names) -> bool:
    """Whether the arm has each joint in the index of c_{12}."""
    sums = [below for below in n.walk(call) if isinstance(below, n.JointAngles)]
    return names.arm is None or all(names.joint_angle(index) is not None for each in sums for _, index in each.terms)


def sizes_of_convention(outcome: Outcome, chain: n.Chain, names: Names) -> Finding | None:
    """Sizes that do not fit tell a slip where the front matter or explicit frames say what the names are, on both sides."""
    if names.arm is None and outcome.findings and outcome.findings[0].kind in (*SIZES, *BLOCKS):
        return say(Kind.NO_ARM_TO_COMPARE)  # a letter may be a column, and a row of letters a matrix
    if not _tells_sizes(outcome):
        return None
    held = [[b for b in n.names(side) if _quantity(b, names)] for side in chain.members]
    if outcome.findings[0].kind is not Kind.SUM_WITH_SCALAR:  # there the scalar may be a vector: ẍ - J̇ q̇
        held = [side if len(side) == 1 else [b for b in side if not _is_scalar(b, names)] for side in held]
    by_convention = [name for side in held for name in side if replace(name, dots=0).key not in names.quantities]
    in_sum = outcome.findings[0].kind is Kind.SUM_WITH_SCALAR  # x_6 of x_6 - d_6 r_13 is a coordinate, and no axis
    explicit = all(_is_explicit(name) and not (in_sum and name.base in tuple("xyz")) for name in by_convention)
    points = outcome.findings[0].kind is Kind.PRODUCT_OF_SIZES  # O_0 O_2 is a vector between points, and no product
    elementary = any(n.is_call(b, *ELEMENTARY) for m in chain.members for b in n.walk(m))
    understood = all(held) or elementary or _are_columns(outcome)
    axes = outcome.findings[0].kind is Kind.SUM_WITH_SCALAR and any(_is_axis(name, names) for name in by_convention)
    if not by_convention or (explicit and not points and not axes and understood):
        return None
    doubt = say(Kind.SIZES_OF_CONVENTION, reason=outcome.findings[0])
    names.state.other_sizes |= {name.key: doubt for name in by_convention if name in map(bare, chain.members)}
    return doubt


def _of_other_size(chain: n.Chain, names: Names) -> Finding | None:
    """What is said of a J that was printed as a matrix of another size may be meant of that one."""
    held = (b.key for member in chain.members for b in n.names(member))
    return next((names.state.other_sizes[key] for key in held if key in names.state.other_sizes), None)


def _tells_sizes(outcome: Outcome) -> bool:
    return bool(outcome.findings) and outcome.findings[0].kind in SIZES


def _quantity(name: n.Name, names: Names) -> bool:
    """Whether a name stands for a quantity of the arm, by the front matter or by convention."""
    plain = replace(name, dots=0)
    return names.known_symbol(plain.key) is None and names.quantity(plain) is not None


def _is_scalar(name: n.Name, names: Names) -> bool:
    quantity = names.quantity(replace(name, dots=0))
    return quantity is not None and quantity.scalar


def _is_axis(name: n.Name, names: Names) -> bool:
    """Whether a name is usually an axis of a frame: x_6 beside a scalar is a coordinate."""
    quantity = names.quantity(replace(name, dots=0))
    return quantity is not None and not quantity.scalar and name.base in ("x", "y", "z") and not name.pre_sup


def _is_explicit(name: n.Name) -> bool:
    """Whether a name says of which frame it is."""
    return any(character.isdigit() for character in name.sub + name.sup + name.pre_sub + name.pre_sup)


def _are_columns(outcome: Outcome) -> bool:
    return all(isinstance(side.value, Matrix) and side.value.shape[1] == 1 for side in outcome.sides)


def _nothing_to_compare(outcome: Outcome, chain: n.Chain, names: Names, erratum: bool) -> Finding | None:
    """Without an arm, only a slip can be told: in an identity, or in what the document has defined. All else may be meant otherwise.

    Letters that the other side lacks make an equation a definition or a law of letters that nothing else binds.
    """
    if names.arm is not None or outcome.role is Role.LAW or _tells_sizes(outcome) or _misses_its_group(outcome):
        return None
    below = [each for member in chain.members for each in n.walk(member)]
    written = any(isinstance(b, n.Matrix) for b in below)
    if any(isinstance(b, n.Name) and ((b.pre_sup and not written) or b.key in names.quantities) for b in below):
        return None  # a law of link matrices
    is_anew = _is_to_vanish(outcome, names) or _labels(outcome) or _is_said_anew(chain, names)
    if _gives_letter(outcome, names) or is_anew:
        return say(Kind.NO_ARM_TO_COMPARE)
    state = names.state
    met = sorted((key, line) for key, line in state.consulted if key in state.definitions)
    elsewhere = [] if erratum else met  # what is said to be an error is meant of them
    if other := [each for each in elsewhere if not goes_on(state.definitions[each[0]].section, state.section)]:
        if _breaks_rotation(outcome):
            return None
        return say(Kind.DEFINED_ELSEWHERE, name=other[0][0], line=other[0][1])
    elementary = any(n.is_call(b, *ELEMENTARY) for b in below)
    first, *others = [letters_held(member, names) for member in chain.members]
    defined = [names.state.definitions[key].node for key, _ in names.state.consulted if key in names.state.definitions]
    angles = any(isinstance(b, n.JointAngles) or n.is_call(b, *TRIGONOMETRY) for b in below)
    of_letters = any(_is_of_letters(node) for node in defined if node is not None)  # a rotation obeys more than they do
    numbers = [m for m in chain.members if not letters_held(m, names) and not _is_nought(m)]
    has_value = bool(numbers) and any(map(bare_key, chain.members))  # that of a name alone
    if defined and outcome.true is not None and outcome.printed is not None:
        first, *others = _letters_of(outcome.true, names), _letters_of(outcome.printed, names)
    if defined or angles:  # an identity of angles, or a slip in one
        alike = all(found == first for found in others) and not (defined and (numbers or _gives_name(outcome, chain)))
        is_slip = outcome.pair is not None and is_near(outcome.pair)
        same = all(found == first for found in others)  # what lacks a letter may say that it is zero
        near = erratum or elementary or alike or (same and _are_written(outcome)) or is_slip
        spoken = {key for node in defined if node is not None for key in letters_held(node, names)}
        astray = any(found - first - spoken and first - found for found in others)
        bound = near and not (of_letters or has_value or astray)
    else:
        bound = all(found == first for found in others)
    return None if bound else say(Kind.NO_ARM_TO_COMPARE)


def _misses_its_group(outcome: Outcome) -> bool:
    """Whether a matrix with a slip is printed for a name with two frames: it is to be a rotation or a pose, whatever the arm."""
    true, printed = outcome.true, outcome.printed
    return true is not None and printed is not None and misses_group(bare(true.node), printed.value) != ""


def _breaks_rotation(outcome: Outcome) -> bool:
    """Whether one entry alone parts a printed matrix from a rotation, and makes it none: no other rotation is meant."""
    pair = outcome.pair
    if pair is None or pair.true.shape != (3, 3):
        return False
    wrong = [place for place, true, printed in pair.entries() if not is_zero(true - printed)]
    sides = sorted(is_rotation(side) for side in (pair.true, pair.printed)) if len(wrong) == 1 else []
    return sides == [False, True]


def _gives_letter(outcome: Outcome, names: Names) -> bool:
    """Whether a wrong entry is a letter that nothing binds and that the other side lacks: the equation says what it is."""
    if outcome.pair is None or len(outcome.nodes) != 2:
        return False
    written = [{str(bare_key(cell)) for cell in _cells(side)} for side in outcome.nodes]
    values = (outcome.pair.true.cells, outcome.pair.printed.cells)
    if not all(isinstance(cell, Scalar) for cells in values for cell in cells):
        return False
    alone = [{symbol_of(cell) for cell in cells} for cells in values]
    return any(
        (letters & own) - symbols_in(others)
        for letters, own, others in zip(written, alone, reversed(values), strict=True)
    )


def _labels(outcome: Outcome) -> bool:
    """Whether a number alone is equated to a list: 1 = (0, 1, 0) is how something is written, and no number."""
    numbers = [isinstance(bare(node), n.Number) for node in outcome.nodes]
    lists = [isinstance(bare(node), n.Sequence) for node in outcome.nodes]
    return any(numbers) and any(lists)


def _is_said_anew(chain: n.Chain, names: Names) -> bool:
    """Whether an equation says once more what a joint is, another solution, or a column whose letters another section gave; or of which kind matrices of letters are, A^{-1} = A^T."""
    made = names.state.definitions
    first = bare(chain.members[0])
    if isinstance(first, n.Name) and first.base in ("theta", "q") and first.sub and first.key in made:
        return True
    told = keys_alone(first) & made.keys()
    if told and any(made[key].section not in ("", names.state.section) for key in told):
        return True
    spoken = [below for member in chain.members for below in n.names(member)]
    nodes = [made[each.key].node for each in spoken if each.key in made]
    return len(nodes) == sum(each.key != "I" for each in spoken) and any(map(_is_any_matrix, nodes))


def _is_any_matrix(node: n.Node | None) -> bool:
    """Whether a matrix has a letter of its own in each place."""
    cells = bare(node).cells if node is not None and isinstance(bare(node), n.Matrix) else ()  # type: ignore[attr-defined]
    return bool(cells) and len({bare_key(cell) for cell in cells} - {None}) == len(cells)


def _is_to_vanish(outcome: Outcome, names: Names) -> bool:
    """Whether what depends on letters is equated to 0: that is a condition on them."""
    return any(map(_is_nought, outcome.nodes)) and any(_letters_of(side, names) for side in outcome.sides)


def _gives_name(outcome: Outcome, chain: n.Chain) -> bool:
    """Whether the equation begins with a name alone, which may be given another meaning here."""
    first = chain.members[0]
    return bare_key(first) is not None and first in outcome.nodes


def _are_written(outcome: Outcome) -> bool:
    """Whether a matrix is written out on both sides."""
    return all(any(isinstance(b, n.Matrix) for b in n.walk(side)) for side in outcome.nodes)


def _is_of_letters(node: n.Node) -> bool:
    """Whether a matrix is a rotation of letters alone, n_x, o_x, a_x … or r_{11}, r_{12} …, or a pose with one."""
    cells = [cell for row in node.rows[:3] for cell in row[:3]] if isinstance(node, n.Matrix) else []
    letters = {
        name.key
        for cell in cells
        if isinstance(name := bare(cell), n.Name) and (name.sub in tuple("xyz") or name.base in "rR")
    }
    return len(cells) == len(letters) in (4, 9)  # in the plane, or in space


def _is_nought(node: n.Node) -> bool:
    if cells := tuple(_cells(node)):
        return isinstance(bare(node), n.Matrix) and all(map(_is_nought, cells))
    return isinstance(node, n.Number) and node.value == 0


def _letters_of(side: Member, names: Names) -> set[str]:
    """Return the letters in the value of a side; where that is outside the algebra, those that it is written with."""
    cells = as_matrix(side.value).cells
    if all(isinstance(cell, Scalar) for cell in cells):
        return symbols_in([cell.normal() for cell in cells])
    return letters_held(side.node, names)


def letters_held(member: n.Node, names: Names, of: frozenset[str] = frozenset()) -> set[str]:
    """Return the letters of a side, those of the names that the document defines, and the joint angles that it holds."""
    found: set[str] = set()
    for below in n.walk(member):
        if isinstance(below, n.JointAngles):
            found |= {f"theta_{index}" for _, index in below.terms}
        elif isinstance(below, n.Name) and below.key not in ("pi", "I"):
            definition = names.state.definitions.get(below.key) if below.key not in of else None
            node = definition.node if definition is not None else None
            found |= {below.key} if node is None else letters_held(node, names, of | {below.key})
    return found


def _is_bound(name: n.Name, names: Names) -> bool:
    known = names.known_symbol(name.key) is not None or name.key in names.state.definitions
    return known or names.quantity(name) is not None
