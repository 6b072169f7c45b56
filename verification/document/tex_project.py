r"""A LaTeX document that its main file puts together by `\input`, `\include` and local packages, as one text.

Files are read below the main file's folder only: no absolute path, no `..`, no link that leads out; a bounded number of
them, each once in a branch.
"""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from armproof.verification.document.front_matter import MAX_BYTES, read_any_text, suffix_of
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.patterns import regex

MOST_FILES = 200
DEEPEST = 12
_INPUT = regex(
    r"\\(?:input|include|subfile|subfileinclude)\s*\{(?P<braced>[^{}]+)\}|\\input\s+(?P<bare>[\w./-]+)"
    r"|\\(?:import|subimport)\*?\s*\{(?P<folder>[^{}]*)\}\s*\{(?P<imported>[^{}]+)\}"
    r"|\\(?:usepackage|RequirePackage|documentclass|LoadClass)\s*(?:\[[^\]]*\]\s*)?\{(?P<packages>[^{}]+)\}"
)


@dataclass(frozen=True)
class _Part:
    """A stretch of the joined text: from `start` on stands what `file` holds from `at` on; `number` counts the stretches."""

    start: int
    file: str
    at: int
    newlines: tuple[int, ...]


@dataclass
class Project:
    """The text of a document, with what it inputs in its place, and the definitions of its local packages.

    `hide` blanks what does not print in a file's text: nothing is input from a comment.
    """

    folder: Path
    hide: Callable[[str], str]
    text: str = ""
    definitions: str = ""
    parts: list[_Part] = field(default_factory=list)
    left_out: dict[str, Finding] = field(default_factory=dict)  # and what is remarked about it
    read: list[Path] = field(default_factory=list)  # the files that were, by the names that they are asked for

    def add(self, text: str, file: str, above: tuple[Path, ...]) -> None:
        """Append the text of a file, and in their places those that it inputs; `above` it are it and those that input it."""
        newlines = tuple(found.start() for found in re.finditer("\n", text))
        visible = self.hide(text)
        at, end = _body(visible) if len(above) > 1 else (0, len(text))
        for found in _INPUT.finditer(visible, at, end):
            if found["packages"]:
                self._define(found["packages"], above)
                continue
            name = (found["folder"] or "") + (found["braced"] or found["bare"] or found["imported"])
            inside = self._read(name.strip(), (".tex", ""), above)
            if inside is None:
                self.left_out.setdefault(name.strip(), say(Kind.NOT_INPUT, file=name.strip()))
                continue
            self._append(text[at : found.start()], file, at, newlines)
            self.add(inside[1], str(inside[0].relative_to(self.folder)), (*above, inside[0]))
            at = found.end()
        self._append(text[at:end], file, at, newlines)

    def _append(self, text: str, file: str, at: int, newlines: tuple[int, ...]) -> None:
        self.parts.append(_Part(len(self.text), file, at, newlines))
        self.text += text

    def _define(self, names: str, above: tuple[Path, ...]) -> None:
        """Take the definitions of the packages that lie beside the document; all others are those of TeX."""
        for name in names.split(","):
            if (inside := self._read(name.strip(), (".sty", ".cls"), above)) is not None:
                visible = self.hide(inside[1])
                for found in _INPUT.finditer(visible):
                    self._define(found["packages"] or found["braced"] or "", (*above, inside[0]))
                self.definitions += visible

    def _read(self, name: str, suffixes: tuple[str, ...], above: tuple[Path, ...]) -> tuple[Path, str] | None:
        """Return a file of the project and its text, or None where there is none that may be read."""
        if not name or "\0" in name or Path(name).is_absolute() or ".." in Path(name).parts:
            return None
        if len(above) >= DEEPEST or len(self.read) >= MOST_FILES:
            return None
        try:
            tried = [self.folder / (name + suffix) for suffix in suffixes]
            asked = next(
                (each for each in tried if each.resolve().is_relative_to(self.folder) and each.is_file()), None
            )
            if (
                asked is None
                or (path := asked.resolve()) in above
                or suffix_of(path) not in (".tex", ".sty", ".cls", ".ltx")
            ):
                return None
            self.read.append(asked)
            text = read_any_text(path)[0].replace("\r\n", "\n")
        except (OSError, ValueError, RuntimeError, DocumentError):
            return None
        return (path, text) if len(self.text) + len(self.definitions) + len(text) <= MAX_BYTES else None

    def place(self, offset: int) -> tuple[int, int]:
        """Return the line (from 1) and the column (from 0) of a place in its own file."""
        part = self.parts[self.number(offset)]
        own = part.at + offset - part.start
        line = bisect(part.newlines, own - 1)
        return line + 1, own - (part.newlines[line - 1] + 1 if line else 0)

    def number(self, offset: int) -> int:
        """Return the number of the stretch in which a place stands."""
        return max(0, bisect(self.parts, offset, key=lambda part: part.start) - 1)

    def file(self, offset: int) -> str:
        """Return the file in which a place stands, below the main file's folder; empty where nothing is input."""
        return self.parts[self.number(offset)].file if len(self.parts) > 1 else ""


def _body(text: str) -> tuple[int, int]:
    """Return where the body of a file begins and ends that may be a document of its own."""
    begin, end = (re.search(r"\\%s\s*\{document\}" % which, text) for which in ("begin", "end"))
    return (begin.end() if begin else 0, end.start() if end else len(text))
