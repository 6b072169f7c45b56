"""What a run reports is data: only what is well-formed counts."""

import json
from pathlib import Path

import pytest

from armproof.course.feedback import Outcome
from armproof.course.grading.judging import judge
from armproof.course.grading.notebook import Notebook
from armproof.course.grading.reports import OUTCOMES, read_report
from armproof.course.grading.results import Status
from armproof.course.grading.running.keeper import Ended, _with_token
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import Submission

CATALOGUE = [{"name": "frames", "number": 1, "title": {"en": "Frames", "fr": "Repères"}, "tasks": [{"name": "rot", "title": {"en": "Rot"}}, {"name": "inv", "title": {"en": "Inv"}}]}]  # fmt: skip
DONE = '{"done": true, "changed": []}'
GOOD = {"lesson": "frames", "task": "rot", "outcome": "correct (proved)", "message": "m", "answer": "x", "attempts": 1, "mistakes": [], "picture": None}  # fmt: skip


def result(**changes: object) -> str:
    return json.dumps({"results": [GOOD | changes]})


def judged(ended: Ended, **read: object):
    return judge(Submission("a", Path("a"), "a"), Notebook((), **read), ended, CATALOGUE, Limits())


def test_the_outcomes_are_those_of_the_feedback():
    assert set(OUTCOMES) == {outcome.value for outcome in Outcome}


def test_a_task_without_a_result_is_not_attempted():
    graded = judged(Ended(lines=[result(), DONE]))
    assert [(each.task, each.outcome) for each in graded.results] == [
        ("rot", "correct (proved)"),
        ("inv", "not attempted"),
    ]
    assert graded.status is Status.GRADED and graded.right == 1 and not graded.remarks


@pytest.mark.parametrize(
    "line",
    [
        result(answer=7), result(attempts=-1), result(mistakes=[7]), result(mistakes=3), result(picture="<svg >"),
        result(picture={"svg": "<p>", "caption": ""}), result(picture={"svg": "<svg " + "x" * 100_000, "caption": ""}),
        result(lesson="other"), result(task="other"), result(outcome="perfect"), result(message=7), result(lesson=[]),
        '{"results": 3}', '{"results": [3]}', "{", "[" * 100_000, '{"cell": -1}', '{"cell": "1"}', '{"error": {"cell": 1}}',
        '{"done": true}', "9" * 5000,
    ],
)  # fmt: skip
def test_what_is_not_well_formed_is_refused(line):
    report = read_report([line], CATALOGUE)
    assert report.refused == 1 and not report.results
    assert read_report([result()], CATALOGUE).refused == 0


def test_text_is_cut_and_lines_are_joined():
    report = read_report([result(message="a\nb\x1b" + "x" * 9999)], CATALOGUE)
    message = report.results["frames", "rot"].message
    assert message.startswith("a b�x") and len(message) < 600


@pytest.mark.parametrize(
    ("ended", "status", "words"),
    [
        (Ended("time", -9, 60.0, lines=['{"cell": 4}']), Status.TIMED_OUT, "ended after 60 s in code cell 4"),
        (Ended("memory", -9), Status.OUT_OF_MEMORY, "more than 1024 MB"),
        (Ended("disk", -9), Status.TOO_MUCH_OUTPUT, "MB of files"),
        (Ended("output", -9), Status.TOO_MUCH_OUTPUT, "printed more than 20 MB"),
        (Ended("sandbox", output="no"), Status.CRASHED, "it was not run: no"),
        (Ended("", 0, lines=['{"cell": 2}']), Status.CRASHED, "code cell 2 by exit code 0"),
        (Ended("", -11, lines=['{"cell": 2}']), Status.CRASHED, "the signal SIGSEGV"),
        (Ended("", 0, printed=300_000, lines=[DONE]), Status.TOO_MUCH_OUTPUT, "it printed 300 kB"),
        (Ended("", 0, lines=['{"error": {"cell": 1, "line": 1, "type": "E", "message": "", "memory": true}}', DONE]),
         Status.OUT_OF_MEMORY, "the others were run"),
        (Ended("", 0, lines=[DONE]), Status.GRADED, ""),
    ],
)  # fmt: skip
def test_how_a_run_ended_is_its_status(ended, status, words):
    graded = judged(ended)
    assert graded.status is status and words in graded.reason


def test_results_do_not_count_where_the_checks_were_changed():
    graded = judged(Ended(lines=[result(), '{"done": true, "changed": ["course.x"]}']))
    assert [each.outcome for each in graded.results] == ["error", "not attempted"] and graded.right == 0
    assert "it changed what checks the answers: course.x" in graded.remarks


def test_the_lesson_is_that_of_the_checks_else_that_opened_else_that_of_the_title():
    assert judged(Ended(lines=[result(), DONE])).lessons == ("1 · Frames",)
    assert judged(Ended(lines=[DONE]), lessons=("frames", "none")).lessons == ("1 · Frames",)
    assert judged(Ended(lines=[DONE]), title="Frames").lessons == ("1 · Frames",)
    unknown = judged(Ended(lines=[DONE]), title="Cooking")
    assert unknown.lessons == () and unknown.remarks == ("it opens no lesson of the course",)


def test_lines_without_the_token_are_foreign():
    assert _with_token(b"T{}\nT{1}\n", "T") == (["{}", "{1}"], False)
    assert _with_token(b"T{}\n{forged}\n", "T") == (["{}"], True)
