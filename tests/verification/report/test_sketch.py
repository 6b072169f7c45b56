"""The report's line drawing of an arm: from the same side as the figures of the course."""

import re

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.numeric.configurations import generic_configuration
from armproof.models.showing.projection import Projection, choose_projection, look_along
from armproof.models.showing.skeleton import place_skeleton
from armproof.verification.report.html.figures import ArmPainter
from armproof.verification.verdict import Record, Verdict

_TOLERANCE = 0.2  # of the units of the picture, which are written with one decimal


def misfit(arm: Arm, projection: Projection) -> float:
    """How far the links in the report's picture are from those seen along a projection, in any scale and place."""
    q = generic_configuration(arm)
    at = dict(zip((joint.symbol for joint in arm.joints), map(float, q), strict=True))
    figure = ArmPainter(arm).at_counterexample(Record(1, "", Verdict.REFUTED, counterexample=at))
    found = re.search(r'<polyline class="link" points="([^"]*)"', figure.svg if figure else "")
    assert found is not None
    drawn = np.array([point.split(",") for point in found[1].split()], dtype=float) * (1, -1)
    links = projection.points(place_skeleton(arm, q).line(arm.frames[-1]))
    drawn, links = (points - points.mean(axis=0) for points in (drawn, links))
    scale = float(np.sum(drawn * links) / np.sum(links * links))
    return float(np.abs(drawn - scale * links).max())


def test_the_report_shows_an_arm_from_the_side_of_the_figures(arm: Arm) -> None:
    assert misfit(arm, choose_projection(arm)) < _TOLERANCE


@pytest.mark.parametrize("arm", ["rx90", "scara"], indirect=True)
def test_another_side_is_told_apart(arm: Arm) -> None:
    other = np.radians(-58.0)
    assert misfit(arm, look_along(np.array([np.cos(other), np.sin(other), np.tan(np.radians(24.0))]))) > _TOLERANCE
