"""A text that writes several decimals with a comma between signs means one number by each; a list of two is none."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.naming.reading import spelling_of

TEXT = r"""
Le bras plan 2R a pour longueurs $L_1 = 0,4$ m et $L_2 = 0,3$ m.

$$ X = L_1\cos\theta_1 + L_2\cos(\theta_1+\theta_2) $$

$$ Y = L_1\sin\theta_1 + L_2\sin(\theta_1+\theta_2) $$

Pour $\theta_1 = 30°$ et $\theta_2 = 60°$, on obtient

$$ Y = 0,4\sin 30° + 0,3\sin 90° = %s \text{ m} $$
"""


@pytest.mark.parametrize(("value", "holds"), [("0,5", True), ("0,6", False)])
def test_decimals_with_a_comma_are_read(value: str, holds: bool) -> None:
    verdict = verify_text(TEXT % value).equations[-1].verdict.value
    assert verdict in (("proved", "confirmed") if holds else ("refuted",))


@pytest.mark.parametrize(
    ("said", "has_commas"),
    [
        ("Soit $a = 0,4$ m et $b = 0,3$ m.", True),
        ("Pour $i = 0,1$ et $j = 0,2$.", False),
        ("Soit $k = 0,1, 2$ et $l = 0,2, 3$.", False),
        ("Les points $(0,4)$ et $(0,3)$.", False),
        ("Soit $a = 0,4$ m, $b = 0,3$ m et $c = 1.5$ m.", False),  # what the point is for, then?
    ],
)
def test_what_writes_decimals_with_a_comma(said: str, has_commas: bool) -> None:
    text = f"{said}\n\n$$ x = a\\cos\\theta_1 $$\n"
    assert spelling_of(parse_document(Path("page.md"), text), frozenset()).decimal_comma is has_commas
