"""The text of a document as Markdown with the place of each line in the file: what is read into the blocks of a sheet."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

_SPECIAL = re.compile(r"[\\`*_\[\]<>#|{}!&@$]")


@dataclass(frozen=True)
class Body:
    """Markdown that begins on line `first` of the file or of the cell; `lines` has each line's own where it was made."""

    text: str
    first: int = 1
    cell: int | None = None
    lines: tuple[int, ...] = ()
    warnings: tuple[str, ...] = ()

    def line(self, row: int) -> int:
        """Return the line in the file of a line of the text (from 0)."""
        return self.lines[min(row, len(self.lines) - 1)] if self.lines else self.first + row


@dataclass
class MarkdownLines:
    """Markdown that is made block by block, in lists and quotes; `place` is the line of the file that is read."""

    place: int = 1
    lines: list[str] = field(default_factory=list)
    places: list[int] = field(default_factory=list)
    margins: list[str] = field(default_factory=list)  # of the quotes and lists that are open
    marked: list[bool] = field(default_factory=list)  # of each, whether the mark of its item is written

    def enter(self, margin: str) -> None:
        """Open a quote ("> ") or a list, by the mark of its items ("-", "1.")."""
        self.margins.append(margin if margin == "> " else f"{margin} ")
        self.marked.append(True)

    def mark(self) -> None:
        """Begin an item of the list that is open."""
        for level in range(len(self.margins) - 1, -1, -1):
            if self.margins[level] != "> ":
                self.marked[level] = False
                return

    def leave(self) -> None:
        """Close the quote or list that was opened last."""
        if self.margins:
            self.margins.pop()
            self.marked.pop()
            self._line("")

    def write(self, block: str) -> None:
        """Write the lines of a block."""
        for line in block.split("\n"):
            self._line(line)
        self._line("")

    def table(self, rows: Sequence[Sequence[str]]) -> None:
        """Write a table whose first row is its header; short rows are filled up."""
        width = max(map(len, rows))
        header, *others = ([*row, *[" "] * (width - len(row))] for row in rows)
        self.write("\n".join(f"| {' | '.join(row)} |" for row in (header, ["---"] * width, *others)))

    def body(self, warnings: Sequence[str] = ()) -> Body:
        """Return all that was written."""
        return Body("\n".join(self.lines), lines=tuple(self.places), warnings=tuple(warnings))

    def _line(self, text: str) -> None:
        margin = ""
        for level, own in enumerate(self.margins):
            first = bool(text) and not self.marked[level]
            margin += own if own == "> " or first else " " * len(own)
            self.marked[level] = self.marked[level] or first
        self.lines.append((margin + text).rstrip())
        self.places.append(self.place)


def escaped(text: str) -> str:
    """Return words as Markdown in which no sign means anything."""
    return _SPECIAL.sub(lambda found: "\\" + found[0], text)
