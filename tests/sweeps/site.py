"""Build the site of the whole course in both editions, twice, and look at every page in a browser.

    python -m tests.sweeps.site [--out DIR]

Exit code 1 if a build takes longer than 90 s, two differ, a page is not valid, shows LaTeX, asks for anything, is cut, breaks a
serious rule of axe-core, or lets a solution out.
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from armproof.course.site.build import build_site
from armproof.course.site.order import Order
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.places import COURSE
from tests.course.site.test_in_browser import HELD
from tests.course.site.test_page import check_valid
from tests.verification.report.browser import Browser
from tests.verification.report.survey import PHONE, SCREEN, survey
from tests.verification.report.test_in_browser import EMPTY_FORMULAS, violations

LONGEST = 90.0  # seconds of a build
UNFOLD = f"{EMPTY_FORMULAS}; document.querySelectorAll('details:not(.view)').forEach(each => {{ each.open = true; }})"
_TELLING = 20  # characters of a line of a solution that no question has by chance


def main() -> int:
    """Print what is found; return 1 if something is wrong."""
    parser = argparse.ArgumentParser(prog="python -m tests.sweeps.site", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--out", type=Path, help="where the sites are left; by default they are removed")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="armproof-site-") as folder:
        out = options.out or Path(folder)
        sources = tuple(COURSE.sources())
        faults = [*build_twice(sources, out), *leaks(sources, out / "site"), *look(out, Path(folder) / "profile")]
    for fault in faults:
        print(f"FAULT  {fault}")
    print(f"{len(faults)} faults")
    return 1 if faults else 0


def build_twice(sources: tuple[Path, ...], out: Path) -> Iterator[str]:
    """Build each edition twice; yield what is wrong with that."""
    for name, solutions in (("site", False), ("site-solutions", True)):
        order = Order(sources, solutions=solutions)
        for again in ("", "-again"):
            started = time.perf_counter()
            build_site(order, out / f"{name}{again}")
            seconds = time.perf_counter() - started
            print(f"{name}{again}: {len(order.sources)} lessons in {seconds:.1f} s")
            if seconds > LONGEST:
                yield f"{name}: {seconds:.0f} s, more than {LONGEST:.0f} s"
        first, second = (
            {path.name: path.read_bytes() for path in (out / folder).iterdir()} for folder in (name, f"{name}-again")
        )
        yield from (
            f"{name}/{file}: another one in the second build" for file in first if first[file] != second.get(file)
        )
        size = sum(len(data) for file, data in first.items() if not file.endswith("-3d.html"))
        print(f"{name}: {len(first)} files, {size / 1e6:.1f} MB without the 3D views")


def leaks(sources: tuple[Path, ...], site: Path) -> Iterator[str]:
    """Yield the lines of solutions that stand on a page or in a notebook of the students' site."""
    lines = 0
    for path in sources:
        source = read_lesson_source(path)
        given = "\n".join((site / f"{path.stem}{suffix}").read_text(encoding="utf-8") for suffix in (".html", ".ipynb"))
        text = re.sub(r"\s+|\\n", "", re.sub(r"<[^>]*>", "", given)).replace("&#39;", "'").replace("&#34;", '"')
        for line in solution_lines(source):
            lines += 1
            if line in text.replace("&gt;", ">").replace("&lt;", "<").replace('\\"', '"').replace("\\\\", "\\"):
                yield f"{path.stem}: '{line}' of a solution stands on the students' page or notebook"
    print(f"leaks: {lines} lines of solutions looked for")


def solution_lines(source: LessonSource) -> Iterator[str]:
    """Yield the telling lines of a lesson's solutions, without white space."""
    everything = "\n".join(cell.text for cell in source.cells)
    for cell, blocks in source.blocks.items():
        lines = source.cells[cell].text.split("\n")
        for block in blocks:
            for line in lines[block.first : block.last - 1]:
                bare = "".join(line.split())
                if len(bare) >= _TELLING and everything.count(line.strip()) == 1:
                    yield bare


def look(out: Path, profile: Path) -> Iterator[str]:
    """Yield what is wrong with a page in a browser."""
    with Browser(profile) as browser:
        for page in sorted(path for name in ("site", "site-solutions") for path in (out / name).glob("*.html")):
            if not page.name.endswith("-3d.html"):
                yield from (f"{page.parent.name}/{page.name}: {fault}" for fault in faults_of(browser, page))


def faults_of(browser: Browser, page: Path) -> Iterator[str]:
    """Yield what is wrong with one page."""
    try:
        check_valid(page.read_text(encoding="utf-8"))
    except AssertionError as error:
        yield f"not valid: {error}"
    found = survey(browser, page)
    code = browser.run(
        "document.querySelectorAll('code, pre').forEach(e => e.remove()); return document.body.innerText"
    )
    yield from (f"LaTeX: {text}" for text in re.findall(r".{0,20}[\\$].{0,20}", code)[:3])
    asked = [address for address in found.requests if not address.startswith("data:")]
    yield from (f"asks for {address}" for address in asked)
    yield from (f"console: {line}" for line in found.console)
    yield from (f"a matrix is not as it should be: {fault}" for fault in found.faults)
    yield from (f"cut on paper: {text}" for text in found.cut)
    if found.scrolls > PHONE:
        yield f"{found.scrolls} px wide on a phone"
    browser.open(page)
    browser.resize(PHONE, 700)
    yield from (f"scrolls and takes no focus: {text}" for text in browser.run(HELD))
    browser.resize(SCREEN)
    for scheme in ("light", "dark"):
        browser.emulate(scheme=scheme)
        serious = [rule for rule in violations(browser, page, UNFOLD) if rule[0] in ("serious", "critical")]
        yield from (f"axe, {scheme}: {rule}" for rule in serious)
    browser.emulate()


if __name__ == "__main__":
    sys.exit(main())
