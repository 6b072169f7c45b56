"""An arm that a reader moves on a page: its numbers, its sliders and its words; a script draws it."""

from __future__ import annotations

import json

from markupsafe import Markup

from armproof.course.feedback import Quantity
from armproof.course.feedback.outcome import pretty
from armproof.course.figures.facts.moving import UNITS, columns_of, moving_of
from armproof.course.figures.facts.task import volume_unit
from armproof.models.errors import written
from armproof.models.language import look_up
from armproof.verification.latex.writer import symbol_as_latex

_FIGURE = Markup(
    '<figure class="hands" data-arm="{data}" data-unit="{unit}" hidden>'
    '<svg class="sketch" role="img" aria-label="{words}" viewBox="0 0 330 250" width="330" height="250"></svg>'
    '<div role="group" aria-label="{group}">{sliders}</div><p><output></output></p>'
    "<figcaption>{caption}</figcaption></figure>"
)
_SLIDER = Markup(
    '<p><label for="{id}">{name}</label><input type="range" id="{id}" min="{low:.0f}" max="{high:.0f}" step="1" value="{start:.0f}"'
    ' data-unit="{unit}" data-scale="{scale}"><output for="{id}"></output></p>'
)


def moving_figure(asked: Quantity, prefix: str) -> Markup:
    """Return the figure of a task's arm with a slider a joint, each id with a prefix; hidden until the script draws it."""
    arm = asked.loaded
    moving = moving_of(arm)
    joints = len(arm.joints)
    numbers = {**moving.numbers(), "columns": columns_of(asked.quantity.get("columns"), joints)}
    sliders = []
    for k, (joint, values) in enumerate(zip(arm.joints, numbers["joints"], strict=True), start=1):
        unit, scale = UNITS[joint.kind]
        low, high, start = (scale * values[key] for key in ("low", "high", "start"))
        name = pretty(symbol_as_latex(joint.symbol))
        sliders.append(
            _SLIDER.format(id=f"{prefix}{k}", name=name, low=low, high=high, start=start, unit=unit, scale=scale)
        )
    return _FIGURE.format(
        data=json.dumps(numbers, separators=(",", ":")),
        unit=volume_unit(arm, moving.task.rows, range(1, joints + 1)),
        words=written("The arm {arm} as its sliders have it", arm=arm.name),
        group=look_up("Joint values"),
        sliders=Markup("").join(sliders),
        caption=look_up("Move the sliders, by hand or by the arrow keys. Shaded: the velocities of the tool for joint rates of norm 1."),
    )  # fmt: skip
