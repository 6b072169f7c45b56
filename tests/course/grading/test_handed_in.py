"""When a submission was handed in: what nbgrader noted, else the file's own time; and how late that is."""

import os
from datetime import UTC, datetime, timedelta

import pytest

from armproof.course.errors import GradingError
from armproof.course.grading.handed_in import in_words, lateness, read_due, time_of

DUE = datetime(2026, 11, 20, 18, tzinfo=UTC)


def test_the_time_is_that_of_nbgrader_else_of_the_file(tmp_path):
    notebook, stamp = tmp_path / "a.ipynb", tmp_path / "timestamp.txt"
    notebook.touch()
    os.utime(notebook, (DUE.timestamp(), DUE.timestamp()))
    assert time_of(notebook) == DUE
    stamp.write_text("2026-11-20 20:15:00.500000 Europe/Paris\n", encoding="utf-8")
    assert time_of(notebook) == DUE + timedelta(minutes=75, seconds=0.5)
    for nonsense in ("yesterday", "2026-11-20 20:15 Nowhere/Else", ""):
        stamp.write_text(nonsense, encoding="utf-8")
        assert time_of(notebook) == DUE


@pytest.mark.parametrize(
    ("late", "words"),
    [
        (timedelta(seconds=-1), ""), (timedelta(), ""), (timedelta(seconds=1), "late by less than an hour"),
        (timedelta(hours=1, seconds=1), "late by 2 hours"), (timedelta(hours=24), "late by 24 hours"), (timedelta(hours=25), "late by 2 days"),
    ],
)  # fmt: skip
def test_late_is_said_in_begun_hours_and_days(late, words):
    assert in_words(lateness(DUE + late, DUE)) == words


def test_nothing_is_late_where_nothing_is_due():
    assert lateness(DUE, None) == lateness(None, DUE) == timedelta()


def test_a_day_is_meant_to_its_end():
    assert read_due("2026-11-20").strftime("%d %H:%M:%S") == "20 23:59:59"
    assert read_due("2026-11-20T18:00+00:00") == DUE
    for nonsense in ("tomorrow", "2026-13-01", "20/11/2026"):
        with pytest.raises(GradingError, match="is no date; write 2026-11-20"):
            read_due(nonsense)
