"""URDFs as they are found: rounded right angles, grippers, mimic joints; what is fixed stays where it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from armproof import verify
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.loading.urdf import made_ready
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.singularities.analysis import analyse_singularities
from tests.models.conftest import joint, link

Write = Callable[..., Path]
BENT = link("a", "b", "c") + joint("j", "a", "b", rpy="{}") + joint("k", "b", "c", xyz="1 0 0", rpy="0 0.3 0")
HAND = link("base", "l1", "l2", "left", "right") + (
    joint("j1", "base", "l1", xyz="0 0 0.5")
    + joint("j2", "l1", "l2", xyz="0.4 0 0", rpy="0.2 0.1 0")
    + joint("left", "l2", "left", "prismatic", "0.1 0.02 0", axis="0 1 0")
    + joint("right", "l2", "right", "prismatic", "0.1 -0.02 0", axis="0 -1 0").replace(
        "</joint>", '<mimic joint="left"/></joint>'
    )
)


@pytest.mark.parametrize(
    ("written", "turns"),
    [("1.5708 0 0", 1), ("-1.5708 0 0", -1), ("1.57 0 0", 1), ("3.14159 0 0", 2), ("3.1415926 0 0", 2)],
)
def test_a_rounded_right_angle_is_that_angle_with_one_remark(write_urdf: Write, written: str, turns: int) -> None:
    arm = load_arm(write_urdf(BENT.format(written) + joint("l", "c", "d", "fixed", rpy=written, extra="") + link("d")))
    (remark,) = arm.warnings
    assert f"angles are taken as the multiples of pi/4 that they round: {written.split()[0]}" in remark
    assert set(trace_of(arm).constants) == {"0.3"}
    pose = NumericKinematics(arm, np.zeros((1, 2))).pose("1")[0]
    assert np.allclose(pose[1:3, 2], [-np.sin(turns * np.pi / 2), np.cos(turns * np.pi / 2)], atol=1e-15)


@pytest.mark.parametrize("written", ["1.5721", "1.5608", "0.3", "0.79", "2.0"])
def test_another_angle_stays_what_it_is(write_urdf: Write, written: str) -> None:
    arm = load_arm(write_urdf(BENT.format(f"{written} 0 0")))
    assert f"{float(written):g}" in trace_of(arm).constants
    assert not any("are taken as" in warning for warning in arm.warnings)


def test_an_equation_with_a_right_angle_holds_on_such_an_arm_and_its_false_twin_does_not(
    write_urdf: Write, tmp_path: Path
) -> None:
    path = write_urdf(BENT.format("1.5708 0 0"))
    matrix = r"$$ {}^0R_1 = \begin{bmatrix} C_1 & -S_1 & 0 \\ 0 & 0 & %s1 \\ S_1 & C_1 & 0 \end{bmatrix} $$"
    document = tmp_path / "a.md"
    document.write_text(f"---\narm: {path}\n---\n\n{matrix % '-'}\n\n{matrix % ''}\n", encoding="utf-8")
    assert [str(record.verdict) for record in verify(document).equations] == ["proved", "refuted"]


def test_a_number_is_no_variable_and_no_family_of_singular_configurations(write_urdf: Write) -> None:
    body = link("a", "b", "c", "d", "e") + joint("j1", "a", "b") + joint("j2", "b", "c", xyz="0.1 0 0", rpy="0.3 0 0")
    body += joint("j3", "c", "d", xyz="0.4 0 0") + joint("t", "d", "e", "fixed", "0.2 0 0", extra="")
    analysis = analyse_singularities(load_arm(write_urdf(body)), "e", rows=[1, 2, 3])
    conditions = [condition for family in analysis.families for condition in family.conditions]
    assert sorted(conditions)[1:] == [r"\theta_3 = 0", r"\theta_3 = \pi"] and len(conditions) == 3
    below = [condition for family in analysis.descend()[0] for condition in family.conditions]
    assert not any(condition.startswith("0.3") for condition in (*conditions, *below))


def test_a_tip_fixes_the_joints_that_do_not_carry_it(write_urdf: Write) -> None:
    path = write_urdf(HAND)
    with pytest.raises(ModelError, match="`lock` those of a gripper, or name the `tip`"):
        load_arm(path)
    arm = load_arm(path, tip="left", lock=["left"])
    assert [found.name for found in arm.joints] == ["j1", "j2"]
    pose = NumericKinematics(arm, np.zeros((1, 2))).pose("2", "l2")[0]
    assert np.allclose(pose[:3, 3], [0.1, 0.02, 0])  # frame n is the tip
    assert load_arm(path, tip="left").joints[2].name == "left"


def test_a_locked_joint_stays_at_its_value(write_urdf: Write) -> None:
    free = load_arm(
        write_urdf(
            link("base", "l1", "l2")
            + joint("j1", "base", "l1", rpy="0.2 0.1 0")
            + joint("j2", "l1", "l2", xyz="0.4 0 0", rpy="0.2 0.1 0")
        )
    )
    locked = load_arm(write_urdf(HAND), tip="l2", lock={"j1": 0.7})
    moved = NumericKinematics(free, np.array([[0.7, 0.3]])).pose("l2", "l1")[0]
    assert np.allclose(NumericKinematics(locked, np.array([[0.3]])).pose("l2", "l1")[0], moved, atol=1e-12)
    open_hand = load_arm(write_urdf(HAND), lock={"left": 0.03, "right": 0})
    pose = NumericKinematics(open_hand, np.zeros((1, 2))).pose("left", "l2")[0]
    assert np.allclose(pose[:3, 3], [0.1, 0.05, 0])
    turned = NumericKinematics(locked, np.zeros((1, 1))).pose("l1", "base")[0]
    assert np.allclose(turned[:2, 0], [np.cos(0.7), np.sin(0.7)])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tip": "nowhere"}, "no link 'nowhere' for a tip; its links are base"),
        ({"lock": ["none"]}, "no joint 'none' to lock; its joints are j1"),
        ({"lock": {"left": "wide"}}, "'lock' is a list of joints"),
        ({"lock": 3}, "'lock' is a list of joints"),
        ({"tip": 3}, "'tip' is the name of a link"),
    ],
)
def test_what_is_not_there_is_told(write_urdf: Write, options: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        load_arm(write_urdf(HAND), **options)


@pytest.mark.parametrize("options", [{"tip": "l1"}, {"lock": ["j1"]}, {"tip": "l1", "lock": ["j1"]}])
def test_no_other_file_than_a_urdf_has_a_tip_or_locks(tmp_path: Path, options: dict) -> None:
    path = tmp_path / "arm.sdf"
    path.write_text("<sdf/>", "utf-8")
    with pytest.raises(ModelError, match=r"arm\.sdf"):
        made_ready(path, **options)
    assert made_ready(path) == ("", ())


def test_an_arm_of_the_catalogue_has_no_tip() -> None:
    with pytest.raises(ModelError, match=r"are for an arm that is a \.urdf file, not scara"):
        load_arm("scara", tip="l1")


def test_the_front_matter_names_tip_and_lock(write_urdf: Write, tmp_path: Path) -> None:
    document = tmp_path / "a.md"
    front = f"---\narm: {write_urdf(HAND)}\ntip: left\nlock: [left]\n---\n\n"
    document.write_text(front + "$$ {}^{l1}T_{l1} = I_4 $$\n\n$$ q = [\\theta_1, \\theta_2]^T $$\n", encoding="utf-8")
    assert verify(document).passed
    document.write_text(front.replace("tip: left\nlock: [left]\n", ""), encoding="utf-8")
    with pytest.raises(ModelError.__base__, match="mimic"):
        verify(document)
