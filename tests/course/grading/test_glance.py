"""The class at a glance: each student counts once, with their best result, and a mistake counts wherever it was made."""

from pathlib import Path

import pytest

from armproof.course.errors import GradingError
from armproof.course.grading.glance import at_a_glance, best_results
from armproof.course.grading.results import Graded, Status, TaskResult
from armproof.course.grading.submissions import Submission
from armproof.course.grading.weights import read_weights

CATALOGUE = [
    {"name": "frames", "tasks": [{"name": "rot"}, {"name": "inv"}]},
    {"name": "quintic", "tasks": [{"name": "line"}]},
]
SIGN, PLACE = "the sign of z₃ is lost", "rows and columns are swapped"


def graded(student: str, outcome: str, *mistakes: str, lesson: int = 1, attempts: int = 1) -> Graded:
    result = TaskResult(
        f"lesson{lesson}", "rot", "Rot", f"{lesson} · Frames", outcome, attempts=attempts, mistakes=mistakes
    )
    return Graded(Submission(student, Path("x"), "x"), Status.GRADED, results=(result,))


def test_so_many_of_so_many_made_a_mistake():
    (lesson,) = at_a_glance([
        graded("a", "wrong", SIGN), graded("b", "wrong", PLACE), graded("c", "wrong", SIGN),
        graded("d", "correct (proved)", SIGN, attempts=2), graded("e", "correct (proved)"), graded("f", "not attempted", attempts=0),
    ])  # fmt: skip
    assert [(each.message, each.students, each.of) for each in lesson.mistakes] == [
        (SIGN, ("a", "c", "d"), 6),
        (PLACE, ("b",), 6),
    ]
    (task,) = lesson.tasks
    assert (task.right, task.attempts) == (2, 1.2)
    assert task.counts == {"correct (proved)": 2, "wrong": 3, "not attempted": 1}


def test_a_student_who_handed_in_twice_counts_once_with_the_better_one():
    twice = [graded("a", "correct (proved)"), graded("a", "wrong", SIGN)]
    for order in (twice, twice[::-1]):
        ((task,),) = (lesson.tasks for lesson in at_a_glance(order))
        assert task.counts == {"correct (proved)": 1}
    assert list(best_results([*twice, Graded(Submission("none", Path("x"), "x"), Status.UNREADABLE)])) == ["a", "none"]


def test_lessons_stand_by_their_number():
    found = at_a_glance([graded("a", "wrong", lesson=12), graded("b", "wrong", lesson=2)])
    assert [(lesson.title, lesson.students) for lesson in found] == [("2 · Frames", ("b",)), ("12 · Frames", ("a",))]


def test_a_line_of_a_task_wins_over_that_of_its_lesson(tmp_path):
    file = tmp_path / "weights.csv"
    file.write_text("lesson,task,weight\nframes,inv,3\nframes,,0.5\n", encoding="utf-8-sig")
    weights = read_weights(file, CATALOGUE)
    assert [weights.of(key) for key in (("frames", "rot"), ("frames", "inv"), ("quintic", "line"))] == [0.5, 3.0, 0.0]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("frame,,1", r"weights.csv:2: there is no lesson 'frame'; .*frames"),
        ("frames,rat,1", r"weights.csv:2: lesson 'frames' has no task 'rat'; its tasks are rot(,| and) inv"),
        ("frames,rot,-1", "'-1' is no weight"),
        ("frames,rot,nan", "'nan' is no weight"),
        ("frames,rot", "'' is no weight"),
    ],
)
def test_a_weight_that_is_none_is_refused(line, message, tmp_path):
    (tmp_path / "weights.csv").write_text(f"lesson,task,weight\n{line}\n", encoding="utf-8")
    with pytest.raises(GradingError, match=message):
        read_weights(tmp_path / "weights.csv", CATALOGUE)


def test_weights_that_cannot_be_read_are_refused(tmp_path):
    with pytest.raises(GradingError, match="cannot be read: No such file"):
        read_weights(tmp_path / "none.csv", CATALOGUE)
