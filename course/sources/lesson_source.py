"""A lesson's source: its cells, solutions and checks, known to be well formed."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.course.errors import AuthoringError, SourceError
from armproof.course.sources.solutions import BEGIN, END, Block, find_blocks
from armproof.course.translation.documents import in_language
from armproof.models.language import ENGLISH
from armproof.verification.document.cells import Cell, percent_cells

FILE = re.compile(r"(?P<number>\d\d)_(?P<name>[a-z][a-z0-9_]*)\.py")


def read_cells(path: Path, lang: str = ENGLISH) -> tuple[Cell, ...]:
    """Return the cells of a py:percent file, its prose in a language; its jupytext header is none of them.

    Raises:
        AuthoringError: the file cannot be read.
        SourceError: it holds no cells, text before the first, or Markdown that is no comment.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise AuthoringError("{path}: cannot be read: {reason}", path=path, reason=reason) from None
    return parse_cells(path, in_language(path, text, lang))


def parse_cells(path: Path, text: str) -> tuple[Cell, ...]:
    """Return the cells of a py:percent text; `path` is for messages."""
    cells = percent_cells(text)
    if not cells:
        raise SourceError(path, 1, "no cell; a lesson is a py:percent file, whose cells begin with '# %%'")
    lines = text.replace("\r\n", "\n").split("\n")
    for number, line in enumerate(lines[: cells[0].marker - 1], 1):
        if line.strip() and not line.startswith("#"):
            raise SourceError(path, number, "'{text:.40}' stands before the first cell, '# %%'", text=line.strip())
    for cell in cells:
        _check_cell(path, cell, lines)
    return cells


def _check_cell(path: Path, cell: Cell, lines: list[str]) -> None:
    if cell.title:
        raise SourceError(path, cell.marker, "'{title}' in the head of a cell; expected [markdown], [raw] or options such as tags=[\"wide\"]", title=cell.title)  # fmt: skip
    if cell.kind == "code":
        return
    for number in range(cell.line, cell.line + cell.text.count("\n") + 1):
        line = lines[number - 1] if cell.text else ""
        if line.strip() and not line.startswith("#"):
            message = f"'{line.strip():.40}' in a text cell; expected a comment: '# ' before every line"
            raise SourceError(path, number, message)


@dataclass(frozen=True)
class Check:
    """A call `lesson.<task>.check(…)`: the task, the cell (from 0), the line of the file, and its statement if it is one."""

    task: str
    cell: int
    line: int
    statement: ast.Expr | None = None


@dataclass(frozen=True)
class LessonSource:
    """A solved source as read: `blocks` and `trees` belong to the code cells, by their index."""

    path: Path
    number: int
    name: str
    cells: tuple[Cell, ...]
    trees: dict[int, ast.Module]
    blocks: dict[int, tuple[Block, ...]]
    checks: tuple[Check, ...]

    @property
    def needed(self) -> set[str]:
        """The names that are read somewhere outside the solutions."""
        return {
            node.id
            for index, tree in self.trees.items()
            for node in ast.walk(tree)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
            if not any(block.first < node.lineno < block.last for block in self.blocks[index])
        }

    def place(self, cell: int, line: int = 1) -> str:
        """Return `file:line` of a line of a cell (both from the notebook's point of view: cell from 0, line from 1)."""
        return f"{self.path}:{self.cells[cell].line + line - 1}" if cell < len(self.cells) else str(self.path)


def read_lesson_source(path: Path, lang: str = ENGLISH) -> LessonSource:
    """Return a lesson's source in a language; raises SourceError, with file and line, where it is not what a lesson is."""
    found = FILE.fullmatch(path.name)
    if found is None:
        raise SourceError(path, 1, "a lesson's file is called NN_name.py, such as 12_scara_jacobian.py")
    cells = read_cells(path, lang)
    _require_front_matter(path, cells)
    _refuse_solutions_in_text(path, cells)
    trees = {index: _parsed(path, cell) for index, cell in enumerate(cells) if cell.kind == "code"}
    blocks = {index: find_blocks(path, cells[index], tree) for index, tree in trees.items()}
    _require_opening(path, found["name"], cells, trees)
    checks = tuple(check for index, tree in trees.items() for check in _checks(cells[index], index, tree))
    return LessonSource(path, int(found["number"]), found["name"], cells, trees, blocks, checks)


def _require_front_matter(path: Path, cells: tuple[Cell, ...]) -> None:
    first = cells[0]
    if first.kind != "raw" or not re.match(r"---\n(.*\n)*---\Z", first.text):
        raise SourceError(
            path,
            first.line,
            "the first cell is no front matter; expected '# %% [raw]' with '# ---', 'title', 'arm' and '# ---'",
        )


def _refuse_solutions_in_text(path: Path, cells: tuple[Cell, ...]) -> None:
    for cell in cells:
        for number, text in enumerate(cell.text.split("\n")):
            if cell.kind != "code" and text.strip() in (BEGIN, END):
                raise SourceError(path, cell.line + number, "'{text}' in a text cell; solutions stand in code cells", text=text.strip())  # fmt: skip


def _parsed(path: Path, cell: Cell) -> ast.Module:
    try:
        return ast.parse(cell.text)
    except SyntaxError as error:
        raise SourceError(path, cell.line + (error.lineno or 1) - 1, "not Python: {msg}", msg=error.msg) from None


def _require_opening(path: Path, name: str, cells: tuple[Cell, ...], trees: dict[int, ast.Module]) -> None:
    expected = f'lesson = open_lesson("{name}")'
    for index, tree in trees.items():
        for node in tree.body:
            if (opened := _opened(node)) is None:
                continue
            if opened != name:
                line = cells[index].line + node.lineno - 1
                raise SourceError(path, line, "opens the lesson '{opened}'; expected {expected}, the name of the file",
                    opened=opened, expected=expected)  # fmt: skip
            return
    raise SourceError(path, cells[0].line, "no cell opens the lesson; expected {expected}", expected=expected)


def _opened(node: ast.stmt) -> str | None:
    """Return the name in `lesson = open_lesson("name", …)`; None for any other statement."""
    match node:
        case ast.Assign(
            targets=[ast.Name(id="lesson")],
            value=ast.Call(func=ast.Name(id="open_lesson"), args=[ast.Constant(value=str(name)), *_]),
        ):
            return name
    return None


def _checks(cell: Cell, index: int, tree: ast.Module) -> Iterator[Check]:
    alone = {id(node.value): node for node in tree.body if isinstance(node, ast.Expr) and node.col_offset == 0}
    for node in ast.walk(tree):
        if (task := _checked_task(node)) is not None:
            yield Check(task, index, cell.line + node.lineno - 1, alone.get(id(node)))  # type: ignore[attr-defined]


def _checked_task(node: ast.AST) -> str | None:
    """Return the task of a call `lesson.<task>.check(…)`; None for any other node."""
    match node:
        case ast.Call(func=ast.Attribute(attr="check", value=ast.Attribute(attr=task, value=ast.Name(id="lesson")))):
            return task
    return None
