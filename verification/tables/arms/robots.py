"""The arm of a URDF that a document prints as code: its joints about and along axes of the base, where it stands at zero."""

from __future__ import annotations

import re
from contextlib import suppress
from fractions import Fraction
from functools import reduce
from math import pi

from armproof.verification.algebra.matrix import Matrix, column, pose_of
from armproof.verification.algebra.protocol import elementary
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Document
from armproof.verification.document.model import BuiltJoint, CodeRobot
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.poses import candidate_with_pose

_NUMBER = regex(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_LETTER = regex(r"(-?)([A-Za-z]+?)_?(\d)")
_OF_PI = regex(r"(-?)(?:(\d)\s*\*\s*)?(?:M_)?pi(?:\s*/\s*(\d))?", re.IGNORECASE)
_OF_NAME = regex(r"\D*(\d+)\D*")
_AXES = {"x": 0, "y": 1, "z": 2}
_NEAR = 2e-3  # of a right angle in radians: 1.57, 1.5708


def candidate_of_robot(document: Document) -> Candidate | None:
    """Return the arm of the one URDF in a document's code, None where its axes are none of the base's, or it tells other numbers of its joints than their places."""
    if len({each.joints for each in document.robots}) != 1:
        return None
    with suppress(EvaluationError, LookupError, ValueError):
        return _Built(document, document.robots[0]).candidate()
    return None


class _Built:
    """A chain of joints, and the letters that its document has for what moves them."""

    def __init__(self, document: Document, robot: CodeRobot) -> None:
        self.document, self.robot = document, robot
        self.algebra = ExactAlgebra(Ring(), None)

    def candidate(self) -> Candidate | None:
        """Return the arm; raises EvaluationError, LookupError, ValueError where it is none that a table has."""
        moving = [each for each in self.robot.joints if each.kind != "fixed"]
        numbers = [int(found[1]) for each in moving if (found := _OF_NAME.fullmatch(each.name)) is not None]
        if numbers and numbers != [*range(1, len(moving) + 1)]:
            return None
        is_of_q = any(self.document.writes(f"q_{place}") for place in range(1, len(moving) + 1))
        symbols = {
            each.name: f"{'q' if is_of_q else 'theta' if each.kind == 'revolute' else 'd'}_{place}"
            for place, each in enumerate(moving, 1)
        }
        factors = [matrix for each in self.robot.joints for matrix in self._moved(each, symbols.get(each.name, ""))]
        pose = reduce(Matrix.__matmul__, factors).map(Scalar.normal)
        place = (self.robot.cell, self.robot.line)
        return candidate_with_pose(pose, list(symbols.values()), place, self.algebra)

    def _moved(self, joint: BuiltJoint, symbol: str) -> list[Matrix]:
        """Return the transforms of a joint: to its origin, and by its variable."""
        ring = self.algebra.ring
        x, y, z = map(self._length, joint.xyz)
        found = [pose_of(self._unit(), column([x, y, z]), ring.zero, ring.one)]
        for axis, angle in zip("zyx", reversed(joint.rpy), strict=True):
            if quarters := _quarters(angle):
                found.append(elementary(self.algebra, "Rot", axis, self.algebra.pi() * quarters / 2))
        if symbol:
            axis, sign = _axis(joint.axis)
            kind = "Rot" if joint.kind == "revolute" else "Trans"
            found.append(elementary(self.algebra, kind, axis, ring.symbol(symbol) * sign))
        return found

    def _unit(self) -> Matrix:
        ring = self.algebra.ring
        return Matrix(tuple(tuple(ring.one if a == b else ring.zero for a in range(3)) for b in range(3)))

    def _length(self, text: str) -> Scalar:
        """Return a number, or a letter that the document has; raises ValueError, LookupError."""
        ring = self.algebra.ring
        if _NUMBER.fullmatch(text):
            return ring.rational(Fraction(text))
        if (found := _LETTER.fullmatch(text)) is None:
            raise LookupError(text)
        sign, letter, number = found.groups()
        key = next(
            each
            for each in (f"{letter}_{number}", f"{letter.swapcase()}_{number}", "")
            if not each or self.document.writes(each)
        )
        if not key:
            raise LookupError(text)
        return -ring.symbol(key) if sign else ring.symbol(key)


def _quarters(text: str) -> int:
    """Return how many right angles an angle is; raises LookupError where it is no number of them."""
    plain = text.strip("${} ").replace("np.", "").replace("math.", "").replace("+", "")
    if (found := _OF_PI.fullmatch(plain)) is not None:
        value = pi * int(found[2] or 1) / int(found[3] or 1) * (-1 if found[1] else 1)
    elif _NUMBER.fullmatch(plain):
        value = float(plain)
    else:
        raise LookupError(text)
    quarters = round(value / (pi / 2))
    if abs(value - quarters * pi / 2) > _NEAR:
        raise LookupError(text)
    return quarters


def _axis(entries: tuple[str, str, str]) -> tuple[str, int]:
    """Return the axis of the joint's frame about which it turns, and its sense; raises LookupError for any other."""
    values = [float(each) for each in entries]
    axis = next((name for name, k in _AXES.items() if abs(values[k]) == 1 and values.count(0) == 2), None)
    if axis is None:
        raise LookupError(entries)
    return axis, int(values[_AXES[axis]])
