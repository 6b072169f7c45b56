"""Everything that a test wants to know of a page, asked while the browser shows it: on a screen, a phone and paper."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from tests.verification.report.browser import Browser

SCREEN, PHONE, PAPER = 1100, 360, 688  # px: a window; a small phone; A4 less its margins
SEEN = "return document.body.innerText"
MATRICES = """
let faults = [], tables = document.querySelectorAll("mtable");
for (const table of tables) {
  if (!table.closest("math")) faults.push(table.textContent);
  let bottom = -Infinity;
  for (const row of table.children) {
    const box = row.getBoundingClientRect();
    if (box.top < bottom - 1 || box.height < 5) faults.push(table.textContent);
    bottom = box.bottom;
    let right = -Infinity;
    for (const cell of row.children) {
      const place = cell.getBoundingClientRect();
      if (place.left < right - 1 || place.width < 2) faults.push(cell.textContent);
      right = place.right;
    }
  }
}
return [tables.length, faults];
"""
BEYOND = """
const edge = document.body.getBoundingClientRect().right + 1;
return [...document.querySelectorAll("math, table, svg")].filter(e => e.getBoundingClientRect().right > edge)
  .map(e => e.textContent.slice(0, 80));
"""
UNREACHABLE = """
return [...document.querySelectorAll(".display, .wide")].filter(d => d.scrollWidth > d.clientWidth + 1 && d.tabIndex < 0)
  .map(d => d.textContent.slice(0, 80));
"""


@dataclass(frozen=True)
class Survey:
    """What was found of one page.

    Attributes:
        seen: the text that a reader sees.
        console: what was written to the console.
        requests: what was asked for beside the page itself.
        matrices: how many matrices there are; `faults` are the rows and cells of them that do not lie where they should.
        scrolls: the width of the page on a phone (px).
        unreachable: what scrolls on a phone and takes no focus.
        cut: what does not fit on A4.
    """

    page: str
    seen: str
    console: list[str]
    requests: list[str]
    matrices: int
    faults: list[str]
    scrolls: int
    unreachable: list[str]
    cut: list[str]


def survey(browser: Browser, page: Path) -> Survey:
    """Open a page and ask everything of it."""
    browser.resize(SCREEN)
    browser.open(page)
    seen = browser.run(SEEN)
    matrices, faults = browser.run(MATRICES)
    browser.resize(PHONE, 700)
    scrolls, unreachable = browser.run("return document.documentElement.scrollWidth"), browser.run(UNREACHABLE)
    browser.emulate("print")
    browser.resize(PAPER, 1000)
    cut = browser.run(BEYOND)
    browser.emulate()
    browser.resize(SCREEN)
    requests = [address for address in browser.requests() if address != page.resolve().as_uri()]
    return Survey(page.name, seen, browser.console(), requests, matrices, faults, scrolls, unreachable, cut)


def survey_folder(browser: Browser, folder: Path) -> list[Survey]:
    """Return what was found of every page of a report."""
    return [survey(browser, page) for page in sorted(folder.glob("*.html"))]
