"""Poses and Jacobians of an arm as terms of a graph, multiplied link by link from the exact trace of each link.

The polynomials of a single link are short whatever the arm, and the product of n links takes a number of operations that
grows with n; multiplied out, the entries of six slanted joints would have thousands of terms.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from armproof.models.arm import Arm
from armproof.models.bulk.graph import ONE, ZERO, Graph, Matrix, Term
from armproof.models.exact.polynomial import Generator, Rows, transpose


class ChainKinematics:
    """Poses and Jacobians of one arm, in one graph, so that they share what they have in common."""

    def __init__(self, arm: Arm, constant: Callable[[Generator], float | None]) -> None:
        """Take the arm, and what gives each constant generator its number (see Graph)."""
        self._arm = arm
        self._rotations: dict[tuple[str, str], Matrix] = {}
        self.graph = Graph(constant)

    def pose(self, frame: str, reference: str) -> Matrix:
        """Return the pose of a frame in a reference frame, 4 rows of 4 terms."""
        p = self._displacement(reference, frame, reference)
        R = self._rotation(frame, reference)
        return [[*row, coordinate] for row, coordinate in zip(R, p, strict=True)] + [[ZERO, ZERO, ZERO, ONE]]

    def jacobian(self, frame: str, expressed_in: str, reference: str) -> Matrix:
        """Return the geometric Jacobian [v; ω] of a frame relative to a reference, 6 rows of n terms.

        A joint gives the link after it the angular velocity ω, and a point P the velocity v_P: it moves the frame, whose
        origin is p, with v = v_P + ω × (p − p_P).
        """
        outward = self._arm.trace.depth(frame) >= self._arm.trace.depth(reference)
        columns = [[ZERO] * 6 for _ in self._arm.joints]
        for before, after in pairwise(self._path(reference, frame) if outward else self._path(frame, reference)):
            point, axes, twists = self._shortest_twists(before, after)
            sign = (
                1 if outward == (point == after) else -1
            )  # of the link after, relative to that before; or the reverse
            R = self._rotation(axes, expressed_in)
            lever = self._displacement(point, frame, expressed_in)
            for joint, twist in enumerate(transpose(twists)):
                if any(twist):
                    v, omega = (
                        self._rotate(R, [self.graph.entry(entry) for entry in twist[i : i + 3]]) for i in (0, 3)
                    )
                    v = [self.graph.add(a, b) for a, b in zip(v, self._cross(omega, lever), strict=True)]
                    columns[joint] = [self.graph.scale(term, sign) for term in (*v, *omega)]
        return [list(row) for row in zip(*columns, strict=True)]

    def _rotation(self, frame: str, reference: str) -> Matrix:
        """Return the rotation of a frame in a reference frame, the product of those of the links between them."""
        if (frame, reference) not in self._rotations:
            before = self._path(reference, frame)[-2]
            R = self.graph.matrix(self._arm.trace.rotation(frame, before))
            if before != reference:
                columns = list(zip(*R, strict=True))
                R = [[self.graph.dot(row, column) for column in columns] for row in self._rotation(before, reference)]
            self._rotations[frame, reference] = R
        return self._rotations[frame, reference]

    def _displacement(self, first: str, last: str, axes: str) -> list[Term]:
        """Return the vector from the origin of a frame to that of another, in some axes.

        The links are summed from the last: these sums are also the levers of the Jacobian.
        """
        if first == last:
            return [ZERO] * 3
        after = self._path(first, last)[1]
        link = [self.graph.entry(entry) for entry in self._arm.trace.origin(after, first)]
        turned = self._rotate(self._rotation(first, axes), link)
        return [self.graph.add(a, b) for a, b in zip(turned, self._displacement(after, last, axes), strict=True)]

    def _path(self, first: str, last: str) -> tuple[str, ...]:
        """Return the frames from one to another, with one frame on each link between them that has a frame."""
        depth = self._arm.trace.depth
        on_link = {depth(name): name for name in reversed(self._arm.frames)}
        low, high = sorted((depth(first), depth(last)))
        between = [on_link[d] for d in range(low + 1, high) if d in on_link]
        return (first, *(between if depth(first) == low else reversed(between)), last)

    def _shortest_twists(self, before: str, after: str) -> tuple[str, str, Rows]:
        """Return a point, axes, and the Jacobian of the one frame relative to the other in which it is shortest.

        In the classic convention joint i turns about z of the frame before, in the modified one about z of its own.
        """
        choices = [
            (point, axes, self._arm.trace.jacobian(point, axes, before if point == after else after))
            for point in (after, before)
            for axes in (after, before)
        ]
        return min(choices, key=lambda choice: sum(len(entry) for row in choice[2] for entry in row))

    def _rotate(self, R: Matrix, vector: Sequence[Term]) -> list[Term]:
        return [self.graph.dot(row, vector) for row in R]

    def _cross(self, a: Sequence[Term], b: Sequence[Term]) -> list[Term]:
        multiply, scale = self.graph.multiply, self.graph.scale
        return [
            self.graph.add(multiply(a[i], b[j]), scale(multiply(a[j], b[i]), -1)) for i, j in ((1, 2), (2, 0), (0, 1))
        ]
