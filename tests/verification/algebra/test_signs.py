"""The roots of squares: a square that has lost its form in the ring is found, and its root has the sign it must have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.algebra.ring import Ring
from armproof.verification.algebra.roots import is_negative
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
REACH = r"\rho = a_3 C_2 - d_3 S_{23}"
RX90 = {
    "arm": "rx90",
    "quantities": {"P_x": {"origin": 6, "component": "x"}, "P_y": {"origin": 6, "component": "y"}},
}


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\sqrt{S_5^4} = S_5^2", Verdict.PROVED),
        (r"\sqrt{S_5^4} = -S_5^2", Verdict.REFUTED),
        (r"\sqrt{S_5^2} = S_5", Verdict.REFUTED),
        (r"\sqrt{(2 - C_5)^2} = 2 - C_5", Verdict.PROVED),
        (r"\sqrt{(C_5 - 2)^2} = C_5 - 2", Verdict.REFUTED),
        (r"\sqrt{a_3^2 d_3^2} = a_3 d_3", Verdict.PROVED),
    ],
)
def test_the_root_of_a_square_is_not_negative(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, arm="rx90").verdict is verdict


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\theta_1 = \operatorname{atan2}(\rho P_y, \rho P_x)", Verdict.PROVED),
        (r"\theta_1 = \operatorname{atan2}(\rho^3 P_y, \rho^3 P_x)", Verdict.PROVED),
        (r"\theta_1 + \pi = \operatorname{atan2}(-\rho P_y, -\rho P_x)", Verdict.PROVED),
        (r"\theta_1 = \operatorname{atan2}(P_y, P_x)", Verdict.CONFIRMED),  # on one branch: ρ > 0
        (r"\theta_1 = \operatorname{atan2}(-\rho P_y, -\rho P_x)", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(\rho P_x, \rho P_y)", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(\rho P_y, P_x)", Verdict.REFUTED),
    ],
)
def test_a_square_common_to_sine_and_cosine_leaves_the_angle(judge: Judge, latex: str, verdict: Verdict) -> None:
    record = judge(REACH, latex, **RX90)
    assert record.verdict is verdict, record.message
    if verdict is Verdict.CONFIRMED:
        assert "one branch" in record.message


def test_nothing_is_not_negative() -> None:
    ring = Ring()
    assert is_negative(ring, (ring.zero - 1).numerator)
    assert not is_negative(ring, ring.zero.numerator)
