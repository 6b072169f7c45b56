"""The prose of a document's file, front matter, Markdown and the cells of a lesson, and the document in another language."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from io import StringIO
from pathlib import Path
from tokenize import COMMENT, DEDENT, INDENT, NEWLINE, STRING, TokenInfo, generate_tokens

from armproof.course.translation.markdown import segments, translated_markdown
from armproof.models.language import ENGLISH
from armproof.verification.document.catalogue import Translate, translation_of
from armproof.verification.document.cells import Cell, percent_cells
from armproof.verification.document.front_matter import split_front_matter
from armproof.verification.document.prose import Prose

Change = Callable[[str], str]  # Markdown in, Markdown out, on as many lines

_NAMED = re.compile(r"^(?P<key>title|source): +(?P<value>\S.*)$", re.MULTILINE)
_OPENING = re.compile(r'(?P<call>open_lesson\("\w+"[^()]*)(?=\))')
_LITERAL = re.compile(r"(?P<open>[rR]?\"\"\")(?P<text>.*)(?P<close>\"\"\")", re.DOTALL)
_REMARK = re.compile(r"(?P<open># )(?!fmt:|noqa)(?P<text>.*)(?P<close>)")
_BEGIN = (NEWLINE, INDENT, DEDENT)  # before a docstring


def prose_of(path: Path, text: str) -> list[Prose]:
    """Return the prose of a document, each piece once, in its order."""
    found: dict[str, Prose] = {}

    def keep(markdown: str) -> str:
        for segment in segments(markdown):
            found.setdefault(segment.prose.text, segment.prose)
        return markdown

    _changed(path, text, keep)
    return list(found.values())


def translated(path: Path, text: str, translate: Translate, lang: str) -> str:
    """Return a document's text with its prose in another language, on as many lines; a lesson is opened in it."""
    made = _changed(path, text, lambda markdown: translated_markdown(markdown, translate))
    return _OPENING.sub(rf'\g<call>, lang="{lang}"', made) if path.suffix == ".py" else made


def in_language(path: Path, text: str, lang: str) -> str:
    """Return a document's text in a language: as it stands in English, else with the words of its catalogue."""
    return text if lang == ENGLISH else translated(path, text, translation_of(path, lang), lang)


def _changed(path: Path, text: str, change: Change) -> str:
    """Return a document's text with each of its Markdown texts changed."""
    if path.suffix != ".py":
        return _changed_markdown(path, text, change)
    lines = text.replace("\r\n", "\n").split("\n")
    for cell in percent_cells(text):
        inside = _changed_code(cell, change) if cell.kind == "code" else _changed_markdown(path, cell.text, change)
        marked = inside.split("\n") if cell.kind == "code" else [f"# {line}".rstrip() for line in inside.split("\n")]
        lines[cell.line - 1 : cell.line - 1 + len(marked)] = marked
    return "\n".join(lines)


def _changed_markdown(path: Path, text: str, change: Change) -> str:
    front, body, _ = split_front_matter(path, text)
    head = text.replace("\r\n", "\n")[: -len(body) or None] if front is not None else ""
    return _NAMED.sub(lambda found: _changed_value(found, change), head) + change(body)


def _changed_value(found: re.Match[str], change: Change) -> str:
    """Return a line of front matter with its value changed, quoted where it is another one."""
    value = found["value"].strip()
    value = json.loads(value) if value.startswith('"') else value
    other = change(value)
    return found[0] if other == value else f"{found['key']}: {json.dumps(other, ensure_ascii=False)}"


def _changed_code(cell: Cell, change: Change) -> str:
    """Return a code cell with its comments, the docstrings of its functions and the documents in its strings changed."""
    lines = cell.text.split("\n")
    for token, found in reversed(list(_told(cell.text))):
        (first, start), (last, end) = token.start, token.end
        inside = _changed_markdown(Path("string.md"), found["text"], change)
        told = f"{lines[first - 1][:start]}{found['open']}{inside}{found['close']}{lines[last - 1][end:]}"
        lines[first - 1 : last] = told.split("\n")
    return "\n".join(lines)


def _told(code: str) -> Iterator[tuple[TokenInfo, re.Match[str]]]:
    """Yield what code tells its reader: comments, docstrings, and strings that are documents."""
    before = NEWLINE
    for token in generate_tokens(StringIO(code).readline):
        pattern = {COMMENT: _REMARK, STRING: _LITERAL}.get(token.type)
        found = pattern.fullmatch(token.string) if pattern is not None else None
        if found is not None and (token.type == COMMENT or before in _BEGIN or found["text"].startswith("---\n")):
            yield token, found
        before = token.type
