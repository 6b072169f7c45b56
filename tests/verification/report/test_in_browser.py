"""The pages in a real browser: what is shown, what is asked for, how it reads on a phone, on paper and to a screen reader."""

import re
from collections.abc import Sequence
from pathlib import Path

import axe_core_python
import pytest

from tests.verification.report.browser import Browser
from tests.verification.report.survey import PHONE, Survey, survey, survey_folder

AXE = Path(axe_core_python.__file__).with_name("axe.min.js")
OF_COLOURS = ("color-contrast", "link-in-text-block")  # all that a dark page can break and the light one does not
EMPTY_FORMULAS = "document.querySelectorAll('math').forEach(formula => formula.replaceChildren())"


@pytest.fixture(scope="module")
def course(browser: Browser, course_report: Path) -> list[Survey]:
    """What was found of every page of the course's report."""
    return survey_folder(browser, course_report)


@pytest.fixture(scope="module")
def others(browser: Browser, wrong_report: Path, hostile_report: Path) -> list[Survey]:
    """What was found of the pages of a wrong document and of hostile ones."""
    return [*survey_folder(browser, wrong_report), *survey_folder(browser, hostile_report)]


def test_the_course_shows_mathematics_and_no_latex(course: list[Survey]) -> None:
    assert len(course) > 3
    for page in course:
        assert len(page.seen) > 200
        assert not re.search(r"[\\$&]", page.seen), (page.page, re.findall(r".{0,20}[\\$&].{0,20}", page.seen)[:3])


def test_every_matrix_is_rendered(course: list[Survey]) -> None:
    """Each row of a matrix lies below the one before, each cell to the right of the one before, and has a size."""
    assert [page.page for page in course if page.faults] == []
    assert sum(page.matrices for page in course) > 100


def test_no_request_leaves_the_machine_and_the_console_stays_empty(course: list[Survey], others: list[Survey]) -> None:
    for page in (*course, *others):
        assert (page.requests, page.console) == ([], []), page.page


def test_a_phone_scrolls_a_wide_formula_and_never_the_page(course: list[Survey], others: list[Survey]) -> None:
    for page in (*course, *others):
        assert page.scrolls <= PHONE, page.page
        assert page.unreachable == [], page.page


def test_paper_cuts_nothing(course: list[Survey], others: list[Survey]) -> None:
    for page in (*course, *others):
        assert page.cut == [], page.page


