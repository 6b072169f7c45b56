"""Run the cells of a lesson in a kernel of its own, and keep what they gave."""

from __future__ import annotations

import tempfile
from pathlib import Path

from armproof.course.errors import SiteError
from armproof.course.site.cells import Cell, cells_of, with_outputs
from armproof.course.sources.kernel import Fault, run_cells
from armproof.course.sources.lesson_source import LessonSource
from armproof.course.sources.places import COURSE, Place
from armproof.verification.document.cells import Cell as SourceCell

_CONFIG = "c.InlineBackend.figure_formats = {'svg'}\nc.HistoryManager.enabled = False\n"
_LONGEST = 300  # characters of what was raised


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
