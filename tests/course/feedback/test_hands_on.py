"""An arm that sliders move in a notebook: the answer beside the truth, det J, and what is said where something is missing."""

from __future__ import annotations

import re
import sys
import types
from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Quantity, Task, open_lesson
from armproof.course.feedback.hands_on import HandsOn
from armproof.course.feedback.notebook import Shown
from armproof.course.tasks.placing_frames import RIG
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.stage import Stage

Q = np.array([0.3, 0.9])
RIGHT = r"\begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}"
WRONG = RIGHT.replace(r"\\ l_1", r"\\ -l_1")


def task(quantity: dict[str, Any], arm: str = "planar_2r") -> Task:
    return Task("it", "It", "?", Quantity(arm, quantity), (), (RIGHT,))


def picture(shown: Any, q: np.ndarray = Q) -> str:
    assert isinstance(shown, HandsOn)
    return re.sub("<style>.*?</style>", "", shown.picture(q), flags=re.DOTALL)


def values(html: str) -> list[float]:
    return [float(found.replace("−", "-")) for found in re.findall(r"det J = (\S+)", html)]


def lines(html: str, kind: str) -> list[str]:
    return re.findall(f'<polyline class="{kind}" points="([^"]+)"', html)


class Widget(types.SimpleNamespace):
    """A stand-in for a widget of ipywidgets: keeps what it is made of, and tells who observes its value."""

    def __init__(self, *children: Any, **given: Any) -> None:
        super().__init__(**{"children": children[0] if children else (), "told": [], "value": "", **given})

    def observe(self, handler: Any, names: str) -> None:
        assert names == "value"
        self.told.append(handler)

    def _repr_mimebundle_(self) -> dict[str, Any]:
        return {"application/vnd.jupyter.widget-view+json": {}}


@pytest.fixture
def widgets(monkeypatch: pytest.MonkeyPatch) -> None:
    module = types.ModuleType("ipywidgets")
    module.__spec__ = types.SimpleNamespace()  # type: ignore[assignment]
    for name in ("VBox", "HTML", "FloatSlider"):
        setattr(module, name, type(name, (Widget,), {}))
    monkeypatch.setitem(sys.modules, "ipywidgets", module)


def test_the_answer_stands_beside_the_truth_with_both_determinants() -> None:
    jacobian = task({"jacobian": 2, "rows": [1, 2]})
    J = NumericKinematics(load_arm("planar_2r"), Q[None]).jacobian("2")[0][:2]
    right, wrong = picture(jacobian.move(RIGHT)), picture(jacobian.move(WRONG))
    assert values(right) == [pytest.approx(np.linalg.det(J), abs=1e-3)] * 2
    claimed = J.copy()
    claimed[1, 0] -= 2 * 0.45 * np.cos(Q[0])
    assert values(wrong)[1] == pytest.approx(np.linalg.det(claimed), abs=1e-3) and values(wrong)[0] == values(right)[0]
    assert lines(right, "true") == lines(right, "printed") and lines(wrong, "true") != lines(wrong, "printed")


def test_an_answer_may_be_a_function_a_formula_or_not_there_yet() -> None:
    def origin(q, l_1, l_2):
        return [l_1 * np.cos(q[0]) + l_2 * np.cos(q[0]), l_1 * np.sin(q[0]) + l_2 * np.sin(q[0] + q[1]), 0]

    def waiting(q):
        raise NotImplementedError

    where = task({"origin": 2})
    assert "x₂′" in picture(where.move(origin)) and "Dashed" in picture(where.move(origin))
    assert "x₂′" in picture(where.move(r"\begin{bmatrix} l_1 C_1 \\ l_1 S_1 \\ 0 \end{bmatrix}"))
    for nothing in (..., None, waiting):
        html = picture(where.move(nothing))
        assert "Dashed" not in html and "cannot" not in html and len(lines(html, "true")) == 1
    assert "cannot be drawn" in picture(where.move(lambda q: 1 / 0))


def test_det_J_has_the_sign_of_the_columns_as_they_are_asked() -> None:
    q = np.array([0.4, 0.5])
    assert values(picture(task({"jacobian": 2, "rows": [1, 2], "columns": [2, 1]}, "polar_rp").move(), q)) == [-0.5]
    lesson = open_lesson("jacobian_columns")
    assert values(picture(lesson.polar_linear.move(lesson.polar_linear.right[0]), q)) == [0.5, 0.5]


def test_the_picture_stays_where_it_is_while_the_arm_moves() -> None:
    moved = task({"origin": 2}).move()
    first = [line.split()[0] for q in (Q, Q + 0.7) for line in lines(picture(moved, q), "link")]
    assert first[0] == first[1]


def test_at_a_singular_configuration_the_ellipse_is_flat() -> None:
    def width(q: list[float]) -> float:
        (ellipse,) = lines(picture(task({"origin": 2}).move(), np.array(q)), "true")
        points = np.array([[float(x) for x in point.split(",")] for point in ellipse.split()])
        return float(np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[1])

    assert width([0.3, 0.0]) < 1.0 < 10.0 < width([0.3, 1.2])


def test_each_slider_moves_the_picture(widgets: None) -> None:
    box = task({"origin": 2}).move().widget()
    *sliders, shown = box.children
    assert [slider.description for slider in sliders] == ["θ₁ (°)", "θ₂ (°)"]
    for slider in sliders:
        before, slider.value = shown.value, slider.value + 10
        slider.told[0]({})
        assert shown.value != before
    q = np.radians([slider.value for slider in sliders])
    assert shown.value == task({"origin": 2}).move().picture(q)
    bundle = task({"origin": 2}).move()._repr_mimebundle_()
    assert set(bundle) == {"application/vnd.jupyter.widget-view+json", "text/html"}


def test_drakes_viewer_follows_the_sliders(widgets: None, monkeypatch: pytest.MonkeyPatch) -> None:
    def pose(q, l_1, l_2):
        return np.array([[1, 0, 0, l_1], [0, 1, 0, 0.1], [0, 0, 1, 0], [0, 0, 0, 1.0]])

    seen: list[np.ndarray] = []
    monkeypatch.setattr(Stage, "move", lambda stage, q, time=0.0: seen.append(q))
    shown = task({"pose": 2}).move(pose, in_3d=True)
    slider, *_, frame = shown.widget().children
    assert isinstance(shown._stage, Stage) and shown._stage.meshcat.HasPath("answer/x")
    assert shown._stage.meshcat.web_url() in frame.value
    slider.value = 90.0
    slider.told[0]({})
    assert [q[0] for q in seen] == pytest.approx([shown.moving.start[0], np.pi / 2])


def test_an_arm_without_a_shape_says_so(widgets: None) -> None:
    *_, frame = HandsOn(load_arm(RIG), in_3d=True).widget().children
    assert "no shape" in frame.value


def test_without_sliders_the_picture_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    bundle = task({"origin": 2}).move()._repr_mimebundle_()
    assert "pip install ipywidgets" in bundle["text/plain"] and "<svg" in bundle["text/html"]


def test_what_is_no_quantity_of_an_arm_is_not_moved() -> None:
    assert isinstance(open_lesson("frames").predict.move(), Shown)
