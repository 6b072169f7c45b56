"""The prose of a Markdown text: headings, paragraphs, items and cells of tables, each with its places; displays are none of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from markdown_it.token import Token

from armproof.verification.document.markdown import ADMONITIONS, markdown_reader, without_labels
from armproof.verification.document.prose import Prose, read_prose

_DISPLAY = re.compile(r"\$\$.*?(?:\$\$|\Z)", re.DOTALL)
_OPENS_BLOCK = re.compile(r"[-+*#>=|~:<]|\d+[.)]|```")  # what no further line of a paragraph may begin with
_DIRECTIVE = re.compile(r"\s*\{?\s*\.?([\w:-]*)")


@dataclass(frozen=True)
class Piece:
    """A part of a line (from 0): from column `start` up to `end`."""

    line: int
    start: int
    end: int


@dataclass(frozen=True)
class Segment:
    """A piece of prose and where it stands, a piece a line; in the cell of a table bars are escaped."""

    prose: Prose
    pieces: tuple[Piece, ...]
    is_cell: bool = False


def segments(text: str) -> list[Segment]:
    """Return the prose of a Markdown text in its order."""
    lines = without_labels(text).split("\n")
    return [segment for segment in _segments(lines, 0, len(lines)) if segment.prose.has_words]


def translated_markdown(text: str, translate: Callable[[str], str]) -> str:
    """Return a Markdown text with its prose translated, on as many lines."""
    lines = text.split("\n")
    for segment in reversed(segments(text)):
        if (translation := translate(segment.prose.text)) != segment.prose.text:
            _put(lines, segment, translation)
    return "\n".join(lines)


def _segments(lines: list[str], begin: int, end: int) -> Iterator[Segment]:
    tokens = markdown_reader().parse("\n".join(lines[begin:end]))
    column = 0
    for before, token in zip([None, *tokens], tokens, strict=False):
        if token.map is None:
            continue
        row = begin + token.map[0]
        if token.type == "tr_open":
            column = 0
        elif token.type == "inline" and before is not None and before.type in ("th_open", "td_open"):
            piece = _cell(token.content, lines[row], row, column)
            column = piece.end
            yield Segment(read_prose(token.content), (piece,), is_cell=True)
        elif token.type == "inline":
            yield from _paragraph(token.content, lines, row)
        elif token.type in ("fence", "colon_fence") and _holds_prose(token):
            yield from _segments(lines, row + 1, begin + token.map[1] - 1)


def _holds_prose(token: Token) -> bool:
    found = _DIRECTIVE.match(token.info)
    return token.type == "colon_fence" or (found is not None and found[1] in ADMONITIONS)


def _cell(content: str, line: str, row: int, column: int) -> Piece:
    written = content if content in line[column:] else content.replace("|", "\\|")
    at = line.index(written, column)
    return Piece(row, at, at + len(written))


def _paragraph(content: str, lines: list[str], row: int) -> Iterator[Segment]:
    """Yield the prose before, between and behind the displays of a paragraph."""
    end = 0
    for found in [*_DISPLAY.finditer(content), None]:
        upto = len(content) if found is None else found.start()
        source = content[end:upto]
        at = content.count("\n", 0, end)
        pieces = [
            Piece(row + at + k, start, start + len(bare))
            for k, bare in enumerate(part.strip() for part in source.split("\n"))
            if bare and (start := lines[row + at + k].index(bare)) >= 0
        ]
        if pieces:
            yield Segment(read_prose(source), tuple(pieces))
        end = len(content) if found is None else found.end()


def _put(lines: list[str], segment: Segment, translation: str) -> None:
    """Put a translation into the places of its source, its words shared out among the lines."""
    for piece, text in zip(segment.pieces, _shared(translation, segment), strict=True):
        line = lines[piece.line]
        inside = text.replace("|", "\\|") if segment.is_cell else text
        lines[piece.line] = line[: piece.start] + inside + line[piece.end :]


def _shared(translation: str, segment: Segment) -> list[str]:
    """Return a translation in as many parts as the source has lines, about as long as these."""
    words, pieces = [segment.prose.filled(word) for word in translation.split(" ")], segment.pieces
    whole = sum(piece.end - piece.start for piece in pieces)
    length = sum(map(len, words)) + len(words)
    parts: list[list[str]] = [[]]
    done, wanted = 0, 0.0
    for piece in pieces[:-1]:
        wanted += (piece.end - piece.start) / whole * length
        while words and (done < wanted or not parts[-1] or _OPENS_BLOCK.match(words[0])):
            done += len(words[0]) + 1
            parts[-1].append(words.pop(0))
        parts.append([])
    parts[-1] += words
    return [" ".join(part) for part in parts]
