"""A record's formula as HTML: the display in MathML from the tree that was checked, or a table with its cells."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from markupsafe import Markup, escape

from armproof.models.language import look_up
from armproof.verification.correction import corrected, edits
from armproof.verification.document import Display
from armproof.verification.errors import ReadError
from armproof.verification.latex.mathml.display import Line, pieces, write_display
from armproof.verification.latex.mathml.marks import RIGHT, WRONG, Mark
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.latex.plain import LETTERS
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex
from armproof.verification.report.html.prose import math, symbol
from armproof.verification.tables.check import read_array
from armproof.verification.verdict import Record, WrongEntry

ON_PAPER = 45.0  # em of text that fit on a line of A4
NARROW = 11.0  # em that fit on a phone within a panel
_SMALLEST = 25  # per cent
_NAME = regex(r"[A-Za-z]+_\w+(?:[-+]\d)?")  # theta_i as Markdown's authors write it
# in a table: "revolute", "joint_3", "x (m)", but not "alpha_i" and no LaTeX
_WORDS = regex(rf"(?<![\\\w])(?!(?:{'|'.join(LETTERS)})(?![a-z]))[A-Za-zÀ-ÿ]{{3,}}|\((?:m|mm|rad|deg|°)\)$")


@dataclass(frozen=True)
class Formula:
    """A formula as HTML and its LaTeX.

    Attributes:
        html: the markup; the escaped LaTeX where it cannot be read.
        latex: the source.
        width: the estimated width of its widest piece (em).
    """

    html: Markup
    latex: str
    width: float = 0.0

    @property
    def fit(self) -> int:
        """The size, in per cent of the text's, at which the widest piece fits on A4."""
        if self.width <= ON_PAPER:
            return 100
        return max(_SMALLEST, int(100 * ON_PAPER / self.width) // 5 * 5)

    @property
    def scrolls(self) -> bool:
        """Whether a narrow window has to scroll it, for which it must take the keyboard's focus."""
        return self.width > NARROW


def as_printed(record: Record, read: Read, *, is_table: bool = False) -> Formula:
    """Return a record's formula as it is printed, its wrong entries marked."""
    if is_table:
        return _table(record, _cells(record.latex), record.latex, read, WRONG)
    spans = [entry.span for entry in record.entries if entry.span is not None] or [
        (_normal(record.latex, edit.start), _normal(record.latex, edit.end)) for edit in edits(record)
    ]
    return _formula(record, record.latex, read, spans, WRONG)


def as_it_should_be(record: Record, read: Read, *, is_table: bool = False) -> Formula | None:
    """Return a refuted record's formula with every wrong entry corrected and marked, or None where that is not known."""
    if is_table:
        return _corrected_table(record, read)
    mended = corrected(record)
    if mended is None:
        return None
    spans = [(_normal(mended.latex, start), _normal(mended.latex, end)) for start, end in mended.spans]
    return _formula(record, mended.latex, read, spans, RIGHT)


def _normal(latex: str, offset: int) -> int:
    """Return a place in LaTeX as the tree counts it, without Unicode signs."""
    return len(normalise_unicode(latex[:offset]))


def _formula(record: Record, latex: str, read: Read, spans: Sequence[tuple[int, int]], mark: Mark) -> Formula:
    try:
        lines = write_display(latex, read, spans, mark)
    except ReadError:
        array = read_array(Display(record.line, latex))
        if array is not None:
            return _table(record, [array.table.header, *array.table.rows], latex, read, mark)
        return source(latex)
    except Exception:  # a formula that we cannot write must not cost the page: its source is shown
        return source(latex)
    return Formula(_lines(lines), latex, max((piece.width for piece in pieces(lines)), default=0.0))


def source(latex: str) -> Formula:
    """Return LaTeX as it stands."""
    return Formula(Markup('<pre class="raw"><code>{}</code></pre>').format(latex.strip("\n")), latex)


def _lines(lines: Iterable[Line]) -> Markup:
    written = []
    for line in lines:
        statements = [
            "".join(f'<math display="block">{piece.markup}</math>' for piece in statement) for statement in line
        ]
        written.append(f'<div class="line">{"".join(f"<div>{each}</div>" for each in statements)}</div>')
    return Markup("".join(written))


# -- tables ------------------------------------------------------------------------------------------------------------


def _cells(latex: str) -> list[Sequence[str]]:
    """Take a Markdown table's record apart again: header and rows."""
    return [tuple(row.split(" & ")) for row in latex.split(" \\\\\n")]


def _corrected_table(record: Record, read: Read) -> Formula | None:
    if not record.entries or not all(entry.correct for entry in record.entries):
        return None
    grid = [list(row) for row in _cells(record.latex)]
    for entry in record.entries:
        place = _place(entry, grid)
        if place is None:
            return None
        grid[place[0]][place[1]] = entry.correct
    return _table(record, grid, " \\\\\n".join(" & ".join(row) for row in grid), read, RIGHT, _places(record))


def _places(record: Record) -> set[tuple[int, int]]:
    grid = _cells(record.latex)
    return {place for entry in record.entries if (place := _place(entry, grid)) is not None}


def _place(entry: WrongEntry, grid: Sequence[Sequence[str]]) -> tuple[int, int] | None:
    """Return where an entry stands in the grid, its header row 0; one without a row stands in the header."""
    if entry.row is None:
        return next(((0, c) for c, header in enumerate(grid[0]) if header == entry.printed), None)
    inside = entry.column is not None and entry.row < len(grid) and entry.column <= len(grid[entry.row])
    return (entry.row, entry.column - 1) if inside and entry.column is not None else None


def _table(
    record: Record,
    grid: Sequence[Sequence[str]],
    latex: str,
    read: Read,
    mark: Mark,
    places: set[tuple[int, int]] | None = None,
) -> Formula:
    marked = places if places is not None else {p for e in record.entries if (p := _place(e, grid)) is not None}
    rows = []
    for r, cells in enumerate(grid):
        tag = "th" if r == 0 else "td"
        written = [_cell(tag, cell, read, mark if (r, c) in marked else None) for c, cell in enumerate(cells)]
        rows.append(Markup("<tr>{}</tr>").format(Markup("").join(written)))
    return Formula(Markup('<table class="claim">{}</table>').format(Markup("").join(rows)), latex, 6.0 * len(grid[0]))


def _content(cell: str, read: Read) -> Markup:
    if "\\" not in cell and _WORDS.search(cell):
        return escape(cell)
    plain = "\\" not in cell and _NAME.fullmatch(cell)
    return symbol(cell, read) if plain else math(cell, read) if cell.strip() else Markup("")


def _cell(tag: str, cell: str, read: Read, mark: Mark | None) -> Markup:
    content = _content(cell, read)
    scope = ' scope="col"' if tag == "th" else ""
    if mark is None:
        return Markup(f"<{tag}{scope}>{content}</{tag}>")
    told = f'<span class="sign" aria-hidden="true">{mark.sign}</span><span class="told">{look_up(mark.label)}</span>'
    return Markup(f'<{tag}{scope} class="{mark.kind}">{content} {told}</{tag}>')
