"""What an inferred arm was taken from is data: it is defined where a decided claim rests on it, and refutes only what else confirms it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display, Document, Table
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.rigid import is_none_by_a_slip, is_rotation
from armproof.verification.equations.sides import Members
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.tables.arms.own_letters import has_index_of_another, has_other_sign
from armproof.verification.verdict import AXES, HOLDS, EquationResult, Record, Role, TakenArm, Verdict, worst


@dataclass(frozen=True)
class Inference:
    """A document whose front matter names the arm that it shows, and what that was taken from; or why there is none.

    `unfit` is the arm as its link matrices are printed, where nothing else holds with it: one of them may hold a slip.
    """

    document: Document
    arm: TakenArm | None = None
    problem: Finding | None = None
    line: int | None = None  # of what gives no arm, or not one
    unfit: Inference | None = None


# beside its links: where a chain's frames lie, which of its joints comes first, and how the joint before an inner one turns
FRAMES, ORDER, TOLD = 0, -1, -2
HEIGHTS = -6  # of which coordinates an equation tells what they hold without a joint, x first
INNER = (
    -9
)  # how the frames between base and tool lie, the first one's next to it: the tool's pose tells nothing of them
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
    if source == "closed form":  # q_3 = h - z tells of z
        told, others = [*told, *_rates(one, members)], [*others, *_rates(other, members)]
        is_of_one = not (told and others) or outcome.verdict is Verdict.REFUTED
        is_linear = not any(_multiplies_moves(below, members) for side in (one, other) for below in n.walk(side))
        links = _links([*told, *others], members, source, is_linear) if is_of_one else frozenset()
        heights = range(HEIGHTS - 2, HEIGHTS + 1)
        return links - frozenset(heights) if _moves_otherwise(outcome, members) else links
    if others or _rates(other, members):
        return frozenset()
    links = _links(told, members, source)
    only_turns = source == "matrices" and outcome.verdict is Verdict.PROVED and {each.kind for each in told} <= _TURNS
    return frozenset(link for link in links if not (only_turns and _is_long(link, members)))


def _is_long(link: int, members: Members) -> bool:
    """Whether a link has a length, of which the rotations of its arm tell nothing."""
    assert members.names.arm is not None
    frames = members.names.arm.frames
    return not is_zero(members.exact.quantity(Quantity("origin", frames[link], frames[link - 1])))


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
    links = frozenset(link for quantity in quantities for link in _span(quantity, members))
    if source != "closed form":
        return links
    axes = (_axes(quantity, members) for quantity in quantities if is_linear)
    return links.union(*(_untold(quantity, members) for quantity in quantities), *axes)


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

    Of what is no pose only that no one link's angle does, 0.
    """
    if rows := _angle_rows(outcome, members):
        return rows
    arm, value = members.names.arm, outcome.printed.value if outcome.printed is not None else None
    quantity = members.quantity_of(outcome.true.node) if outcome.true is not None else None
    if (
        arm is None
        or quantity is None
        or quantity.kind != "pose"
        or not isinstance(value, Matrix)
        or value.shape != (4, 4)
    ):
        return frozenset({0})
    if not is_rigid(value):
        return frozenset()
    frames, pose, depth = arm.frames, members.exact.pose, trace_of(arm).depth
    links = {k: (frames[k - 1], frames[k]) for k in _span(quantity, members)}
    ends = (frames[min(links) - 1], frames[max(links)]) if links else ("", "")
    if (quantity.reference, quantity.frame) != ends:
        return frozenset(links)
    left_over = {k: pose(ends[0], near) @ value @ pose(far, ends[1]) for k, (near, far) in links.items()}
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


def _has_row(link: Matrix, convention: str) -> bool:
    """Whether a pose may be that of a row in a DH table: it shifts along the new x and the old z, or the old x and the new z."""
    rows = link.rows
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
        replace(quantity, kind="velocity") for quantity in found if quantity is not None and quantity.kind == "origin"
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


def settle_data(
    inferred: Inference, equations: Iterable[Record], tables: Iterable[Record]
) -> tuple[tuple[Record, ...], tuple[Record, ...]]:
    """Return the records of displays and tables, what the arm was taken from as data among them."""
    equations, tables, taken = tuple(equations), tuple(tables), inferred.arm
    if taken is None:
        if inferred.problem is not None and inferred.problem.kind is Kind.CONVENTION_DISPUTED:
            equations = tuple(_unless_it_rests_on(inferred.problem, record) for record in equations)
        return _told(inferred, equations), _told(inferred, tables)
    claims = [each for record in equations for each in record.outcomes if not _is_data(taken, record, each.links)]
    confirmed = frozenset(link for each in claims if each.verdict in HOLDS for link in each.links)
    settled = _Settled(
        taken,
        confirmed,
        any(_is_sure(taken, each, confirmed) for each in claims) or _shown_twice(taken, tables),
        {key: each.links for each in claims for key in each.defines},
        _never_as_usual(inferred, equations),
        _against(taken, equations, confirmed),
        _in_several_entries(taken, equations),
    )
    return tuple(map(settled.display, equations)), tuple(map(settled.table, tables))


