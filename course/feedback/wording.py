"""What a student is told of a wrong formula: the findings of the proof that do not give the right term away."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.verdict import WrongEntry

ASKED = r"\Xi"  # the name that what is asked has in a claim; no course uses it
MOST_PLACES = 4
GENERAL = (Kind.UNEQUAL, Kind.ONLY_WRONG_ENTRY)  # what is said where no mistake is recognised


def told(findings: Sequence[Finding], entries: Sequence[WrongEntry]) -> tuple[Finding, ...]:
    """Return what is wrong, without the right term and without our proof's own concerns; else where it is wrong."""
    if said := [finding for finding in findings if finding.is_told]:
        return without_asked(said)
    places = [(entry.row, entry.column) for entry in entries]
    if not places or places == [(None, None)]:
        return (say(Kind.UNEQUAL),)
    if len(places) == 1:
        return (say(Kind.ONLY_WRONG_ENTRY).at(row=places[0][0], column=places[0][1]),)
    if len(places) <= MOST_PLACES:
        return (say(Kind.FEW_WRONG_ENTRIES, places=[place(row, column) for row, column in places]),)
    return (say(Kind.WRONG_ENTRIES, count=len(places)),)


def place(row: int | None, column: int | None) -> str:
    """Return an entry's place (from 1) as the student reads it."""
    return "value" if row is None or column is None else f"({row}, {column})"


def without_asked(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return findings without the name that a claim gives to what is asked."""
    return tuple(finding.renamed(ASKED, "what is asked").renamed("Xi", "what is asked") for finding in findings)
