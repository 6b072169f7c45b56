"""Read a student's notebook: its code cells, and what says which lesson it is. Nothing in it is run or trusted."""

from __future__ import annotations

import json
import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from armproof.course.grading.sandbox.limits import MEGABYTE
from armproof.verification.document.cells import notebook_cells

_LARGEST = 20 * MEGABYTE
_OPENED = re.compile(r"open_lesson\(\s*[\"'](\w+)[\"']")
_SEEDED = re.compile(r"open_lesson\(\s*[\"'](\w+)[\"'][^)]*?\bseed\s*=\s*[\"']?([^\"',)]{1,80})")
_SOLUTIONS = re.compile(r"\.solution\(|\.right\b")
_TITLE = re.compile(r"^title:\s*[\"']?(.+?)[\"']?\s*$", re.MULTILINE)


class UnreadableError(Exception):
    """A file is no notebook; the message says why, in a sentence without its name."""


@dataclass(frozen=True)
class Notebook:
    """What is read of a notebook.

    Attributes:
        cells: the sources of its code cells.
        lessons: the names of the lessons that they open.
        seeded: the same with a seed, `name=seed`, of those that are opened with one.
        title: that of its front matter.
        asks_solutions: whether a cell asks for the solutions that come with the tasks.
    """

    cells: tuple[str, ...]
    lessons: tuple[str, ...] = ()
    title: str = ""
    asks_solutions: bool = False
    seeded: tuple[str, ...] = ()


def read_notebook(path: Path) -> Notebook:
    """Read a notebook; raises UnreadableError."""
    try:
        cells = notebook_cells(_read_text(path))
    except json.JSONDecodeError as error:
        raise UnreadableError(f"line {error.lineno} is not JSON, which a notebook is: {error.msg}") from None
    except ValueError as error:
        raise UnreadableError(f"it is no notebook: {error}") from None
    code = tuple(cell.text for cell in cells if cell.kind == "code")
    opened = dict.fromkeys(name for source in code for name in _OPENED.findall(source))
    title = _title([cell.text for cell in cells if cell.kind in ("raw", "markdown")])
    seeded = dict.fromkeys(f"{name}={quote(seed.strip())}" for source in code for name, seed in _SEEDED.findall(source))
    return Notebook(code, tuple(opened), title, any(_SOLUTIONS.search(source) for source in code), tuple(seeded))


def _read_text(path: Path) -> str:
    """Return the text of a regular file: a link could lead to another student's work, a pipe might never end."""
    if path.is_symlink():
        raise UnreadableError("it is a link to another file; a copy of the notebook is needed")
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError as error:
        raise UnreadableError(f"it cannot be read: {error.strerror}") from None
    with open(handle, "rb") as file:
        state = os.fstat(handle)
        if not stat.S_ISREG(state.st_mode):
            raise UnreadableError("it is not a file")
        if state.st_size > _LARGEST:
            size, most = state.st_size // MEGABYTE, _LARGEST // MEGABYTE
            raise UnreadableError(f"it has {size} MB; at most {most} MB are read (without outputs a notebook is small)")
        try:
            return file.read(_LARGEST).decode("utf-8-sig")
        except UnicodeDecodeError:
            raise UnreadableError("it is not text in UTF-8, which a notebook is") from None


def _title(cells: list[str]) -> str:
    for source in cells:
        if source.lstrip().startswith("---") and (found := _TITLE.search(source[:10_000])):
            return found[1]
    return ""