def _against(taken: TakenArm, records: Iterable[Record], confirmed: frozenset[int]) -> Mapping[int, frozenset[int]]:
    """Return, for each link, the lines that do not hold of it: of a printed matrix those that another one would make right."""
    found: dict[int, frozenset[int]] = {}
    for record in records:
        for each in record.outcomes if not record.erratum else ():
            if each.is_of_no_arm:  # whatever the arm is: that speaks against none of its links
                continue
            of_matrices = taken.source == "matrices"
            own = _links_at_fault(each, record, confirmed) | (each.against - confirmed)
            links = own if of_matrices else each.links
            if ORDER in links - confirmed:  # another order of the joints would make it right: it tells of that alone
                links = frozenset({ORDER})
            for link in links if each.verdict is Verdict.REFUTED else ():
                found[link] = found.get(link, frozenset()) | {record.line}
    return found


def _in_several_entries(taken: TakenArm, records: Iterable[Record]) -> Mapping[int, frozenset[int]]:
    """Return, for each printed link matrix, the lines that do not hold with it in more than one entry: it, or they, may be wrong."""
    found: dict[int, frozenset[int]] = {}
    for record in records if taken.source == "matrices" else ():
        for each in record.outcomes if not record.erratum else ():
            several = sum(entry.equation == each.index for entry in record.entries) > 1
            for link in each.links if several and each.verdict is Verdict.REFUTED else ():
                found[link] = found.get(link, frozenset()) | {record.line}
    return found


def _links_at_fault(result: EquationResult, record: Record, confirmed: frozenset[int]) -> frozenset[int]:
    """Return the links of which nothing holds and of which another one makes a pose right that several entries would have to mend."""
    wrong = [entry for entry in record.entries if entry.equation == result.index]
    links = result.explained_by or frozenset()
    return links - confirmed if len(wrong) > 1 and links and min(links) > 0 else frozenset()


def _is_sure(taken: TakenArm, claim: EquationResult, confirmed: frozenset[int]) -> bool:
    """Whether a claim is decided by the arm, and not only other than what that was taken from."""
    if claim.verdict in HOLDS:
        return bool(claim.links or claim.usual)
    is_own = taken.source == "matrices" and not claim.links & taken.mended
    sure = is_own or {link for link in claim.links if link > 0} <= confirmed
    return claim.is_decided and bool(claim.links) and sure


def _never_as_usual(inferred: Inference, records: Iterable[Record]) -> frozenset[str]:
    """Return the names that convention binds, and of which nothing holds while several displays are refuted, not only beside the arm's source.

    They are not what they were taken for: x and y of a planar arm in a section of its own.
    """
    taken = inferred.arm
    assert taken is not None
    parts: list[Display | Table] = [*inferred.document.displays, *inferred.document.tables]
    here = {each.section for each in parts if (each.cell, each.line) in taken.lines}
    refuted: dict[str, set[tuple[int, int]]] = {}
    held: set[str] = set()
    for record in records:
        for outcome in record.outcomes:
            if outcome.verdict in HOLDS:
                held |= outcome.usual.keys()
            for key in outcome.usual if outcome.verdict is Verdict.REFUTED and record.section not in here else ():
                refuted.setdefault(key, set()).add((record.cell or 0, record.line))
    return frozenset(key for key, places in refuted.items() if len(places) > 1 and key not in held)


def _shown_twice(taken: TakenArm, tables: Iterable[Record]) -> bool:
    """Whether a table says the same as what the arm was taken from: link matrices, a closed form."""
    return any(table.verdict in HOLDS and not _is_data(taken, table) for table in tables)


def _told(inferred: Inference, records: tuple[Record, ...]) -> tuple[Record, ...]:
    """Say of a table or a matrix why no arm was taken from it."""
    if (problem := inferred.problem) is None:
        return records
    return tuple(
        replace(
            record, findings=(problem, *(each for each in record.findings if each.kind is not Kind.NO_ARM_FOR_TABLE))
        )
        if record.line == inferred.line and record.verdict is Verdict.UNCHECKED
        else record
        for record in records
    )


