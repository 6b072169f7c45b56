"""The kinematics of an arm at millions of configurations: compiled from its exact trace to vectorised NumPy.

The exact trace of each link (models/exact/trace.py) becomes terms of a graph (models/bulk/graph.py), the links are multiplied there
(models/exact/chain.py), and the graph is compiled once to a program (models/bulk/program.py). No plant is evaluated, so
that the double plant of models/numeric/plant.py stays an independent route.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from math import isfinite
from numbers import Real
from threading import Lock
from typing import Any

import numpy as np

from armproof.models.arm import Arm, once_per_arm
from armproof.models.bulk.graph import Graph, Matrix, Term
from armproof.models.bulk.inputs import JointInputs
from armproof.models.bulk.jacobian_part import JacobianPart, maximal_minors, read_part
from armproof.models.bulk.program import Program
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.chain import Algebra, ChainKinematics, traced_link
from armproof.models.exact.numbers import constant_value
from armproof.models.exact.polynomial import Generator
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.joint_values import read_joint_values

_MOST_MINORS = 84  # of 6 rows and 9 columns; more of them take longer than the singular values
_CHUNK = 16_384  # configurations whose singular values are computed at once
_GENERIC = 20


class BulkKinematics:
    """Poses, Jacobians, manipulability and condition numbers of an arm at N configurations, as read-only arrays.

    Every method takes q, an (N, n) array, list or tuple of joint values from base to tool (rad, m). N may be 0; values
    outside the joint limits are allowed (`outside_limits` of models/numeric/joint_values.py tells of them). It raises a ModelError
    where the arm has no such frame, row or column, or where q cannot be read. A reference, or axes, that are not given are the
    base frame's, usually "0". Programs are compiled at first use and kept. Threads may share a bulk.
    """

    def __init__(self, arm: Arm, values: Mapping[str, float] | None = None) -> None:
        """Take the arm, and other values for some of its lengths (m) and constant angles (rad).

        Raises:
            ModelError: the arm has no such length or angle, or its value is not a finite number.
        """
        self._arm = arm
        self._values = {**arm.lengths, **arm.angles, **_read_values(arm, values or {})}
        self._variables = {joint.symbol for joint in arm.joints}
        trace = trace_of(arm)
        depths = {frame: trace.depth(frame) for frame in arm.frames}
        self._graph = graph = Graph(self._constant)
        algebra = Algebra(graph.entry, graph.add, graph.multiply, graph.scale)
        self._kinematics = ChainKinematics(depths, len(arm.joints), partial(traced_link, trace), algebra)
        self._programs: dict[tuple[Any, ...], tuple[Program, list[tuple[int, int]]]] = {}
        self._lock = Lock()
        self._ranks: dict[JacobianPart, int] = {}

    def with_values(self, values: Mapping[str, float]) -> BulkKinematics:
        """Return the kinematics of the same arm with other lengths (m) and constant angles (rad).

        Raises:
            ModelError: the arm has no such length or angle, or its value is not a finite number.
        """
        return BulkKinematics(self._arm, {**self._values, **values})

    def pose(self, q: Any, frame: str, reference: str | None = None) -> np.ndarray:
        """Return the pose of a frame in a reference frame, {}^{reference}T_{frame}.

        Returns:
            (N, 4, 4) array, metres.
        """
        (X,) = self._run(q, "pose", *self._arm.frame_names(frame, reference))
        return X

    def jacobian(self, q: Any, frame: str, expressed_in: str | None = None, reference: str | None = None) -> np.ndarray:
        """Return the geometric Jacobian of the origin of a frame: [v; ω] = J(q) q̇.

        v (m/s) and ω (rad/s) are those of `frame` relative to `reference`, expressed in the axes of `expressed_in`.

        Returns:
            (N, 6, n) array, rows [v; ω], columns base to tool.
        """
        (J,) = self._run(q, "jacobian", *self._arm.frame_names(frame, expressed_in, reference))
        return J

    def pose_and_jacobian(self, q: Any, frame: str) -> tuple[np.ndarray, np.ndarray]:
        """Return the pose of a frame in the base frame and its Jacobian, sooner than one after the other.

        Returns:
            (N, 4, 4) and (N, 6, n) arrays, as `pose` and `jacobian` return them.
        """
        X, J = self._run(q, "pose and jacobian", *self._arm.frame_names(frame, None))
        return X, J

    def manipulability(
        self,
        q: Any,
        frame: str,
        rows: Sequence[int] | None = None,
        columns: Sequence[int] | None = None,
        expressed_in: str | None = None,
    ) -> np.ndarray:
        """Return Yoshikawa's manipulability w = √det(J Jᵀ), the product of the singular values of J.

        With more rows than columns w = √det(Jᵀ J); where J is square w = |det J|. By the formula of Cauchy and Binet, w
        is the root of the sum of the squared maximal minors; near a singular configuration this keeps the digits of which
        det(J Jᵀ) loses half.

        Args:
            rows: the rows of [v; ω] meant, counted from 1; all six if not given.
            columns: the columns meant, counted from 1 at the base; all n if not given.
            expressed_in: as for `jacobian`.

        Returns:
            (N,) array, not negative, in the unit of the minors.

        Source: T. Yoshikawa, Manipulability of robotic mechanisms, Int. J. of Robotics Research 4 (2), 1985.
        """
        part = read_part(self._arm, frame, rows, columns, expressed_in)
        if part.maximal_minors > _MOST_MINORS:
            return _read_only(self._singular_values(q, part).prod(axis=1))
        minors = self._run(q, "minors", part)[0][:, 0, 0]
        return _read_only(np.abs(minors) if part.maximal_minors == 1 else np.sqrt(minors))

    def condition_number(
        self,
        q: Any,
        frame: str,
        rows: Sequence[int] | None = None,
        columns: Sequence[int] | None = None,
        expressed_in: str | None = None,
    ) -> np.ndarray:
        """Return the condition number κ = σ_1/σ_r of the Jacobian, with r its rank at a generic configuration.

        Singular values that vanish everywhere, as those of a planar arm out of its plane, do not count. At a singular
        configuration, σ_r ≤ max(rows, columns) ε σ_1 with ε = 2⁻⁵², κ is infinite; it is never NaN. Where the rows mix
        metres and radians the number depends on the unit of length.

        Args:
            rows, columns, expressed_in: as for `manipulability`.

        Returns:
            (N,) array, from 1 to infinity.

        Source: J. K. Salisbury, J. J. Craig, Articulated hands, Int. J. of Robotics Research 1 (1), 1982.
        """
        part = read_part(self._arm, frame, rows, columns, expressed_in)
        singular_values = self._singular_values(q, part)
        largest, smallest = singular_values[:, 0], singular_values[:, max(self._rank(part), 1) - 1]
        regular = smallest > max(part.size) * np.finfo(float).eps * largest
        condition = np.full(len(largest), np.inf)
        np.divide(largest, smallest, out=condition, where=regular)
        return _read_only(condition)

    def _constant(self, generator: Generator) -> float | None:
        """Return the number of a constant generator, None for what varies with a joint."""
        moves = generator[1] in self._variables
        return None if moves else constant_value(generator, self._values)

    def _run(self, q: Any, *key: Any) -> list[np.ndarray]:
        """Return the arrays of a program, compiled if it is asked for the first time."""
        q = read_joint_values(self._arm, q)
        with self._lock:
            if key not in self._programs:
                self._programs[key] = self._compile(self._matrices(*key))
        program, shapes = self._programs[key]
        return [_read_only(array.reshape(len(q), *shape)) for array, shape in zip(program(q), shapes, strict=True)]

    def _compile(self, matrices: Sequence[Matrix]) -> tuple[Program, list[tuple[int, int]]]:
        groups = [[term for row in matrix for term in row] for matrix in matrices]
        shapes = [(len(matrix), len(matrix[0])) for matrix in matrices]
        return Program(self._graph, partial(JointInputs, self._arm.joints), groups), shapes

    def _matrices(self, what: str, *of: Any) -> list[Matrix]:
        """Return the matrices of terms that a program evaluates."""
        if what == "pose":
            return [self._kinematics.pose(*of)]
        if what == "jacobian":
            return [self._kinematics.jacobian(*of)]
        if what == "pose and jacobian":
            frame, base = of
            return [self._kinematics.pose(frame, base), self._kinematics.jacobian(frame, base, base)]
        return [[[self._volume(*of)]]]

    def _volume(self, part: JacobianPart) -> Term:
        """Return the determinant of a square part of the Jacobian, else the sum of its squared maximal minors."""
        J = self._kinematics.jacobian(part.frame, part.expressed_in, self._arm.frames[0])
        minors = maximal_minors(self._graph, part.of_terms(J))
        return minors[0] if len(minors) == 1 else self._graph.dot(minors, minors)

    def _singular_values(self, q: Any, part: JacobianPart) -> np.ndarray:
        q = read_joint_values(self._arm, q)
        values = np.empty((len(q), min(part.size)))
        for start in range(0, len(q), _CHUNK):
            J = self.jacobian(q[start : start + _CHUNK], part.frame, part.expressed_in)
            values[start : start + _CHUNK] = np.linalg.svd(J[:, part.rows][:, :, part.columns], compute_uv=False)
        return values

    def _rank(self, part: JacobianPart) -> int:
        """Return the rank at a generic configuration: the largest at some that are drawn at random."""
        if part not in self._ranks:
            q = np.random.default_rng(0).uniform(-np.pi, np.pi, (_GENERIC, len(self._arm.joints)))
            values = self._singular_values(q, part)
            self._ranks[part] = int((values > 1e-9 * values[:, :1]).sum(axis=1).max())
        return self._ranks[part]


@once_per_arm
def bulk_of(arm: Arm) -> BulkKinematics:
    """Return the kinematics of an arm at very many configurations."""
    return BulkKinematics(arm)


def _read_values(arm: Arm, values: Mapping[str, float]) -> dict[str, float]:
    known = (*arm.lengths, *arm.angles)
    for name, value in values.items():
        if name not in known:
            raise ModelError(Fault.NO_LENGTH_OR_ANGLE, name=name, arm=arm.name, known=list(known) or "none")
        if isinstance(value, bool) or not isinstance(value, Real) or not isfinite(value):
            raise ModelError(Fault.VALUE_NOT_FINITE, name=name, arm=arm.name, value=repr(value))
    return {name: float(value) for name, value in values.items()}


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array
