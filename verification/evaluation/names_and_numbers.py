"""What the leaves of an expression stand for: numbers, names under a document's bindings, frames that it adds."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.values import Identity, identity
from armproof.verification.errors import EvaluationError, ShapeError, UnboundName
from armproof.verification.evaluation.differentiation import time_derivative
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import numbered_frames, transform_pair


def number_value(evaluator: Evaluating, node: n.Number) -> Value:
    """Return a number as a constant of the algebra."""
    return evaluator.algebra.rational(node.value)


def name_value(evaluator: Evaluating, node: n.Name) -> Value:
    """Return what a name stands for; raises UnboundName where it stands for nothing."""
    algebra, names = evaluator.algebra, evaluator.names
    if node.base == "words":
        raise UnboundName(node.text, say(Kind.WORDS_FOR_VALUE))
    if (quantity := names.quantities.get(node.key)) is not None:
        return algebra.quantity(quantity)
    if node.dots:
        return time_derivative(evaluator, node)
    if (sign := names.state.signs.value(node.key)) is not None:
        return algebra.rational(Fraction(sign))
    symbol = names.known_symbol(node.key)
    if symbol is not None:
        return algebra.symbol(symbol)
    if node.key in names.state.definitions:
        return names.defined_value(node.key, algebra)
    if (quantity := names.quantity(node)) is not None:
        return algebra.quantity(quantity)
    if node.key == "pi":
        return algebra.pi()
    if node.base in ("I", "Id", "E") and not (node.pre_sub or node.pre_sup or node.sup):
        if (size := re.fullmatch(r"([1-9])(?:x\1)?", node.sub)) is not None:
            return identity(algebra, int(size.group(1)))
        if not node.sub and node.base != "E":
            return Identity(algebra.rational(Fraction(1)))
    if names.is_free(node):
        names.used.add(node.key)
        return algebra.symbol(node.key)
    if node.key == "q" and names.arm is not None:
        return column([algebra.symbol(joint.symbol) for joint in names.arm.joints])
    if (angles := names.angle_sum(node)) is not None:
        return joint_angle_sum(evaluator, angles)
    if (added := names.added_frame(node)) is not None:
        return _to_added_frame(evaluator, node, *added)
    _reject_unknown_frame(evaluator, node)
    raise UnboundName(node.key)


def joint_angle_sum(evaluator: Evaluating, node: n.JointAngles) -> Any:
    """Return the θ_1 + θ_2 of c_{12}."""
    total = evaluator.algebra.rational(Fraction(0))
    for sign, index in node.terms:
        symbol = evaluator.names.joint_angle(index)
        if symbol is None:
            raise ShapeError(say(Kind.NO_SUCH_ANGLE, index=index))
        angle = evaluator.algebra.symbol(symbol)
        total = total + angle if sign > 0 else total - angle
    return total


def _to_added_frame(evaluator: Evaluating, node: n.Name, reference: str, frame: str, key: str) -> Matrix:
    """The transform to a frame that the document fixed on one of the arm's, such as a tool."""
    fixed = evaluator.names.defined_value(key, evaluator.algebra)
    if not isinstance(fixed, Matrix) or fixed.shape != (4, 4):
        raise UnboundName(node.key)
    whole = evaluator.algebra.quantity(Quantity("pose", frame, reference)) @ fixed
    return whole.block(range(3), range(3)) if node.base == "R" else whole


def _reject_unknown_frame(evaluator: Evaluating, node: n.Name) -> None:
    """A transform between numbered frames that the arm does not have is a slip, not a new name."""
    arm = evaluator.names.arm
    if arm is None or node.base not in ("T", "A", "H", "R") or node.primes:
        return
    indices = [index for index in (node.pre_sup, node.pre_sub, node.sup, node.sub) if index]
    numbered = numbered_frames(arm)
    if transform_pair(node, arm, evaluator.names.transforms) == (numbered[-1], str(len(numbered))):
        return  # ^3_4T of an arm with three joints: the tool's frame, which the display may define
    if len(indices) == 2 and all(index in arm.frames or index.isdigit() for index in indices):
        missing = next((index for index in indices if index not in arm.frames), None)
        if missing is not None:
            raise EvaluationError(say(Kind.NO_SUCH_FRAME, frame=missing, arm=arm.name, frames=list(arm.frames)))


def ellipsis(evaluator: Evaluating, _node: n.Dots) -> Value:
    """Refuse an ellipsis."""
    raise UnboundName("…", say(Kind.TERMS_LEFT_OUT))


def layout(evaluator: Evaluating, _node: n.Layout) -> Value:
    """Refuse several equations in one place."""
    raise EvaluationError(say(Kind.SEVERAL_EQUATIONS))
