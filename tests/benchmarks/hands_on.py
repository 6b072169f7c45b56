"""A slider is moved: how soon the kernel has the new picture, and how many pictures a second a page of the site draws."""

from __future__ import annotations

import statistics
import tempfile
import time
from pathlib import Path

from armproof.course.feedback import open_lesson
from tests.course.site.test_moving import page_of
from tests.verification.report.browser import CHROMIUM, DRIVER, Browser

STEPS = 40
MOVED = (
    ("frames", "pose"),
    ("scara_jacobian", "jacobian"),
    ("spatial_rrr", "point"),
    ("jacobian_columns", "polar_linear"),
)
FRAMES = """
const slider = document.querySelector("figure.hands input");
return new Promise(done => {
  const started = performance.now();
  let drawn = 0;
  const step = now => {
    slider.value = Number(slider.min) + (3 * drawn++) % (slider.max - slider.min);
    slider.dispatchEvent(new Event("input"));
    if (now - started < 2000) requestAnimationFrame(step);
    else done(1000 * drawn / (now - started));
  };
  requestAnimationFrame(step);
});
"""


def rows() -> list[tuple[str, str, str]]:
    """Return what is printed: for each task with its answer the time of a step, and the pictures a second in Chromium."""
    found = [(f"{lesson}.{task}", f"{1000 * step(lesson, task):.1f} ms", "<= 50 ms") for lesson, task in MOVED]
    if CHROMIUM and DRIVER:
        found.append(("scara on the site, in Chromium", f"{pictures():.0f} /s", ">= 20 /s"))
    return found


def step(lesson: str, task: str) -> float:
    """Return the median of the times from a value to its picture, with the first right answer."""
    asked = getattr(open_lesson(lesson), task)
    moved = asked.move(asked.right[0])
    times = []
    for k in range(STEPS + 1):
        started = time.perf_counter()
        moved.picture(moved.moving.start + 0.01 * k)
        times.append(time.perf_counter() - started)
    return statistics.median(times[1:])


def pictures() -> float:
    """Return how many pictures a second a page draws while a slider is dragged."""
    asked = open_lesson("scara_jacobian").jacobian.asks
    with tempfile.TemporaryDirectory() as folder, Browser(Path(folder) / "profile") as browser:
        browser.open(page_of(asked, Path(folder) / "page.html"))
        return float(browser.run(FRAMES))
