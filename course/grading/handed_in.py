"""When a submission was handed in, and how late that is."""

from __future__ import annotations

from contextlib import suppress
from datetime import UTC, date, datetime, time, timedelta
from pathlib import Path
from zoneinfo import ZoneInfo

from armproof.course.errors import GradingError
from armproof.models.errors import counted
from armproof.models.language import look_up

_STAMP = "timestamp.txt"  # beside the notebook, where nbgrader collected it
_HOUR, _DAY = timedelta(hours=1), timedelta(days=1)


def time_of(path: Path) -> datetime:
    """Return when a notebook was handed in: what nbgrader noted beside it, else when the file was last changed."""
    stamp = path.parent / _STAMP
    if stamp.is_file():
        with suppress(OSError, ValueError, KeyError):  # one that says no time
            return _read_stamp(stamp.read_text(encoding="utf-8"))
    return datetime.fromtimestamp(int(path.lstat().st_mtime), UTC)


def _read_stamp(text: str) -> datetime:
    """Return the time in words such as 2026-11-20 15:58:23.948203 Europe/Paris."""
    day, clock, *zone = text.split()
    read = datetime.fromisoformat(f"{day} {clock}")
    return read if read.tzinfo else read.replace(tzinfo=ZoneInfo(zone[0] if zone else "UTC"))


def read_due(text: str) -> datetime:
    """Return until when submissions are in time; a day alone is meant to its end, a time without a zone is local.

    Raises:
        GradingError: it says no time.
    """
    try:
        if len(text) == len("2026-11-20"):
            return datetime.combine(date.fromisoformat(text), time(23, 59, 59)).astimezone()
        read = datetime.fromisoformat(text)
    except ValueError:
        raise GradingError("'{text}' is no date; write 2026-11-20, 2026-11-20T18:00 or 2026-11-20T18:00+01:00", text=text) from None  # fmt: skip
    return read if read.tzinfo else read.astimezone()


def lateness(handed_in: datetime | None, due: datetime | None) -> timedelta:
    """Return how much later than due it was handed in; nothing where it is in time, or nothing is due."""
    return max(handed_in - due, timedelta()) if handed_in is not None and due is not None else timedelta()


def in_words(late: timedelta) -> str:
    """Return how late something is: in days, else hours, else minutes, begun ones counted; empty where it is not."""
    if not late:
        return ""
    if late > _DAY:
        return counted("late by {number} day", "late by {number} days", -(-late // _DAY))
    if late > _HOUR:
        return counted("late by {number} hour", "late by {number} hours", -(-late // _HOUR))
    return look_up("late by less than an hour")
