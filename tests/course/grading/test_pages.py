"""Tables and pages: everything of a student's is escaped, and the results of one are on their page alone."""

import csv
import html
import io
import re
from pathlib import Path

import pytest

from armproof.course.grading.grading import Grades, mark_repeated
from armproof.course.grading.pages import GRADES, results_table, submissions_table, write_grades
from armproof.course.grading.results import CellError, Graded, Status, TaskResult
from armproof.course.grading.running.protections import ATTEMPTS
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import Submission
from armproof.verification.report.html.folder import ReportFolderError, new_report

EVIL = "<script>alert(1)</script>"


def graded(student: str, file: str = "08.ipynb", status: Status = Status.GRADED, text: str = "fine") -> Graded:
    results = (
        TaskResult("frames", "rot", "Rot", "correct (proved)", text),
        TaskResult("frames", "inv", "Inv", "wrong", text),
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
        assert "default-src 'none'" in html.unescape(page) and not re.search(r"(?:src|href)=\"(?:\w+:|//)", page)


def test_the_index_says_which_protections_were_in_force(tmp_path):
    page = pages(tmp_path, grades(graded("a")))["index.html"]
    assert page.count("✓ in force") == len(ATTEMPTS) and "✗ not in force" not in page
    page = pages(tmp_path, grades(graded("a"), held=False))["index.html"]
    assert page.count("✗ not in force") == len(ATTEMPTS)


def test_the_tables_have_a_line_a_task_and_a_line_a_submission():
    both = [graded("a", text='=HYPERLINK("x"), "y"'), graded("b", status=Status.TIMED_OUT)]
    tasks = list(csv.DictReader(io.StringIO(results_table(both).decode("utf-8-sig"), newline="")))
    assert [(row["student"], row["lesson"], row["task"], row["outcome"]) for row in tasks[:2]] == [
        ("a", "frames", "rot", "correct (proved)"),
        ("a", "frames", "inv", "wrong"),
    ]
    assert len(tasks) == 4 and tasks[0]["message"] == '\'=HYPERLINK("x"), "y"'
    lines = list(csv.DictReader(io.StringIO(submissions_table(both).decode("utf-8-sig"), newline="")))
    assert [(row["status"], row["right"], row["tasks"], row["seconds"]) for row in lines] == [
        ("graded", "1", "2", "1.50"),
        ("timed out", "1", "2", "1.50"),
    ]


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
