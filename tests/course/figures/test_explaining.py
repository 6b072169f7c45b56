"""Figures that explain a word: a link, the cases of two axes, the gripper, columns of a Jacobian, elbow up and down, branches.

The French ones are drawn, whose words are longer; in a sweep those of both languages.
"""

import numpy as np
import pytest

from armproof.course.figures.facts.branches import branch_of, corners_of
from armproof.course.figures.facts.columns import columns_of
from armproof.course.figures.facts.elbow import elbow_of
from armproof.course.figures.facts.link_parts import link_parts
from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.facts.solutions import postures_of
from armproof.course.figures.facts.task import tool_frame
from armproof.course.figures.kinds import axes, gripper, link
from armproof.course.figures.registry import KINDS, caption_kind, draw_kind, figures_for, find_kind
from armproof.course.links import classic_link, modified_link
from armproof.models.catalogue import load_arm
from armproof.models.language import languages
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.conftest import TABLES
from tests.course.figures.legibility import illegible
from tests.laws import SWEEP

GENERAL = [name for name in KINDS if find_kind(name).general]
LINKS = {"classic": classic_link, "modified": modified_link}


def drawn(figure) -> set[str]:
    return {artist.get_gid() for artist in figure.findobj() if artist.get_gid()}


@pytest.mark.parametrize("name", GENERAL)
@pytest.mark.parametrize("lang", languages() if SWEEP else ("fr",))
def test_what_explains_a_word_can_be_read_and_belongs_to_no_arm(name: str, lang: str) -> None:
    arm, kind = load_arm("scara"), find_kind(name)
    assert illegible(draw_kind(kind, arm, lang)) == ()
    assert "SCARA" not in caption_kind(kind, arm, lang) and kind not in figures_for(arm)


@pytest.mark.parametrize("convention", LINKS)
def test_a_link_is_drawn_as_its_matrix_has_it(convention) -> None:
    a, alpha, d, theta = link.EXAMPLE
    parts = link_parts(convention, *link.EXAMPLE)
    X = LINKS[convention](a, np.radians(alpha), d, np.radians(theta))
    np.testing.assert_allclose(np.linalg.inv(parts.before) @ parts.after, X, atol=1e-12)
    assert [np.linalg.norm(np.diff(parts.lengths[name], axis=0)) for name in "ad"] == pytest.approx([a, d])
    for turn, end in zip(parts.turns, (parts.after[:3, 2], parts.after[:3, 0]), strict=True):
        across = np.cross(turn.axis, turn.start)
        np.testing.assert_allclose(np.cos(turn.angle) * turn.start + np.sin(turn.angle) * across, end, atol=1e-12)
    ids = drawn(link.link_figure(load_arm("scara")))
    assert {"a", "d", "alpha", "theta", "axis 0", "axis 1", "normal", "frame i-1 x", "frame i z"} <= ids


@pytest.mark.parametrize("case", axes.CASES)
def test_the_common_normal_is_the_shortest_way(case: str) -> None:
    a, alpha = axes.CASES[case]
    parts = link_parts("modified", a, alpha, 0.0, 0.0)
    (p, u), (r, v) = parts.axes
    s, t = np.meshgrid(np.linspace(-1, 1, 81), np.linspace(-1, 1, 81))
    ways = (p + s[..., None] * u) - (r + t[..., None] * v)
    assert np.linalg.norm(ways, axis=-1).min() == pytest.approx(np.linalg.norm(np.diff(parts.feet, axis=0)), abs=1e-9)
    assert (np.linalg.norm(np.cross(u, v)) < 1e-9) == (case == "parallel") and (a == 0) == (case == "meeting")


def test_the_axes_of_the_gripper_are_a_rotation() -> None:
    R = np.column_stack([gripper.SLIDING, gripper.NORMAL, gripper.APPROACH])
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-15)
    assert np.linalg.det(R) == pytest.approx(1)
    np.testing.assert_allclose(gripper.SLIDING, np.cross(gripper.NORMAL, gripper.APPROACH))


@pytest.mark.parametrize("name", ["planar_2r", "polar_rp", "spatial_rrr", "scara", "rx90"])
def test_a_column_is_axis_times_lever(name: str) -> None:
    arm = load_arm(name)
    J = NumericKinematics(arm, showing_pose(arm)[None]).jacobian(tool_frame(arm))[0]
    for k, column in enumerate(columns_of(arm)):
        turns = column.joint.kind == "revolute"
        expected = np.cross(column.z, column.lever) if turns else column.z
        np.testing.assert_allclose(column.v, expected, atol=1e-9)
        np.testing.assert_allclose(J[3:, k], column.z if turns else 0 * column.z, atol=1e-9)
        assert not turns or np.allclose(expected, 0) or not np.allclose(column.v, -expected)


@pytest.mark.parametrize("name", ["planar_2r", "planar_3r", "scara", "scara_column"])
def test_both_elbows_lie_on_both_circles(name: str) -> None:
    found = elbow_of(load_arm(name))
    assert found is not None
    for elbow in found.elbows:
        reached = np.linalg.norm(elbow - found.shoulder), np.linalg.norm(elbow - found.target)
        assert reached == pytest.approx(found.radii, abs=1e-9)
    side = [np.linalg.det([found.target - found.shoulder, elbow - found.shoulder]) for elbow in found.elbows]
    assert side[0] == pytest.approx(-side[1]) and side[0] > 1e-3
    assert {"circle shoulder", "circle target", "posture 1 link 1", "posture 2 link 1", "r"} <= drawn(
        draw_kind(find_kind("elbow"), load_arm(name))
    )


def test_arms_without_two_such_postures_have_no_elbow_figure() -> None:
    assert [elbow_of(load_arm(name)) for name in ("polar_rp", "spatial_rrr", "rx90", "spherical_wrist")] == [None] * 4


@pytest.mark.parametrize("spec", ["rx90", "kr210", TABLES["puma table"]], ids=["rx90", "kr210", "puma"])
def test_each_of_eight_postures_has_a_name_of_its_own(spec) -> None:
    arm = load_arm(spec)
    q = postures_of(arm).q
    names = [branch_of(arm, each) for each in q]
    assert len(names) == 8 == len(set(names))
    wrists = np.array([corners_of(arm, each)["wrist"] for each in q])
    np.testing.assert_allclose(wrists, np.tile(wrists[0], (8, 1)), atol=1e-6)
    flipped = q[0] + np.array([0, 0, 0, np.pi, -2 * q[0][4], np.pi])
    assert branch_of(arm, flipped)[:2] == names[0][:2] and branch_of(arm, flipped)[2] != names[0][2]
    assert corners_of(load_arm("scara"), np.zeros(4)) == {} and branch_of(load_arm("scara"), np.zeros(4)) == ()
