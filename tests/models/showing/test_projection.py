"""From which side an arm is seen: planar arms in their plane, the others from one direction."""

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import axonometric, choose_projection, look_along, plane_projection


@pytest.mark.parametrize("toward", [(0, 0, 1), (0, -1, 0), (1, 2, 3)])
def test_projections_are_orthonormal(toward: tuple[float, float, float]) -> None:
    projection = look_along(np.array(toward))
    R = np.stack([projection.right, projection.up, projection.toward])
    assert pytest.approx(np.eye(3), abs=1e-14) == R @ R.T
    assert np.linalg.det(R) == pytest.approx(1)


def test_planar_arms_are_seen_along_their_normal(arm: Arm) -> None:
    projection = choose_projection(arm)
    assert projection.planar == (arm.name in ("planar_2r", "planar_3r", "polar_rp"))
    if projection.planar:
        q = np.random.default_rng(1).uniform(-1, 1, (5, len(arm.joints)))
        depths = projection.depth(NumericKinematics(arm, q).pose(arm.frames[-1])[:, :3, 3])
        assert np.ptp(depths) < 1e-12
    else:
        assert np.array_equal(projection.toward, axonometric().toward)


@pytest.mark.parametrize("arm", ["scara", "planar_2r"], indirect=True)
def test_arms_with_parallel_axes_have_a_plane(arm: Arm) -> None:
    projection = plane_projection(arm)
    assert projection is not None
    assert projection.toward == pytest.approx([0, 0, 1])


@pytest.mark.parametrize("arm", ["rx90"], indirect=True)
def test_other_arms_have_none(arm: Arm) -> None:
    assert plane_projection(arm) is None