def _unless_it_rests_on(problem: Finding, record: Record) -> Record:
    """Leave open what a document says of an arm that its text denies: what its displays define, and what is made of that."""
    if record.erratum:
        return record
    rests = [each.verdict is Verdict.DEFINED or (each.verdict in HOLDS and bool(each.uses)) for each in record.outcomes]
    if not any(rests):
        return record
    outcomes = tuple(
        replace(each, verdict=Verdict.UNCHECKED, findings=(problem,)) if is_open else each
        for each, is_open in zip(record.outcomes, rests, strict=True)
    )
    return replace(
        record,
        outcomes=outcomes,
        verdict=worst([each.verdict for each in outcomes]),
        findings=(problem, *record.findings),
    )


def _is_data(taken: TakenArm, record: Record, links: frozenset[int] = frozenset()) -> bool:
    """Whether the arm was taken from a table, or from the equation in a display that is about these links."""
    place = (record.cell, record.line)
    count = len(taken.front["arm"]["rows"]) if "arm" in taken.front else 0
    of_tool = bool(links) and not (FRAMES in links and max(links) < count)  # of another point it is no source
    is_source = {"table": True, "matrices": len(links) == 1 or place in taken.products}.get(taken.source, of_tool)
    return place in taken.lines and is_source


def _is_of_any_arm(result: EquationResult) -> bool:
    slips = (Kind.SLIP_OF_ANY_JACOBIAN, Kind.SLIP_FOR_EACH_JOINT, Kind.SLIP_AS_VECTORS)
    return any(each.kind in slips for each in result.findings)


