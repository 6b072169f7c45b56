"""The convention of a DH table or of a link matrix that the text names in words: "by Craig's (modified) convention", "paramètres de Khalil"."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.patterns import regex

CONVENTION = "convention"  # of the link matrices of a section
MAY_TELL = regex(r"craig|modifi|khalil|proximal|classi|standard|distal|spong|paul|original", re.IGNORECASE)
_OF_FRAMES = regex(
    r"[ck]onven[tcz]|denavit|\bd-?h\b|\b(?:notations?|param[eè]\w+|that|those|celles?|jene|der|die|la|las|el|quella|quelle) (?:of|de|von|di) (?:craig|khalil|spong|paul)"
    r"|\b(?:notations?|fram(?:es|ing)|tables?|tabell\w+|tableau|tabla|tabella|tabela|param[eèé]\w+|parámetros|parametri|parâmetros)\b[^.;!?]{0,60}?‹"
    r"|\blink (?:matrix|matrices|transform\w*)|\bmatrices? de passage|\bgliedmatri\w+",
    re.IGNORECASE,
)
_MODIFIED = regex(r"\b(?:craig|modifi\w+|khalil|proximal)\b", re.IGNORECASE)
_CLASSIC = regex(
    r"\b(?:classi(?:c|cal|que|ques|sche\w*|co|ca|cos|cas)|standard|distal|spong|paul|original)\b", re.IGNORECASE
)
_AUTHOR = regex(r"\b(?:craig|khalil|spong|paul)\b", re.IGNORECASE)
_CONTRAST = regex(
    r"\b(?:unlike|not|instead|rather|contrary|contrast|others?|both|compar\w+|some|sometimes|differ\w*|contrairement|pas|non|autres?"
    r"|statt|nicht|andere\w*|unterschied|no|otros?|otras?|diferencia|altr[io])\b",
    re.IGNORECASE,
)


_CODE = regex(
    r"\bdef \w+\(|^\s*[\w, ]+ = |^[%#\s]*---\s*$|\b(?:dh|convention|link): *\w+", re.MULTILINE
)  # or front matter


_CITED = regex(  # [1], \cite{craig05}, and not a link [1](…), nor the entry of a list of references itself
    r"(?<!\n)(?<!^)\[(?P<label>\^?[\w+-]{1,12})\](?![(:\[])|\\cite\w*\s*(?:\[[^\]]*\]\s*)*\{(?P<key>[\w:.+-]+)\}"
)
_ENTRY = regex(
    r"^[ \t]*(?:[-*+][ \t]+)?(?:\[(?P<label>\^?[\w+-]{1,12})\]:?|\\bibitem\s*(?:\[[^\]]*\]\s*)?\{(?P<key>[\w:.+-]+)\})(?P<entry>.+(?:\n(?!\s*\n|[ \t]*(?:[-*+]|\[|\\bibitem)).+)*)",
    re.MULTILINE,
)


def _with_authors(text: str) -> str:
    """Return a text in which the citation of a book whose author has a convention of his own is that author: "those of the book [1]"."""
    entries = {found["label"] or found["key"]: found["entry"] for found in _ENTRY.finditer(text)}
    authors = {label: found.group() for label, entry in entries.items() if (found := _AUTHOR.search(entry)) is not None}
    if not authors:
        return text

    def author(found: re.Match[str]) -> str:
        named = authors.get(found["label"] or found["key"])
        return found.group() if named is None else f" ‹{named}›"

    return _CITED.sub(author, text)


def told_convention(text: str) -> str:
    """Return the convention of DH that the sentences of a text name, "" where they name none, both, or one as another's."""
    told = set[str]()
    text = _with_authors(text)
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
