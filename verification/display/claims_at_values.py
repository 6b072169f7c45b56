"""Claims at values that are given: in a column of rates, in the text before, in a worked example, of a velocity."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, takewhile

from armproof.verification.display.claims import Claims
from armproof.verification.display.worked_targets import WorkedTargets, with_right_entry, written_cells
from armproof.verification.equations.at_stated_values import MANY, is_mostly_right
from armproof.verification.equations.decimals import COARSE, FINE, finest_decimals
from armproof.verification.equations.inequalities import is_numbers
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.under_rates import JACOBIAN, UnderRates
from armproof.verification.equations.worked_numbers import tells_values, unitless
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, is_number
from armproof.verification.naming.state import DocumentState
from armproof.verification.verdict import DECIDED, HOLDS, Verdict


class ClaimsAtValues:
    """What equations claim at the values that a document gives: numbers may be those there."""

    def __init__(self, claims: Claims) -> None:
        self.claims = claims
        self.checker, self.names, self.given = claims.checker, claims.names, claims.decision.given
        self.targets = WorkedTargets((), claims.checker.members)

    def claim(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain that is no condition: numbers may be those of given values, and of rates in a column."""
        if rates := self.given.rates_of_column(chain):
            stated = self.names.state.configuration
            self.names.state.configuration = {**self.given.stated(rates), **stated}
            outcomes = self._at_values(chain, equation, line, define)
            self.names.state.configuration = stated
            return outcomes
        under = UnderRates(self.checker.members, self.names.state.told)
        if self.names.arm is None or not n.has_rates(chain) or not under.concerns(chain):
            return self._at_values(chain, equation, line, define)
        before = self.names.state.copy()
        outcomes = self._at_values(chain, equation, line, define)
        is_open = not outcomes or any(outcome.verdict not in HOLDS for outcome in outcomes)
        if not is_open or any(outcome.verdict is Verdict.REFUTED for outcome in outcomes):
            return outcomes
        return self._under_rates(under, chain, before, equation, line) or outcomes

    def _under_rates(
        self, under: UnderRates, chain: n.Chain, before: DocumentState, equation: int, line: int
    ) -> list[Outcome]:
        """Return what becomes of an equation under the rates or the velocity that are given, where it holds or is a slip away; else nothing."""
        for reading, meanings in under.readings(chain):
            after = self.names.state.copy()
            self.names.state.become(before)
            self.names.state.inferred |= meanings
            self.names.state.told = under.told_besides
            tried = self.claims.chain(reading, equation, line, False)
            self.names.state.become(before)
            wrong = [each for each in tried if each.verdict not in HOLDS]
            is_meant = before.told.has_shown or before.told.line in (0, line)
            if tried and (not wrong or (is_meant and all(each.verdict is Verdict.REFUTED for each in wrong))):
                tried = [under.unless_data(each) for each in tried] if len(tried) == 1 else tried
                tried = [each.unless_slip(say(Kind.OTHER_AS_TOLD)) for each in tried]
                for each in tried:
                    each.read_as = each.read_as if JACOBIAN.key not in each.read_as else ""
                    if each.verdict in HOLDS:
                        each.also(say(Kind.UNDER_RATES))
                self.names.state.told = replace(before.told, has_shown=True)
                return tried
            self.names.state.become(after)
        return []

    def _at_values(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        self.claims.begin()
        if _is_of_rank(chain):
            return self.claims.circumstances.of_ranks(chain, self.claims.chain(chain, equation, line, define), line)
        there = self._at_told_values(chain, equation, line)
        if any(outcome.verdict in DECIDED for outcome in there):
            return [replace(self.claims.unless_doubted(outcome), uses=self.claims.consulted()) for outcome in there]
        outcomes = self.claims.chain(chain, equation, line, define)
        is_open = any(each.verdict not in HOLDS for each in outcomes) and not any(
            each.verdict is Verdict.REFUTED and each.true is not None and not is_number(each.true.node)
            for each in outcomes
        )
        if is_open and (worked := self._of_worked_example(chain, equation, line)):
            return worked
        is_open = is_open and any(each.verdict is Verdict.UNCHECKED for each in outcomes)
        if is_open and (worked := self._of_target(chain, equation, line)):
            return worked
        outcomes = self._with_wrong_numbers(chain, outcomes, equation, line)
        for outcome in outcomes if there else ():
            if outcome.tells(Kind.NUMBERS_OF_NOWHERE):
                outcome.findings = there[0].findings
        return outcomes

    def _of_worked_example(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return the outcomes of numbers that hold at the values given last, under whatever heading; [] where some do not.

        What is "Given" in centimetres is often worked out without a unit. Only one number of a matrix is refuted there, of which
        many others are right: else the numbers may be of other values.
        """
        state = self.names.state
        if not state.given_last or set(chain.relations) != {"="} or not any(map(tells_values, chain.members)):
            return []
        before = state.copy()
        for given in unitless(state.given_last):
            state.configuration = {key: replace(each, section=state.section) for key, each in given.items()}
            self.claims.begin()
            steps = [replace(chain, members=pair, relations=("=",)) for pair in pairwise(chain.members)]
            outcomes = [
                o
                for k, step in enumerate(steps)
                for o in self.claims.readings.outcomes(step, equation + k, line, False)
            ]
            held = [each for each in outcomes if each.verdict in HOLDS]
            slips = [each for each in outcomes if each not in held and is_mostly_right(each, MANY)]
            tells = any(each.tells(Kind.TO_DECIMALS_THERE) for each in held) or slips
            if outcomes and tells and len(held) + len(slips) == len(outcomes):
                state.configuration = before.configuration
                return [replace(self.claims.unless_doubted(each), uses=self.claims.consulted()) for each in outcomes]
            state.become(before)
        return []

    def _of_target(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return the outcomes of what is worked out of a target, or of a configuration, that is given in numbers; [] where it is not that.

        The sides with letters hold everywhere; the numbers behind them are those where the target is reached. One alone is
        refuted, where it is a misprint of the right one: what is rounded on the way may be off.
        """
        formulas = [*takewhile(lambda each: not self.targets.is_worked(each), chain.members)]
        numbers = chain.members[len(formulas) :]
        if not {*chain.relations} <= {"=", "≈"} or not formulas or not numbers:
            return []
        if not all(map(self.targets.is_worked, numbers)) or any(map(_divides_by_zero, numbers)):
            return []
        alone = bare(formulas[0]) if len(formulas) == 1 else None
        if (
            isinstance(alone, n.Name)
            and not alone.pre_sup
            and self.names.known_symbol(alone.key) not in self.names.joints
        ):
            return []  # p_x = 0.54 may have given the name its meaning
        told = self.names.state.given_last | self.claims.circumstances.text.told_values()
        fine = sum(finest_decimals([each]) >= FINE for each in written_cells(numbers[-1]))
        tells = fine > 1 or any(map(tells_values, numbers))
        given = self.targets.at({key: each.value for key, each in told.items()}) if tells else None
        for reached in (*self.targets.reached(line), *([given] if given is not None else [])):
            true = next(filter(None, map(reached.value, formulas)), None)
            errors = [reached.errors(each, true) for each in numbers] if true is not None else []
            before = self._of_formulas(formulas, equation, line)
            if true is None or None in errors or any(each.verdict not in HOLDS for each in before):
                continue
            off = [
                (k, e)
                for k, each in enumerate(errors)
                for e, (error, allowed) in enumerate(each or ())
                if error > allowed
            ]
            held = before + [
                Outcome(Verdict.CONFIRMED, (say(Kind.TO_DECIMALS_THERE),), equation + k, samples=1)
                for k in range(len(formulas) - 1, len(chain.members) - 1)
            ]
            if not off:
                return held
            if len(off) > 1 or (reached is given and not self._are_of(numbers, *off[0])):
                continue
            (place, entry) = off[0]
            right = with_right_entry(numbers[place], entry, true[entry])
            if right is None:
                continue
            place = max(0, len(formulas) + place - 1)
            sides = self.checker.member(right), self.checker.member(chain.members[place + 1])
            wrong = self.checker.equality.compare(*sides, equation + place, False)
            if wrong.verdict is Verdict.REFUTED and wrong.wrong:
                return [wrong if each.equation == wrong.equation else each for each in held]
        return []

    def _are_of(self, numbers: Sequence[n.Node], place: int, entry: int) -> bool:
        """Whether numbers besides a wrong one are right, so that they are of the configuration: another side, or three entries."""
        others = sum(finest_decimals([cell]) >= COARSE for cell in written_cells(numbers[place])) - 1
        return others >= MANY or any(finest_decimals([each]) >= COARSE for k, each in enumerate(numbers) if k != place)

    def _of_formulas(self, formulas: Sequence[n.Node], equation: int, line: int) -> list[Outcome]:
        """Return what becomes of what stands before the numbers, of every configuration."""
        steps = (n.Chain(pair, ("=",)) for pair in pairwise(formulas))
        return [
            o for k, step in enumerate(steps) for o in self.claims.readings.outcomes(step, equation + k, line, False)
        ]

    def _at_told_values(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return what becomes of numbers at the values that the text before gives; [] where there are none.

        What is not decided there leaves no trace. Only few numbers of many are refuted there, and fewer still that do not stand right behind the text.
        """
        state = self.names.state
        speaks = state.told.standing or state.told_lengths
        if not speaks or len(chain.members) < 2 or not any(map(is_numbers, chain.members)):
            return []
        before = state.copy()
        state.configuration = self.claims.circumstances.text.told_values() | state.configuration
        outcomes = self.claims.readings.outcomes(chain, equation, line, False)
        wrong = [each for each in outcomes if each.verdict not in HOLDS]
        times = 1 if state.told.line == line else MANY
        if not wrong or all(is_mostly_right(each, times) for each in wrong):
            state.configuration = before.configuration
            return outcomes
        state.become(before)
        return [each.left_open(say(Kind.OTHER_AS_TOLD)) for each in wrong if each.verdict is Verdict.REFUTED]

    def _with_wrong_numbers(self, chain: n.Chain, outcomes: list[Outcome], equation: int, line: int) -> list[Outcome]:
        """φ = θ_1 + θ_2 = 30° + 45° = 85°: numbers at the end of a chain are to be equal, of whatever values they are."""
        is_open = {each.equation for each in outcomes if each.verdict is Verdict.UNCHECKED}
        if not is_open or set(chain.relations) != {"="}:
            return outcomes
        first = len(chain.members) - len(list(takewhile(is_number, reversed(chain.members))))
        if first < 1 or len(chain.members) - first < 2:
            return outcomes
        if not any(map(tells_values, chain.members[first:])):
            return outcomes
        wrong = {each.equation: each for each in self.claims.readings.unequal(chain, first, equation, line)}
        return [wrong.get(each.equation, each) if each.equation in is_open else each for each in outcomes]


def _divides_by_zero(node: n.Node) -> bool:
    return any(isinstance(b, n.Quotient) and n.ungrouped(b.denominator) == n.Number(Fraction(0)) for b in n.walk(node))


def _is_of_rank(chain: n.Chain) -> bool:
    """Whether a rank stands in a chain that does not say itself at which values."""
    below = [*n.walk(chain)]
    return any(map(n.is_rank, below)) and not any(isinstance(each, n.At) for each in below)
