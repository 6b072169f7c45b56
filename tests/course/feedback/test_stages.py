"""Feedback comes in two stages, at configurations that a student can imagine, with a picture that says what it shows."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from armproof.course.feedback import (
    Feedback,
    Formula,
    Lesson,
    Number,
    Outcome,
    Quantity,
    Table,
    Task,
    lessons,
    open_lesson,
)
from armproof.course.feedback.progress import VARIABLE
from armproof.course.tasks.kr210_table import DH
from armproof.course.tasks.scara_inverse import ARM
from armproof.course.tasks.scara_jacobian import JACOBIAN, jacobian
from armproof.models.language import use

METRES = [
    (0, 0, 0.75, "theta_1"), ("-pi/2", 0.35, 0, "theta_2 - pi/2"), (0, 1.25, 0, "theta_3"),
    ("-pi/2", -0.054, 1.5, "theta_4"), ("pi/2", 0, 0, "theta_5"), ("-pi/2", 0, 0, "theta_6"),
]  # fmt: skip


@pytest.fixture
def task(monkeypatch: pytest.MonkeyPatch) -> Task:
    monkeypatch.setenv(VARIABLE, "")
    asks = Quantity("scara", {"jacobian": 4})
    task = Task("jacobian", "J", "Write $J$.", asks, ("Look.",), (JACOBIAN,))
    return Lesson(1, "sample", "", (), (task, Task("two", "Two", "1 + 1?", Number(2), (), (2,)))).jacobian


def wrong(column: int) -> str:
    return JACOBIAN.replace("& a_2 C_{12} &", "& -a_2 C_{12} &") if column == 2 else JACOBIAN.replace("1 & 1", "-1 & 1")


def test_expected_values_are_held_back_until_another_answer_is_wrong(task: Task) -> None:
    first, again, second = task.check(wrong(2)), task.check(wrong(2)), task.check(wrong(1))
    for feedback in (first, again):  # who runs a cell again has not tried again
        assert "expected" not in str(feedback).replace("values expected", "")
        assert "0.2745" in str(feedback)
        assert "-0.2745" not in str(feedback)
        assert feedback.picture is not None
        assert ">expected<" not in feedback._repr_html_()
    assert "expected" in str(second)
    assert ">expected<" in second._repr_html_()
    assert "expected" in str(task.check(wrong(2)))
    assert len(first.as_json()["rows"]) == 1  # what a teacher reads is whole


def test_what_is_wrong_offers_the_next_hint_and_then_the_solution(task: Task) -> None:
    assert "`lesson.jacobian.hint()`" in str(task.check(wrong(2)))
    assert "<code>lesson.jacobian.hint()</code>" in task.check(wrong(1))._repr_html_()
    task.hint()
    assert "lesson.jacobian.solution()" in str(task.check(wrong(2)))
    assert "hint()" not in str(task.check(JACOBIAN))
    with use("fr"):
        assert "indication" in str(Task("two", "Two", "", Number(2), ("x",), (2,), lang="fr").check(3))


def test_a_sentence_begins_with_a_capital_and_a_symbol_stays_small() -> None:
    page = {
        words: Feedback(Outcome.WRONG, words)._repr_html_()
        for words in ("z × p is no column", "a sign is wrong", "l'exposant 2 est trop grand")
    }
    assert "<p>z × p is no column" in page["z × p is no column"]
    assert "<p>A sign is wrong" in page["a sign is wrong"]
    assert "<p>L&#39;exposant" in page["l'exposant 2 est trop grand"]


@pytest.mark.parametrize("column", [1, 2])
def test_the_picture_says_which_joint_moves(task: Task, column: int) -> None:
    def answer(q: np.ndarray, a_1: float, a_2: float) -> np.ndarray:
        result = jacobian(q, a_1, a_2)
        result[1 if column == 1 else 0, column - 1] += 0.1
        result[0, 1] += 0.2  # that of joint 2 is wrong in an upper row: the picture takes the first column, as the text
        return result

    for feedback in (task.check(answer), task.check(wrong(column))):
        assert feedback.picture is not None
        assert f"when joint {column} alone moves at 1 rad/s" in feedback.picture.caption


def test_a_counterexample_is_a_target_that_the_arm_reaches() -> None:
    def told(name: str) -> Iterator[float]:
        task = getattr(open_lesson("scara_inverse"), name)
        feedback = [task.check(each.answer) for each in task.wrong[:3]]
        yield from (float(each.rows[0].expected) for each in feedback if each.rows)

    assert all(-1 <= cosine <= 1 for cosine in told("elbow"))
    assert all(0 < d_3 < 0.3 for d_3 in told("slide"))
    assert all(-np.pi <= theta_1 <= np.pi for theta_1 in told("shoulder"))
    branching = open_lesson("scara_inverse").elbow.check(lambda X, Y, a_1, a_2: 0.2 if X > 0 else 0.3)
    assert dict(branching.at) == {"X": 0.5, "Y": 0.2, "a_1": 0.4, "a_2": 0.3}
    elbow = Formula(r"\frac{X^2 + Y^2 - a_1^2 - a_2^2}{2 a_1 a_2}", ("X", "Y", "a_1", "a_2"))
    without = elbow.judge(r"\frac{a_1^2 + a_2^2 - X^2 - Y^2}{2 a_1 a_2}")
    assert abs(float(without.rows[0].expected)) > 1  # what cases are for


def test_every_case_of_a_task_tells_all_letters() -> None:
    formulas = [task.asks for lesson in lessons() for task in lesson.tasks if isinstance(task.asks, Formula)]
    assert [asks for asks in formulas if asks.cases] != []
    for asks in formulas:
        for case in asks.cases:
            assert np.isfinite(asks.claim.values_at(r"\Xi", case)).all()


def test_right_numbers_in_metres_are_not_wrong() -> None:
    table = Table(DH, "modified", measured="kr210")
    right = table.judge(METRES)
    assert (right.outcome, right.is_right) == (Outcome.LETTERS, False)
    assert "in metres" in right.message
    near = [*METRES[:1], ("-pi/2", 0.36, 0, "theta_2 - pi/2"), *METRES[2:]]
    assert table.judge(near).outcome is Outcome.WRONG
    assert Table(DH, "modified").judge(METRES).outcome is Outcome.WRONG  # whose letters have no lengths in metres
    slide = Formula("d_1 - d_4 - Z", ("Z", "d_1", "d_4"), arm=ARM)
    assert slide.judge("0.38 - Z").outcome is Outcome.LETTERS
    assert slide.judge("0.39 - Z").outcome is Outcome.WRONG


def test_columns_in_the_order_of_the_other_convention_are_named() -> None:
    table = Table(DH, "modified")
    letters = [
        ("theta_1", "d_1 + d_2", 0, 0), ("theta_2 - pi/2", 0, "a_1", "-pi/2"), ("theta_3", 0, "a_2", 0),
        ("theta_4", "d_4 + d_5", "-a_3", "-pi/2"), ("theta_5", 0, 0, "pi/2"), ("theta_6", 0, 0, "-pi/2"),
    ]  # fmt: skip
    assert "your columns are in the order theta, d, a, alpha" in table.judge(letters).message
    assert "your columns" not in table.judge([(*row[:3], 0) for row in letters]).message


def test_a_letter_in_a_column_of_another_kind_and_a_table_of_the_other_convention_are_named() -> None:
    table = Table("scara_column", "classic")
    modified = [(0, 0, "d_1", "theta_1"), (0, "a_1", 0, "theta_2"), ("pi", "a_2", "d_3", 0), (0, 0, "d_4", "theta_4")]
    assert "a table of the modified convention" in table.judge(modified).message
    other = [*modified[:3], (0, "a_1", "d_4", "theta_4")]
    assert table.judge(other).message == "row 1: theta_1 is the variable of a joint, and stands in the column of alpha"
    rows = [("theta_1", "d_1", "a_1", 0), ("theta_2", 0, "a_2", "pi"), (0, "d_3", 0, 0), ("theta_4", "d_4", 0, 0)]
    assert table.judge(rows).is_right
    for row, words in (
        (("theta_2", 0, 0, "a_2"), "row 2: a_2 is a length, and stands in the column of alpha"),
        (("theta_2", "theta_4", "a_2", "pi"), "row 2: theta_4 is an angle, and stands in the column of d"),
        (("theta_2", 0, "a_2", "pi/2"), "row 2: alpha is wrong (half of what belongs there)"),
        (("theta_2", 0, "a_2", "180"), "row 2: alpha = 180 is in degrees"),
    ):
        assert table.judge([rows[0], row, *rows[2:]]).message.startswith(words)
    assert table.judge([rows[0], ("theta_2", 0, "a_2", "180°"), *rows[2:]]).is_right
