"""A task takes an answer in whatever form it is given, and says what is wrong in it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp

from armproof.course.feedback import (
    AnswerError,
    Choice,
    Formula,
    Number,
    Outcome,
    Quantity,
    Table,
    Task,
    WithSympy,
    Wrong,
    open_lesson,
)
from armproof.course.feedback.answer import as_latex

L_1, L_2, T_1, T_2 = sp.symbols("l_1 l_2 theta_1 theta_2")


def tool(q: Any, l_1: Any, l_2: Any) -> Any:
    return [l_1 * np.cos(q[0]) + l_2 * np.cos(q[0] + q[1]), l_1 * np.sin(q[0]) + l_2 * np.sin(q[0] + q[1])]


def at_the_arms_lengths(theta_1: float, theta_2: float) -> list[float]:
    lengths = POSITION.loaded.lengths
    return tool([theta_1, theta_2], lengths["l_1"], lengths["l_2"])


POSITION = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
REACH = Formula(
    r"\arccos D", ("x", "y", "l_1", "l_2"), given={"D": r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}"}, unit="rad"
)
COSINE = Formula(r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", ("x", "y", "l_1", "l_2"))
DETERMINANT = Formula(
    r"\det J_v",
    ("theta_1", "theta_2", "l_1", "l_2"),
    arm="planar_2r",
    quantities={"J_v": {"jacobian": 2, "rows": [1, 2]}},
)
DAMPED = Formula(r"\frac{1}{2\lambda}", ("lambda",))
SUM_OF_ANGLES = Formula(r"l_1 \sin(\theta_1 + \theta_2)", ("theta_1", "theta_2", "l_1"))
ANGLE = Formula(
    r"\beta", ("X", "Y"), given={"X": r"\rho\cos\beta", "Y": r"\rho\sin\beta"}, symbols={"rho": "free"}, unit="rad"
)
POINT = sp.Matrix([L_1 * sp.cos(T_1) + L_2 * sp.cos(T_1 + T_2), L_1 * sp.sin(T_1) + L_2 * sp.sin(T_1 + T_2)])
LATEX = r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \end{bmatrix}"


def task(asks: Any, *wrong: Wrong) -> Task:
    return Task("name", "Title", "Text", asks, ("nudge", "method"), (), wrong)


@pytest.mark.parametrize(
    ("asks", "answer"),
    [
        (POSITION, tool),
        (POSITION, at_the_arms_lengths),
        (POSITION, POINT),
        (POSITION, WithSympy(lambda _: sp.expand_trig(POINT))),
        (POSITION, [POINT[0], POINT[1]]),
        (POSITION, LATEX),
        (POSITION, f"$$ p = {LATEX} $$"),
        (COSINE, r"\frac{x^2 + y^2 - (l_1^2 + l_2^2)}{2 l_1 l_2}"),
        (COSINE, lambda x, y, l_1, l_2: (x**2 + y**2 - l_1**2 - l_2**2) / (2 * l_1 * l_2)),
        (COSINE, lambda x, y, a, b: ((x * x + y * y) / a - a - b * b / a) / (2 * b)),
        (COSINE, "(x**2 + y^2 - l_1**2 - l2^2) / (2*l_1*l_2)"),
        (COSINE, lambda y, x, l_2, l_1: (x**2 + y**2 - l_1**2 - l_2**2) / (2 * l_1 * l_2)),
        (POSITION, "[l1*cos(theta1) + l2*cos(theta1 + theta2); l1*np.sin(theta1) + l2*sin(theta1 + theta2)]"),
        (POSITION, ["l_1 c_1 + l_2 c_{12}", r"l_1 \sin\theta_1 + l_2 s_{12}"]),
        (POSITION, r"\begin{bmatrix} l_1c_1+l_2c_{12} \\ l_1s_1+l_2s_{12} \end{bmatrix}"),
        (DETERMINANT, "l_1l_2s_2"),
        (DETERMINANT, "l1l2s2"),
        (Table("planar_2r", "classic"), [("q_1", 0, "l_1", 0), ("q_2", 0, "l_2", 0)]),
        (Number(-1), "−1"),
        (Formula(r"\mathbf{Rot}_z(\theta)", ("theta",)), r"\mathbf{Rot}_z(\frac{\theta}{2}) \mathbf{Rot}_z(\frac{\theta}{2})"),
        (DAMPED, "1/(2*lambda)"),
        (DAMPED, 1 / (2 * sp.Symbol("lamda"))),
        (ANGLE, r"\operatorname{atan2}(Y, X)"),
        (REACH, r"\arccos D"),
        (REACH, lambda x, y, a, b: math.acos((x * x + y * y - a * a - b * b) / (2 * a * b))),
        (DETERMINANT, "l_1 l_2 s_2"),
        (DETERMINANT, lambda t1, t2, a, b: a * b * (math.sin(t1 + t2) * math.cos(t1) - math.cos(t1 + t2) * math.sin(t1))),
        (Table("planar_2r", "classic"), [("theta_1", 0, "l_1", 0), {"a": "l_2", "alpha": 0, "d": 0, "theta": "theta_2"}]),
        (Table("planar_2r", "classic"), r"\begin{array}{cccc} \theta_1 & 0 & l_1 & 0 \\ \theta_2 & 0 & l_2 & 0 \end{array}"),
        (Number(2), 2),
        (Number(2.5, "m"), "2,5"),
        (Number(500.0, "m"), "0.5 km"),
        (Number(0.375, "m/s"), "0,375 m/s"),
        (Number((0.25, -0.1), "m"), "250 mm, -10 cm"),
        (Number((0.0, 2.0), "m"), "x = 0, y = 2"),
        (Number((0.0, 2.0), "m"), [[0], [2]]),
        (Number((math.pi / 2, 0.0), "rad"), "90°, 0°"),
        (Number((-math.pi / 2, 0.4), "rad"), ["-pi/2", 0.4]),
        (Formula(r"\begin{bmatrix} \theta_1 \\ \pi \end{bmatrix}", ("theta_1",), unit="rad"), r"\begin{bmatrix} \theta_1 + 4\pi \\ -\pi \end{bmatrix}"),
        (Number((0.0, math.pi / 2)), "[0, pi/2]"),
        (Number((0.0, 2.0)), "0 2"),
        (Choice({"1": "one", "2": "two"}, "2"), 2),
        (Choice({"a": "one", "b": "two", "c": "three"}, frozenset("ab")), "A and b"),
        (Number((1.0, math.pi)), [1, math.pi]),
        (Choice({"a": "one", "b": "two"}, "b"), " b "),
        (Choice({"a": "one", "b": "two", "c": "three"}, frozenset("ab")), ["b", "a"]),
    ],
)  # fmt: skip
def test_every_form_of_a_right_answer_is_proved(asks: Any, answer: Any) -> None:
    assert task(asks).check(answer).outcome is Outcome.PROVED


def test_an_angle_counts_up_to_whole_turns() -> None:
    feedback = task(ANGLE).check(lambda X, Y: np.angle(X + 1j * Y) % (2 * np.pi))
    assert feedback.outcome is Outcome.CONFIRMED
    assert task(ANGLE).check(lambda X, Y: np.angle(X + 1j * Y) % (np.pi / 2)).outcome is Outcome.WRONG


def test_what_branches_on_values_is_confirmed_and_says_so() -> None:
    def branching(x: float, y: float, a: float, b: float) -> float:
        return (x * x + y * y - a * a - b * b) / (2 * a * b) if x > 0 else 0.0

    feedback = task(COSINE).check(branching)
    assert feedback.outcome is Outcome.CONFIRMED
    assert "not proved" in feedback.message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (POSITION, lambda q: tool(np.deg2rad(q), 0.45, 0.33), ""),
        (POSITION, LATEX.replace("S_{12}", "S_2"), "entry (2, 1): index 1 is missing"),
        (POSITION, LATEX.replace("+ l_2 C", "- l_2 C"), "entry (1, 1): wrong sign"),
        (COSINE, r"\frac{x^2 + y^2 + l_1^2 - l_2^2}{2 l_1 l_2}", ""),
        (
            COSINE,
            lambda x, y, a, b: x * x if x > 0 else y,
            "l_1, l_2 have no effect in your answer: what is asked depends on them",
        ),
        (DETERMINANT, lambda t1, t2, a, b: a * b * math.cos(t2), "cosine for sine"),
        (Table("planar_2r", "classic"), [("theta_1", 0, "l_2", 0), ("theta_2", 0, "l_1", 0)], "a"),
        (Table("planar_2r", "classic"), [("theta_1", 0, "l_1", 0)], "2 rows"),
        (COSINE, r"\pm\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", "which of the two signs"),
        (POSITION, np.zeros(2), "the values for one case"),
        (POSITION, r"\begin{bmatrix} l_1 C_1 \end{bmatrix}", "the result is"),
        (ANGLE, r"\arctan\frac{Y}{X}", "`atan2` keeps the quadrant"),
        (ANGLE, lambda X, Y: math.degrees(math.atan2(Y, X)), "in degrees"),
        (DETERMINANT, lambda theta_1, theta_2, l_1, l_2: l_1 * l_2 * np.sin(np.radians(theta_2)), "taken as degrees"),
        (DAMPED, r"\lambda", r"your answer is 2 \lambda^2 times what is asked"),
        (Choice({"a": "one", "b": "two"}, "b"), "a, b", "one of them is asked for"),
        (Number(2), 3, "is not 3"),
        (Number(1500.0, "m"), "1,500", "one number, not 2"),
        (Number(0.25, "m"), "250 cm", "is not 2.5"),
        (
            Formula(r"\begin{bmatrix} \theta_1 \\ \pi \end{bmatrix}", ("theta_1",), unit="rad"),
            r"\begin{bmatrix} \theta_1 + \pi \\ \pi \end{bmatrix}",
            "entry (1, 1)",
        ),
        (
            Formula(r"\begin{bmatrix} \theta_1 \\ \pi \end{bmatrix}", ("theta_1",), unit="rad"),
            r"\begin{bmatrix} \theta_1 \\ 180 \end{bmatrix}",
            "entry (2, 1): in degrees?",
        ),
        (Formula(r"\theta_1", ("theta_1",), unit="rad/s"), r"\theta_1 + 2\pi", "does not belong"),
        (Number((1.0, 2.0)), 1, "2 numbers"),
        (Choice({"a": "one", "b": "two"}, "b", {"a": "one is too few"}), "a", "one is too few"),
        (Choice({"a": "one", "b": "two", "c": "three"}, frozenset("ab")), "a", "there is more"),
    ],
)
def test_a_wrong_answer_is_told_why(asks: Any, answer: Any, words: str) -> None:
    feedback = task(asks).check(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message
    assert "should be" not in feedback.message


@pytest.mark.parametrize("asks", [POSITION, COSINE, Table("planar_2r", "classic"), Number(1), Choice({"a": ""}, "a")])
@pytest.mark.parametrize("nothing", [None, ..., "", " … ", [], [None, None]])
def test_no_answer_is_not_attempted(asks: Any, nothing: Any) -> None:
    assert task(asks).check(nothing).outcome is Outcome.NOT_ATTEMPTED


@pytest.mark.parametrize("asks", [POSITION, COSINE])
def test_a_stub_is_not_attempted(asks: Any) -> None:
    def stub(*values: Any) -> None:
        raise NotImplementedError

    assert task(asks).check(stub).outcome is Outcome.NOT_ATTEMPTED
    assert task(asks).check(lambda *values: None).outcome is Outcome.NOT_ATTEMPTED


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (POSITION, "p_2", "may not name p_2"),
        (POSITION, r"T^0_2 + \Xi", "may not name"),
        (POSITION, r"\begin{bmatrix} p_x \\ p_y \end{bmatrix}", "may not name p_x"),
        (POSITION, r"f(q)", "may not name f"),
        (DETERMINANT, r"\det J_v", "may not name J_v"),
        (POSITION, r"\frac{l_1", "cannot be read at character"),
        (POSITION, "k_7 l_1", "the letters are theta_1, theta_2, l_1, l_2"),
        (POSITION, {"x": 1}, "is no formula"),
        (POSITION, "x" * 30_000, "too long"),
        (POSITION, np.zeros((2, 2, 2)), "not an array of more dimensions"),
        (COSINE, "\\begin{bmatrix}".replace("\\b", "\b"), 'write r"'),
        (SUM_OF_ANGLES, r"l_1 \sin\theta_{12}", r"write \theta_1 + \theta_2 for \theta_{12}"),
        (COSINE, "k + x", "k is no letter of this task; the letters are x, y, l_1, l_2"),
        (COSINE, r"\sqrt{x^2 + Z^2}", "Z is no letter of this task; the letters are x, y, l_1, l_2"),
        (ANGLE, r"\beta", "is no letter of this task; the letters are X, Y"),
        (DETERMINANT, "l_1 l_2 s_2 = 0", "without = 0"),
        (
            Table("planar_2r", "classic"),
            [("theta_1", 0, "L", 0), ("theta_2", 0, "l_2", 0)],
            "row 1: a: there is no letter L",
        ),
        (Table("planar_2r", "classic"), [("theta_1", 0, None, 0), ("theta_2", 0, "l_2", 0)], "row 1: a is empty"),
        (COSINE, lambda x, y: x, "4 arguments: x, y, l_1, l_2"),
        (COSINE, lambda x, y, a, b: x / 0, "ZeroDivisionError in line"),
        (COSINE, lambda x, y, a, b: "text", ""),
        (Table("planar_2r", "classic"), [("theta_1", 0)], "row 1 is to hold 4 entries: theta, d, a, alpha"),
        (Table("planar_2r", "classic"), [{"a": 0}], "row 1 has no 'theta'"),
        (Number(1), "a few", "is a number"),
        (Number((6.0, 5.0)), "6 or 5", "is a list of 2 numbers"),
        (Number(2.0), "not 2", "is a number"),
        (Choice({"a": "one", "b": "two"}, "b"), "z", "the options are 'a', 'b'"),
    ],
)
def test_what_cannot_be_judged_says_what_is_expected(asks: Any, answer: Any, words: str) -> None:
    feedback = task(asks).check(answer)
    assert feedback.outcome is Outcome.ERROR
    assert words in feedback.message


@pytest.mark.parametrize(
    "rows", [("0 & v_3 & v_2", "v_3 & 0 & v_1", "v_2 & v_1 & 0"), ("v_1 & 0 & 0", "0 & v_2 & 0", "0 & 0 & v_3")]
)
def test_the_letters_of_an_answer_mean_what_the_task_says(rows: tuple[str, ...]) -> None:
    skew = Formula(
        r"\begin{bmatrix} 0 & -v_3 & v_2 \\ v_3 & 0 & -v_1 \\ -v_2 & v_1 & 0 \end{bmatrix}", ("v_1", "v_2", "v_3")
    )
    assert (
        skew.judge(rf"\begin{{bmatrix}} {rows[0]} \\ {rows[1]} \\ {rows[2]} \end{{bmatrix}}").outcome is Outcome.WRONG
    )
    length = Formula("1", ("k_x", "k_y", "k_z"))
    assert length.judge("k_x^2 + k_y^2 + k_z^2").outcome is Outcome.WRONG


def test_a_table_is_not_wrong_for_an_angle_in_decimals() -> None:
    crane = Table({"dh": "classic", "rows": [{"theta": "theta_1", "d": "h", "a": 0, "alpha": "pi/2"}]}, "classic")
    assert crane.judge([("theta_1", "h", 0, 1.5708)]).outcome is Outcome.LETTERS
    assert crane.judge([("theta_1", "h", 0, -1.5708)]).outcome is Outcome.WRONG
    assert crane.judge([("theta_1", "h", "h", 1.5708)]).outcome is Outcome.WRONG


def test_a_loop_without_end_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("armproof.course.feedback.formula.SECONDS", 0.3)

    def loop(x: float, y: float, a: float, b: float) -> float:
        while True:
            x += 1

    feedback = task(COSINE).check(loop)
    assert feedback.outcome is Outcome.ERROR
    assert "did not end" in feedback.message


@pytest.mark.parametrize(
    "answer",
    [
        lambda q, l_1, l_2: tool([q[0], q[1] - q[0]], l_1, l_2),
        r"\begin{bmatrix} l_2 C_2 + l_1 C_1 \\ l_1 S_1 + l_2 S_2 \end{bmatrix}",
        sp.Matrix([L_1 * sp.cos(T_1) + L_2 * sp.cos(T_2), L_1 * sp.sin(T_1) + L_2 * sp.sin(T_2)]),
    ],
)
def test_a_known_mistake_is_told_in_its_own_words_in_every_form(answer: Any) -> None:
    known = Wrong(
        r"\begin{bmatrix} l_1 C_1 + l_2 C_2 \\ l_1 S_1 + l_2 S_2 \end{bmatrix}", "add the angles up", own=True
    )
    assert task(POSITION, known).check(answer).message == "add the angles up"
    assert task(POSITION, known).check(LATEX.replace("l_1", "l_2")).message != "add the angles up"


def test_a_known_mistake_in_an_angle_is_known_again_a_whole_turn_away() -> None:
    known = Wrong(lambda X, Y: np.arctan2(-Y, -X), "this looks away from the target", own=True)
    behind = task(ANGLE, known).check(lambda X, Y: np.arctan2(Y, X) + 3 * np.pi)
    assert behind.message == "this looks away from the target"
    assert task(ANGLE, known).check(lambda X, Y: np.arctan2(Y, X) + 1).message != behind.message


@pytest.mark.parametrize(
    "hostile", [r"\input{/etc/passwd}", "\\write18{rm}", "{" * 2000, "^" * 500, "__import__('os')"]
)
def test_a_hostile_text_is_refused_and_nothing_is_executed(hostile: str) -> None:
    assert task(POSITION).check(hostile).outcome is Outcome.ERROR


@pytest.mark.parametrize("asks, answer", [(REACH, "2"), (ANGLE, "2 X"), (COSINE, "x^2"), (DAMPED, "2")])
def test_an_answer_that_lacks_letters_of_what_is_asked_is_wrong_and_no_arm_is_missing(asks: Any, answer: str) -> None:
    feedback = task(asks).check(answer)
    assert feedback.outcome is Outcome.WRONG
    assert "no arm" not in feedback.message


def test_the_angle_of_a_rotation_is_known_by_its_cosine_and_not_by_its_sine() -> None:
    wrist = open_lesson("kr210_inverse").wrist
    answer = r"\begin{bmatrix} \text{atan2}(r_{21}, -r_{31}) \\ %s \\ \text{atan2}(r_{12}, r_{13}) \end{bmatrix}"
    assert wrist.check(answer % r"\arccos r_{11}").is_right
    by_sine = wrist.check(answer % r"\arcsin r_{21}")
    assert by_sine.outcome is Outcome.WRONG and by_sine.message.startswith(
        "entry (2, 1): r_{11}, r_{31} have no effect"
    )
    assert not wrist.check(answer % r"(-\arccos r_{11})").is_right


def test_a_formula_of_a_function_is_read_back_as_it_was() -> None:
    assert as_latex([[1, sp.Rational(1, 2)], [T_1, -1]]) == (
        r"\begin{bmatrix} 1 & \frac{1}{2} \\ \theta_1 & -1 \end{bmatrix}"
    )
    with pytest.raises(AnswerError, match="no formula"):
        as_latex(object())
