"""A class of invented students, graded in the sandbox, and its pages as a teacher sees them: on a projector, on a phone, in French.

`make sweep` grades all 30 students, `make test` ten of them, who make every kind of mistake.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.course.grading.glance import at_a_glance
from armproof.course.grading.grades import Grades
from armproof.course.grading.grading import grade
from armproof.course.grading.pages import write_grades
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import find_submissions
from armproof.models.language import use
from tests.course.grading.invented import write_class
from tests.laws import SWEEP
from tests.verification.report.browser import Browser
from tests.verification.report.survey import PHONE, survey
from tests.verification.report.test_in_browser import OF_COLOURS, violations

SHOWN = slice(0, 30) if SWEEP else slice(14, 24)
STUDENTS = SHOWN.stop - SHOWN.start
OPENED = "document.querySelectorAll('details').forEach(each => { each.open = true; });"


@pytest.fixture(scope="module")
def grades(bwrap: str, tmp_path_factory: pytest.TempPathFactory) -> Grades:
    folder = tmp_path_factory.mktemp("class")
    write_class(folder)
    return grade(find_submissions(folder)[SHOWN], Limits(seconds=120))


@pytest.fixture(scope="module", params=["en", "fr"])
def pages(request: pytest.FixtureRequest, grades: Grades, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp(request.param)
    with use(request.param):
        write_grades(out, grades)
    return out


def test_all_are_graded_and_the_sign_of_z_3_is_counted(grades: Grades):
    (lesson,) = at_a_glance(grades.graded)
    assert len(lesson.students) == len(grades.best) == STUDENTS and not any(each.needs_a_look for each in grades.graded)
    (lost,) = [each for each in lesson.mistakes if "its ω_z counts negative" in each.message]
    made = [each for each in grades.graded if any("1 & 1 & 0 & 1 " in result.answer for result in each.results)]
    assert {each.submission.student for each in made} <= set(lost.students) and lost.of == STUDENTS
    assert {len(task.results) for task in lesson.tasks} == {STUDENTS}


def test_an_answer_stands_beside_its_picture_and_the_attempts(grades: Grades):
    drawn = [result for each in grades.graded for result in each.results if result.picture]
    assert drawn and all(result.outcome == "wrong" and "<svg" in result.picture.svg for result in drawn)
    results = [result for each in grades.graded for result in each.results]
    assert all(
        bool(result.answer) == (result.outcome != "not attempted") == bool(result.attempts) for result in results
    )
    assert any(result.answer.startswith("def rotation(q):") for result in results)
    assert any(result.is_right and result.mistakes and result.attempts == 2 for result in results)


def test_the_pages_read_on_a_phone_and_ask_for_nothing(browser: Browser, pages: Path):
    for page in _shown(pages):
        found = survey(browser, page)
        asked = [
            each for each in found.requests if not each.startswith("data:image/")
        ]  # the pictures in the page itself
        assert (asked, found.console, found.unreachable, found.cut) == ([], [], [], []), page
        assert found.scrolls <= PHONE, page


def test_no_name_stands_beside_a_mistake_unless_it_is_opened(browser: Browser, pages: Path, grades: Grades):
    browser.open(pages / "index.html")
    shown = "return [...document.querySelectorAll('section[aria-labelledby^=lesson]')].map(each => each.innerText).join(' ')"
    names = list(grades.best)
    assert not any(name in browser.run(shown) for name in names)
    browser.run(OPENED)
    assert all(name in browser.run(shown) for name in names)


def test_axe_finds_nothing(browser: Browser, pages: Path):
    is_dark = "fr" in pages.name
    browser.emulate(scheme="dark" if is_dark else "light")
    for page in _shown(pages):
        assert violations(browser, page, OPENED, OF_COLOURS if is_dark else ()) == [], page
    browser.emulate()


def _shown(pages: Path) -> list[Path]:
    """The page of the class, and one of a student with a picture."""
    return [
        pages / "index.html",
        next(page for page in sorted(pages.glob("*.html")) if "<img" in page.read_text(encoding="utf-8")),
    ]
