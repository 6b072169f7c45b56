"""Statements that are not identities: implications, equations at singular configurations, inequalities, sizes."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np

from verification.compare import align
from verification.equation import ChainChecker
from verification.errors import EvaluationError, NoValue
from verification.evaluate import Evaluator
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.outcome import Outcome
from verification.scalar import Scalar
from verification.trees import has_branches
from verification.values import as_scalar, is_zero
from verification.verdict import Verdict

HIGHEST_POWER = 4


class Undecided(EvaluationError):
    """Neither a proof nor a counterexample was found."""


def vanishing(checker: ChainChecker, statements: Iterable[n.Chain]) -> Scalar:
    """Return a scalar that vanishes exactly where one of the equations holds.

    f = g gives f − g; an angle θ = α gives 1 − cos(θ − α); θ ∈ {α, β} and alternatives multiply.
    """
    product: Scalar | None = None
    for chain in statements:
        for factor in _factors(checker, chain):
            product = factor if product is None else product * factor
    if product is None:
        raise Undecided("no equation stands where a condition is expected")
    return product


def _factors(checker: ChainChecker, chain: n.Chain) -> list[Scalar]:
    """The factors of a condition; one with ± holds on either branch."""
    branches = (1, -1) if has_branches(chain) else (1,)
    return [
        factor
        for branch in branches
        for factor in _factors_of(checker, chain, Evaluator(checker.names, checker.exact, branch))
    ]


def _factors_of(checker: ChainChecker, chain: n.Chain, evaluator: Evaluator) -> list[Scalar]:
    if len(chain.members) == 1:  # "θ_2 = 0 or π": the angle is that of the alternative before
        raise Undecided("a condition is an equation")
    if chain.relations == ("∈",) and isinstance(chain.members[1], n.Sequence):
        left = chain.members[0]
        return [
            _factor(checker, left, evaluator.scalar(left), evaluator.scalar(item)) for item in chain.members[1].items
        ]
    if set(chain.relations) != {"="}:
        raise Undecided(f"'{' '.join(chain.relations)}' is not an equation")
    *first, last = chain.members
    if len(first) != 1:
        raise Undecided("a chain stands where one condition is expected")
    multiple = _integer_multiple_of_pi(last)
    if multiple is not None:
        _, sine = checker.exact.cos_sin(evaluator.scalar(first[0]) / checker.exact.rational(multiple))
        return [sine]
    left, right = as_scalar(evaluator.evaluate(first[0])), as_scalar(evaluator.evaluate(last))
    if not (isinstance(left, Scalar) and isinstance(right, Scalar)):
        raise Undecided("a matrix stands where a scalar condition is expected")
    return [_factor(checker, first[0], left, right)]


def _integer_multiple_of_pi(node: n.Node) -> Fraction | None:
    """kπ with k any integer: a product of the letter k (or n) and π."""
    if isinstance(node, n.Product) and len(node.factors) == 2:
        a, b = node.factors
        if isinstance(a, n.Name) and a.key in ("k", "n", "m") and isinstance(b, n.Name) and b.key == "pi":
            return Fraction(1)
    return None


def _factor(checker: ChainChecker, node: n.Node, left: Scalar, right: Scalar) -> Scalar:
    arm = checker.names.arm
    revolute = {joint.symbol for joint in arm.joints if joint.kind == "revolute"} if arm is not None else set()
    bare = isinstance(node, n.Name) and checker.names.known_symbol(node.key) in revolute
    if bare or checker.exact.ring.has_arcs(left):
        return 1 - checker.exact.cos_sin(left - right)[0]
    return left - right


def implies(checker: ChainChecker, f: Scalar, g: Scalar) -> bool:
    """Decide f = 0 ⟹ g = 0 by divisibility: a power of g is a multiple of f, lengths taken as nonzero."""
    if g.is_zero():
        return True
    power = checker.exact.ring.one
    for _ in range(HIGHEST_POWER):
        power = power * g
        if not f.is_zero() and _never_zero(checker, checker.exact.ring.without_sines_below(power / f).denominator):
            return True
    return False


def _never_zero(checker: ChainChecker, denominator: Any) -> bool:
    """Whether a polynomial is a constant times lengths and rates: nonzero for every arm of the family."""
    terms = list(checker.exact.ring.terms(denominator))
    if len(terms) != 1:
        return False
    arm = checker.names.arm
    lengths = set(arm.lengths) if arm is not None else set()
    return all(
        kind == "sqrt" or (kind == "symbol" and (name in lengths or (arm is None and _reads_as_length(name))))
        for kind, name in terms[0][0]
    )


def _reads_as_length(name: str) -> bool:
    """Whether a letter of a document with no arm is a link's length: l, l_1, a_2, d_i."""
    return name[:1] in ("l", "L") or name[:2] in ("a_", "d_")


