"""Half an angle is not the same a whole turn on: what holds within half a turn is not wrong."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

PAGE = "$$ x = l (c_1 + c_{12}), \\quad y = l (s_1 + s_{12}) $$\n\n$$ \\det J = l^2 s_2 $$\n\n$$ %s $$\n"


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\operatorname{atan2}(y, x) = \theta_1 + \frac{\theta_2}{2}", Verdict.UNCHECKED),
        (r"\operatorname{atan2}(y, x) = \theta_1 + \frac12 \theta_2", Verdict.UNCHECKED),
        (r"\sqrt{x^2 + y^2} = 2 l \cos\frac{\theta_2}{2}", Verdict.UNCHECKED),
        (r"\operatorname{atan2}(y, x) = \theta_1 - \frac{\theta_2}{2}", Verdict.REFUTED),
        (r"\operatorname{atan2}(y, x) = \theta_1 + \theta_2", Verdict.REFUTED),
        (r"\sqrt{x^2 + y^2} = 2 l \sin\frac{\theta_2}{2}", Verdict.REFUTED),
    ],
)
def test_what_holds_within_half_a_turn_is_left_open(latex: str, verdict: Verdict) -> None:
    assert verify_text(PAGE % latex).equations[-1].verdict is verdict
