"""The corrected LaTeX of a refuted display: what is wrong replaced where it stands, everything else as it was."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from armproof.verification.latex.unicode import original_offset
from armproof.verification.verdict import Correction, Record, WrongEntry

ELLIPSIS = r"\ldots"  # stands for what is too long to be written: no correction


@dataclass(frozen=True)
class Corrected:
    """A display as it should be; `spans` are the places of the corrections in it, from left to right."""

    latex: str
    spans: tuple[tuple[int, int], ...]


def edits(record: Record) -> tuple[Correction, ...]:
    """Return the corrections that mend a refuted display, from left to right, at places of `record.latex`.

    Those that were sought and verified with the document (`check_document(..., correct=True)`); else those that the wrong
    entries tell. Empty where nothing is wrong, or where an entry has no place of its own (the entry of a product) or no
    correction that could be written in full: a display is corrected as a whole or not at all.
    """
    if record.corrections is not None:
        return record.corrections
    if not record.entries or not all(_is_usable(entry) for entry in record.entries):
        return ()
    found = sorted({correction_of(record.latex, entry) for entry in record.entries}, key=lambda c: (c.start, c.end))
    return () if any(left.end > right.start for left, right in pairwise(found)) else tuple(found)


def corrected(record: Record) -> Corrected | None:
    """Return a refuted display as it should be, or None where `edits` knows no way."""
    changes = edits(record)
    if not changes:
        return None
    spans, grown = [], 0
    for change in changes:
        start = change.start + grown
        spans.append((start, start + len(change.text)))
        grown += len(change.text) - (change.end - change.start)
    return Corrected(applied(record.latex, changes), tuple(spans))


def corrected_latex(record: Record) -> str | None:
    """Return the LaTeX of a refuted display as it should be, or None where `edits` knows no way."""
    found = corrected(record)
    return None if found is None else found.latex


def applied(latex: str, corrections: Sequence[Correction]) -> str:
    """Return LaTeX with its corrections made, which come from left to right; raises ValueError where they overlap."""
    text, position = "", 0
    for correction in corrections:
        if correction.start < position:
            raise ValueError("two corrections overlap")
        text += latex[position : correction.start] + correction.text
        position = correction.end
    return text + latex[position:]


def _is_usable(entry: WrongEntry) -> bool:
    return entry.span is not None and bool(entry.correct) and ELLIPSIS not in entry.correct


def correction_of(latex: str, entry: WrongEntry) -> Correction:
    """Place an entry in the LaTeX as the author wrote it: spans count in its form without Unicode signs."""
    assert entry.span is not None
    start, end = (original_offset(latex, offset) for offset in entry.span)
    while end > start and latex[end - 1].isspace():
        end -= 1
    while start < end and latex[start].isspace():
        start += 1
    return Correction(start, end, entry.correct)
