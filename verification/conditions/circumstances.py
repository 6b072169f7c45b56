"""Under which conditions the text between displays puts those that follow: what may hold there alone is not refuted."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial

from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.matrix import as_matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.given_numbers import fails_at_values, given_numbers, keeps_letters
from armproof.verification.conditions.heeding import Heeding, unbraced, value_of
from armproof.verification.conditions.holding_there import holds_where, postures_of
from armproof.verification.conditions.implication import Implication
from armproof.verification.conditions.postures import vanish_at_quarter_turns
from armproof.verification.conditions.told_branches import ON_A_BRANCH, slides_pulled_out
from armproof.verification.document.postures import THERE, names_singular_place, tells_kind
from armproof.verification.document.sentences import FROM_VALUES, NOT_THERE
from armproof.verification.document.told_singularities import TOLD_SINGULAR
from armproof.verification.equations.alignment import align
from armproof.verification.equations.case_conditions import comparisons_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import finest_decimals
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError, WhereDefined
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key, has_branches, is_number
from armproof.verification.naming.state import Told
from armproof.verification.verdict import HOLDS, Role, Verdict

OF_A_SIGN = ("sqrt", "abs", *n.ARCS)  # a root or an angle that has another sign elsewhere


class Circumstances:
    """Leaves open what follows from what the text says, or may be meant of a posture that it names."""

    def __init__(self, checker: ChainChecker, given: GivenValues) -> None:
        self.checker = checker
        self.given = given
        self.names = checker.names
        self.text = Heeding(checker, given)

    def judge(self, outcome: Outcome, line: int = 0) -> Outcome:
        """Leave open what is refuted, and may be meant where the text before it says: in its own line, or further above."""
        told = self.names.state.told
        if outcome.true is None or outcome.printed is None or outcome.states_values:
            return outcome
        if all(map(is_number, outcome.nodes)) or outcome.tells(
            Kind.DEFINES_ZERO
        ):  # 0.2 + 0.2898 is what it is, wherever
            return outcome
        given = (*told.earlier, *told.conditions)
        is_above = line and told.line != line and not told.is_direct and self.names.arm is not None
        if is_above and keeps_letters(self.checker, self.given, given, outcome.pair):
            told = replace(told, conditions=(), earlier=())
        if not self._is_wrong_at(told, outcome) and any(self._follows(each, outcome) for each in self._told(told)):
            return self._proved_there(outcome) or outcome.left_open(say(Kind.HOLDS_AS_TOLD))
        if self.names.arm is None and told.conditions and any(map(bare_key, outcome.nodes)):
            return outcome.left_open(say(Kind.OTHER_AS_TOLD))  # what a name is, or is there: either may hold the slip
        if told.in_words and not self._is_told(outcome, told) and self._may_hold_there(outcome, told.begins_there):
            return outcome.left_open(say(Kind.POSTURE_IN_WORDS))
        if told.bounds and any(map(_has_a_sign, (outcome.true.node, outcome.printed.node))):
            return self._within(told.bounds, outcome)
        return self._wrong_there(outcome) if told.is_direct else outcome

    def judge_behind(self, outcome: Outcome, said: Sequence[str]) -> Outcome:
        """Leave open what is refuted, and holds with what the text right behind its display says: "where θ_1 = θ_2 = 0"."""
        if outcome.verdict is not Verdict.REFUTED or outcome.true is None or outcome.printed is None:
            return outcome
        conditions: list[n.Chain] = []
        is_of_determinant = False  # "det J = 0 when the arm is stretched" says so of the determinant
        leads_on = not {*TOLD_SINGULAR}.isdisjoint(
            said
        )  # to where the arm is singular, "The singular configuration is"
        told = (each for each in said if each not in (FROM_VALUES, NOT_THERE, *TOLD_SINGULAR))
        for latex in self.text.in_letters(each for each in told if not (leads_on and names_singular_place(each))):
            if outcome.role is not Role.LAW and tells_kind(latex):  # of which kind a joint is, and no posture
                continue
            with suppress(ReadError, RecursionError):
                found = [each for each in self.names.reader.read(unbraced(latex)) if isinstance(each, n.Chain)]
                conditions += [condition for chain in found for condition in self.text.conditions_of(chain)]
                members = [member for chain in found for member in chain.members]
                is_of_determinant |= any(n.is_call(below, "det") for member in members for below in n.walk(member))
                if not found and not is_of_determinant and self._may_hold_there(outcome, THERE in latex):
                    return outcome.left_open(say(Kind.POSTURE_IN_WORDS))
        if FROM_VALUES in said and keeps_letters(self.checker, self.given, conditions, outcome.pair):
            return outcome  # the text leads on from these values
        for posture in postures_of(conditions) if conditions else ():
            if self._follows(posture, outcome) and not self._vanishes(posture, outcome):
                return outcome.left_open(say(Kind.HOLDS_AS_BEHIND))
        return outcome

    def judge_before(self, outcome: Outcome, behind: Sequence[n.Chain]) -> Outcome:
        """Leave open what is refuted, and may be meant where the values that stand behind it in its display say."""
        if outcome.true is None or outcome.printed is None or not self._follows(behind, outcome):
            return outcome
        return outcome.left_open(say(Kind.HOLDS_AS_BEHIND))

    def _vanishes(self, conditions: Sequence[n.Chain], outcome: Outcome) -> bool:
        """Whether an equation gives a determinant that moves, and says 0 = 0 under conditions: "so the arm is singular where θ_2 = 0"."""
        is_determinant = any(n.is_call(below, "det") for node in outcome.nodes for below in n.walk(node))
        moves = outcome.pair is not None and all(
            symbols_in(side.cells) for side in (outcome.pair.true, outcome.pair.printed)
        )
        nought = n.Number(Fraction(0), "0")
        return (
            is_determinant
            and moves
            and all(holds_where(self.checker, conditions, n.Chain((node, nought), ("=",))) for node in outcome.nodes)
        )

    def _proved_there(self, outcome: Outcome) -> Outcome | None:
        """Return what is proved at the values that lead to an equation, in which the joints that have them are no longer."""
        assert outcome.true is not None and outcome.printed is not None
        told = self.names.state.told
        if not told.is_direct or not told.conditions or not outcome.printed.known:
            return None
        cells = [cell for cell in as_matrix(outcome.printed.value).cells if isinstance(cell, Scalar)]
        if any(self._given_by(each) <= symbols_in(cells) for each in told.conditions):
            return None  # it may be meant elsewhere
        claim = n.Chain((outcome.true.node, outcome.printed.node), ("=",))
        found = self._together(told.conditions, Implication("⇒", [[]], [[claim]]), outcome)
        if found is None or found.verdict is not Verdict.PROVED:
            return None
        read_as = outcome.read_as or self.checker.members.read_as(claim)
        return replace(found, findings=(say(Kind.HOLDS_THERE), *found.findings), read_as=read_as)

    def _is_wrong_at(self, told: Told, outcome: Outcome) -> bool:
        """Whether numbers were refuted at the very values that the text gives: nothing else is to be asked of these."""
        given = [self.given.values_of(each) for each in told.conditions]
        if not outcome.there or not given or not all(given):
            return False
        stated = self.names.state.configuration
        values = [(name, node) for each in given for name, node in (each or {}).items()]
        return all(name in stated and self._is_same(stated[name].node, node) for name, node in values)

    def _is_same(self, one: n.Node, other: n.Node) -> bool:
        first, second = (self.checker.member(node).value for node in (one, other))
        return isinstance(first, Scalar) and isinstance(second, Scalar) and (first - second).is_zero()

    def _wrong_there(self, outcome: Outcome) -> Outcome:
        """Return what is refuted with the values that lead to it in both of its sides, where these are all that the text gives."""
        given = [self.given.values_of(each) for each in self.names.state.told.conditions]
        values = {name: self.checker.member(node).value for each in given for name, node in (each or {}).items()}
        if outcome.pair is None or outcome.there or not all(given) or not {*values} <= {*self.given.joints}:
            return outcome
        numbers = {name: self.checker.members.number(each) for name, each in values.items() if isinstance(each, Scalar)}
        if len(numbers) < len(values) or not {*values}.isdisjoint(symbols_in(outcome.pair.printed.cells)):
            return outcome
        with WhereDefined():
            true = outcome.pair.true.map(lambda cell: substitute(cell, values))
            pair = replace(outcome.pair, true=true)
            wrong = [place for place, a, b in pair.entries() if not (a - b).normal().is_zero()]
            return replace(outcome, pair=pair, wrong=wrong, there=numbers) if wrong else outcome
        return outcome

    def numbers_there(self, outcome: Outcome, line: int) -> Outcome | None:
        """Return what is proved, or refuted, of numbers at the values that lead to them; None where nothing is."""
        if outcome.true is None or outcome.printed is None or not outcome.tells(Kind.NUMBERS_OF_NOWHERE):
            return None
        if (
            self.names.arm is None
        ):  # decimals at values of letters are compared elsewhere, and drawing points takes seconds
            return None
        told = self.names.state.told
        is_near = told.line == line or told.holds_below
        return self._proved_there(outcome) or (self._vanishes_not(outcome) if is_near else None)

    def _vanishes_not(self, outcome: Outcome) -> Outcome | None:
        """Return zeros refuted where what is printed beside them is another at the values that lead to them, whatever the lengths are."""
        assert outcome.true is not None and outcome.printed is not None
        told, zeros = self.names.state.told, as_matrix(outcome.printed.value)
        if told.in_words or not all(isinstance(cell, Scalar) and cell.is_zero() for cell in zeros.cells):
            return None
        pairs = align(outcome.true.value, outcome.printed.value, self.checker.exact)
        refuted = replace(outcome, verdict=Verdict.REFUTED, findings=(), pair=next(pairs, None))
        found = self._wrong_there(refuted)
        return found if found.there else None

    def vanishes_there(self, chain: n.Chain, equation: int) -> Outcome | None:
        """Return det J = 0 as a claim that is proved at the values that lead to it; None where it is none."""
        told = self.names.state.told
        if (
            not told.is_direct
            or not told.conditions
            or set(chain.relations) != {"="}
            or not is_number(chain.members[-1])
        ):
            return None
        if not any(n.is_call(below, "det") for member in chain.members for below in n.walk(member)):
            return None
        claim, judged = Implication("⇒", [[]], [[chain]]), Outcome(Verdict.UNCHECKED, (), equation)
        found, anywhere = (self._together(given, claim, judged) for given in (told.conditions, ()))
        if found is None or found.verdict is not Verdict.PROVED or anywhere is not None:
            return None  # that of J J^T is zero wherever J has six rows: those are not meant
        read_as = self.checker.members.read_as(chain)
        return replace(found, findings=(say(Kind.HOLDS_THERE), *found.findings), read_as=read_as)

    def _given_by(self, condition: n.Chain) -> set[str]:
        """Return the joints and lengths to which a condition gives values, or all that it relates."""
        if values := self.given.values_of(condition):
            return {*values}
        sides = [self.checker.member(node).value for node in condition.members]
        return {*symbols_in([each for each in sides if isinstance(each, Scalar)])}

    def as_usual_there(self, outcome: Outcome) -> Outcome | None:
        """Return what is proved of a name as it is usually meant at the values that lead to the equation; None where nothing is."""
        usual, state = outcome.as_usual, self.names.state
        if usual is None or not usual.meanings or not state.told.is_direct:
            return None
        before = state.copy()
        self.names.forget(outcome.defines)  # what it is there is no meaning that the name has everywhere
        for key, quantity in usual.meanings.items():
            state.infer_usual(key, quantity)
        found = self._proved_there(usual.outcome)
        if found is None:
            state.become(before)
        return found

    def within_bounds(self, outcome: Outcome) -> Outcome:
        """Leave open what holds on a branch alone, unless that is where the text before it says: θ_2 ∈ (0, π)."""
        is_on_branch = any(finding.kind in ON_A_BRANCH for finding in outcome.findings)
        bounds = [each for each in self.names.state.told.bounds if is_on_branch and self.text.moves(each)]
        return self._within(bounds, outcome) if bounds else outcome

    def is_beyond_bounds(self, point: Mapping[str, float]) -> bool:
        """Whether a configuration may lie beyond what the text bounds its joints by: by more than the full turn of an angle, or d_3 > 0."""
        bounds = [
            each for chain in self.names.state.told.bounds if self.text.moves(chain) for each in comparisons_of(chain)
        ]
        where = [each for each in bounds if self._may_bound(each, point)]
        if not where:
            return False
        sampled = self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import hold_everywhere
        return not hold_everywhere(self.checker, sampled, where)

    def _may_bound(self, bound: tuple[n.Node, str, n.Node], point: Mapping[str, float]) -> bool:
        """Whether a comparison holds a joint of a configuration, and is not that of a length with a number, as it is there."""
        left, relation, right = bound
        values = [as_scalar(self.checker.member(each).value) for each in (left, right)]
        if point.keys().isdisjoint(symbols_in([each for each in values if isinstance(each, Scalar)])):
            return False
        one, other = (self._number_at(each, point) for each in (left, right))
        if one is None or other is None:
            return True
        return not (one > other if relation in ">≥" else one < other)

    def _number_at(self, node: n.Node, point: Mapping[str, float]) -> float | None:
        """Return the value of a sliding joint at a configuration, or the number that a formula is."""
        symbol = self.names.known_symbol(key) if (key := bare_key(node)) is not None else None
        if symbol is not None and symbol in self.names.joints:
            return None if self.names.is_angle(symbol) else point.get(symbol)
        value = as_scalar(self.checker.member(node).value)
        is_number_alone = isinstance(value, Scalar) and not symbols_in([value])
        return self.checker.members.number(value) if is_number_alone else None

    def _within(self, bounds: Sequence[n.Chain], outcome: Outcome) -> Outcome:
        assert outcome.true is not None and outcome.printed is not None
        where = [each for chain in bounds for each in comparisons_of(chain)]
        sides, sampled = (outcome.true.node, outcome.printed.node), self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import (
                fails_everywhere,
                hold_everywhere,
                holds_anywhere,
                holds_somewhere,
                holds_where,
            )
        if where and not (where := [each for each in where if holds_somewhere(self.checker, sampled, each)]):
            return outcome  # |cos θ_3| > 1: there is no solution
        if where and hold_everywhere(self.checker, sampled, where):  # θ_2 ∈ [0, 2π)
            return outcome
        count = holds_where(self.checker, sampled, sides, outcome.pair, where)
        is_refuted = not count and outcome.verdict is Verdict.REFUTED
        if is_refuted and fails_everywhere(self.checker, sampled, sides, outcome.pair):
            return outcome  # wherever the text means
        if not count and outcome.tells(*ON_A_BRANCH):
            holds = holds_anywhere if any(map(has_branches, outcome.nodes)) else holds_where
            if holds(self.checker, sampled, sides, outcome.pair, [*where, *slides_pulled_out(self.checker)]):
                return outcome
        if not count:
            return outcome.left_open(say(Kind.BOUND_IN_TEXT))
        found = (say(Kind.HOLDS_WHERE_SAID, count=count),)
        return replace(outcome, verdict=Verdict.CONFIRMED, findings=found, samples=count, wrong=[])

    def of_implication(self, judged: Outcome, implication: Implication) -> Outcome:
        """Leave open what does not follow, where it follows together with what the text before says; lengths that are stated hold."""
        if judged.verdict is not Verdict.REFUTED:
            return judged
        stated = self.names.state.configuration
        lengths = [value_of(name, each.node) for name, each in stated.items() if name in self.given.lengths]
        if lengths and (again := self._together(lengths, implication, judged)) is not None:
            return replace(again, equation=judged.equation)
        told = self.names.state.told
        given = [told.conditions, (*told.earlier, *told.conditions)] if told.conditions else []
        postures = dict.fromkeys(posture for each in given for posture in postures_of(each))
        if any(self._together([*lengths, *each], implication, judged) for each in postures):
            return judged.left_open(say(Kind.HOLDS_AS_TOLD))
        return judged

    def _together(self, given: Sequence[n.Chain], implication: Implication, judged: Outcome) -> Outcome | None:
        """Return what becomes of an implication under more conditions; None where it fails, or they are never met."""
        with self.checker.exact.budget.paused():
            from armproof.verification.conditions.judgement import check_implication
        before = [[*given, *each] for each in implication.before]
        behind = [[*given, *each] for each in implication.behind]
        again = check_implication(self.checker, replace(implication, before=before, behind=behind), judged.equation)[0]
        fails = again.verdict is Verdict.REFUTED or say(Kind.CONDITION_NEVER_MET) in again.findings
        return None if fails else again

    def at_premised(self, implication: Implication, equation: int) -> Outcome | None:
        """θ_2 = 60°, l_1 = 1 ⇒ P_x = 0.5: numbers that follow from values alone are those there, as they are rounded."""
        given, claims = implication.before, implication.behind
        if implication.arrow == "⇐":
            given, claims = claims, given
        if implication.arrow == "⇔" or len(given) != 1 or len(claims) != 1 or not finest_decimals(claims[0]):
            return None
        values = [self.given.values_of(chain) for chain in given[0]]
        if not all(values):
            return None
        state = self.names.state
        lengths = {name: each for name, each in state.configuration.items() if name in self.given.lengths}
        with state.unchanged():
            state.configuration = lengths | self.given.stated(
                {k: v for each in values for k, v in (each or {}).items()}
            )
            outcomes = [each for chain in claims[0] for each in self.checker.check(chain, equation, 0, define=False)]
        nowhere = say(Kind.NUMBERS_OF_NOWHERE)
        if any(nowhere in outcome.findings for outcome in outcomes):
            return Outcome(Verdict.UNCHECKED, (nowhere,), equation)
        if any(outcome.verdict not in HOLDS for outcome in outcomes):
            return None
        return Outcome(Verdict.CONFIRMED, (say(Kind.TO_DECIMALS_THERE),), equation, samples=1)

    def of_ranks(self, chain: n.Chain, outcomes: list[Outcome], line: int) -> list[Outcome]:
        """Return what becomes of an equation with a rank, which is decided where the text or a display before it says."""
        told, configuration = self.names.state.told, self.names.state.configuration
        joints = [value_of(name, each.node) for name, each in configuration.items() if name in self.given.joints]
        given = [*told.standing, *joints]
        if not given and not told.in_words:
            return outcomes
        with self.checker.exact.budget.paused():
            from armproof.verification.conditions.ranks_there import rank_everywhere, rank_there
        if told.in_words:
            posture = say(Kind.POSTURE_IN_WORDS)
            return [rank_everywhere(self.checker, chain, each, posture) for each in outcomes]
        found = [rank_there(self.checker, chain, each, given) for each in outcomes]
        again = partial(rank_there, self.checker, chain, given=given)
        if doubt := self.checker.rows.others((chain,), found, lambda: [again(outcome=each) for each in outcomes]):
            return [each.left_open(doubt) for each in found]
        is_near = not told.conditions or told.line == line or told.is_direct
        return found if is_near else [each.unless_refuted(say(Kind.OTHER_AS_TOLD)) for each in found]

    def of_rank_everywhere(self, outcome: Outcome) -> Outcome:
        """Leave open a rank that the text says to be so in every configuration, unless it is: what is proved of one is generic."""
        if not any(map(n.is_rank, (below for node in outcome.nodes for below in n.walk(node)))):
            return outcome
        with self.checker.exact.budget.paused():
            from armproof.verification.conditions.ranks_there import rank_everywhere
        chain = n.Chain(tuple(outcome.nodes), ("=",) * (len(outcome.nodes) - 1))
        return rank_everywhere(self.checker, chain, outcome, say(Kind.RANK_SOMEWHERE))

    def _told(self, told: Told) -> Iterator[tuple[n.Chain, ...]]:
        """Yield the conditions that the text gives, alone and with what was stated before; one of several postures each."""
        if not told.conditions:
            return
        yield from dict.fromkeys([*postures_of(told.conditions), *postures_of((*told.earlier, *told.conditions))])
        for at, condition in enumerate(told.conditions):
            for posture in self._postures(condition):
                yield from postures_of((*told.conditions[:at], posture, *told.conditions[at + 1 :]))

    def _follows(self, conditions: Sequence[n.Chain], outcome: Outcome) -> bool:
        """Whether an equation holds, or nobody can tell, under conditions."""
        assert outcome.true is not None and outcome.printed is not None
        if fails_at_values(
            self.checker, given_numbers(self.checker, self.given, conditions, outcome.pair), outcome.pair
        ):
            return False
        return holds_where(self.checker, conditions, n.Chain((outcome.true.node, outcome.printed.node), ("=",)))

    def _is_told(self, outcome: Outcome, told: Told) -> bool:
        """Whether words such as "stretched" say no more of an equation than the values beside them: of all its joints but the first."""
        values = self.given.values_of_all(told.conditions)
        if outcome.pair is None or not self.text.fits(told, told.bent):
            return False
        moving = symbols_in(outcome.pair.true.cells) & {*self.given.joints}
        return moving <= {*values, *list(self.given.joints)[:1]}

    def _may_hold_there(self, outcome: Outcome, begins_there: bool) -> bool:
        """Whether an equation may hold in a posture that words name.

        A joint moves one side alone; or both agree at quarter turns, and the sentence begins with the posture. What says
        itself where it holds, J|_{θ_2 = 0}, needs no words for it.
        """
        if outcome.pair is None or outcome.states_values:
            return False
        true, printed = outcome.pair.true.cells, outcome.pair.printed.cells
        if symbols_in(true) & set(self.given.joints) != symbols_in(printed) & set(self.given.joints):
            return True
        joints = self.names.arm.joints if self.names.arm is not None else ()
        differences = [a - b for a, b in zip(true, printed, strict=True)] if begins_there else []
        return begins_there and vanish_at_quarter_turns(self.checker.exact, joints, differences)

    def _postures(self, condition: n.Chain) -> tuple[n.Chain, ...]:
        """Return the two values of a joint whose sine or cosine a condition says to be 0, if it says so."""
        scalars = [value for each in condition.members if isinstance(value := self.checker.member(each).value, Scalar)]
        turns = ("sin", ("0", r"\pi")), ("cos", (r"\pi/2", r"-\pi/2"))
        for joint in self.given.joints if len(scalars) == len(condition.members) == 2 else ():
            name = n.Name(*joint.partition("_")[::2])
            for function, values in turns:
                found = self.checker.member(n.Call(function, (name,))).value
                left = scalars[0] - scalars[1]
                if isinstance(found, Scalar) and ((left - found).is_zero() or (left + found).is_zero()):
                    return tuple(value_of(joint, self.names.reader.read_expression(value)) for value in values)
        return ()


def _has_a_sign(node: n.Node) -> bool:
    return any(n.is_call(below, *OF_A_SIGN) for below in n.walk(node))
