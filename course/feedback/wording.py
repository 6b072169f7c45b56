"""What a student is told of a wrong formula: the finding of the proof without the right term, and without its own concerns."""

from __future__ import annotations

import re
from collections.abc import Sequence

from armproof.verification.verdict import WrongEntry

ASKED = r"\Xi"  # the name that what is asked has in a claim; no course uses it
_TELLING = re.compile(r"^(?:entry \(\d+, \d+\): )?is .*, should be .*$", re.DOTALL)
# What concerns our proof and not the student's answer, or half a sentence whose other half gives the answer away.
_OURS_ALONE = re.compile(r"not exact|too large to tell|the two sides|square root|arc function|lengths of this arm")
_OURS = re.compile(rf"should be|at the configuration given before|{_OURS_ALONE.pattern}")
MOST_PLACES = 4
UNEQUAL = "the formula is not equal to what is asked"


def sentence(message: str, entries: Sequence[WrongEntry]) -> str:
    """Return what is wrong in words, without giving the right term away."""
    if not entries and message and not _OURS_ALONE.search(message):
        return without_asked(message)
    told = [part for part in message.split("; ") if not _TELLING.match(part) and not _OURS.search(part)]
    if told and (told[0] or len(told) > 1):
        return without_asked("; ".join(told))
    places = [place(entry.row, entry.column) for entry in entries]
    if not places or places == ["value"]:
        return UNEQUAL
    if len(places) == 1:
        return f"entry {places[0]} is wrong, the others are right"
    if len(places) <= MOST_PLACES:
        return f"the entries {', '.join(places)} are wrong"
    return f"{len(places)} entries are wrong"


def place(row: int | None, column: int | None) -> str:
    """Return an entry's place (from 1) as the student reads it."""
    return "value" if row is None or column is None else f"({row}, {column})"


def without_asked(message: str) -> str:
    """Return a message without the name that a claim gives to what is asked."""
    return message.replace(ASKED, "what is asked").replace("Xi", "what is asked")
