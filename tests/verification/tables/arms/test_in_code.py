"""A DH table in code is asked before what the formulas alone would pin, and gives way where these are of another arm."""

from __future__ import annotations

from armproof import verify_text

SCARA_IN_CODE = r"""
```python
robot = DHRobot([RevoluteDH(a=a1), RevoluteDH(a=a2, alpha=np.pi), PrismaticDH(), RevoluteDH()])
```

With $a_1$ and $a_2$ for the two lengths of the arm:

$$ x = a_1 \cos\theta_1 + a_2 \cos(\theta_1+\theta_2) $$

$$ y = a_1 \sin\theta_1 + a_2 \sin(\theta_1+\theta_2) $$

$$ z = -d_3 $$

$$ T_4^0 = \begin{bmatrix} \cos(\theta_1+\theta_2-\theta_4) & \sin(\theta_1+\theta_2-\theta_4) & 0 & a_1 c_1 + a_2 c_{12} \\ \sin(\theta_1+\theta_2-\theta_4) & -\cos(\theta_1+\theta_2-\theta_4) & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & -d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""


def test_a_table_in_code_is_asked_before_what_the_formulas_alone_would_pin() -> None:
    result = verify_text(SCARA_IN_CODE)
    assert result.arms[0].source == "table"
    assert [each.verdict.value for each in result.equations] == ["proved"] * 4
    for right, wrong in (("z = -d_3", "z = d_3"), (r"& -\cos(", r"& \cos(")):
        found = [each.verdict.value for each in verify_text(SCARA_IN_CODE.replace(right, wrong)).equations]
        assert sorted(found) == ["proved"] * 3 + ["refuted"], wrong


def test_a_table_in_code_of_another_arm_is_not_that_of_the_formulas() -> None:
    other = SCARA_IN_CODE.replace(
        "RevoluteDH(a=a1), RevoluteDH(a=a2, alpha=np.pi)", "RevoluteDH(a=a2), RevoluteDH(a=a1, alpha=np.pi)"
    )
    assert "refuted" not in [each.verdict.value for each in verify_text(other).equations][:2]