def counterexample(checker: ChainChecker, f: Scalar, g: Scalar) -> dict[str, float] | None:
    """Return a configuration of quarter turns at which f = 0 and g ≠ 0, exactly; None where none is found."""
    arm = checker.names.arm
    if arm is None:
        return None
    ring = checker.exact.ring
    symbols = [joint for joint in arm.joints if any(_mentions(ring, value, joint.symbol) for value in (f, g))][:4]
    quarters = [Fraction(k, 2) for k in (0, 2, 1, -1)]
    pi = checker.exact.pi()
    for choice in itertools.product(quarters, repeat=len(symbols)):
        values = {
            joint.symbol: pi * ring.rational(turn) if joint.kind == "revolute" else ring.rational(turn)
            for joint, turn in zip(symbols, choice, strict=True)
        }
        if ring.substitute(f, values).is_zero() and not ring.substitute(g, values).is_zero():
            scale = {joint.symbol: np.pi if joint.kind == "revolute" else 1.0 for joint in symbols}
            return {
                joint.symbol: float(turn) * scale[joint.symbol] for joint, turn in zip(symbols, choice, strict=True)
            }
    return None


def _mentions(ring: Any, value: Scalar, symbol: str) -> bool:
    return any(
        name == symbol
        for part in (value.numerator, value.denominator)
        for powers, _ in ring.terms(part)
        for _, name in powers
    )


def is_condition(chain: n.Chain) -> bool:
    """Whether an equation before an arrow reads as a condition (det J = 0) and not as a step of a derivation."""
    return any(relation == "∈" for relation in chain.relations) or any(
        all(
            isinstance(b, n.Number | n.Sum | n.Product | n.Quotient | n.Group)
            or (isinstance(b, n.Name) and b.key in ("pi", "k"))
            for b in n.walk(m)
        )
        for m in chain.members
    )


def _entries_of(checker: ChainChecker, chains: list[n.Chain]) -> list[Scalar] | None:
    """Return the differences of the entries of one equation between matrices; None where it is none."""
    if len(chains) != 1 or chains[0].relations != ("=",):
        return None
    left, right = (checker.member(node) for node in chains[0].members)
    if not (isinstance(left.value, Matrix) or isinstance(right.value, Matrix)) or not (left.known and right.known):
        return None
    pair = next(align(left.value, right.value, checker.exact))
    return [
        a - b
        for row, other in zip(pair.true.rows, pair.printed.rows, strict=True)
        for a, b in zip(row, other, strict=True)
    ]


def check_implication(
    checker: ChainChecker, kind: str, premises: list[n.Chain], conclusions: list[n.Chain], equation: int
) -> tuple[Outcome, dict[str, float]]:
    """Return the verdict of premises ⇒ (⇔, ⇐) conclusions, alternatives on either side joined by "or"."""
    outcome = Outcome(Verdict.PROVED, "", equation)
    try:
        entries = _entries_of(checker, conclusions) if kind in ("⇒", "⇐") else None
        if entries is not None and kind == "⇒":  # a matrix equation: each of its entries follows
            f = vanishing(checker, premises)
            g = next((entry for entry in entries if not implies(checker, f, entry)), checker.exact.ring.zero)
        elif (entries := _entries_of(checker, premises) if kind == "⇐" else None) is not None:
            g = vanishing(checker, conclusions)
            f = next((entry for entry in entries if not implies(checker, g, entry)), checker.exact.ring.zero)
        else:
            f, g = vanishing(checker, premises), vanishing(checker, conclusions)
        wanted = {"⇒": [(f, g)], "⇐": [(g, f)], "⇔": [(f, g), (g, f)]}[kind]
        for premise, conclusion in wanted:
            if implies(checker, premise, conclusion):
                continue
            found = counterexample(checker, premise, conclusion)
            side = (
                "the left side holds and the right does not"
                if premise is f
                else "the right side holds and the left does not"
            )
            if found is None:
                outcome.verdict, outcome.message = Verdict.UNCHECKED, f"not decided whether {side} somewhere"
                return outcome, {}
            outcome.verdict, outcome.message = Verdict.REFUTED, f"{side} at the configuration given"
            return outcome, found
    except NoValue as problem:
        outcome.verdict, outcome.message = Verdict.REFUTED, str(problem)
    except EvaluationError as problem:
        outcome.verdict, outcome.message = Verdict.UNCHECKED, str(problem)
    return outcome, {}


