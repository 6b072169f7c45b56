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


@pytest.mark.parametrize(("sign", "verdict"), [("+", "proved"), ("-", "refuted")])
def test_the_text_behind_displays_tells_their_letters(sign: str, verdict: str) -> None:
    lines = ["$$ x = \\rho c_1 - \\sigma s_1 $$", "", f"$$ y = \\rho s_1 {sign} \\sigma c_1 $$", "", "where $\\rho = l_1 + l_2 c_2$ and $\\sigma = l_2 s_2$."]  # fmt: skip
    assert verdicts_of(*lines) == ["proved", verdict]


def test_what_stands_under_another_heading_tells_nothing_of_the_displays_above() -> None:
    lines = ["$$ x = \\rho c_1 $$", "## Next", "where $\\rho = l_1 + l_2 c_{12}$", "$$ p_1 = \\rho $$"]
    assert verdicts_of(*lines)[0] == "unchecked"


def test_a_letter_that_the_display_gives_a_meaning_has_that() -> None:
    lines = ["$$ \\rho = l_1 s_1 \\\\ y = \\rho + l_2 s_{12} $$", "where $\\rho = l_1 c_1$"]
    assert verdicts_of(*lines) == ["proved"]
