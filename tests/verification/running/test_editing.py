"""A document while it is edited: each verdict at its place in the text, in each format, and a text that cannot be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document.rewriting import rewrite
from armproof.verification.running.editing import EditedDocument, Mark

RIGHT = "$$ p_2 = [l_1 C_1 + l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$"
WRONG = RIGHT.replace("+ l_2 C_{12}", "- l_2 C_{12}")
FRONT = "---\narm: planar_2r\n---\n\n"


def marks(edited: EditedDocument, text: str) -> list[Mark]:
    """Return what is said of a text, once it is checked."""
    for _ in edited.update(text):
        pass
    return list(edited.marks())


@pytest.mark.parametrize(
    ("name", "head", "mark"),
    [
        ("a.md", FRONT, ""),
        ("a.tex", "% arm: planar_2r\n", ""),
        ("a.py", "# %% [markdown]\n# ---\n# arm: planar_2r\n# ---\n", "# "),
    ],
)
def test_a_wrong_entry_has_its_place_and_its_mending_in_each_format(name: str, head: str, mark: str) -> None:
    edited = EditedDocument(Path(name))
    text = f"{head}{mark}\n{mark}α {WRONG}\n"
    (found,) = marks(edited, text)
    (line, start), (last, end) = found.start, found.end
    assert line == last == head.count("\n") + 2 and found.fails
    assert text.split("\n")[line - 1][start:end] == "l_1 C_1 - l_2 C_{12}"
    mended = rewrite(Path(name).suffix, text, edited.fix(line))
    assert "l_1 C_1 + l_2 C_{12}" in mended and marks(edited, mended) == []
    assert edited.fix(line) == []
    assert "claim, proved: origin of frame 2 in frame 0" in edited.hover(line) and edited.hover(1) == ""


def test_a_text_that_cannot_be_checked_is_told_and_so_is_its_mending() -> None:
    edited = EditedDocument(Path("a.md"))
    (found,) = marks(edited, FRONT.replace("planar_2r", "nowhere") + RIGHT)
    assert "no arm 'nowhere'" in found.message and found.start[0] == 2
    assert marks(edited, FRONT + RIGHT) == []


def test_what_is_left_for_a_newer_text_is_checked_then() -> None:
    edited = EditedDocument(Path("a.md"))
    text = FRONT + "\n\n".join([WRONG, RIGHT, WRONG])
    left = edited.update(text)
    next(left)
    assert [found.start[0] for found in edited.marks()] == [5]
    left.close()
    assert [found.start[0] for found in marks(edited, text)] == [5, 9]