@dataclass(frozen=True)
class _Settled:
    """The records of a document whose arm was taken from a part of it.

    Attributes:
        confirmed: the links of which something that is no data holds.
        is_used: whether anything else is decided with this arm.
        named: what defined names tell of.
        never_as_usual: the names that convention binds and that are none of the arm's.
        against: the lines that do not hold, for each link that they tell of.
        in_doubt: those that do not hold of a link in several entries.
    """

    taken: TakenArm
    confirmed: frozenset[int]
    is_used: bool
    named: Mapping[tuple[str, int], frozenset[int]]
    never_as_usual: frozenset[str] = frozenset()
    against: Mapping[int, frozenset[int]] = field(default_factory=dict)
    in_doubt: Mapping[int, frozenset[int]] = field(default_factory=dict)

    def table(self, record: Record) -> Record:
        """Return the record of a table: data, or another table, which is not refuted by this one."""
        if _is_data(self.taken, record):
            data = self._data(1, frozenset(self.against) - {FRAMES, 0})
            return Record(
                record.line, record.latex, data.verdict, record.erratum, data.findings, (data,), cell=record.cell,
                section=record.section, file=record.file,
            )  # fmt: skip
        if record.verdict is Verdict.REFUTED and not record.erratum:
            other = say(Kind.SECOND_TABLE, source=self.taken.source, line=self.taken.line)
            return replace(record, verdict=Verdict.UNCHECKED, findings=(other, *record.findings), corrections=None)
        return record

    def display(self, record: Record) -> Record:
        """Return the record of a display."""
        if not record.outcomes:  # a table that is set as an array, or what was not read
            return self.table(record) if record.verdict in (*HOLDS, Verdict.REFUTED) else record
        outcomes = tuple(self._outcome(each, record) for each in record.outcomes)
        verdict = worst([each.verdict for each in outcomes])
        findings = list(record.findings)
        if outcomes != record.outcomes:
            findings = [finding for each in outcomes if each.verdict is verdict for finding in each.findings]
        if any(each.is_decided and each.links for each in outcomes):
            findings.append(say(Kind.FOR_ARM_OF, source=self.taken.source, line=self.taken.line))
        corrections = record.corrections if verdict is record.verdict else None
        return replace(record, outcomes=outcomes, verdict=verdict, findings=tuple(findings), corrections=corrections)

    def _outcome(self, result: EquationResult, record: Record) -> EquationResult:
        """Return an equation's result; unchecked where it differs from the source in what nothing else confirms."""
        if result.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) and self._is_of_screws(record):
            return self._data(result.index)
        if result.verdict in HOLDS and _is_data(self.taken, record, result.links):
            return result if result.links <= self.confirmed else self._data(result.index, result.links)
        links = result.links.union(*(self.named.get(key, ()) for key in result.uses))
        doubtful = links - self.confirmed
        is_of_links = bool(doubtful) and min(doubtful) > 0 and (len(doubtful) == 1 or self._is_alone(result, record))
        if is_of_links and result.explained_by is not None and not doubtful & result.explained_by:
            links, doubtful = self.confirmed & links, frozenset()  # no link in its place makes it right
        has_entry = any(entry.equation == result.index for entry in record.entries)
        has_sides = (
            bool(links) or has_entry or result.role is Role.CONDITION
        )  # else a shape, or an inverse that this arm's Jacobian does not have
        is_own = self.taken.source == "matrices" and not (links - self.confirmed) & self.taken.mended
        is_own = is_own and not _links_at_fault(result, record, self.confirmed)
        is_slip = self._is_slip(links, result, record) or self._is_off_its_place(doubtful, result, record)
        is_slip = is_slip or self._has_slip_in_length(doubtful, result, record)
        is_sure = has_sides and (is_own or not doubtful or is_slip)
        is_sure = is_sure and (not self.taken.told_by or TOLD in self.confirmed)
        is_sure = is_sure or result.is_of_no_arm
        if result.verdict is not Verdict.REFUTED or record.erratum or _is_of_any_arm(result):
            return result
        if others := result.usual.keys() & self.never_as_usual:
            doubt = say(Kind.NEVER_AS_USUAL, name=min(others))
            return replace(result, verdict=Verdict.UNCHECKED, findings=(doubt.at(result.index),))
        if is_sure:
            return result
        doubt = say(Kind.OTHER_THAN_SOURCE, source=self.taken.source, line=self.taken.line)
        return replace(result, verdict=Verdict.UNCHECKED, findings=(doubt.at(result.index), *result.findings))

    def _is_of_screws(self, record: Record) -> bool:
        """Whether a display gives axes, the pose at zero or the product of an arm that was taken from these, and nothing speaks against them."""
        kinds = {finding.kind for each in record.outcomes for finding in each.findings}
        is_source = self.taken.is_of_screws and record.place in self.taken.products
        return is_source and kinds.isdisjoint((Kind.OTHER_SCREWS, Kind.CONTRADICTED))

    @staticmethod
    def _is_alone(result: EquationResult, record: Record) -> bool:
        """Whether one entry alone of a pose is wrong: other links would be seen in more."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        return [bool(each.row) for each in wrong] == [True] and 0 not in (result.explained_by or ())

    def _is_slip(self, links: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one entry alone is other than coordinates say that fit together: x = ∂y/∂θ_1, which one slip in them would break."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        is_pinned = self.taken.source == "closed form" and not (self.taken.mended or self.taken.told_by)
        alone = all(len(self.against.get(link, ())) < 2 for link in links)
        if not is_pinned or not alone or len(wrong) != 1:
            return False
        is_told = wrong[0].finding is not None
        if not wrong[0].row:  # a formula: what nothing pins of the coordinates may be what is wrong
            return is_told and links - self.confirmed <= self._pinned
        return FRAMES not in links - self.confirmed or is_told

    def _is_off_its_place(self, doubtful: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one coordinate alone of a pose is wrong that holds elsewhere: in another frame's the others would be, too."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        if doubtful != {FRAMES} or len(wrong) != 1 or wrong[0].column != 4 or not wrong[0].row:
            return False
        return AXES - (wrong[0].row - 1) in self.confirmed

    def _has_slip_in_length(self, doubtful: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one length of a link alone is other than its row says, which tells what the author calls it."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        if self.taken.source != "table" or len(doubtful) != 1 or len(wrong) != 1 or wrong[0].finding is None:
            return False
        link = min(doubtful)
        is_alone = self.against.get(link) == frozenset({record.line})  # else the row may be what is wrong
        return has_index_of_another(self.taken, link, wrong[0]) or (
            is_alone and has_other_sign(self.taken, link, wrong[0])
        )

    @property
    def _pinned(self) -> frozenset[int]:
        """What coordinates tell for certain that fit together: of z only where it turns, and no constant."""
        rows = self.taken.front["arm"]["rows"]
        turns_up = any(str(row["alpha"]) != "0" for row in rows)
        return frozenset({*range(1, len(rows) + 1), AXES, AXES - 1, *([AXES - 2] if turns_up else [])})

    def _data(self, index: int, links: frozenset[int] = frozenset()) -> EquationResult:
        doubts = (
            lines.get(link, frozenset()) for lines in (self.against, self.in_doubt) for link in links - self.confirmed
        )
        lines = sorted(frozenset[int]().union(*doubts))
        is_known = self.taken.in_words or (self.is_used and not lines)
        verdict = Verdict.DEFINED if is_known else Verdict.UNCHECKED
        gives = say(Kind.GIVES_ARM, convention=self.taken.convention)
        doubt = (say(Kind.CONTRADICTED, lines=lines),) if lines and not self.taken.in_words else ()
        return EquationResult(index, Role.DATA, verdict, findings=(gives, *doubt), links=links)
