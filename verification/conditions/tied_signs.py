"""Signs that belong together: θ_2 = ±π/2 ⇒ det J = ±l_1 l_2 is said of the upper signs, and of the lower ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from armproof.verification.conditions.implication import Implication, is_signed
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

Judged = tuple[Outcome, dict[str, float]]
_WORST_FIRST = (Verdict.REFUTED, Verdict.UNCHECKED, Verdict.PROVED)


def with_signs_tied(implication: Implication, judge: Callable[[Sequence[int]], Judged]) -> Judged:
    """Return what becomes of an implication, judged for signs that are chosen freely and for those that all have together.

    With ∓ in it the signs belong together; with ± alone they may not, c_2 = ±√(1 − s_2²) ⇔ s_2 = ±√(1 − c_2²): what then
    comes out in one of the two ways alone is left open.
    """
    freely = judge(())
    if len(signed := [chain for chain in implication.chains if is_signed(chain)]) < 2:
        return freely
    is_of_both = all(any(map(is_signed, side)) for side in (implication.premises, implication.conclusions))
    chosen: tuple[Sequence[int], ...] = ((1,), (-1,)) if is_of_both else ((1, -1),)
    tied = min(map(judge, chosen), key=lambda judged: _WORST_FIRST.index(judged[0].verdict))
    if tied[0].verdict is freely[0].verdict:
        return freely
    if any(map(_turns, signed)):
        if tied[0].verdict is Verdict.REFUTED:
            tied[0].also(say(Kind.SIGNS_TOGETHER))
        return tied
    if Verdict.UNCHECKED in (verdicts := (freely[0].verdict, tied[0].verdict)):
        return (freely, tied)[verdicts.index(Verdict.UNCHECKED)]
    return freely[0].left_open(say(Kind.SIGNS_UNTOLD)), {}


def _turns(chain: n.Chain) -> bool:
    return any(sign == "∓" for below in n.walk(chain) if isinstance(below, n.Sum) for sign, _ in below.terms)


def under_signs_before(implication: Implication, links: Sequence[Implication]) -> Implication:
    """Return the last link of A ⇒ B ⇒ C under the premises before it whose signs those of its conclusion belong to."""
    before = [chain for link in links for chain in link.premises if is_signed(chain)]
    if implication.arrow != "⇒" or not any(map(is_signed, implication.conclusions)):
        return implication
    return replace(implication, before=[[*before, *chains] for chains in implication.before])


def with_signed(chain: n.Chain, conclusions: Sequence[n.Chain]) -> list[n.Chain]:
    """Return a further conclusion together with those before it whose signs its own belong to: c_2 = 0 ⇒ s_2 = ±1, det J = ±l_1 l_2."""
    return [*filter(is_signed, conclusions), chain] if is_signed(chain) else [chain]
