"""Text that students wrote, cut and without what does something to a terminal, a table or a page."""

from __future__ import annotations

import re

_CONTROLS = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
_FORMULA = ("=", "+", "-", "@", "\t")


def clean(text: str, longest: int = 500) -> str:
    """Return a text on one line, at most so long, without control characters and what is no Unicode."""
    return re.sub(r"\s+", " ", clean_lines(text, longest)).strip()


def clean_lines(text: str, longest: int) -> str:
    """Return a text at most so long, without control characters and what is no Unicode; its lines stay."""
    cut = text if len(text) <= longest else f"{text[:longest]}…"
    return _CONTROLS.sub("�", cut.replace("\r\n", "\n"))


def as_cell(text: str) -> str:
    """Return a text as a table's cell that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(_FORMULA) else text
