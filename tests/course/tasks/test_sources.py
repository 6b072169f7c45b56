"""The sources of the lessons fit their tasks, and what students read in a notebook is what was verified."""

import re
from pathlib import Path

import pytest

from armproof.course.feedback import lessons

LESSONS = {path.stem[3:]: path for path in sorted(Path("course/lessons").glob("[0-9][0-9]_*.py"))}


def test_the_lessons_are_numbered_from_one_and_have_150_tasks_at_least() -> None:
    assert [lesson.number for lesson in lessons()] == list(range(1, len(LESSONS) + 1))
    assert [f"{lesson.number:02}_{lesson.name}" for lesson in lessons()] == [path.stem for path in LESSONS.values()]
    assert sum(len(lesson.tasks) for lesson in lessons()) >= 150


@pytest.mark.parametrize("name", LESSONS)
def test_a_lesson_meets_its_tasks_in_their_order(name: str) -> None:
    met = re.findall(r"^lesson\.(\w+)\.check\(", LESSONS[name].read_text(encoding="utf-8"), re.MULTILINE)
    (lesson,) = (lesson for lesson in lessons() if lesson.name == name)
    assert met == [task.name for task in lesson.tasks]


@pytest.mark.parametrize("name", LESSONS)
def test_a_quoted_display_stands_on_one_line(name: str) -> None:
    """JupyterLab takes mathematics out before it reads block quotes: the > of a second line would be shown."""
    quoted = [line for line in LESSONS[name].read_text(encoding="utf-8").splitlines() if line.startswith("# > ")]
    assert [line for line in quoted if line.count("$$") == 1] == []
