"""Signs to be chosen: what holds for one value of σ = ±1 alone chooses it, and the upper signs of one display belong together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations

from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import HOLDS, Verdict

Again = Callable[[], list[Outcome]]
Holds = Callable[[Outcome], bool]
_OTHER = {"±": "∓", "∓": "±"}


def unless_of_a_sign(names: Names, outcomes: list[Outcome], again: Again) -> list[Outcome]:
    """Leave open what is proved as σ s_2 = s_2 is; s_2 = σ √(1 − c_2²) holds for neither value alone, but on each branch."""
    met = sorted(names.state.signs.read) if _proved(outcomes) else []
    for key in met:
        if _proved_with(names, key, 1, again) != _proved_with(names, key, -1, again):
            doubt = say(Kind.OF_A_SIGN, name=key)
            outcomes = [each.left_open(doubt) if each.verdict is Verdict.PROVED else each for each in outcomes]
    return outcomes


def _proved_with(names: Names, key: str, value: int, again: Again) -> list[int]:
    """Return which equations are proved where a sign is a number."""
    with names.state.unchanged():
        del names.state.signs.values[key]
        names.define(key, lambda algebra: algebra.rational(Fraction(value)))
        return _proved(again())


def _proved(outcomes: list[Outcome]) -> list[int]:
    return [each.equation for each in outcomes if each.verdict is Verdict.PROVED]


def unless_signs_clash(outcomes: Sequence[Outcome], holds: Holds) -> list[Outcome]:
    """Leave open two equations of a display with ± that hold together only where one of them has ∓ instead."""
    found = list(outcomes)
    signed = [k for k, each in enumerate(outcomes) if each.verdict in HOLDS and _is_signed(each)]
    for one, other in combinations(signed, 2):
        first, second = outcomes[one], outcomes[other]
        if not holds(_together(first, second)) and holds(_together(first, _turned(second))):
            for k in (one, other):
                found[k] = outcomes[k].left_open(say(Kind.SIGNS_CLASH))
    return found


def clashes_with(outcome: Outcome, chain: n.Chain, holds: Holds) -> bool:
    """Whether an equation with ± holds together with another one only where one of them has ∓ instead."""
    if len(chain.members) != 2 or not any(map(n.has_branches, chain.members)) or not _is_signed(outcome):
        return False
    assert outcome.true is not None and outcome.printed is not None
    true, printed = (replace(side, node=node) for side, node in zip((outcome.true, outcome.printed), chain.members, strict=True))  # fmt: skip
    other = replace(outcome, true=true, printed=printed)
    return not holds(_together(outcome, other)) and holds(_together(outcome, _turned(other)))


def _is_signed(outcome: Outcome) -> bool:
    """Whether ± stands in an equation of two scalars."""
    return len(outcome.sides) == 2 and not outcome.matrices and any(map(n.has_branches, outcome.nodes))


def _together(*outcomes: Outcome) -> Outcome:
    """Return several equations as one of columns, which holds on one choice of its signs."""
    first = outcomes[0]
    assert first.true is not None and first.printed is not None
    trues, printed = (n.Matrix(tuple((each.nodes[k],) for each in outcomes)) for k in (0, 1))
    return replace(first, true=replace(first.true, node=trues), printed=replace(first.printed, node=printed), pair=None)


def _turned(outcome: Outcome) -> Outcome:
    """Return an equation with ∓ for ±."""
    assert outcome.true is not None and outcome.printed is not None
    return replace(
        outcome,
        true=replace(outcome.true, node=_with_other_signs(outcome.true.node)),
        printed=replace(outcome.printed, node=_with_other_signs(outcome.printed.node)),
    )


def _with_other_signs(node: n.Node) -> n.Node:
    changed = n.substitute_each(node, {id(child): _with_other_signs(child) for child in n.children(node)})
    if not isinstance(changed, n.Sum):
        return changed
    return replace(changed, terms=tuple((_OTHER.get(sign, sign), term) for sign, term in changed.terms))
