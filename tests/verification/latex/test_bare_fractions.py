r"""\frac takes one sign each where it has no braces: \frac\theta2 is a half of θ."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.verdict import Verdict


@pytest.mark.parametrize("latex", [r"\frac\theta2", r"\frac r2", r"\tfrac T2", r"\frac\pi3", r"\frac\alpha\beta"])
def test_a_fraction_without_braces_is_one(latex: str) -> None:
    [chain] = Reader().read(f"{latex} = 1")
    assert isinstance(chain, n.Chain) and isinstance(chain.members[0], n.Quotient)


def test_only_one_digit_is_its_denominator() -> None:
    [chain] = Reader().read(r"\frac r23 = 1")
    assert isinstance(chain, n.Chain) and isinstance(chain.members[0], n.Product)


@pytest.mark.parametrize(("sign", "verdict"), [("1", Verdict.PROVED), ("-1", Verdict.REFUTED)])
def test_half_an_angle_is_decided(sign: str, verdict: Verdict) -> None:
    latex = rf"$$ \tan\frac\theta2 = {sign} \cdot \frac{{\sin\theta}}{{1 + \cos\theta}} $$"
    assert verify_text(latex).equations[-1].verdict is verdict
