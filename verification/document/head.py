"""Put keys of front matter at the head of a document, as each format has it, and leave every other character as it is."""

from __future__ import annotations

import json
import re

from armproof.verification.document.formats import parse_document
from armproof.verification.document.front_matter import suffix_of
from armproof.verification.document.model import Document
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.patterns import regex

_FENCE = regex(r"(?:---|\.\.\.)[ \t]*$")


def with_front_matter(document: Document, text: str, block: str) -> str:
    """Return a document's text with the lines of a YAML block beside the front matter that it has.

    Raises:
        DocumentError: it cannot be put there so that the document is read with these keys and otherwise as before.
    """
    mark = "\ufeff" if text.startswith("\ufeff") else ""
    ends = "\r\n" if "\r\n" in text else "\n"
    plain = text.removeprefix(mark).replace("\r\n", "\n")
    made = _INSERT.get(suffix_of(document.path), _into_markdown)(plain, block.rstrip("\n").split("\n"))
    if not _is_as_meant(document, made):
        raise DocumentError(say(Kind.NO_PLACE_FOR_FRONT), path=document.path)
    return mark + made.replace("\n", ends)


def head_of(suffix: str, block: str) -> str:
    """Return the front matter of a document that has none, as its format writes it."""
    lines = block.rstrip("\n").split("\n")
    if suffix == ".tex":
        return "".join(f"% {line}\n" for line in ("---", *lines, "---"))
    if suffix == ".rst":
        return "..\n" + "".join(f"   {line}\n" for line in lines)
    return "".join(f"{line}\n" for line in ("---", *lines, "---"))


def _is_as_meant(document: Document, made: str) -> bool:
    """Whether the keys are there, and everything else is read as before."""
    try:
        read = parse_document(document.path, made)
    except DocumentError:
        return False
    kept = all(read.front.get(key) == value for key, value in document.front.items())
    texts = [[display.latex for display in one.displays] for one in (document, read)]
    cells = [[(table.header, table.rows) for table in one.tables] for one in (document, read)]
    return kept and "arm" in read.front and texts[0] == texts[1] and cells[0] == cells[1]


def _into_markdown(text: str, block: list[str]) -> str:
    lines = text.split("\n")
    if re.match(r"---[ \t]*$", lines[0]) and (end := _end(lines, 1)) is not None:
        return "\n".join([*lines[:end], *block, *lines[end:]])
    return head_of(".md", "\n".join(block)) + "\n" + text


def _end(lines: list[str], start: int) -> int | None:
    return next((k for k in range(start, len(lines)) if _FENCE.match(lines[k])), None)


def _into_tex(text: str, block: list[str]) -> str:
    """The head is the comments at the beginning, behind those that tell editors how to set the file."""
    lines = text.split("\n")
    head = next((k for k, line in enumerate(lines) if not re.match(r"\s*%", line)), len(lines))
    bare = [re.sub(r"^\s*%+ ?", "", line).rstrip() for line in lines[:head]]
    if "---" in bare and (end := _end(bare, bare.index("---") + 1)) is not None:
        return "\n".join([*lines[:end], *(f"% {line}" for line in block), *lines[end:]])
    first = next((k for k, line in enumerate(bare) if not line.startswith("!")), head)
    return "\n".join([*lines[:first], *head_of(".tex", "\n".join(block)).split("\n")[:-1], *lines[first:]])


def _into_rst(text: str, block: list[str]) -> str:
    lines = text.split("\n")
    first = next((k for k, line in enumerate(lines) if line.strip()), 0)
    if re.match(r"\.\.\s*$", lines[first]):  # a comment with keys: they stand under one another
        margin = re.match(r"\s*", lines[first + 1] if first + 1 < len(lines) else "   ")
        return "\n".join(
            [*lines[: first + 1], *(f"{margin[0] if margin else ''}{b}" for b in block), *lines[first + 1 :]]
        )
    return head_of(".rst", "\n".join(block)) + "\n" + text


def _into_percent(text: str, block: list[str]) -> str:
    """The first text cell's front matter, or a cell of its own before the first."""
    lines = text.split("\n")
    cell = next((k for k, line in enumerate(lines) if re.match(r"#\s*%%", line)), len(lines))
    bare = [re.sub(r"^# ?", "", line) for line in lines]
    is_text = cell < len(lines) and re.search(r"\[(?:markdown|md|raw)\]", lines[cell]) is not None
    has_front = is_text and "".join(bare[cell + 1 : cell + 2]).rstrip() == "---"
    if has_front and (end := _end(bare, cell + 2)) is not None:
        return "\n".join([*lines[:end], *(f"# {line}" for line in block), *lines[end:]])
    return "\n".join(
        [*lines[:cell], "# %% [raw]", *(f"# {line}" for line in ("---", *block, "---")), "", *lines[cell:]]
    )


def _into_notebook(text: str, block: list[str]) -> str:
    """The front matter of the first cell, or a raw cell of its own before it."""
    cells = json.loads(text or "{}").get("cells", [])
    source = "".join(cells[0]["source"]) if cells else ""
    opening = re.search(r'"cells"\s*:\s*\[', text)
    if opening is None:
        return text
    if source.startswith("---") and isinstance(cells[0]["source"], list):
        inside = re.compile(r'"(?:---|\.\.\.)[ \t]*(?:\\n)?"')
        fences = list(inside.finditer(text, opening.end()))
        added = ", ".join(json.dumps(f"{line}\n", ensure_ascii=False) for line in block)
        return text[: fences[1].start()] + added + ", " + text[fences[1].start() :] if len(fences) > 1 else text
    cell: dict[str, object] = {
        "cell_type": "raw",
        "metadata": {},
        "source": ["---\n", *(f"{b}\n" for b in block), "---"],
    }
    if cells and "id" in cells[0]:
        cell = {"cell_type": "raw", "id": "front-matter", **cell}
    return f"{text[: opening.end()]}\n  {json.dumps(cell, ensure_ascii=False)}{',' if cells else ''}{text[opening.end() :]}"


_INSERT = {".tex": _into_tex, ".rst": _into_rst, ".py": _into_percent, ".ipynb": _into_notebook}
