"""The order in which the displays of a document solve for the joints."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from armproof.verification.errors import DocumentError, EvaluationError, TooComplex
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.derivation import Derivation, Step
from armproof.verification.inverse.given_target import GivenTarget
from armproof.verification.inverse.resolution import Resolution

MOST_SIGNS = 6  # independent signs: 64 branches


class NoDerivation(DocumentError):
    """The displays of a document do not solve for every joint."""

    kind = Kind.NO_DERIVATION


def plan(start: Derivation, order: tuple[str, ...], algebra: GivenTarget) -> Derivation:
    """Return the derivation with its steps: for each joint the first display that can be computed when it is due.

    Args:
        start: names, target and formulas.
        order: the joints in the order in which they are solved; () takes the displays in their order.
        algebra: any, with the target in it.

    Raises:
        NoDerivation: a joint that no display solves for, and what the displays that try lack.
    """
    resolution = Resolution(start, algebra, {})
    steps: list[Step] = []
    left = list(order) or [joint.symbol for joint in start.arm.joints]
    while left:
        found = _next_step(resolution, left[:1] if order else left)
        if found is None:
            raise NoDerivation(_why_not(resolution, left[:1] if order else left), "inverse")
        step, value = found
        algebra.solved[step.joint] = value
        steps.append(step)
        left.remove(step.joint)
    signs = tuple(dict.fromkeys(resolution.branching))
    if len(signs) > MOST_SIGNS:
        raise DocumentError(say(Kind.TOO_MANY_SIGNS, count=len(signs), most=MOST_SIGNS), "inverse")
    return replace(start, steps=tuple(steps), choice=dict(resolution.choice), signs=signs)


def _next_step(resolution: Resolution, joints: list[str]) -> tuple[Step, Any] | None:
    """Return the first display, in the document's order, that solves for one of the joints."""
    formulas = [formula for joint in joints for formula in resolution.derivation.formulas.get(joint, [])]
    for formula in sorted(formulas, key=lambda formula: formula.line):
        known, choice = len(resolution.branching), dict(resolution.choice)
        try:
            return Step(formula.key, formula), resolution.scalar(formula)
        except TooComplex:
            raise
        except EvaluationError:
            del resolution.branching[known:]
            resolution.choice = choice
    return None


def _why_not(resolution: Resolution, joints: list[str]) -> str:
    target = ", ".join(resolution.derivation.target.names)
    reasons = "; ".join(_reason(resolution, joint) for joint in joints)
    return f"'inverse': no display solves for {' or '.join(joints)} by {target}: {reasons}"


def _reason(resolution: Resolution, joint: str) -> str:
    found = []
    for formula in resolution.derivation.formulas.get(joint, []):
        try:
            resolution.scalar(formula)
        except EvaluationError as error:
            found.append(f"line {formula.line}: {error}")
    return ", ".join(found) or f"no display '{joint} = …'"
