"""A right answer is right in whatever form students write it; a wrong one in the same form is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Choice, Formula, Number, Outcome, Quantity, open_lesson
from armproof.course.feedback.answer import as_latex
from armproof.course.feedback.spelling import parts_of

POSITION = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
POLAR = Formula(
    r"\begin{bmatrix} u \cos\theta - r w \sin\theta \\ u \sin\theta + r w \cos\theta \end{bmatrix}",
    ("r", "theta", "u", "w"),
)
COSINE = Formula(r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", ("x", "y", "l_1", "l_2"))
ROOT = Formula(r"\sqrt{x^2 + y^2}", ("x", "y"))
SPEED = Formula(r"\frac{15}{8 t_f}", ("t_f",))
DIRECTION = Formula(r"\text{atan2}(p_y, p_x)", ("p_x", "p_y"), unit="rad", symbols={"rho": "free", "gamma": "free"},
    given={"p_x": r"\rho\cos(3\gamma)", "p_y": r"\rho\sin(3\gamma)"})  # fmt: skip
BEND = Formula(r"-a_1 a_2 \sin\theta_2", ("theta_1", "theta_2", "a_1", "a_2"))
TURN = Formula(r"\begin{bmatrix} \cos\theta & -\sin\theta \\ \sin\theta & \cos\theta \end{bmatrix}", ("r", "theta"))
SIZES = Number((6.0, 7.0, 7.0, 1.0))
AXES = Choice({"z4": "axis 4", "z5": "axis 5", "z6": "axis 6"}, frozenset({"z4", "z5"}))
STEP = Choice({"alpha_0": "the twist", "a_0": "the length"}, "alpha_0")
RAM = Quantity({"dh": "modified", "rows": [{"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"}, {"alpha": "-pi/2", "a": 0, "d": "d_2", "theta": 0}],
    "joints": ["theta_1", "d_2"]}, {"axis": 2, "along": "z"})  # fmt: skip


@pytest.mark.parametrize(
    ("asks", "right", "wrong"),
    [
        (POLAR, r"[u\cos\theta - r w\sin\theta, u\sin\theta + r w\cos\theta]", r"[u\cos\theta - r w\sin\theta, u\sin\theta - r w\cos\theta]"),
        (POLAR, r"u\cos\theta - r w\sin\theta, u\sin\theta + r w\cos\theta", r"u\cos\theta, u\sin\theta"),
        (POLAR, "X = u cos(theta) - r w sin(theta), Y = u sin(theta) + r w cos(theta)".replace(" cos", "*cos").replace(" sin", "*sin").replace(" w", "*w"),
            "X = u*cos(theta), Y = u*sin(theta)"),
        (POLAR, r"\begin{aligned} X &= u\cos\theta - r w\sin\theta, \\ Y &= u\sin\theta + r w\cos\theta \end{aligned}",
            r"\begin{aligned} X &= u\cos\theta \\ Y &= u\sin\theta + r w\cos\theta \end{aligned}"),
        (POSITION, "l_1 C_1 + l_2 C_{12}; l_1 S_1 + l_2 S_{12}", "l_1 C_1 + l_2 C_2; l_1 S_1 + l_2 S_2"),
        (COSINE, "(x²+y²−l₁²−l₂²)/(2 l₁ l₂)", "(x²+y²−l₁−l₂)/(2 l₁ l₂)"),
        (ROOT, "np.hypot(x, y)", "np.hypot(x, x)"),
        (SPEED, "1,875/t_f", "1,785/t_f"),
        (SPEED, r"\frac{1,875}{t_f}", r"\frac{1,785}{t_f}"),
        (SIZES, "6x7, 7x1", "7x6, 7x1"),
        (SIZES, "J is 6×7 and the rates 7×1", "J is 7×6 and the rates 7×1"),
        (Number((6.0, 5.0)), "6 conditions, degree 5", "5 conditions, degree 6"),
        (Number((1.0, 2.0)), "row 1, column 2", "row 2, column 1"),
        (Number((0.0, 0.0, 1.0, 0.3), "m"), "O_1 = [0, 0, 1], a_1 = 0.3", "O_1 = [0, 0, 0], a_1 = 0.3"),
        (Number((2.0, 1.0, 0.0)), ["two", "one", "none"], ["two", "two", "none"]),
        (Number(8.0), "huit", "sept"),
        (Number((0.0, 2.0, 0.0), "m"), "x = 0, y = 200 cm, z = 0", "x = 0, y = 2 cm, z = 0"),
        (Number((0.0, 0.4, 0.15), "m"), "0, 40 cm, 15 cm", "0, 15 cm, 40 cm"),
        (Number(500.0, "m"), "about 500 m", "about 5000 m"),
        (Number(500.0, "m"), "L ≈ 500 m", "L ≈ 50 m"),
        (Number(500.0, "m"), r"$L = \frac{0.5}{0.001} = 500$", r"$L = \frac{0.001}{0.5} = 0.002$"),
        (Number(2.0, "rad/s"), r"\dot\theta = 2", r"\dot\theta = 4"),
        (Number(2.0, "rad/s"), "θ' = 2 rad/s", "θ' = 4 rad/s"),
        (Number(8.0), "2 × 2 × 2 = 8", "2 × 2 = 4"),
        (Number((0.6435011087932844, -0.9272952180016122), "rad"), ["atan2(0.3, 0.4)", "atan2(0.3,0.4) - pi/2"], ["atan2(0.4, 0.3)", "atan2(0.3,0.4) - pi/2"]),
        (Number(500.0, "m"), "500 000 mm", "5 000 m"),
        (Number((2.153, 0.0), "m"), "2 153 mm ; 0", "1 532 mm ; 0"),
        (AXES, "z4 & z5", "z4 & z6"),
        (Number((0.0, 0.0, 0.0, 1.0)), "0001", "0010"),
        (Number((2.0, 4.0)), "x2, x4", "x4, x2"),
        (Number(6.0), "6 (3 rotations, 3 translations)", "3 (3 rotations, 3 translations)"),
        (Number(6.0), "6 (3+3)", "5 (2+3)"),
        (Number(6.0), "six (6)", "five (5)"),
        (Number(8.0), "2³ = 8", "2² = 4"),
        (Number(0.375, "m/s"), "= 0.375", "= 0.75"),
        (Number(2.0, "rad/s"), "2 s^-1", "20 s^-1"),
        (Number((0.0, -1.0, 0.0)), "[0, -1, 0]^T", "[0, 1, 0]^T"),
        (Number((0.0, 0.3, -0.4), "m"), "(0 | 0.3 | -0.4)", "(0 | 0.3 | 0.4)"),
        (Number((-np.pi / 2, 0.0, 0.4), "rad"), "roll −π/2 pitch 0 yaw 0.4", "roll π/2 pitch 0 yaw 0.4"),
        (Number((-np.pi / 2, 0.0, 0.4), "rad"), "-90°, 0°, 22.918°", "-90°, 0°, 22.8°"),
        (Number(6.0), "3 + 3 = 6", "3 + 4 = 7"),
        (Number((-np.pi / 2, 0.0, 0.4), "rad"), "roll -pi/2, pitch 0, yaw 0.4", "roll pi/2, pitch 0, yaw 0.4"),
        (Number((-np.pi / 2, 0.0, 0.4), "rad"), "-pi/2; 0; 0.4", "-pi/2; 0.4; 0"),
        (Number((0.8, 0.75)), "sin θ = 0.8, tan φ = 0.75", "sin θ = 0.75, tan φ = 0.8"),
        (SIZES, "J: 6×7, q̇: 7×1", "J: 7×6, q̇: 7×1"),
        (BEND, "-a1 a2 sin(θ2)", "-a1 a2 sin(θ1)"),
        (TURN, "1/r * [[r*cos(theta), -r*sin(theta)], [r*sin(theta), r*cos(theta)]]", "1/r * [[cos(theta), -sin(theta)], [sin(theta), cos(theta)]]"),
        (Number(500.0, "m"), r"\frac{0.5}{0.001}", r"\frac{0.001}{0.5}"),
        (Number((np.pi / 2, 0.4), "rad"), [1.5708, 0.4], [1.58, 0.4]),
        (Number((np.pi / 2, 0.4), "rad"), [r"\frac{\pi}{2}", "0.4"], [r"-\frac{\pi}{2}", "0.4"]),
        (AXES, [4, 5], [5, 6]),
        (AXES, ("z_4", "(z5)"), ("z_4", "z_6")),
        (AXES, ["axis 4", "axis 5"], ["axis 4"]),
        (STEP, "α_0", "a_0"),
        (STEP, "option alpha_0", "option a_0"),
        (AXES, "axes 4 and 5", "axes 5 and 6"),
        (Choice({"vx": "v", "wx": "ω"}, "wx"), "ω_x", "v_x"),
        (DIRECTION, "np.arctan2(py, px)", "np.arctan2(px, py)"),
        (DIRECTION, "theta_1 = atan2(p_y, p_x)", "theta_1 = atan2(p_x, p_y)"),
        (Number((1.5, 1.196), "m"), ["1,5", "1,196"], ["1,5", "1,916"]),
        (Number(500.0, "m"), "0,5 / 0,001", "0,5 / 0,01"),
        (Number(500.0, "m"), r"500\,\text{m}", r"50\,\text{m}"),
        (Number(-1.0), "minus one", "one"),
        (Number((6.0, 5.0)), "six and five", "five and six"),
        (Number(np.pi / 2, "rad"), 1.571, 1.58),
        (SPEED, "v = 15/(8 t_f)", "v = 8/(15 t_f)"),
        (STEP, "the twist", "the length"),
        (RAM, lambda theta_1: [-np.sin(theta_1), np.cos(theta_1), 0], lambda theta_1: [np.cos(theta_1), np.sin(theta_1), 0]),
        (open_lesson("planar_dh").z_axes.asks, "z, z", "x, x"),
        (open_lesson("planar_dh").origins.asks, "AB", "BC"),
        (open_lesson("placing_frames").table.asks,
            {"alpha": [0, "pi/2", 0, "pi/2"], "a": [0, 0, "a_2", "e"], "d": [0, 0, 0, "d_4"], "theta": ["theta_1", "theta_2", "theta_3", 0]},
            {"alpha": [0, "pi/2", 0, "pi/2"], "a": [0, 0, "e", "a_2"], "d": [0, 0, 0, "d_4"], "theta": ["theta_1", "theta_2", "theta_3", 0]}),
    ],
)  # fmt: skip
def test_a_form_decides_nothing(asks: Any, right: Any, wrong: Any) -> None:
    assert asks.judge(right).is_right
    assert asks.judge(wrong).outcome is Outcome.WRONG


@pytest.mark.parametrize(
    "text", [r"\text{atan2}(y, x)", r"a\,b", "[a, b]", r"\begin{bmatrix} a & b \end{bmatrix}", "a,", ""]
)
def test_one_formula_is_not_taken_apart(text: str) -> None:
    assert parts_of(text) is None


def test_a_list_is_a_column_and_a_row_is_read_as_the_column_that_is_asked() -> None:
    assert as_latex(r"[\cos\theta, 0]") == r"\begin{bmatrix} \cos\theta \\ 0 \end{bmatrix}"
    right = POLAR.judge(POLAR.latex.replace(r"\\", "&"))
    assert right.is_right and "column" in right.notes[0]
    wrong = POLAR.judge(r"\begin{bmatrix} u & w \end{bmatrix}")
    assert not wrong.is_right and "1×2" not in wrong.message
    assert "1×3" in POLAR.judge(r"\begin{bmatrix} u & w & 0 \end{bmatrix}").message


def test_three_digits_are_enough_of_a_number_that_has_more_and_two_are_not() -> None:
    asked = Number((0.6435011, -1.5707963), "rad")
    assert asked.judge([0.644, -1.57]).outcome is Outcome.CONFIRMED
    assert asked.judge([0.64, -1.57]).outcome is Outcome.WRONG
    assert asked.judge([0.645, -1.57]).outcome is Outcome.WRONG
    assert Number(0.375, "m/s").judge(0.38).outcome is Outcome.WRONG


def test_numbers_that_are_right_to_four_digits_are_right_only_where_they_have_more() -> None:
    assert Number(np.pi / 2, "rad").judge(1.5708).outcome is Outcome.CONFIRMED
    assert Number(0.375, "m/s").judge(0.37503).outcome is Outcome.WRONG


def test_numbers_may_have_names_in_any_order_and_stand_in_latex() -> None:
    place = Number((0.25, 0.3, -0.1), "m", ("x", "y", "z"))
    assert place.judge({"z": -0.1, "X": 0.25, "y": 0.3}).is_right
    assert not place.judge({"x": 0.3, "y": 0.25, "z": -0.1}).is_right
    assert not place.judge({"x": 0.25, "y": 0.3}).is_right
    assert Number(500, "m").judge(r"5 \cdot 10^2").is_right
    assert not Number(500, "m").judge(r"5 \times 10^3").is_right


def test_of_an_angle_whole_turns_are_no_mistake() -> None:
    angles = Number((0.6435011087932844, -np.pi / 2), "rad", ("θ_1", "θ_2"))
    assert angles.judge([0.6435, 4.7124]).is_right
    assert angles.judge([0.6435, 3 * np.pi / 2]).is_right
    for wrong in ([0.6435, 4.6124], [0.6435, np.pi / 2], [36.87, -90.5], [0.6435, -90]):
        assert not angles.judge(wrong).is_right
    assert not Number(0.5, "rad/s").judge(0.5 + 2 * np.pi).is_right
