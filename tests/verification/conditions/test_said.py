"""What the text between displays says of letters: a meaning that serves until a display gives another."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"


def verdicts_of(*lines: str) -> list[str]:
    return [record.verdict.value for record in verify_text(FRONT + "\n".join(lines) + "\n").equations]


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        ("with $k = l_1 c_1$", "x = k + l_2 c_{12}", "proved"),
        ("with $k = l_1 c_1$", "x = k - l_2 c_{12}", "refuted"),
        ("with $k = l_1 c_1$", "x = k^2 l_2 - s_1", "unchecked"),  # no slip: the text may mean something else
        ("with $k$ of the figure", "x = k + l_2 c_{12}", "unchecked"),
        ("with $k = 2$", "x = k + l_2 c_{12}", "unchecked"),  # a number of the text is that of one case
        ("with $l_1 = l_2 c_1$", "x = l_1 c_1 + l_2 c_{12}", "proved"),  # l_1 has a meaning
        ("with $v = l_1 c_1$", "x = v + l_2 c_{12}", "unchecked"),  # v is usually a velocity
    ],
)
def test_a_letter_of_the_text_has_its_meaning(said: str, display: str, verdict: str) -> None:
    assert verdicts_of(f"{said}", f"$$ {display} $$")[-1] == verdict


def test_a_display_gives_a_letter_of_the_text_another_meaning() -> None:
    lines = ["$k = l_1 c_1$", "$$ k = l_1 s_1 $$", "$$ y = k + l_2 s_{12} $$", "$$ x = k + l_2 c_{12} $$"]
    assert verdicts_of(*lines) == ["defined", "proved", "refuted"]
