"""Forces by their components: statics is decided for any of them."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"
FORCE = r"$$ F = \begin{bmatrix} F_x \\ F_y \end{bmatrix} $$"
FIRST = r"-(l_1 s_1 + l_2 s_{12}) F_x + (l_1 c_1 + l_2 c_{12}) F_y"
RIGHT, WRONG = r"-l_2 s_{12} F_x + l_2 c_{12} F_y", r"-l_2 s_{12} F_x - l_2 c_{12} F_y"
COLUMN = r"\begin{{bmatrix}} {} \\ {} \end{{bmatrix}}"


def verdicts_of(*parts: str) -> list[str]:
    return [record.verdict.value for record in verify_text(FRONT + "\n\n".join(parts) + "\n").equations]


@pytest.mark.parametrize(("second", "verdict"), [(RIGHT, "proved"), (WRONG, "refuted")])
@pytest.mark.parametrize(
    ("before", "statics"),
    [
        (FORCE, r"\tau = J^T F"),
        (r"With $F = (F_x, F_y)^T$:", r"\tau = J^T F"),
        ("", r"\tau = J^T " + COLUMN.format("F_x", "F_y")),
        ("", r"J^T " + COLUMN.format("F_x", "F_y")),
        ("", COLUMN.format(r"\tau_1", r"\tau_2") + " = J^T " + COLUMN.format("F_x", "F_y")),
        ("", r"\tau = J_v^T " + r"\begin{bmatrix} F_x \\ F_y \\ 0 \end{bmatrix}"),
    ],
)
def test_statics_holds_for_any_force(before: str, statics: str, second: str, verdict: str) -> None:
    assert verdicts_of(before, f"$$ {statics} = {COLUMN.format(FIRST, second)} $$")[-1] == verdict


def test_what_a_wrong_value_defined_refutes_no_right_one_behind_it() -> None:
    torques = COLUMN.format(r"\tau_1", r"\tau_2") + " = J^T " + COLUMN.format("F_x", "F_y")
    lines = [f"$$ {torques} = {COLUMN.format(FIRST, second)} $$" for second in (WRONG, RIGHT)]
    assert verdicts_of(*lines) == ["refuted", "proved"]


@pytest.mark.parametrize(
    ("told", "verdict"),
    [
        ("$$ F_x = 10 $$", "proved"),
        (r"$$ \begin{bmatrix} F_x \\ F_y \end{bmatrix} = \begin{bmatrix} 10 \\ 5 \end{bmatrix} $$", "proved"),
        ("$$ F_x = -k_x x $$", "unchecked"),
        ("", "unchecked"),  # it may be told below
    ],
)
def test_a_component_is_what_an_equation_says(told: str, verdict: str) -> None:
    ten = FIRST.replace("F_x", "10"), RIGHT.replace("F_x", "10")
    found = verdicts_of(FORCE, told, f"$$ \\tau = J^T F = {COLUMN.format(*ten)} $$")
    assert "refuted" not in found[:-1] and found[-1] == verdict


def test_one_letter_alone_is_no_force() -> None:
    assert verdicts_of(r"$$ F_x = l_1 c_1 $$", r"$$ x = F_x + l_2 c_{12} $$")[-1] == "proved"
    assert (
        verdicts_of(r"$$ \begin{bmatrix} N_x \\ N_y \end{bmatrix} = \begin{bmatrix} c_1 \\ s_1 \end{bmatrix} $$")[-1]
        != "refuted"
    )


CYLINDER = r"""# Cylindrical arm

The joint vector is $q = (\theta, h, r)^T$, in this order.

$$ p_x = r\cos\theta $$

$$ p_y = r\sin\theta $$

$$ p_z = h $$

$$ v^2 = \dot r^2 + r^2\,\dot\theta^2 + \dot h^2 $$

"""
POLAR = r"""# Polar arm

$$ x = (l + d)\cos\theta $$

$$ y = (l + d)\sin\theta $$

$$ \dot x^2 + \dot y^2 = \dot d^2 + (l+d)^2\,\dot\theta^2 $$

"""


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (POLAR + r"$$ \tau = (l + d)(F_y\cos\theta - F_x\sin\theta) $$", "proved"),
        (POLAR + r"$$ \tau = (l + d)(F_y\cos\theta + F_x\sin\theta) $$", "unchecked"),
        (POLAR + r"$$ \tau = l\,(F_y\cos\theta - F_x\sin\theta) $$", "unchecked"),
        (POLAR + r"$$ f = F_x\cos\theta + F_y\sin\theta $$", "proved"),
        (POLAR + r"$$ f = F_x\cos\theta - F_y\sin\theta $$", "unchecked"),
        (CYLINDER + r"$$ \tau_\theta = r\,(F_y\cos\theta - F_x\sin\theta),\qquad f_h = F_z,\qquad f_r = F_x\cos\theta + F_y\sin\theta $$", "proved"),
        (CYLINDER + r"$$ f_h = F_x $$", "unchecked"),
        (CYLINDER + r"$$ \tau_\theta = r\,(F_y\cos\theta + F_x\sin\theta) $$", "unchecked"),
        (CYLINDER + r"$$ J = \begin{bmatrix} -r\sin\theta & 0 & \cos\theta \\ r\cos\theta & 0 & \sin\theta \\ 0 & 1 & 0 \end{bmatrix} $$", "proved"),
        (CYLINDER + r"$$ J = \begin{bmatrix} -r\sin\theta & \cos\theta & 0 \\ r\cos\theta & \sin\theta & 0 \\ 0 & 0 & 1 \end{bmatrix} $$", "not passed"),
        (CYLINDER + r"$$ J = \begin{bmatrix} -r\sin\theta & 0 & \cos\theta \\ r\cos\theta & 0 & -\sin\theta \\ 0 & 1 & 0 \end{bmatrix} $$", "not passed"),
    ],
)  # fmt: skip
def test_efforts_and_columns_are_those_of_the_joints_by_their_letters(text: str, verdict: str) -> None:
    found = verify_text(text).equations[-1].verdict.value
    assert found in ("refuted", "unchecked") if verdict == "not passed" else found == verdict


IN_THE_PLANE = FRONT.replace(
    "---\n", "---\nquantities:\n  x: {origin: 2, component: x}\n  y: {origin: 2, component: y}\n", 1
)


@pytest.mark.parametrize(
    ("torque", "verdict"),
    [
        (r"\tau_1 = x F_y - y F_x", "proved"),
        (r"\tau_1 = x F_y + y F_x", "unchecked"),
        (r"\tau_1 = x F_x - y F_y", "unchecked"),
        (r"\tau_1 = x F_y - y F_x + M", "proved"),
        (r"\tau_1 = x F_y - y F_x - M", "unchecked"),
    ],
)
def test_coordinates_may_stand_in_a_torque(torque: str, verdict: str) -> None:
    moment = " and the moment $M$" if "M" in torque else ""
    text = f"{IN_THE_PLANE}\nThe hand exerts $(F_x, F_y)${moment} on a nut.\n\n$$ {torque} $$\n"
    assert verify_text(text).equations[-1].verdict.value == verdict


def test_a_moment_that_the_text_tells_acts_on_all_joints() -> None:
    said = "Die Hand übt die Kraft $(F_x, F_y)$ und das Moment $m$ aus."
    for rest, verdict in (("+ m", "proved"), ("- m", "refuted"), ("", "refuted")):
        torques = rf"$$ \tau_1 = {FIRST} + m $$", rf"$$ \tau_2 = {RIGHT} {rest} $$"
        assert verdicts_of(said, *torques) == ["proved", verdict]
