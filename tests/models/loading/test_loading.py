"""Model files without a card, and what is not an arm."""

import logging
from collections.abc import Callable
from logging.handlers import BufferingHandler
from math import inf
from pathlib import Path

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ArmproofError, ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.drake_arm import frame_of
from armproof.models.numeric.plant import NumericKinematics
from tests.models.conftest import SLANTED, joint, link
from tests.models.evaluation import evaluate_entries

Write = Callable[..., Path]
TWO = link("a", "b") + joint("j", "a", "b", xyz="0.1 0.2 0.33")


def test_a_plain_urdf_counts_its_joints_and_frames(write_urdf: Write) -> None:
    arm = load_arm(write_urdf(SLANTED, "slanted"))
    assert arm.name == "slanted"
    assert [(joint.index, joint.name, joint.symbol, joint.kind) for joint in arm.joints] == [
        (1, "j1", "theta_1", "revolute"), (2, "j2", "theta_2", "revolute"), (3, "j3", "d_3", "prismatic"),
    ]  # fmt: skip
    assert (arm.joints[0].lower, arm.joints[0].upper) == (-2, 2.5)
    assert (arm.joints[1].lower, arm.joints[1].upper) == (-inf, inf)
    assert arm.frames == ("0", "1", "2", "3", "base", "l1", "l2", "l3", "tool")
    assert frame_of(arm, "0").name() == "base" and frame_of(arm, "3").name() == "l3" and frame_of(arm, 3).name() == "l3"
    assert arm.lengths == {} and arm.dh is None and arm.warnings == ()


def test_moving_the_base_changes_nothing(write_urdf: Write, tmp_path: Path) -> None:
    arm = load_arm(write_urdf(SLANTED))
    moved = load_arm(
        write_urdf(link("world") + SLANTED + joint("w", "world", "base", "fixed", "1 2 3", "0.1 0.2 0.3", extra=""))
    )
    (tmp_path / "package.xml").write_text('<package format="2"><name>own</name></package>')
    (tmp_path / "arm.urdf").write_text(arm.path.read_text() if arm.path else "")
    directives = tmp_path / "cell.dmd.yaml"
    directives.write_text(
        "directives:\n- add_model: {name: a, file: package://own/arm.urdf}\n"
        "- add_weld: {parent: world, child: a::base, X_PC: {translation: [1, 2, 3], rotation: !Rpy {deg: [10, 20, 30]}}}\n"
    )
    for other in (moved, load_arm(directives)):
        assert trace_of(other).pose("3") == trace_of(arm).pose("3")
        assert trace_of(other).jacobian("tool") == trace_of(arm).jacobian("tool")
        q = np.random.default_rng(0).normal(size=(5, 3))
        np.testing.assert_allclose(
            NumericKinematics(other, q).pose("3"), NumericKinematics(arm, q).pose("3"), atol=1e-14
        )
        np.testing.assert_allclose(
            NumericKinematics(other, q).jacobian("3"), NumericKinematics(arm, q).jacobian("3"), atol=1e-14
        )


def test_a_moved_tool_does_change_something(write_urdf: Write) -> None:
    moved = load_arm(write_urdf(SLANTED.replace("0 0.4 0.12", "0 0.4 0.13")))
    assert trace_of(moved).pose("tool") != trace_of(load_arm(write_urdf(SLANTED))).pose("tool")


def test_a_chain_on_the_world_has_the_world_as_frame_0(write_urdf: Write) -> None:
    arm = load_arm(write_urdf(link("world", "b") + joint("j", "world", "b", xyz="0.1 0 0")))
    assert frame_of(arm, "0").is_world_frame()
    q = np.array([[0.7]])
    np.testing.assert_allclose(
        evaluate_entries(arm, trace_of(arm).pose("1"), q), NumericKinematics(arm, q).pose("1"), atol=1e-15
    )


def test_an_sdf_is_an_arm(tmp_path: Path) -> None:
    path = tmp_path / "arm.sdf"
    path.write_text("""<sdf version="1.9"><model name="m"><link name="a"/>
        <link name="b"><pose relative_to="j">0.05 0 0 0.3 0 0</pose></link>
        <joint name="j" type="revolute"><pose relative_to="a">0.1 0.2 0.3 0 0 0.7853981633974483</pose>
          <parent>a</parent><child>b</child><axis><xyz>0 1 1</xyz></axis></joint></model></sdf>""")
    arm = load_arm(path)
    q = np.random.default_rng(0).normal(size=(20, 1))
    np.testing.assert_allclose(
        evaluate_entries(arm, trace_of(arm).pose("1"), q), NumericKinematics(arm, q).pose("1"), atol=1e-12
    )


def test_missing_meshes_do_not_matter(write_urdf: Write) -> None:
    mesh = '<visual><geometry><mesh filename="package://nowhere/arm.dae"/></geometry></visual>'
    body = TWO.replace('<link name="b"/>', f'<link name="b">{mesh}{mesh.replace("visual", "collision")}</link>')
    assert load_arm(write_urdf(body)).warnings == ()


