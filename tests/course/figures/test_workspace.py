"""The workspace: each cell's best configuration is there on the double plant, with that manipulability; the curves are singular."""

import numpy as np
import pytest

from armproof.course.figures.facts.positioning import position_singularities, positioning_of
from armproof.course.figures.kinds.workspace import (
    CONFIGURATIONS,
    applies,
    caption,
    curve_points,
    shown_configuration,
    workspace_figure,
    workspace_of,
)
from armproof.course.figures.registry import caption_kind, draw_kind, figures_for, find_kind
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.test_sketch import TOLERANCE, drawn, figure_of

ARMS = ("planar_2r", "planar_3r", "polar_rp", "scara", "spatial_rrr", "rx90", "kr210")
SINGULAR = ("planar_2r", "planar_3r", "scara", "spatial_rrr", "rx90", "kr210")


def volume(arm, positioning, q: np.ndarray) -> np.ndarray:
    """√det(J Jᵀ) on the double plant."""
    J = NumericKinematics(arm, q).jacobian(positioning.frame)[:, [row - 1 for row in positioning.rows]][
        :, :, [c - 1 for c in positioning.columns]
    ]
    return np.linalg.svd(J, compute_uv=False).prod(axis=1)


@pytest.mark.parametrize("name", ARMS)
def test_each_cell_holds_what_the_plant_has_there(name: str) -> None:
    arm = load_arm(name)
    found = workspace_of(arm)
    assert CONFIGURATIONS >= 10**6
    rows, columns = np.nonzero(~np.isnan(found.best))
    some = np.random.default_rng(0).choice(len(rows), 400)
    q = found.winners[rows[some], columns[some]]
    w = found.best[rows[some], columns[some]]
    assert np.abs(volume(arm, found.positioning, q) - w).max() <= 1e-9
    points = found.positioning.projection.points(NumericKinematics(arm, q).pose(found.positioning.frame)[:, :3, 3])
    cell = found.x[1] - found.x[0]
    assert np.abs(points[:, 0] - found.x[columns[some]]).max() <= cell / 2 + TOLERANCE
    assert np.abs(points[:, 1] - found.y[rows[some]]).max() <= cell / 2 + TOLERANCE
    assert np.abs(volume(arm, found.positioning, np.roll(q, 1, axis=0)) - w).max() > 1e-3  # the negative control
    for k in (column - 1 for column in found.positioning.columns):
        assert arm.joints[k].lower - 1e-12 <= q[:, k].min() and q[:, k].max() <= arm.joints[k].upper + 1e-12


@pytest.mark.parametrize("name", ARMS)
def test_the_picture_is_the_map(name: str) -> None:
    arm = load_arm(name)
    found = workspace_of(arm)
    figure = figure_of(workspace_figure, arm)
    image = next(image for axes in figure.axes for image in axes.images if image.get_gid() == "best")
    assert np.array_equal(np.ma.filled(image.get_array(), np.nan), found.best, equal_nan=True)
    stick = drawn(figure)["stick"]
    end = NumericKinematics(arm, shown_configuration(found)[None]).pose(found.positioning.frame)[0, :3, 3]
    assert np.abs(stick[-1] - found.positioning.projection.points(end)).max() <= TOLERANCE


@pytest.mark.parametrize("name", SINGULAR)
def test_the_curves_drawn_are_images_of_singular_configurations(name: str) -> None:
    arm = load_arm(name)
    found, lines = workspace_of(arm), drawn(figure_of(workspace_figure, arm))
    assert found.curves
    for latex, q in found.curves.items():
        points = lines[f"singular {latex}"]
        valid = ~np.isnan(q[:, 0])
        assert np.array_equal(np.isnan(points[:, 0]), ~valid)
        on_plant = found.positioning.projection.points(
            NumericKinematics(arm, q[valid]).pose(found.positioning.frame)[:, :3, 3]
        )
        assert np.abs(points[valid] - on_plant).max() <= TOLERANCE
        assert np.nanmax(np.abs(curve_points(found.positioning, q) - points)) <= TOLERANCE
        assert volume(arm, found.positioning, q[valid]).max() <= 1e-7
        assert volume(arm, found.positioning, q[valid] + 0.1).max() > 1e-3  # the negative control


