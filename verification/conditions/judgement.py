"""What becomes of an implication: proved, refuted at a configuration, or left open."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import write_bounded
from armproof.verification.conditions.entailment import Entailment
from armproof.verification.conditions.implication import (
    Implication,
    has_rank_within,
    is_condition,
    is_rank_condition,
)
from armproof.verification.conditions.signs import ORDERS, Reader, Signs, follow
from armproof.verification.conditions.system import System, Undecided, read_condition
from armproof.verification.conditions.tied_signs import Judged, under_signs_before, with_signs_tied
from armproof.verification.equations.case_conditions import comparisons_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import finest_decimals
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError, NoValue, TooComplex
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict


def check_implication(
    checker: ChainChecker, implication: Implication, equation: int, links: Sequence[Implication] = ()
) -> Judged:
    """Return the verdict of premises ⇒ (⇔, ⇐) conclusions, and a configuration that refutes it.

    What is wrong by itself is left open where it may be meant of a configuration at rest there (rates), of lengths of which
    one is the larger, or together with the premises of the links before it.
    """
    if any(map(has_rank_within, implication.chains)):
        return Outcome(Verdict.UNCHECKED, (say(Kind.RANK_IS_NO_NUMBER),), equation), {}
    if checker.names.arm is not None and any(compares(chain) for chain in implication.chains):
        outcome, found = _of_signs(checker, implication, equation)
        if outcome.verdict is Verdict.UNCHECKED and (there := _equation_where(checker, implication, equation)):
            return there, {}
        wrong = outcome.verdict is Verdict.REFUTED
        return (outcome.left_open(say(Kind.UNDER_MORE)), {}) if wrong and links else (outcome, found)
    outcome, found = _with_its_signs(checker, implication, equation)
    if outcome.verdict is not Verdict.REFUTED:
        return _unless_signs_before(checker, implication, outcome, links), found
    if found and finest_decimals(implication.chains) and _nearly_holds(checker, implication, found):
        return outcome.left_open(say(Kind.MADE_OF_ROUNDED)), {}
    rates = any(isinstance(b, n.Name) and b.dots for chain in implication.chains for b in n.walk(chain))
    signs = checker.exact.ring.signs_chosen and checker.names.state.compares_lengths
    if links and implication.arrow == "⇒":
        before = [[*a, *b] for a, b in itertools.product(links[0].before, implication.before)]
        together = _follows(checker, replace(implication, before=before), equation)[0]
        signs = signs or together.verdict is not Verdict.REFUTED
    return (Outcome(Verdict.UNCHECKED, (say(Kind.UNDER_MORE),), equation), {}) if rates or signs else (outcome, found)


def _nearly_holds(checker: ChainChecker, implication: Implication, point: dict[str, float]) -> bool:
    checker.sampled()  # raises where nothing may be drawn
    with checker.exact.budget.paused():
        from armproof.verification.conditions.rounded_there import nearly_holds

    return nearly_holds(checker, implication, point)


def compares(chain: n.Chain) -> bool:
    """Whether a chain says that something is larger, or in an interval; a rank below another is a condition of its own."""
    if is_rank_condition(chain):
        return False
    interval = chain.relations == ("∈",) and n.interval_of("∈", chain.members[1]) is not None
    return interval or not ORDERS.keys().isdisjoint(chain.relations)


def _of_signs(checker: ChainChecker, implication: Implication, equation: int) -> Judged:
    """What follows from signs is proved; refuted is what fails at a configuration where they are so."""
    try:
        sides = [[Reader(checker).read(chains) for chains in side] for side in (implication.before, implication.behind)]
        point = None
        for given, asked in {"⇒": (sides,), "⇐": (sides[::-1],), "⇔": (sides, sides[::-1])}[implication.arrow]:
            (conclusion, *others), positive = asked, _positive(checker)
            if others or conclusion.has_equation or not conclusion.signs:
                raise Undecided(say(Kind.SIGNS_NOT_SHOWN))
            left = [each for each in given if not follow(each.signs, conclusion.signs, positive)]
            compared = Reader(checker).read(checker.names.state.comparisons)
            points = (_point(checker, each, compared, conclusion) for each in left)
            if left and (point := next(filter(None, points), None)) is None:
                raise Undecided(say(Kind.SIGNS_NOT_SHOWN))
            if point is not None:
                holds, fails = ("left", "right") if given is sides[0] else ("right", "left")
                finding = say(Kind.DOES_NOT_FOLLOW, holds=holds, fails=fails)
                return Outcome(Verdict.REFUTED, (finding,), equation), point
    except EvaluationError as problem:
        return Outcome(Verdict.UNCHECKED, (finding_of(problem),), equation), {}
    return Outcome(Verdict.PROVED, (), equation), {}


def _equation_where(checker: ChainChecker, implication: Implication, equation: int) -> Outcome | None:
    """sin θ_2 > 0 ⇒ sin θ_2 = √(1 − cos² θ_2): return what samples confirm where the comparisons hold."""
    given, claims = implication.before, implication.behind
    if implication.arrow == "⇐":
        given, claims = claims, given
    if implication.arrow == "⇔" or len(given) != 1 or len(claims) != 1 or not all(map(compares, given[0])):
        return None
    if any(chain.relations != ("=",) for chain in claims[0]):
        return None
    where, sampled = [each for chain in given[0] for each in comparisons_of(chain)], checker.sampled()
    with checker.exact.budget.paused():
        from armproof.verification.equations.sampled_relations import holds_where
    counts = [holds_where(checker, sampled, (c.members[0], c.members[1]), None, where) for c in claims[0]]
    found = (say(Kind.HOLDS_WHERE_SAID, count=min(counts)),)
    return Outcome(Verdict.CONFIRMED, found, equation, samples=min(counts)) if all(counts) else None


def _positive(checker: ChainChecker) -> frozenset[str]:
    arm = checker.names.arm
    return frozenset(name for name, length in arm.lengths.items() if length > 0) if arm is not None else frozenset()


def _point(checker: ChainChecker, given: Signs, compared: Signs, asked: Signs) -> dict[str, float] | None:
    """Return a configuration that refutes what is asked, for lengths as the document compares them."""
    if given.has_equation:
        return None
    checker.sampled()  # raises where nothing may be drawn
    with checker.exact.budget.paused():
        from armproof.verification.conditions.signed_points import signed_point

    return signed_point(checker, (*given.signs, *compared.signs), asked.signs)


def states_condition(checker: ChainChecker, chain: n.Chain) -> bool:
    """Whether an equation that does not hold everywhere is meant of some configurations or lengths: θ_1 = θ_2, ‖p‖ = l_1.

    One side does not move with the joints, or both are made of joint variables and lengths alone.
    """
    if is_condition(chain):
        return True
    arm, members = checker.names.arm, [checker.member(node) for node in chain.members]
    if arm is None or not all(member.known for member in members):
        return False
    joints = {joint.symbol for joint in arm.joints}
    values = [as_scalar(member.value) for member in members]
    if any(isinstance(value, Scalar) and joints.isdisjoint(symbols_in([value])) for value in values):
        return True
    plain = n.Number | n.Sum | n.Product | n.Quotient | n.Group
    return all(isinstance(b, plain) or checker.members.is_symbol(b) for m in chain.members for b in n.walk(m))


def check_value(checker: ChainChecker, implication: Implication, equation: int) -> Outcome | None:
    """Return whether a formula has a value where a condition f ≠ 0 behind it holds; None where that is no such condition."""
    try:
        divisors = [value for chain in implication.premises for value in _divisors(checker, chain)]
        if not divisors or any(chain.relations != ("≠",) for chain in implication.conclusions):
            return None
        given = read_condition(checker, implication.behind)
        for divisor in divisors:
            if Entailment(checker, given, (System((), ((divisor,),)),)).counterexample() is not None:
                formula = write_bounded(divisor, checker.names.state.notation)
                return Outcome(Verdict.UNCHECKED, (say(Kind.HAS_VALUE_WHERE, divisor=formula),), equation)
    except EvaluationError as problem:
        return Outcome(Verdict.UNCHECKED, (finding_of(problem),), equation)
    return Outcome(Verdict.PROVED, (), equation)


def _divisors(checker: ChainChecker, chain: n.Chain) -> Iterator[Scalar]:
    """Yield what a formula divides by, as far as it moves with the joints: denominators, determinants, cosines."""
    for node in n.walk(chain):
        divisor: n.Node | None = None
        if isinstance(node, n.Quotient):
            divisor = node.denominator
        elif isinstance(node, n.Postfix) and node.operator in ("-1", "-T"):
            divisor = n.Call("det", (node.base,), span=node.span)
        elif n.is_call(node, "tan"):
            divisor = n.Call("cos", node.arguments, span=node.span)
        value = None if divisor is None else as_scalar(Evaluator(checker.names, checker.exact).evaluate(divisor))
        if isinstance(value, Scalar) and value.as_fraction() is None:
            yield value


def _with_its_signs(checker: ChainChecker, implication: Implication, equation: int) -> Judged:
    return with_signs_tied(implication, lambda branches: _follows(checker, implication, equation, branches))


def _unless_signs_before(
    checker: ChainChecker, implication: Implication, outcome: Outcome, links: Sequence[Implication]
) -> Outcome:
    """Leave open θ_2 = ±π/2 ⇒ c_2 = 0 ⇒ det J = ∓l_1 l_2, whose last link holds where the signs before it are forgotten."""
    wider = under_signs_before(implication, links)
    if wider == implication or outcome.verdict is not Verdict.PROVED:
        return outcome
    again, _ = _with_its_signs(checker, wider, outcome.equation)
    return outcome if again.verdict is Verdict.PROVED else outcome.left_open(say(Kind.SIGNS_UNTOLD))


def _follows(checker: ChainChecker, implication: Implication, equation: int, branches: Sequence[int] = ()) -> Judged:
    outcome, point = Outcome(Verdict.PROVED, (), equation), {}
    try:
        before = read_condition(checker, implication.before, branches)
        behind = read_condition(checker, implication.behind, branches)
        for forward in {"⇒": (True,), "⇐": (False,), "⇔": (True, False)}[implication.arrow]:
            entailment = Entailment(checker, before, behind) if forward else Entailment(checker, behind, before)
            try:
                found = entailment.counterexample()
            except EvaluationError as problem:  # the other direction may yet be refuted
                if isinstance(problem, TooComplex) or outcome.verdict is Verdict.PROVED:
                    outcome = _undecided(outcome, problem)
                continue
            if found is not None:
                holds, fails = ("left", "right") if forward else ("right", "left")
                if outcome.verdict is not Verdict.REFUTED:
                    outcome.verdict, point = Verdict.REFUTED, found
                    outcome.findings = (say(Kind.DOES_NOT_FOLLOW, holds=holds, fails=fails),)
                if families := entailment.families(implication.arrow == "⇔"):
                    outcome.also(say(Kind.NOT_COVERED, side=fails, families=families))
    except NoValue as problem:
        outcome.verdict, outcome.findings = Verdict.REFUTED, (finding_of(problem),)
    except EvaluationError as problem:
        outcome = _undecided(outcome, problem)
    return outcome, point


def _undecided(outcome: Outcome, problem: EvaluationError) -> Outcome:
    """What one direction has refuted stays so, whatever becomes of the other."""
    if outcome.verdict is Verdict.REFUTED:
        return outcome
    return replace(outcome, verdict=Verdict.UNCHECKED, findings=(finding_of(problem),))
