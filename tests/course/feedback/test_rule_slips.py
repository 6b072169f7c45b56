"""Brackets of an argument left out, a root astray and forgotten squares are named; of other numbers no root is said to be wrong."""

from __future__ import annotations

from typing import Any

import pytest

from armproof.course.feedback import Formula, Outcome, Quantity, open_lesson

PEAK = Formula(r"\frac{10}{\sqrt{3}} \cdot \frac{d}{t_f^2}", ("d", "t_f"))
BOUND = Formula(r"\frac{1}{2 b}", ("b",))
ELBOW = Formula(r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", ("x", "y", "l_1", "l_2"))
REACH = Formula("4 x^2 y^2 - (x^2 + y^2 - z^2)^2", ("x", "y", "z"))
OUT = Formula(r"\sqrt{x^2 + y^2} - a", ("x", "y", "a"))
RING = Formula("((a + b)^2 - x^2)(x^2 - (a - b)^2)", ("x", "a", "b"))
ANGLE = Formula(
    r"\arcsin\frac{K}{f} - b", ("K", "f", "b"), given={"K": r"f\sin(3\gamma)"}, symbols={"gamma": "free"}, unit="rad"
)
HALF = Formula(r"\sin\frac{\theta}{2}", ("theta",))
GAIN = Formula(r"\frac{x}{x^2 + y^2}", ("x", "y"))
ROT = r"\begin{bmatrix} C\phi C\theta & -S\phi & C\phi S\theta \\ S\phi C\theta & C\phi & S\phi S\theta \\ -S\theta & 0 & C\theta \end{bmatrix}"
RPY = open_lesson("tool_orientation").rpy.asks
SIDES = Formula(r"\operatorname{atan2}(z, y)", ("x", "y", "z"), unit="rad")
HEAD = Quantity({"dh": "modified", "rows": [{"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"}, {"alpha": "-pi/2", "a": "e", "d": 0, "theta": "theta_2"}],}, {"pose": 2})  # fmt: skip
TOOL = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
ALONG = Formula(r"u \cos(\alpha + \beta)", ("u", "alpha", "beta"))
FACING = Formula(r"\operatorname{atan2}(y, x)", ("x", "y"), unit="rad",
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)"}, symbols={"rho": "free", "gamma": "free"})  # fmt: skip
RATES = Formula(r"\begin{bmatrix} \frac{u C_1 + v S_1}{l_1 S_2} \\ u (l_1 C_1 + l_2 C_2) + v (l_1 S_1 + l_2 S_2) \end{bmatrix}",
    ("u", "v", "theta_1", "theta_2", "l_1", "l_2"), arm="planar_2r")  # fmt: skip


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (PEAK, r"10 \sqrt{3} \frac{d}{t_f^2}", "a root stands on the wrong side of the line"),
        (PEAK, r"\frac{10}{3} \cdot \frac{d}{t_f^2}", "a root is missing"),
        (PEAK, r"\frac{15}{8} \cdot \frac{d}{t_f^2}", "the number in front is wrong: "),
        (PEAK, r"\frac{d}{t_f^2}", "the number in front is missing"),
        (BOUND, r"\frac{1}{\sqrt{2} b}", "a root does not belong"),
        (BOUND, r"\frac{1}{4 b}", "the number 4 is too large"),
        (ELBOW, r"\frac{x + y - l_1^2 - l_2^2}{2 l_1 l_2}", "squares are missing"),
        (ELBOW, r"\frac{x^2 + y^2 - l_1 - l_2}{2 l_1 l_2}", "squares are missing"),
        (REACH, "4 x^2 y^2 - (x^2 + y^2 - z^2)", "a square is missing"),
        (RING, "((a + b) - x^2)(x^2 - (a - b))", "squares are missing"),
        (ANGLE, r"\frac{\arcsin K}{f} - b", "a part stands outside a function"),
        (HALF, r"\frac{\sin\theta}{2}", "a part stands outside a function"),
        (BOUND, r"\frac{2}{b}", "the number in front is upside down"),
        (GAIN, r"\frac{x}{\sqrt{x^2 + y^2}}", "a root does not belong"),
        (RPY, ROT, "the factor with \\psi is missing"),
        (OUT, "x^2 + y^2 - a", "a root is missing"),
        (SIDES, r"\operatorname{atan2}(z, x)", "x where y belongs"),
        (ALONG, r"u \cos\alpha + \beta", "brackets are missing: a part stands outside a function"),
        (TOOL, r"\begin{bmatrix} l_1 C_1 + l_2 \cos\theta_1 + \theta_2 \\ l_1 S_1 + l_2 \sin\theta_1 + \theta_2 \end{bmatrix}",
            "entries (1, 1), (2, 1): brackets are missing: a part stands outside"),
        (FACING, r"\operatorname{atan2}(-y, -x)", "half a turn off everywhere"),
        (FACING, r"\arctan(y/x)", "atan2"),
        (RATES, r"\begin{bmatrix} \frac{v C_1 + u S_1}{l_1 S_2} \\ v (l_1 C_1 + l_2 C_2) + u (l_1 S_1 + l_2 S_2) \end{bmatrix}", "u and v are exchanged"),
    ],
)  # fmt: skip
def test_a_broken_rule_is_named(asks: Any, answer: Any, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (PEAK, r"\frac{9}{\sqrt{3}} \cdot \frac{d}{t_f^2}", "root"),
        (BOUND, r"\frac{1}{4 b}", "root"),
        (ELBOW, r"\frac{x - y - l_1^2 - l_2^2}{2 l_1 l_2}", "squares are missing"),
        (ALONG, r"u \cos\alpha + u \beta", "brackets"),
        (FACING, r"\arctan(y/x)", "everywhere"),
        (BOUND, r"\frac{1}{3 b}", "in front is missing"),
    ],
)
def test_another_mistake_is_not_taken_for_it(asks: Any, answer: Any, words: str) -> None:
    assert words not in asks.judge(answer).message


def test_where_a_few_entries_are_wrong_two_explanations_are_told() -> None:
    pose = r"\begin{bmatrix} C_1 C_2 & -C_1 S_2 & -S_1 & e \\ S_1 C_2 & -S_1 S_2 & C_1 & 0 \\ -S_2 & -C_2 & 0 & h \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    message = HEAD.judge(pose).message
    assert "(1, 4)" in message
    assert "; or: the link matrices" in message


def test_angles_that_are_added_are_no_wrong_link() -> None:
    pose = r"\begin{bmatrix} C_{12} & -S_{12} & 0 & e C_1 \\ S_{12} & C_{12} & 0 & e S_1 \\ 0 & 0 & 1 & h \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    assert "are added, as in a planar arm" in HEAD.judge(pose).message
