"""A coordinate that is printed as a root of the others: the root chooses one of two heights, and claims no mistake."""

from __future__ import annotations

import pytest

from armproof import verify_text

FRONT = """---
arm: planar_2r
quantities: {x: {origin: 2, component: x}, y: {origin: 2, component: y}}
---

"""


@pytest.mark.parametrize(
    ("equation", "verdict"),
    [
        (r"y = \sqrt{l_1^2 + l_2^2 + 2 l_1 l_2 c_2 - x^2}", "unchecked"),
        (r"y = l_1 s_1 + \sqrt{l_2^2 - (x - l_1 c_1)^2}", "unchecked"),
        (r"y = \sqrt{l_1^2 + l_2^2 - 2 l_1 l_2 c_2 - x^2}", "refuted"),
        (r"y = l_1 s_1 + \sqrt{l_2^2 + (x - l_1 c_1)^2}", "refuted"),
        (r"y = l_1 c_1 + \sqrt{l_2^2 - (x - l_1 c_1)^2}", "refuted"),
        (r"y = \sqrt{y^2}", "refuted"),
        (r"y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2 - x^2", "proved"),
    ],
)
def test_a_root_that_chooses_a_height_is_left_open(equation: str, verdict: str) -> None:
    [record] = verify_text(f"{FRONT}$$ {equation} $$\n").equations
    assert record.verdict == verdict
