"""A tool that the text puts in the arm's last frame is where that says."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.told_ends import told_ends


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("The tip of the tool has the coordinates $(g, 0, h)$ in frame 4.", ["4\tg\t0\th"]),
        (r"Le bout de l'outil a pour coordonnées $(g, 0, 0)^T$ dans le repère $R_3$.", ["3\tg\t0\t0"]),
        (r"Der Greifer hat die Koordinaten $(0, g, 0)$ in $\{2\}$.", ["2\t0\tg\t0"]),
        ("The gripper has the coordinates $(0, 0, 0)$ in frame 3.", []),
        ("The screw has the coordinates $(g, 0, 0)$ in frame 3.", []),
        ("The gripper has the coordinates $(x, y, z)$.", []),
    ],
)
def test_a_sentence_puts_the_tool_in_a_frame(sentence: str, told: list[str]) -> None:
    assert [*told_ends(sentence)] == told


LIFT = r"""
| i | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | $d_1$ | 0 | 0 |
| 2 | 0 | $q_2$ | 0 | $-90°$ |
| 3 | 0 | $q_3$ | 0 | 0 |

$$ T_2^1 = \begin{{bmatrix}} 1 & 0 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & -1 & 0 & q_2 \\ 0 & 0 & 0 & 1 \end{{bmatrix}} $$

{said}

"""
TOLD = "The gripper has the coordinates $(g, 0, 0)$ in $R_3$."
FORWARD = r"""
$$ x = g\cos\theta_1 - q_3\sin\theta_1 $$

$$ y = g\sin\theta_1 + q_3\cos\theta_1 $$

"""


@pytest.mark.parametrize(
    ("said", "shown", "claim", "verdict"),
    [
        (TOLD, FORWARD, "x^2 + y^2 = g^2 + q_3^2", "proved"),
        (TOLD, FORWARD, "x^2 + y^2 = q_3^2", "refuted"),
        (TOLD, "", "x^2 + y^2 = q_3^2", "unchecked"),  # nothing shows that tool
        ("", "", "x^2 + y^2 = q_3^2", "proved"),
        ("", FORWARD, "x^2 + y^2 = g^2 + q_3^2", "unchecked"),
    ],
)
def test_the_tool_is_where_the_text_puts_it(said: str, shown: str, claim: str, verdict: str) -> None:
    found = verify_text(LIFT.format(said=said) + shown + f"$$ {claim} $$\n").equations
    assert found[-1].verdict.value == verdict
