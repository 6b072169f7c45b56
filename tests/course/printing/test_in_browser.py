"""A sheet in HTML in a real browser: on a phone, and to a screen reader."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.course.printing.printing import render
from tests.course.site.test_in_browser import HELD
from tests.verification.report.browser import Browser
from tests.verification.report.survey import PHONE, SCREEN
from tests.verification.report.test_in_browser import violations

POSE = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
LONG = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_1 C_2 - l_2 S_1 S_2 + l_1 - l_1 + l_2 - l_2 \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"  # fmt: skip
ERRATUM = "> **Erratum** (slide 3)\n> " + POSE.replace("l_2 S", "l_1 S")
TABLE = f"| {' | '.join('abcdefgh')} |\n|{'---|' * 8}\n| {' | '.join(['a long cell'] * 8)} |\n\n"
BODY = (
    f"## Part\n\n{POSE}<!-- own -->\n{LONG}{ERRATUM}<!-- own -->\n{TABLE}```\n{'x' * 200}\n```\n\n## Solution\n\n{POSE}"
)
NUMBERS = "return [...document.querySelectorAll('.tag')].map(each => each.getBoundingClientRect().right)"


@pytest.fixture
def page(document, make, tmp_path: Path) -> Path:
    """A sheet with all that there is on one, in both editions."""
    path = tmp_path / "sheet.html"
    path.write_bytes(render(make(document(BODY), solutions=True), "html"))
    return path


def test_axe_finds_nothing_serious_on_a_sheet(browser: Browser, page: Path) -> None:
    for width in (PHONE, SCREEN):
        browser.resize(width, 700)
        assert [rule for rule in violations(browser, page) if rule[0] in ("serious", "critical")] == [], width
    browser.resize(SCREEN)


def test_numbers_stay_in_view_beside_what_scrolls(browser: Browser, page: Path) -> None:
    browser.open(page)
    browser.resize(PHONE, 700)
    rights = browser.run(NUMBERS)
    browser.resize(SCREEN)
    assert len(rights) == 4 and max(rights) <= PHONE


def test_what_scrolls_takes_the_focus_and_what_took_none_would_be_noticed(browser: Browser, page: Path) -> None:
    browser.resize(PHONE, 700)
    browser.open(page)
    assert browser.run(HELD) == []
    browser.run("document.querySelector('[role=group]').removeAttribute('tabindex')")
    browser.run("document.querySelectorAll('.table').forEach(each => each.removeAttribute('tabindex'))")
    assert len(browser.run(HELD)) > 0
    browser.resize(SCREEN)
