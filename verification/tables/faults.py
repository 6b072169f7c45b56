"""What is wrong with a DH table as a whole: its headers, its columns or its frames."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import combinations

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex.greek import GREEK
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.row import PARAMETERS
from armproof.verification.tables.tool import same_tool
from armproof.verification.verdict import WrongEntry


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong, and the wrong entries (a wrong header has no row and column).

    `is_all`: there is nothing else wrong with the entries.
    """

    finding: Finding
    entries: tuple[WrongEntry, ...] = ()
    is_all: bool = False


def fault_of_table(found: TableReading) -> Fault | None:
    """Return the one thing that is wrong with the table as a whole, or None."""
    return _other_frames(found) or _other_convention(found) or _swapped_headers(found) or _shifted(found)


def letter(found: TableReading, parameter: str) -> str:
    """Return the letter of a parameter's column."""
    role = found.claim.columns.headers[found.reading.columns[parameter]].role
    return GREEK.get(role, role)


def _other_frames(found: TableReading) -> Fault | None:
    """The table gives the pose of the last frame rightly, by other frames than the arm's."""
    for reading in [found] if found.convention == found.claim.columns.stated else [found, found.otherwise]:
        first = next((v.row for v in reading.verdicts if v.row.frames is not None and not v.holds), None)
        if first is not None and (frame := same_tool(reading)) is not None:
            pose = f"{{}}^{found.arm.frames[0]}T_{frame}"
            return Fault(say(Kind.OTHER_FRAMES, pose=pose, number=first.number, convention=reading.convention))
    return None


def _other_convention(found: TableReading) -> Fault | None:
    """The headers state the other convention."""
    stated, convention = found.claim.columns.stated, found.convention
    if not stated or stated == convention:
        return None
    headers = [found.claim.columns.headers[k].text for k in (found.reading.a, found.reading.alpha)]
    entries = tuple(_wrong_header(text, _with_index(text, convention)) for text in headers)
    kind = Kind.HEADERS_OF_OTHER_CONVENTION if found.is_right else Kind.FRAMES_OF_OTHER_CONVENTION
    return Fault(say(kind, convention=convention, stated=stated), entries)


def _swapped_headers(found: TableReading) -> Fault | None:
    if len(found.wrong) < 2:
        return None
    columns, headers = found.reading.columns, found.claim.columns.headers
    for one, other in combinations(PARAMETERS, 2):
        if not found.but(**{one: columns[other], other: columns[one]}).is_right:
            continue
        texts = headers[columns[one]].text, headers[columns[other]].text
        entries = (_wrong_header(*texts), _wrong_header(*reversed(texts)))
        swapped = say(Kind.HEADERS_SWAPPED, one=letter(found, one), other=letter(found, other))
        return Fault(swapped, entries, is_all=True)
    return None


def _shifted(found: TableReading) -> Fault | None:
    """Rows of a and α that stand one row too low or too high, as in the other convention."""
    verdicts = found.verdicts
    if len(found.wrong) < 2 or any(v.right is None or v.problems for v in verdicts):
        return None
    if {parameter for v in verdicts for parameter in v.wrong} - {"a", "alpha"}:
        return None
    for printed, right, words in ((verdicts[1:], verdicts[:-1], "low"), (verdicts[:-1], verdicts[1:], "high")):
        if all(
            r.right is not None and r.right.agrees(parameter, v.values[parameter])
            for v, r in zip(printed, right, strict=True)
            for parameter in ("a", "alpha")
        ):
            other = found.otherwise.convention
            return Fault(say(Kind.ROWS_SHIFTED, direction=words, convention=other))
    return None


def _wrong_header(printed: str, correct: str) -> WrongEntry:
    return WrongEntry(1, None, None, printed, correct, say(Kind.THE_HEADER))


def _with_index(header: str, convention: str) -> str:
    """Return a header with the index of the convention: a_{i-1} for a_i and back."""
    if convention == "classic":
        return re.sub(r"_\s*\{?\s*([ijkn])\s*[-−]\s*1\s*\}?", r"_\1", header)
    return re.sub(r"_\s*\{?\s*([ijkn])\s*\}?", r"_{\1-1}", header)
