"""Passing a singular configuration: the joint rates drawn give the tool its twist on the double plant; damped ones are bounded."""

import numpy as np
import pytest

from armproof.course.figures.facts.near_singular import near_singular
from armproof.course.figures.facts.task import tool_points
from armproof.course.figures.kinds.crossing import applies, caption, crossing_figure, error_parts, rate_scales
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import choose_projection
from tests.course.figures.test_sketch import TOLERANCE, drawn, figure_of


@pytest.fixture
def crossing_arm(arm: Arm) -> Arm:
    if applies(arm, "en") is not None:
        pytest.skip(str(applies(arm, "en")))
    return arm


def rates_of(arm: Arm, name: str) -> np.ndarray:
    lines, scales = drawn(figure_of(crossing_figure, arm)), rate_scales(arm)[0]
    return np.column_stack([lines[f"rate {name} {joint.symbol}"][:, 1] for joint in arm.joints]) / scales


def test_the_rates_drawn_give_the_tool_its_twist_on_the_double_plant(crossing_arm: Arm) -> None:
    found = near_singular(crossing_arm)
    assert found is not None
    rows = [row - 1 for row in found.task.rows]
    numeric = NumericKinematics(crossing_arm, found.q)
    J, rates = numeric.jacobian(found.task.frame)[:, rows], rates_of(crossing_arm, "pseudo")
    assert np.abs((J @ rates[:, :, None])[:, :, 0] - found.twist[rows]).max() <= 1e-9 * max(1, np.abs(rates).max())
    assert (
        np.abs(numeric.pose(found.task.frame)[:, :3, 3] - found.poses[:, :3, 3])[:, [r for r in rows if r < 3]].max(
            initial=0
        )
        <= 1e-8
    )
    damped = rates_of(crossing_arm, "damped")
    assert np.abs((J @ damped[:, :, None])[:, :, 0] - found.twist[rows]).max() > 1e-3  # the negative control


def test_the_damped_rates_are_those_of_the_formula_and_bounded(crossing_arm: Arm) -> None:
    found = near_singular(crossing_arm)
    assert found is not None
    rows = [row - 1 for row in found.task.rows]
    J = NumericKinematics(crossing_arm, found.q_damped).jacobian(found.task.frame)[:, rows]
    wanted = found.twist[rows] + 5.0 * found.error
    inverse = J.transpose(0, 2, 1) @ np.linalg.inv(J @ J.transpose(0, 2, 1) + found.damping**2 * np.eye(len(rows)))
    drawn_rates = rates_of(crossing_arm, "damped")
    assert np.abs((inverse @ wanted[:, :, None])[:, :, 0] - drawn_rates).max() <= 1e-7
    bound = np.linalg.norm(wanted, axis=1) / (2 * found.damping)
    assert (np.linalg.norm(drawn_rates, axis=1) <= bound * (1 + 1e-9)).all()
    assert np.abs(rates_of(crossing_arm, "pseudo")).max() > np.abs(drawn_rates).max()


def test_paths_are_where_the_plant_has_the_tool(crossing_arm: Arm) -> None:
    found, lines = near_singular(crossing_arm), drawn(figure_of(crossing_figure, crossing_arm))
    assert found is not None
    projection = choose_projection(crossing_arm)
    for name, q in (("pseudo", found.q), ("damped", found.q_damped)):
        assert np.abs(lines[f"path {name}"] - projection.points(tool_points(crossing_arm, q))).max() <= TOLERANCE


def test_it_nears_the_family_that_it_names(crossing_arm: Arm) -> None:
    found = near_singular(crossing_arm)
    assert found is not None
    distance = found.family.distance(found.q)
    assert distance[found.nearest] < 0.15 < distance.max()
    assert found.family.latex.split("=")[0].strip("\\ ")[:3] in caption(crossing_arm)
    assert all(np.isfinite(error).all() for _, _, error in error_parts(found))


def test_an_arm_whose_singular_configuration_is_out_of_reach_says_so() -> None:
    kind, arm = find_kind("crossing"), load_arm("polar_rp")
    assert near_singular(arm) is None
    assert "No singular configuration within the joint limits" in str(kind.applies(arm, "en"))
    assert any("singular" in text.get_text() for text in draw_kind(kind, arm).texts)
