"""Every task of the course knows its right answers from its wrong ones, in several forms."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from armproof.course.feedback import Choice, Formula, Number, Outcome, Quantity, Task, lessons, open_lesson
from armproof.course.feedback.answer import is_function
from armproof.course.feedback.slope import REVIEW
from armproof.course.sources.places import COURSE
from armproof.verification.verdict import Verdict

ASKED = [(lesson, task) for lesson in lessons() for task in lesson.tasks if task.name != REVIEW]
TASKS = [pytest.param(task, id=f"{lesson.name}-{task.name}") for lesson, task in ASKED]
DERIVED = [each for each in TASKS if each.values[0].derivation.lines]
EVERY_TASK = pytest.mark.parametrize("task", TASKS)


def form_of(answer: object) -> object:
    return "function" if is_function(answer) else type(answer)


@pytest.mark.parametrize("source", COURSE.sources(), ids=lambda path: path.stem)
def test_every_lesson_asks_for_an_arm_that_it_has_not_shown_and_ends_with_a_summary(source: Path) -> None:
    text = source.read_text(encoding="utf-8")
    assert "lesson.transfer.check(" in text
    assert "# ## What you know now" in text


@EVERY_TASK
def test_every_right_answer_is_proved(task: Task) -> None:
    feedback = [task.check(answer) for answer in task.right]
    assert feedback
    assert [str(each) for each in feedback if each.outcome is not Outcome.PROVED] == []


@EVERY_TASK
def test_every_wrong_answer_gets_its_own_message(task: Task) -> None:
    told = [task.check(wrong.answer) for wrong in task.wrong]
    assert [str(each) for each in told if each.outcome not in (Outcome.WRONG, Outcome.LETTERS)] == []
    missing = [(wrong.words, each.message) for wrong, each in zip(task.wrong, told, strict=True)
               if not wrong.words or wrong.words not in each.message]  # fmt: skip
    assert missing == []
    assert len({each.message for each in told}) >= 4, "mistakes that are told in the same words"


@EVERY_TASK
def test_every_task_has_forms_mistakes_and_a_ladder(task: Task) -> None:
    assert len(task.right) >= 3
    assert len(task.wrong) >= 4
    assert len(task.hints) >= 2
    assert not task.check().is_right
    forms = {form_of(answer) for answer in task.right}
    if not isinstance(task.asks, Choice | Number):
        assert len(forms) >= 2, "one form only"
    if isinstance(task.asks, Formula | Quantity):
        assert {"function", str} <= forms
    assert str(task.hint())
    assert str(task.solution())


@pytest.mark.parametrize("task", DERIVED)
def test_every_line_of_a_derivation_is_proved(task: Task) -> None:
    records = task.derivation.records()
    assert len(records) == len(task.derivation.lines) > 1
    assert [(each.latex, each.message) for each in records if each.verdict is not Verdict.PROVED] == []


@pytest.mark.parametrize(
    ("lesson", "name", "right", "wrong"),
    [
        ("scara_jacobian", "determinant", "-a_1", "a_1"),
        ("scara_inverse", "inverse", r"\arccos D \\", r"-\arccos D \\"),  # of both signs one is asked for
        ("kr210_inverse", "elbow_angle", r"\sqrt", r"-\sqrt"),
        ("kr210_inverse", "wrist", r"r_{12}, r_{13}", r"-r_{12}, -r_{13}"),
        ("tool_orientation", "angles", "n_z, a_z", "-n_z, -a_z"),
    ],
)
def test_a_line_that_does_not_hold_is_not_proved(lesson: str, name: str, right: str, wrong: str) -> None:
    derivation = getattr(open_lesson(lesson), name).derivation
    *others, last = derivation.lines
    assert right in last.latex
    spoiled = replace(derivation, lines=(*others, replace(last, latex=last.latex.replace(right, wrong))))
    before, at_last = [each.verdict for each in spoiled.records()][-2:]
    assert before is Verdict.PROVED
    assert at_last in (Verdict.REFUTED, Verdict.UNCHECKED)


def test_most_tasks_of_several_steps_have_a_derivation() -> None:
    assert len(DERIVED) >= 82