def test_warnings_of_the_parser_are_kept_with_file_and_line_and_not_told_twice(
    write_urdf: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = BufferingHandler(capacity=1000)
    monkeypatch.setattr(logging.getLogger(), "handlers", [told])
    path = write_urdf(TWO + '\n<transmission name="t"><type>odd</type></transmission>')
    (warning,) = load_arm(path).warnings
    assert warning.startswith(f"{path}:3: warning: A <transmission>")
    assert not told.buffer


def test_an_angle_that_is_nearly_right_is_warned_of(write_urdf: Write) -> None:
    arm = load_arm(write_urdf(link("a", "b") + joint("j", "a", "b", rpy="1.5721 0 0")))
    assert "turns by 1.5721 rad, nearly 2*pi/4; write 1.5707963267948966" in arm.warnings[0]
    assert trace_of(arm).constants == {"1.5721": 1.5721}


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("", "no moving joint; an arm has at least one revolute or prismatic joint"),
        (link("a", "b", "c") + joint("j", "a", "b"), "an arm has one base; bodies without a joint to a parent: a, c"),
        (
            link("a", "b", "c", "d") + joint("j", "a", "b") + joint("k", "b", "c") + joint("m", "b", "d"),
            "more than one moving branch: j, k and, off it, m; an arm is one serial chain",
        ),
        (
            link("a", "b", "c") + joint("j", "a", "c") + joint("k", "b", "c"),
            "joints 'j' and 'k' both carry 'c'; an arm is a serial chain without closed loops",
        ),
        (
            link("a", "b", "c") + joint("j", "a", "b") + joint("k", "b", "c", "planar"),
            "joint 'k' is planar; an arm has revolute, continuous, prismatic and fixed joints",
        ),
        (
            link("a", "b", "c") + joint("j", "a", "b") + joint("k", "b", "c", extra='<mimic joint="j"/>'),
            "joints coupled by <mimic> or constraints are not supported",
        ),
        (
            link("a", "b") + joint("j", "a", "b", "wobbly"),
            r"\.urdf:2: error: Joint 'j' has unrecognized type: 'wobbly'",
        ),
        (
            link("a", "b") + joint("j", "a", "b", xyz="nan 0 0"),
            r"\.urdf:2: Expected 3 values for attribute xyz got nan 0 0",
        ),
        (
            link("a", "b") + joint("j", "a", "b", extra='\n<limit lower="2" upper="1"/>'),
            r"\.urdf:3: the lower limit of a joint",
        ),
        (link("a") + joint("j", "a", "zz"), r"\.urdf:\d: error: Could not find link named 'zz'"),
        ("<link name='a'>", r"\.urdf:3: not well-formed XML: mismatched tag"),
        ("<xacro:arm xmlns:xacro='x'/>", r"\.urdf:2: <xacro:arm> is a macro; expand the file with xacro first"),
        (link("a", "a", "b") + joint("j", "a", "b"), r"\.urdf: .*already contains a body named 'a'"),
    ],
)
def test_what_is_not_an_arm_is_refused(body: str, message: str, write_urdf: Write) -> None:
    with pytest.raises(ModelError, match=message):
        load_arm(write_urdf(body))


def test_sdf_limits_the_wrong_way_round_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "arm.sdf"
    path.write_text("""<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>
        <joint name="j" type="revolute"><parent>a</parent><child>b</child>
        <axis><xyz>0 0 1</xyz><limit><lower>2</lower><upper>1</upper></limit></axis></joint></model></sdf>""")
    with pytest.raises(ModelError, match=r"arm\.sdf:3: the lower limit of a joint is above its upper limit"):
        load_arm(path)


def test_bad_directives_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "cell.dmd.yaml"
    path.write_text("directives:\n- add_model: {name: a, file: package://nowhere/arm.urdf}\n")
    with pytest.raises(ModelError, match=r"cell\.dmd\.yaml: .*unknown package 'nowhere'"):
        load_arm(path)


def test_the_catalogue_loads_without_a_warning(arm: Arm) -> None:
    assert arm.warnings == ()
    assert load_arm(arm.name).title if arm.name in arm_names() else True


def test_an_arm_is_loaded_once_until_its_files_change(write_urdf: Write) -> None:
    path = write_urdf(TWO)
    arm = load_arm(path)
    assert load_arm(str(path)) is arm
    assert load_arm(path.name, path.parent) is arm
    path.write_text(path.read_text().replace("0.33", "0.4321"))
    assert load_arm(path) is not arm
    assert load_arm("scara") is load_arm("scara", path.parent)


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        (
            "scarab",
            r"no arm 'scarab'; an arm is one of .*scara, .*, a path to a \.urdf, \.sdf, \.dmd\.yaml or a DH table",
        ),
        ("nowhere/arm.urdf", r"nowhere/arm\.urdf: no such model file"),
        ("", "an arm is a name, a path or a DH table, not ''"),
        (7, "an arm is a name, a path or a DH table, not 7"),
        (None, "an arm is a name, a path or a DH table, not None"),
    ],
)
def test_an_unknown_arm_is_refused_with_those_there_are(spec: object, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        load_arm(spec)  # type: ignore[arg-type]


def test_unknown_joint_variables_are_refused_with_those_there_are() -> None:
    arm = load_arm("scara")
    assert arm.joint("d_3").index == 3
    with pytest.raises(
        ArmproofError,
        match="no joint variable 'd_4' on arm 'scara'; its joint variables are theta_1, theta_2, d_3, theta_4",
    ):
        arm.joint("d_4")
