"""A conclusion about coordinates of two points, one of them the tool's and one another frame's, is neither right nor wrong."""

from __future__ import annotations

from armproof import verify_text

HAND = """---
arm:
  dh: modified
  rows:
  - {a: 0, alpha: 0, d: 0, theta: theta_1}
  - {a: l_1, alpha: 0, d: 0, theta: theta_2}
  - {a: l_2, alpha: 0, d: 0, theta: theta_3}
  tool:
    xyz: [l_3, 0, 0]
quantities:
%s---

$$ \\theta_3 = 0 \\Rightarrow x^2 + y^2 = l_1^2 + (l_2 + l_3)^2 + 2 l_1 (l_2 + l_3) c_2 $$
"""
TOOL, LAST = ("  {0}: {{origin: E, component: {0}}}\n", "  {0}: {{origin: 3, component: {0}}}\n")


def verdict(x: str, y: str) -> str:
    return verify_text(HAND % (x.format("x") + y.format("y"))).equations[0].verdict.value


def test_coordinates_of_two_points_conclude_nothing() -> None:
    assert verdict(TOOL, TOOL) == "proved"
    assert verdict(LAST, LAST) == "refuted"
    assert verdict(LAST, TOOL) == verdict(TOOL, LAST) == "unchecked"
