"""What is too large to be decided exactly is confirmed at samples, with the reason; samples never refute it."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind

A, B = "(1 + C_1 + S_2 + C_3 + S_4)^{9}", "(2 + S_1 + C_2 + S_3 + C_5)^{9}"
FALSE = A.replace("+ S_4", "- S_4")


@pytest.mark.parametrize(
    ("right", "verdict", "kind"),
    [(f"{B} {A}", "confirmed", Kind.NOT_EXACT), (f"{B} {FALSE}", "unchecked", Kind.TOO_LARGE)],
)
def test_a_product_of_too_many_terms_is_sampled(right: str, verdict: str, kind: Kind) -> None:
    (record,) = verify_text(f"---\narm: rx90\n---\n\n$$ {A} {B} = {right} $$\n").equations
    assert record.verdict == verdict and record.says(kind)
    assert "a product of 715 by 715 terms" in record.message
    assert (record.samples >= 100) == (verdict == "confirmed")


def test_a_product_that_is_not_too_large_is_still_proved_or_refuted() -> None:
    small = f"---\narm: rx90\n---\n\n$$ {A} {B} = {B} {A} $$\n\n$$ {A} {B} = {B} {FALSE} $$\n".replace("^{9}", "^{2}")
    assert [str(record.verdict) for record in verify_text(small).equations] == ["proved", "refuted"]
