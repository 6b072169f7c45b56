"""Whether an equation holds under conditions, or nobody can tell."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import product
from math import prod

from armproof.verification.conditions.implication import Implication
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

MOST_POSTURES = 16


def holds_where(checker: ChainChecker, conditions: Sequence[n.Chain], claim: n.Chain) -> bool:
    """Whether a claim holds under conditions, or nobody can tell."""
    with checker.exact.budget.paused():  # few documents need it: the import is none of its time
        from armproof.verification.conditions.judgement import check_implication

    implication = Implication("⇒", [[*conditions]], [[claim]])
    return check_implication(checker, implication, 1)[0].verdict is not Verdict.REFUTED


def postures_of(conditions: Sequence[n.Chain]) -> Iterator[tuple[n.Chain, ...]]:
    """Yield the conditions for each of several values that one name has: "θ_2 = 0 or θ_2 = π" are two postures, and no contradiction."""
    values: defaultdict[str, list[n.Chain]] = defaultdict(list)
    for condition in conditions:
        name = condition.members[0]
        if condition.relations == ("=",) and isinstance(name, n.Name):
            values[name.key].append(condition)
        else:
            values[str(len(values))].append(condition)
    if prod(map(len, values.values())) > MOST_POSTURES:
        yield tuple(conditions)
    else:
        yield from product(*values.values())
