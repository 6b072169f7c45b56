"""What a page is made of: the cells of a lesson as the student gets them, with their solutions and their outputs."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from armproof.course.sources.editions import student_cells
from armproof.course.sources.lesson_source import LessonSource

Output = Mapping[str, Any]  # as a notebook holds it

_CALL = re.compile(r"(?<![\w.])lesson\.(\w+)\.(check|show|hint|solution)\(")


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
        """Return the names of the tasks whose check, show, hint or solution the cell calls."""
        return tuple(dict.fromkeys(task for task, call in _CALL.findall(self.source) if call == name))

    def opens(self) -> bool:
        """Whether the cell opens the lesson."""
        return self.kind == "code" and "open_lesson(" in self.source


def cells_of(source: LessonSource) -> tuple[Cell, ...]:
    """Return the cells of a lesson, not executed."""
    pairs = zip(source.cells, student_cells(source), strict=True)
    return tuple(
        Cell(cell.kind, student.source, cell.source, number, cell.line) for number, (cell, student) in enumerate(pairs)
    )


def with_outputs(cells: Sequence[Cell], outputs: Mapping[int, Sequence[Output]]) -> tuple[Cell, ...]:
    """Return the cells with what running them gave, by their places."""
    return tuple(replace(cell, outputs=tuple(outputs.get(cell.number, ()))) for cell in cells)
