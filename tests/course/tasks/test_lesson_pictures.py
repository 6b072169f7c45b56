"""The pictures of lessons 9 to 12 show a student's answer over Drake's, and speak politely where there is none."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from armproof.course.feedback.notebook import Shown
from armproof.course.figures.registry import find_kind
from armproof.course.tasks import inverse_velocity, proofread, quintic, scara_inverse
from armproof.models.catalogue import load_arm

TARGET = {"X": 0.35, "Y": 0.4, "Z": 0.25, "psi": 0.3}
PICTURES: list[Any] = [
    pytest.param(lambda answer: scara_inverse.show_inverse(answer, **TARGET), scara_inverse.inverse, id="inverse"),
    pytest.param(inverse_velocity.show_rates, inverse_velocity.rates, id="rates"),
    pytest.param(quintic.show_motion, quintic.coefficients, id="motion"),
    pytest.param(quintic.show_tracking, quintic.coefficients, id="tracking"),
]
LESSONS = (Path(__file__).resolve().parents[3] / "course" / "lessons").glob("*.py")
DRAWN = re.compile(r'draw_kind\(find_kind\("(\w+)"\), load_arm\("(\w+)"\)\)')
SHOWN = sorted({each for path in LESSONS for each in DRAWN.findall(path.read_text(encoding="utf-8"))})
EVERY_PICTURE = pytest.mark.parametrize(("show", "right"), PICTURES)
SHEET = "---\narm: planar_2r\n---\n\n$$ p_2 = \\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\\\ l_1 S_1 + l_2 S_{12} \\\\ 0 \\end{bmatrix} $$\n"


def curves(figure: Figure, gid: str) -> list[np.ndarray]:
    return [np.array(line.get_xydata()) for axes in figure.axes for line in axes.lines if line.get_gid() == gid]


@EVERY_PICTURE
def test_an_answer_is_drawn(show: Callable[..., Any], right: Callable[..., Any]) -> None:
    assert isinstance(show(right), Figure)


@EVERY_PICTURE
@pytest.mark.parametrize("answer", [..., None, lambda *of: None, lambda *of: [1.0], lambda *of: 1 / 0, "x"])
def test_what_cannot_be_drawn_gets_a_sentence(show: Callable[..., Any], right: Callable[..., Any], answer: Any) -> None:
    assert isinstance(show(answer), Shown)


@pytest.mark.parametrize(("show", "right"), [PICTURES[1], PICTURES[2]])
def test_the_right_answer_lies_on_drakes_and_a_wrong_one_beside_it(
    show: Callable[..., Any], right: Callable[..., Any]
) -> None:
    def distance(figure: Figure) -> float:
        drake, answer = curves(figure, "drake"), curves(figure, "answer")
        assert len(drake) == len(answer) > 0
        return max(float(np.abs(one - other).max()) for one, other in zip(drake, answer, strict=True))

    assert distance(show(right)) < 1e-6
    assert distance(show(lambda *of: 1.1 * right(*of))) > 1e-2


def test_the_posture_is_one_of_drakes_two() -> None:
    figure = scara_inverse.show_inverse(scara_inverse.inverse, **TARGET)
    (answer,) = curves(figure, "answer")
    distances = [np.abs(answer - curves(figure, f"drake {k}")[0]).max() for k in (1, 2)]
    assert min(distances) < 1e-9 and max(distances) > 0.1


def test_a_target_out_of_reach_is_said_to_be() -> None:
    shown = scara_inverse.show_inverse(scara_inverse.inverse, **{**TARGET, "X": 0.9})
    assert "within reach" in str(shown)


def test_a_sheet_is_proofread_after_the_student_has_tried() -> None:
    assert "by hand" in str(proofread.proofread(SHEET, after=...))
    assert "1 proved" in str(proofread.proofread(SHEET, after=["1"]))
    assert "wrong sign" in str(proofread.proofread(SHEET.replace("l_1 S_1 +", "l_1 S_1 -")))


def test_what_is_no_sheet_gets_a_sentence() -> None:
    assert "cannot be checked: sheet.md" in str(proofread.proofread("---\narm: [\n---\n"))


def test_a_sheet_is_shown_without_its_front_matter() -> None:
    assert str(proofread.show_sheet(SHEET)).startswith("$$ p_2")


def test_a_figure_in_a_lesson_has_something_to_show() -> None:
    """A kind that an arm does not have would be drawn as the reason why."""
    assert {"link", "axes", "columns", "elbow", "quintic", "manipulability"} <= {kind for kind, _ in SHOWN}
    assert not [each for each in SHOWN if find_kind(each[0]).applies(load_arm(each[1]), "en") is not None]
    assert find_kind("elbow").applies(load_arm("polar_rp"), "en") is not None
