"""Rotations that the text has turn the axes, or clockwise, are not those that turn vectors."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

TURNED = "\\begin{bmatrix} \\cos\\theta & %s\\sin\\theta & 0 \\\\ %s\\sin\\theta & \\cos\\theta & 0 \\\\ 0 & 0 & 1 \\end{bmatrix}"
PAGE = "# Rotations\n\n%s\n\nNow\n\n$$ R_z(\\theta) = " + TURNED + " $$\n"


@pytest.mark.parametrize(
    "said",
    [
        "The matrix turns the axes, not the vectors.",
        r"The angle $\theta$ is counted clockwise, as on a compass.",
        "Les angles sont comptés dans le sens horaire.",
        "Elle fait passer des coordonnées dans l'ancienne base à celles dans la nouvelle base.",
        "In this text points are row vectors.",
        r"Un point a les coordonnées $X$ dans $R_0$ et $X'$ dans $R_1$.",
    ],
)
def test_a_transposed_rotation_may_be_meant(said: str) -> None:
    assert verify_text(PAGE % (said, "", "-")).equations[-1].verdict is Verdict.UNCHECKED


@pytest.mark.parametrize(
    "said",
    [
        "The angle is counted counterclockwise.",
        "The matrix turns vectors.",
        "Les angles sont comptés dans le sens trigonométrique.",
        "It leads from the coordinates in the new basis to those in the old one.",
    ],
)
def test_elsewhere_it_is_refuted_and_the_right_one_proved(said: str) -> None:
    assert verify_text(PAGE % (said, "", "-")).equations[-1].verdict is Verdict.REFUTED
    assert verify_text(PAGE % (said, "-", "")).equations[-1].verdict is Verdict.PROVED
