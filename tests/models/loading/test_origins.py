"""The origins of the joints of every arm."""

from __future__ import annotations

import numpy as np

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.loading.origins import joint_origins
from armproof.models.numeric.drake_arm import plant_of
from tests.models.evaluation import evaluate_entries


def test_the_joints_of_the_chain_lead_from_link_to_link(arm: Arm) -> None:
    origins = joint_origins(arm)
    if arm.dh is not None:
        assert origins == {}  # no model file, no origins
        return
    assert {joint.name for joint in arm.joints} <= origins.keys()
    assert all(origins[joint.name].kind == joint.kind for joint in arm.joints)
    links = {origin.child for origin in origins.values()}
    assert len(links) == len(origins)
    assert len({origin.parent for origin in origins.values()} - links) == 1


def test_the_origins_are_those_of_the_double_plant(arm: Arm) -> None:
    for name, origin in joint_origins(arm).items():
        X_PF = plant_of(arm).GetJointByName(name).frame_on_parent().GetFixedPoseInBodyFrame()
        xyz = evaluate_entries(arm, [[entry] for entry in origin.xyz], np.zeros((1, len(arm.joints))))[0, :, 0]
        np.testing.assert_allclose(xyz, X_PF.translation(), atol=1e-12)


def test_a_moving_joint_has_an_axis_and_a_fixed_one_none() -> None:
    origins = joint_origins(load_arm("kr210"))
    axes = [origin.axis and "xyz"[origin.axis.index(1.0)] for origin in origins.values()]
    assert axes == ["z", "y", "y", "x", "y", "x", None]


def test_roll_pitch_and_yaw_make_the_rotation_of_the_double_plant(arm: Arm) -> None:
    for name, origin in joint_origins(arm).items():
        (cr, sr), (cp, sp), (cy, sy) = evaluate_entries(arm, origin.rpy, np.zeros((1, len(arm.joints))))[0]
        Rz = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        Ry = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
        Rx = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
        X_PF = plant_of(arm).GetJointByName(name).frame_on_parent().GetFixedPoseInBodyFrame()
        np.testing.assert_allclose(Rz @ Ry @ Rx, X_PF.rotation().matrix(), atol=1e-12)
