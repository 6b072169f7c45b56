"""The letters of joints whose angle in the DH table has an offset: an inverse means them as the displays do."""

from pathlib import Path

import pytest

from armproof.verification.check import verify_text
from armproof.verification.document import parse_document
from armproof.verification.inverse import read_inverse

HEAD = r"""---
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: Q_1}
    - {a: l_2, alpha: 0, d: 0, theta: Q_2 - pi/2}
  joints: [Q_1, Q_2]
inverse: {target: [x, y]}
---

"""
BOUND = "quantities: {x: {origin: 2, component: x}, y: {origin: 2, component: y}}\n---\n\n"
OF_TABLE = r"$$x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12}$$" + "\n\n"
OF_VARIABLES = r"$$x = l_1 c_1 + l_2 s_{12}, \quad y = l_1 s_1 - l_2 c_{12}$$" + "\n\n"
TOLD = r"$$\theta_1 = q_1, \quad \theta_2 = q_2 - \frac{\pi}{2}$$" + "\n\n"
D = r"$$D = \frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}$$" + "\n\n"
TABLE = (
    D
    + r"""$$\theta_2 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D)$$

$$\theta_1 = \operatorname{atan2}(y, x) - \operatorname{atan2}(l_2 s_2, l_1 + l_2 c_2)$$
"""
)
VARIABLES = (
    D
    + r"""$$\theta_2 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D) + \frac{\pi}{2}$$

$$\theta_1 = \operatorname{atan2}(y, x) - \operatorname{atan2}(-l_2 c_2, l_1 + l_2 s_2)$$
"""
)


def page(body: str, letter: str = r"theta", bound: bool = True) -> str:
    """Return a document on the arm whose joints have that letter."""
    head = HEAD.replace("Q", letter)
    return (head.replace("---\n\n", BOUND) if bound else head) + body


@pytest.mark.parametrize("bound", [True, False])
@pytest.mark.parametrize(
    ("body", "verdict"),
    [
        (OF_TABLE + TABLE, "proved"),
        (OF_VARIABLES + VARIABLES, "proved"),
        (OF_VARIABLES + TABLE, "unchecked"),  # right of the other angle
        (OF_TABLE + VARIABLES, "unchecked"),
        (OF_TABLE + TABLE.replace("(y, x) -", "(y, x) +"), "refuted"),
        (OF_VARIABLES + VARIABLES.replace("(-l_2", "(l_2"), "refuted"),
        (OF_TABLE + VARIABLES.replace("(-l_2", "(l_2"), "refuted"),
    ],
)
def test_an_inverse_means_the_angles_as_the_displays_do(body: str, verdict: str, bound: bool) -> None:
    inverse = verify_text(page(body, bound=bound)).inverse
    assert inverse is not None and inverse.verdict.value == verdict


@pytest.mark.parametrize(
    ("body", "verdict"),
    [
        (TOLD + TABLE, "proved"),
        (TOLD + TABLE.replace(r"\theta_2 =", "q_2 ="), "refuted"),
        (TOLD + TABLE.replace("(y, x) -", "(y, x) +"), "refuted"),
        (TABLE + "$$q_1 + q_2$$", "proved"),
        (VARIABLES + "$$q_1 + q_2$$", "unchecked"),  # nobody says what q_2 is
    ],
)
def test_beside_the_variables_the_letter_means_the_angle_of_the_table(body: str, verdict: str) -> None:
    inverse = verify_text(page(body, "q")).inverse
    assert inverse is not None and inverse.verdict.value == verdict


@pytest.mark.parametrize("body", [TABLE, VARIABLES])
def test_solutions_are_values_of_the_variables(body: str) -> None:
    inverse = read_inverse(parse_document(Path("page.md"), page(body)))
    found = inverse.solve(inverse.forward([[0.4, 0.9]]))
    assert found.valid.all()
    assert abs(found.q[0] - [0.4, 0.9]).max(axis=1).min() < 1e-9
