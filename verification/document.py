"""Read a document: front matter, displays and DH tables of Markdown, notebooks and py:percent lessons."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import yaml
from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

from verification.errors import DocumentError

FRONT_MATTER_KEYS = ("title", "source", "arm", "symbols", "transforms", "quantities")
# keys that notebook and site tools put into the same block
FOREIGN_KEYS = frozenset(["author", "authors", "date", "lang", "language", "subtitle", "license", "jupyter", "jupytext",
                          "kernelspec", "format", "abstract", "keywords", "slug", "description"])  # fmt: skip
SUFFIXES = (".md", ".ipynb", ".py")
_HTML_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
MAX_BYTES = 20_000_000


@dataclass(frozen=True)
class Display:
    """One `$$` display: its LaTeX, the line of its opening `$$` (from 1), the notebook cell if any."""

    line: int
    latex: str
    erratum: bool = False
    cell: int | None = None
    section: str = ""
    closed: bool = True


@dataclass(frozen=True)
class Table:
    """A Markdown table: header and rows of LaTeX (the `$` removed)."""

    line: int
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    erratum: bool = False
    cell: int | None = None
    section: str = ""


@dataclass(frozen=True)
class Document:
    """A document as read; `front` is its front matter, `front_line` the line it begins on."""

    path: Path
    front: dict[str, Any]
    displays: tuple[Display, ...]
    tables: tuple[Table, ...]
    lines: dict[str, int] = field(default_factory=dict)

    def at(self, key: str) -> str:
        """Return `file:line` of a front-matter key, for messages."""
        return f"{self.path}:{self.lines.get(key, 1)}"


def read_document(path: Path) -> Document:
    """Return the document of a file; raises DocumentError with file and line where it is not one."""
    text = _read_text(path)
    if path.suffix == ".ipynb":
        return _read_notebook(path, text)
    if path.suffix == ".py":
        return _read_percent(path, text)
    front, lines, body, first = _split_front_matter(path, text)
    displays, tables = _read_markdown(body, first)
    return Document(path, front or {}, tuple(displays), tuple(tables), lines)


def find_documents(paths: list[Path]) -> list[Path]:
    """Return the documents named, and those in the folders named; raises DocumentError where there are none.

    In a folder, a file counts that has front matter with one of our keys or holds a display.
    """
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            inside = [
                child
                for child in sorted(path.rglob("*"))
                if child.suffix in SUFFIXES
                and child.is_file()
                and not any(p.startswith(".") for p in child.relative_to(path).parts)
            ]
            documents = [child for child in inside if _is_document(child)]
            if not documents:
                raise DocumentError(
                    f"{path}: no document in this folder; a document is a {', '.join(SUFFIXES)} file with $$ displays"
                )
            found.extend(documents)
        elif not path.exists():
            raise DocumentError(f"{path}: no such file or folder")
        elif path.suffix not in SUFFIXES:
            raise DocumentError(f"{path}: '{path.suffix}' files are not read; those that are: {', '.join(SUFFIXES)}")
        else:
            found.append(path)
    return list(dict.fromkeys(found))


def _is_document(path: Path) -> bool:
    try:
        text = _read_text(path)
    except DocumentError:
        return path.suffix in (".md", ".ipynb")
    if path.suffix == ".py":
        return "# %% [markdown]" in text
    return "$$" in text or (text.startswith("---") and bool(re.search(r"^arm:", text, re.MULTILINE)))


def _read_text(path: Path) -> str:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise DocumentError(f"{path}: larger than {MAX_BYTES // 1_000_000} MB")
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise DocumentError(f"{path}: not a text file in UTF-8 (byte {error.start})") from None
    except OSError as error:
        raise DocumentError(f"{path}: cannot be read: {error.strerror}") from None


# -- front matter ------------------------------------------------------------------------------------------------------


def _split_front_matter(
    path: Path, text: str, first: int = 1
) -> tuple[dict[str, Any] | None, dict[str, int], str, int]:
    """Return front matter (None where there is none), its keys' lines, the body and the body's first line.

    `first` is the line of the file on which the text begins.
    """
    text = text.replace("\r\n", "\n")
    if not re.match(r"---[ \t]*\n", text):
        return None, {}, text, first
    end = re.compile(r"^(?:---|\.\.\.)[ \t]*$", re.MULTILINE).search(text, text.index("\n") + 1)
    if end is None:
        raise DocumentError(f"{path}:{first}: the front matter opened by '---' is never closed by '---'")
    block = text[text.index("\n") + 1 : end.start()]
    front, lines = parse_front_matter(path, block, first + 1)
    body_start = end.end() + 1
    return front, lines, text[body_start:], first + text.count("\n", 0, body_start)


def parse_front_matter(path: Path, block: str, first_line: int) -> tuple[dict[str, Any], dict[str, int]]:
    """Return the mapping of a YAML block and the line of each top key; raises DocumentError."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        for event in yaml.parse(block, Loader=loader):
            if isinstance(event, yaml.AliasEvent):  # a few of them can stand for millions of entries
                line = first_line + (event.start_mark.line if event.start_mark else 0)
                raise DocumentError(
                    f"{path}:{line}: the front matter may not repeat a part by '*{event.anchor}'; write it out"
                )
        front = yaml.load(block, Loader=loader)  # noqa: S506 - a safe loader
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = first_line + (mark.line if mark else 0)
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        raise DocumentError(f"{path}:{line}: the front matter is not YAML: {problem}") from None
    except (ValueError, RecursionError) as error:
        raise DocumentError(f"{path}:{first_line}: the front matter is not YAML: {error}") from None
    if front is None:
        front = {}
    if not isinstance(front, dict):
        raise DocumentError(f"{path}:{first_line}: the front matter must be a mapping of keys such as 'arm: scara'")
    lines: dict[str, int] = {}
    for number, text in enumerate(block.split("\n")):
        if found := re.match(r"([A-Za-z_]+)\s*:", text):
            key, line = found.group(1), first_line + number
            if key in lines:
                raise DocumentError(
                    f"{path}:{line}: the front-matter key '{key}' stands twice, first in line {lines[key]}"
                )
            lines[key] = line
    for key in front:
        if key not in FRONT_MATTER_KEYS and key not in FOREIGN_KEYS:
            where = f"{path}:{lines.get(str(key), first_line)}"
            raise DocumentError(
                f"{where}: unknown front-matter key '{key}'; the keys are {', '.join(FRONT_MATTER_KEYS)}"
            )
    if "arm" in front and front["arm"] is None:
        where = f"{path}:{lines.get('arm', first_line)}"
        raise DocumentError(f"{where}: 'arm' is empty; name an arm, a model file or a DH table, or leave the key out")
    for key in ("title", "source"):
        if not isinstance(front.get(key, ""), str):
            raise DocumentError(f"{path}:{lines.get(key, first_line)}: '{key}' must be text, not {front[key]!r}")
    return front, lines


