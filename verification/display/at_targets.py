"""Numbers worked out of a target, or of a configuration, that a document gives: the sides with letters hold everywhere."""

from __future__ import annotations

from collections.abc import Sequence, Set
from fractions import Fraction
from itertools import pairwise, takewhile

from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.display.two_readings import Decide
from armproof.verification.display.worked_targets import Reached, WorkedTargets, with_right_entry, written_cells
from armproof.verification.equations.at_stated_values import MANY
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import COARSE, FINE, finest_decimals
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.worked_numbers import tells_values
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import HOLDS, Verdict


class AtTargets:
    """Decides numbers where the target is reached. One alone is refuted, where it is a misprint: what is rounded on the way may be off."""

    def __init__(
        self, checker: ChainChecker, circumstances: Circumstances, targets: WorkedTargets, decide: Decide
    ) -> None:
        self.checker, self.names = checker, checker.names
        self.circumstances, self.targets, self.decide = circumstances, targets, decide

    def outcomes(self, chain: n.Chain, equation: int, line: int, own: Set[str] = frozenset()) -> list[Outcome]:
        """Return the outcomes of an equation whose last sides are numbers of an example; [] where it is not that.

        Names that it has just given their meaning, its `own`, have the very numbers: τ = J^T F = (3, 4).
        """
        formulas = [*takewhile(lambda each: not self.targets.is_worked(each), chain.members)]
        numbers = chain.members[len(formulas) :]
        if not {*chain.relations} <= {"=", "≈"} or not formulas or not numbers:
            return []
        if not all(map(self.targets.is_worked, numbers)) or any(map(_divides_by_zero, numbers)):
            return []
        if len(formulas) == 1 and self._may_be_given(bare(formulas[0])):
            return []
        told = self._at_told(numbers)
        for reached in (*self.targets.reached(line), *([told] if told is not None else [])):
            if found := self._where(reached, chain, formulas, equation, line, own, is_told=reached is told):
                return found
        return []

    def _may_be_given(self, alone: n.Node) -> bool:
        """Whether an equation may have given a name its meaning: p_x = 0.54."""
        return (
            isinstance(alone, n.Name)
            and not alone.pre_sup
            and self.names.known_symbol(alone.key) not in self.names.joints
        )

    def _at_told(self, numbers: Sequence[n.Node]) -> Reached | None:
        """Return the configuration that the text tells, if numbers are so fine that they tell values of it."""
        fine = sum(finest_decimals([each]) >= FINE for each in written_cells(numbers[-1]))
        if fine <= 1 and not any(map(tells_values, numbers)):
            return None
        told = self.names.state.given_last | self.circumstances.text.told_values()
        return self.targets.at({key: each.value for key, each in told.items()})

    def _where(
        self,
        reached: Reached,
        chain: n.Chain,
        formulas: Sequence[n.Node],
        equation: int,
        line: int,
        own: Set[str],
        is_told: bool,
    ) -> list[Outcome]:
        """Return the outcomes of numbers at a configuration, if all are right there or one alone is wrong; else []."""
        numbers = chain.members[len(formulas) :]
        telling = (each for each in formulas if own.isdisjoint(name.key for name in n.names(each)))
        true = next(filter(None, map(reached.value, telling)), None)
        errors = [reached.errors(each, true) for each in numbers] if true is not None else []
        if true is None or None in errors:
            return []
        steps = (n.Chain(pair, ("=",)) for pair in pairwise(formulas))
        before = [o for k, step in enumerate(steps) for o in self.decide(step, equation + k, line, False)]
        if any(each.verdict not in HOLDS for each in before):
            return []
        held = before + [
            Outcome(Verdict.CONFIRMED, (say(Kind.TO_DECIMALS_THERE),), equation + k, samples=1)
            for k in range(len(formulas) - 1, len(chain.members) - 1)
        ]
        off = [
            (k, e) for k, each in enumerate(errors) for e, (error, allowed) in enumerate(each or ()) if error > allowed
        ]
        if not off:
            return held
        if len(off) > 1 or (is_told and not _are_of_configuration(numbers, *off[0])):
            return []
        place, entry = off[0]
        right = with_right_entry(numbers[place], entry, true[entry])
        if right is None:
            return []
        step = max(0, len(formulas) + place - 1)
        sides = self.checker.member(right), self.checker.member(chain.members[step + 1])
        wrong = self.checker.equality.compare(*sides, equation + step, False)
        if wrong.verdict is not Verdict.REFUTED or not wrong.wrong:
            return []
        return [wrong if each.equation == wrong.equation else each for each in held]


def _are_of_configuration(numbers: Sequence[n.Node], place: int, entry: int) -> bool:
    """Whether numbers besides a wrong one are right, so that they are of the configuration: another side, or three entries."""
    others = sum(finest_decimals([cell]) >= COARSE for cell in written_cells(numbers[place])) - 1
    return others >= MANY or any(finest_decimals([each]) >= COARSE for k, each in enumerate(numbers) if k != place)


def _divides_by_zero(node: n.Node) -> bool:
    return any(isinstance(b, n.Quotient) and n.ungrouped(b.denominator) == n.Number(Fraction(0)) for b in n.walk(node))