def test_families_beyond_the_limits_have_no_curve() -> None:
    arm = load_arm("planar_2r")
    analysis = position_singularities(arm)
    assert analysis is not None and {family.latex for family in analysis.families} == {
        r"\theta_2 = 0",
        r"\theta_2 = \pi",
    }
    assert set(workspace_of(arm).curves) == {r"\theta_2 = 0"}
    assert "No singular configuration" in caption(load_arm("polar_rp"))


def test_the_centre_of_a_wrist_is_mapped_in_the_section_of_the_first_joint() -> None:
    for name, frame in (("rx90", "4"), ("kr210", "5")):
        positioning = positioning_of(load_arm(name))
        assert positioning is not None
        assert (positioning.frame, positioning.wrist, positioning.about) == (frame, True, True)
        assert positioning.columns == (1, 2, 3)


def test_a_wrist_has_no_map_and_says_why() -> None:
    arm = load_arm("spherical_wrist")
    kind = find_kind("workspace")
    assert "neither in a plane" in str(applies(arm, "en")) and "ni dans un plan" in str(applies(arm, "fr"))
    assert kind not in figures_for(arm)
    assert draw_kind(kind, arm).texts


@pytest.mark.parametrize("name", ARMS)
def test_the_boundary_is_reached_and_has_nothing_beyond_it(name: str) -> None:
    """From a point of it one can go to a place that no configuration reaches, and to one that some do."""
    found = workspace_of(load_arm(name))
    cell = found.x[1] - found.x[0]
    points = found.boundary[~np.isnan(found.boundary[:, 0])]
    reached = np.argwhere(~np.isnan(found.best))[:, ::-1] * cell + [found.x[0], found.y[0]]
    empty = np.pad(np.isnan(found.best), 3, constant_values=True)
    empties = (np.argwhere(empty)[:, ::-1] - 3) * cell + [found.x[0], found.y[0]]
    for point in points[:: max(len(points) // 150, 1)]:
        assert np.linalg.norm(reached - point, axis=1).min() <= 2.5 * cell
        assert np.linalg.norm(empties - point, axis=1).min() <= 5 * cell
    inside = found.positioning.projection.points(
        NumericKinematics(found.positioning.arm, shown_configuration(found)[None]).pose(found.positioning.frame)[
            0, :3, 3
        ]
    )
    if name != "polar_rp":  # at its best with the slide drawn out
        assert np.linalg.norm(points - inside, axis=1).min() > 3 * cell  # the negative control


def test_joint_limits_bound_a_planar_arm_where_no_configuration_is_singular() -> None:
    """The polar arm: two arcs of the slide's ends, two sides of the angle's; a circle less a wedge."""
    arm = load_arm("polar_rp")
    points = workspace_of(arm).boundary
    points = points[~np.isnan(points[:, 0])]
    angle, slide = (np.array([joint.lower, joint.upper]) for joint in arm.joints)
    r, theta = np.linalg.norm(points, axis=1), np.arctan2(points[:, 1], points[:, 0])
    at_end = np.abs(r[:, None] - slide).min(axis=1) < 1e-9
    at_side = np.abs(np.angle(np.exp(1j * (theta[:, None] - angle)))).min(axis=1) < 1e-9
    assert (at_end | at_side).all() and at_end.any() and at_side.any()


def test_the_highest_manipulability_is_the_same_wherever_it_is_told() -> None:
    """l_1 l_2 = 0.1575 m² of the planar 2R arm, printed as 0.158 by the workspace, the map and its caption."""
    arm = load_arm("planar_2r")
    exact = arm.lengths["l_1"] * arm.lengths["l_2"]
    found = workspace_of(arm)
    assert found.highest == pytest.approx(exact, rel=1e-9) and np.nanmax(found.best) < exact
    assert all("0.158 m²" in caption_kind(find_kind(kind), arm) for kind in ("workspace", "manipulability"))
