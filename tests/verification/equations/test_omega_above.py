"""A Jacobian that is printed with the rows of ω above those of v is not refuted, whatever the number of its rows."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind

SCARA = r"""
| $j$ | $\alpha_j$ | $d_j$ | $\theta_j$ | $r_j$ |
|---|---|---|---|---|
| 1 | 0 | 0 | $\theta_1$ | 0 |
| 2 | 0 | $d_2$ | $\theta_2$ | 0 |
| 3 | 0 | $d_3$ | 0 | $r_3$ |
| 4 | 0 | 0 | $\theta_4$ | 0 |

$$ x = d_2\cos\theta_1 + d_3\cos(\theta_1+\theta_2) $$

$$ y = d_2\sin\theta_1 + d_3\sin(\theta_1+\theta_2) $$

$$ J(q) = \begin{pmatrix} 1 & 1 & 0 & 1 \\ -d_2\sin\theta_1 - d_3\sin(\theta_1+\theta_2) & -d_3\sin(\theta_1+\theta_2) & 0 & 0 \\ d_2\cos\theta_1 + d_3\cos(\theta_1+\theta_2) & %s\cos(\theta_1+\theta_2) & 0 & 0 \\ 0 & 0 & 1 & 0 \end{pmatrix} $$
"""


@pytest.mark.parametrize(("length", "is_meant"), [("d_3", True), ("d_2", False)])
def test_rows_of_omega_may_stand_above(length: str, is_meant: bool) -> None:
    record = verify_text(SCARA % length).equations[-1]
    assert record.verdict.value == "unchecked"
    assert record.says(Kind.OMEGA_IS_FIRST) is is_meant
