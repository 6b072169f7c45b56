"""Values and units that stand in the text behind a formula belong to it."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import read_document
from armproof.verification.document.units import with_unit


@pytest.mark.parametrize(
    ("latex", "behind", "whole"),
    [
        (r"\theta_1 = 30", "° and", r"\theta_1 = 30^\circ"),
        (r"\theta_1 = 30", r"~degrees", r"\theta_1 = 30^\circ"),
        (r"\theta_1 = 30", r"\,\degree", r"\theta_1 = 30^\circ"),
        (r"\theta_1", " = -45°, ", r"\theta_1 = -45^\circ"),
        ("l_1", " = 250 mm", r"l_1 = 250\,\text{mm}"),
        ("l_1 = 0.5", " m long", "l_1 = 0.5"),
        ("l_1 = 0.5", " more", "l_1 = 0.5"),
        (r"\theta_1", " is 30°", r"\theta_1"),
        (r"l_1 c_1 + 2", " degrees of freedom", "l_1 c_1 + 2"),
        (r"n = 2", " degrés de liberté", "n = 2"),
        (r"\theta_1 = \theta_2", " = 30°", r"\theta_1 = \theta_2"),
        (r"\theta_1 = 30", r" and $\theta_2 = 60$ degrees", r"\theta_1 = 30^\circ"),
        (r"\theta_1 = 30", r", $\theta_2 = 60$ et $\theta_3 = 10$ degrés", r"\theta_1 = 30^\circ"),
        (r"\theta_1 = 30", r", $\theta_2 = 60$ (in degrees).", r"\theta_1 = 30^\circ"),
        (r"\theta_1 = 1.57", " (in degrees 90)", r"\theta_1 = 1.57"),
        (r"\theta_1 = 30", r" and $d_3 = 60$; degrees", r"\theta_1 = 30"),
        ("d_3 = 2", r" and $\theta_2 = 60$ degrees", "d_3 = 2"),
        ("l_1 = 30", r" and $l_2 = 20$ cm", r"l_1 = 30\,\text{cm}"),
    ],
)
def test_a_formula_has_the_value_and_the_unit_of_the_text_behind_it(latex: str, behind: str, whole: str) -> None:
    assert with_unit(latex, behind) == whole


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.md", "For $\\theta_1 = 30$° and $l_1$ = 250 mm:\n\n$$x = 1$$\n"),
        (
            "a.tex",
            "\\begin{document}\nFor $\\theta_1 = 30$~degrees and $l_1$ = 250 mm:\n\\[x = 1\\]\n\\end{document}\n",
        ),
        ("a.rst", "For :math:`\\theta_1 = 30`\u00b0 and :math:`l_1` = 250 mm:\n\n.. math:: x = 1\n"),
    ],
)
def test_every_format_reads_them(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    (display,) = read_document(tmp_path / name).displays
    assert display.said[:2] == (r"\theta_1 = 30^\circ", r"l_1 = 250\,\text{mm}")
