"""What "its velocity" is said to be is of the point that the display above is of."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

TABLE = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n\nThe tool is at\n\n$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$\n\n"
ELBOW = "$$ x = l_1 c_1, \\quad y = l_1 s_1 $$\n\n"
RATE = "\n\n$$ \\dot x = -l_1 s_1 \\dot\\theta_1 $$\n"


@pytest.mark.parametrize(
    ("said", "rate", "verdict"),
    [
        ("The elbow is at\n\n" + ELBOW, "Its velocity has the component", Verdict.UNCHECKED),
        ("Le coude est en\n\n" + ELBOW, "Sa vitesse a la composante", Verdict.UNCHECKED),
        ("The end of the bar is at\n\n" + ELBOW, "Its speed along $x$:", Verdict.UNCHECKED),
        ("The elbow is at\n\n" + ELBOW, "The velocity of the tool has the component", Verdict.REFUTED),
        ("", "Its velocity has the component", Verdict.REFUTED),
    ],
)
def test_a_possessive_is_of_the_point_above(said: str, rate: str, verdict: Verdict) -> None:
    assert verify_text(TABLE + said + rate + RATE).equations[-1].verdict is verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("The joint between the two links runs on the circle", Verdict.UNCHECKED),
        ("Le coude, lui, reste sur un cercle :", Verdict.UNCHECKED),
        ("The tool runs on the circle", Verdict.REFUTED),
    ],
)
def test_what_another_point_runs_on_is_not_of_the_tool(said: str, verdict: Verdict) -> None:
    assert verify_text(f"{TABLE}{said}\n\n$$ x^2 + y^2 = l_1^2 $$\n").equations[-1].verdict is verdict
