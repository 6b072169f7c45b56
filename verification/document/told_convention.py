"""The convention of a DH table or of a link matrix that the text names in words: "by Craig's (modified) convention", "paramètres de Khalil"."""

from __future__ import annotations

import re
from collections.abc import Iterator

CONVENTION = "convention"  # of the link matrices of a section
MAY_TELL = re.compile(r"craig|modifi|khalil|proximal|classi|standard|distal|spong|paul|original", re.IGNORECASE)
_OF_FRAMES = re.compile(
    r"[ck]onven[tcz]|denavit|\bd-?h\b|\b(?:notations?|param[eè]\w+|that|those|celles?|jene|der|die|la|las|el|quella|quelle) (?:of|de|von|di) (?:craig|khalil|spong|paul)"
    r"|\blink (?:matrix|matrices|transform\w*)|\bmatrices? de passage|\bgliedmatri\w+",
    re.IGNORECASE,
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


_CODE = re.compile(
    r"\bdef \w+\(|^\s*[\w, ]+ = |^[%#\s]*---\s*$|\b(?:dh|convention|link): *\w+", re.MULTILINE
)  # or front matter


def told_convention(text: str) -> str:
    """Return the convention of DH that the sentences of a text name, "" where they name none, both, or one as another's."""
    told = set[str]()
    for sentence in re.split(r"[.;!?](?=\s)|\n\s*\n|\n(?=\s*#)", text):
        if not _OF_FRAMES.search(sentence):
            continue
        named = {name for name, words in (("modified", _MODIFIED), ("classic", _CLASSIC)) if words.search(sentence)}
        told |= named if not _CONTRAST.search(sentence) else {*named, ""}
    return told.pop() if len(told) == 1 else ""


def conventions_below(sentence: str) -> Iterator[str]:
    """Yield the convention that a sentence or a heading names, as what holds of the displays in its section."""
    if not _CODE.search(sentence) and (told := told_convention(sentence)):
        yield f"{CONVENTION} {told}\n{' '.join(sentence.split())}"
