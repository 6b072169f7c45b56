"""The course has one closed-form inverse an arm, found by the front matter of its handouts."""

import numpy as np
import pytest

from armproof.course.inverse import arms_with_inverse, inverse_of
from armproof.verification.inverse import InverseError, Mark

ARMS = ("planar_2r", "planar_3r", "polar_rp", "rx90", "scara_column", "spatial_rrr", "spherical_wrist")


def test_the_arms_with_an_inverse_are_known() -> None:
    assert set(ARMS) <= set(arms_with_inverse())


@pytest.mark.parametrize("arm", ARMS)
def test_the_inverse_of_an_arm_is_that_of_its_handout(arm: str) -> None:
    inverse = inverse_of(arm)
    assert inverse.arm.name == arm and inverse is inverse_of(arm)
    zero = np.zeros((1, len(inverse.arm.joints))) + 0.4
    assert inverse.solve(inverse.forward(zero)).mark.tolist() == [Mark.REACHABLE]


def test_an_arm_without_an_inverse_is_named() -> None:
    with pytest.raises(
        InverseError, match="no handout derives an inverse for the arm 'kr210'; those it has: planar_2r"
    ):
        inverse_of("kr210")
