"""The notebooks made from a source: the student's, the instructor's, nbgrader's."""

from __future__ import annotations

import ast
import json
from pathlib import Path
from typing import Any

import pytest

from armproof.course.errors import SourceError
from armproof.course.sources.editions import instructor_notebook, student_notebook
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.nbgrader import nbgrader_notebook
from armproof.course.sources.places import COURSE

nbformat = pytest.importorskip("nbformat")
EDITIONS = [student_notebook, instructor_notebook, nbgrader_notebook]


@pytest.fixture
def small(lesson) -> LessonSource:
    return read_lesson_source(lesson()[1])


def cells(data: bytes) -> list[dict[str, Any]]:
    return json.loads(data)["cells"]


def sources(data: bytes) -> list[str]:
    return ["".join(cell["source"]) for cell in cells(data)]


@pytest.mark.parametrize("edition", EDITIONS)
def test_every_edition_is_a_valid_notebook_with_ids_of_its_own(edition, small):
    data = edition(small)
    nbformat.validate(json.loads(data))
    assert data == edition(small) and data.endswith(b"}\n")
    ids = [cell["id"] for cell in cells(data)]
    assert len(ids) == len(set(ids))
    assert all(cell.get("outputs", []) == [] and cell.get("execution_count") is None for cell in cells(data))


def test_a_cell_keeps_its_id_when_its_text_changes(lesson):
    before = student_notebook(read_lesson_source(lesson()[1]))
    after = student_notebook(read_lesson_source(lesson(("Return the area", "Give the area"))[1]))
    assert before != after
    assert [cell["id"] for cell in cells(before)] == [cell["id"] for cell in cells(after)]


def test_the_bytes_are_those_that_jupyter_writes(small):
    data = student_notebook(small)
    node = nbformat.reads(data.decode(), as_version=4)
    assert nbformat.writes(node) + "\n" == data.decode()


def test_a_student_gets_lines_to_fill_in_and_no_solution(small):
    found = sources(student_notebook(small))
    assert found[3] == (
        'def area(a, b):\n    """Return the area of a rectangle with a corner cut off."""\n'
        "    ...  # your code here\n\n\nlesson.area.check(area)"
    )
    assert found[4] == "root = ...  # your answer here\nlesson.root.check(root)"  # nobody reads `shift`
    assert found[5] == "joints = ...  # your answer here\nlesson.joints.check(joints)"
    assert not any("SOLUTION" in text or "corner =" in text for text in found)


def test_an_instructor_finds_the_solutions(small):
    found = sources(instructor_notebook(small))
    assert "corner = a**2 / 2" in found[3] and "### BEGIN SOLUTION" in found[3]
    assert len(found) == len(sources(student_notebook(small)))


@pytest.mark.parametrize(
    ("block", "expected"),
    [
        ("joints, links = 2, 3", "joints = ...  # your answer here"),
        ("import math\njoints = int(math.sqrt(4))", "joints = ...  # your answer here"),
        ("def joints():\n    return 2", "joints = ...  # your answer here"),
        ("joints = sum(1 for each in 'ab')", "joints = ...  # your answer here"),
        ("for joints in (1, 2):\n    other = joints", "joints = ...  # your answer here"),
        ("if True:\n    joints = 2\nelse:\n    joints = 3", "joints = ...  # your answer here"),
    ],
)
def test_the_names_that_a_solution_gives_a_value_are_left_to_fill_in(lesson, block: str, expected: str):
    read = read_lesson_source(lesson(("joints = 2", block))[1])
    assert sources(student_notebook(read))[5] == f"{expected}\nlesson.joints.check(joints)"


def test_a_solution_that_binds_nothing_becomes_one_line(lesson):
    read = read_lesson_source(lesson(("joints = 2", "print(2)"), ("check(joints)", "check(2)"))[1])
    assert sources(student_notebook(read))[5] == "...  # your answer here\nlesson.joints.check(2)"


# -- nbgrader ----------------------------------------------------------------------------------------------------------


def test_nbgrader_gets_answers_and_checks_in_cells_of_their_own(small):
    code = [cell for cell in cells(nbgrader_notebook(small)) if cell["cell_type"] == "code"]
    own = [cell["metadata"]["nbgrader"] for cell in code]
    assert all(item["schema_version"] == 3 and item["task"] is False for item in own)
    assert [(item["solution"], item["grade"], item["locked"]) for item in own] == [
        (False, False, True),
        *[(True, False, False), (False, True, True)] * 3,
    ]
    graded = [item for item in own if item["grade"]]
    assert [item["grade_id"] for item in graded] == ["small-area", "small-root", "small-joints"]
    assert [item.get("points") for item in own] == [None, *[None, 1] * 3]
    assert len({item["grade_id"] for item in own}) == len(own)


def test_nbgraders_solutions_keep_their_markers_and_its_checks_raise(small):
    found = nbgrader_notebook(small)
    for cell in cells(found):
        text, own = "".join(cell["source"]), cell["metadata"].get("nbgrader", {})
        assert ("### BEGIN SOLUTION" in text and "### END SOLUTION" in text) == own.get("solution", False)
        assert ("raise AssertionError" in text) == own.get("grade", False)
        if cell["cell_type"] == "code":
            ast.parse(text)


def test_a_check_that_nbgrader_cannot_grade_is_named(lesson):
    read = read_lesson_source(lesson(("lesson.joints.check", "print(lesson.joints.check"), ("check(joints)", "check(joints))"))[1])  # fmt: skip
    with pytest.raises(SourceError, match=r"03_small.py:\d+: nbgrader cannot grade this check; expected lesson.joints"):
        nbgrader_notebook(read)


def test_of_two_checks_of_a_task_the_last_earns_the_point(lesson):
    read = read_lesson_source(
        lesson(("lesson.joints.check(joints)", "lesson.joints.check(1)\nlesson.joints.check(joints)"))[1]
    )
    graded = [cell for cell in cells(nbgrader_notebook(read)) if cell["metadata"].get("nbgrader", {}).get("grade")]
    assert ["".join(cell["source"]).split("\n")[0] for cell in graded][-1] == "_feedback = lesson.joints.check(joints)"
    assert len(graded) == 3


@pytest.mark.parametrize("source", COURSE.sources(), ids=lambda path: path.stem)
def test_every_lesson_has_its_editions(source: Path):
    read = read_lesson_source(source)
    for edition in EDITIONS:
        nbformat.validate(json.loads(edition(read)))
    assert "BEGIN SOLUTION" not in student_notebook(read).decode()
    assert COURSE.notebook(source).read_bytes() == student_notebook(read), "armproof lesson build"
