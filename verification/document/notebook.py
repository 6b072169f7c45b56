"""Read a notebook: the displays of its Markdown cells, each at its line of the cell."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from armproof.verification.document.front_matter import split_front_matter
from armproof.verification.document.markdown import read_markdown
from armproof.verification.document.model import Display, Document, Table
from armproof.verification.errors import DocumentError


def read_notebook(path: Path, text: str) -> Document:
    """Return the document of a notebook's JSON; its front matter stands in its first Markdown or raw cell that has one."""
    front: dict[str, Any] | None = None
    lines: dict[str, int] = {}
    displays: list[Display] = []
    tables: list[Table] = []
    for number, (kind, source) in enumerate(notebook_cells(path, text)):
        if kind not in ("markdown", "raw"):
            continue
        first = 1
        if front is None and source.lstrip().startswith("---"):
            blank = len(source) - len(source.lstrip())
            front, lines, source, first = split_front_matter(path, source[blank:], 1 + source.count("\n", 0, blank))
        if kind == "markdown":
            more, more_tables = read_markdown(source, first, number)
            displays += more
            tables += more_tables
    return Document(path, front or {}, tuple(displays), tuple(tables), lines)


def notebook_cells(path: Path, text: str) -> list[tuple[str, str]]:
    """Return the type and the source of each cell; raises DocumentError."""
    try:
        cells = json.loads(text)["cells"]
        return [(c["cell_type"], c["source"] if isinstance(c["source"], str) else "".join(c["source"])) for c in cells]
    except json.JSONDecodeError as error:
        raise DocumentError(f"{path}:{error.lineno}: not a notebook: {error.msg} (a notebook is JSON)") from None
    except (KeyError, TypeError, ValueError, RecursionError):
        raise DocumentError(f"{path}:1: not a notebook: it has no list of cells with a type and a source") from None
