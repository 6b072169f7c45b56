"""A lesson that was opened with a seed of the class is graded; one that a run makes up is not."""

from __future__ import annotations

import pytest

from armproof.course.feedback import Task, open_lesson
from armproof.course.grading.running.checker import load_course


def test_numbers_of_ones_own_are_graded(monkeypatch: pytest.MonkeyPatch, tmp_path):
    monkeypatch.setattr(Task, "check", Task.check)  # what recording changes is put back
    _, results = load_course(["scara_jacobian=Ana%20P.", "no_lesson=Ana"], "", str(tmp_path))
    own = open_lesson("scara_jacobian", seed="Ana P.").prediction
    own.check(own.right[0])
    assert [(each["task"], each["outcome"]) for each in results()] == [("prediction", "correct (proved)")]
    own.check(own.wrong[0].answer)
    assert [each["outcome"] for each in results()] == ["wrong"]
    other = open_lesson("scara_jacobian", seed="another of the run's making").prediction
    other.check(other.right[0])
    assert [each["outcome"] for each in results()] == ["wrong"]