# -- Markdown ----------------------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _markdown() -> MarkdownIt:
    return (
        MarkdownIt("commonmark", {"maxNesting": 100})
        .enable("table")
        .use(dollarmath_plugin, allow_labels=True, double_inline=True)
    )


def _read_markdown(body: str, first: int, cell: int | None = None) -> tuple[list[Display], list[Table]]:
    displays: list[Display] = []
    tables: list[Table] = []
    section = ""
    quotes: list[bool] = []  # one a nested blockquote: whether it is an erratum
    tokens = _markdown().parse(body)
    for index, token in enumerate(tokens):
        if token.type == "heading_open":
            section = tokens[index + 1].content
        elif token.type == "blockquote_open":
            quotes.append(_is_erratum(tokens, index))
        elif token.type == "blockquote_close":
            quotes.pop()
        elif token.type in ("math_block", "math_block_label"):
            line = first + (token.map[0] if token.map else 0)
            displays.extend(_block_displays(token.content, line, any(quotes), cell, section))
        elif token.type == "html_block" and "$$" in _HTML_COMMENT.sub("", token.content):
            line = first + (token.map[0] if token.map else 0) + token.content[: token.content.index("$$")].count("\n")
            displays.append(
                Display(line, token.content[token.content.index("$$") + 2 :], any(quotes), cell, section, closed=False)
            )
        elif token.type == "inline":
            displays.extend(_inline_displays(token, first, any(quotes), cell, section))
        elif token.type == "table_open":
            tables.append(_read_table(tokens, index, first, any(quotes), cell, section))
    return displays, tables


