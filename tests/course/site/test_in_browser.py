"""The pages of the site in a real browser: light and dark, on a phone, on paper, to a screen reader, without a network."""

from __future__ import annotations

import re
import time
from pathlib import Path

import pytest

from armproof.course.feedback import open_lesson
from armproof.course.site.arms import write_views
from armproof.course.site.index import write_index
from armproof.course.site.order import Neighbour, Order
from tests.course.site.conftest import NOT_ATTEMPTED, RIGHT, STREAM
from tests.course.site.test_page import ATTACK
from tests.verification.report.browser import Browser
from tests.verification.report.survey import PHONE, SCREEN, survey
from tests.verification.report.test_in_browser import OF_COLOURS, violations

WIDE = "x" * 200
LONG = r"[\theta_1, \theta_2, \theta_1 + \theta_2, l_1 + l_2, \theta_1 - \theta_2, l_1 - l_2, \theta_1 + l_1 + l_2]^T"
PICTURE = {"output_type": "display_data", "data": {"image/svg+xml": "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='200'/>"}}  # fmt: skip
HTML = {"output_type": "display_data", "data": {"text/html": f"<table><caption>t</caption><tr><td>{WIDE}</td></tr></table>{ATTACK}"}}  # fmt: skip
HELD = """
return [...document.querySelectorAll("body *")].filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 1 && e.tabIndex < 0
  && ["auto", "scroll"].includes(getComputedStyle(e).overflowX)).map(e => e.outerHTML.slice(0, 80));
"""  # what scrolls and takes no focus
TEXT = {"output_type": "stream", "name": "stdout", "text": WIDE}


@pytest.fixture(scope="module")
def site(page, lesson, tmp_path_factory) -> Path:
    """A folder with pages of both editions, a hostile one, an index and a 3D view."""
    out = tmp_path_factory.mktemp("site")
    outputs = {4: [STREAM, NOT_ATTEMPTED, PICTURE, HTML, TEXT], 5: [NOT_ATTEMPTED]}
    pages = {
        "student": page(outputs),
        "solutions": page({4: [RIGHT, PICTURE], 5: [RIGHT]}, solutions=True),
        "hostile": page({4: [HTML]}, title=f"{ATTACK} <b>", objective=ATTACK, words=ATTACK),
        "wide": page(words=f"Given ${LONG}$."),
    }
    source, place = lesson()
    opened = open_lesson(source.name, place.root)
    pages["index"] = write_index(
        [(opened, Neighbour(3, "The planar arm", source.path.stem, "planar_2r"))], Order((source.path,), place)
    )
    for name, html in pages.items():
        (out / f"{name}.html").write_text(html, encoding="utf-8")
    write_views(["planar_2r"], out, {"en": ""})
    return out


def test_pages_are_read_anywhere(browser: Browser, site: Path) -> None:
    """One opening of each page: mathematics and no LaTeX, no request, no error, nothing cut on a phone or on paper."""
    for name in ("student", "solutions", "hostile", "wide", "index"):
        found = survey(browser, site / f"{name}.html")
        text = found.seen.replace(ATTACK, "")
        assert len(text) > 200 and not re.search(r"[\\$]", text), name
        asked = [address for address in found.requests if not address.startswith("data:")]
        assert (asked, found.console, found.faults) == ([], [], []), name
        assert found.scrolls <= PHONE and found.cut == [], name
        browser.resize(PHONE, 700)
        assert browser.run(HELD) == [], name
        browser.resize(SCREEN)
    browser.open(site / "hostile.html")
    assert browser.run("return window.attacked") is None


def test_what_scrolls_and_takes_no_focus_is_noticed(browser: Browser, site: Path) -> None:
    text = (site / "student.html").read_text(encoding="utf-8")
    (site / "held.html").write_text(text.replace('<pre class="out" tabindex="0"', '<pre class="out"'), encoding="utf-8")
    browser.open(site / "held.html")
    assert len(browser.run(HELD)) == 1


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(browser: Browser, site: Path, scheme: str) -> None:
    browser.emulate(scheme=scheme)
    unfold = "document.querySelectorAll('details:not(.view)').forEach(each => { each.open = true; })"
    for name in ("student", "solutions", "index"):
        found = violations(browser, site / f"{name}.html", unfold, OF_COLOURS if scheme == "dark" else ())
        assert [rule for rule in found if rule[0] in ("serious", "critical")] == [], name
    browser.emulate()


def test_axe_finds_code_that_is_too_faint(browser: Browser, site: Path) -> None:
    faint = (site / "student.html").read_text(encoding="utf-8")
    for colour in ("#5d6470", "#a0a7b4"):
        faint = faint.replace(f"--comment: {colour}", "--comment: #c9ccd2").replace(
            "style-src", "style-src 'unsafe-inline'"
        )
    faint = re.sub(r"'sha256-[^']*'", "", faint.replace("&#39;", "'"))
    (site / "faint.html").write_text(faint, encoding="utf-8")
    assert "color-contrast" in {rule for _, rule, _ in violations(browser, site / "faint.html")}


def test_the_3d_view_is_loaded_when_it_is_asked_for_and_asks_for_nothing_else(browser: Browser, site: Path) -> None:
    browser.open(site / "student.html")
    assert not any("3d.html" in address for address in browser.requests())
    browser.run("document.querySelector('details.view').open = true")
    until, asked = time.monotonic() + 20, []
    while not any(address.endswith("planar_2r-3d.html") for address in asked) and time.monotonic() < until:
        time.sleep(0.1)
        asked += browser.requests()
    assert [address for address in asked if not address.startswith(("data:", "chrome:"))] == [
        (site / "planar_2r-3d.html").resolve().as_uri()
    ]
    assert not [line for line in browser.console() if "Content Security" in line or "Failed to load" in line]


def test_each_control_of_the_3d_view_has_a_name(browser: Browser, site: Path) -> None:
    browser.open(site / "planar_2r-3d.html")
    controls = "return [...document.querySelectorAll('.dg input, .dg select')].map(each => each.ariaLabel)"
    names = browser.run(controls)
    assert len(names) > 20 and all(names) and "Top color" in names
    assert browser.run("return document.querySelector('[role=main] > h1').textContent") == browser.run(
        "return document.title"
    )
    browser.run("document.querySelectorAll('.dg input').forEach(each => each.removeAttribute('aria-label'))")
    assert not any(browser.run(controls.replace(", .dg select", "")))  # it is these names that are read


def test_without_scripts_there_is_a_link_to_the_3d_view(browser: Browser, site: Path) -> None:
    browser.command("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.open(site / "student.html")
        tree = browser.command("Accessibility.getFullAXTree", {})["nodes"]
    finally:
        browser.command("Emulation.setScriptExecutionDisabled", {"value": False})
    named = [(node.get("role", {}).get("value"), node.get("name", {}).get("value", "")) for node in tree]
    assert any(role == "DisclosureTriangle" and name == "Turn it in 3D" for role, name in named)
    assert any(role == "heading" and name == "Where the tool is" for role, name in named)
    assert any(role == "navigation" and name == "Contents of this lesson" for role, name in named)
    assert '<a href="planar_2r-3d.html">' in (site / "student.html").read_text(encoding="utf-8")


def test_a_page_prints_to_a4(browser: Browser, site: Path) -> None:
    browser.open(site / "student.html")
    assert browser.pdf().startswith(b"%PDF")
    browser.emulate("print")
    hidden = "return [...document.querySelectorAll('.side, .view, .onward')].every(each => each.offsetParent === null)"
    assert browser.run(hidden)
    browser.emulate()
    assert not browser.run(hidden)
