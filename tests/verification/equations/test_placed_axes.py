"""Axes that name no frame are vectors, and seen from where the axis beside them is seen."""

from __future__ import annotations

import pytest

from armproof import verify_text

ARM = """---
arm:
  dh: modified
  rows:
  - {a: 0, alpha: 0, d: 0, theta: theta_1}
  - {a: L_1, alpha: pi/2, d: 0, theta: theta_2}
  - {a: L_2, alpha: 0, d: 0, theta: theta_3}
---

"""


@pytest.mark.parametrize(
    ("equation", "verdict"),
    [
        (r"{}^1x_2 = c_2 x_1 + s_2 z_1", "proved"),
        (r"x_{2(1)} = \begin{bmatrix} c_2 \\ 0 \\ s_2 \end{bmatrix} = c_2.x_1 + s_2.z_1", "proved"),
        (r"{}^0x_2 = c_2 x_1 + s_2 z_1", "proved"),
        (r"{}^1x_2 = c_2 x_1 - s_2 z_1", "refuted"),
        (r"{}^1x_2 = c_2 x_1 + s_2 y_1", "refuted"),
        (r"{}^1y_2 = c_2 x_1 + s_2 z_1", "refuted"),
        (r"{}^1x_3 = {}^1R_2 x_3", "unchecked"),  # it may be {}^2x_3
    ],
)
def test_an_axis_without_a_frame_is_expressed_in_that_of_the_other_side(equation: str, verdict: str) -> None:
    [record] = verify_text(f"{ARM}$$ {equation} $$\n").equations
    assert record.verdict == verdict


def test_what_the_document_gives_a_meaning_keeps_it() -> None:
    *_, record = verify_text(f"{ARM}$$ x_1 = L_1 c_1 $$\n\n$$ {{}}^1x_2 = c_2 x_1 + s_2 z_1 $$\n").equations
    assert record.verdict in ("unchecked", "refuted")
