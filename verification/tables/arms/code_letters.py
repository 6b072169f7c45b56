"""The letters of a table in code as its document writes them: \\theta_1 of q1, l_1 of L1."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.document import Document, Table
from armproof.verification.patterns import regex

_LETTER = regex(r"(?<![A-Za-z])(\\?[A-Za-z]+)_\{(\d+)\}")
_JOINTS = {"\\theta": "q", "q": "\\theta", "d": "q"}


def in_letters_of(document: Document, table: Table) -> Table:
    """Return a table with the other spelling of each letter that the document writes so alone."""

    def spelt(found: re.Match[str]) -> str:
        letter, index = found.groups()
        others = (letter.swapcase(), _JOINTS.get(letter, letter))
        written = [each for each in (letter, *others) if document.writes(f"{each.lstrip(chr(92))}_{index}")]
        return f"{(written or [letter])[0]}_{{{index}}}"

    rows = tuple(tuple(_LETTER.sub(spelt, cell) for cell in row) for row in table.rows)
    return replace(table, rows=rows)
