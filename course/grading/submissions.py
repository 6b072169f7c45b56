"""The submissions of a class: which notebooks there are, and whose they are."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from unicodedata import normalize

from armproof.course.errors import GradingError
from armproof.course.grading.handed_in import time_of
from armproof.course.grading.text import clean

_NOTEBOOK = ".ipynb"
_OF_MOODLE = re.compile(r"(?P<student>.+?)_(?P<participant>\d+)_assignsubmission_file(_|$)")


@dataclass(frozen=True)
class Submission:
    """One notebook of one student.

    Attributes:
        student: the name of their folder, or of the file where it lies in no folder.
        path: where the notebook is.
        file: its path in the class's folder, as it is shown.
        participant: their number, where Moodle named the folder or file.
        handed_in: when it was handed in.
    """

    student: str
    path: Path
    file: str
    participant: str = ""
    handed_in: datetime | None = None


def find_submissions(folder: Path) -> list[Submission]:
    """Return the notebooks of a class, by student and file; hidden files and Jupyter's checkpoints are none.

    Raises:
        GradingError: there is no such folder, no notebook in it, or one student's name is that of two.
    """
    if not folder.exists():
        raise GradingError("{path}: there is no such folder; armproof grade takes the folder of a class's notebooks",
            path=clean(str(folder)))  # fmt: skip
    if not folder.is_dir():
        raise GradingError("{path}: not a folder; armproof grade takes the folder of a class's notebooks", path=clean(str(folder)))  # fmt: skip
    try:
        paths = sorted(_notebooks(folder))
    except OSError as error:
        raise GradingError("{path}: cannot be read: {reason}", path=clean(str(error.filename)), reason=error.strerror) from None  # fmt: skip
    if not paths:
        raise GradingError("{path}: no notebooks in it; put each student's .ipynb files there, or into a folder of their name",
            path=clean(str(folder)))  # fmt: skip
    found = [_submission(folder, path) for path in paths]
    _check_names(folder, found)
    return sorted(found, key=lambda each: (each.student.casefold(), each.file))


def _notebooks(folder: Path) -> list[Path]:
    """Return the notebooks below a folder; links to folders are not followed."""

    def give_up(error: OSError) -> None:
        raise error

    found = []
    for place, folders, files in os.walk(folder, onerror=give_up):
        folders[:] = [name for name in folders if not name.startswith(".")]
        found += [Path(place) / name for name in files if name.lower().endswith(_NOTEBOOK) and not name.startswith(".")]
    return found


def _submission(folder: Path, path: Path) -> Submission:
    parts = path.relative_to(folder).parts
    student, participant = parts[0] if len(parts) > 1 else path.stem, ""
    if named := _OF_MOODLE.match(student):
        student, participant = named["student"], named["participant"]
    return Submission(clean(normalize("NFC", student)), path, clean("/".join(parts)), participant, time_of(path))


def _check_names(folder: Path, found: list[Submission]) -> None:
    """Refuse two folders or files that are one student's by their name: their results could not be told apart.

    Files that Moodle names belong together by the number of their student.
    """
    places: dict[str, tuple[Submission, Path]] = {}
    for each in found:
        first = folder / each.path.relative_to(folder).parts[0]
        other, place = places.setdefault(each.student.casefold(), (each, first))
        if place != first and not (each.participant and each.participant == other.participant):
            shown = " and ".join(f"'{clean(path.name)}'" for path in (place, first))
            raise GradingError("the student '{name}' is there twice: {shown}; put all of a student's notebooks into one folder, or rename one",
                name=other.student, shown=shown)  # fmt: skip
