"""The verdict of one chain of equations: which member is true, which names are defined, which entries are wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, NoReturn

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import is_near
from armproof.verification.equations.catalogue import Catalogue
from armproof.verification.equations.compositions import is_product_of_links, is_way_outwards
from armproof.verification.equations.conventional import Conventions
from armproof.verification.equations.definitions import (
    Definitions,
    Redefinitions,
    letters_meant_anew,
)
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.forces import LETTERS as OF_FORCES
from armproof.verification.equations.forces import heed_forces, unless_left_out, with_components
from armproof.verification.equations.foreign_index import of_foreign_index
from armproof.verification.equations.given_values import (
    adopts_letters,
    angle_of_cosine,
    keys_alone,
    names_alone,
    new_angle,
    new_letters,
    new_name,
)
from armproof.verification.equations.jacobian_rows import RowsOfJacobians
from armproof.verification.equations.letter_matrices import (
    FEWEST_LETTERS,
    are_of_no_other,
    are_shown_of_tool,
    await_value,
    awaited,
    entries_before,
    entries_elsewhere,
    forget_letters,
    forget_letters_of,
    hold_as_defined,
    hold_entries,
    is_of_pose,
    is_shown_as_defined,
    is_shown_to_be,
    name_of_tool,
    of_defined_rotation,
    stale,
    take_entries,
    target_pose,
    with_entries_of_capitals,
    with_last_row,
    with_small_letters,
)
from armproof.verification.equations.of_points import OfPoints
from armproof.verification.equations.other_zeros import OtherZeros
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.places import (
    forget_ended,
    heed_places,
    keep_printed,
    left_open_for_places,
    left_open_for_section,
)
from armproof.verification.equations.readings import Check, Readings
from armproof.verification.equations.second_route import SecondRoute, is_distance
from armproof.verification.equations.sides import Member, Members
from armproof.verification.equations.signed_distances import named_with_sign
from armproof.verification.equations.skew import unless_skewed
from armproof.verification.equations.spelt_names import with_spelt_names
from armproof.verification.equations.table_angles import TableAngles
from armproof.verification.equations.torques import Torques
from armproof.verification.equations.torques_of_points import TorquesOfPoint
from armproof.verification.equations.worked_numbers import as_added_up, in_the_unit_behind
from armproof.verification.errors import NotSampled, UnboundName
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches
from armproof.verification.naming.conventions import ENTRIES, ENTRY, WRIST
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import DECIDED, HOLDS, Verdict

if TYPE_CHECKING:
    from armproof.verification.evaluation.sampled import SampledAlgebra


@dataclass
class _Pass:
    """One time that a chain is checked.

    Attributes:
        members: its sides, with their values; those of names that are bound on the way are set then.
        first, line: the number of its first equation, the line of its display.
        define: whether its names get a meaning by it.
        check: checks another reading of it in the same place.
        before, settled: the definitions, and the names bound by notation, before it.
        placed, ended: the lines of names that are blocks by their place in a matrix, and of those whose section is over.
        defined: what its first name was before, where it is defined once more.
        is_open: whether a side has no value, in a document with an arm.
        branches: whether a sign in it is to be chosen.
    """

    chain: n.Chain
    members: list[Member]
    first: int
    line: int
    define: bool
    definitions: Definitions
    check: Callable[..., list[Outcome]]
    before: dict[str, Definition]
    settled: Set[str]
    placed: Mapping[str, tuple[int, str]]
    ended: Mapping[str, int]
    defined: Definition | None
    of_jacobian: bool
    is_open: bool
    branches: bool


class ChainChecker:
    """Checks chains of `=` under the bindings of a document."""

    def __init__(self, names: Names, exact: ExactAlgebra, sampled: Callable[[], SampledAlgebra]) -> None:
        self.names = names
        self.exact = exact
        self.sampled = sampled
        self.members = Members(names, exact, sampled)
        self.route = SecondRoute(self.members)
        self.equality = Equality(self.members, self.route)
        self.readings = Readings(self.equality)
        self.conventions = Conventions(self.equality)
        self.redefinitions = Redefinitions(names)
        self.catalogue = Catalogue(self.members)
        self.of_entries = False  # whether a chain is read with r_{ij} of another matrix
        self.of_coordinates = False  # whether a chain is read with x for a coordinate

    @cached_property
    def rows(self) -> RowsOfJacobians:
        """The rows in which Jacobians are read; asked only where one is named."""
        return RowsOfJacobians(self.members)

    @cached_property
    def angles(self) -> TableAngles:
        """What the letters of joints with an offset mean; asked only of an arm that has one."""
        return TableAngles(self.names)

    @cached_property
    def zeros(self) -> OtherZeros:
        """Which joints a marked letter counts from another zero."""
        return OtherZeros(self.members)

    @property
    def confirm(self) -> bool:
        """Whether what is proved is also evaluated on the double plant."""
        return self.route.enabled

    @confirm.setter
    def confirm(self, enabled: bool) -> None:
        self.route.enabled = enabled

    def member(self, node: n.Node) -> Member:
        """Evaluate one side exactly."""
        return self.members.evaluate(node)

    def quantity_of(self, node: n.Node) -> Quantity | None:
        """Return the arm's quantity that a name, with or without arguments, stands for."""
        return self.members.quantity_of(node)

    def check(self, chain: n.Chain, first_equation: int, line: int, define: bool = True) -> list[Outcome]:
        """Return one outcome an equation, numbered from `first_equation`.

        A chain is read, its sides are evaluated and compared with the one that is true, and each outcome is judged by what
        the document says beside it. Another reading is checked in the same way, from the beginning.
        """
        chain = with_spelt_names(chain, self.names)
        if not n.letters(chain).isdisjoint((*ENTRIES, ENTRY.upper())):  # few chains hold letters of a pose
            chain = with_last_row(with_entries_of_capitals(chain, self.names))
        now = self._begun(chain, first_equation, line, define)
        if (said := self._of_other_index(now)) is not None or (said := self._of_no_value(now)) is not None:
            return said
        outcomes = self._of_awaited(now, self._judged(now, self._compared(now)))
        if (anew := self._with_letters_anew(now, outcomes)) is not None:
            return anew
        if now.defined is not None:
            outcomes = self.redefinitions.judge(now.chain, outcomes, now.defined, now.check)
        if self.names.state.definitions:
            outcomes = [self.redefinitions.unless_repeated(outcome, line) for outcome in outcomes]
            outcomes = [self.redefinitions.unless_said(each, line) if define else each for each in outcomes]
        for outcome in outcomes:
            outcome.read_as = outcome.read_as or (self.members.read_as(outcome.true.node) if outcome.true else "")
        if (doubt := self._other_direction(now, outcomes)) is not None:
            if self._tells_direction(now):
                return now.check(now.chain)
            outcomes = [replace(outcome.left_open(doubt), defines=()) for outcome in outcomes]
        return self._remembered(now, outcomes)

    def _begun(self, chain: n.Chain, first_equation: int, line: int, define: bool) -> _Pass:
        """Read a chain and evaluate its sides."""
        state = self.names.state
        state.signs.read.clear()
        before = state.definitions.copy()
        placed = state.placed | {k: (each.line, each.section) for k, each in before.items() if each.by_place}
        is_over = define and any(each.has_ended for each in before.values())
        ended = forget_ended(self.names, chain) if is_over else {}
        if define and (masses := self.names.reader.spelling.masses):  # g = 9.81 says what it is
            state.adopted -= masses & {bare_key(member) or "" for member in chain.members}
        if define and self.names.arm is not None and n.letters(chain) & OF_FORCES:
            heed_forces(self.names, chain)
            chain = with_components(chain, self.names)
        chain = self.conventions.read(chain)
        is_again = define and bare_key(chain.members[0]) in state.definitions
        defined = self.redefinitions.before(chain) if is_again else None
        of_jacobian = self.members.speaks_of_jacobian(chain)
        chain = self.rows.choose(chain) if of_jacobian else chain
        settled = frozenset(state.inferred)
        members, fresh = self._evaluated(chain, define)
        is_open = define and self.names.arm is not None and not all(member.known for member in members)
        if is_open and (matrix := stale(members, self.names)) is not None:
            forget_letters(self.names, matrix)
            members, fresh = self._evaluated(chain, define)
        check = partial(self.check, first_equation=first_equation, line=line, define=define)
        definitions = Definitions(self.readings, line, define, fresh)
        return _Pass(
            chain, members, first_equation, line, define, definitions, check, before, settled, placed, ended, defined, of_jacobian, is_open,
            has_branches(chain) or bool(state.signs.read),
        )  # fmt: skip

    def _of_other_index(self, now: _Pass) -> list[Outcome] | None:
        """Return what is refuted of a name with an index that the arm has not, where another one is meant."""
        if not now.is_open or not any(isinstance(each.problem, UnboundName) for each in now.members):
            return None
        aside = partial(self._aside, first_equation=now.first, line=now.line)
        if (slipped := of_foreign_index(now.chain, self.names, now.first, aside)) is None:
            return None
        refuted, meant = slipped
        now.check(meant, define=False)  # its usual names mean what they do in that
        return refuted

    def _of_no_value(self, now: _Pass) -> list[Outcome] | None:
        """Bind the names that what they are equated to binds. Return what becomes of a chain of which nothing has a value yet."""
        members = self.conventions.bind(self._with_parts(now.members))
        now.members = members = self._with_parts(members)  # J_i beside a p_e that was bound
        if now.define:
            if self.names.state.inferred.keys() - now.settled:
                heed_places(self.names, members, now.settled, now.line)
            if now.is_open and (target := target_pose(members, self.names)) is not None:
                self.names.state.inferred[target[0]] = target[1]
                return now.check(now.chain)
            if now.is_open and (found := awaited(members)) is not None:
                return [replace(await_value(self.names, *found, now.line), equation=now.first)]
        if not any(member.known for member in members):
            if now.define and adopts_letters(self.members, members):
                return now.check(now.chain)
            return now.definitions.nothing_known(members, now.first)
        if now.define:
            now.members = [self.readings.own_angle(member, members) for member in members]
        return None

    def _with_parts(self, members: list[Member]) -> list[Member]:
        """Return the members, with J_i as the column that the size of a known one tells."""
        known = [member for member in members if member.known]
        return [self.readings.part(member, known) for member in members] if known else members

    def _compared(self, now: _Pass) -> list[Outcome]:
        """Compare each side that has a value with the true one, and give it to the names of the others."""
        true = max((member for member in now.members if member.known), key=lambda member: member.rank)  # the first one
        outcomes: list[Outcome] = []
        for index, member in enumerate(now.members):
            equation = now.first + max(0, index - 1)
            if member.known and member is not true:
                compared = self.equality.compare(true, member, equation, now.branches)
                if index and compared.verdict is Verdict.REFUTED and outcomes and outcomes[-1].verdict in HOLDS:
                    compared = as_added_up(self.equality.compare, now.members[index - 1], compared)
                outcomes.append(self.rows.kept(compared) if now.define and now.of_jacobian else compared)
                if now.define:
                    self.rows.heed_column(compared)
            elif not member.known:
                outcomes.append(OfPoints(self.members).judge(now.definitions.define(true, member, equation)))
        if now.define and any(finding.kind is Kind.SIGNED_DISTANCE for each in outcomes for finding in each.findings):
            outcomes = named_with_sign(self.names, self.members, now.chain, outcomes, is_distance)
        return _of_one_value(outcomes)

    def _judged(self, now: _Pass, outcomes: list[Outcome]) -> list[Outcome]:
        """Return the outcomes, left open where the chain may be read otherwise, or a name means something else there."""
        outcomes = self._read_otherwise(now, outcomes)
        if self.names.state.definitions:
            outcomes = [now.definitions.of_sine(each) for each in outcomes]
        outcomes = self._of_other_matrix(now, outcomes)
        outcomes = [self.readings.other_meaning(outcome, now.line, now.define) for outcome in outcomes]
        if now.placed:
            outcomes = [left_open_for_places(self.names, outcome, now.placed) for outcome in outcomes]
        if now.ended:
            outcomes = [left_open_for_section(self.names, outcome, now.ended) for outcome in outcomes]
        for each in outcomes if now.define else ():
            keep_printed(self.names, each)
        if self.names.state.adopted:
            outcomes = [unless_left_out(outcome, self.names) for outcome in outcomes]
        outcomes = [self.conventions.judge(outcome) for outcome in outcomes]
        outcomes = [self.catalogue.judge(outcome) if outcome.names_value else outcome for outcome in outcomes]
        return [self._defined(each) if each.verdict is Verdict.DEFINED else each for each in outcomes]

    def _with_letters_anew(self, now: _Pass, outcomes: list[Outcome]) -> list[Outcome] | None:
        """Return the outcomes where letters of a matrix get another meaning than before; nobody knows then what they mean."""
        if not (now.define and self.names.state.definitions):
            return None
        letters = letters_meant_anew(outcomes)
        if not letters & self.names.state.definitions.keys():
            return None
        self.names.forget(letters)
        outcomes = now.check(now.chain)
        self.names.leave_unknown(letters, now.line)
        return outcomes

    def _other_direction(self, now: _Pass, outcomes: list[Outcome]) -> Finding | None:
        """Return the doubt where transforms may be meant the other way round; what the chain defines is taken back then."""
        otherwise = partial(now.check, now.chain, define=False)
        doubt = self.readings.other_direction([now.chain], _all_proved(outcomes), lambda: _all_proved(otherwise()))
        if doubt is not None:
            self.names.state.definitions = now.before
        return doubt

    def _tells_direction(self, now: _Pass) -> bool:
        """Let a chain tell how transforms are meant, where nothing else does: T_0^3 = A_1 A_2 A_3."""
        is_told = not now.define or self.names.state.transforms
        if is_told or not (is_product_of_links(now.chain) or is_way_outwards(now.chain)):
            return False
        self.names.state.transforms = "lower"
        return True

    def _remembered(self, now: _Pass, outcomes: list[Outcome]) -> list[Outcome]:
        """Keep what the chain shows of names for the lines behind it. Return the outcomes, with what its braces say."""
        self.conventions.restore(outcomes)
        if now.define and self.names.state.awaited:
            self._give_letters(now.chain, now.definitions)
        if now.define and all(outcome.verdict in HOLDS for outcome in outcomes):
            self.names.state.printed = self.readings.printed_rotation(now.chain) or self.names.state.printed
        return [*outcomes, *_labels(now)]

    def _defined(self, outcome: Outcome) -> Outcome:
        """Return a definition, left open where it is a slip away from a skew matrix, tells other torques than J^T F, or a determinant that is none."""
        outcome = unless_skewed(outcome, self.names)
        if outcome.true is not None and _is_vanishing_determinant(outcome.true):
            doubt = say(Kind.DEFINES_ZERO, name=outcome.defines[0] if outcome.defines else "")
            if outcome.defines and self._is_of_shape(outcome.true.node):
                self.names.forget(outcome.defines)
                return replace(outcome, verdict=Verdict.REFUTED, findings=(doubt,), defines=())
            for key in outcome.defines:
                self.names.leave_open(key, doubt)
            return replace(outcome.left_open(doubt), defines=())
        if self.names.arm is None and outcome.verdict is Verdict.DEFINED:
            return TorquesOfPoint(self.members).judge(outcome)
        is_of_forces = self.names.state.adopted and outcome.verdict is Verdict.DEFINED
        return Torques(self.members).judge(outcome) if is_of_forces else outcome

    def _is_of_shape(self, node: n.Node) -> bool:
        """Whether a determinant is zero by the shape of a Jacobian that the document shows: det(J J^T) of six rows and five columns."""
        for below in (each for each in n.walk(node) if n.is_call(each, "det")):
            name, inner = next(iter(n.names(below)), None), bare(below.arguments[0])
            first = bare(inner.factors[0]) if isinstance(inner, n.Product) else None
            shown = name is not None and (
                name.key in self.names.state.shown or name.key in self.names.state.definitions
            )
            value = self.members.evaluate(first).value if shown and first is not None else None
            if isinstance(value, Matrix) and value.shape[0] > value.shape[1]:
                return True
        return False

    def _evaluated(self, chain: n.Chain, define: bool) -> tuple[list[Member], frozenset[str]]:
        """Return the sides with their values, and the new letters that the chain defines: the names alone of these have none."""
        new, fresh = new_name(self.names, chain), new_letters(self.names, chain) if define else frozenset()
        unused = {each.key for member in chain.members for each in names_alone(member) if self.names.is_new(each)}
        turned = new_angle(self.names, chain) if new is None else None
        members = [
            Member(node, None, UnboundName(new or turned or ""))
            if (new is not None and bare_key(node) == new) or (turned is not None and angle_of_cosine(node) == turned)
            else self.members.evaluate(node)
            for node in chain.members
        ]
        named = [each for each in members if bare_key(each.node) and isinstance(each.problem, UnboundName)]
        known = [member for member in members if member.known]  # p = [x; y; z] = […] says both what p is and what x is
        if not (fresh and len(known) > 1 and len(known) + len(named) == len(members)):
            if named and len(unused) >= FEWEST_LETTERS:
                self.names.used.difference_update(unused)  # T = [n o a p] says nothing of them
            return members, frozenset()
        unbound = UnboundName(min(fresh))
        return [Member(m.node, None, unbound) if fresh & keys_alone(m.node) else m for m in members], fresh

    def _read_otherwise(self, now: _Pass, first: list[Outcome]) -> list[Outcome]:
        """Return the outcomes under another reading of the Jacobian where the first one refutes the chain."""
        chain, made, check = now.chain, self.names.state.definitions, partial(self._again, now)
        outcomes = first
        if any(outcome.verdict is Verdict.REFUTED for outcome in first) and self.members.speaks_of_jacobian(chain):
            outcomes = self.rows.with_fewer(chain, first, check)
        if any(outcome.verdict is Verdict.REFUTED for outcome in outcomes):
            outcomes = self.readings.as_product_of_links(chain, outcomes, check)
            outcomes = self._in_the_unit_behind(chain, outcomes, check)
        outcomes = self.readings.of_the_tool(chain, outcomes, now.settled, check)
        if outcomes is first and any(outcome.verdict is Verdict.REFUTED for outcome in first):
            outcomes = self._of_coordinates(chain, first, check)
        if outcomes is first:
            self.names.state.definitions = made
        return outcomes

    def _in_the_unit_behind(self, chain: n.Chain, first: list[Outcome], check: Check) -> list[Outcome]:
        """Return the outcomes where numbers are worked out in the degrees of what comes out, if fewer are refuted then."""
        marked, unsure = in_the_unit_behind(chain)
        tried = check(marked) if marked is not chain else first
        refuted = [sum(each.verdict is Verdict.REFUTED for each in outcomes) for outcomes in (first, tried)]
        if refuted[1] >= refuted[0]:
            return first
        doubt = say(Kind.DEGREES_UNMARKED, number=unsure)
        return [each.left_open(doubt) for each in tried] if unsure else tried

    def _of_coordinates(self, chain: n.Chain, first: list[Outcome], check: Check) -> list[Outcome]:
        """Return the outcomes where x is a coordinate, and no vector as in an equation before, if none is refuted then."""
        before = self.names.state.copy()
        if not self.of_coordinates and self.conventions.take_coordinates(chain.members, beside=False):
            self.of_coordinates = True  # 𝐱 = [x y z]^T asks again what x is
            try:
                tried = check(chain)
            finally:
                self.of_coordinates = False
            if not any(outcome.verdict is Verdict.REFUTED for outcome in tried):
                return tried
            self.names.state.become(before)
        return first

    def _of_other_matrix(self, now: _Pass, first: list[Outcome]) -> list[Outcome]:
        """Return the outcomes where r_{ij} are of another matrix than the tool's, if all hold; what else is no slip is left open."""
        if self.of_entries or all(outcome.verdict in HOLDS for outcome in first):
            if now.define and not self.of_entries and ENTRY in n.letters(now.chain):
                hold_as_defined(self.names, now.chain, now.line)
            return first
        is_open = all(outcome.verdict is Verdict.UNCHECKED for outcome in first)
        chain = (with_small_letters(now.chain) if is_open else None) or now.chain
        if ENTRY not in n.letters(chain):
            return first
        readings = [*entries_elsewhere(self.names, chain)]
        for entries in readings:
            with self._of_taken_entries():
                tried = self._aside(chain, now.first, now.line, partial(self._take_entries, now, entries))
            if all(outcome.verdict in HOLDS for outcome in tried):
                is_near = any(each.verdict is Verdict.REFUTED and _is_slip(each) for each in first)
                if is_near and (placed := self._placed(entries)):
                    return [each.left_open(placed) for each in first]
                if now.define:
                    hold_entries(self.names, entries, now.line)
                return tried
        if self.names.arm is None:
            return self._of_defined_rotation(now) or first
        if are_of_no_other(self.names, self.members, chain, readings):
            return first
        made = self.names.state.definitions
        others = [key for entries in readings for key in entries if key in made and made[key].by_place]
        lines = {key: made[key].line for key in others} or entries_before(self.names, readings)
        doubt = next((say(Kind.SECOND_MEANING, name=key, line=line) for key, line in lines.items()), None)
        shown = next((each for each in readings if is_shown_to_be(self.names, each)), None)
        if doubt and shown and (tried := self._of_shown_matrix(now, chain, shown)):
            return [each.unless_slip(doubt) for each in tried]
        if doubt and is_shown_as_defined(self.names, chain):
            return [each.unless_slip(doubt) for each in first]
        return [each if doubt is None or _is_slip(each) else each.left_open(doubt) for each in first]

    def _placed(self, entries: Iterable[str]) -> Finding | None:
        """Say where r_{ij} were printed as the entries of another matrix, of which they may be with a slip."""
        made = self.names.state.definitions
        return next(
            (say(Kind.SECOND_MEANING, name=k, line=made[k].line) for k in entries if k in made and made[k].by_place),
            None,
        )

    def _of_shown_matrix(self, now: _Pass, chain: n.Chain, entries: Mapping[str, Quantity]) -> list[Outcome]:
        """Return the outcomes where r_{ij} are of the matrix of which they were before; none where that decides nothing."""
        meant = self.names.state.copy()
        with self._of_taken_entries():
            self._take_entries(now, entries)
            tried = self.check(chain, now.first, now.line, now.define)
        if all(each.verdict in DECIDED for each in tried):
            return tried
        self.names.state.become(meant)
        return []

    @contextmanager
    def _of_taken_entries(self) -> Iterator[None]:
        """Ask for no other matrix while r_{ij} are read as those of one."""
        self.of_entries = True
        try:
            yield
        finally:
            self.of_entries = False

    def _take_entries(self, now: _Pass, entries: Mapping[str, Quantity]) -> None:
        """Let the r_{ij} be of a matrix; what the first reading of a chain defined by others of them means nothing then."""
        self.names.state.definitions = now.before.copy()
        take_entries(self.names, entries)

    def _of_awaited(self, now: _Pass, first: list[Outcome]) -> list[Outcome]:
        """Return the outcomes where the letters of a matrix whose name has no value are of the tool's pose, if all hold.

        Those of U_0 = [s n a P], as Paul and Khalil say, may mean what they usually do as well.
        """
        awaited_now = self.names.state.awaited if now.is_open else {}
        spoken = {b.key for m in now.chain.members for b in n.names(m)} if awaited_now else set()
        open_ = ((key, matrix) for key, (matrix, _) in awaited_now.items() if key.rpartition("_")[2] not in WRIST)
        met = {key: matrix for key, matrix in open_ if spoken & keys_alone(matrix)}
        poses = {key: matrix for key, matrix in met.items() if is_of_pose(matrix)}
        of_tool = partial(self._mean_tool, now, poses)
        usual = [matrix for key, matrix in met.items() if key.startswith("U")]
        as_usual = partial(forget_letters_of, self.names, usual)
        for meaning in (*([of_tool] if poses else []), *([as_usual] if usual else [])):
            tried = self._aside(now.chain, now.first, now.line, meaning)
            if all(outcome.verdict in HOLDS for outcome in tried):
                if now.define and meaning is of_tool and are_shown_of_tool(self.names, poses, now.line):
                    of_tool()
                return tried
        return first

    def _mean_tool(self, now: _Pass, met: Mapping[str, n.Node]) -> None:
        """Let the letters of matrices be the entries of the tool's pose."""
        for matrix in met.values():
            forget_letters(self.names, matrix)
            tool = self.member(name_of_tool(self.names))
            now.definitions.define_entries(tool, Member(matrix), 1, True)

    def _of_defined_rotation(self, now: _Pass) -> list[Outcome] | None:
        """Return the outcomes where r_{ij} are of the rotation that a document without an arm gave last, if all hold."""
        made = self.names.state.definitions
        self.names.state.definitions = now.before.copy()  # θ = atan2(r_23, r_13) gives θ no meaning then
        take = of_defined_rotation(self.names, now.chain, self.exact, now.line)
        tried = self._aside(now.chain, now.first, now.line, take) if take is not None else []
        if tried and all(outcome.verdict in HOLDS for outcome in tried):
            return tried
        self.names.state.definitions = made
        return None

    def _aside(
        self, chain: n.Chain, first_equation: int, line: int, first: Callable[[], None] = lambda: None
    ) -> list[Outcome]:
        """Check another chain, with what is done `first`, and leave nothing of it behind."""
        meant = self.conventions.doubts, self.conventions.before
        with self.names.state.unchanged():
            first()
            tried = self.check(chain, first_equation, line, define=False)
        self.conventions.doubts, self.conventions.before = meant
        return tried

    def _give_letters(self, chain: n.Chain, definitions: Definitions) -> None:
        """Let the letters of a matrix mean the entries of a name that a chain gives a value."""
        letters = self.names.state.awaited
        for node in (each for each in chain.members if bare_key(each) in letters):
            if (named := self.members.evaluate(node)).known:
                matrix, line = letters.pop(str(bare_key(node)))
                forget_letters(self.names, matrix)
                replace(definitions, line=line).define_entries(named, Member(matrix), 1, True)

    def _again(self, now: _Pass, chain: n.Chain) -> list[Outcome]:
        """Check another reading of a chain, without what its first reading defined."""
        self.names.state.definitions = now.before.copy()
        return now.check(chain)


