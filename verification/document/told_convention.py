"""The convention of a DH table that the text names in words: "by Craig's (modified) convention", "paramètres de Khalil"."""

from __future__ import annotations

import re

MAY_TELL = re.compile(r"craig|modifi|khalil|proximal|classi|standard|distal|spong|paul|original", re.IGNORECASE)
_OF_FRAMES = re.compile(
    r"[ck]onven[tcz]|denavit|\bd-?h\b|\b(?:notations?|param[eè]\w+) (?:of|de|von) (?:craig|khalil)", re.IGNORECASE
)
_MODIFIED = re.compile(r"\b(?:craig|modifi\w+|khalil|proximal)\b", re.IGNORECASE)
_CLASSIC = re.compile(
    r"\b(?:classi(?:c|cal|que|ques|sche\w*|co|ca|cos|cas)|standard|distal|spong|paul|original)\b", re.IGNORECASE
)
_CONTRAST = re.compile(
    r"\b(?:unlike|not|instead|rather|contrary|contrast|others?|both|compar\w+|some|sometimes|differ\w*|contrairement|pas|non|autres?"
    r"|statt|nicht|andere\w*|unterschied|no|otros?|otras?|diferencia|altr[io])\b",
    re.IGNORECASE,
)


def told_convention(text: str) -> str:
    """Return the convention of DH that the sentences of a text name, "" where they name none, both, or one as another's."""
    told = set[str]()
    for sentence in re.split(r"[.;!?](?=\s)|\n\s*\n|\n(?=\s*#)", text):
        if not _OF_FRAMES.search(sentence):
            continue
        named = {name for name, words in (("modified", _MODIFIED), ("classic", _CLASSIC)) if words.search(sentence)}
        told |= named if not _CONTRAST.search(sentence) else {*named, ""}
    return told.pop() if len(told) == 1 else ""
