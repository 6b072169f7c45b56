"""IPython's magics and shell lines in a cell: skipped, each with a note, so that the rest of the cell runs as Python."""

from __future__ import annotations

import ast
import re

_WHOLE = re.compile(r"%%(?!time\b|timeit\b|capture\b)(\w+)")
_LINE = re.compile(r"\s*(?:[%!]|\?|[^#'\"]*\w\?{1,2}\s*$)")
_ASSIGNED = re.compile(r"(\s*)([\w.,\s\[\]]+?)\s*=\s*[%!]")


def without_magics(source: str) -> tuple[str, list[str]]:
    """Return a cell as plain Python, its lines where they were, and a note for each thing that was skipped."""
    if _is_python(source):
        return source, []
    first = source.lstrip().split("\n", 1)[0]
    if whole := _WHOLE.match(first):
        return "", [f"%%{whole[1]}: the whole cell was skipped"]
    lines, notes = [], []
    for line in source.split("\n"):
        if assigned := _ASSIGNED.match(line):
            notes.append(f"skipped, and set to None: {line.strip()}")
            lines.append(f"{assigned[1]}{assigned[2]} = None")
        elif _LINE.match(line):
            notes.append(f"skipped: {line.strip()}")
            lines.append(re.match(r"\s*", line)[0] + "pass")  # type: ignore[index]
        else:
            lines.append(line)
    plain = "\n".join(lines)
    return (plain, notes) if _is_python(plain) else (source, [])


def _is_python(source: str) -> bool:
    try:
        ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True
