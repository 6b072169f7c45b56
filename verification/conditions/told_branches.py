"""Which of several solutions the text tells: what holds on a branch is compared where that has the sign that is told."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from armproof.verification.document.told_branches import BRANCH, MINUS_ROOT, PLUS_ROOT
from armproof.verification.equations.case_conditions import Comparison, comparisons_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import Verdict

ON_A_BRANCH = (Kind.ON_A_BRANCH, Kind.TO_DECIMALS_ON_A_BRANCH)


class ToldBranches:
    """Leaves open what holds on another branch than the text tells, and confirms what holds on that alone."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker

    def judge(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Return what becomes of an equation on one branch of its roots and arc functions where a branch is told."""
        told = [each.removeprefix(BRANCH).strip() for each in meant if each.startswith(BRANCH)]
        if not told or outcome.true is None or outcome.printed is None:
            return outcome
        root = _sign_of_root(outcome)
        told = [each for each in told if not root or each != root]
        if not told:
            return outcome
        is_open = say(Kind.BOUND_IN_TEXT)
        if self.checker.names.arm is None:
            return outcome.left_open(is_open) if self._may_turn(outcome) else outcome
        fails_elsewhere = outcome.verdict is Verdict.REFUTED or outcome.tells(Kind.SIGNED_DISTANCE)
        if not fails_elsewhere and not outcome.tells(*ON_A_BRANCH):
            return outcome
        bounds = [comparison for each in told for comparison in self._read(each)]
        if fails_elsewhere:
            count = self._holds_where(outcome, bounds) if bounds and _has_a_sign(outcome) else 0
            there = (say(Kind.HOLDS_WHERE_SAID, count=count),)
            return (
                replace(outcome, verdict=Verdict.CONFIRMED, findings=there, samples=count, wrong=[])
                if count
                else outcome
            )
        bounds += slides_pulled_out(self.checker)
        return outcome if all(map(self._read, told)) and self._meets(outcome, bounds) else outcome.left_open(is_open)

    def _may_turn(self, outcome: Outcome) -> bool:
        """Whether an equation without an arm would be another with the other sign of a root or of an arc function."""
        return outcome.verdict in (Verdict.CONFIRMED, Verdict.REFUTED) and _has_a_sign(outcome)

    def _read(self, latex: str) -> list[Comparison]:
        with suppress(ReadError, RecursionError):
            chains = [each for each in self.checker.names.reader.read(latex) if isinstance(each, n.Chain)]
            return [comparison for chain in chains for comparison in comparisons_of(chain)]
        return []

    def _holds_where(self, outcome: Outcome, bounds: Sequence[Comparison]) -> int:
        """Return at how many configurations an equation holds, of all where comparisons do; 0 where it fails at one."""
        assert outcome.true is not None and outcome.printed is not None
        sides, sampled = (outcome.true.node, outcome.printed.node), self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import hold_everywhere, holds_where
        if hold_everywhere(self.checker, sampled, bounds):
            return 0
        return holds_where(self.checker, sampled, sides, outcome.pair, bounds)

    def _meets(self, outcome: Outcome, bounds: Sequence[Comparison]) -> bool:
        """Whether an equation holds at a configuration where comparisons do."""
        assert outcome.true is not None and outcome.printed is not None
        sides, sampled = (outcome.true.node, outcome.printed.node), self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import holds_anywhere
        return holds_anywhere(self.checker, sampled, sides, outcome.pair, bounds)


def slides_pulled_out(checker: ChainChecker) -> list[Comparison]:
    """Return that the sliding joints are pulled out, as one branch of a solution takes them."""
    slides = (symbol for symbol, joint in checker.names.joints.items() if joint.kind == "prismatic")
    return [(n.Name(*each.partition("_")[::2]), ">", n.Number(Fraction(0))) for each in slides]


def _sign_of_root(outcome: Outcome) -> str:
    """Return which root an equation says that something is: that with a minus sign, or that without."""
    assert outcome.true is not None and outcome.printed is not None
    sides = [bare(side.node) for side in (outcome.true, outcome.printed)]
    minus = [each.terms[0][1] for each in sides if isinstance(each, n.Sum) and [s for s, _ in each.terms] == ["-"]]
    if any(n.is_call(bare(each), "sqrt") for each in minus):
        return MINUS_ROOT
    return PLUS_ROOT if any(n.is_call(each, "sqrt") for each in sides) else ""


def _has_a_sign(outcome: Outcome) -> bool:
    """Whether a root or an arc function stands in an equation."""
    return any(n.is_call(below, "sqrt", "abs", *n.ARCS) for node in outcome.nodes for below in n.walk(node))
