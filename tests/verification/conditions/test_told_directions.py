"""From where angles are counted, and which way, the text may tell otherwise than the arm has it that it names, or shows as a table."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

NAMED = "---\narm: planar_2r\n---\n\n"
TABLE = """Classic Denavit-Hartenberg parameters:

| $i$ | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |
|---|---|---|---|---|
| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |
| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |

"""


def verdict(arm: str, sentence: str, latex: str) -> Verdict:
    return verify_text(f"{arm}{sentence}\n\n$$ {latex} $$\n").equations[-1].verdict


@pytest.mark.parametrize("arm", [NAMED, TABLE], ids=["named", "table"])
@pytest.mark.parametrize(
    ("usual", "other"),
    [
        ("When all angles are zero, the arm points along $x_0$.", "When all angles are zero, the arm points along $y_0$."),
        ("At rest, all angles being zero, the arm lies along $x_0$.", "When both angles are zero, the arm hangs straight down."),
        (r"$\theta_1$ is the elevation of the first link above the horizontal.", r"$\theta_1$ is the angle of depression of the first link below the horizontal."),
    ],
)  # fmt: skip
def test_what_the_text_counts_otherwise_is_left_open(arm: str, usual: str, other: str) -> None:
    right, wrong = r"y = l_1 s_1 + l_2 s_{12}", r"y = -l_1 s_1 - l_2 s_{12}"
    assert verdict(arm, usual, right) is Verdict.PROVED
    assert verdict(arm, usual, wrong) is (
        Verdict.REFUTED if arm == NAMED else Verdict.UNCHECKED
    )  # or the table is wrong
    assert verdict(arm, other, right) is Verdict.UNCHECKED
    assert verdict(arm, other, wrong) is Verdict.UNCHECKED


def test_which_axis_points_down_is_the_arm_s_own() -> None:
    assert verdict(NAMED, "The axis $y_0$ points down.", r"y = l_1 s_1 + l_2 s_{12}") is Verdict.PROVED
