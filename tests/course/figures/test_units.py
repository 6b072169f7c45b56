"""No axis of a plot has two units: what is in mm stands beside what is in degrees, each on an axis of its own."""

import re

import pytest
from matplotlib.figure import Figure

from armproof.course.figures.drawing.plots import axes_by_unit, plot_axes
from armproof.course.figures.drawing.style import new_figure
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.models.catalogue import load_arm

_UNIT = re.compile(r"\(([^()]*)\)$")
_ANGLES, _LENGTHS = {"°", "°/s", "°/s²", "mrad", "rad/s", "N m"}, {"m", "mm", "m/s", "m/s²", "N"}


def units(figure: Figure) -> dict[str, str]:
    """Return the unit of each curve that has a name, by the label of the axes that hold it."""
    found = {}
    for axes in figure.axes:
        unit = _UNIT.search(axes.get_ylabel())
        found |= {line.get_gid(): unit[1] for line in axes.lines if unit and line.get_gid()}
    return found


@pytest.mark.parametrize("kind", ["crossing", "tracking", "quintic"])
def test_angles_and_lengths_stand_on_axes_of_their_own(kind: str) -> None:
    arm = load_arm("scara")
    found = units(draw_kind(find_kind(kind), arm))
    assert not any("," in unit for unit in found.values())
    for joint in arm.joints:
        of_joint = {unit for gid, unit in found.items() if gid.endswith(f" {joint.symbol}")} - {"%"}
        assert of_joint <= (_ANGLES if joint.kind == "revolute" else _LENGTHS), joint.symbol
    errors = {gid: unit for gid, unit in found.items() if gid.startswith("error ")}
    assert set(errors.values()) == (
        {"mm", "°"} if kind == "crossing" else {"mm", "mrad"} if kind == "tracking" else set()
    )


def test_what_has_one_unit_has_one_axis() -> None:
    axes = plot_axes(new_figure(), (10, 10, 50, 30), "en")
    same = axes_by_unit(axes, {"revolute": "rate (%)", "prismatic": "rate (%)"}, "en")
    assert same["revolute"] is same["prismatic"] is axes
    other = axes_by_unit(axes, {"revolute": "e (mrad)", "prismatic": "e (mm)"}, "en")
    assert other["revolute"] is axes and other["prismatic"].get_ylabel() == "e (mm)"
