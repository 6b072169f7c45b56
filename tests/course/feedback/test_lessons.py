"""Lessons are opened by name, remember what was solved, and are shown in a notebook and in a terminal."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import (
    Derivation,
    Lesson,
    LessonError,
    Line,
    Number,
    Outcome,
    Quantity,
    Task,
    Wrong,
    course,
    lessons,
    open_lesson,
)
from armproof.course.feedback.progress import VARIABLE, read_progress
from armproof.course.feedback.slope import stages
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics

OWN = """
from armproof.course.feedback import Lesson, Number, Task
LESSON = Lesson(1, "mine", "Mine", ("One",), (Task("two", "Two", "1 + 1?", Number(2), ("Count.",), (2,)),))
"""


@pytest.fixture
def lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Lesson:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "new" / "progress.json"))
    return make()


def make() -> Lesson:
    pose = Task(
        "tool", "The <tool>", "Where is $p_2$?", Quantity("planar_2r", {"origin": 2}), ("Look.", "Add."),
        (r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}",),
    )  # fmt: skip
    return Lesson(3, "sample", "A sample", ("See.",), (Task("two", "Two", "1 + 1?", Number(2), (), (2,)), pose))


def test_a_right_answer_stays_solved_in_the_next_kernel(lesson: Lesson) -> None:
    lesson.two.check(3)
    assert make().progress()["two"] is Outcome.WRONG
    lesson.two.check(2)
    lesson.two.check(5)
    assert make().progress() == {"two": Outcome.PROVED, "tool": Outcome.NOT_ATTEMPTED}
    assert lesson.results()["two"].outcome is Outcome.WRONG  # what is graded is the last answer
    assert "1 of 2 tasks solved" in repr(make())


def test_a_broken_progress_file_is_no_progress(lesson: Lesson, tmp_path: Path) -> None:
    lesson.two.check(2)
    for content in ("{", "[]", '{"sample": {"two": "won"}}', '{"sample": 3}'):
        (tmp_path / "new" / "progress.json").write_text(content, encoding="utf-8")
        assert read_progress("sample") == {}
    lesson.two.check(2)
    assert json.loads((tmp_path / "new" / "progress.json").read_text())["sample"] == {"two": "correct (proved)"}


def test_without_a_file_progress_is_kept_in_the_process(lesson: Lesson, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "")
    lesson.two.check(2)
    assert lesson.progress()["two"] is Outcome.PROVED
    assert make().progress()["two"] is Outcome.NOT_ATTEMPTED


def test_hints_are_a_ladder(lesson: Lesson) -> None:
    assert ["Look" in str(lesson.tool.hint()), "Add" in str(lesson.tool.hint())] == [True, True]
    assert "solution()" in str(lesson.tool.hint())
    assert "no hint" in str(lesson.two.hint())


def test_the_solution_shows_formula_and_number(lesson: Lesson) -> None:
    lesson.tool.check([0, 0, 0])
    lesson.two.check(3)
    assert "$$ \\begin{bmatrix}" in lesson.tool.solution()._repr_markdown_()
    assert "2" in str(lesson.two.solution())


def test_the_solution_of_numbers_says_how_each_follows_in_the_unit_that_is_asked() -> None:
    ring = Number(
        (0.05, 0.55, 0.9273), "m", ("near", "far"), {"a": 0.3, "b": 0.25}, steps=("a - b", "", r"\arctan(4/3)")
    )
    assert ring.shown() == "- near: $a - b = 0.05$ m\n- far: $0.55$ m\n- number 3: $\\arctan(4/3) = 0.9273$ m"
    assert Number(np.pi / 2, "rad", steps=(r"\pi/2",)).shown() == r"$\pi/2 \approx 1.571$ rad"


def test_the_solution_opens_line_by_line_after_an_attempt(lesson: Lesson) -> None:
    assert "Try an answer first" in str(lesson.tool.solution())
    lesson.tool.check()
    assert "Try an answer first" in str(lesson.tool.solution())  # no answer is no attempt
    lesson.tool.check([0, 0, 0])
    assert make().tool.was_tried()  # in the next kernel too
    assert not make().two.was_tried()
    lesson.tool.derivation = Derivation((Line("The first bar.", "a = b"), Line("The second.", "b = c")))
    one, two = str(lesson.tool.solution()), str(lesson.tool.solution())
    assert "$$ a = b $$" in one
    assert "b = c" not in one
    assert "solution.**" not in one
    assert "1. The first bar." in two
    assert "$$ b = c $$" in two
    assert "$$ \\begin{bmatrix}" in two


def test_feedback_is_escaped_and_drawn_in_a_notebook(lesson: Lesson) -> None:
    feedback = lesson.tool.check(lambda theta_1, theta_2: [0.1, 0.2, 0.0])
    page = feedback._repr_html_()
    assert feedback.picture is not None
    assert "<svg" in page
    assert "wrong" in page
    assert "The &lt;tool&gt;" in lesson._repr_html_()
    evil = Lesson(1, "evil", "<script>alert(1)</script>", ("<b>",), lesson.tasks)
    assert "<script>" not in evil._repr_html_()
    assert "<script>" not in lesson.tool.check("<script>alert(1)</script>")._repr_html_()


def test_a_picture_is_drawn_on_request_where_there_is_one(lesson: Lesson) -> None:
    arm = load_arm("planar_2r")
    right = lesson.tool.show(lambda q: NumericKinematics(arm, [q]).pose("2")[0, :3, 3], theta_1=0.3)
    assert "<svg" in right._repr_html_()
    assert "no answer yet" in str(lesson.tool.show())
    assert "no answer yet" in str(lesson.tool.show(lambda q: None))
    assert "cannot be drawn" in str(lesson.tool.show(lambda q: 1 / 0))
    assert "only a function" in str(lesson.two.show(3))


def test_a_task_is_an_attribute_and_an_unknown_one_lists_the_known(lesson: Lesson) -> None:
    assert "tool" in dir(lesson)
    with pytest.raises(AttributeError, match="no task 'tol'; its tasks are two, tool"):
        lesson.tol  # noqa: B018


@pytest.mark.parametrize("name", ["two words", "check-it", "results", "title"])
def test_a_name_that_cannot_be_an_attribute_is_refused(name: str) -> None:
    with pytest.raises(LessonError, match=r"taken|identifier"):
        Lesson(1, "sample", "", (), (Task(name, "", "", Number(1), (), ()),))


def test_lessons_of_the_course_are_found_by_name() -> None:
    assert open_lesson("scara_jacobian") is open_lesson("scara_jacobian")
    with pytest.raises(LessonError, match=r"no lesson 'scara'; the lessons are .*scara_jacobian"):
        open_lesson("scara")


def test_a_teachers_own_lesson_is_opened_from_a_folder(tmp_path: Path) -> None:
    (tmp_path / "tasks").mkdir()
    (tmp_path / "tasks" / "mine.py").write_text(OWN, encoding="utf-8")
    assert open_lesson("mine", folder=tmp_path).two.check("2").is_right
    with pytest.raises(LessonError, match="the lessons there: mine"):
        open_lesson("other", folder=tmp_path)
    (tmp_path / "tasks" / "empty.py").write_text("", encoding="utf-8")
    with pytest.raises(LessonError, match="LESSON = Lesson"):
        open_lesson("empty", folder=tmp_path)


def test_a_hidden_wrong_answer_is_no_right_one() -> None:
    known = Wrong(3, "three is one too many", own=True)
    task: Any = Task("two", "Two", "", Number(2), (), (2,), (known,))
    assert task.check(3).message == "three is one too many"
    assert task.check(2).is_right


def test_the_slope_names_every_lesson_with_what_comes_before_it() -> None:
    by_name = {lesson.name: lesson for lesson in lessons()}
    assert [(name, stage.number) for name, stage in stages().items()] == [
        (each.name, each.number) for each in lessons()
    ]
    for name, stage in stages().items():
        assert all(stages()[other].number < stage.number for other in stage.before), name
        assert 20 <= stage.minutes <= 90
        assert bool(stage.before) == (stage.number > 1)
    assert by_name["jacobian_columns"].number < by_name["planar_3r_jacobian"].number
    assert "About 60 minutes · after lessons 6, 10" in repr(by_name["scara_jacobian"])
    assert "Environ 60 minutes · après les leçons 6, 10" in open_lesson("scara_jacobian", lang="fr")._repr_html_()
    assert "after lessons 6, 10" in repr(course()) and "after lessons 6, 10" in course()._repr_html_()


def test_a_task_returns_three_lessons_later_and_counts_again() -> None:
    for name, stage in stages().items():
        earlier, _, task = stage.review.partition(".")
        assert bool(stage.review) == (stage.number > 3)
        if stage.review:
            assert stages()[earlier].number == stage.number - 3
            review, first = open_lesson(name).tasks[-1], getattr(open_lesson(earlier), task)
            assert (review.name, review.text, review.lesson) == ("review", first.text, name)
            assert review is not first and review.asks is first.asks
    french = open_lesson("placing_frames", lang="fr").review
    assert french.title == open_lesson("frames", lang="fr").inverse.title != open_lesson("frames").inverse.title
