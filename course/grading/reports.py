"""Read what a run reported: it is data from a process that a student controls, of which only what is well-formed is taken."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

from armproof.course.grading.results import CellError, Picture
from armproof.course.grading.text import clean, clean_lines
from armproof.models.errors import written
from armproof.models.language import look_up, noted

SKIPPED = (noted("skipped"), noted("skipped, and set to None"))  # what a note begins with
_MOST = 200  # errors and notes that are kept
NOT_ATTEMPTED = "not attempted"
MISTAKEN = ("wrong", "in letters, please")
OUTCOMES = ("correct (proved)", "correct (confirmed)", *reversed(MISTAKEN), NOT_ATTEMPTED, "error")
MOST_MISTAKES = 20  # of one task in one notebook
LONGEST_ANSWER = 4000  # characters
_LARGEST_PICTURE = 100_000


@dataclass(frozen=True)
class Reported:
    """What the checks of one task found; see `results.TaskResult`."""

    outcome: str = NOT_ATTEMPTED
    message: str = ""
    answer: str = ""
    attempts: int = 0
    mistakes: tuple[str, ...] = ()
    picture: Picture | None = None


@dataclass
class Report:
    """What a run reported.

    Attributes:
        cell: the last cell that was begun.
        done: whether all cells were run.
        memory: whether memory ran out in one of them.
        errors, notes: what cells raised, and what was skipped.
        results: by lesson and task.
        changed: functions of ours that were changed meanwhile.
        refused: how many reports were not well-formed.
    """

    cell: int = 0
    done: bool = False
    memory: bool = False
    errors: list[CellError] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    results: dict[tuple[str, str], Reported] = field(default_factory=dict)
    changed: list[str] = field(default_factory=list)
    refused: int = 0


def read_report(lines: Iterable[str], catalogue: Sequence[dict[str, Any]]) -> Report:
    """Return the report in a run's lines; a lesson, task or outcome that there is not is refused."""
    known = {(lesson["name"], task["name"]) for lesson in catalogue for task in lesson["tasks"]}
    report = Report()
    for line in lines:
        try:
            entry = json.loads(line)
            _take(report, entry if isinstance(entry, dict) else {}, known)
        except (ValueError, TypeError, KeyError, RecursionError):
            report.refused += 1
    return report


def _take(report: Report, entry: dict[str, Any], known: set[tuple[str, str]]) -> None:
    if "cell" in entry:
        report.cell = _number(entry["cell"])
    elif "note" in entry and len(report.notes) < _MOST:
        report.notes.append(_note(entry))
    elif "error" in entry and len(report.errors) < _MOST:
        error = entry["error"]
        place = _number(error["cell"]), _number(error["line"])
        report.errors.append(CellError(*place, _text(error["type"], 80), _text(error["message"])))
        report.memory |= error["memory"] is True
    elif "results" in entry:
        for result in entry["results"]:
            _take_result(report, result, known)
    elif "done" in entry:
        report.done = entry["done"] is True
        report.changed = [_text(name, 120) for name in entry["changed"]][:_MOST]


def _note(entry: dict[str, Any]) -> str:
    kind, colon, what = _text(entry["note"]).partition(": ")
    note = written("{kind}: {what}", kind=look_up(kind), what=what) if colon else kind
    return written("cell {cell}: {note}", cell=_number(entry["in"]), note=note)


def _take_result(report: Report, result: dict[str, Any], known: set[tuple[str, str]]) -> None:
    key = result["lesson"], result["task"]
    if key not in known or result["outcome"] not in OUTCOMES:
        report.refused += 1
        return
    report.results[key] = Reported(
        result["outcome"],
        _text(result["message"]),
        clean_lines(result["answer"], LONGEST_ANSWER),
        _number(result["attempts"]),
        tuple(_text(mistake) for mistake in result["mistakes"][:MOST_MISTAKES]),
        _picture(result["picture"]),
    )


def _picture(drawn: Any) -> Picture | None:
    """Return what is drawn, which a page shows as an image: nothing in it is run, and it asks for nothing."""
    if drawn is None:
        return None
    if not drawn["svg"].startswith("<svg ") or len(drawn["svg"]) > _LARGEST_PICTURE:
        raise ValueError
    return Picture(drawn["svg"], _text(drawn["caption"]))


def _number(value: Any) -> int:
    if not isinstance(value, int) or not 0 <= value < 1_000_000:
        raise ValueError
    return value


def _text(value: Any, longest: int = 500) -> str:
    if not isinstance(value, str):
        raise TypeError
    return clean(value, longest)
