"""Postures of an arm in words, "when the arm is stretched out": what stands behind them may hold there alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.model import INLINE, Display

_PLACE = r"(?:configuration|position|posture|pose)"
_ARM = r"(?:arm|links?|segments?|bras|manipulator|robot)"
_LIES = r"(?:straight|vertical(?:e|es)?|verticaux|horizontal(?:e|es)?|horizontaux|aligned|collinear|upright|alignés?|colinéaires)"
_POSTURE = re.compile(
    rf"\b(?:(?:out)?stretched|(?:fully|completely|entirely) (?:extended|folded|retracted)|full extension|folded|"
    rf"(?:zero|home|rest|initial|reference|singular|upright|vertical|horizontal) {_PLACE}|at the origin|straight {_ARM}|"
    rf"{_ARM}(?: (?:is|are|being|est|sont|étant))? {_LIES}|tendue?s?|en extension|repliée?s?|dépliée?s?|à l['’]origine|"
    rf"{_PLACE} (?:zéro|nulle|initiale|singulière|de repos|de référence|verticale|horizontale))\b",
    re.IGNORECASE,
)


def postures(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield the words of a text that name a posture, each as what stands in the text between displays."""
    for found in _POSTURE.finditer(" ".join(text.split())):
        yield Display(line, rf"\text{{{found.group()}}}", section=section, opening=INLINE)
