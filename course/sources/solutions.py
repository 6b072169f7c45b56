"""The solution blocks of a code cell, and what a student finds in their place."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.course.errors import SourceError
from armproof.models.language import look_up, noted
from armproof.verification.document.cells import Cell

BEGIN, END = "### BEGIN SOLUTION", "### END SOLUTION"
CODE, ANSWER = noted("your code here"), noted("your answer here")
_MARKER = re.compile(r"^(?P<indent>[ \t]*).*#+ *(?P<which>BEGIN|END) +SOLUTION\b.*$", re.IGNORECASE)


@dataclass(frozen=True)
class Block:
    """A solution in a cell: the lines of its two markers (from 1, in the cell), their indent, and the names it binds.

    `names` is empty inside a function.
    """

    first: int
    last: int
    indent: str
    in_function: bool
    names: tuple[str, ...]


def find_blocks(path: Path, cell: Cell, tree: ast.Module) -> tuple[Block, ...]:
    """Return the solution blocks of a code cell; raises SourceError where markers do not match or a block holds nothing."""
    blocks: list[Block] = []
    begun: tuple[int, str] | None = None
    for number, text in enumerate(cell.text.split("\n"), 1):
        if (found := _MARKER.match(text)) is None:
            continue
        at, is_begin = cell.line + number - 1, found["which"].upper() == "BEGIN"
        exact = BEGIN if is_begin else END
        if text.strip() != exact:
            raise SourceError(path, at, "'{text}' is no marker; expected '{exact}' alone on its line", text=text.strip(), exact=exact)  # fmt: skip
        if is_begin and begun is not None:
            before = cell.line + begun[0] - 1
            raise SourceError(path, at, "a second '{begin}'; expected '{end}' for the one of line {before}",
                begin=BEGIN, end=END, before=before)  # fmt: skip
        if not is_begin and begun is None:
            raise SourceError(path, at, "'{end}' without '{begin}' before it in the same cell", end=END, begin=BEGIN)
        if is_begin:
            begun = number, found["indent"]
            continue
        assert begun is not None
        if found["indent"] != begun[1]:
            raise SourceError(path, at, "'{end}' is not indented as its '{begin}' of line {begun}",
                end=END, begin=BEGIN, begun=cell.line + begun[0] - 1)  # fmt: skip
        blocks.append(_block(path, cell, tree, begun, number))
        begun = None
    if begun is not None:
        raise SourceError(path, cell.line + begun[0] - 1, "'{begin}' without '{end}' behind it in the same cell", begin=BEGIN, end=END)  # fmt: skip
    return tuple(blocks)


def _block(path: Path, cell: Cell, tree: ast.Module, begun: tuple[int, str], last: int) -> Block:
    first, indent = begun
    at = cell.line + first - 1
    inside = [node for node in ast.walk(tree) if isinstance(node, ast.stmt) and first < node.lineno < last]
    if not inside:
        raise SourceError(path, at, "nothing between '{begin}' and '{end}'; expected the solution", begin=BEGIN, end=END)  # fmt: skip
    if any((node.end_lineno or last) > last for node in inside):
        raise SourceError(path, at, "the solution ends in the middle of a statement; move its markers")
    if not indent:
        return Block(first, last, indent, False, tuple(dict.fromkeys(_bound(tree.body, first, last))))
    functions = (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef))
    if not any(function.lineno < first and inside[0] in ast.walk(function) for function in functions):
        raise SourceError(
            path, at, "an indented solution outside a function; expected it in a function, or not indented"
        )
    return Block(first, last, indent, True, ())


def _bound(statements: list[ast.stmt], first: int, last: int) -> Iterator[str]:
    """Yield the names that top-level statements between two lines give a value, imports left out."""
    for node in statements:
        if not first < node.lineno < last:
            continue
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield node.name
        elif not isinstance(node, ast.Import | ast.ImportFrom):
            inner = [below for below in ast.walk(node) if isinstance(below, ast.Name)]
            yield from (name.id for name in inner if isinstance(name.ctx, ast.Store) and not _is_local(name, node))


def _is_local(name: ast.Name, statement: ast.stmt) -> bool:
    """Whether a name is one of a comprehension, a lambda or a function inside the statement."""
    scopes = ast.ListComp | ast.SetComp | ast.DictComp | ast.GeneratorExp | ast.FunctionDef | ast.Lambda
    return any(name in ast.walk(scope) for scope in ast.walk(statement) if isinstance(scope, scopes))


def without_solutions(cell: Cell, blocks: Collection[Block], needed: Collection[str]) -> str:
    """Return the text of a cell with a line to fill in for each solution.

    Args:
        cell: a code cell.
        blocks: its solutions.
        needed: the names that the lesson reads outside solutions; of a block's names only they are left to fill in, or
            all where none is read.
    """
    lines = cell.text.split("\n")
    for block in sorted(blocks, key=lambda block: block.first, reverse=True):
        lines[block.first - 1 : block.last] = _blank(block, needed)
    return "\n".join(lines)


def _blank(block: Block, needed: Collection[str]) -> list[str]:
    if block.in_function:
        return [f"{block.indent}...  # {look_up(CODE)}"]
    names, answer = [name for name in block.names if name in needed] or block.names, f"...  # {look_up(ANSWER)}"
    return [f"{name} = {answer}" for name in names] or [answer]
