"""Tables and pages: everything of a student's is escaped, and the results of one are on their page alone."""

import base64
import csv
import html
import io
import re
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from armproof.course.grading.grades import Grades
from armproof.course.grading.grading import mark_repeated
from armproof.course.grading.pages import GRADES, write_grades
from armproof.course.grading.results import CellError, Graded, Picture, Status, TaskResult
from armproof.course.grading.running.protections import ATTEMPTS
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import Submission
from armproof.course.grading.tables import tables
from armproof.course.grading.weights import Weights
from armproof.verification.report.html.folder import ReportFolderError, new_report

EVIL = "<script>alert(1)</script>"


def graded(student: str, file: str = "08.ipynb", status: Status = Status.GRADED, text: str = "fine") -> Graded:
    results = (
        TaskResult("frames", "rot", "Rot", "1 · Frames", "correct (proved)", text, text, 1),
        TaskResult(
            "frames", "inv", "Inv", "1 · Frames", "wrong", text, text, 2, (text,), Picture(f"<svg {text}>", text)
        ),
    )
    error = CellError(3, 1, f"Type{text}", text)
    return Graded(Submission(student, Path(file), f"{student}/{file}"), status, text, ("1 · Frames",), results, (error,),
                  (text,), (text,), text, 1.5)  # fmt: skip


def grades(*each: Graded, held: bool = True) -> Grades:
    return Grades(each, dict.fromkeys(ATTEMPTS, held), Limits())


def pages(tmp_path: Path, found: Grades) -> dict[str, str]:
    write_grades(tmp_path, found)
    return {path.name: path.read_text(encoding="utf-8") for path in tmp_path.glob("*.html")}


def test_each_student_has_a_page_with_their_own_results_only(tmp_path):
    found = pages(
        tmp_path,
        grades(graded("Anna", text="anna's"), graded("Zoë", text="zoës"), graded("Zoë", "09.ipynb", text="zoës")),
    )
    assert set(found) == {"index.html", "Anna.html", "Zoe.html"}
    assert "zoës" in found["Zoe.html"] and "zoës" not in found["Anna.html"]
    assert "2 of 4 tasks correct" in found["Zoe.html"] and "1 of 2 tasks correct" in found["Anna.html"]
    assert all(f'href="{name}"' in found["index.html"] for name in ("Anna.html", "Zoe.html"))


def test_names_and_texts_are_escaped(tmp_path):
    quoted = "\" onload='x' & é"
    found = pages(tmp_path, grades(graded(EVIL, f"{quoted}.ipynb", text=EVIL + quoted)))
    for page in found.values():
        assert EVIL not in page and "&lt;script&gt;alert(1)" in page
        assert "onload='x'" not in page and "é" in page
        scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
        assert len(scripts) == 1 and "alert" not in scripts[0]
        assert "default-src 'none'" in html.unescape(page) and not re.search(
            r"(?:src|href)=\"(?!data:image/svg)(?:\w+:|//)", page
        )


def test_the_index_says_which_protections_were_in_force(tmp_path):
    page = pages(tmp_path, grades(graded("a")))["index.html"]
    assert page.count("✓ in force") == len(ATTEMPTS) and "✗ not in force" not in page
    page = pages(tmp_path, grades(graded("a"), held=False))["index.html"]
    assert page.count("✗ not in force") == len(ATTEMPTS)


def test_the_tables_have_a_line_a_task_and_a_line_a_submission():
    both = [graded("a", text='=HYPERLINK("x"), "y"'), graded("b", status=Status.TIMED_OUT)]
    tasks = rows(grades(*both), "results.csv")
    assert [(row["student"], row["lesson"], row["task"], row["outcome"], row["attempts"]) for row in tasks[:2]] == [
        ("a", "frames", "rot", "correct (proved)", "1"),
        ("a", "frames", "inv", "wrong", "2"),
    ]
    assert len(tasks) == 4 and tasks[0]["message"] == tasks[0]["answer"] == '\'=HYPERLINK("x"), "y"'
    lines = rows(grades(*both), "submissions.csv")
    assert [(row["status"], row["right"], row["tasks"]) for row in lines] == [
        ("graded", "1", "2"),
        ("timed out", "1", "2"),
    ]


def rows(found: Grades, name: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(tables(found)[name].decode("utf-8-sig"), newline="")))


def test_seconds_stand_in_a_table_of_their_own(tmp_path):
    slow, quick = (grades(replace(graded("a"), seconds=seconds)) for seconds in (9.25, 1.0))
    differ = [name for name, table in tables(slow).items() if table != tables(quick)[name]]
    assert differ == ["times.csv"] and rows(slow, "times.csv")[0]["seconds"] == "9.25"
    assert pages(tmp_path, slow) == pages(tmp_path, quick)


def test_late_work_and_points_are_for_moodle_and_nbgrader_too(tmp_path):
    due = datetime(2026, 11, 20, 18, tzinfo=UTC)
    moodle = Submission("Ana", Path("x"), "Ana_7/x", "7", due + timedelta(hours=30))
    found = replace(
        grades(replace(graded("Ana"), submission=moodle), graded("Bo")),
        due=due, weights=Weights({("frames", "rot"): 3.0, ("frames", "inv"): 1.0, ("quintic", "line"): 4.0}),
    )  # fmt: skip
    assert [(row["Identifier"], row["Full name"], row["Grade"]) for row in rows(found, "moodle.csv")] == [
        ("Participant 7", "Ana", "37.50"), ("Bo", "Bo", "37.50")
    ]  # fmt: skip
    ana = rows(found, "nbgrader.csv")[0]
    assert (ana["assignment"], ana["student_id"], ana["score"], ana["max_score"]) == ("frames", "Ana", "3", "4")
    assert [row["hours_late"] for row in rows(found, "submissions.csv")] == ["30.00", "0.00"]
    found_pages = pages(tmp_path, found)
    assert "late by 2 days" in found_pages["Ana.html"] and "late by" not in found_pages["Bo.html"]


def test_the_picture_of_an_answer_is_an_image_of_its_own(tmp_path):
    page = pages(tmp_path, grades(graded("a", text="onload='x'")))["a.html"]
    data = re.search(r'<img alt="[^"]*" src="data:image/svg\+xml;base64,([^"]+)"', page)
    assert data and "onload" in base64.b64decode(data[1]).decode()  # where no browser runs it
    assert "<svg onload" not in page and "img-src data:" in html.unescape(page)


def test_earlier_results_are_replaced_and_nothing_else(tmp_path):
    for _ in range(2):
        with new_report(tmp_path / "out", GRADES) as part:
            write_grades(part, grades(graded("a")))
    (tmp_path / "out" / "notes.txt").touch()
    with (
        pytest.raises(ReportFolderError, match=r"holds 'notes.txt'.*--out takes"),
        new_report(tmp_path / "out", GRADES),
    ):
        pass


def test_a_lesson_handed_in_twice_is_remarked():
    first, second, other = mark_repeated([graded("a"), graded("a", "09.ipynb"), graded("b")])
    assert first.remarks[-1] == second.remarks[-1] == "another notebook of this student is on the same lesson"
    assert other.remarks == ("fine",)
