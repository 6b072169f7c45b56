"""Of a wrong formula in which no slip is found it is said what is right in it; of a whole, what it is instead."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Formula, Number, Outcome, Quantity
from armproof.course.feedback.table import Table

COSINE = Formula(r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", ("x", "y", "l_1", "l_2"))
SWITCH = Formula(r"(1 - \sigma)\theta + \sigma d", ("sigma", "theta", "d"))
BENDING = Formula(r"l_1 l_2 C_3 (l_1 C_2 + l_2 S_{23})", ("theta_2", "theta_3", "l_1", "l_2"), arm="planar_3r")
GAIN = Formula(r"\frac{x}{x^2 + y^2}", ("x", "y"))
TOOL = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
JACOBIAN = Quantity("planar_3r", {"jacobian": 3})
CRANE: dict[str, Any] = {"dh": "modified", "rows": [
    {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"}, {"alpha": "-pi/2", "a": "b", "d": 0, "theta": "theta_2"},
    {"alpha": "pi/2", "a": 0, "d": "d_3", "theta": 0}]}  # fmt: skip
END = Quantity(CRANE, {"origin": 3})
POSE, X, Y = Quantity("scara_modified", {"pose": 4}), "a_2 C_1 + a_3 C_{12}", "a_2 S_1 + a_3 S_{12}"
EXCHANGED = Formula("-C_1 S_2", ("theta_1", "theta_2"), arm="planar_2r")
FLAT = r"\begin{bmatrix} b C_1 + d_3 C_{12} \\ b S_1 + d_3 S_{12} \\ h \end{bmatrix}"
_V = r"-l_1 S_1 - l_2 S_{12} - l_3 S_{123} & -l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123}"


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (SWITCH, r"\sigma(\theta + d)", r"\sigma d is right, \sigma \theta has the wrong sign, one term is missing"),
        (SWITCH, r"\sigma\theta d", "a sum of 3 terms, and your answer is none of them"),
        (COSINE, r"\frac{x^2 + y^2 - l_1^2 - l_1 l_2}{2 l_1 l_2} + \frac{x}{y}", "x^2 / (2 l_1 l_2), y^2 / (2 l_1 l_2) and -l_1^2 / (2 l_1 l_2) are right"),
        (BENDING, "l_1 l_2 S_2 S_3 (l_1 S_2 + l_2 C_2)", "l_1 and l_2 are right, S_2, S_3 and (l_1 S_2 + l_2 C_2) do not belong"),
        (GAIN, r"\frac{x - y}{x^2}", "a single term, and none of your 2 terms is it"),
        (TOOL, r"\begin{bmatrix} l_1 C_1 l_2 C_{12} \\ l_1 S_1 l_2 S_{12} \end{bmatrix}", "the terms are multiplied"),
        (END, FLAT, r"\theta_1 and \theta_2 are added, as in a planar arm"),
        (END, lambda q, h, b: [b * np.cos(q[0]) + q[2] * np.cos(q[0] + q[1]), b * np.sin(q[0]) + q[2] * np.sin(q[0] + q[1]), h], "as in a planar arm"),
        (POSE, r"\begin{bmatrix} C_{123} & -S_{123} & 0 & A \\ S_{123} & C_{123} & 0 & B \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}".replace("A", X).replace("B", Y),
            "(1, 1), (1, 2), (2, 1), (2, 2): index 3 where 4 belongs"),
        (JACOBIAN, rf"\begin{{bmatrix}} {_V} \\ 0 & 0 & 0 \end{{bmatrix}}", "rows 1 to 3 of what is asked"),
        (JACOBIAN, rf"\begin{{bmatrix}} {_V} \\ 1 & 1 & 1 \end{{bmatrix}}", "rows 1, 2, 6 of what is asked"),
        (TOOL, r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}", "rows 1 to 2 of your answer are right"),
        (TOOL, lambda q, l_1, l_2: [l_1 * np.cos(q[0]) + l_2 * np.cos(q[0] + q[1])], "row 1 of what is asked"),
        (TOOL, r"\begin{bmatrix} l_1 C_1 + l_2 C_{23} \\ l_1 S_1 + l_2 S_{12} \end{bmatrix}", "index 3 where 1 belongs"),
        (END, r"\begin{bmatrix} (b + d_3 S_2) C_1 \\ (b - d_3 S_{23}) C_1 \\ h + d_3 C_2 \end{bmatrix}", "no joint angle 3"),
        (Number((0.4, 0.3), "m"), [0.4, 0.31], "number 2 is not 0.31: too large by less than a tenth: a slip in the reckoning?; all else is right"),
        (Number((0.4, 0.3, 0.1), "m"), [0.43, 0.3, 0.07], "number 1: too large by less than a tenth: a slip in the reckoning?; number 3: too small, but more than half"),
        (Number(-1.0), 2, "wrong by a factor of 2, and in sign"),
        (Number(2.0, "rad/s"), 2000, "wrong by a factor of 1000"),
        (Table(CRANE, "modified"), [(0, 0, "h", "theta_1"), ("pi", "b", 0, "theta_2"), ("pi/2", 0, "d_3", 0)], "row 2: alpha is wrong (a quarter turn off)"),
    ],
)  # fmt: skip
def test_a_wrong_answer_is_told_what_is_right_in_it(asks: Any, answer: Any, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (
            TOOL,
            r"\begin{bmatrix} l_1 C_1 - l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \end{bmatrix}",
            "planar arm",
        ),  # it is one
        (END, r"\begin{bmatrix} (b + d_3 S_2) C_1 \\ (b + d_3 S_2) S_1 \\ h - d_3 C_2 \end{bmatrix}", "planar arm"),
        (JACOBIAN, rf"\begin{{bmatrix}} {_V.replace('-l_1', 'l_1')} \\ 0 & 0 & 0 \end{{bmatrix}}", "right, but"),
        (Number((0.4, 0.3, 0.1), "m"), [0.43, 0.3, 0.07], "all else"),
        (Number(2.0, "rad/s"), 2000, "millimetres"),
        (EXCHANGED, "S_1 C_2", "S_{12}"),
    ],
)
def test_nothing_is_told_that_is_not_so(asks: Any, answer: Any, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words not in feedback.message
