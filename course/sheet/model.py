"""What a sheet is: blocks and the inline parts in them, with their mathematics written and their verdicts at hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from armproof.verification.latex.mathml.box import Box
from armproof.verification.latex.mathml.display import Line
from armproof.verification.verdict import Record

# -- inline ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Text:
    """Words."""

    text: str


@dataclass(frozen=True)
class Styled:
    """Words set off: strong or emphasis."""

    kind: Literal["strong", "emphasis"]
    parts: tuple[Inline, ...]


@dataclass(frozen=True)
class Code:
    """A piece of code within words."""

    text: str


@dataclass(frozen=True)
class Formula:
    """A formula within words, in pieces between which a line may end."""

    pieces: tuple[Box, ...]


@dataclass(frozen=True)
class Link:
    """Words that lead to a page of the network."""

    target: str
    parts: tuple[Inline, ...]


@dataclass(frozen=True)
class Break:
    """The end of a line that the author wants."""


Inline = Text | Styled | Code | Formula | Link | Break

# -- blocks ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Heading:
    """A title of a section, of level 2 to 6."""

    level: int
    parts: tuple[Inline, ...]


@dataclass(frozen=True)
class Paragraph:
    """A paragraph; `leads` says that it ends in the middle of a sentence, which the next block completes."""

    parts: tuple[Inline, ...]
    leads: bool = False


@dataclass(frozen=True)
class Display:
    """A display with its verdict and its number; without lines it could not be read, and its source is printed.

    `own` says that the document's source does not have it, in this and in tables.
    """

    lines: tuple[Line, ...]
    record: Record
    number: str = ""
    own: bool = False


@dataclass(frozen=True)
class Table:
    """A table, and its verdict where it is a claim; `columns` says how each column is aligned."""

    header: tuple[tuple[Inline, ...], ...]
    rows: tuple[tuple[tuple[Inline, ...], ...], ...]
    columns: tuple[str, ...]
    record: Record | None = None
    own: bool = False


@dataclass(frozen=True)
class Listing:
    """A list; `start` is the first number of a numbered one."""

    items: tuple[tuple[Block, ...], ...]
    start: int | None = None


@dataclass(frozen=True)
class Quote:
    """A block quote: a plain one, an erratum of the source, or a worked solution."""

    kind: Literal["plain", "erratum", "solution"]
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Listed:
    """Lines of code, as they stand."""

    text: str


@dataclass(frozen=True)
class Picture:
    """A picture in a file, its width on paper, and its caption."""

    path: Path
    width: float | None  # mm; None: as wide as it is, at most the line
    caption: tuple[Inline, ...]


@dataclass(frozen=True)
class Blank:
    """Space to write a solution into (mm)."""

    height: float


@dataclass(frozen=True)
class Rule:
    """A line across the column."""


Block = Heading | Paragraph | Display | Table | Listing | Quote | Listed | Picture | Blank | Rule


@dataclass(frozen=True)
class Sheet:
    """A document ready for paper.

    Attributes:
        title: what it is.
        source: what it was taken from.
        lang: en or fr.
        arm: the arm's name; empty where the statements are about none.
        blocks: what stands on it.
        draft: whether DRAFT is printed across it.
        solutions: whether it is the edition with solutions and errata.
        warnings: what of the document is not on it, and why.
        foot: what stands at its foot; empty: how many of its equations are proved.
    """

    title: tuple[Inline, ...]
    source: tuple[Inline, ...]
    lang: str
    arm: str
    blocks: tuple[Block, ...]
    draft: bool = False
    solutions: bool = False
    warnings: tuple[str, ...] = ()
    foot: str = ""

    @property
    def records(self) -> tuple[Record, ...]:
        """The verdicts of the displays and tables that stand on the sheet."""
        found = (block.record for block in walk(self.blocks) if isinstance(block, Display | Table))
        return tuple(record for record in found if record is not None)

    @property
    def has_own(self) -> bool:
        """Whether something on the sheet is marked as not being the source's."""
        return any(isinstance(block, Display | Table) and block.own for block in walk(self.blocks))


def inner(block: Block) -> tuple[tuple[Block, ...], ...]:
    """Return the sequences of blocks that a block holds: the one of a quote, those of the items of a list."""
    return (block.blocks,) if isinstance(block, Quote) else block.items if isinstance(block, Listing) else ()


def with_inner(block: Block, change: Callable[[tuple[Block, ...]], tuple[Block, ...]]) -> Block:
    """Return a block with each sequence of blocks that it holds changed."""
    if isinstance(block, Quote):
        return replace(block, blocks=change(block.blocks))
    return replace(block, items=tuple(map(change, block.items))) if isinstance(block, Listing) else block


def walk(blocks: tuple[Block, ...]) -> Iterator[Block]:
    """Yield blocks and all blocks in them, in their order."""
    for block in blocks:
        yield block
        for part in inner(block):
            yield from walk(part)


def plain(parts: tuple[Inline, ...]) -> str:
    """Return inline parts as plain text, their formulas left out."""
    words = []
    for part in parts:
        if isinstance(part, Text | Code):
            words.append(part.text)
        elif isinstance(part, Styled | Link):
            words.append(plain(part.parts))
        elif isinstance(part, Break):
            words.append(" ")
    return "".join(words)
