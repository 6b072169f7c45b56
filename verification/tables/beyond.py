"""DH tables of an arm whose own frames are no DH frames: the pose of the last frame is compared, but for its axes."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.equations.chain import ChainChecker
from armproof.verification.tables.entries import WrongEntries
from armproof.verification.tables.mend import single_mends
from armproof.verification.tables.plant import confirm_tool
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.tool import turned_tool
from armproof.verification.verdict import Record, Verdict


def check_beyond_frames(
    checker: ChainChecker, found: TableReading, wrong: WrongEntries, unchecked: Record, left_open: list[str]
) -> Record:
    """Return the record: proved where the last frame stands still in the arm's, refuted where one change brings it there."""
    reason = f"the frames of arm '{found.arm.name}' are DH frames of neither convention: the rows cannot be checked one by one"
    readings = (found,) if found.claim.columns.stated else (found, found.otherwise)
    for reading in readings:
        if (tool := turned_tool(reading)) is not None:
            place = "" if tool.origin == tool.frame else f", with its origin in that of frame {tool.origin}"
            words = f"the last row's frame moves with frame {tool.frame} for every configuration{place}"
            message = "; ".join([words, reason, *reading.notes])
            proved = replace(unchecked, verdict=Verdict.PROVED, message=message)
            return confirm_tool(reading, tool, proved, checker.sampled()) if checker.confirm else proved
    for reading in readings:
        for verdict, parameter, value in single_mends(reading):
            if (tool := turned_tool(reading.mended(verdict, parameter, value))) is not None:
                fault = wrong.wrong_entry(verdict, parameter, value)
                mended = f"so mended, the last row's frame moves with frame {tool.frame}"
                message = "; ".join([fault.words, mended, reason, *reading.notes])
                return replace(unchecked, verdict=Verdict.REFUTED, message=message, entries=fault.entries)
    said = [reason, "and the last row's frame lies at none of the arm's last frames", *left_open]
    return replace(unchecked, message="; ".join(said))
