"""A wrong answer in which no slip of the pen is recognised is told how it relates to what is asked."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Formula, Number, Outcome, Quantity
from armproof.course.feedback.number_slips import values_in

_ANGLES = ("theta_1", "theta_2", "theta_3")
COSINE = Formula(r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", ("x", "y", "l_1", "l_2"))
SPEED = Formula(r"\frac{30(q_f - q_0) t^2 (t_f - t)^2}{t_f^5}", ("t", "q_0", "q_f", "t_f"))
SQUARE = Formula(r"l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2", ("theta_2", "l_1", "l_2"))
SLOPE = Formula(r"\sin\theta \cos\phi", ("theta", "phi"))
RADIUS = Formula(r"\sqrt{x^2 + y^2}", ("x", "y"))
VELOCITY = Formula(r"u \cos\theta - r w \sin\theta", ("r", "theta", "u", "w"), arm="polar_rp")
FACING = Formula(
    r"\operatorname{atan2}(y, x)", ("x", "y"), unit="rad",
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)"}, symbols={"rho": "free", "gamma": "free"},
)  # fmt: skip
INVERSE = Formula(
    r"\frac{1}{l_1 S_2} \begin{bmatrix} C_1 & S_1 \\ -l_1 S_1 & l_1 C_1 \end{bmatrix}",
    ("theta_1", "theta_2", "l_1"),
    arm="planar_2r",
)
LEAN = Formula(r"\operatorname{atan2}(l_1, l_2)", ("l_1", "l_2"), unit="rad")
AWAY = replace(FACING, latex=r"\operatorname{atan2}(y, -x)")
BENT = Formula(r"\arccos D", ("D",), given={"D": r"\cos(3\gamma)"}, symbols={"gamma": "free"}, unit="rad")
OUT = Formula(r"\sqrt{x^2 + y^2} - l_1", ("x", "y", "l_1"))
HEIGHT = Formula("l_1 S_1 + l_2 S_{12} + l_3 S_{123}", (*_ANGLES, "l_1", "l_2", "l_3"), arm="planar_3r")
COLUMN = Quantity("polar_rp", {"jacobian": 2, "rows": [1, 2], "columns": [2]})
TOOL = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
BENDING = Formula(r"l_1 l_2 C_3 (l_1 C_2 + l_2 S_{23})", ("theta_2", "theta_3", "l_1", "l_2"), arm="planar_3r")
TURRET = Formula(
    r"\begin{bmatrix} \operatorname{atan2}(y, x) \\ \operatorname{atan2}(z, \sqrt{x^2 + y^2}) \end{bmatrix}", ("x", "y", "z"), unit="rad",
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)"}, symbols={"rho": "free", "gamma": "free"},
)  # fmt: skip
LINK = Formula(
    r"\begin{bmatrix} C_1 & S_1 & 0 & -l_1 \\ -S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}", ("theta_1", "l_1"), arm="planar_2r",
)  # fmt: skip
LEVER = Quantity("planar_3r", {"difference": [3, 0]})
TURNED = Formula(
    r"\operatorname{atan2}(y, \sqrt{x^2 - y^2}) - \theta",
    ("x", "y", "theta"),
    given={"y": r"x \sin(3\gamma)"},
    symbols={"gamma": "free"},
    unit="rad",
)
AXIS = Quantity("planar_3r", {"difference": [3, 2]})
TURNING = Quantity("planar_3r", {"jacobian": 3, "rows": [6]})
COLUMN3 = Quantity("planar_3r", {"jacobian": 3, "rows": [4, 5, 6]})
DIFFERENCE = Formula(r"l_1 \sin(\theta_1 - \theta_2)", (*_ANGLES, "l_1"), arm="planar_3r")
OUTSIDE = Formula("x - (l_1 + l_2) y", ("x", "y", "l_1", "l_2"))
LEANING = Formula(r"\arctan\frac{l_1}{l_2} + x", ("l_1", "l_2", "x"), unit="rad")
SPREAD = Formula("(x l_1 + y + l_2) z", ("x", "y", "z", "l_1", "l_2"))
ANGLES = Number((0.6, 0.8), labels=("sin θ", "cos θ"))
BACK = Quantity("planar_3r", {"difference": [3, 2]})
ARMS = Number((0.25, 0.85), "m", ("nearest", "farthest"), {"l_1": 0.6, "l_2": 0.3})
PLACE = Number((0.0, 0.3, -0.4), labels=("x", "y", "z"))


def squared(answer: str) -> str:
    return rf"\left({answer}\right)^2"


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (COSINE, rf"\sqrt{{1 - {squared(COSINE.latex)}}}", "a sine stands where the cosine"),
        (COSINE, rf"\arccos\left({COSINE.latex}\right)", "your answer is the angle: its cosine is asked"),
        (COSINE, r"\frac{x^2 + y^2 - l_1 - l_2}{2 l_1 l_2}", "squares are missing"),
        (COSINE, r"\frac{x^2 + y^2 + l_1^2 + l_2^2}{2 l_1 l_2}", "wrong signs of terms 3 and 4"),
        (COSINE, r"\frac{x^2 - l_1^2 - l_2^2}{2 l_1 l_2}", "y is missing"),
        (SPEED, r"\frac{30(q_f - q_0) t^2 (t_f - t)}{t_f^5}", "a factor (t_f - t) is missing"),
        (COSINE, r"(x^2 + y^2 - l_1^2 - l_2^2) / 2 \cdot l_1 l_2", "does l_1 l_2 stand above the line where it belongs below?"),
        (SLOPE, r"-\cos\theta \sin\phi", "are exchanged, and the sign is wrong"),
        (RADIUS, r"1.002 \sqrt{x^2 + y^2}", "close, but a number in it is rounded"),
        (RADIUS, r"1.01 \sqrt{x^2 + y^2}", "1.01 times too large"),
        (SPEED, r"\frac{30 t^2 (t_f - t)^2}{t_f^5}", "q_0, q_f have no effect in your answer"),
        (SPEED, lambda t, q_0, q_f, t_f: q_0 + (q_f - q_0) * t / t_f, "the units do not fit: with twice"),
        (SQUARE, lambda theta_2, l_1, l_2: (l_1 + l_2 * np.cos(theta_2)) ** 2, "minus l_2^2 (sin \\theta_2)^2"),
        (SQUARE, r"l_1^2 + l_2^2 + 2 l_1 l_2 \cos^2\theta_2", "the exponent 2 is too large"),
        (SQUARE, r"\sqrt{l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2}", "your answer is the root"),
        (RADIUS, "(x^2 + y^2)", "your answer is the square of what is asked"),
        (RADIUS, r"\frac{1}{\sqrt{x^2 + y^2}}", "a quotient is upside down"),
        (SPEED, SPEED.latex.replace("30", "47"), "the number 47 is too large"),
        (RADIUS, "x", "y is missing: what is asked depends on it"),
        (VELOCITY, r"w \cos\theta - r u \sin\theta", "u and w are exchanged"),
        (FACING, r"\arccos\frac{x}{\sqrt{x^2 + y^2}}", "for some values only"),
        (INVERSE, INVERSE.latex.replace("l_1 S_2", "l_1 C_2"), "entries (1, 1), (1, 2), (2, 1), (2, 2): cosine for sine"),
        (TOOL, r"\begin{bmatrix} 0 \\ l_1 S_1 + l_2 S_{12} \end{bmatrix}", "what is asked is not zero"),
        (AWAY, r"\operatorname{atan2}(-x, y)", "the arguments of atan2 are exchanged"),
        (BENT, lambda D: np.arcsin(np.sqrt(1 - D**2)), "the sine is right, the angle is not"),
        (BENT, lambda D: -np.arccos(D), "sign"),
        (OUT, r"\sqrt{x^2 + y^2 - l_1^2}", "a term stands under the root that belongs outside"),
        (LEAN, r"\arcsin\frac{l_1}{l_2}", "arcsin where arctan belongs"),
        (LEAN, lambda l_1, l_2: 2 * np.arcsin(l_1 / l_2) - np.arcsin(l_1 / l_2), "the tangent of the angle is known"),
        (HEIGHT, "l_1 S_1 + l_2 S_2 + l_3 S_3", "each angle is taken as absolute"),
        (COLUMN, r"\begin{bmatrix} r \\ \sin\theta \end{bmatrix}", r"entry (1, 1): \theta is missing"),
        (COLUMN, r"\begin{bmatrix} \frac{1}{\cos\theta} \\ \sin\theta \end{bmatrix}", "entry (1, 1): a quotient is upside down"),
        (PLACE, [0, -0.3, -0.4], "the sign is wrong"),
        (PLACE, [0.3, 0, -0.4], "are exchanged"),
        (PLACE, [0.3, 0, 0.4], "their order and signs are not"),
        (PLACE, [0, 300, -400], "millimetres"),
        (PLACE, [0, 0.6, -0.8], "wrong by a factor of 2"),
        (Number((0.0, np.pi / 2)), [0, 90], "in degrees"),
        (Number((5, 4)), [5, 3], "one too few"),
        (Number((0.6435011, -1.5707963)), [0.64, -1.57], "right, but rounded"),
        (Number((0, 0, 1)), [0.6, 0.8, 0], "at right angles"),
        (Number((0, 0, 1)), [0, 1, 1], "a direction has the length 1"),
        (Formula(r"\frac{15 d}{8 k}", ("d", "k")), r"\frac{17 d}{8 k}", "the number 17 is too large"),
        (Formula("x^2 + y^2 - 2 x y", ("x", "y")), "x^2 + y^2 - 7 x y", "the number 7 is too large"),
        (Formula("20 x^3", ("x",)), "15 x^3", "the number 15 is too small"),
        (Formula("c^2 - (a - b)^2", ("a", "b", "c")), "c^2 - (a^2 - b^2)", "a square of a sum is taken term by term: the mixed term is missing"),
        (Number((6.0, 7.0, 1.0), "–", ("rows", "columns", "sheets")), [6, 1, 1], "columns is not 1: this is sheets"),
        (Number((0.75, 1.5), "m", ("near", "far"), {"a": 0.5, "b": 1.0}, steps=("", "a + b")), [0.75, 2.25], "far is not 2.25: near does not belong in it"),
        (Formula("20 x^3", ("x",)), "-15 x^3", "your answer is 1.333 times too small, and the sign is wrong"),
        (Number((0.75, 0.6)), [0.6, 0.6], "number 1 is not 0.6: this is number 2"),
        (Number((0.25, 0.8)), [0.25, 1.25], "numerator and denominator are exchanged"),
        (ARMS, [0.25, 0.55], "farthest is not 0.55: l_2 is missing"),
        (ARMS, [0.3, 0.85], "nearest is not 0.3: this is l_2 alone"),
        (ARMS, [0.85, 0.85], "nearest is not 0.85: l_1 does not belong in it"),
        (BENDING, r"l_1 l_2 C_3 (l_1 S_2 - l_2 C_{23})", "a quarter turn away"),
        (BENDING, r"l_1 l_2 C_3 (l_1 S_2 + l_2 C_{23})", "sine and cosine are exchanged in two places"),
        (Formula(r"l_1 \cos\theta + l_2 \sin\theta", ("theta", "l_1", "l_2")), r"l_1 \cos\theta - l_2 \sin\theta", "sign"),
        (RADIUS, "(x + y)", "a root of a sum of squares is taken term by term"),
        (TURRET, TURRET.latex.replace(r"\sqrt{x^2 + y^2}", "x"), "entry (2, 1): y is missing"),
        (SPEED, SPEED.latex.replace("30", r"\frac{1}{30}"), "a quotient is upside down"),
        (SPEED, SPEED.latex.replace("30", r"10 \sqrt{27}"), "your answer is √3 times too large"),
        (LEAN, r"\frac{l_1}{l_2}", "a quotient is the tangent of an angle"),
        (FACING, r"\operatorname{atan2}(-y, x)", "wrong sign"),
        (FACING, r"\frac{\pi}{2} - \operatorname{atan2}(x, -y)", "the sign of the angle is wrong"),
        (FACING, r"\arctan\frac{x}{y}", "the quotient in the arctangent is upside down"),
        (LINK, r"\begin{bmatrix} C_1 & -S_1 & 0 & -l_1 C_1 \\ S_1 & C_1 & 0 & -l_1 S_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
            "the rotation is that of the inverse: it is still to be transposed; the origin is that of the inverse, only negated"),
        (AXIS, r"\begin{bmatrix} l_3 C_{123} \\ l_3 S_{123} \\ l_3 \end{bmatrix}", "entry (3, 1): zero belongs there"),
        (LEVER, r"\begin{bmatrix} (l_1 + l_2 + l_3) C_{123} \\ (l_1 + l_2 + l_3) S_{123} \\ 0 \end{bmatrix}", r"entry (1, 1): l_3 C_{123} is right, l_1 C_{123} and l_2 C_{123} do not belong, 2 terms are missing"),
        (TURNED, r"\arcsin\frac{y}{x} - 2\theta", r"what is asked minus \theta"),
        (AXIS, lambda q, l_3: [l_3 * np.cos(q[0] + q[1] + q[2]), l_3 * np.sin(q[0] + q[1] + q[2]), l_3], "entry (3, 1): zero belongs there"),
        (TURNING, r"\begin{bmatrix} 1 & 1 & l_3 \end{bmatrix}", "entry (1, 3): what is asked does not depend on l_3"),
        (COLUMN3, r"\begin{bmatrix} 1 & 1 & 1 \\ 2 & 1 & 1 \\ 1 & 1 & 1 \end{bmatrix}", "entries (1, 1), (1, 2), (1, 3), (2, 1): zero belongs there"),
        (HEIGHT, "l_1 S_1 + l_2 S_{12} + l_3", "is missing"),
        (DIFFERENCE, r"l_1 \sin(\theta_1 + \theta_2)", r"wrong sign of angle \theta_2"),
        (DIFFERENCE, r"l_1 \sin(\theta_1 - \theta_2 + \theta_3)", r"angle \theta_3 does not belong"),
        (OUTSIDE, "x - l_1 + l_2 y", "brackets are missing"),
        (COSINE, r"x^2 + y^2 - l_1^2 - \frac{l_2^2}{2 l_1 l_2}", "brackets are missing"),
        (DIFFERENCE, r"l_1 (\sin\theta_1 - \sin\theta_2)", "a sine or cosine of a sum is taken term by term"),
        (DIFFERENCE, r"l_1 \sin(2\theta_1 - \theta_2)", "the factor 2 does not belong in the angle"),
        (OUT, "x + y - l_1", "a root of a sum of squares is taken term by term"),
        (COSINE, r"\frac{(x + y)^2 - l_1^2 - l_2^2}{2 l_1 l_2}", "the square of a sum stands where the sum of the squares belongs"),
        (SPEED, SPEED.latex.replace("(t_f - t)^2", "(t_f^2 + t^2)"), "a square of a sum is taken term by term"),
        (COSINE, r"\frac{2 l_1 l_2}{x^2 + y^2 - l_1^2 - l_2^2}", "a quotient is upside down"),
        (FACING, r"2 \operatorname{atan2}(y, -x) - \operatorname{atan2}(y, -x)", "its cosine has the wrong sign"),
        (LEANING, r"\operatorname{atan2}(l_1, -l_2) + x", "the sign of the second argument of atan2 is wrong"),
        (LEANING, r"\arccos\frac{l_1}{l_2} + x", "arccos where arctan belongs"),
        (Number(0.7, "m").told_in("at $0.3$ m and 0.4 m; 90°"), 0.12, "is this 0.3 · 0.4?"),
        (Number(0.7, "m").told_in("at $0.3$ m and 0.4 m; 90°"), 0.4, "0.4 is given for something else"),
        (Number((0.6435, -1.5707963), "rad", ("φ", "ψ")), [0.6, -1.5708], "φ is not 0.6"),
        (SPREAD, "x l_1 + y + l_2 z", "brackets are missing"),
        (OUTSIDE, "y (x - l_1 - l_2)", "brackets that are too wide"),
        (HEIGHT, "l_1 S_1 + l_2 S_1 S_2 + l_3 S_1 S_2 S_3", "products of sines or cosines stand"),
        (LEANING, r"\frac{l_1}{l_2} + x", "a quotient is the tangent of an angle"),
        (COSINE, r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2 l_1}", "does not belong"),
        (HEIGHT, lambda t1, t2, t3, a, b, c: a * np.sin(np.degrees(t1)) + b * np.sin(np.degrees(t1 + t2)) + c * np.sin(np.degrees(t1 + t2 + t3)), "turned into degrees"),
        (TOOL, lambda q, l_1, l_2: [l_1 * np.cos(q[0]) + l_2 * (np.cos(q[0]) + np.cos(q[1])), l_1 * np.sin(q[0]) + l_2 * np.sin(q[0] + q[1])],
            "entry (1, 1): a sine or cosine of a sum is taken term by term"),
        (PLACE, [0, 30, -40], "in centimetres?"),
        (Number(500.0, "m"), 5, "wrong by a factor of 100"),
        (Number(0.375, "m/s"), 0.38, "right, but rounded"),
        (Number(0.7, "m").told_in("at 0.3 m and 0.4 m"), 0.5, "this is the root of 0.3² + 0.4²"),
        (Number(0.72, "m").told_in("at 0.32 m and 0.4 m"), 0.1024, "is this 0.32 · 0.32?"),
        (Number((0.6435, -1.5708, -0.9273), "rad", ("α", "β", "γ")), [0.6435, -1.5708, -2.2143], "γ is not -2.2143: this is −α + β"),
        (ANGLES, [36.87, 0.8], "sin θ is not 36.87: this is the angle: its sine is asked"),
        (Number((0.3, 0.0), "m"), [0.3, 1], "number 2 is not 1: zero belongs there"),
        (Number(2.0, "rad/s"), "2 m/s", "m/s is not the unit: rad/s is asked for"),
        (BACK, r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}", "from the origin of frame 0 to that of frame 2, not from 2 to 3"),
    ],
)  # fmt: skip
def test_a_wrong_answer_is_told_how_it_relates_to_what_is_asked(asks: Any, answer: Any, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message


def test_a_letter_that_is_none_is_told_before_what_is_wrong_elsewhere() -> None:
    answer = r"\begin{bmatrix} l_1 C_1 + l_2 C_2 \\ l_1 S_1 + l_3 S_{12} \end{bmatrix}"
    assert "l_3 is no letter of this task" in TOOL.judge(answer).message
    assert "no letter" not in TOOL.judge(answer.replace("l_3", "l_2")).message


@pytest.mark.parametrize(
    ("asks", "answer"),
    [
        (RADIUS, "3 x + 2 y + x y^3 / y^3"),
        (RADIUS, lambda x, y: [1, 2, 3]),
        (RADIUS, lambda x, y: 1 / 0),
        (PLACE, [0.1, 0.37, -0.42]),
        (LINK, LINK.latex.replace("-l_1", "l_1 C_1 + 2 l_1 S_1")),
        (ANGLES, [0.61, 0.8]),
        (Number(0.375, "m/s"), 0.4),
        (Number(500.0, "m"), 11),
        (Number(0.7, "m").told_in("at 0.3 m and 0.4 m"), 0.13),
        (ARMS, [0.13, 0.71]),
        (Number((0, 0, 1)), [0.6, 0, 0.8]),
    ],
)
def test_what_has_no_simple_relation_is_told_none(asks: Any, answer: Any) -> None:
    feedback = asks.judge(answer)
    assert not feedback.is_right
    said = (
        "alone",
        "does not belong",
        "right angles",
        "length 1",
        "turn away",
        "square",
        "rounded",
        "units",
        "exchanged",
        "missing",
        "times",
        "plus",
        "minus",
        "root",
        "square of",
        "factor",
        "order",
    )
    assert [word for word in said if word in feedback.message] == []


def test_a_wrong_entry_is_not_told_in_letters_that_the_task_keeps_to_itself() -> None:
    feedback = TURRET.judge(TURRET.latex.replace(r"\sqrt{x^2 + y^2}", "x"))
    assert not {"rho", "gamma"} & set(feedback.message.replace("\\", " ").split())


def test_values_of_a_text_are_lengths_that_it_gives_to_letters() -> None:
    text = r"$a_1 = 0.4$ m, $d_1 + d_2 = 0.75$ m, $\theta_1 = 90°$, $\dot q_2 = 2$ rad/s, $x^2 = 3$"
    assert values_in(text) == {"a_1": 0.4, "d_1 + d_2": 0.75}


def test_a_number_that_is_only_rounded_is_not_called_wrong_beside_one_that_is() -> None:
    asked = Number((0.6435011, -1.5707963), "rad", ("φ", "ψ"))
    assert "ψ" not in asked.judge([0.6, -1.5708]).message
    assert "ψ" in asked.judge([0.643, -1.57]).message  # where all are rounded, that is what is said
