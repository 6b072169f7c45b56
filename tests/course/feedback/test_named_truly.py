"""A wrong answer is told the mistake that was made: not another one that explains some of its entries, or all of them by chance."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Choice, Formula, Number, Outcome, Placement, Quantity, Scheme, Task, Wrong

CRANE = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"},
        {"alpha": "-pi/2", "a": "e", "d": 0, "theta": "theta_2"},
        {"alpha": "pi/2", "a": 0, "d": "d_3", "theta": 0},
    ],
}
TOOL, POSE = Quantity(CRANE, {"origin": 3}), Quantity(CRANE, {"pose": 3})
ELBOW = Quantity("spatial_rrr", {"jacobian": 3, "rows": [1, 2, 3]})
POLAR = Quantity("polar_rp", {"jacobian": 2, "rows": [1, 2], "columns": [2, 1]})
SCARA = Quantity("scara", {"jacobian": 4, "rows": [4, 5, 6]})
LINKS = Quantity("planar_3r", {"pose": 3})
CROSSED = Formula(r"\begin{bmatrix} 0 & -z & y \\ z & 0 & -x \\ -y & x & 0 \end{bmatrix}", ("x", "y", "z"))
INVERSE = Formula(r"\begin{bmatrix} \cos\theta & \sin\theta \\ -\frac{\sin\theta}{r} & \frac{\cos\theta}{r} \end{bmatrix}", ("theta", "r"))  # fmt: skip
BEHIND = Formula(r"\frac{1}{x y} \begin{bmatrix} y \cos u & y \sin u \\ -x \sin u & x \cos u \end{bmatrix}", ("x", "y", "u"))  # fmt: skip
AWAY = Formula(
    r"\begin{bmatrix} \cos\theta & \sin\theta & 0 & -x\cos\theta - y\sin\theta \\ -\sin\theta & \cos\theta & 0 & x\sin\theta - y\cos\theta \\ 0 & 0 & 1 & -z \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    ("theta", "x", "y", "z"),
)
TWO_ARCS = Formula(
    r"\text{atan2}(x, y) - \text{atan2}(n, m)", ("x", "y", "m", "n"), unit="rad", symbols={"rho": "free", "gamma": "free", "beta": "free"},
    given={"x": r"\rho\sin(5\beta + 3\gamma)", "y": r"\rho\cos(5\beta + 3\gamma)", "m": r"\rho\cos(3\gamma)", "n": r"\rho\sin(3\gamma)"},
)  # fmt: skip
BEHIND_A_RIGHT_ANGLE = Formula(
    r"\begin{bmatrix} \text{atan2}(\sqrt{s^2}, c) \\ x \end{bmatrix}", ("s", "c", "x"), unit="rad", symbols={"rho": "free"},
    given={"s": r"\frac{8\rho}{1 + 16\rho^2}", "c": r"\frac{1 - 16\rho^2}{1 + 16\rho^2}"},
)  # fmt: skip
TURNED = Formula(r"\begin{bmatrix} k\cos\theta - m\sin\theta \\ m\cos\theta + k\sin\theta \end{bmatrix}", ("theta", "k", "m"))  # fmt: skip
REACH = Formula("4 a^2 b^2 - (x^2 + y^2 - a^2 - b^2)^2", ("x", "y", "a", "b"))
COSINE = Formula(r"\frac{x^2 - a^2 - b^2}{2 a b}", ("x", "a", "b"), cases=({"x": 1.2, "a": 0.7, "b": 0.9},))
ARC = Formula(r"\arccos \frac{x}{2 a}", ("x", "a"), unit="rad")
PEAK = Formula(r"\frac{15}{8} \cdot \frac{q_f - q_0}{t_f}", ("q_0", "q_f", "t_f"))
DAMPED = Formula(r"\begin{bmatrix} \cos\theta \\ \frac{r}{1 + r^2} \end{bmatrix}", ("theta", "r"))
PRODUCT = Formula(r"a b \sin\theta", ("a", "b", "theta"))
TURNS = Formula(
    r"\begin{bmatrix} \cos\phi\cos\theta & -\sin\phi & \cos\phi\sin\theta \\ \sin\phi\cos\theta & \cos\phi & \sin\phi\sin\theta \\ -\sin\theta & 0 & \cos\theta \end{bmatrix}",
    ("phi", "theta"),
)
SQUARES = Formula(r"\begin{bmatrix} \frac{r}{1 + r^2} & \frac{1}{1 + r^2} \end{bmatrix}", ("r",))
RISE = Formula("a^2 + b^2 - (c - h)^2", ("a", "b", "c", "h"))


def about_z(angle: Any) -> Any:
    return np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])


def about_y(angle: Any) -> Any:
    return np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])


def bar(angle: Any, length: Any) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, length * c], [s, c, 0, length * s], [0, 0, 1, 0], [0, 0, 0, 1]])


def tool(theta_1: Any, theta_2: Any, d_3: Any, h: Any, e: Any) -> Any:
    out = e + d_3 * np.sin(theta_2)
    return [out * np.cos(theta_1), out * np.sin(theta_1), h + d_3 * np.cos(theta_2)]


def columns(*lines: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join(lines) + r" \end{bmatrix}"


ELBOW_ROWS = (r"-l_2 S_1 C_2 & -l_2 C_1 S_2 & 0", r"l_2 C_1 C_2 & -l_2 S_1 S_2 & 0", "0 & l_2 C_2 & 0")


@pytest.mark.parametrize(
    ("asks", "answer", "words", "never"),
    [
        (TOOL, lambda q, h, e: tool(q[0], q[0] + q[1], q[2], h, e), "added, as in a planar arm", "summed up twice"),
        (LINKS, lambda q, l_1, l_2, l_3: bar(q[0], l_1) @ bar(q[0] + q[1], l_2) @ bar(q[0] + q[1] + q[2], l_3), "summed up twice", "planar"),
        (LINKS, lambda q, l_1, l_2, l_3: bar(q[0], l_1) * bar(q[1], l_2) * bar(q[2], l_3), "@ multiplies matrices", "missing"),
        (LINKS, lambda q, l_1, l_2, l_3: bar(-q[0], l_1) @ bar(q[1], l_2) @ bar(-q[2], l_3), "joints theta_1, theta_3 are taken the other way", "entry"),
        (LINKS, lambda q, l_1, l_2, l_3: bar(q[0], l_1) @ bar(q[1], l_2) @ bar(-q[2], l_3), "joint theta_3 is taken the other way", "joints"),
        (LINKS, lambda q, l_1, l_2, l_3: bar(q[0], l_1) + bar(q[1], l_2) + bar(q[2], l_3), "are added: they are to be multiplied", "absolute"),
        (COSINE, lambda x, a, b: (x * 2 - a * 2 - b * 2) / (2 * a * b), "squares are missing", "units"),
        (COSINE, lambda x, a, b: np.cos((x**2 - a**2 - b**2) / (2 * a * b)), "the cosine of what is asked", "angle"),
        (TURNS, lambda phi, theta: about_z(phi) * about_y(theta), "`@` multiplies matrices", "missing"),
        (TOOL, lambda q, h, e: tool(q[0], q[1] + 90, q[2], h, e)[:2] + tool(q[0], q[1], q[2], h, e)[2:], "", "degrees"),
        (Quantity(CRANE, {"pose": 2, "in": 1}), lambda q, e: np.array([[np.cos(q[1] + 360), -np.sin(q[1] + 360), 0, e], [0, 0, 1, 0], [-np.sin(q[1] + 360), -np.cos(q[1] + 360), 0, 0], [0, 0, 0, 1]]), "an angle in degrees is taken as radians", "base frame"),
        (Quantity("spatial_rrr", {"origin": 3}), lambda q, l_1, l_2: [l_2 * np.cos(q[1]) * np.cos(q[2]), l_2 * np.sin(q[1]) * np.cos(q[2]), l_1 + l_2 * np.sin(q[2])], "is the first", "where"),
        (ELBOW, columns(ELBOW_ROWS[0].replace("-l_2 C_1", "l_2 C_1"), ELBOW_ROWS[1].replace("-l_2 S_1", "l_2 S_1"), ELBOW_ROWS[2]), "entries (1, 2), (2, 2): wrong sign", "the other way"),
        (ELBOW, columns(ELBOW_ROWS[0].replace("-l_2 S_1 C_2", "l_2 S_1 S_2"), ELBOW_ROWS[1].replace("l_2 C_1 C_2", "-l_2 C_1 S_2"), ELBOW_ROWS[2]), "are exchanged, and the sign is wrong", "another zero"),
        (SCARA, columns("0 & 0 & 0 & 0", "0 & 0 & 0 & 0", "1 & 1 & 1 & 1"), "entry (3, 4): wrong sign", "wrong order"),
        (POLAR, columns(r"\cos\theta & r\sin\theta", r"\sin\theta & -r\cos\theta"), "column 2: joint theta is taken the other way", "column 1"),
        (CROSSED, columns("x & -z & y", "z & y & -x", "-y & x & z"), "entries (1, 1), (2, 2), (3, 3): zero belongs there", "what stands there belongs"),
        (CROSSED, columns("0 & y & -z", "z & 0 & -x", "-y & x & 0"), "", "zero belongs there"),
        (INVERSE, columns(r"\frac{1}{\cos\theta} & -\frac{1}{r\sin\theta}", r"\frac{1}{\sin\theta} & \frac{1}{r\cos\theta}"), "each entry is inverted by itself", "times"),
        (INVERSE, columns(r"\cos\theta & -r\sin\theta", r"\sin\theta & r\cos\theta"), "", "by itself"),
        (BEHIND, BEHIND.latex.replace("x y}", "x}"), "your answer is y times what is asked", "the first factor"),
        (AWAY, AWAY.latex.replace(r"-x\cos\theta - y\sin\theta", "x").replace(r"x\sin\theta - y\cos\theta", "y").replace("-z", "z"), "the origin is that of the inverse", "missing"),
        (AWAY, AWAY.latex.replace("-z", "z"), "entry (3, 4): wrong sign", "inverse"),
        (TWO_ARCS, r"\text{atan2}(y, x) - \text{atan2}(m, n)", "the arguments of atan2 are exchanged", "the sign of the angle"),
        (TWO_ARCS, r"\text{atan2}(n, m) - \text{atan2}(x, y)", "sign", "arguments"),
        (BEHIND_A_RIGHT_ANGLE, columns(r"\arcsin s", "x"), "gives no angle beyond a quarter turn", "cosine has the wrong sign"),
        (BEHIND_A_RIGHT_ANGLE, columns(r"\arctan\frac{s}{c}", "x"), "`arctan` does not", "both arguments"),
        (BEHIND_A_RIGHT_ANGLE, columns(r"\text{atan2}(-s, -c)", "x"), "both arguments have the wrong sign", "`arctan` does not"),
        (TURNED, columns(r"(k - m)\cos\theta", r"(k + m)\sin\theta"), "a factor stands before brackets that are too wide", "cosine for sine"),
        (TURNED, columns(r"k\cos\theta - m\cos\theta", r"m\cos\theta + k\sin\theta"), "cosine for sine", "brackets"),
        (TURNED, columns(r"-m\cos\theta - k\sin\theta", r"k\cos\theta - m\sin\theta"), "entries (1, 1) and (2, 1) are exchanged, and the sign of one is wrong", "another direction"),
        (TURNED, columns(r"m\cos\theta + k\sin\theta", r"k\cos\theta - m\sin\theta"), "are swapped", "sign"),
        (REACH, "a^2 b^2 - (x^2 + y^2 - a^2 - b^2)^2", "a factor 4 is missing", "3 a^2"),
        (COSINE, "x^2 - a^2 - b^2 / 2 a b", "has two readings", "not equal"),
        (ARC, r"\arccos \frac{x}{a}", "a factor 2 is missing", "not equal"),
        (PEAK, r"1.875 \cdot \frac{q_f}{t_f}", "q_0 is missing", "numbers stand for"),
        (PEAK, r"\frac{15(q_f - q_0)}{8 t_f} - \frac{2 (q_f - q_0)}{t_f^3}", "does not belong", "where q_0 belongs"),
        (DAMPED, columns(r"\frac{\cos\theta}{1 + r^2}", r"\frac{r}{1 + r^2}"), "a divisor does not belong", "term"),
        (PRODUCT, r"(a + b) \sin\theta", "a sum stands where a product belongs", "times"),
        (PRODUCT, r"(a + \theta) \sin\theta", "", "a sum stands where a product"),
        (SQUARES, columns(r"\frac{r}{\sqrt{1 + r^2}} & \frac{1}{\sqrt{1 + r^2}}"), "a root does not belong", "differs from that"),
        (RISE, "a^2 + b^2 - (c + h)^2", "wrong sign of term 2", "term 1"),
        (Choice({"axis": "on axis 1", "circle": "on the circle"}, frozenset({"circle"})), "circle and axis", "that is not so", "there is more"),
    ],
)  # fmt: skip
def test_the_mistake_that_was_made_is_named(asks: Any, answer: Any, words: str, never: str) -> None:
    feedback = asks.judge(answer)
    assert feedback.outcome is Outcome.WRONG
    assert words in feedback.message
    assert never not in feedback.message


def test_words_beside_a_key_are_no_choice() -> None:
    where = Choice({"inside": "within", "outer": "on the edge"}, frozenset({"inside"}))
    assert where.judge("axis").outcome is Outcome.ERROR
    assert "there is more" not in where.judge("axis").message
    assert where.judge("the inside, and axis").outcome is not Outcome.PROVED


def test_what_stands_beside_a_variable_does_not_make_it_vanish() -> None:
    scheme = Scheme("planar_2r", {"A": (0, 0, 0), "B": ("l_1", 0, 0)})
    frames: dict[str, Any] = {"z": ["z", "z"], "O": ["A", "B"], "x": ["AB", "x"]}

    def said(*second: Any) -> str:
        return Placement(scheme, "table", frames).judge({**frames, "table": [(0, 0, 0, "theta_1"), second]}).message

    assert "(the constant offset)" in said(0, "l_1", 0, "theta_2 + pi/2")
    assert "(it should vanish)" in said("pi/2", "l_1", 0, "theta_2")
    assert "theta_1 is the variable of another joint" in said(0, "l_1", 0, "theta_1")


def test_a_known_mistake_in_some_numbers_is_told_beside_what_is_wrong_in_the_others() -> None:
    asks = Number((0.7, 0.9, 0.0), labels=("x", "y", "z"))
    known = Wrong([-1.1, 0.8, 0], "the columns are added without their rates", own=True)
    task = Task("velocity", "Velocity", "…", asks, (), ([0.7, 0.9, 0],), (known,))
    told = task.check([-1.1, 0.8, 1]).message
    assert told.startswith("the columns are added without their rates; z is not 1")
    assert "rates" not in task.check([0.7, 0.8, 1]).message
