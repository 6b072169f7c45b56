"""How far a student has come, kept in a file of theirs so that it outlives the kernel."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from pathlib import Path

from armproof.course.feedback.outcome import Feedback, Outcome
from armproof.verification.running.atomic import write_atomically

VARIABLE = "ARMPROOF_PROGRESS"  # another file; empty: none
_NAMES = {outcome.value for outcome in Outcome}


def progress_file() -> Path | None:
    """Return the file in which progress is kept; None where none is wanted."""
    named = os.environ.get(VARIABLE)
    if named is not None:
        return Path(named) if named else None
    with suppress(RuntimeError):
        return Path.home() / ".armproof" / "progress.json"
    return None


def read_progress(lesson: str) -> dict[str, Outcome]:
    """Return the last outcome of each task of a lesson; nothing where the file is missing or no such file."""
    kept = _read_kept().get(lesson)
    if not isinstance(kept, dict):
        return {}
    return {str(task): Outcome(value) for task, value in kept.items() if isinstance(value, str) and value in _NAMES}


def reached(before: Outcome | None, now: Outcome) -> Outcome:
    """Return how far a task is solved: what was right once stays so, whatever is tried after it."""
    return before if before is not None and before.is_right and not now.is_right else now


def keep_progress(feedback: Feedback) -> None:
    """Keep the outcome of a task; a right answer is not forgotten for a wrong one after it."""
    file = progress_file()
    if file is None or feedback.outcome is Outcome.NOT_ATTEMPTED:
        return
    before = read_progress(feedback.lesson).get(feedback.task)
    if reached(before, feedback.outcome) is before:
        return
    kept = _read_kept()
    lesson = kept.get(feedback.lesson)
    kept[feedback.lesson] = {**(lesson if isinstance(lesson, dict) else {}), feedback.task: feedback.outcome.value}
    with suppress(OSError):  # a home that cannot be written loses the progress, not the lesson
        file.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(file, (json.dumps(kept, indent=1, sort_keys=True) + "\n").encode())


def _read_kept() -> dict[str, object]:
    file = progress_file()
    if file is None:
        return {}
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return kept if isinstance(kept, dict) else {}
