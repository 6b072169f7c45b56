"""The verdict of one chain of equations: which member is true, which names are defined, which entries are wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, NoReturn

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.alignment import is_near
from armproof.verification.equations.catalogue import Catalogue
from armproof.verification.equations.compositions import is_product_of_links, is_way_outwards
from armproof.verification.equations.conventional import Conventions
from armproof.verification.equations.definitions import (
    Definitions,
    Redefinitions,
    keys_about,
    letters_meant_anew,
    letters_placed_before,
)
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.forces import LETTERS as OF_FORCES
from armproof.verification.equations.forces import heed_forces, unless_left_out
from armproof.verification.equations.foreign_index import of_foreign_index
from armproof.verification.equations.given_values import adopts_letters, keys_alone, new_letters, new_name
from armproof.verification.equations.jacobian_rows import RowsOfJacobians
from armproof.verification.equations.letter_matrices import (
    await_value,
    awaited,
    entries_elsewhere,
    forget_letters,
    stale,
    take_entries,
)
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.readings import Check, Readings
from armproof.verification.equations.second_route import SecondRoute
from armproof.verification.equations.sides import Member, Members
from armproof.verification.equations.skew import unless_skewed
from armproof.verification.equations.table_angles import TableAngles
from armproof.verification.equations.torques import Torques
from armproof.verification.errors import NotSampled, UnboundName
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key, has_branches
from armproof.verification.naming.conventions import ENTRY
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import HOLDS, Verdict

if TYPE_CHECKING:
    from armproof.verification.evaluation.sampled import SampledAlgebra


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
        """Return one outcome an equation, numbered from `first_equation`."""
        self.names.state.signs.read.clear()
        before = self.names.state.definitions.copy()
        blocks = {key: (each.line, each.section) for key, each in before.items() if each.by_place}
        placed = self.names.state.placed | blocks
        ended = self._ended_with_their_section(chain) if define else {}
        if define and self.names.arm is not None and n.letters(chain) & OF_FORCES:
            heed_forces(self.names, chain)
        chain = self.conventions.read(chain)
        is_again = define and bare_key(chain.members[0]) in self.names.state.definitions
        defined = self.redefinitions.before(chain) if is_again else None
        of_jacobian = self.members.speaks_of_jacobian(chain)
        chain = self.rows.choose(chain) if of_jacobian else chain
        settled = frozenset(self.names.state.inferred)
        members, fresh = self._evaluated(chain)
        is_open = define and self.names.arm is not None and not all(member.known for member in members)
        if is_open and (matrix := stale(members)) is not None:
            forget_letters(self.names, matrix)
            members, fresh = self._evaluated(chain)
        if is_open and any(isinstance(each.problem, UnboundName) for each in members):
            aside = partial(self._aside, first_equation=first_equation, line=line)
            if (slipped := of_foreign_index(chain, self.names, first_equation, aside)) is not None:
                refuted, meant = slipped
                self.check(meant, first_equation, line, define=False)  # its usual names mean what they do in that
                return refuted
        branches = has_branches(chain) or bool(self.names.state.signs.read)
        definitions = Definitions(self.readings, line, define, fresh)
        known = [member for member in members if member.known]
        members = [self.readings.part(member, known) for member in members] if known else members
        members = self.conventions.bind(members)
        if define:
            self._heed_places(members, settled, line)
            if is_open and (found := awaited(members)) is not None:
                return [replace(await_value(self.names, *found, line), equation=first_equation)]
        known = [member for member in members if member.known]
        if not known:
            if define and adopts_letters(self.members, members):
                return self.check(chain, first_equation, line, define)
            return definitions.nothing_known(members, first_equation)
        if define:
            members = [self.readings.own_angle(member, members) for member in members]
        known = [member for member in members if member.known]
        true = max(known, key=lambda member: member.rank)  # the first of the highest
        outcomes: list[Outcome] = []
        for index, member in enumerate(members):
            equation = first_equation + max(0, index - 1)
            if member.known and member is not true:
                compared = self.equality.compare(true, member, equation, branches)
                outcomes.append(self.rows.kept(compared) if define and of_jacobian else compared)
            elif not member.known:
                outcomes.append(definitions.define(true, member, equation))
        again = partial(self._again, before, first_equation, line, define)
        outcomes = self._read_otherwise(chain, outcomes, settled, again)
        outcomes = self._of_other_matrix(chain, outcomes, first_equation, line)
        outcomes = [self.readings.other_meaning(outcome, line, define) for outcome in outcomes]
        if placed:
            outcomes = [self._left_open_for_places(outcome, placed) for outcome in outcomes]
        if ended:
            outcomes = [self._left_open_for_section(outcome, ended) for outcome in outcomes]
        if self.names.state.adopted:
            outcomes = [unless_left_out(outcome, self.names) for outcome in outcomes]
        outcomes = [self.conventions.judge(outcome) for outcome in outcomes]
        outcomes = [self.catalogue.judge(outcome) if outcome.names_value else outcome for outcome in outcomes]
        outcomes = [self._defined(each) if each.verdict is Verdict.DEFINED else each for each in outcomes]
        check = partial(self.check, first_equation=first_equation, line=line)
        if define and (letters := letters_meant_anew(outcomes)) & self.names.state.definitions.keys():
            self.names.forget(letters)
            outcomes = check(chain)
            self.names.leave_unknown(letters, line)
            return outcomes
        if defined is not None:
            outcomes = self.redefinitions.judge(chain, outcomes, defined, check)
        for outcome in outcomes:
            outcome.read_as = outcome.read_as or (self.members.read_as(outcome.true.node) if outcome.true else "")
        doubt = self.readings.other_direction(
            [chain], _all_proved(outcomes), lambda: _all_proved(check(chain, define=False))
        )
        is_untold = doubt and define and not self.names.state.transforms
        if is_untold and (is_product_of_links(chain) or is_way_outwards(chain)):
            self.names.state.definitions = before
            self.names.state.transforms = "lower"  # T_0^3 = A_1 A_2 A_3 tells it, where nothing else does
            return check(chain)
        if doubt:
            self.names.state.definitions = before  # what names it would define is open too
            outcomes = [replace(outcome.left_open(doubt), defines=()) for outcome in outcomes]
        self.conventions.restore(outcomes)
        if define and self.names.state.awaited:
            self._give_letters(chain, definitions)
        if define and all(outcome.verdict in HOLDS for outcome in outcomes):
            self.names.state.printed = self.readings.printed_rotation(chain) or self.names.state.printed
        return [*outcomes, *_labels(chain, first_equation, definitions)]

    def _defined(self, outcome: Outcome) -> Outcome:
        """Return a definition, left open where it is a slip away from a skew matrix, or tells other torques than J^T F."""
        outcome = unless_skewed(outcome, self.names)
        is_of_forces = self.names.state.adopted and outcome.verdict is Verdict.DEFINED
        return Torques(self.members).judge(outcome) if is_of_forces else outcome

    def _evaluated(self, chain: n.Chain) -> tuple[list[Member], frozenset[str]]:
        """Return the sides with their values, and the new letters that the chain defines: the names alone of these have none."""
        new, fresh = new_name(self.names, chain), new_letters(self.names, chain)
        members = [
            Member(node, None, UnboundName(new))
            if new is not None and bare_key(node) == new
            else self.members.evaluate(node)
            for node in chain.members
        ]
        if not (fresh and len(members) > 1 and all(member.known for member in members)):
            return members, frozenset()
        unbound = UnboundName(min(fresh))
        return [Member(m.node, None, unbound) if fresh & keys_alone(m.node) else m for m in members], fresh

    def _read_otherwise(self, chain: n.Chain, first: list[Outcome], settled: Set[str], check: Check) -> list[Outcome]:
        """Return the outcomes under another reading of the Jacobian where the first one refutes the chain."""
        made = self.names.state.definitions
        outcomes = first
        if any(outcome.verdict is Verdict.REFUTED for outcome in first) and self.members.speaks_of_jacobian(chain):
            outcomes = self.rows.with_fewer(chain, first, check)
        outcomes = self.readings.of_the_tool(chain, outcomes, settled, check)
        if outcomes is first and any(outcome.verdict is Verdict.REFUTED for outcome in first):
            outcomes = self._of_coordinates(chain, first, check)
        if outcomes is first:
            self.names.state.definitions = made
        return outcomes

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

    def _ended_with_their_section(self, chain: n.Chain) -> dict[str, int]:
        """Forget what blocks of another section are that a chain is about: they get a meaning anew. Return their lines."""
        ended = {key: each.line for key, each in self.names.state.definitions.items() if each.has_ended}
        ended = {key: ended[key] for key in keys_about(chain) if key in ended} if ended else {}
        self.names.forget(ended)
        return ended

    def _left_open_for_section(self, outcome: Outcome, ended: Mapping[str, int]) -> Outcome:
        """Leave open what is not so, of names that are blocks in another section: this one may be a part of that."""
        if outcome.verdict is not Verdict.REFUTED:
            return outcome
        first = min(ended)
        self.names.leave_unknown(ended, ended[first], Kind.OTHER_SECTION)
        return outcome.left_open(say(Kind.OTHER_SECTION, name=first, line=ended[first]))

    def _of_other_matrix(self, chain: n.Chain, first: list[Outcome], equation: int, line: int) -> list[Outcome]:
        """Return the outcomes where r_{ij} are of another matrix than the tool's, if all hold; what else is no slip is left open."""
        if self.of_entries or ENTRY not in n.letters(chain) or all(outcome.verdict in HOLDS for outcome in first):
            return first
        readings = [*entries_elsewhere(self.names, chain)]
        for entries in readings:
            self.of_entries = True
            tried = self._aside(chain, equation, line, partial(take_entries, self.names, entries))
            self.of_entries = False
            if all(outcome.verdict in HOLDS for outcome in tried):
                return tried
        made = self.names.state.definitions
        others = [key for entries in readings for key in entries if key in made and made[key].by_place]
        doubt = say(Kind.SECOND_MEANING, name=others[0], line=made[others[0]].line) if others else None
        return [each if doubt is None or _is_slip(each) else each.left_open(doubt) for each in first]

    def _aside(
        self, chain: n.Chain, first_equation: int, line: int, first: Callable[[], None] = lambda: None
    ) -> list[Outcome]:
        """Check another chain, with what is done `first`, and leave nothing of it behind."""
        before, meant = self.names.state.copy(), (self.conventions.doubts, self.conventions.before)
        first()
        tried = self.check(chain, first_equation, line, define=False)
        self.names.state.become(before)
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

    def _heed_places(self, members: list[Member], settled: Set[str], line: int) -> None:
        """Remember the names of blocks that are what convention says, as their places in a matrix show."""
        state = self.names.state
        if state.inferred.keys() <= settled:
            return
        cells = (bare_key(cell) for each in members for row in written_rows(each.node) for cell in row)
        for key in {key for key in cells if key is not None and key not in settled}:
            if key in state.inferred and key not in state.conventional and not state.inferred[key].scalar:
                state.placed[key] = line, state.section

    def _left_open_for_places(self, outcome: Outcome, placed: Mapping[str, tuple[int, str]]) -> Outcome:
        """Leave open what does not fit with what the places in another matrix told of a name; nobody knows any more what it is."""
        letters = letters_placed_before(outcome, placed)
        if not letters:
            return outcome
        first = min(letters)
        line, section = placed[first]
        self.names.forget(letters)
        kind = Kind.SECOND_MEANING if section in ("", self.names.state.section) else Kind.OTHER_SECTION
        self.names.leave_unknown(letters, line, kind)
        return outcome.left_open(say(kind, name=first, line=line))

    def _again(
        self, before: dict[str, Definition], first_equation: int, line: int, define: bool, chain: n.Chain
    ) -> list[Outcome]:
        """Check another reading of a chain, without what its first reading defined."""
        self.names.state.definitions = before.copy()
        return self.check(chain, first_equation, line, define)


def no_samples() -> NoReturn:
    """Take no samples: of a checker that decides exactly, or not at all."""
    raise NotSampled(say(Kind.NOT_SAMPLED))


def _is_slip(outcome: Outcome) -> bool:
    return outcome.verdict is not Verdict.REFUTED or (outcome.pair is not None and is_near(outcome.pair))


def _all_proved(outcomes: Iterable[Outcome]) -> bool:
    return all(outcome.verdict is Verdict.PROVED for outcome in outcomes)


def _labels(chain: n.Chain, first_equation: int, definitions: Definitions) -> Iterator[Outcome]:
    """Yield what the braces of a chain say of what stands in them."""
    for index, node in enumerate(chain.members):
        for brace in n.walk(node):
            if isinstance(brace, n.Labelled):
                yield from definitions.label(brace, first_equation + max(0, index - 1))
