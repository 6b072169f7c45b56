"""The picture of a student's answer on request, right or wrong."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from armproof.course.feedback.answer import is_function, is_missing
from armproof.course.feedback.errors import AnswerError
from armproof.course.feedback.html import block
from armproof.course.feedback.picture import call_at, draw_answer
from armproof.course.feedback.quantity import Quantity
from armproof.course.feedback.shown import Shown
from armproof.models.errors import ArmproofError
from armproof.verification.functions.returned import NotAttempted
from armproof.verification.report.html.figures import Figure

if TYPE_CHECKING:
    from armproof.course.feedback.task import Task

NOTHING_YET = "`{}`: no answer yet, nothing to draw."
_USUAL = (0.5, -0.9, 1.1, 0.7, -0.6, 0.8)  # rad; of a slide a third of it, in metres


class Portrait:
    """A picture with its caption."""

    def __init__(self, figure: Figure) -> None:
        self.figure = figure
        self.caption = figure.caption

    def __repr__(self) -> str:
        return f"[{self.caption}]"

    def _repr_html_(self) -> str:
        inner = Markup("<figure>{}<figcaption>{}</figcaption></figure>").format(self.figure.svg, self.caption)
        return str(block("open", inner))


def show_answer(task: Task, answer: Any, at: Mapping[str, float]) -> Shown | Portrait:
    """Return the answer over the arm, or a polite sentence."""
    if is_missing(answer):
        return Shown(NOTHING_YET.format(task.name))
    if not isinstance(task.asks, Quantity) or not is_function(answer):
        return Shown(f"`{task.name}`: only a function that gives a pose, an origin or a Jacobian can be drawn.")
    joints = {joint.symbol: joint for joint in task.asks.loaded.joints}
    if unknown := sorted(set(at) - set(joints)):
        raise AnswerError(f"no joint '{unknown[0]}'; the joints are {', '.join(joints)}")
    usual = {
        symbol: value if joint.kind == "revolute" else abs(value) / 3
        for (symbol, joint), value in zip(joints.items(), _USUAL, strict=False)
    }
    at = {**usual, **at}
    try:
        call_at(task.asks.loaded, answer, at)
    except NotAttempted:
        return Shown(NOTHING_YET.format(task.name))
    except ArmproofError as problem:
        return Shown(f"`{task.name}`: the answer cannot be drawn: {problem}")
    figure = draw_answer(task.asks.loaded, task.asks.quantity, answer, at)
    if figure is None:
        return Shown(f"`{task.name}`: this answer cannot be drawn: it is no pose, point or Jacobian in the base frame.")
    return Portrait(figure)
