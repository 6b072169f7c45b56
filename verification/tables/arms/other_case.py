"""Lengths that a document writes large in its formulas and small in its matrices: L_2 for l_2."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.document import Document
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate

_LENGTH = regex(r"\b([lL])_(\d+)\b")


def in_other_case(candidate: Candidate, document: Document) -> Candidate | None:
    """Return an arm whose l_2 is called L_2 as well, or the other way round; None where it is not, or where L_2 may be something else.

    Something else it may be where the document says what it is, or where both stand in one display.
    """
    entries = " ".join(row[column] for row in candidate.rows for column in ("a", "d"))
    own = set(_LENGTH.findall(entries))
    letters = {letter for letter, _ in own}
    if len(letters) != 1:
        return None
    [letter] = letters
    other = letter.swapcase()
    named = {f"{other}_{digit}": f"{letter}_{digit}" for _, digit in sorted(own) if document.writes(f"{other}_{digit}")}
    if not named or any(_is_apart(name, key, document) for name, key in named.items()):
        return None
    return replace(candidate, symbols={**candidate.symbols, **named})


def _is_apart(name: str, key: str, document: Document) -> bool:
    """Whether a document says what a name is, or writes it beside the other one."""
    one, other = (_written(each) for each in (name, key))
    texts = [text for each in document.displays for text in (*each.said, each.latex)]
    alone = rf"(?:^|[,;&=]|\\\\|quad)\s*{one.pattern}\s*"
    said = re.compile(rf"{alone}&?\s*(?::?=|\\approx|≈)|=\s*&?\s*{one.pattern}\s*(?:$|[,;&]|\\\\|\\q?quad)")
    return any(said.search(text) or (one.search(text) and other.search(text)) for text in texts)


def _written(name: str) -> re.Pattern[str]:
    letter, _, digits = name.partition("_")
    return re.compile(rf"(?<![A-Za-z]){letter}\s*_\s*\{{?\s*{digits}(?!\d)\s*\}}?")
