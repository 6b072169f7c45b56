"""What a page is made of: the cells of a lesson as the student gets them, with their solutions, and what running them in a kernel gave."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from armproof.course.errors import SiteError
from armproof.course.sources.editions import student_cells
from armproof.course.sources.kernel import Fault, run_cells
from armproof.course.sources.lesson_source import LessonSource
from armproof.course.sources.places import COURSE, Place
from armproof.verification.document.cells import Cell as SourceCell

Output = Mapping[str, Any]  # as a notebook holds it

_CALL = re.compile(r"(?<![\w.])lesson\.(\w+)\.(check|show|move|hint|solution)\(")
_CONFIG = "c.InlineBackend.figure_formats = {'svg'}\nc.HistoryManager.enabled = False\n"
_LONGEST = 300  # characters of what was raised


@dataclass(frozen=True)
class Cell:
    """A cell of a lesson.

    Attributes:
        kind: markdown, code or raw.
        source: what the student gets.
        solved: the solved source; the same where the cell holds no solution.
        number: its place among the cells of the lesson, from 0.
        line: the line of the file on which it begins.
        outputs: what running it gave.
    """

    kind: str
    source: str
    solved: str
    number: int
    line: int = 1
    outputs: tuple[Output, ...] = ()

    @property
    def has_solution(self) -> bool:
        """Whether the student is to fill something in."""
        return self.source != self.solved

    def calls(self, name: str) -> tuple[str, ...]:
        """Return the names of the tasks whose check, show, move, hint or solution the cell calls."""
        return tuple(dict.fromkeys(task for task, call in _CALL.findall(self.source) if call == name))

    def opens(self) -> bool:
        """Whether the cell opens the lesson."""
        return self.kind == "code" and "open_lesson(" in self.source


def cells_of(source: LessonSource) -> tuple[Cell, ...]:
    """Return the cells of a lesson, not executed."""
    triples = zip(source.cells, student_cells(source), range(len(source.cells)), strict=True)
    return tuple(Cell(cell.kind, student.source, cell.source, k, cell.line) for cell, student, k in triples)


def with_outputs(cells: Sequence[Cell], outputs: Mapping[int, Sequence[Output]]) -> tuple[Cell, ...]:
    """Return the cells with what running them gave, by their places."""
    return tuple(replace(cell, outputs=tuple(outputs.get(cell.number, ()))) for cell in cells)


def execute(source: LessonSource, place: Place = COURSE, *, solved: bool = False) -> tuple[Cell, ...]:
    """Return the cells of a lesson with what running them gave, in a fresh kernel and an empty folder.

    Args:
        source: the lesson.
        place: where it and its tasks are.
        solved: whether the solved source is run rather than what the student gets.

    Raises:
        SiteError: a cell raises an exception or takes too long: the lesson, the cell, the line and the exception.
    """
    cells = cells_of(source)
    notebook = [SourceCell(cell.kind, cell.solved if solved else cell.source) for cell in cells]
    with tempfile.TemporaryDirectory(prefix="armproof-site-") as folder:
        run = run_cells(source.name, notebook, place, _settings(Path(folder)))
    if run.fault is not None:
        raise SiteError(_describe(source, cells, run.fault, solved))
    return with_outputs(cells, dict(enumerate(run.outputs)))


def _describe(source: LessonSource, cells: tuple[Cell, ...], fault: Fault, solved: bool) -> str:
    """Return "file:line: cell 7, line 3, does not run: ZeroDivisionError: division by zero"."""
    cell = cells[min(fault.cell, len(cells) - 1)]
    line = fault.line or 1
    at = cell.line + line - 1 if solved or not cell.has_solution else cell.line
    what = (fault.message.splitlines() or ["it failed"])[0][:_LONGEST]
    return f"{source.path}:{at}: cell {cell.number}, line {line}, does not run: {what}"


def _settings(folder: Path) -> dict[str, str]:
    """Return what makes the same lesson give the same page: figures as SVG, without a date and with ids that repeat."""
    profile = folder / "ipython" / "profile_default"
    profile.mkdir(parents=True)
    (profile / "ipython_kernel_config.py").write_text(_CONFIG, encoding="ascii")
    (folder / "matplotlibrc").write_text("svg.hashsalt: armproof\n", encoding="ascii")
    return {
        "IPYTHONDIR": str(folder / "ipython"),
        "MATPLOTLIBRC": str(folder),
        "SOURCE_DATE_EPOCH": "0",
        "PYTHONHASHSEED": "0",
    }
