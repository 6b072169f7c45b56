"""The editions of a lesson, the student's notebook and the instructor's: the same cells give the same bytes, on every machine."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from armproof.course.sources.lesson_source import LessonSource
from armproof.course.sources.solutions import without_solutions
from armproof.verification.document.cells import Cell

KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
FOLDED = {"jupyter": {"source_hidden": True}}  # JupyterLab shows the front matter as a bar


def as_notebook(name: str, cells: Iterable[Cell]) -> dict[str, Any]:
    """Return cells as a notebook of format 4.5, without outputs; each cell's id is a digest of the name and its position."""
    return {
        "cells": [_as_json(cell, cell_id(name, position)) for position, cell in enumerate(cells)],
        "metadata": {"kernelspec": dict(KERNEL), "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def as_bytes(notebook: Mapping[str, Any]) -> bytes:
    """Return a notebook as Jupyter would write it: sorted keys, an indent of 1, a newline at the end."""
    return (json.dumps(notebook, ensure_ascii=False, indent=1, sort_keys=True) + "\n").encode("utf-8")


def cell_id(name: str, position: int) -> str:
    """Return the id of a lesson's cell."""
    return hashlib.sha256(f"{name}/{position}".encode()).hexdigest()[:12]


def _as_json(cell: Cell, identifier: str) -> dict[str, Any]:
    written: dict[str, Any] = {
        "cell_type": cell.kind,
        "id": identifier,
        "metadata": dict(cell.metadata),
        "source": cell.source.splitlines(keepends=True),
    }
    return written | {"execution_count": None, "outputs": []} if cell.kind == "code" else written


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
