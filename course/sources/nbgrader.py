"""Export for nbgrader: answers and the checks of them in cells of their own, with its metadata (schema 3).

An answer's cell keeps its solution between `### BEGIN SOLUTION` and `### END SOLUTION`, which nbgrader takes out; a check's
cell is locked, worth a point, and raises where the answer is not right.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from armproof.course.errors import SourceError
from armproof.course.sources.editions import as_bytes, as_notebook, metadata_of
from armproof.course.sources.lesson_source import Check, LessonSource
from armproof.verification.document.cells import Cell

POINTS = 1
_GRADED = """_feedback = {call}
display(_feedback)
if not _feedback.is_right:
    raise AssertionError(f"{{_feedback.outcome.value}}: {{_feedback.message}}")"""


@dataclass(frozen=True)
class Part:
    """Some lines of a code cell: a check that earns a point, or what stands around it."""

    text: str
    check: Check | None = None
    is_answer: bool = False


def nbgrader_notebook(lesson: LessonSource) -> bytes:
    """Return the source version of an nbgrader assignment; raises SourceError where a check is no statement of its own."""
    graded = {check.task: check for check in lesson.checks if check.statement is not None}
    for check in lesson.checks:
        if check.task not in graded:
            expected = f"lesson.{check.task}.check(…) as a statement on lines of its own, outside any other"
            raise SourceError(lesson.path, check.line, "nbgrader cannot grade this check; expected {expected}", expected=expected)  # fmt: skip
    return as_bytes(as_notebook(lesson.name, _cells(lesson, list(graded.values()))))


def _cells(lesson: LessonSource, graded: list[Check]) -> Iterator[Cell]:
    for index, cell in enumerate(lesson.cells):
        if cell.kind != "code":
            yield replace(cell, metadata=metadata_of(cell))
            continue
        own = [check for check in graded if check.cell == index]
        for number, part in enumerate(_parts(lesson, index, own), 1):
            yield _as_cell(lesson.name, cell, part, f"{index}-{number}")


def _as_cell(lesson: str, cell: Cell, part: Part, place: str) -> Cell:
    text = part.text
    if part.check is not None:
        metadata = _metadata(f"{lesson}-{part.check.task}", grade=True, locked=True) | {"points": POINTS}
        text = _GRADED.format(call=text)
    elif part.is_answer:
        metadata = _metadata(f"{lesson}-answer-{place}", solution=True)
    else:
        metadata = _metadata(f"{lesson}-cell-{place}", locked=True)
    return Cell("code", text, metadata={**cell.metadata, "nbgrader": metadata})


def _metadata(grade_id: str, *, grade: bool = False, solution: bool = False, locked: bool = False) -> dict[str, Any]:
    kinds = {"grade": grade, "solution": solution, "locked": locked, "task": False}
    return {"schema_version": 3, "grade_id": grade_id, **kinds}


def _parts(lesson: LessonSource, index: int, graded: list[Check]) -> Iterator[Part]:
    """Yield a code cell in parts: each check that earns a point, and what stands between them."""
    lines = lesson.cells[index].text.split("\n")
    begin = 0
    for check in graded:
        statement = check.statement
        assert statement is not None
        end = statement.end_lineno or statement.lineno
        yield from _between(lesson, index, lines, begin, statement.lineno - 1)
        yield Part(ast.unparse(statement), check)
        begin = end
    yield from _between(lesson, index, lines, begin, len(lines))


def _between(lesson: LessonSource, index: int, lines: list[str], begin: int, end: int) -> Iterator[Part]:
    text = "\n".join(lines[begin:end]).strip("\n")
    if text.strip():
        yield Part(text, is_answer=any(begin < block.first <= end for block in lesson.blocks[index]))
