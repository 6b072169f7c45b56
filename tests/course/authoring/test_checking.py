"""Checking lessons: a good one passes; whatever is wrong is found, with its file and line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from armproof.course.authoring.checking import lessons as checking
from armproof.course.authoring.checking.building import student_files, write_stale
from armproof.course.authoring.checking.lessons import check_lesson, check_lessons
from armproof.course.sources.kernel import Fault, Run
from armproof.course.sources.places import Place
from armproof.verification.document.cells import Cell
from tests.needs import needs

needs("nbclient")
WRONG = ("return a * b - corner", "return a * b + corner")
LEFT = ("### BEGIN SOLUTION\njoints = 2\n### END SOLUTION", "joints = 2")


def built(place: Place, source: Path) -> Path:
    write_stale(student_files(place, [source]))
    return source


@pytest.fixture
def without_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run cells in this process: a kernel takes a second to start."""

    def run_here(name: str, cells: list[Cell], place: Place, settings: dict[str, str]) -> Run:
        assert settings == {"LANGUAGE": "en"}
        place.notebooks.mkdir(exist_ok=True)
        monkeypatch.chdir(place.notebooks)
        monkeypatch.setenv("ARMPROOF_PROGRESS", "")
        space: dict = {}
        for index, cell in enumerate(cells):
            try:
                if cell.kind == "code":
                    exec(cell.source, space)  # noqa: S102 - the lesson of conftest.py
            except Exception as error:
                return Run(0.1, fault=Fault(index, None, f"{type(error).__name__}: {error}"))
        return Run(0.1, {name: told.as_json() for name, told in space["lesson"].results().items()})

    monkeypatch.setattr(checking, "run_cells", run_here)


def test_a_good_lesson_passes_in_a_kernel(lesson, tmp_path, monkeypatch):
    monkeypatch.setenv("ARMPROOF_PROGRESS", str(tmp_path / "progress.json"))
    place, source = lesson()
    [report] = check_lessons(place, [built(place, source)], 1)
    assert report.problems == ()
    assert (report.tasks, report.right, report.wrong) == (3, 5, 3)
    assert report.verdicts == {"proved": 1, "refuted": 1}
    assert report.seconds > 0.2 and report.student_seconds > 0.2 and len(report.check_seconds) == 2
    assert not (tmp_path / "progress.json").exists()  # whoever checks a lesson has not taken it
    assert sorted(path.name for path in place.notebooks.iterdir()) == ["03_small.ipynb"]


