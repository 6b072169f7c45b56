"""A lesson begun by a student: its notebook, copied into a folder of theirs and never over what is there."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from armproof.course.authoring.checking.building import student_files
from armproof.course.errors import AuthoringError
from armproof.course.sources.places import COURSE
from armproof.models.language import ENGLISH
from armproof.verification.running.atomic import write_atomically


def begin(names: Sequence[str], folder: Path, lang: str = ENGLISH) -> tuple[list[Path], list[Path]]:
    """Copy the notebooks of lessons into a folder; return those that are new, and those that were there and stay as they are.

    Raises:
        AuthoringError: no such lesson, the folder is the course's own, or nothing can be written there.
    """
    if COURSE.root in [folder.resolve(), *folder.resolve().parents]:
        raise AuthoringError("{folder}: the course itself is here; work in a folder of your own, --into DIR", folder=folder)  # fmt: skip
    files = student_files(COURSE, COURSE.named(names), lang)
    new: list[Path] = []
    kept: list[Path] = []
    for notebook, data in files.items():
        path = folder / notebook.name
        (new if _create(path, data) else kept).append(path)
    return new, kept


def _create(path: Path, data: bytes) -> bool:
    """Write a new file, whole or not at all; False where there is one that is not empty."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            path.open("xb").close()  # takes the name: nobody's file of that name is written over
        except FileExistsError:
            if path.stat().st_size:
                return False
        write_atomically(path, data)
    except OSError as error:
        raise AuthoringError("{path}: cannot be written: {reason}", path=path, reason=error.strerror) from None
    return True
