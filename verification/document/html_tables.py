"""Tables of HTML in a Markdown text: header and rows of LaTeX, indices that stand in <sub> and <sup> among them."""

from __future__ import annotations

from html.parser import HTMLParser

_SCRIPTS = {"sub": "_{", "sup": "^{"}


class _Reader(HTMLParser):
    """Gathers the cells of each table; `rows` of the one that is open, a merged cell makes it none."""

    def __init__(self) -> None:
        super().__init__()
        self.tables: list[tuple[int, list[list[str]]]] = []
        self.rows: list[list[str]] = []
        self.line = 0
        self.is_merged = self.in_cell = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Begin a table, a row, a cell or an index."""
        if tag == "table":
            self.rows, self.is_merged, self.line = [], False, self.getpos()[0]
        elif tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th") and self.rows:
            self.is_merged = self.is_merged or any(
                name in ("colspan", "rowspan") and value != "1" for name, value in attrs
            )
            self.rows[-1].append("")
            self.in_cell = True
        elif tag in _SCRIPTS:
            self.handle_data(_SCRIPTS[tag])

    def handle_endtag(self, tag: str) -> None:
        """End one; a table with what was read."""
        if tag in ("td", "th"):
            self.in_cell = False
        elif tag in _SCRIPTS:
            self.handle_data("}")
        elif tag == "table" and not self.is_merged:
            self.tables.append((self.line, [row for row in self.rows if row]))

    def handle_data(self, data: str) -> None:
        """Add to the cell that is open."""
        if self.in_cell:
            self.rows[-1][-1] += data


def read_html_tables(content: str) -> list[tuple[int, tuple[tuple[str, ...], ...]]]:
    """Return the tables of a block of HTML without merged cells, each with its line in it (from 1) and its rows."""
    reader = _Reader()
    reader.feed(content)
    found = [
        (line, tuple(tuple(" ".join(cell.replace("$", " ").split()) for cell in row) for row in rows))
        for line, rows in reader.tables
    ]
    return [(line, rows) for line, rows in found if len(rows) > 1]
