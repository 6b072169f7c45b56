"""A wrong result, sampled: the arm's quantity and what was obtained for it at a few generic configurations."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property, reduce
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.naming.quantities import numbered_frames

TOLERANCE = 1e-7
_NEVER_ALONE = {  # by the kind of the matrix: mistakes that nobody makes in some of its blocks and not in the others
    "pose": (Kind.LINK_TWICE,),
    "jacobian": (Kind.OTHER_ZERO, Kind.WRONG_LINK, Kind.OTHER_POINT),
}
_OF_TWO = (Kind.COLUMNS_SWAPPED, Kind.COLUMNS_REVERSED, Kind.COLUMNS_SHIFTED)  # that are made in two columns at once
_OF_MANY_COLUMNS = (  # of a Jacobian: where one column alone is changed, a sign in it is wrong, and not the joint's
    Kind.JOINT_THE_OTHER_WAY,
    Kind.JOINTS_THE_OTHER_WAY,
    Kind.WRONG_LINK,
)
Candidate = tuple[Finding, np.ndarray]  # what the result is instead, and the values it would have: (N, rows, columns)
Place = tuple[Finding, np.ndarray]  # a block of the matrix, and its mask (rows, columns)


def changed(values: np.ndarray, place: Any, by: Any) -> np.ndarray:
    """Return a copy of an array with other values in one place."""
    copy = values.copy()
    copy[place] = by
    return copy


@dataclass(frozen=True)
class Explanation:
    """A mistake, None where none was found; and in how many blocks it was not made, though it concerns them."""

    finding: Finding | None = None
    exceptions: int = 0

    @property
    def is_whole(self) -> bool:
        """Whether the mistake was made in all that it concerns."""
        return self.finding is not None and not self.exceptions

    def or_better(self, other: Explanation) -> Explanation:
        """Return the other explanation if it has fewer exceptions, else this one."""
        if other.finding is None or (self.finding is not None and other.exceptions >= self.exceptions):
            return self
        return other


@dataclass(frozen=True, eq=False)
class Case:
    """A quantity of an arm at N configurations.

    Attributes:
        kinematics: the plant of doubles at these configurations.
        true, obtained: (N, rows, columns); `obtained` may have another shape.
        partners: the plant at n more configurations, of which the k-th shares with the first the value of joint k and no
            other; None where the result cannot be had there.
        obtained_there: returns the result at those.
        is_printed: whether the result stands in a document; else a function computed it.
    """

    arm: Arm
    quantity: Quantity
    kinematics: NumericKinematics
    true: np.ndarray
    obtained: np.ndarray
    partners: NumericKinematics | None = None
    obtained_there: Callable[[], np.ndarray] | None = None
    is_printed: bool = False

    @property
    def q(self) -> np.ndarray:
        """The configurations, (N, n), rad and m."""
        return self.kinematics.q

    @property
    def fits(self) -> bool:
        """Whether the result has the shape of the quantity."""
        return self.obtained.shape == self.true.shape

    @cached_property
    def frames(self) -> list[str]:
        """The frames of the chain, base to tool: those with numbers, and the ends that are asked for beyond them."""
        chain, ends = numbered_frames(self.arm), (self.quantity.reference, self.quantity.frame)
        return [frame for frame in self.arm.frames if frame in (*chain, *ends)]

    @cached_property
    def size(self) -> np.ndarray:
        """The size 1 + |obtained| by which differences are scaled."""
        return np.asarray(1 + np.abs(self.obtained))

    @cached_property
    def whole(self) -> np.ndarray:
        """The 4×4 pose, or the 6×n Jacobian, that the quantity is or is a part of, at each configuration."""
        quantity = self.quantity
        if quantity.kind == "jacobian":
            return self.kinematics.jacobian(quantity.frame, quantity.reference, self.arm.frames[0])
        return self.kinematics.pose(quantity.frame, quantity.reference)

    def selected(self, whole: np.ndarray) -> np.ndarray:
        """Return what the quantity names of a 4×4 pose, or of a 6×n Jacobian, at each configuration."""
        rows, columns = kind_of(self.quantity).block(self.quantity, whole.shape[2])
        return np.asarray(whole[:, rows][:, :, columns])

    def column_of(self, joint: int) -> int:
        """Return the column (from 1) of a joint in the Jacobian: its place in the result where other columns come first."""
        asked = self.quantity.columns or ()
        in_order = list(asked) == sorted(asked)
        return joint if in_order or joint not in asked else list(asked).index(joint) + 1

    @cached_property
    def blocks(self) -> list[Place]:
        """The parts of the matrix that may be wrong by themselves: rotation and origin, v and ω of each column."""
        rows, columns = self.true.shape[1:]
        row, column = np.indices((rows, columns))
        if self.quantity.kind == "jacobian":
            place = np.array(self.quantity.rows or range(1, 7))[row]
            number = np.array(self.quantity.columns or range(1, columns + 1))[column]
            parts = [("linear", place <= 3), ("angular", place > 3)]
            blocks = [
                (say(Kind.THE_PART_OF_COLUMN, part=name, number=self.column_of(int(k))), part & (number == k))
                for k in np.unique(number)
                for name, part in parts
            ]
        elif self.quantity.kind == "pose" and not self.quantity.rows:
            blocks = [
                (say(Kind.THE_ROTATION), (row < 3) & (column < 3)),
                (say(Kind.THE_ORIGIN), (row < 3) & (column == 3)),
                (say(Kind.THE_LAST_ROW), row == 3),
            ]
        else:
            blocks = [(say(Kind.THE_MATRIX), np.ones((rows, columns), dtype=bool))]
        return [(name, mask) for name, mask in blocks if mask.any()]

    @cached_property
    def wrong(self) -> list[Place]:
        """The blocks in which the result differs from the quantity."""
        off = (np.abs(self.true - self.obtained) > TOLERANCE * self.size).any(axis=0)
        return [(name, mask) for name, mask in self.blocks if (off & mask).any()]

    def explained_by(self, candidates: Iterable[Candidate]) -> Explanation:
        """Return the candidate that was obtained in every block that is wrong, with the fewest exceptions."""
        best = Explanation()
        if self.fits and not self.wrong:  # right but for rounding, beside numbers that are large
            return best
        place = np.ones(self.obtained.shape[1:], dtype=bool)
        if self.fits:
            place = np.any([mask for _, mask in self.wrong], axis=0)
        first, limit = self.obtained[0][place], TOLERANCE * self.size[0][place]
        for finding, values in candidates:
            if values.shape != self.obtained.shape or not (np.abs(values[0][place] - first) <= limit).all():
                continue
            if (np.abs(values - self.obtained) <= TOLERANCE * self.size)[:, place].all():
                best = best.or_better(self._with_exceptions(finding, values))
            if best.is_whole:
                break
        return best

    def _with_exceptions(self, finding: Finding, values: np.ndarray) -> Explanation:
        """Say in which blocks alone a candidate was obtained, where it would differ in others too."""
        if not self.fits:
            return Explanation(finding)
        differs = (np.abs(self.true - values) > TOLERANCE * self.size).any(axis=0)
        if finding.kind in _OF_MANY_COLUMNS and self.quantity.kind == "jacobian" and differs.any(axis=0).sum() == 1 < differs.shape[1]:  # fmt: skip
            return Explanation()
        concerned = [name for name, mask in self.blocks if (differs & mask).any()]
        wrong = [name for name, _ in self.wrong]
        if len(wrong) >= len(concerned):
            return Explanation(finding)
        if finding.kind in _NEVER_ALONE.get(self.quantity.kind, ()) or (
            finding.kind in _OF_TWO and _columns(wrong) != _columns(concerned)
        ):
            return Explanation()
        place = _together(wrong, concerned)
        return Explanation(say(Kind.ALONE, cause=finding, place=place), len(concerned) - len(wrong))


def _columns(blocks: list[Finding]) -> set[int]:
    """Return the columns of a Jacobian's blocks."""
    return {block.terms["number"] for block in blocks if "number" in block.terms}


def _together(blocks: list[Finding], concerned: list[Finding]) -> Finding:
    """Return several blocks as one place: a part of a Jacobian, some of its columns, the rotation and the origin.

    Args:
        concerned: all blocks that the mistake would have changed.
    """
    parts = {block.terms["part"] for block in blocks if "part" in block.terms}
    columns = sorted(_columns(blocks))
    if len(blocks) == 1:
        return blocks[0]
    if not columns:
        return reduce(lambda one, other: say(Kind.BOTH, one=one, other=other), blocks)
    if len(parts) == 1:
        part = parts.pop()
        if any(block.terms.get("part") == part and block not in blocks for block in concerned):
            return say(Kind.THE_PART_OF_COLUMNS, part=part, numbers=columns)
        return say(Kind.THE_PART, part=part)
    return say(Kind.THE_COLUMN, number=columns[0]) if len(columns) == 1 else say(Kind.THE_COLUMNS, numbers=columns)