def _is_erratum(tokens: list[Token], start: int) -> bool:
    """Whether the first words of a blockquote are **Erratum**."""
    first = next((t for t in tokens[start + 1 :] if t.type in ("inline", "blockquote_close", "math_block")), None)
    return (
        first is not None
        and first.type == "inline"
        and bool(re.match(r"[*_\s]*errat(?:um|a)\b", first.content, re.IGNORECASE))
    )


def _block_displays(content: str, line: int, erratum: bool, cell: int | None, section: str) -> Iterator[Display]:
    """Yield the displays of a block: `$$ a = 1 $$ $$ b = 2 $$` on one line are two."""
    for index, part in enumerate(content.split("$$")):
        if index % 2 == 0:
            yield Display(line, part.strip("\n"), erratum, cell, section)
        line += part.count("\n")


def _inline_displays(token: Token, first: int, erratum: bool, cell: int | None, section: str) -> Iterator[Display]:
    base = first + (token.map[0] if token.map else 0)
    cursor = 0
    for child in token.children or []:
        if child.type == "math_inline_double":
            at = token.content.find("$$" + child.content, cursor)
            cursor = at + len(child.content) + 4
            yield Display(base + token.content.count("\n", 0, at), child.content, erratum, cell, section)
        elif child.type == "text" and "$$" in child.content and (at := token.content.find("$$", cursor)) >= 0:
            yield Display(
                base + token.content.count("\n", 0, at), token.content[at + 2 :], erratum, cell, section, closed=False
            )
            return


def _read_table(tokens: list[Token], start: int, first: int, erratum: bool, cell: int | None, section: str) -> Table:
    rows: list[list[str]] = []
    for token in tokens[start:]:
        if token.type == "tr_open":
            rows.append([])
        elif token.type == "inline":
            rows[-1].append(token.content.strip().strip("$").strip())
        elif token.type == "table_close":
            break
    opening = tokens[start]
    line = first + (opening.map[0] if opening.map else 0)
    return Table(line, tuple(rows[0]), tuple(tuple(row) for row in rows[1:]), erratum, cell, section)


# -- notebooks and lessons ---------------------------------------------------------------------------------------------


def _read_notebook(path: Path, text: str) -> Document:
    try:
        notebook = json.loads(text)
        cells = notebook["cells"]
        sources = [
            (c["cell_type"], c["source"] if isinstance(c["source"], str) else "".join(c["source"])) for c in cells
        ]
    except json.JSONDecodeError as error:
        raise DocumentError(f"{path}:{error.lineno}: not a notebook: {error.msg} (a notebook is JSON)") from None
    except (KeyError, TypeError, ValueError, RecursionError):
        raise DocumentError(f"{path}:1: not a notebook: it has no list of cells with a type and a source") from None
    front: dict[str, Any] | None = None
    lines: dict[str, int] = {}
    displays: list[Display] = []
    tables: list[Table] = []
    for number, (kind, source) in enumerate(sources):
        if kind not in ("markdown", "raw"):
            continue
        first = 1
        if front is None and source.lstrip().startswith("---"):
            front, lines, source, first = _split_front_matter(path, source.lstrip())
        if kind == "markdown":
            more, more_tables = _read_markdown(source, first, number)
            displays += more
            tables += more_tables
    return Document(path, front or {}, tuple(displays), tuple(tables), lines)


def _read_percent(path: Path, text: str) -> Document:
    """A jupytext py:percent file: its Markdown cells, at their own lines of the file."""
    front: dict[str, Any] | None = None
    lines: dict[str, int] = {}
    displays: list[Display] = []
    tables: list[Table] = []
    source = text.replace("\r\n", "\n").split("\n")
    starts = [k for k, line in enumerate(source) if line.startswith("# %%")] + [len(source)]
    for number, (start, end) in enumerate(pairwise(starts)):
        if not re.match(r"# %%.*\[(?:markdown|md|raw)\]", source[start]):
            continue
        body = "\n".join(re.sub(r"^# ?", "", line) for line in source[start + 1 : end])
        first = start + 2
        if front is None and body.startswith("---"):
            front, lines, body, first = _split_front_matter(path, body, first)
        more, more_tables = _read_markdown(body, first, number)
        displays += more
        tables += more_tables
    return Document(path, front or {}, tuple(displays), tuple(tables), lines)
