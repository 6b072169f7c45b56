"""Read the cells of a lesson, a jupytext py:percent file; what is malformed is refused with its line."""

from __future__ import annotations

from pathlib import Path

from armproof.course.sources.errors import AuthoringError, SourceError
from armproof.verification.document.cells import Cell, percent_cells


def read_cells(path: Path) -> tuple[Cell, ...]:
    """Return the cells of a py:percent file; its jupytext header is none of them.

    Raises:
        AuthoringError: the file cannot be read.
        SourceError: it holds no cells, text before the first, or Markdown that is no comment.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise AuthoringError(f"{path}: cannot be read: {reason}") from None
    return parse_cells(path, text)


def parse_cells(path: Path, text: str) -> tuple[Cell, ...]:
    """Return the cells of a py:percent text; `path` is for messages."""
    cells = percent_cells(text)
    if not cells:
        raise SourceError(path, 1, "no cell; a lesson is a py:percent file, whose cells begin with '# %%'")
    lines = text.replace("\r\n", "\n").split("\n")
    for number, line in enumerate(lines[: cells[0].marker - 1], 1):
        if line.strip() and not line.startswith("#"):
            raise SourceError(path, number, f"'{line.strip():.40}' stands before the first cell, '# %%'")
    for cell in cells:
        _check_cell(path, cell, lines)
    return cells


def _check_cell(path: Path, cell: Cell, lines: list[str]) -> None:
    if cell.title:
        raise SourceError(path, cell.marker, f"'{cell.title}' in the head of a cell; expected [markdown], [raw] or options such as tags=[\"wide\"]")  # fmt: skip
    if cell.kind == "code":
        return
    for number in range(cell.line, cell.line + cell.text.count("\n") + 1):
        line = lines[number - 1] if cell.text else ""
        if line.strip() and not line.startswith("#"):
            message = f"'{line.strip():.40}' in a text cell; expected a comment: '# ' before every line"
            raise SourceError(path, number, message)
