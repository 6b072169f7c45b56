"""How much of what a document says of its arm holds under each reading of what the arm was taken from."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, partial
from operator import methodcaller
from types import MappingProxyType
from typing import Any

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Display, Document
from armproof.verification.document.heading import sections_around
from armproof.verification.document.sentences import FROM_VALUES, values_of
from armproof.verification.equations.alignment import is_constant, is_near
from armproof.verification.equations.at_listed_values import holds_at_listed_values
from armproof.verification.equations.chain import ChainChecker, no_samples
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.readings import side_by_side
from armproof.verification.errors import ReadError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.latex.tokens import Spelling
from armproof.verification.naming.conventions import is_entry
from armproof.verification.naming.reading import read_names, spelling_of
from armproof.verification.tables.arms.support import links_of
from armproof.verification.verdict import Verdict

WORK = 3_000  # for one display under one reading: counted, so that no machine's load chooses an arm
WORK_IN_ALL = 50_000
SECONDS = 2.0  # what no count bounds
_NEVER_PLACED = frozenset("theta q a l L c s C S m".split())  # letters of which θ_1^2 is a square
SpellingOf = Callable[[frozenset[str]], Spelling]
LEAD = 4  # so many more hold under one reading than under all others: the rest need not be tried


@dataclass(frozen=True)
class Reading:
    """A way to read a document: the front matter that it amounts to, and how many of its equations then hold or fail.

    `entries` counts those of the equations that hold: where as many hold in two ways, a pose tells more than a height.
    `near` counts those that would hold if one of their entries were another.
    `joints` are the names alone, as in θ_1 = …, of which an equation may hold.
    """

    front: Mapping[str, Any]
    name: str
    held: int = 0
    failed: int = 0
    entries: int = 0
    joints: frozenset[str] = frozenset()
    near: int = 0

    @property
    def counts(self) -> tuple[int, int, int, int]:
        """How many hold, and fail by more than one entry, and fail, and the entries of those that hold, the best first in order."""
        return -self.held, self.contradicted, self.failed, -self.entries

    @property
    def contradicted(self) -> int:
        """How many fail by more than one entry, which a slip would explain."""
        return max(0, self.failed - self.near)

    @property
    def is_near(self) -> bool:
        """Whether all that fails is one equation, by one entry."""
        return self.failed == self.near == 1

    @property
    def convention(self) -> str:
        """The convention of its DH table."""
        return str(self.front["arm"]["dh"])

    @property
    def transforms(self) -> str:
        """Which index of a transform names the reference."""
        return str(self.front.get("transforms", "upper"))


class _Trial:
    """A document read in one way, its displays taken one by one."""

    def __init__(
        self, spelling: SpellingOf, front: Mapping[str, Any], arm: Arm, numbers: Mapping[str, Fraction], source: str
    ) -> None:
        self.name, self.source = arm.name, source
        names = read_names(arm, front)
        names.reader.spelling = spelling(names.reader.words)
        self.checker = ChainChecker(names, ExactAlgebra(Ring(), arm), no_samples)
        self.checker.confirm, self.checker.route.weighs = False, True
        for key, number in numbers.items():
            names.define(key, methodcaller("rational", number), by_table=True)
        self.is_strict = False
        self.held = self.failed = self.entries = self.near = 0
        self.wrong: set[str] = set()  # of which entries fail
        self.joints: set[str] = set()

    def take(self, display: Display, counts: bool = True) -> None:
        """Count which equations of a display that rest on the arm hold."""
        held, entries = self.held, self.entries
        failed, wrong = self.failed, set(self.wrong)
        self.checker.names.state.enter(display.section)
        self.checker.names.state.listed = display.listed
        budget = self.checker.exact.budget
        self.checker.exact.ring.forget_signs()
        with suppress(Exception), budget.of(SECONDS, WORK):  # a fault of ours must not cost the document its verdicts
            for chain in self.checker.names.reader.read(display.latex):
                if isinstance(chain, n.Chain) and chain.relations and set(chain.relations) == {"="}:
                    told = [member for member in chain.members if not isinstance(n.bare(member), n.Number)]
                    if len(told) > 1:  # det J = 0 is a condition, and no evidence
                        self._take_chain(
                            replace(chain, members=tuple(told), relations=("=",) * (len(told) - 1)), display.line
                        )
        if not counts:
            self.held, self.entries = held, entries
        if _is_of_a_case(display, self.is_strict):
            self.failed, self.wrong = failed, wrong

    def _take_chain(self, chain: n.Chain, line: int) -> None:
        outcomes = self.checker.check(chain, 1, line, define=not (parts := side_by_side(chain)))
        if parts and not all(outcome.verdict is Verdict.PROVED for outcome in outcomes):
            outcomes = [outcome for part in parts for outcome in self.checker.check(part, 1, line)]
        if outcomes and _may_hold(outcomes[0]) and (key := bare_key(chain.members[0])):
            self.joints.add(key)
        whole = self._whole(n.bare(chain.members[0]))
        for outcome in outcomes:
            tells = bool(links_of(outcome, self.checker.members, self.source))
            self.held += tells and (outcome.verdict is Verdict.PROVED or holds_at_listed_values(outcome))
            fails = tells and outcome.verdict is Verdict.REFUTED
            self.failed += fails and whole not in self.wrong
            self.wrong |= {whole} if fails and whole else set()
            self.near += tells and outcome.verdict is Verdict.REFUTED and _has_one_slip(outcome)
            if tells and outcome.verdict is Verdict.PROVED and outcome.pair is not None:
                self.entries += sum(not is_constant(as_matrix(cell)) for cell in outcome.pair.true.cells)

    def _whole(self, node: n.Node) -> str:
        """Return what r_{ij} or p_x is an entry of: nine that fail are one matrix that does; "" of anything else."""
        if not isinstance(node, n.Name):
            return ""
        quantity = self.checker.members.quantity_of(node)
        if is_entry(node) or quantity is None or not quantity.scalar or quantity.kind != "origin":
            return node.base if is_entry(node) else ""
        return f"{quantity.frame} in {quantity.reference}"

    def reading(self, front: Mapping[str, Any]) -> Reading:
        return Reading(front, self.name, self.held, self.failed, self.entries, frozenset(self.joints), self.near)


def _is_of_a_case(display: Display, is_strict: bool = False) -> bool:
    """Whether the text puts a display under values, or says otherwise that it does not hold of the tool everywhere; what it says of letters only where that is not strict."""
    if display.supposed or display.of_other_point or display.in_other_frame or (display.meant and not is_strict):
        return True
    return FROM_VALUES in display.said or any(map(values_of, (display.section, *sections_around(display.section))))


def weigh(
    document: Document,
    fronts: Sequence[Mapping[str, Any]],
    apart: Collection[tuple[int | None, int]] = (),
    numbers: Mapping[str, Fraction] = MappingProxyType({}),
    only: Collection[tuple[int | None, int]] = (),
    source: str = "",
    to_the_end: bool = False,
) -> list[Reading]:
    """Return the readings that an arm can be built of, the one under which most holds first; raises where there is none.

    What stands at the places `apart` is no evidence; `numbers` are those that names stand for by their indices. Where `only` names places, what stands elsewhere only tells how the document is spelt. What a `source` of its own shows an arm to be, rates tell of, too. `to_the_end` weighs all displays, and lets what the text says of letters excuse none. What is read is judged by its equations alone: labels often belong to another convention than the table beside them.
    """
    trials = list(_trials(document, fronts, numbers, source))
    for _, trial in trials:
        trial.is_strict = to_the_end
    for display in (each for each in document.displays if not only or each.place in only):
        if sum(trial.checker.exact.budget.asked for _, trial in trials) > WORK_IN_ALL:
            break
        if display.closed and not (display.erratum or display.denied) and "=" in display.latex:
            for trial in dict.fromkeys(trial for _, trial in trials):
                trial.take(display, (display.cell, display.line) not in apart)
            best, *others = sorted((trial.held for _, trial in trials), reverse=True)
            if best - max(others, default=0) >= LEAD and not to_the_end:
                break
    return sorted((trial.reading(front) for front, trial in trials), key=lambda one: one.counts)


def _trials(
    document: Document, fronts: Sequence[Mapping[str, Any]], numbers: Mapping[str, Fraction], source: str
) -> Iterator[tuple[Mapping[str, Any], _Trial]]:
    """Yield the trial of each front matter; of two that differ in what nobody asks it is one."""
    begun: dict[str, _Trial] = {}
    tells = _has_two_scripts(document)
    spelling = cache(partial(spelling_of, document))  # one for all readings: it does not rest on the arm
    problem: ArmproofError | None = None
    found = False
    for front in fronts:
        told = repr(front if tells else {**front, "transforms": ""})
        if told in begun:
            yield front, begun[told]
            continue
        try:
            trial = _Trial(spelling, front, load_arm(front["arm"], document.path.parent), numbers, source)
        except ArmproofError as error:
            problem = problem or error
            continue
        found = True
        begun[told] = trial
        yield front, trial
    if not found and problem is not None:
        raise problem


def _has_two_scripts(document: Document) -> bool:
    """Whether a name of a document has an index above and one below: of others nobody asks which of them is the reference."""
    reader = read_names(None, {}).reader
    reader.spelling = spelling_of(document, reader.words)
    for display in document.displays:
        with suppress(ReadError, RecursionError):
            nodes = (node for statement in reader.read(display.latex) for node in n.walk(statement))
            if any(map(_is_between, nodes)):
                return True
    return False


def _is_between(node: n.Node) -> bool:
    """Whether a node may be a name with an index above and one below, T_1^0; p_1^0 is read as a power first."""
    name = n.bare(node.base) if isinstance(node, n.Power) else node
    if not isinstance(name, n.Name) or not name.sub:
        return False
    return bool(name.sup) if name is node else name.base not in _NEVER_PLACED


def _has_one_slip(outcome: Outcome) -> bool:
    """Whether one entry alone of a matrix is wrong, and half of those that move are right."""
    return len(outcome.wrong) == 1 and outcome.pair is not None and not outcome.pair.is_scalar and is_near(outcome.pair)


def _may_hold(outcome: Outcome) -> bool:
    """Whether an equation holds, or but for signs that samples decide."""
    is_open = outcome.tells(Kind.NOT_SAMPLED)
    return outcome.verdict is Verdict.PROVED or (outcome.verdict is Verdict.UNCHECKED and is_open)