def check_relation(checker: ChainChecker, chain: n.Chain, equation: int) -> Outcome:
    """Return the verdict of a chain with ≤, <, ≠, ≈, ∈: sizes and inequalities on samples, conditions as definitions."""
    relation = next(r for r in chain.relations if r != "=")
    left, right = chain.members[0], chain.members[-1]
    outcome = Outcome(Verdict.DEFINED, "a condition, not a claim", equation)
    if relation == "∈":
        size = _size_of_space(right)
        member = checker.member(left)
        if size is None or not member.known or not isinstance(member.value, Matrix):
            return outcome
        if member.value.shape == size:
            outcome.verdict, outcome.message = Verdict.PROVED, "the size"
        else:
            wanted = f"{member.value.size}, not {size[0]}×{size[1]}"
            outcome.verdict, outcome.message = Verdict.REFUTED, f"the matrix is {wanted}"
        return outcome
    members = [checker.member(node) for node in chain.members]
    if relation == "≠":
        if all(m.known for m in members) and _identical(members[0].value, members[-1].value):
            outcome.verdict, outcome.message = Verdict.REFUTED, "the two sides are equal for every configuration"
        return outcome
    if isinstance(left, n.Name) or isinstance(right, n.Name):
        return outcome  # a bound on a variable: a condition
    if relation in ("≤", "<", "≥", ">"):
        return _sampled_inequality(checker, chain, outcome)
    if relation == "≈":
        return _sampled_approximation(checker, chain, outcome)
    return outcome


def _identical(a: Any, b: Any) -> bool:
    a, b = as_scalar(a), as_scalar(b)
    if isinstance(a, Matrix) and isinstance(b, Matrix):
        return a.shape == b.shape and all(
            is_zero(x - y) for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True)
        )
    if isinstance(a, Scalar) and isinstance(b, Scalar):
        return (a - b).is_zero()
    if isinstance(a, Matrix) and isinstance(b, Scalar):
        return b.is_zero() and all(is_zero(x) for row in a.rows for x in row)
    return False


def _size_of_space(node: n.Node) -> tuple[int, int] | None:
    """ℝ^{6×4} → (6, 4); ℝ^3 → (3, 1)."""
    if not (isinstance(node, n.Power) and isinstance(node.base, n.Name) and node.base.base == "R"):
        return None
    exponent = node.exponent
    if isinstance(exponent, n.Number):
        return int(exponent.value), 1
    if isinstance(exponent, n.Product) and exponent.operators == ("×",):
        sizes = [int(f.value) for f in exponent.factors if isinstance(f, n.Number)]
        return (sizes[0], sizes[1]) if len(sizes) == 2 else None
    return None


def _sampled_inequality(checker: ChainChecker, chain: n.Chain, outcome: Outcome) -> Outcome:
    holds = {"≤": lambda a, b: a <= b + 1e-9, "<": lambda a, b: a < b + 1e-9, "≥": lambda a, b: a >= b - 1e-9,
             ">": lambda a, b: a > b - 1e-9, "=": lambda a, b: np.abs(a - b) < 1e-9}  # fmt: skip
    try:
        with np.errstate(all="ignore"):
            values = [as_scalar(checker.sampled_value(node)) for node in chain.members]
            if any(isinstance(value, Matrix | list) for value in values):
                return outcome
            good = np.ones(checker.sampled().samples, dtype=bool)
            for relation, a, b in zip(chain.relations, values, values[1:], strict=False):
                good &= holds[relation](a, b) | ~np.isfinite(a) | ~np.isfinite(b)
    except (EvaluationError, KeyError):
        return outcome
    outcome.samples = int(good.size)
    if good.all():
        outcome.verdict, outcome.message = Verdict.CONFIRMED, "an inequality holds at every sample"
    else:
        outcome.verdict, outcome.message = Verdict.REFUTED, "the inequality fails at some configurations"
    return outcome


def _sampled_approximation(checker: ChainChecker, chain: n.Chain, outcome: Outcome) -> Outcome:
    try:
        with np.errstate(all="ignore"):
            first, *others = [as_scalar(checker.sampled_value(node)) for node in chain.members]
            if not all(isinstance(value, np.ndarray) for value in (first, *others)):
                return outcome
            close = all(np.allclose(first, other, rtol=1e-2, atol=1e-3) for other in others)
    except EvaluationError:
        return outcome
    outcome.samples = checker.sampled().samples
    outcome.verdict = Verdict.CONFIRMED if close else Verdict.REFUTED
    outcome.message = "an approximation, to about a hundredth"
    return outcome
