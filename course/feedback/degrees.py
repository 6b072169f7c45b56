"""Numbers of degrees within the sines and cosines of a formula, which take radians: cos(θ_2 - 90)."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.course.feedback.claim import Claim
from armproof.course.feedback.outcome import ASKED
from armproof.course.feedback.relation import Letters, same
from armproof.course.feedback.worked import IN_RADIANS
from armproof.models.language import look_up
from armproof.verification.diagnosis.slips import is_trigonometric
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_STEP = 15  # degrees, of which an angle that is meant in degrees is a multiple


def degrees_astray(claim: Claim, latex: str, at: Letters) -> str:
    """Say that an angle in degrees is taken as radians, where a formula is what is asked once it is not; empty where it is not."""
    spans = sorted({number.span for number in _degrees_in(claim.read(latex))}, reverse=True)
    mended = latex
    for start, end in spans:
        mended = rf"{mended[:start]}\frac{{{mended[start:end]} \pi}}{{180}}{mended[end:]}"
    if not spans or not same(claim.values_over(mended, at), claim.values_over(ASKED, at)):
        return ""
    return look_up(IN_RADIANS)


def _degrees_in(tree: n.Node) -> Iterator[n.Number]:
    """Yield the numbers that stand alone, or beside a letter, in the argument of a sine or cosine and may be degrees."""
    for call in n.walk(tree):
        if not is_trigonometric(call):
            continue
        argument = bare(call.arguments[0])
        terms = [bare(term) for _, term in argument.terms] if isinstance(argument, n.Sum) else [argument]
        yield from (
            term
            for term in terms
            if isinstance(term, n.Number) and term.value and not term.value % _STEP and term.value >= _STEP
        )
