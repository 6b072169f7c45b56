"""Solutions for several joints that hold on a branch each are one solution where they hold together somewhere."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind

WRIST = r"""
| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | 0 | 0 | $-90°$ |
| 2 | $\theta_2$ | 0 | 0 | $90°$ |
| 3 | $\theta_3$ | $d_3$ | 0 | 0 |

$$ {}^0R_3 = \begin{bmatrix} c_1 c_2 c_3 - s_1 s_3 & -c_1 c_2 s_3 - s_1 c_3 & c_1 s_2 \\ s_1 c_2 c_3 + c_1 s_3 & -s_1 c_2 s_3 + c_1 c_3 & s_1 s_2 \\ -s_2 c_3 & s_2 s_3 & c_2 \end{bmatrix} $$

$$ {}^0R_3 = \begin{bmatrix} r_{11} & r_{12} & r_{13} \\ r_{21} & r_{22} & r_{23} \\ r_{31} & r_{32} & r_{33} \end{bmatrix} $$

$$ \theta_2 = \operatorname{atan2}(\sqrt{r_{13}^2 + r_{23}^2}, r_{33}) $$
"""
OTHER_SECOND = r"$$ \theta_2 = \operatorname{atan2}(-\sqrt{r_{13}^2 + r_{23}^2}, r_{33}) $$"
TURNED = r"$$ \theta_1 = \operatorname{atan2}(-r_{23}, -r_{13}) $$"
FITTING = r"$$ \theta_1 = \operatorname{atan2}(r_{23}, r_{13}) $$"


@pytest.mark.parametrize(
    ("behind", "verdict"),
    [
        (FITTING, "confirmed"),
        (TURNED, "unchecked"),  # holds nowhere where θ_2 > 0
        (f"{FITTING}\n\n{TURNED}", "confirmed"),  # another solution
        (f"\n## The other solution\n\n{OTHER_SECOND}\n\n{TURNED}", "confirmed"),
    ],
)
def test_solutions_that_never_hold_together_are_not_confirmed(behind: str, verdict: str) -> None:
    *_, last = verify_text(f"{WRIST}\n{behind}\n").equations
    assert last.verdict == verdict
    assert last.says(Kind.RESTS_ON_DOUBT) is (verdict == "unchecked")


PAIR = r"""---
arm: planar_2r
---

Elbow down

$$ \begin{aligned} \theta_1 &= \operatorname{atan2}(y, x) - \arccos\frac{x^2 + y^2 + l_1^2 - l_2^2}{2 l_1 \sqrt{x^2 + y^2}} \\ \theta_2 &= \arccos\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2} \end{aligned} $$

Elbow up

$$ \begin{aligned} \theta_1 &= \operatorname{atan2}(y, x) %s \arccos\frac{x^2 + y^2 + l_1^2 - l_2^2}{2 l_1 \sqrt{x^2 + y^2}} \\ \theta_2 &= -\arccos\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2} \end{aligned} $$
"""


@pytest.mark.parametrize(("sign", "verdict"), [("+", "confirmed"), ("-", "unchecked")])
def test_the_second_solution_of_a_section_is_one_as_well(sign: str, verdict: str) -> None:
    assert [each.verdict for each in verify_text(PAIR % sign).equations] == ["confirmed", verdict]