def no_samples() -> NoReturn:
    """Take no samples: of a checker that decides exactly, or not at all."""
    raise NotSampled(say(Kind.NOT_SAMPLED))


def _is_slip(outcome: Outcome) -> bool:
    return outcome.verdict is not Verdict.REFUTED or (outcome.pair is not None and is_near(outcome.pair))


def _all_proved(outcomes: Iterable[Outcome]) -> bool:
    return all(outcome.verdict is Verdict.PROVED for outcome in outcomes)


def _labels(now: _Pass) -> Iterator[Outcome]:
    """Yield what the braces of a chain say of what stands in them."""
    for index, node in enumerate(now.chain.members):
        for brace in n.walk(node):
            if isinstance(brace, n.Labelled):
                equation = now.first + max(0, index - 1)
                yield from now.definitions.label(brace, equation, partial(now.check, first_equation=equation))


def _of_one_value(outcomes: list[Outcome]) -> list[Outcome]:
    """Let what p = [x; y; z] = f defines stand for one value: what uses x uses p."""
    entries = {key for each in outcomes if each.tells(Kind.DEFINES_ENTRIES) for key in each.defines}
    names = {key for each in outcomes if each.tells(Kind.DEFINES) for key in each.defines}
    if not (entries and names):
        return outcomes
    both = tuple(sorted(entries | names))
    return [replace(each, defines=both) if each.defines else each for each in outcomes]


def _is_vanishing_determinant(member: Member) -> bool:
    """Whether a side is made of a determinant and zero at every configuration: det(J^T J) of a J with more columns than rows."""
    is_zero = isinstance(member.value, Scalar) and member.value.is_zero()
    return is_zero and any(n.is_call(below, "det") for below in n.walk(member.node))