@pytest.mark.parametrize(
    ("change", "at", "message"),
    [
        (WRONG, "lesson.area.check(area)", "solved: the task 'area' is wrong, expected correct (proved)"),
        (LEFT, "lesson.joints.check(joints)", "the student's notebook: the task 'joints' is correct (proved), expected not"),
        (("lesson.joints.check", "1 / 0\nlesson.joints.check"), "1 / 0", "solved: ZeroDivisionError: division by zero"),
        (("lesson.joints.check", "import os\nos._exit(1)\nlesson.joints.check"), None, "solved: the kernel died"),
        (
            ("lesson.joints.check", "import traceback\ntry:\n    1 / 0\nexcept ZeroDivisionError:\n    print(traceback.format_exc())\nlesson.joints.check"),
            None, "solved: its output shows a traceback",
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_is_found_in_a_kernel(lesson, change, at: str | None, message: str):
    place, source = lesson(change)
    report = check_lesson(place, built(place, source))
    [found] = [problem for problem in report.problems if message in problem]
    assert at is None or found.startswith(f"{source}:{source.read_text().split(chr(10)).index(at) + 1}: ")


def test_two_lessons_are_checked_side_by_side_and_reported_in_order(lesson, monkeypatch):
    place, source = lesson()
    built(place, source)
    second = source.with_name("04_other.py")
    second.write_text("x = 1", encoding="utf-8")
    reports = list(check_lessons(place, [source, second], 2))
    assert [report.source for report in reports] == [source, second]
    assert [report.passes for report in reports] == [True, False] and reports[1].cannot_run


@pytest.mark.usefixtures("without_kernels")
def test_a_good_lesson_has_no_problems(lesson):
    place, source = lesson()
    assert check_lesson(place, built(place, source)).problems == ()


@pytest.mark.usefixtures("without_kernels")
@pytest.mark.parametrize(
    ("change", "at", "message"),
    [
        (WRONG, "lesson.area.check(area)", "solved: the task 'area' is wrong, expected correct (proved)"),
        (LEFT, "lesson.joints.check(joints)", "the student's notebook: the task 'joints' is correct (proved)"),
        (("check(root)", "check(root + nothing)"), None, "solved: NameError: name 'nothing' is not defined"),
        (("lesson.joints.check(joints)", "print(joints + 1)"), None, "the student's notebook: TypeError"),
        (("lesson.joints.check(joints)", ""), None, "03_small.py:1: the task 'joints' is never checked"),
        (
            ("lesson.joints.check(joints)", "if False:\n    lesson.links.check(joints)"),
            "    lesson.links.check(joints)", "no task 'links'; the tasks are area, root, joints",
        ),
        (("+ \\sin^2\\theta_1 = 1", "+ \\sin^2\\theta_1 = 2"), "# $$ \\cos^2\\theta_1 + \\sin^2\\theta_1 = 2 $$", "refuted: "),
        (("= 1 $$", "= \\Psi + \\Xi $$"), None, "unchecked: 'Psi' is not bound"),
        (("= 1 $$", "= \\Chi $$"), None, "unreadable: "),
        (("= \\sin\\theta_1 $$", "= -\\sin\\theta_1 $$"), None, "an erratum that is not refuted"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_found(lesson, change, at: str | None, message: str):
    place, source = lesson(change)
    report = check_lesson(place, built(place, source))
    found = [problem for problem in report.problems if message in problem]
    assert found, report.problems
    assert all(re.match(rf"{re.escape(str(source))}:\d+: ", problem) for problem in found)
    if at is not None:
        assert found[0].startswith(f"{source}:{source.read_text().split(chr(10)).index(at) + 1}: ")


@pytest.mark.usefixtures("without_kernels")
@pytest.mark.parametrize(
    ("change", "at", "message"),
    [
        (('right=("b + a",)', 'right=("b + a", "b - a")'), 'name="root"', "right answer 2, b - a: wrong: "),
        (("Wrong(3,", "Wrong(2,"), 'name="joints"', "wrong answer 1, 2: correct (proved)"),
        (
            ('Wrong("a - b", "sign")', 'Wrong("a - b", "index")'),
            'name="root"',
            "expected the words 'index', got wrong: ",
        ),
    ],
)
def test_an_answer_that_gets_other_words_is_named_with_its_task(lesson, change, at: str, message: str):
    place, source = lesson(tasks=change)
    report = check_lesson(place, built(place, source))
    file = place.tasks / "small.py"
    line = next(number for number, text in enumerate(file.read_text().split("\n")) if at in text)
    [found] = report.problems
    assert found.startswith(f"{file}:{line}: ") and message in found


@pytest.mark.usefixtures("without_kernels")
def test_a_stale_notebook_and_a_missing_one_are_found(lesson):
    place, source = lesson()
    [missing] = check_lesson(place, source).problems
    assert missing == f"{place.notebook(source)}: is missing; write it with: armproof lesson build"
    built(place, source)
    place.notebook(source).write_text(place.notebook(source).read_text().replace("rectangle", "square"))
    [stale] = check_lesson(place, source).problems
    assert stale == f"{place.notebook(source)}: is not what the source gives; write it with: armproof lesson build"


@pytest.mark.parametrize(
    ("change", "line", "message"),
    [
        (("number=3", "number=4"), 1, "declares the number 4; expected 3, as the file 03_small.py says"),
        (('name="joints"', 'name="root"'), 1, "task name 'root' is taken"),
        (("asks=Number(2)", "asks=Number(nothing)"), None, "NameError: name 'nothing' is not defined"),
        (("LESSON = ", "LESSON = = "), None, "SyntaxError"),
        (("LESSON = ", "OTHER = "), 1, "it is to declare LESSON = Lesson"),
    ],
)
def test_tasks_that_cannot_be_loaded_are_named(lesson, change, line: int | None, message: str):
    place, source = lesson(tasks=change)
    report = check_lesson(place, source)
    [problem] = report.problems
    assert report.cannot_run and message in problem
    number = int(re.match(rf"{re.escape(str(place.tasks / 'small.py'))}:(\d+): ", problem).group(1))
    text = (place.tasks / "small.py").read_text().split("\n")
    assert number == line or change[1] in text[number - 1]


def test_a_lesson_without_tasks_is_named(lesson):
    place, source = lesson()
    (place.tasks / "small.py").unlink()
    [problem] = check_lesson(place, source).problems
    assert problem == f"{source}:1: the lesson has no tasks; expected the file {place.tasks / 'small.py'}"
