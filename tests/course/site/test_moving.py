"""An arm that a reader moves on a page: its numbers and its script against Drake, its sliders under the keyboard."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Quantity
from armproof.course.figures.facts.moving import moving_of
from armproof.course.figures.facts.task import joint_ranges
from armproof.course.site.moving import moving_figure
from armproof.course.site.page import SITE
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.language import use
from armproof.models.numeric.plant import NumericKinematics
from tests.verification.report.browser import Browser
from tests.verification.report.test_in_browser import violations

ARROW = """
const slider = document.querySelectorAll("figure.hands input")[arguments[0]];
const before = [slider.value, document.querySelector("figure.hands .true").getAttribute("points")];
slider.focus();
return before;
"""
SEEN = """
const figure = document.querySelector("figure.hands"), slider = figure.querySelectorAll("input")[arguments[0]];
return [slider.value, figure.querySelector(".true").getAttribute("points"), slider.getAttribute("aria-valuetext"), figure.querySelector(":scope > p output").value];
"""
COMPUTED = """
const arm = JSON.parse(document.querySelector("figure.hands").dataset.arm);
return arguments[0].map(q => { const { tool, columns } = kinematics(arm, q); return [tool, columns, measures(arm, columns)]; });
"""


def configurations(arm: Arm) -> np.ndarray:
    rng = np.random.default_rng(4)
    return np.column_stack([rng.uniform(low, high, 12) for low, high in joint_ranges(arm)])


def poe(numbers: Mapping[str, Any], q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the tool's origin and Jacobian (6, n) by the product of exponentials, as the page's script has them."""
    R, t, joints = np.eye(3), np.zeros(3), []
    for joint, value in zip(numbers["joints"], q, strict=True):
        axis, point = np.array(joint["axis"]), np.array(joint["point"])
        z, start = R @ axis, R @ point + t
        joints.append((joint["kind"], z, start))
        if joint["kind"] == "prismatic":
            t = t + value * z
            continue
        K = np.cross(np.eye(3), axis)
        N = np.eye(3) + np.sin(value) * K + (1 - np.cos(value)) * K @ K
        t, R = t + R @ (point - N @ point), R @ N
    p = R @ np.array(numbers["tool"]) + t
    turns = [kind == "revolute" for kind, _, _ in joints]
    columns = [
        np.r_[np.cross(z, p - start), z] if turn else np.r_[z, np.zeros(3)]
        for turn, (_, z, start) in zip(turns, joints, strict=True)
    ]
    return p, np.column_stack(columns)


def differ(arm: Arm, numbers: Mapping[str, Any]) -> float:
    """Return how far the numbers of a page are from Drake's."""
    q = configurations(arm)
    kinematics, frame = NumericKinematics(arm, q), moving_of(arm).task.frame
    found = [poe(numbers, each) for each in q]
    origins = np.array([p for p, _ in found]) - kinematics.pose(frame)[:, :3, 3]
    return max(float(np.abs(origins).max()), float(np.abs(np.array([J for _, J in found]) - kinematics.jacobian(frame)).max()))  # fmt: skip


@pytest.mark.parametrize("name", arm_names())
def test_the_numbers_of_a_page_are_drakes(name: str) -> None:
    arm = load_arm(name)
    numbers = json.loads(json.dumps(moving_of(arm).numbers()))
    assert differ(arm, numbers) < 1e-7
    wrong = copy.deepcopy(numbers)
    wrong["joints"][0]["axis"] = [-part for part in wrong["joints"][0]["axis"]]
    assert differ(arm, wrong) > 0.01


@pytest.mark.parametrize("name", arm_names())
def test_all_that_an_arm_reaches_is_seen(name: str) -> None:
    moving = moving_of(load_arm(name))
    points = moving.projection.points(moving.task.points(configurations(moving.task.arm)))
    low, high = moving.window
    assert np.all(points >= low - 0.05 * (high - low)) and np.all(points <= high + 0.05 * (high - low))


def page_of(asked: Quantity, path: Path, lang: str = "en") -> Path:
    with use(lang):
        script = "".join((files("armproof.course.site") / "templates" / "hands.js").read_text(encoding="utf-8"))
        figure = moving_figure(asked, "m")
    style = SITE._style
    path.write_text(
        f'<!DOCTYPE html><html lang="{lang}"><head><meta charset="utf-8"><title>t</title><style>{style}</style></head>'
        f"<body><main><h1>t</h1>{figure}</main><script>{script}</script></body></html>",
        encoding="utf-8",
    )
    return path


@pytest.mark.parametrize(
    ("name", "frame"), [("planar_2r", 2), ("polar_rp", 2), ("spatial_rrr", "P"), ("scara", 4), ("rx90", 6)]
)
def test_the_script_computes_what_drake_does(browser: Browser, tmp_path: Path, name: str, frame: Any) -> None:
    arm = load_arm(name)
    browser.open(page_of(Quantity(name, {"pose": frame}), tmp_path / "page.html"))
    q, task = configurations(arm), moving_of(arm).task
    kinematics = NumericKinematics(arm, q)
    for (tool, columns, told), p, J in zip(
        browser.run(COMPUTED, q.tolist()),
        kinematics.pose(task.frame)[:, :3, 3],
        kinematics.jacobian(task.frame),
        strict=True,
    ):
        np.testing.assert_allclose(tool, p, atol=1e-7)
        np.testing.assert_allclose(np.array(columns).T, J, atol=1e-7)
        rows = J[task.places]
        assert told["w"] == pytest.approx(np.sqrt(max(np.linalg.det(rows @ rows.T), 0)), abs=1e-7)
        if len(rows) == len(columns):
            assert told["det J"] == pytest.approx(np.linalg.det(rows), abs=1e-7)
    assert browser.console() == []


def test_an_arrow_key_moves_the_arm_and_says_so(browser: Browser, tmp_path: Path) -> None:
    browser.open(
        page_of(Quantity("polar_rp", {"jacobian": 2, "rows": [1, 2], "columns": [2, 1]}), tmp_path / "page.html", "fr")
    )
    value, ellipse = browser.run(ARROW, 1)
    for kind in ("keyDown", "keyUp"):
        browser.command(
            "Input.dispatchKeyEvent",
            {"type": kind, "key": "ArrowRight", "code": "ArrowRight", "windowsVirtualKeyCode": 39},
        )
    after, moved, spoken, told = browser.run(SEEN, 1)
    assert int(after) == int(value) + 1 and moved != ellipse and spoken == f"{after}\u00a0mm"
    found = re.fullmatch(
        r"det J = (0,\d+)\u00a0m; w = \1\u00a0m", told
    )  # r, in the order of the columns that are asked
    assert found and float(found[1].replace(",", ".")) == pytest.approx(int(after) / 1000, abs=1e-3)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_in_a_figure_that_moves(browser: Browser, tmp_path: Path, scheme: str) -> None:
    browser.emulate(scheme=scheme)
    assert violations(browser, page_of(Quantity("scara", {"pose": 4}), tmp_path / "page.html")) == []
    browser.emulate()
