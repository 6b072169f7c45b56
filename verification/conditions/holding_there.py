"""Whether an equation holds under conditions, or nobody can tell."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from math import prod

from armproof.verification.algebra.calculus import is_rate, substitute, symbols_in
from armproof.verification.conditions.implication import Implication
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import WhereDefined
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

MOST_POSTURES = 16


def holds_where(checker: ChainChecker, conditions: Sequence[n.Chain], claim: n.Chain) -> bool:
    """Whether a claim holds under conditions, or nobody can tell."""
    with checker.exact.budget.paused():  # few documents need it: the import is none of its time
        from armproof.verification.conditions.judgement import check_implication

    implication = Implication("⇒", [[*conditions]], [[claim]])
    return check_implication(checker, implication, 1)[0].verdict is not Verdict.REFUTED


def fails_at_values(checker: ChainChecker, given: Sequence[Mapping[str, n.Node] | None], outcome: Outcome) -> bool:
    """Whether the sides of an equation differ where all that is given are values of joints and lengths, the joints moving on or at rest."""
    values = {name: checker.member(node).value for each in given for name, node in (each or {}).items()}
    known = {*checker.names.joints, *checker.names.lengths}
    if outcome.pair is None or not values or not all(given) or not {*values} <= known:
        return False
    true, printed = outcome.pair.true.cells, outcome.pair.printed.cells
    nought = checker.exact.ring.zero
    at_rest = {
        each: nought for each in symbols_in([*true, *printed]) if is_rate(each) and each.rpartition(" ")[2] in values
    }
    with WhereDefined():
        for rates in ({}, at_rest):
            sides = [[substitute(each, {**values, **rates}).normal() for each in side] for side in (true, printed)]
            tells = not rates or any(not each.is_zero() for each in sides[0])  # where all joints rest, nothing moves
            if tells and all((a - b).is_zero() for a, b in zip(*sides, strict=True)):
                return False
        return True
    return False


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
