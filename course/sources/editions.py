"""The editions of a lesson: the student's notebook and the instructor's."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from armproof.course.sources.lesson_source import LessonSource
from armproof.course.sources.notebook import as_bytes, as_notebook
from armproof.course.sources.solutions import without_solutions
from armproof.verification.document.cells import Cell

FOLDED = {"jupyter": {"source_hidden": True}}  # JupyterLab shows the front matter as a bar


def student_notebook(lesson: LessonSource) -> bytes:
    """Return what a student opens: no solutions, no outputs."""
    return as_bytes(as_notebook(lesson.name, student_cells(lesson)))


def instructor_notebook(lesson: LessonSource) -> bytes:
    """Return the edition with solutions, between their markers; no outputs."""
    return as_bytes(as_notebook(lesson.name, solved_cells(lesson)))


def solved_cells(lesson: LessonSource) -> Iterator[Cell]:
    """Yield the cells of the source as they are."""
    yield from map(_written, lesson.cells)


def student_cells(lesson: LessonSource) -> Iterator[Cell]:
    """Yield the cells of the student's notebook, one for each of the source."""
    needed = lesson.needed
    for index, cell in enumerate(lesson.cells):
        blocks = lesson.blocks.get(index, ())
        yield _written(replace(cell, text=without_solutions(cell, blocks, needed)) if blocks else cell)


def _written(cell: Cell) -> Cell:
    return replace(cell, metadata=metadata_of(cell))


def metadata_of(cell: Cell) -> Mapping[str, Any]:
    """Return a cell's metadata: its own, and the front matter folded."""
    return {**FOLDED, **cell.metadata} if cell.kind == "raw" else dict(cell.metadata)
