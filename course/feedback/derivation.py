"""A worked derivation: its lines, each a claim that is proved as a display of a handout is, opened one by one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from armproof.verification.check import check_document
from armproof.verification.document import Display, Document
from armproof.verification.verdict import Record


@dataclass(frozen=True)
class Line:
    """One line of a derivation: what is done, in a few words or none, and the equation that it gives, LaTeX."""

    words: str
    latex: str


@dataclass(frozen=True, eq=False)
class Derivation:
    """The way to a solution.

    Attributes:
        lines: in their order, from the rule to the solution.
        front: under which the lines are read, as a document's front matter; an arm, and names of its quantities.
        given: displays that come before: names with a meaning.
    """

    lines: tuple[Line, ...] = ()
    front: Mapping[str, Any] = field(default_factory=dict)
    given: tuple[str, ...] = ()

    def opened(self, count: int) -> str:
        """Return the first lines as Markdown."""
        shown = (
            f"{line.words}\n\n$$ {line.latex} $$" if line.words else f"${line.latex}$" for line in self.lines[:count]
        )
        return "\n\n".join(f"{k}. {line}" for k, line in enumerate(shown, 1))

    def records(self) -> tuple[Record, ...]:
        """Return the verdict on each line: a line that is not proved is none to be shown."""
        texts = [*self.given, *(line.latex for line in self.lines)]
        displays = tuple(Display(k, text, section="") for k, text in enumerate(texts, 1))
        return check_document(Document(Path("derivation"), dict(self.front), displays, ())).equations[len(self.given) :]
