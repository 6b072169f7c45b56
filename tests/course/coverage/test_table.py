"""The table of the sources' exercises cites sheets and tasks that exist, and every line that is called asked is asked."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof.course.authoring.command import lesson
from armproof.course.coverage.table import Exercise, Status, faults, read_exercises
from armproof.course.feedback import lessons

EXERCISES = read_exercises()
SHEETS = {path.stem for path in Path("course/handouts").glob("*.md")}
TASKS = {f"{each.name}.{task.name}" for each in lessons() for task in each.tasks}


def asked(*tasks: str, sheets: tuple[str, ...] = ()) -> Exercise:
    return Exercise("001", "214-217", Status.ASKED, sheets, tasks, {"en": "Number the links", "fr": "Numéroter"})


def test_what_the_table_cites_exists_and_what_is_asked_has_a_task() -> None:
    assert list(faults(EXERCISES, SHEETS, TASKS)) == []


def test_no_exercise_of_the_sources_is_open() -> None:
    assert [row.citation for row in EXERCISES if row.status is Status.OPEN] == []


@pytest.mark.parametrize(
    ("row", "said"),
    [
        (asked("frames.compos"), "no task frames.compos"),
        (asked("frames.compose", sheets=("scara-999",)), "no sheet scara-999"),
        (asked(), "asked if a task asks it"),
        (replace(asked("frames.compose"), status=Status.OPEN), "asked if a task asks it"),
    ],
)
def test_a_row_that_does_not_stand_is_told(row: Exercise, said: str) -> None:
    (told,) = faults([row], SHEETS, TASKS)
    assert said in told
    assert told.startswith("001:214-217")


def test_every_document_is_there_line_by_line_in_both_languages() -> None:
    assert [*dict.fromkeys(row.document for row in EXERCISES)] == ["001", "002", "000", "004"]
    assert len({row.citation for row in EXERCISES}) >= 100
    assert all(row.words["en"] and row.words["fr"] and row.words["en"] != row.words["fr"] for row in EXERCISES)
    assert all(row.sheets for row in EXERCISES if row.status is not Status.NONE)


@pytest.mark.parametrize("sheet", sorted(name for name in SHEETS if re.search(r"-00\d", name)))
def test_a_sheet_of_a_source_asks_something_and_has_the_solution(sheet: str) -> None:
    text = (Path("course/handouts") / f"{sheet}.md").read_text(encoding="utf-8")
    questions = re.findall(r"\n\n([^\n#][^#]*)\n\n##+ Solution\n\n\S", text)
    assert questions and all(question.strip() for question in questions)


def test_the_command_prints_every_line_and_the_counts() -> None:
    result = CliRunner().invoke(lesson, ["coverage"])
    assert all(f"{row.citation}  " in result.output for row in EXERCISES)
    count = sum(row.status is Status.OPEN for row in EXERCISES)
    assert f"{count} open" in result.output
    assert result.exit_code == (1 if count else 0)
