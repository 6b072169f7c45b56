"""What a document is once it is read: its displays and tables, each with its place in the file."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from armproof.verification.errors import DocumentError
from armproof.verification.findings import Finding, finding_of


@dataclass(frozen=True)
class Piece:
    """A part of a display's LaTeX that stands in the file as it is: from `at` on, `length` characters.

    `line` (from 1) and `column` (from 0) are its place in the file, or in a notebook's cell. A part that a macro stands for
    has no characters of its own there: it is replaced as a whole, up to `end`.
    """

    at: int
    length: int
    line: int
    column: int
    in_dollars: bool = True  # a table's cell may hold a number without them
    end: tuple[int, int] | None = None


@dataclass(frozen=True)
class Listing:
    """Equations that give joints and lengths numbers: of a piece of code, or at the ends of what is worked out.

    `off`: how far from what they are rounded from the latter may be. `in_text`: the text of the section gives them.
    `assigned`: all to which the code gives something.
    """

    line: int
    values: tuple[str, ...]
    section: str = ""
    off: float | None = None
    in_text: bool = False
    cell: int | None = None
    assigned: frozenset[str] = frozenset()

    @property
    def place(self) -> tuple[int, int]:
        """Its cell, 0 where there are none, and its line."""
        return self.cell or 0, self.line


@dataclass(frozen=True)
class Display:
    """One display: its LaTeX, the line of its opening (from 1), the notebook cell if any.

    `pieces` leads from the LaTeX back to the file: block quotes, comments and macros of the author's own stand between
    them. It is empty where the place of the LaTeX is not known.
    """

    line: int
    latex: str
    erratum: bool = False
    cell: int | None = None
    section: str = ""
    closed: bool = True
    denied: bool = (
        False  # whether the text around it, or a tag, says that it is wrong: of an erratum that goes without saying
    )
    faulted: bool = False  # whether it finds fault with something else, which may yet be this: what holds is not meant
    strange: str = ""  # the sentence around it that is not understood, and may take it back
    supposed: bool = False  # whether that supposes it, asks for it, or says in words that it holds in a case alone
    may_not_print: bool = False  # whether it stands in a branch of a conditional that nothing in the document decides
    of_other_point: bool = False  # whether the sentence before it is of another point than the tool, or another frame
    in_other_frame: bool = False  # whether it says that what follows is expressed in another frame than the base
    meant: tuple[
        str, ...
    ] = ()  # the letters that the text gives another meaning than the arm has for them, and of which link or operation it speaks
    directions: tuple[str, ...] = ()  # what the text of its section tells of axes, of angles and of the arm at zero
    opening: str = "$$"  # what it begins with in the file
    file: str = ""  # in which it stands, below the document's folder, where a main file inputs others; `cell` counts the changes
    said: tuple[str, ...] = ()  # the equations and postures in the text between the display before and this one
    said_above: int = 0  # how many of them stand above the last heading
    said_outside: int = 0  # and how many of those in sections that are not around that of the display
    goes_on: bool = False  # whether no words stand between it and the display before
    said_next: tuple[str, ...] = ()  # those of the text between it and the next display
    said_behind: tuple[str, ...] = ()  # those of the next text below it, under the same heading
    listed: tuple[Listing, ...] = ()  # the values in code under its heading, and those that are worked out above it
    pieces: tuple[Piece, ...] = field(default=(), compare=False, repr=False)

    @property
    def place(self) -> tuple[int | None, int]:
        """Its cell and its line."""
        return self.cell, self.line


INLINE = "$"  # the opening of what stands in the text: readers hand it over in its place among the displays
CODE = "```"  # that of code, which they hand over likewise


@dataclass(frozen=True)
class Table:
    """A Markdown table: header and rows of LaTeX (the `$` removed).

    `pieces` are the places of its cells, row by row, the header's first; None where one is not known.
    """

    line: int
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    erratum: bool = False
    cell: int | None = None
    section: str = ""
    file: str = ""
    pieces: tuple[tuple[Piece | None, ...], ...] = field(default=(), compare=False, repr=False)


@dataclass(frozen=True)
class Words:
    """What stands between the displays of a document, from its line on: as its format has it, macros expanded."""

    line: int
    text: str


@dataclass(frozen=True)
class Accept:
    """A comment by which the author accepts a finding, on its last line; `target` is the place of what it is about."""

    line: int
    cell: int | None
    reason: str
    target: tuple[int | None, int] | None = None


@dataclass(frozen=True)
class ToldPart:
    """What a sentence tells of one letter of an arm's build: what it is, and the words about it; `before` is the place of the display behind it."""

    place: tuple[int | None, int]  # cell and line
    before: tuple[int, int]  # cell (0 where there is none) and line
    kind: str
    letter: str  # its LaTeX
    marks: frozenset[str] = frozenset()


