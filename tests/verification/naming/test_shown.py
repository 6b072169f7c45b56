"""What the other equations of a document show of a usual name: an entry r_31 is shown by others of its matrix."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text
from armproof.verification.verdict import Verdict

WRIST = r"""The wrist, in the classic convention:

|  | theta | d | a | alpha |
|---|---|---|---|---|
| 4 | $q_4$ | 0 | 0 | $-\pi/2$ |
| 5 | $q_5$ | 0 | 0 | $+\pi/2$ |
| 6 | $q_6$ | 0 | 0 | 0 |

$$ A_4 = \begin{bmatrix} c_4 & 0 & -s_4 & 0 \\ s_4 & 0 & c_4 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

"""
SHOWS = r"""For the solution with $s_5 > 0$:

$$ q_4 = \operatorname{atan2}(r_{23}, r_{13}) $$

"""
LAST = r"$$ q_6 = \operatorname{atan2}(%s, %s) $$"


@pytest.mark.parametrize(
    ("shows", "arguments", "verdict"),
    [
        (SHOWS, ("r_{32}", "-r_{31}"), Verdict.CONFIRMED),
        (SHOWS, ("r_{32}", "r_{31}"), Verdict.REFUTED),
        ("", ("r_{32}", "-r_{31}"), Verdict.CONFIRMED),
        ("", ("r_{32}", "r_{31}"), Verdict.UNCHECKED),  # nothing shows which rotation r is
        (SHOWS.replace("r_", "m_"), ("r_{32}", "r_{31}"), Verdict.UNCHECKED),
    ],
)
def test_an_entry_is_shown_by_others_of_its_matrix(shows: str, arguments: tuple[str, str], verdict: Verdict) -> None:
    assert verify_text(WRIST + shows + LAST % arguments).equations[-1].verdict is verdict
