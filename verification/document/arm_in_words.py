"""The planar arms that a text names in words: "a planar two-link arm", "un robot 3R plan", "a 2-DOF planar manipulator"."""

from __future__ import annotations

import re

from armproof.verification.patterns import regex

_COUNTS = {
    2: "2|two|deux|dos|zwei|due|dois",
    3: "3|three|trois|tres|drei|tre|três",
    4: "4|four|quatre|cuatro|vier|quattro|quatro",
}
MAY_NAME = regex(r"\bplan(?!ar_)|[ -]link\b", re.IGNORECASE)  # what no text lacks that names one
_PLANAR = regex(r"\bplan(?:ar|aire|e|o|a|ares|arer|aren|ari)?\b|\b(?:two|2|three|3)[ -]link\b")
_ARM = regex(
    r"\b(?:robot(?:ic|ique|s)?|arm|manipulator|manipulateur|manipulador|bras|brazo|braccio|braço|mechanism|linkage)\b"
)
_PARTS = (
    r"(?:links?|segments?|(?:revolute |rotary )?joints?|dof|ddl|gdl|r|eslabones|liaisons rotoïdes|rotations|articulations"
    r"|articulaciones|bielles|elos|bracci)"
)
_PARTS_OF = {n: regex(rf"(?<![\w.])(?:{words})[ -]?{_PARTS}\b|\br{{{n}}}\b") for n, words in _COUNTS.items()}
_MARKS = regex(r"[*_`$]|\\\w+")
_STOP = regex(r"[.;:!?](?:\s|$)|\n\s*\n|\n\s*#")


def planar_arms(text: str) -> frozenset[int]:
    """Return of how many joints the planar arms are that the sentences of a text name."""
    sentences = (" ".join(each.split()) for each in _STOP.split(_MARKS.sub(" ", text.lower())))
    named = [each for each in sentences if _PLANAR.search(each) and _ARM.search(each)]
    return frozenset(number for number, parts in _PARTS_OF.items() if any(map(parts.search, named)))
