"""DH tables of an arm whose own frames are no DH frames: the pose of the last frame is compared, but for its axes."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.equations.chain import ChainChecker
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.tables.entries import WrongEntries
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.tool import turned_tool
from armproof.verification.verdict import Record, Verdict


def check_beyond_frames(
    checker: ChainChecker, found: TableReading, wrong: WrongEntries, unchecked: Record, left_open: list[Finding]
) -> Record:
    """Return the record: proved where the last frame stands still in the arm's, refuted where one change brings it there."""
    reason = say(Kind.NO_DH_FRAMES, arm=found.arm.name)
    readings = (found,) if found.claim.columns.stated else (found, found.otherwise)
    for reading in readings:
        if (tool := turned_tool(reading)) is not None:
            kind = Kind.MOVES_WITH if tool.origin == tool.frame else Kind.MOVES_WITH_BUT_AT
            moves = say(kind, frame=tool.frame, origin=tool.origin)
            proved = replace(unchecked, verdict=Verdict.PROVED, findings=(moves, reason, *reading.notes))
            if not checker.confirm:
                return proved
            sampled = checker.sampled()
            with checker.exact.budget.paused():
                from armproof.verification.tables.plant import confirm_tool

            return confirm_tool(reading, tool, proved, sampled)
    checker.sampled()  # raises where none may be taken
    with checker.exact.budget.paused():
        from armproof.verification.tables.mend import single_mends

    for reading in readings:
        for verdict, parameter, value in single_mends(reading):
            if (tool := turned_tool(reading.mended(verdict, parameter, value))) is not None:
                fault = wrong.wrong_entry(verdict, parameter, value)
                said = (fault.finding, say(Kind.SO_MENDED, frame=tool.frame), reason, *reading.notes)
                return replace(unchecked, verdict=Verdict.REFUTED, findings=said, entries=fault.entries)
    return replace(unchecked, findings=(reason, say(Kind.AT_NO_LAST_FRAME), *left_open))
