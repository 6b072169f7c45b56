"""Whether an equation holds under conditions, or nobody can tell."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.conditions.implication import Implication
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict


def holds_where(checker: ChainChecker, conditions: Sequence[n.Chain], claim: n.Chain) -> bool:
    """Whether a claim holds under conditions, or nobody can tell."""
    with checker.exact.budget.paused():  # few documents need it: the import is none of its time
        from armproof.verification.conditions.judgement import check_implication

    implication = Implication("⇒", [[*conditions]], [[claim]])
    return check_implication(checker, implication, 1)[0].verdict is not Verdict.REFUTED
