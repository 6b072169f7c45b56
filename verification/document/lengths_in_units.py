r"""Lengths that a sentence gives in two units: "$l_1$ is given in feet, $l_2$ in inches"; a formula with both adds what is not alike."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.patterns import regex

_LENGTH = regex(r"[aAdDlLrRhH]_\{?\d\}?")
_SAID = regex(
    r"\$([^$]*)\$|\\\((.*?)\\+\)|(?<!\S)(?:in|en|em) (inch|feet|foot|pieds?|pouce|fuß|zoll|pulgada|pies|piedi|pollic|mm|millim|cm|centim|zentim|m\b|met|mèt)|\d\s*(mm|cm|m)(?!\w)",
    re.IGNORECASE,
)


def lengths_in_two_units(sentence: str) -> Iterator[str]:
    """Yield the letters of lengths in a sentence that gives one of them in another unit than the next: those before each unit."""
    units: dict[str, str] = {}
    waiting: list[str] = []
    for found in _SAID.finditer(sentence):
        if unit := found[3]:
            units |= dict.fromkeys(waiting, unit.lower())
            waiting = []
        elif not found[4] and _LENGTH.fullmatch((found[1] or found[2] or "").strip()):
            waiting.append((found[1] or found[2]).strip())
    if len({*units.values()}) > 1:
        yield from units