@dataclass(frozen=True)
class BuiltJoint:
    """A joint of a URDF in code: "revolute", "prismatic" or "fixed", "" of another kind; its origin and its axis as they are printed."""

    name: str
    kind: str
    parent: str
    child: str
    xyz: tuple[str, str, str]
    rpy: tuple[str, str, str]
    axis: tuple[str, str, str]


@dataclass(frozen=True)
class CodeRobot:
    """The chain of joints that a URDF in code tells, from its base to its tool."""

    line: int
    joints: tuple[BuiltJoint, ...]
    cell: int | None = None
    section: str = ""


@dataclass(frozen=True)
class Called:
    """What a sentence calls the arms that it speaks of: numbers, letters, kinds."""

    place: tuple[int, int]  # cell (0 where there is none) and line
    section: str
    names: frozenset[str]


@dataclass(frozen=True)
class Document:
    """A document as read; `front` is its front matter, `lines` the line of each key in it."""

    path: Path
    front: dict[str, Any]
    displays: tuple[Display, ...]
    tables: tuple[Table, ...]
    lines: dict[str, int] = field(default_factory=dict)
    accepts: tuple[Accept, ...] = ()
    remarks: tuple[Finding, ...] = ()  # on how it was read
    headings: tuple[tuple[int, str], ...] = ()  # with their lines, where its front matter has `arms` by section
    named: tuple[str, ...] = ()  # the arms of the catalogue that its text names
    in_code: tuple[Table, ...] = ()  # the DH tables in its pieces of code
    robots: tuple[CodeRobot, ...] = ()  # the URDFs in its pieces of code
    called: tuple[Called, ...] = ()  # what its sentences call arms, in their order
    planar: frozenset[int] = frozenset()  # how many joints the planar arms have that its text names
    convention: str = ""  # that of a DH table which its text names, "classic" or "modified"
    ends: tuple[tuple[int, str], ...] = ()  # where its text puts the tool in a frame, with their lines: "3\te\t0\t0"
    told: tuple[ToldPart, ...] = ()  # what its sentences tell of an arm's build, in their order
    figures: tuple[
        tuple[int | None, int, str], ...
    ] = ()  # the formulas of vectors in its text, with their cells and lines
    scalars: frozenset[str] = frozenset()  # the letters that its text calls a size or a moment: "size L", "moment M"

    def writes(self, key: str, *besides: tuple[int | None, int]) -> bool:
        """Whether a name such as d_3 stands in a display or in the text between, but at these places (cell, line)."""
        letter, _, digits = key.partition("_")
        named = re.compile(rf"(?<![A-Za-z]){letter}\s*_\s*\{{?\s*{digits}(?!\d)")
        texts = (
            text for each in self.displays for text in (*each.said, *(() if each.place in besides else (each.latex,)))
        )
        return any(named.search(text) for text in texts)

    def at(self, key: str) -> str:
        """Return `file:line` of a front-matter key, for messages."""
        return f"{self.path}:{self.lines.get(key, 1)}"

    def fault(self, key: str, error: Exception) -> DocumentError:
        """Return an error of a front-matter key, with its file and line."""
        return DocumentError(finding_of(error), path=self.path, line=self.lines.get(key, 1))
