"""Relations other than equality: sizes, and what is never equal, decided exactly; inequalities on samples."""

from __future__ import annotations

from typing import Any

from armproof.verification.algebra.matrix import Matrix, as_scalar, is_zero
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict


def check_relation(checker: ChainChecker, chain: n.Chain, equation: int) -> Outcome:
    """Return the verdict of a chain with ≤, <, ≠, ≈, ∈: sizes and inequalities on samples, conditions as definitions."""
    relation = next(r for r in chain.relations if r != "=")
    left, right = chain.members[0], chain.members[-1]
    outcome = Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)
    if relation == "∈":
        size = _size_of_space(right)
        member = checker.member(left)
        if size is None or not member.known or not isinstance(member.value, Matrix):
            return outcome
        if member.value.shape == size:
            outcome.verdict, outcome.findings = Verdict.PROVED, (say(Kind.IN_SPACE),)
        else:
            other = say(Kind.NOT_IN_SPACE, size=member.value.size, space=f"{size[0]}×{size[1]}")
            outcome.verdict, outcome.findings = Verdict.REFUTED, (other,)
        return outcome
    members = [checker.member(node) for node in chain.members]
    if relation == "≠":
        if all(m.known for m in members) and _identical(members[0].value, members[-1].value):
            outcome.verdict, outcome.findings = Verdict.REFUTED, (say(Kind.ALWAYS_EQUAL),)
        return outcome
    if isinstance(left, n.Name) or isinstance(right, n.Name):
        return outcome  # a bound on a variable: a condition
    if relation not in ("≤", "<", "≥", ">", "≈"):
        return outcome
    sampled = checker.sampled()
    with checker.exact.budget.paused():
        from armproof.verification.equations.sampled_relations import check_approximation, check_inequality

    check = check_approximation if relation == "≈" else check_inequality
    return check(checker, chain, outcome, sampled.samples)


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
