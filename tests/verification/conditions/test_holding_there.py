"""What differs where joints have the values that a text gives is refuted; what holds there, and nowhere else, is left open."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

HEAD = r"""---
arm: planar_2r
quantities: {x: {origin: 2, component: x}, y: {origin: 2, component: y}}
---

For $\theta_1 = 90^\circ$ and $\theta_2 = -90^\circ$ the elbow is bent.

"""


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (r"\dot y = l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2)", "proved"),
        (r"\dot y = l_1 c_1 \dot\theta_1 + l_2 s_{12} (\dot\theta_1 + \dot\theta_2)", "refuted"),
        (r"x = l_1 c_1 - l_2 c_{12}", "refuted"),
        (r"y = l_1 s_1 - l_2 s_{12}", "unchecked"),  # it holds there
    ],
)
def test_values_excuse_what_holds_with_them_alone(display: str, verdict: str):
    assert verify_text(f"{HEAD}$$ {display} $$\n").equations[0].verdict.value == verdict


@pytest.mark.parametrize(
    ("behind", "verdicts"),
    [
        ("The singular configuration is", {"refuted"}),
        ("This is so in the stretched configuration", {"refuted", "unchecked"}),
    ],
)
def test_a_determinant_in_letters_is_none_at_a_singular_configuration(behind: str, verdicts: set[str]):
    text = f"---\narm: planar_2r\n---\n\n$$ \\det J = l_1 l_2 c_1 $$\n\n{behind}\n\n$$ \\theta_2 = 0 $$\n"
    assert verify_text(text).equations[0].verdict.value in verdicts
