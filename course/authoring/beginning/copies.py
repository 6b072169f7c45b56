"""A lesson begun by a student: its notebook, copied into a folder of theirs and never over what is there."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path

from armproof.course.authoring.checking.building import student_files
from armproof.course.errors import AuthoringError
from armproof.course.sources.places import COURSE
from armproof.models.language import ENGLISH
from armproof.verification.running.atomic import write_atomically

_SEED = re.compile(r"[\w][\w .-]{0,59}")
_FORMULA = re.compile(r"\$[^$\\]+ = [\d.]+\$")  # of a length: $a_1 = 0.3$


def begin(names: Sequence[str], folder: Path, lang: str = ENGLISH, seed: str = "") -> tuple[list[Path], list[Path]]:
    """Copy the notebooks of lessons into a folder; return those that are new, and those that were there and stay as they are.

    Args:
        seed: gives their tasks numbers of their own, in the text as well.

    Raises:
        AuthoringError: no such lesson or seed, the folder is the course's own, or nothing can be written there.
    """
    if seed and not _SEED.fullmatch(seed):
        raise AuthoringError("'{seed:.40}' is no seed: a name or a number, of letters, digits, blanks, dots and hyphens", seed=seed)  # fmt: skip
    if COURSE.root in [folder.resolve(), *folder.resolve().parents]:
        raise AuthoringError("{folder}: the course itself is here; work in a folder of your own, --into DIR", folder=folder)  # fmt: skip
    files = student_files(COURSE, COURSE.named(names), lang)
    new: list[Path] = []
    kept: list[Path] = []
    for notebook, data in files.items():
        path = folder / notebook.name
        data = _with_numbers(data, notebook.stem.partition("_")[2], lang, seed) if seed else data
        (new if _create(path, data) else kept).append(path)
    return new, kept


def _with_numbers(data: bytes, name: str, lang: str, seed: str) -> bytes:
    """Return a notebook that opens its lesson with a seed, and whose text has the numbers of that seed."""
    from armproof.course.feedback import open_lesson

    text = data.decode("utf-8").replace(f'open_lesson(\\"{name}\\"', f'open_lesson(\\"{name}\\", seed=\\"{seed}\\"')
    usual, own = (open_lesson(name, lang=lang, seed=each).tasks for each in ("", seed))
    for task, other in zip(usual, own, strict=True):
        if other.numbers:
            for old, new in zip(_FORMULA.findall(task.text), _FORMULA.findall(other.text), strict=True):
                text = text.replace(old, new)
        for old, new in other.printed.items():
            text = text.replace(json.dumps(old)[1:-1], json.dumps(new)[1:-1])
    return text.encode("utf-8")


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
