"""Where a display stands in its file: between its own marks, whatever else is written there."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document
from armproof.verification.document.rewriting import change_of_cell
from armproof.verification.errors import DocumentError

TABLES = {
    "page.md": "---\narm: planar_2r\n---\n| $i$ | a | d |\n|---|---|---|\n| 1 | $l_1$ | 0 |\n",
    "page.tex": "% arm: planar_2r\n\\begin{tabular}{ccc}\n$i$ & a & d \\\\\n1 & $l_1$ & 0 \\\\\n\\end{tabular}\n",
}


def pieces(text: str, name: str = "page.md") -> list[list[tuple[int, int, int]]]:
    return [
        [(p.line, p.column, p.length) for p in display.pieces] for display in parse_document(Path(name), text).displays
    ]


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("$$ x $$ x $$ x $$\n", [[(1, 3, 1)], [(1, 13, 1)]]),  # what stands between two displays is no display
        ("$$ x = y $$\n\n$$\nx = y\n$$\n", [[(1, 3, 5)], [(4, 0, 5)]]),
        ("$$\nx\n= y\n$$\n", [[(2, 0, 1), (3, 0, 3)]]),
        ("$$\n  x\n   = y\n$$\n", [[(2, 2, 1), (3, 3, 3)]]),
        ("> $$ x = y $$\n", [[(1, 5, 5)]]),
        ("x $$ x $$", [[(1, 5, 1)]]),
    ],
)
def test_each_display_is_found_between_its_own_marks(text: str, places: list[list[tuple[int, int, int]]]) -> None:
    assert pieces(text) == places


@pytest.mark.parametrize("rows", [1, 2])
def test_a_tabular_has_a_header_and_a_row_at_least(rows: int) -> None:
    row = r" $i$ & $a_i$ \\" + "\n"
    document = parse_document(
        Path("page.tex"), "% arm: planar_2r\n\\begin{tabular}{cc}\n" + row * rows + "\\end{tabular}\n"
    )
    assert len(document.tables) == rows - 1


@pytest.mark.parametrize("text", ["Title", "Title\n=====", "", "\n", "=====\nTitle\n====="])
def test_a_title_alone_is_no_front_matter(text: str) -> None:
    document = parse_document(Path("page.rst"), text)
    assert (document.front, document.displays) == ({}, ())
    assert parse_document(Path("page.rst"), f"{text}\n\n:arm: scara\n").front == {"arm": "scara"}


@pytest.mark.parametrize("name", TABLES)
def test_each_cell_is_found_and_gets_dollars_where_it_needs_them(name: str) -> None:
    lines = TABLES[name].split("\n")
    (table,) = parse_document(Path(name), TABLES[name]).tables
    for row, texts in zip(table.pieces, (("i", "a", "d"), ("1", "l_1", "0")), strict=True):
        found = [(lines[p.line - 1][p.column : p.column + p.length], p.at) for p in row if p is not None]
        assert found == [(text, 0) for text in texts]
    changed = [
        change_of_cell(table, 1, column, text, in_notebook=False) for column, text in ((1, "l_2"), (2, "d_2"), (2, "5"))
    ]
    assert [change is not None and change.text for change in changed] == ["l_2", "$d_2$", "5"]
    assert change_of_cell(table, 7, 0, "l_2", in_notebook=False) is None


def test_a_format_is_one_that_is_read() -> None:
    assert len(parse_document(Path("page"), "$$ x = y $$", "md").displays) == 1
    with pytest.raises(DocumentError, match="pdf"):
        parse_document(Path("page.md"), "$$ x = y $$", "pdf")
