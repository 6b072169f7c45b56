"""Under which conditions the text between displays puts those that follow: what may hold there alone is not refuted."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import combinations, pairwise

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.implication import Implication
from armproof.verification.conditions.postures import vanish_at_quarter_turns
from armproof.verification.document.heading import sections_around
from armproof.verification.document.joint_values import in_letters, is_joint_value
from armproof.verification.document.other_meanings import ALL, BEHIND, JACOBIAN
from armproof.verification.document.postures import SINGULAR, THERE, kind_of_joints
from armproof.verification.document.sentences import FROM_VALUES, GENERAL
from armproof.verification.equations.case_conditions import comparisons_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import finest_decimals
from armproof.verification.equations.definitions import angle_of_tangent, squared_name
from armproof.verification.equations.forces import heed_forces
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.under_rates import UnderRates
from armproof.verification.errors import ReadError
from armproof.verification.evaluation.blocks import cells_of, rows_of_letters
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.state import Stated, Told
from armproof.verification.verdict import HOLDS, Verdict

POSTURE = r"\text{posture}"  # one that the text names, and nobody can tell
ON_A_BRANCH = (Kind.ON_A_BRANCH, Kind.TO_DECIMALS_ON_A_BRANCH)
OF_A_SIGN = frozenset("sqrt abs atan2 atan acos asin".split())  # a root or an angle that has another sign elsewhere
_HELD = re.compile(r"\s*(?:\\\{(?P<set>(?:(?!\\[{}]).)*=(?:(?!\\[{}]).)*)\\\}|\((?P<list>[^()]*=[^()]*)\))\s*")


class Circumstances:
    """Heeds what the text says, and leaves open what follows from it or may be meant of a posture that it names."""

    def __init__(self, checker: ChainChecker, given: GivenValues) -> None:
        self.checker = checker
        self.given = given
        self.names = checker.names

    def heed(self, said: Sequence[str], above: int, outside: int, line: int) -> None:
        """The text before a display gives values or a condition: the configuration stated before it is over, perhaps.

        What stands `above` the last heading ends a configuration as well; below it holds what it says of lengths, unless
        it stands `outside`, in a section that is not around that of the display.
        """
        state = self.names.state
        state.told = replace(state.told, is_direct=False)
        for is_outside, texts in ((True, said[:outside]), (False, said[outside:above])):
            if texts:
                before, around = state.told, sections_around(state.section)
                self._heed(texts, line)
                told = before if is_outside else replace(state.told, section=around[0] if around else "")
                state.told = told if told.holds_below else Told()
        if said[above:]:
            self._heed(said[above:], line)

    def _heed(self, said: Iterable[str], line: int) -> None:
        names: set[str] = set()
        conditions: list[n.Chain] = []
        velocities: list[n.Chain] = []
        bounds: list[n.Chain] = []
        in_words = False
        kind = ""
        of_arm = self.names.arm is not None
        said = tuple(said)
        is_last = said[-1:] == (SINGULAR,)
        for latex in self._in_letters(said):
            if latex in (SINGULAR, FROM_VALUES):
                continue
            if latex == GENERAL:
                self._end_configuration(line)
                continue
            if latex.startswith("\\text{") and (of_joints := kind_of_joints(latex)):
                kind = of_joints
                continue
            try:
                found = [each for each in self.names.reader.read(unbraced(latex)) if isinstance(each, n.Chain)]
                chains = [chain for chain in found if not self.given.repeats(chain)]
                bounding = [chain for chain in chains if _is_bound(chain)]
                for bound in bounding:
                    self.names.state.compare(bound, self.given.lengths)
                bounds += (bound for bound in bounding if of_arm and "≠" not in bound.relations)
                if any(map(self._moves, bounding)):  # where θ_2 ≠ 0, nothing is said of θ_2 = π any more
                    names |= {*self.given.joints}
                    self.names.state.told = replace(self.names.state.told, conditions=(), earlier=())
                chains = [chain for chain in chains if not _is_bound(chain)]
                if found and not chains:
                    continue
            except ReadError:
                names |= {*self.given.joints, *self.given.lengths}
                chains = []
            names |= {name for chain in chains for name in _equated(chain)}
            velocities += filter(UnderRates(self.checker.members, Told()).velocity_in, chains) if of_arm else ()
            for chain in (
                chains if of_arm else ()
            ):  # without one a letter of the text is any: it says where things hold, and no more
                heed_forces(self.names, chain)
                self._define(chain, line, conditions)
            chains = [self._without_letters(chain, line) for chain in chains]
            conditions += [condition for chain in chains for condition in self._conditions(chain)]
            in_words = in_words or not chains
        self._begin(names, conditions, in_words, line)
        before = self.names.state.told
        self.names.state.told = replace(
            before,
            of_singularities=is_last,
            begins_there=any(THERE in latex for latex in said),
            velocities=tuple(velocities) or before.velocities,
            bounds=tuple(bounds) or before.bounds,
            kind=kind or before.kind,
            is_direct=bool(conditions) and not in_words and FROM_VALUES in said,
            line=line if velocities or is_last else before.line,
        )
        told = self._values(conditions)
        self.names.state.given_last |= told
        self.names.state.told_lengths |= {name: told[name] for name in told if name in self.given.lengths}

    def _in_letters(self, said: Iterable[str]) -> Iterator[str]:
        """Yield what a text says, the values of joints in words in the arm's letters; those of an arm that is not known as a posture."""
        joints = [] if self.names.arm is None else [key_as_latex(each.symbol) for each in self.names.arm.joints]
        for latex in said:
            yield from (in_letters(latex, joints) or [POSTURE]) if is_joint_value(latex) else [latex]

    def told_values(self) -> dict[str, Stated]:
        """Return the values that the text gives: of lengths, wherever above, and of joints, for the display at hand."""
        return self.names.state.told_lengths | self._values(self.names.state.told.standing)

    def _values(self, conditions: Iterable[n.Chain]) -> dict[str, Stated]:
        return self.given.stated(
            {name: node for each in conditions for name, node in (self.given.values_of(each) or {}).items()}
        )

    def heed_behind(self, said: Iterable[str], statements: Iterable[n.Statement], line: int) -> None:
        """The text behind a display says what a letter of it is: "p_x = ρ c_1", where ρ = …."""
        chains = [each for each in statements if isinstance(each, n.Chain)]
        alone = {bare_key(member) for chain in chains for member in chain.members}
        held = {b.key for chain in chains for b in n.walk(chain) if isinstance(b, n.Name) and self.names.is_open(b)}
        if self.names.arm is None or not (held := held - alone):
            return
        for latex in said:
            with suppress(ReadError, RecursionError):
                for chain in self.names.reader.read(latex):
                    if isinstance(chain, n.Chain) and bare_key(_of_root(chain).members[0]) in held:
                        self._define(chain, line)

    def _define(self, chain: n.Chain, line: int, conditions: Sequence[n.Chain] = ()) -> None:
        """x_p = x − l_3 cos α: a letter that has no meaning gets one, until a display gives it another."""
        chain = _of_root(chain)
        name = chain.members[0]
        if chain.relations != ("=",) or not isinstance(name, n.Name) or name.dots:
            return
        if self.names.quantity(name) is not None and rows_of_letters(chain.members[1]):  # T = [s n a P; 0 0 0 1]
            self.checker.check(chain, 1, line)
            return
        if self._says_anew(name, chain.members[1]) and not (conditions and self._holds_where(conditions, chain)):
            before = self.names.state.definitions[name.key]
            if not before.in_text:
                self.names.leave_open(name.key, say(Kind.SECOND_MEANING, name=name.text or name.key, line=line))
                return
            del self.names.state.definitions[name.key]
        if not self.names.is_open(name) or self.names.angle_sum(name) is not None:  # θ_{23} is θ_2 + θ_3
            return
        members, value = self.checker.members, chain.members[1]
        usual = is_usual(name) and self.names.usual(name)  # type: ignore[arg-type]
        if usual or isinstance(bare(value), n.Name):
            return
        (found,) = self.checker.conventions.bind([members.evaluate(value)])
        told = as_scalar(found.value) if found.known else None
        cells = told.cells if isinstance(told, Matrix) and told.shape[1] == 1 else [told]
        scalars = [cell for cell in cells if isinstance(cell, Scalar)]
        if len(scalars) == len(cells) and symbols_in(scalars):
            self.names.define(name.key, members.meaning(value), line, node=value, in_text=True)

    def _says_anew(self, name: n.Name, node: n.Node) -> bool:
        """Whether a letter that the document has defined gets another meaning, a formula and no value: "Now let k_1 = l_1 - l_2 c_2"."""
        before = self.names.state.definitions.get(name.key)
        if before is None or before.by_place or before.by_table or isinstance(bare(node), n.Name):
            return False
        consulted = frozenset(self.names.state.consulted)
        values = [as_scalar(self.checker.members.evaluate(each).value) for each in (name, node)]
        self.names.state.consulted.intersection_update(consulted)
        scalars = [each for each in values if isinstance(each, Scalar)]
        return len(scalars) == 2 and bool(symbols_in(scalars[1:])) and not (scalars[0] - scalars[1]).normal().is_zero()

    def _without_letters(self, chain: n.Chain, line: int) -> n.Chain:
        """l_1 = l_2 = l relates lengths, and says what the letter l is; return the chain without it."""
        related = self.given.related(chain) if set(chain.relations) == {"="} else []
        if len(related) < 2 or len(related) == len(chain.members):
            return chain
        for letter in (bare_key(each) for each in chain.members if each not in related):
            meaning = self.checker.members.meaning(related[0])
            self.names.define(str(letter), meaning, line, node=related[0], in_text=True)
        return replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1))

    def of_display(self, chain: n.Chain, *, holds_nowhere: bool = False) -> None:
        """A display that is a condition itself, c_1 = 1, l_1 = l_2, or P_y = 0 of a configuration that is not told, may limit those behind it."""
        if self.names.arm is None:
            return
        conditions = [*self._conditions(chain)]
        sides = [as_scalar(self.checker.member(node).value) for node in chain.members if holds_nowhere]
        if not conditions and chain.relations == ("=",) and sides and all(isinstance(each, Scalar) for each in sides):
            conditions = [chain]
        self._begin(set(), conditions, in_words=False)

    def judge_behind(self, outcome: Outcome, said: Sequence[str]) -> Outcome:
        """Leave open what is refuted, and holds with what the text right behind its display says: "where θ_1 = θ_2 = 0"."""
        if outcome.verdict is not Verdict.REFUTED or outcome.true is None or outcome.printed is None:
            return outcome
        conditions: list[n.Chain] = []
        is_of_determinant = False  # "det J = 0 when the arm is stretched" says so of the determinant
        for latex in self._in_letters(each for each in said if each != FROM_VALUES):
            with suppress(ReadError, RecursionError):
                found = [each for each in self.names.reader.read(unbraced(latex)) if isinstance(each, n.Chain)]
                conditions += [condition for chain in found for condition in self._conditions(chain)]
                members = [member for chain in found for member in chain.members]
                is_of_determinant |= any(n.is_call(below, "det") for member in members for below in n.walk(member))
                if not found and not is_of_determinant and self._may_hold_there(outcome, THERE in latex):
                    return outcome.left_open(say(Kind.POSTURE_IN_WORDS))
        if conditions and self._follows(conditions, outcome) and not self._vanishes(conditions, outcome):
            return outcome.left_open(say(Kind.HOLDS_AS_BEHIND))
        return outcome

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
            and all(self._holds_where(conditions, n.Chain((node, nought), ("=",))) for node in outcome.nodes)
        )

    def unless_meant_otherwise(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is written with a letter that the text gives another meaning than the arm has for it."""
        written = {below.key for node in outcome.nodes for below in n.walk(node) if isinstance(below, n.Name)}
        if JACOBIAN in meant and JACOBIAN in written:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=JACOBIAN))
        sides = (outcome.pair.true, outcome.pair.printed) if outcome.pair is not None else ()
        written |= symbols_in(cell for side in sides for cell in side.cells if isinstance(cell, Scalar))
        for each in meant:
            letters = self._meant_by(each)
            if not written.isdisjoint(letters):
                return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=min(written & letters)))
        return outcome

    def _meant_by(self, meant: str) -> set[str]:
        r"""Return the joints and lengths that a letter, or the word for all angles, names: of `BEHIND` those that are measured from a joint before them."""
        which, _, latex = meant.partition(" ")
        if which not in (ALL, BEHIND):
            return set()
        of_arm = {*self.given.lengths} | self._turned(which == BEHIND)
        if not latex:
            return self._turned(which == BEHIND)
        try:
            return {bare_key(self.names.reader.read_expression(latex)) or ""} & of_arm
        except ReadError:
            return set()

    def _turned(self, only_behind: bool) -> set[str]:
        """Return the joints that turn; or those alone that a joint before them turns about the same direction."""
        if self.names.arm is None:
            return {*self.given.joints}
        turning = [joint for joint in self.names.arm.joints if joint.kind == "revolute"]
        if not only_behind:
            return {joint.symbol for joint in turning}
        whole = self.checker.exact.jacobian(self.names.arm.frames[-1], self.names.arm.frames[0])
        axes = {joint: [row[joint.index - 1] for row in whole.rows[3:]] for joint in turning}
        found = set()
        for before, joint in combinations(turning, 2):
            pairs = [*zip(axes[joint], axes[before], strict=True)]
            if all((a - b).is_zero() for a, b in pairs) or all((a + b).is_zero() for a, b in pairs):
                found.add(joint.symbol)
        return found

    def _end_configuration(self, line: int) -> None:
        """ "In general": the configuration stated before is over. What holds there alone is not refuted behind it."""
        state = self.names.state
        ended = {key: state.configuration.pop(key) for key in {*state.configuration} - {*self.given.lengths}}
        given = tuple(_value(key, each.node) for key, each in ended.items()) or state.told.conditions
        state.told = Told(conditions=given, line=line, section=state.section, is_over=True) if given else Told()
        state.given_last = {key: each for key, each in state.given_last.items() if key in self.given.lengths}

    def _begin(self, names: set[str], conditions: Sequence[n.Chain], in_words: bool, line: int = 0) -> None:
        """Forget what is given anew: a length by its name, a configuration as a whole."""
        state = self.names.state
        held = names | {b.key for each in conditions for b in n.walk(each) if isinstance(b, n.Name)}
        angles = any(isinstance(below, n.JointAngles) for each in conditions for below in n.walk(each))
        moves = in_words or angles or not held.isdisjoint((*self.given.joints, "q", "theta"))
        over = [key for key in state.configuration if key in names or (moves and key not in self.given.lengths)]
        ended = [(key, _value(key, state.configuration.pop(key).node)) for key in over]
        if conditions or in_words:
            earlier = tuple(value for key, value in ended if key not in names)
            state.told = Told(
                tuple(conditions), earlier, in_words, line=line, section=state.section, holds_below=not moves
            )

    def _conditions(self, chain: n.Chain) -> Iterator[n.Chain]:
        """Yield the values that an equation gives, or itself where it is one of joints and lengths that is no identity."""
        if set(chain.relations) - {"=", "≈"} or len(chain.members) < 2:
            return
        if values := self.given.values_of(chain):
            yield from (_value(name, node) for name, node in values.items())
            return
        members = [self.checker.member(node) for node in chain.members]
        if any(self.checker.quantity_of(below) is not None for node in chain.members for below in n.walk(node)):
            return
        scalars = [value for member in members if isinstance(value := as_scalar(member.value), Scalar)]
        of_arm = {*self.given.joints, *self.given.lengths} if self.names.arm is not None else symbols_in(scalars)
        if len(scalars) < len(members) or of_arm.isdisjoint(symbols_in(scalars)):
            return
        apart = [difference for a, b in pairwise(scalars) if not (difference := a - b).is_zero()]
        if apart and all(symbols_in([difference.normal()]) for difference in apart):  # θ_3 = θ_3 - π/2 holds nowhere
            yield replace(chain, relations=("=",) * len(chain.relations))

    def judge(self, outcome: Outcome) -> Outcome:
        """Leave open what is refuted, and may be meant where the text before it says."""
        told = self.names.state.told
        if outcome.true is None or outcome.printed is None or outcome.states_values:
            return outcome
        if any(self._follows(each, outcome) for each in self._told(told)):
            return self._proved_there(outcome) or outcome.left_open(say(Kind.HOLDS_AS_TOLD))
        if self.names.arm is None and told.conditions and any(map(bare_key, outcome.nodes)):
            return outcome.left_open(say(Kind.OTHER_AS_TOLD))  # what a name is, or is there: either may hold the slip
        if told.in_words and self._may_hold_there(outcome, told.begins_there):
            return outcome.left_open(say(Kind.POSTURE_IN_WORDS))
        if told.bounds and any(map(_has_a_sign, (outcome.true.node, outcome.printed.node))):
            return self._within(told.bounds, outcome)
        return outcome

    def _proved_there(self, outcome: Outcome) -> Outcome | None:
        """Return what is proved at the values that lead to an equation, in which the joints that have them are no longer."""
        assert outcome.true is not None and outcome.printed is not None
        told = self.names.state.told
        values = [self.given.values_of(each) for each in told.conditions] if told.is_direct else []
        joints = {name for each in values for name in each or {}}.intersection(self.given.joints)
        if not joints or not all(values) or not outcome.printed.known:
            return None
        cells = [cell for cell in as_matrix(outcome.printed.value).cells if isinstance(cell, Scalar)]
        if not joints.isdisjoint(symbols_in(cells)):
            return None
        claim = n.Chain((outcome.true.node, outcome.printed.node), ("=",))
        found = self._together(told.conditions, Implication("⇒", [[]], [[claim]]), outcome)
        if found is None or found.verdict is not Verdict.PROVED:
            return None
        return replace(found, findings=(say(Kind.HOLDS_THERE), *found.findings), read_as=outcome.read_as)

    def within_bounds(self, outcome: Outcome) -> Outcome:
        """Leave open what holds on a branch alone, unless that is where the text before it says: θ_2 ∈ (0, π)."""
        is_on_branch = any(finding.kind in ON_A_BRANCH for finding in outcome.findings)
        bounds = [each for each in self.names.state.told.bounds if is_on_branch and self._moves(each)]
        return self._within(bounds, outcome) if bounds else outcome

    def _moves(self, bound: n.Chain) -> bool:
        """Whether a bound is one of the configuration, and not of lengths or of other letters alone."""
        sides = [
            node for comparison in comparisons_of(bound) for node in (comparison[0], comparison[2])
        ] or bound.members
        members = [as_scalar(self.checker.member(node).value) for node in sides]
        return not symbols_in([each for each in members if isinstance(each, Scalar)]).isdisjoint(self.given.joints)

    def _within(self, bounds: Sequence[n.Chain], outcome: Outcome) -> Outcome:
        assert outcome.true is not None and outcome.printed is not None
        where = [each for chain in bounds for each in comparisons_of(chain)]
        sides, sampled = (outcome.true.node, outcome.printed.node), self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import (
                fails_everywhere,
                hold_everywhere,
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
        if not count:
            return outcome.left_open(say(Kind.BOUND_IN_TEXT))
        found = (say(Kind.HOLDS_WHERE_SAID, count=count),)
        return replace(outcome, verdict=Verdict.CONFIRMED, findings=found, samples=count, wrong=[])

    def of_implication(self, judged: Outcome, implication: Implication) -> Outcome:
        """Leave open what does not follow, where it follows together with what the text before says; lengths that are stated hold."""
        if judged.verdict is not Verdict.REFUTED:
            return judged
        stated = self.names.state.configuration
        lengths = [_value(name, each.node) for name, each in stated.items() if name in self.given.lengths]
        if lengths and (again := self._together(lengths, implication, judged)) is not None:
            return replace(again, equation=judged.equation)
        given = self.names.state.told.conditions
        if not given or self._together([*lengths, *given], implication, judged) is None:
            return judged
        return judged.left_open(say(Kind.HOLDS_AS_TOLD))

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
        joints = [_value(name, each.node) for name, each in configuration.items() if name in self.given.joints]
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
        is_near = not told.conditions or told.line == line
        return found if is_near else [each.unless_refuted(say(Kind.OTHER_AS_TOLD)) for each in found]

    def judge_before(self, outcome: Outcome, behind: Sequence[n.Chain]) -> Outcome:
        """Leave open what is refuted, and may be meant where the values that stand behind it in its display say."""
        if outcome.true is None or outcome.printed is None or not self._follows(behind, outcome):
            return outcome
        return outcome.left_open(say(Kind.HOLDS_AS_BEHIND))

    def _told(self, told: Told) -> Iterator[tuple[n.Chain, ...]]:
        """Yield the conditions that the text gives, alone and with what was stated before; one of several postures each."""
        if told.conditions:
            yield from dict.fromkeys([told.conditions, (*told.earlier, *told.conditions)])
            for at, condition in enumerate(told.conditions):
                for posture in self._postures(condition):
                    yield (*told.conditions[:at], posture, *told.conditions[at + 1 :])

    def _follows(self, conditions: Sequence[n.Chain], outcome: Outcome) -> bool:
        """Whether an equation holds, or nobody can tell, under conditions."""
        assert outcome.true is not None and outcome.printed is not None
        return self._holds_where(conditions, n.Chain((outcome.true.node, outcome.printed.node), ("=",)))

    def _holds_where(self, conditions: Sequence[n.Chain], claim: n.Chain) -> bool:
        """Whether a claim holds under conditions, or nobody can tell."""
        with self.checker.exact.budget.paused():  # few documents need it: the import is none of its time
            from armproof.verification.conditions.judgement import check_implication

        implication = Implication("⇒", [[*conditions]], [[claim]])
        return check_implication(self.checker, implication, 1)[0].verdict is not Verdict.REFUTED

    def _may_hold_there(self, outcome: Outcome, begins_there: bool) -> bool:
        """Whether an equation may hold in a posture that words name.

        A joint moves one side alone; or both agree at quarter turns, and the sentence begins with the posture.
        """
        if outcome.pair is None:
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
                    return tuple(_value(joint, self.names.reader.read_expression(value)) for value in values)
        return ()


def _has_a_sign(node: n.Node) -> bool:
    return any(isinstance(below, n.Call) and below.function in OF_A_SIGN for below in n.walk(node))


def unbraced(latex: str) -> str:
    """Return the equations of {θ_1 = 30°, θ_2 = 60°}, which set braces or parentheses hold together."""
    found = _HELD.fullmatch(latex)
    return (found["set"] or found["list"]) if found is not None else latex


def _of_root(chain: n.Chain) -> n.Chain:
    """r² = x² + y² says that r = √(x² + y²), which is a length and positive; tan β = y/x what β is."""
    if chain.relations == ("=",) and (turned := angle_of_tangent(*chain.members)) is not None:
        return replace(chain, members=turned)
    if chain.relations != ("=",) or squared_name(chain.members[0]) is None:
        return chain
    square, value = chain.members
    assert isinstance(square, n.Power)
    return replace(chain, members=(bare(square.base), n.placed(n.Call("sqrt", (value,), "\\sqrt"), value.span)))


def _is_bound(chain: n.Chain) -> bool:
    in_interval = chain.relations == ("∈",) and n.interval_of("∈", chain.members[1]) is not None
    return in_interval or (bool(chain.relations) and set(chain.relations).issubset("<>≤≥≠"))


def _equated(chain: n.Chain) -> Iterator[str]:
    """Yield the names that stand alone on a side, or in a list on one."""
    for side in chain.members if chain.relations else ():
        for cell in (side, *cells_of(side)):
            if isinstance(cell, n.Name):
                yield replace(cell, dots=0).key


def _value(name: str, node: n.Node) -> n.Chain:
    dots, _, letter = name.rpartition(" ")
    return n.Chain((n.Name(*letter.partition("_")[::2], dots=dots.count("dot")), node), ("=",))
