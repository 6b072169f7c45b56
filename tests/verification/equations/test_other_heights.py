"""A height with an index may be counted from a joint that stands: z_w = z - d_1 - a_4 sin φ is that of the wrist above the shoulder."""

from __future__ import annotations

import pytest

from armproof import verify_text

ARM = r"""
| i | theta | d | a | alpha |
|---|---|---|---|---|
| 1 | $\theta_1$ | $d_1$ | 0 | 90° |
| 2 | $\theta_2$ | 0 | $a_2$ | 0 |
| 3 | $\theta_3$ | 0 | $a_3$ | 0 |
| 4 | $\theta_4$ | 0 | $a_4$ | 0 |

$$ z = d_1 + a_2 s_2 + a_3 s_{23} + a_4 s_{234} $$

$$ \phi = \theta_2 + \theta_3 + \theta_4 $$

"""


@pytest.mark.parametrize(
    ("height", "verdict"),
    [
        (r"z_w = z - a_4\sin\phi", "proved"),
        (r"z_w = z - d_1 - a_4\sin\phi", "unchecked"),
        (r"z_w = a_2 s_2 + a_3 s_{23}", "unchecked"),
        (r"z_w = z + a_4\sin\phi", "unchecked"),
        (r"z_w = z - d_1 - a_4\cos\phi", "unchecked"),
        (r"z = a_2 s_2 + a_3 s_{23} + a_4 s_{234}", "refuted"),
    ],
)
def test_a_height_may_be_counted_from_a_joint_that_stands(height: str, verdict: str) -> None:
    assert verify_text(ARM + f"$$ {height} $$").equations[-1].verdict.value == verdict
