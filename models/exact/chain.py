"""Poses and Jacobians of an arm, multiplied link by link from the exact kinematics of each link.

The polynomials of a single link are short whatever the arm, and the product of n links takes a number of operations that
grows with n; multiplied out, the entries of six slanted joints would have thousands of terms. So the product is taken in
an algebra that the caller chooses: the graph of models/bulk, which shares what is common, or the polynomials themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import groupby, pairwise
from typing import Generic, TypeVar

from armproof.models.exact.polynomial import ONE, ZERO, Entry, Rows, add, matrix_product, multiply, scale, transpose
from armproof.models.exact.trace import Trace

T = TypeVar("T")


@dataclass(frozen=True)
class Algebra(Generic[T]):
    """What the links are multiplied in: `entry` brings an exact entry into it, `scale` multiplies by a whole number."""

    entry: Callable[[Entry], T]
    add: Callable[..., T]
    multiply: Callable[[T, T], T]
    scale: Callable[[T, int], T]


POLYNOMIALS: Algebra[Entry] = Algebra(lambda entry: entry, add, multiply, scale)


@dataclass(frozen=True)
class Link:
    """A frame as seen from a frame before it, and how the joints between the two move it.

    Attributes:
        before, after: the frames; `after` is farther from the base, or on the same link.
        pose: that of `after` in `before`, 4 rows of 4 entries.
        point, axes: the frame at whose origin, and the frame in whose axes, the twists stand: `before` or `after`.
        twists: for each joint between the two, by its place from 0, the [v; ω] of `after` relative to `before`.
    """

    before: str
    after: str
    pose: Rows
    point: str
    axes: str
    twists: Mapping[int, tuple[Entry, ...]]


def traced_link(trace: Trace, before: str, after: str) -> Link:
    """Return a link, with the twists where they are shortest.

    In the classic convention joint i turns about z of the frame before, in the modified one about z of its own.
    """
    choices = [
        (point, axes, trace.jacobian(point, axes, before if point == after else after))
        for point in (after, before)
        for axes in (after, before)
    ]
    point, axes, J = min(choices, key=lambda choice: sum(len(entry) for row in choice[2] for entry in row))
    sign = 1 if point == after else -1  # else it is the twist of `before` relative to `after`
    twists = {
        joint: tuple(scale(entry, sign) for entry in column) for joint, column in enumerate(transpose(J)) if any(column)
    }
    return Link(before, after, trace.pose(after, before), point, axes, twists)


class ChainKinematics(Generic[T]):
    """Poses and Jacobians of one arm in one algebra.

    From frame to frame it goes by the first frame of each link, so that what it asks for are the links between these, and
    those from these to the other frames of the same link.
    """

    def __init__(
        self, depths: Mapping[str, int], joints: int, link: Callable[[str, str], Link], algebra: Algebra[T]
    ) -> None:
        """Take the number of moving joints before each frame, that of all, what gives a link, and the algebra."""
        self._depths = depths
        self._joints = joints
        self._link = cache(link)
        self._algebra = algebra
        self._first = {depth: frame for frame, depth in reversed(list(depths.items()))}
        self._rotations: dict[tuple[str, str], list[list[T]]] = {}
        self._zero, self._one = algebra.entry(ZERO), algebra.entry(ONE)

    def pose(self, frame: str, reference: str) -> list[list[T]]:
        """Return the pose of a frame in a reference frame, 4 rows of 4 terms."""
        p = self._displacement(reference, frame, reference)
        R = self._rotation(frame, reference)
        last = [self._zero, self._zero, self._zero, self._one]
        return [[*row, coordinate] for row, coordinate in zip(R, p, strict=True)] + [last]

    def jacobian(self, frame: str, expressed_in: str, reference: str) -> list[list[T]]:
        """Return the geometric Jacobian [v; ω] of a frame relative to a reference, 6 rows of n terms.

        A joint gives the link after it the angular velocity ω, and a point P the velocity v_P: it moves the frame, whose
        origin is p, with v = v_P + ω × (p − p_P).
        """
        outward = self._depths[frame] >= self._depths[reference]
        columns = [[self._zero] * 6 for _ in range(self._joints)]
        for before, after in pairwise(self._path(reference, frame) if outward else self._path(frame, reference)):
            if self._depths[before] == self._depths[after]:
                continue
            link = self._link(before, after)
            R = self._rotation(link.axes, expressed_in)
            lever = self._displacement(link.point, frame, expressed_in)
            for joint, twist in link.twists.items():
                v, omega = (self._rotate(R, [self._algebra.entry(entry) for entry in twist[i : i + 3]]) for i in (0, 3))
                v = [self._algebra.add(a, b) for a, b in zip(v, self._cross(omega, lever), strict=True)]
                columns[joint] = [self._algebra.scale(term, 1 if outward else -1) for term in (*v, *omega)]
        return [list(row) for row in zip(*columns, strict=True)]

    def pairs(self) -> list[tuple[str, str]]:
        """Return the frames, before and after, of every link that may be asked for."""
        firsts = [self._first[depth] for depth in sorted(self._first)]
        others = [(self._first[depth], frame) for frame, depth in self._depths.items() if self._first[depth] != frame]
        return [*pairwise(firsts), *others]

    def _rotation(self, frame: str, reference: str) -> list[list[T]]:
        """Return the rotation of a frame in a reference frame, the product of those of the links between them."""
        if frame == reference:
            return [[self._one if i == j else self._zero for j in range(3)] for i in range(3)]
        if (frame, reference) not in self._rotations:
            before = self._path(reference, frame)[-2]
            R = [[self._algebra.entry(entry) for entry in row[:3]] for row in self._step(before, frame)[:3]]
            if before != reference:
                columns = list(zip(*R, strict=True))
                R = [[self._dot(row, column) for column in columns] for row in self._rotation(before, reference)]
            self._rotations[frame, reference] = R
        return self._rotations[frame, reference]

    def _displacement(self, first: str, last: str, axes: str) -> list[T]:
        """Return the vector from the origin of a frame to that of another, in some axes.

        The links are summed from the last: these sums are also the levers of the Jacobian.
        """
        if first == last:
            return [self._zero] * 3
        after = self._path(first, last)[1]
        link = [self._algebra.entry(row[3]) for row in self._step(first, after)[:3]]
        turned = self._rotate(self._rotation(first, axes), link)
        rest = self._displacement(after, last, axes)
        return [self._algebra.add(a, b) for a, b in zip(turned, rest, strict=True)]

    def _path(self, first: str, last: str) -> list[str]:
        """Return the frames from one to another, by the first frame of each link between them."""
        low, high = sorted((self._depths[first], self._depths[last]))
        between = [self._first[depth] for depth in range(low, high + 1) if depth in self._first]
        if self._depths[first] > self._depths[last]:
            between.reverse()
        return [name for name, _ in groupby([first, *between, last])]

    def _step(self, start: str, end: str) -> Rows:
        """Return the pose of a frame of a path in the one before it."""
        depth = self._depths[start]
        forward = depth < self._depths[end] or (depth == self._depths[end] and self._first[depth] == start)
        return self._link(start, end).pose if forward else inverse_pose(self._link(end, start).pose)

    def _rotate(self, R: Sequence[Sequence[T]], vector: Sequence[T]) -> list[T]:
        return [self._dot(row, vector) for row in R]

    def _dot(self, left: Sequence[T], right: Sequence[T]) -> T:
        return self._algebra.add(*(self._algebra.multiply(a, b) for a, b in zip(left, right, strict=True)))

    def _cross(self, a: Sequence[T], b: Sequence[T]) -> list[T]:
        add, multiply, scale = self._algebra.add, self._algebra.multiply, self._algebra.scale
        return [add(multiply(a[i], b[j]), scale(multiply(a[j], b[i]), -1)) for i, j in ((1, 2), (2, 0), (0, 1))]


def inverse_pose(X: Rows) -> Rows:
    """Return the inverse of a homogeneous transform: Rᵀ and −Rᵀ p."""
    R = transpose(tuple(row[:3] for row in X[:3]))
    p = matrix_product(R, tuple((row[3],) for row in X[:3]))
    return (*((*row, scale(add(*shift), -1)) for row, shift in zip(R, p, strict=True)), X[3])
