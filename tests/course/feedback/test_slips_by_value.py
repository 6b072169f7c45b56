"""Two slips at once, or one that only samples tell, are said in words; of what is farther from right nothing is made up."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Formula, Outcome, Quantity, Table

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
JACOBIAN = Quantity("planar_3r", {"jacobian": 3})
CRANE = Table("planar_2r", "classic")


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
        (HARMONIC, r"\frac{1}{x} + \frac{1}{y}", "below the line is taken term by term"),
        (TOOL, r"\begin{bmatrix} (l_1 + l_2) C_{12} \\ (l_1 + l_2) S_{12} \end{bmatrix}", "brackets that are too wide"),
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
