"""What the text behind a determinant says of singular configurations is no condition of it: there any multiple of it is zero, too."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

ARM = r"""# Two links
| i | a | alpha | d | theta |
|---|---|---|---|---|
| 1 | $l_1$ | 0 | 0 | $\theta_1$ |
| 2 | $l_2$ | 0 | 0 | $\theta_2$ |

$$ x = l_1 c_1 + l_2 c_{12} $$
$$ y = l_1 s_1 + l_2 s_{12} $$
"""


def verdict(determinant: str, behind: str) -> str:
    text = rf"{ARM}$$ \det J = {determinant} $$" + f"\n\n{behind}\n"
    return verify_text(text).equations[-1].verdict.value


@pytest.mark.parametrize("behind", [r"so the arm is singular where $\theta_2 = 0$.", r"where $\theta_2 = 0$."])
def test_a_wrong_sign_is_found_before_the_configurations_where_it_is_zero(behind: str) -> None:
    assert verdict("l_1 l_2 s_2", behind) == "proved"
    assert verdict("-l_1 l_2 s_2", behind) == "refuted"


def test_what_holds_at_the_values_behind_stays_open() -> None:
    assert verdict("l_1 l_2 c_2", r"where $\theta_2 = \pi/4$.") == "unchecked"
    assert verdict("0", r"where $\theta_2 = 0$.") == "unchecked"
