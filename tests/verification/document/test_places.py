"""Where a display stands in its file: between its own marks, whatever else is written there."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document


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
