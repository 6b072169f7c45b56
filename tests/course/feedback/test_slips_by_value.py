"""Two slips at once, or one that only samples tell, are said in words; of what is farther from right nothing is made up."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Formula, Number, Outcome, Quantity, Table, Task, Wrong, open_lesson

SWITCH = Formula(r"(1 - \sigma)\theta + \sigma d", ("sigma", "theta", "d"))
OPPOSITE = Formula(r"\theta_1 + \theta_2 - \psi", ("theta_1", "theta_2", "psi"), unit="rad")
ELBOW = Formula(r"\text{atan2}(K, \sqrt{f^2 - K^2}) - \beta", ("K", "f", "beta"), given={"K": r"f\sin(3\gamma)"}, symbols={"gamma": "free"}, unit="rad")  # fmt: skip
TURNED = Formula(r"\text{atan2}(x, y) - \text{atan2}(n, m)", ("x", "y", "m", "n"), unit="rad", symbols={"rho": "free", "gamma": "free"},
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)"})  # fmt: skip
OUT = Formula(r"\sqrt{x^2 + y^2} - l_1", ("x", "y", "l_1"))
POLAR = Formula(
    r"\begin{bmatrix} u \cos\theta - r w \sin\theta \\ u \sin\theta + r w \cos\theta \end{bmatrix}",
    ("r", "theta", "u", "w"),
)
HARMONIC = Formula(r"\frac{1}{x + y}", ("x", "y"))
TOOL = Quantity("planar_2r", {"origin": 2, "rows": [1, 2]})
FACING = Formula(r"\text{atan2}(y, x)", ("x", "y"), unit="rad", symbols={"rho": "free", "gamma": "free"},
    given={"x": r"\rho\cos(3\gamma)", "y": r"\rho\sin(3\gamma)"})  # fmt: skip
ABOUT = Formula(
    r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos\theta & -\sin\theta \\ 0 & \sin\theta & \cos\theta \end{bmatrix}",
    ("theta",),
)
TANGENT = Formula(r"u + v \tan\theta", ("u", "v", "theta"))
CIRCLE = Formula(r"l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta", ("l_1", "l_2", "theta"))
RADIUS = Formula(r"\sqrt{x^2 + y^2}", ("x", "y"))
SPEED = Formula(r"\frac{15}{8 t_f}", ("t_f",))
BACK = Formula("x - (d_6 + d_7) s", ("x", "d_6", "d_7", "s"))
REACH = Formula("x (l_1 C_2 - l_2 S_3)", ("x", "l_1", "l_2", "theta_2", "theta_3"), arm="planar_3r")
LINKS = Formula(
    "l_1 C_1 + l_2 C_{12} + l_3 C_{123}", ("theta_1", "theta_2", "theta_3", "l_1", "l_2", "l_3"), arm="planar_3r"
)
RPY = Formula(
    r"\mathrm{Rot}_z(\phi) \mathrm{Rot}_y(\theta) \mathrm{Rot}_x(\psi) \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    ("phi", "theta", "psi"),
)
JACOBIAN = Quantity("planar_3r", {"jacobian": 3})
CRANE = Table("planar_2r", "classic")


def turn(angle: Any, axis: str) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    X = np.full((4, 4), 0 * angle) + np.eye(4)
    X[i, i], X[i, j], X[j, i], X[j, j] = c, -s, s, c
    return X


def _of_links_before(q: Any, l_1: Any, l_2: Any, l_3: Any) -> Any:
    angles = np.cumsum(q)
    x, y = (np.cumsum([length * f(angle) for length, angle in zip((l_1, l_2, l_3), angles, strict=True)]) for f in (np.cos, np.sin))  # fmt: skip
    return np.array([-y, x, 0 * x, 0 * x, 0 * x, 1 + 0 * x])


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (SWITCH, r"(1 - \sigma) d + \theta", "two slips: d and \\theta are swapped; a factor"),
        (OPPOSITE, r"\pi - \theta_1 - \theta_2 - \psi", "two slips: the first term does not belong; wrong signs of terms 1 and 2"),
        (ELBOW, r"\arcsin\frac{f}{K} - \beta", "a quotient is upside down"),
        (ELBOW, r"\arcsin\frac{f}{K} + \beta", "two slips"),
        (TURNED, r"\arcsin\frac{x}{\sqrt{x^2 + y^2}} - \arcsin\frac{n}{\sqrt{m^2 + n^2}}", "atan2 of both sides"),
        (TURNED, r"\arccos\frac{y}{\sqrt{x^2 + y^2}} - \arccos\frac{m}{\sqrt{n^2 + m^2}}", "atan2 of both sides"),
        (OUT, r"\sqrt{x^2 + y^2 - l_1^2}", "stands under the root"),
        (OUT, r"\sqrt{(x - l_1)^2 + y^2}", "stands under the root"),
        (ELBOW, r"\text{atan2}(K, f) - \beta", "the longest side"),
        (ELBOW, r"\sin\frac{K}{f} - \beta", "sin where arcsin belongs"),
        (FACING, r"\text{atan2}(y, \sqrt{x^2 + y^2})", "the longest side"),
        (TURNED, r"\text{atan2}(x - n, y - m)", "the coordinates are subtracted"),
        (BACK, "x - d_6 d_7 s", "a product stands where a sum belongs"),
        (BACK, "(x - d_6 + d_7) s", "two slips"),
        (open_lesson("rx90_and_wrist").wrist_centre.asks, "[(C_1 a_3 C_2 - d_3) S_{23}, (S_1 a_3 C_2 - d_3) S_{23}, a_3 S_2 + d_3 C_{23}]", "around the wrong parts of a product"),
        (REACH, r"x l_1 (C_2 - l_2 S_3)", "brackets that are too wide"),
        (REACH, r"x (l_1 C_2 - l_2 C_3)", "cosine for sine"),
        (LINKS, "l_1 C_1 + 2 l_2 C_{12} + 3 l_3 C_{123}", "the first factor does not belong, in two places"),
        (RPY, lambda phi, theta, psi: turn(phi, "z") @ turn(psi, "x") @ turn(theta, "y"), r"in the order \phi, \psi, \theta, not \phi, \theta, \psi"),
        (RPY, lambda phi, theta, psi: turn(phi, "z") + turn(theta, "y") + turn(psi, "x"), "are added"),
        (RPY, lambda phi, theta, psi: turn(phi, "z") @ turn(psi, "x"), r"theta is missing"),
        (Number((0.0, 0.0, 0.0, 1.0)), [0, 0, 0, 4], "each of them is 1 or 0"),
        (Number((np.pi / 2, 0.4), "rad"), [np.pi / 2, 22.9], "in degrees? Radians"),
        (Number((np.pi / 2, 0.4), "rad"), [90, -22.918], "in degrees, where radians are asked for, and a sign is wrong"),
        (Number(0.375, "m/s"), "0.375 s", "s is not the unit: m/s is asked for"),
        (RPY, lambda phi, theta, psi: turn(psi, "z") @ turn(phi, "y") @ turn(theta, "x"), "stand in each other's places"),
        (ABOUT, lambda theta: turn(theta, "z")[:3, :3], "this turns about z, not about x"),
        (TURNED, r"\text{atan2}(x, y) \text{atan2}(n, m)", "a product stands where a sum belongs"),
        (ELBOW, r"\arcsin(\frac{K}{f} - \beta)", "in the argument of a function"),
        (ELBOW, r"\frac{\arcsin(K/f)}{\beta}", "a quotient stands where a difference belongs"),
        (BACK, "x s - d_6 - d_7", "a factor stands at the wrong term"),
        (TANGENT, r"u - v \sin\theta", "two slips: wrong sign of term 2; sin where tan belongs"),
        (CIRCLE, r"2 l_1 l_2 \cos\theta", "two slips: the term l_1^2 is missing; the term l_2^2 is missing"),
        (RADIUS, r"\sqrt{x y}", "a product stands where a sum belongs"),
        (Quantity("planar_2r", {"jacobian": 2, "rows": [1, 2], "columns": [1]}), "[-l_2 S_{12}, l_2 C_{12}]", "the column of joint theta_2, not of theta_1"),
        (SPEED, r"\frac{1.8}{t_f}", "times too small"),
        (Number((1.0, -1.0)), [0, 0], "each of them is 1 or -1"),
        (Number(0.7, "m").told_in("at 0.3 m, 0.4 m and 1.2 m"), 1.3, "the root of 0.3² + 0.4² + 1.2²"),
        (HARMONIC, r"\frac{1}{x} + \frac{1}{y}", "below the line is taken term by term"),
        (TOOL, r"\begin{bmatrix} (l_1 + l_2) C_{12} \\ (l_1 + l_2) S_{12} \end{bmatrix}", "index 2 does not belong"),
        (TOOL, r"[l_1 C_1 + l_2 C_2, l_1 S_1 - l_2 S_{12}]", "entry (1, 1): index 1 is missing; entry (2, 1): wrong sign of term 2"),
        (TOOL, r"[l_1 C_1 + l_2 C_2, l_1 S_1 + l_2 S_1]", "entry (2, 1)"),
        (POLAR, r"[u \cos\theta + r w \sin\theta, u \sin\theta - r w \cos\theta]", "entries (1, 1), (2, 1): wrong sign of term 2"),
        (JACOBIAN, _of_links_before, "not those before it"),
        (CRANE, [("theta_1", "l_1", 0, 0), ("theta_2", "l_2", 0, 0)], "a and d are exchanged in all rows"),
        (Table("scara", "classic"), [("theta_1", 0, "a_1", 0), ("theta_2", 0, "a_2", "pi"), ("theta_3", "d_3", 0, 0), ("theta_4", "d_4", 0, 0)],
            "joint 3 slides: it has no angle"),
        (HARMONIC, r"\infty", "that is infinite"),
    ],
)  # fmt: skip
def test_slips_are_named(asks: Any, answer: Any, words: str) -> None:
    try:
        message = asks.judge(answer).message
    except Exception as problem:
        message = str(problem)
    assert words in message


@pytest.mark.parametrize(
    ("asks", "answer"),
    [
        (SWITCH, r"(1 - \sigma)^2 d + 3\theta"),
        (TURNED, r"\arcsin\frac{x}{\sqrt{x^2 + n^2}} - 3 \arcsin\frac{n}{\sqrt{m^2 + y^2}}"),
        (HARMONIC, r"\frac{1}{x} + \frac{3}{y^2}"),
    ],
)
def test_nothing_is_made_up(asks: Any, answer: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert not any(words in feedback.message for words in ("two slips", "term by term", "`atan2`", "swapped"))


@pytest.mark.parametrize(
    ("asks", "answer"),
    [(ELBOW, r"\arcsin\frac{K}{f} - \beta"), (HARMONIC, r"\frac{\frac{1}{x y}}{\frac{1}{x} + \frac{1}{y}}")],
)
def test_what_is_right_is_no_slip(asks: Any, answer: str) -> None:
    assert asks.judge(answer).is_right


def test_known_mistakes_in_different_entries_are_said_together() -> None:
    known = (Wrong([6, -1], "two columns are equal", own=True), Wrong([5, 1], "they turn the same way", own=True))
    task = Task("aligned", "Title", "Text", Number((5.0, -1.0)), ("nudge",), ((5, -1),), known)
    assert task.check([6, 1]).message == "two columns are equal; they turn the same way"
    assert "two columns" not in task.check([4, -1]).message
    assert task.check([5, -1]).is_right
