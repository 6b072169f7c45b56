"""A class with a stand-in for the server: who is run, how often, and in which order the results are."""

import contextlib

import pytest

from armproof.course.errors import GradingError
from armproof.course.grading.grading import grade
from armproof.course.grading.results import Status
from armproof.course.grading.running.keeper import Ended
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import find_submissions

DONE = ['{"done": true, "changed": []}']


class Stand:
    """Answers each submission with what was prepared for its first cell, one after the other."""

    def __init__(self, **prepared: list[Ended]) -> None:
        self.prepared = prepared
        self.catalogue: list[dict[str, object]] = []
        self.held: dict[str, bool] = {}
        self.jobs = 2

    def run(self, cells: tuple[str, ...]) -> Ended:
        return self.prepared[cells[0]].pop(0)


@pytest.fixture
def graded(write, tmp_path, monkeypatch):
    def graded(**prepared: list[Ended]):
        stand = Stand(**prepared)
        monkeypatch.setattr("armproof.course.grading.grading.Client", lambda *_, **__: contextlib.nullcontext(stand))
        for name in prepared:
            write(f"{name}.ipynb", name)
        found = grade(find_submissions(tmp_path / "class"), Limits(seconds=10), 2)
        assert not any(stand.prepared.values())  # all that was prepared was asked for
        return {each.submission.student: each.status for each in found.graded}

    return graded


def test_what_timed_out_beside_others_without_a_processor_is_run_again_alone(graded):
    starved, busy = Ended("time", -9, 10, busy=1.0), Ended("time", -9, 10, busy=9.0)
    found = graded(starved=[starved, Ended(lines=DONE)], endless=[busy], sleeps=[starved, starved])
    assert found == {"endless": Status.TIMED_OUT, "sleeps": Status.TIMED_OUT, "starved": Status.GRADED}


def test_the_results_are_in_the_order_of_the_students(graded):
    names = [f"s{number}" for number in range(8)]
    assert list(graded(**{name: [Ended(lines=DONE)] for name in reversed(names)})) == names


def test_a_class_where_every_submission_may_read_is_refused(write, tmp_path, monkeypatch):
    write("anna.ipynb", "x = 1")
    monkeypatch.setattr("armproof.course.grading.sandbox.bubblewrap.readable_places", lambda: (tmp_path,))
    with pytest.raises(GradingError, match=r"every submission may read .*; put the class's folder somewhere else"):
        grade(find_submissions(tmp_path / "class"), Limits())
