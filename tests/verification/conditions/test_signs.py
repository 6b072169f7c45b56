"""What follows from signs of scalars: their factors are those given, and what is below a line or counts twice does not vanish."""

from __future__ import annotations

import pytest

from armproof.verification.algebra.ring import Ring
from armproof.verification.conditions.signs import Sign, follow

RING = Ring()
LETTERS = {"one": RING.rational(1), **{name: RING.symbol(name) for name in "abcdlm"}}  # l and m are lengths
FOLLOWS = """
⟶ a*a ≥ 0
⟶ l > 0
⟶ 2*l*m + l ≠ 0
a > 0 ⟶ a > 0, a ≥ 0, a ≠ 0, a*l > 0, a*a*a > 0, -a*l*-m > 0, one/a > 0, a*(2*l + m) > 0
a ≥ 0 ⟶ a*a*a ≥ 0, a*a ≥ 0, a*b*b ≥ 0
a ≠ 0 ⟶ a*a > 0, a*a*l ≠ 0, one/(a*a) > 0, one/(a*a) ≥ 0
-a > 0 ⟶ -one/a > 0, -3*a > 0, one - one - a*a*a > 0
a - b > 0 ⟶ 2*a - 2*b > 0, (a - b)/l > 0, (b - a)*(a - b)*(b - a) > 0
-a > 0, -b > 0 ⟶ a*b > 0
a > 0, -b > 0, c > 0 ⟶ -a*b*c > 0
a*b > 0, b > 0 ⟶ a > 0
a*b > 0, b ≠ 0 ⟶ a*b > 0
a*b ≥ 0, b > 0 ⟶ a ≥ 0
a*b*c > 0 ⟶ a ≠ 0, a*c ≠ 0
"""
OPEN = """
⟶ a > 0
⟶ a*a > 0
⟶ a ≠ 0
⟶ l - m > 0
⟶ l - l > 0
⟶ l - l ≥ 0
a > 0 ⟶
a > 0 ⟶ -a > 0
a > 0 ⟶ -2*a > 0
a > 0 ⟶ a > 0, b > 0
a > 0 ⟶ a - a > 0
a > 0 ⟶ a - a ≥ 0
a > 0 ⟶ a*b*b > 0
a - a ≥ 0 ⟶ a ≥ 0
a - a > 0, a - a ≠ 0 ⟶ a ≠ 0
a ≥ 0 ⟶ a > 0
a ≥ 0 ⟶ a*a > 0
a ≥ 0 ⟶ a ≠ 0
a ≥ 0 ⟶ one/a ≥ 0
a ≠ 0 ⟶ a > 0
a ≠ 0 ⟶ a ≥ 0
a ≠ 0 ⟶ a*l > 0
a - b > 0 ⟶ b - a > 0
a*b > 0 ⟶ a > 0
a*b ≥ 0, b ≥ 0 ⟶ a ≥ 0
a*b ≥ 0, b ≠ 0 ⟶ a ≥ 0
-a > 0, -b > 0 ⟶ -a*b > 0
a > 0, b > 0, c > 0, d > 0 ⟶ a*b*c*d > 0
"""


def signs(text: str) -> list[Sign]:
    """Return the signs of a list such as "a > 0, b ≠ 0"."""
    found = [each.split()[:-1] for each in text.split(",") if each.strip()]
    return [Sign(eval(" ".join(value), {}, LETTERS), relation) for *value, relation in found]  # noqa: S307


@pytest.mark.parametrize(
    ("line", "does"), [(line, text is FOLLOWS) for text in (FOLLOWS, OPEN) for line in text.strip().splitlines()]
)
def test_a_sign_follows_from_others_or_is_left_open(line: str, does: bool) -> None:
    given, asked = map(signs, line.split("⟶"))
    assert follow(given, asked, frozenset("lm")) == does
    assert not does or all(follow(given, [each], frozenset("lm")) for each in asked)
