"""Rows or columns that are exchanged are named as such, with what is wrong besides; of all wrong entries something is said."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Formula, Outcome, Quantity, Table, Task
from armproof.course.feedback.number_slips import number_slip


def matrix(*rows: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


ROWS = (r"C\theta & -S\theta & 0 & a", r"S\theta C\alpha & C\theta C\alpha & -S\alpha & -d S\alpha",
    r"S\theta S\alpha & C\theta S\alpha & C\alpha & d C\alpha", "0 & 0 & 0 & 1")  # fmt: skip
LINK = Formula(matrix(*ROWS), ("a", "alpha", "d", "theta"))
JACOBIAN = Quantity("planar_2r", {"jacobian": 2, "rows": [1, 2]})
FIRST, SECOND = "-l_1 S_1 - l_2 S_{12} & -l_2 S_{12}", "l_1 C_1 + l_2 C_{12} & l_2 C_{12}"
INVERSE = Formula(r"\frac{1}{x y} " + matrix(r"y \cos u & y \sin u", r"-x \sin u & x \cos u"), ("x", "y", "u"))
MOTION = Formula(matrix("x + y", "x - y", "x z"), ("x", "y", "z"))
TURN = Formula(
    r"\operatorname{atan2}(y, x) - \operatorname{atan2}(n, m)", ("x", "y", "m", "n"), unit="rad",
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)", "m": r"\rho\cos\beta", "n": r"\rho\sin\beta"},
    symbols={"rho": "free", "gamma": "free", "beta": "free"},
)  # fmt: skip
WRIST = Formula(
    matrix(r"\arccos u", r"\operatorname{atan2}(v, w)"), ("u", "v", "w"), unit="rad",
    given={"u": r"\cos\gamma", "v": r"\sin\gamma\sin\beta", "w": r"\sin\gamma\cos\beta"}, symbols={"gamma": "free", "beta": "free"},
)  # fmt: skip
CRANE = Table({"dh": "classic", "rows": [{"theta": "theta_1", "d": "h", "a": 0, "alpha": "pi/2"}, {"theta": "theta_2", "d": 0, "a": "b", "alpha": 0}]}, "classic")  # fmt: skip


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (LINK, matrix(ROWS[1], ROWS[0], *ROWS[2:]), "rows 1 and 2 are swapped"),
        (LINK, matrix(*(" & ".join(row.split(" & ")[k] for k in (3, 1, 2, 0)) for row in ROWS)), "columns 1 and 4 are swapped"),
        (LINK, matrix(ROWS[1], ROWS[0].replace("a", "d").replace("thetd", "theta"), *ROWS[2:]), "rows 1 and 2 are swapped; once that is put right: entry (1, 4): d where a belongs"),
        (LINK, matrix(ROWS[2], ROWS[0], ROWS[1], ROWS[3]), "the rows are right, their order is not"),
        (JACOBIAN, matrix(SECOND, FIRST.replace("S_{12} & ", "S_{2} & ")), "rows 1 and 2 are swapped; once that is put right: entry (1, 1): index 1 is missing"),
        (LINK, matrix(ROWS[0], ROWS[1], "0 & 0 & 0 & 1", ROWS[2].replace("C\\theta S", "-C\\theta S")), "rows 3 and 4 are swapped; once that is put right: entry (3, 2): wrong sign"),
        (LINK, matrix(*(" & ".join(line) for line in zip(*(ROWS[k].split(" & ") for k in (3, 1, 2, 0)), strict=True))), "the matrix is transposed; once that is put right: rows 1 and 4 are swapped"),
        (INVERSE, r"\frac{1}{x y} " + matrix(r"y \cos u & y \cos u", r"-x \sin u & -x \cos u"), "entry (1, 2): cosine for sine; entry (2, 2): wrong sign"),
        (INVERSE, r"\frac{1}{x} " + matrix(r"y \cos u & y \sin u", r"-x \sin u & x \cos u"), "your answer is y times what is asked"),
        (LINK, matrix("1 & 0 & 0 & a", r"0 & 1 & 0 & -d\,S\alpha", r"0 & 0 & 1 & d\,C\alpha", "0 & 0 & 0 & 1"), "the rotation is the identity"),
        (LINK, matrix(*ROWS).replace("C\\", "@").replace("S\\", "C\\").replace("@", "S\\"), "sine and cosine are exchanged throughout"),
        (MOTION, matrix("x - y", "x z", "x + y"), "the rows are right, their order is not"),
        (MOTION, matrix("x + 2 y", "x - y", "x + z"), "entry (1, 1)"),
        (MOTION, matrix("x", "x - y", "z"), "entry (1, 1): the term y is missing; entry (3, 1): a factor x is missing"),
        (MOTION, matrix("0", "x + y", "1"), "entry (2, 1): wrong sign of term 2; entries (1, 1), (3, 1): x is missing"),
        (TURN, r"\operatorname{atan2}(y m - n x, x m - y n)", "wrong sign of term 2"),
        (WRIST, matrix(r"\operatorname{atan2}(\sqrt{v^2 + w^2}, u)", r"\operatorname{atan2}(v, u)"), "entry (2, 1): u where w belongs"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_of_every_wrong_entry(asks: Any, answer: str, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (LINK, matrix(ROWS[0].replace("-S", "S"), ROWS[1].replace("-d", "d"), *ROWS[2:]), "swapped"),
        (JACOBIAN, matrix(FIRST.replace("S_1", "C_1"), SECOND.replace("C_1", "S_1")), "rows"),
        (MOTION, matrix("x + y", "x - y", "z"), "too"),
        (WRIST, matrix(r"\operatorname{atan2}(\sqrt{v^2 + w^2}, u)", r"\operatorname{atan2}(v, u)"), "(1, 1)"),
    ],
)
def test_no_exchange_is_told_where_there_is_none(asks: Any, answer: str, words: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words not in feedback.message


def test_a_letter_that_falls_out_of_an_answer_is_not_called_absent() -> None:
    cancelled = Formula("x y", ("x", "y")).judge(r"\frac{x y}{x y} + 2").message
    assert cancelled == "x, y have no effect in your answer: what is asked depends on them"
    assert Formula("x y", ("x", "y")).judge("2 x + 1").message.startswith("y is missing")


def test_a_matrix_with_its_factor_before_it_is_right_as_it_stands() -> None:
    assert INVERSE.judge(r"\frac{1}{x y} " + matrix(r"y \cos u & y \sin u", r"-x \sin u & x \cos u")).is_right


def test_signs_that_make_a_table_look_like_one_of_the_other_convention_are_named() -> None:
    spec = {"dh": "modified", "rows": [{"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"}, {"alpha": 0, "a": "a_1", "d": 0, "theta": "theta_2"},
        {"alpha": "pi", "a": "a_2", "d": "d_3", "theta": 0}, {"alpha": 0, "a": 0, "d": "d_4", "theta": "theta_4"}]}  # fmt: skip
    asks = Table(spec, "modified")
    rows = [(0, 0, 0, "theta_1"), (0, "-a_1", 0, "theta_2"), ("pi", "a_2", "-d_3", 0), (0, 0, "d_4", "theta_4")]
    assert asks.judge(rows).message == "row 2: a is wrong (the sign); row 3: d is wrong (the sign)"
    rows = [
        (0, 0, "d_4 + d_3", "theta_1"),
        (0, "a_1", 0, "theta_2"),
        ("pi", "a_2", "d_3", 0),
        (0, 0, "d_4 + a_1", "theta_4"),
    ]
    assert "row 4: d is wrong (a_1 does not belong)" in asks.judge(rows).message


def test_two_rows_of_a_table_that_are_exchanged_are_named() -> None:
    right = [("theta_1", "h", 0, "pi/2"), ("theta_2", 0, "b", 0)]
    assert CRANE.judge(right).is_right
    assert CRANE.judge([("theta_2", 0, "b", 0), ("theta_1", "h", 0, "pi/2")]).message == "rows 1 and 2 are swapped"
    assert "swapped" not in CRANE.judge([("theta_2", "h", "b", "pi/2"), ("theta_1", "h", "b", 0)]).message


@pytest.mark.parametrize(
    ("given", "right", "known", "unit", "words"),
    [
        ([0.9], [0.25], {"l_1": 0.4, "l_2": 0.3}, "m", "even l_1 + l_2 is only 0.7: the arm does not reach that far"),
        ([0.9], [0.25], {"l_1": 0.4, "l_2": 0.3}, "m/s", ""),
        ([1.109], [0.312], {"a": 0.506, "b": 0.35, "c": 0.253, "d": 0.07}, "m", "this is a + b + c"),
        ([0.15], [0.25], {}, "m", "this is 3/5 of what is asked"),
        ([0.17], [0.25], {}, "m", ""),
        ([0.0484], [0.22], {}, "m", "this is the square of what is asked"),
        ([np.cos(0.4)], [0.4], {}, "rad", "this is the cosine of the angle"),
        ([8, 2], [6, 2], {}, "–", "2 too many"),
        ([4, 2], [6, 2], {}, "–", "2 too few"),
        ([11, 2], [6, 2], {}, "–", "too large"),
        ([2.5, 2], [6, 2], {}, "–", "a whole number is asked"),
        ([57.3 * 0.4, 0.3], [0.4, 0.3], {}, "m", ""),
    ],
)
def test_a_wrong_number_is_told_how_it_relates(given: Any, right: Any, known: Any, unit: str, words: str) -> None:
    told = number_slip(
        np.array(given, dtype=float), np.array(right, dtype=float), ("x", "y")[: len(right)], known, unit
    )
    assert words in told and ("too" in told or words)
    assert "degrees" not in told and ("reach" not in told or unit == "m")


def test_a_task_names_the_entries_of_which_it_says_no_more() -> None:
    task = Task("name", "Title", "Text", MOTION, (), (matrix("x + y", "x - y", "x z"),))
    message = task.check(matrix("x - y", r"\sqrt{x} + z y^3 + 7", "x z")).message
    assert "(1, 1)" in message and "(2, 1)" in message


@pytest.mark.parametrize("unit", ["–", "m", "m/s", "rad"])
@pytest.mark.parametrize("right", [(0.0,), (2.0,), (0.0, 0.0, 1.0), (0.25, -0.4), (1.0, 1.0, -1.0), (6.0, 0.0, 3.0)])
def test_of_any_wrong_number_something_is_said(unit: str, right: tuple[float, ...]) -> None:
    for wrong in (0.0, 1.0, -1.0, 0.255, 57.3, 1e6, 2.004):
        for k in range(len(right)):
            given = np.array([*right[:k], wrong, *right[k + 1 :]])
            if not np.isclose(given, right, rtol=1e-6).all():
                assert number_slip(
                    given, np.array(right), ("x", "y", "z")[: len(right)], {"l_1": 0.4}, unit, (0.4, 3.0)
                )
