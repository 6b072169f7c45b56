"""A seed gives each student other lengths; what is right and wrong of them is known as well as of the usual ones."""

from __future__ import annotations

import pytest

from armproof.course.feedback import Outcome, Task, lessons, open_lesson

OWN = [(lesson.name, task.name) for lesson in lessons() for task in lesson.tasks if task.own]
SEEDS = ["Ana", "Léo", "7", *map(str, range(100, 117))]


def seeded(lesson: str, name: str, seed: str) -> Task:
    return getattr(open_lesson(lesson, seed=seed), name)  # type: ignore[no-any-return]


@pytest.mark.parametrize(("lesson", "name"), OWN)
def test_right_answers_are_proved_and_wrong_ones_told_for_every_seed(lesson: str, name: str) -> None:
    tasks = [seeded(lesson, name, seed) for seed in SEEDS]
    for task in tasks:
        assert {task.check(answer).outcome for answer in task.right} == {Outcome.PROVED}
        for wrong in task.wrong:
            feedback = task.check(wrong.answer)
            assert feedback.outcome is Outcome.WRONG
            assert wrong.words in feedback.message
    assert len({task.text for task in tasks}) >= 15
    usual = getattr(open_lesson(lesson), name)
    alike = [task for task in tasks if task.check(usual.right[0]).is_right]  # a sum may be the same
    assert len(alike) <= len(tasks) // 5


def test_a_teacher_reproduces_the_numbers_of_a_seed() -> None:
    assert OWN != []
    task = open_lesson("scara_jacobian", seed="Ana").prediction
    assert dict(task.numbers) == {"a_1": 0.365, "a_2": 0.195}  # on every machine, in every version of Python
    assert open_lesson("scara_jacobian", seed=7).prediction is open_lesson("scara_jacobian", seed="7").prediction
    assert not open_lesson("scara_jacobian").prediction.numbers
    assert "Your numbers (m): a₁ = 0.365, a₂ = 0.195." in str(task.check())
    assert "Your numbers" not in str(task.check(task.right[0]))
    french = open_lesson("scara_jacobian", lang="fr", seed="Ana").prediction
    assert "$a_1 = 0.365$" in french.text