def test_the_survey_notices_what_is_wrong(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(
        "<!DOCTYPE html><title>t</title><p>$$ x \\\\ y $$ &amp; <div><mtable><mtr>a matrix without its math</mtr></mtable></div>"
        "<div class='display' style='overflow:auto;width:100px'><svg width='900' height='9'></svg></div><svg width='900' height='9'>"
        "</svg><img src='missing.png'><script>console.error('x')</script>"
    )
    found = survey(browser, page)
    assert re.search(r"[\\$&]", found.seen) and found.faults and found.unreachable and found.cut
    assert found.console and found.requests and found.scrolls > PHONE


def test_a_page_prints_to_a4(browser: Browser, wrong_report: Path) -> None:
    browser.open(wrong_report / "planar-2r.html")
    pdf = browser.pdf()
    assert pdf.startswith(b"%PDF") and len(pdf) > 10_000


# -- accessibility -----------------------------------------------------------------------------------------------------


def violations(browser: Browser, page: Path, before: str = "", rules: Sequence[str] = ()) -> list[tuple[str, str, str]]:
    """Return the rules of axe-core, all or some, that a page breaks, after a script has run: (impact, rule, the first element)."""
    browser.open(page)
    browser.run(before)
    browser.command("Runtime.evaluate", {"expression": AXE.read_text(encoding="utf-8")})
    options = {"resultTypes": ["violations"], **({"runOnly": {"type": "rule", "values": [*rules]}} if rules else {})}
    found = browser.run("return axe.run(document, arguments[0]).then(r => r.violations)", options)
    return [(rule["impact"], rule["id"], rule["nodes"][0]["html"]) for rule in found]


def test_axe_finds_nothing_serious_in_the_course(browser: Browser, course_report: Path) -> None:
    """The formulas are left out here, for axe-core takes a minute over those of a long page; the next test has some."""
    for page in sorted(course_report.glob("*.html")):
        found = violations(browser, page, EMPTY_FORMULAS)
        assert [rule for rule in found if rule[0] in ("serious", "critical")] == [], page.name


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious_in_an_errata_sheet_with_its_formulas(
    browser: Browser, wrong_report: Path, scheme: str
) -> None:
    browser.emulate(scheme=scheme)
    for page in sorted(wrong_report.glob("*.html")):
        found = violations(browser, page, rules=OF_COLOURS if scheme == "dark" else ())
        assert [rule for rule in found if rule[0] in ("serious", "critical")] == [], page.name
    browser.emulate()


def test_axe_finds_what_is_wrong(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(
        "<!DOCTYPE html><html><title>t</title><p style='color:#bbb;background:#fff'>faint <img src='data:,'></p>"
    )
    assert {"color-contrast", "image-alt", "html-has-lang"} <= {rule for _, rule, _ in violations(browser, page)}
    assert {rule for _, rule, _ in violations(browser, page, rules=OF_COLOURS)} == {"color-contrast"}


def test_nothing_of_a_hostile_document_is_executed(browser: Browser, hostile_report: Path) -> None:
    found = sorted(hostile_report.glob("*.html"))
    assert len(found) == 4  # three documents and the index; one could not be checked
    for page in found:
        browser.open(page)
        assert browser.run("return window.attacked") is None, page.name
        assert browser.run("return document.querySelectorAll('img, script:not(:last-of-type), iframe').length") == 0
        assert "<script>" in browser.run("return document.body.innerText")  # it is there, as text


def test_a_script_that_slips_in_is_stopped_by_the_policy(
    browser: Browser, hostile_report: Path, tmp_path: Path
) -> None:
    spoiled = (hostile_report / "index.html").read_text(encoding="utf-8")
    attack = "<script>window.attacked=1</script><img src='http://192.0.2.1/x.png'>"
    (tmp_path / "page.html").write_text(spoiled.replace("</main>", f"{attack}</main>"), encoding="utf-8")
    browser.open(tmp_path / "page.html")
    assert browser.run("return window.attacked") is None
    assert len(browser.console()) >= 2  # two refusals


def test_equations_are_searched_and_filtered(browser: Browser, wrong_report: Path) -> None:
    browser.open(wrong_report / "planar-2r.html")
    shown = "return [...document.querySelectorAll('.equation')].filter(e => e.offsetParent !== null).map(e => e.dataset.state)"
    every = browser.run(shown)
    assert sorted(set(every)) == ["erratum", "proved", "refuted"]
    browser.run("document.querySelector('.filter input[value=refuted]').click()")
    assert browser.run(shown) == [state for state in every if state != "refuted"]
    assert (
        browser.run("return document.querySelector('[role=status]').textContent")
        == f"{len(browser.run(shown))} of {len(every)} shown"
    )
    browser.run("document.querySelector('.filter input[value=refuted]').click()")
    browser.run(
        "const s = document.querySelector('.filter input[type=search]'); s.value = 'VELOCITY wrong sign';"
        "s.dispatchEvent(new Event('input'))"
    )
    assert browser.run(shown) == ["refuted"]


def test_the_corrected_latex_is_copied(browser: Browser, wrong_report: Path) -> None:
    browser.open(wrong_report / "planar-2r.html")
    copied = browser.run(
        """
        const sheet = document.getElementById("sheet-line-20"), button = [...sheet.querySelectorAll(".copy")].pop();
        let taken = null;
        navigator.clipboard.writeText = text => { taken = text; return Promise.resolve(); };
        document.execCommand = () => { taken = document.activeElement.value; return true; };
        sheet.querySelectorAll("details").forEach(d => { d.open = true; });
        button.click();
        return new Promise(done => setTimeout(() => done([taken, button.firstChild.data]), 50));
        """
    )
    assert copied[0] and "& -l_2 S_{12}" in copied[0] and copied[1] == "Copied"


def test_the_page_works_without_scripts(browser: Browser, wrong_report: Path) -> None:
    browser.command("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.open(wrong_report / "planar-2r.html")
        tree = browser.command("Accessibility.getFullAXTree", {})["nodes"]
    finally:
        browser.command("Emulation.setScriptExecutionDisabled", {"value": False})
    named = [(node.get("role", {}).get("value"), node.get("name", {}).get("value", "")) for node in tree]
    assert not any(role == "button" for role, _ in named)  # what needs a script is not offered
    assert any(role == "heading" and name.startswith("Line 20") for role, name in named)
    assert any(role == "DisclosureTriangle" and "LaTeX" in name for role, name in named)
    assert any(role.startswith("MathML") or role == "math" for role, _ in named if role)
