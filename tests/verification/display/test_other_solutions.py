"""Another solution from one that is known is proved where the tool is where it was, and left open elsewhere."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind
from armproof.verification.verdict import Verdict

TABLE = r"""# An arm

| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | $d_1$ | 0 | $90^\circ$ |
| 2 | $\theta_2$ | 0 | $a_2$ | 0 |
| 3 | $\theta_3$ | 0 | $a_3$ | 0 |

The arm reaches the same point also over its back,

"""
FLIP = r"\theta_1' = \theta_1 + \pi, \qquad \theta_2' = \pi - \theta_2, \qquad \theta_3' = -\theta_3"


@pytest.mark.parametrize(
    ("latex", "kind"),
    [
        (FLIP, Kind.OTHER_SOLUTION_OF_POSITION),
        (FLIP.replace("'", "^{(2)}").replace(r"\pi", r"180^\circ"), Kind.OTHER_SOLUTION_OF_POSITION),
        (r"\theta_1' = \theta_1 - 2\pi", Kind.OTHER_SOLUTION_OF_POSE),
    ],
)
def test_where_the_tool_is_where_it_was_it_is_proved(latex: str, kind: Kind) -> None:
    record = verify_text(f"{TABLE}$$ {latex} $$\n").equations[-1]
    assert record.verdict is Verdict.PROVED
    assert record.says(kind)


@pytest.mark.parametrize(
    "latex",
    [
        FLIP.replace(r"\pi - \theta_2", r"-\theta_2"),
        FLIP.replace(r"-\theta_3", r"\theta_3"),
        FLIP.replace(r"\theta_1 + \pi", r"\theta_1"),
        r"\theta_1' = \theta_1",
        r"\theta_1' = \theta_1 + \frac{\pi}{2}",
        r"\theta_1' = \theta_1 + \pi, \qquad r' = -r",
    ],
)
def test_where_it_is_elsewhere_or_nothing_changes_it_is_left_open(latex: str) -> None:
    assert verify_text(f"{TABLE}$$ {latex} $$\n").equations[-1].verdict is Verdict.UNCHECKED
