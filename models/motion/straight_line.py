"""Straight-line motion of the tool: its origin on a line, its axes turning evenly, as a path in joint space."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from numbers import Integral
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.differential_solver import ALL_ROWS, Solver, differential_solver, read_rows
from armproof.models.motion.pose_error import pose_error, read_pose
from armproof.models.numeric.joint_values import limit_notes, read_configuration
from armproof.models.numeric.plant import NumericKinematics


@dataclass(frozen=True)
class StraightLine:
    """A straight-line motion of the tool, over s from 0 to 1; follow_path and time_optimal give it time.

    Attributes:
        poses: the pydrake PiecewisePose of the tool in frame 0.
        path: the joint values, a pydrake PiecewisePolynomial with values of the shape (n, 1), a cubic spline.
        position_error: the largest distance of the tool on the path from the line (m), in the rows followed.
        rotation_error: the largest angle from the axes it should have (rad), in the rows followed.
        least_singular_value: the least of the Jacobian's rows followed, along the path; near 0 the joints are fast.
        least_at: s where it is.
    """

    poses: Any
    path: Any
    position_error: float
    rotation_error: float
    least_singular_value: float
    least_at: float


def pose_line(X_0: np.ndarray, X_f: np.ndarray) -> Any:
    """Return the poses from one to another, s from 0 to 1: p = p_0 + s (p_f − p_0), and R by spherical interpolation.

    Returns:
        A pydrake PiecewisePose.

    Raises:
        ModelError: a matrix that is no pose.
    """
    from pydrake.math import RigidTransform, RotationMatrix
    from pydrake.trajectories import PiecewisePose

    ends = []
    for X, name in ((X_0, "X_0"), (X_f, "X_f")):
        pose: Any = read_pose(X, name)
        ends.append(RigidTransform(RotationMatrix.ProjectToRotationMatrix(pose[:3, :3]), pose[:3, 3]))
    return PiecewisePose.MakeLinear([0.0, 1.0], ends)


def straight_line(
    arm: Arm,
    frame: str,
    q_0: Any,
    X_f: np.ndarray,
    *,
    solver: Solver | None = None,
    rows: Sequence[int] = ALL_ROWS,
    samples: int = 101,
    tolerance: float = 1e-4,
) -> StraightLine:
    """Return the joint path that moves the tool on a straight line from where q_0 has it to a pose.

    The joint values are solved for at evenly spaced poses, each from those before, and joined by a cubic spline; its
    error is measured at the poses and half-way between them.

    Args:
        frame: the document frame that marks the tool.
        q_0: (n,), base to tool (rad, m).
        X_f: (4, 4), the pose at the end, in frame 0.
        solver: from a pose and joint values nearby to the joint values, closed-form or not; differential_solver if not
            given. Revolute joints may be a turn off: the value nearest to the one before counts.
        rows: the rows of [v; ω], from 1, that the arm is to follow, all if not given: (1, 2) for a planar 2R.
        samples: how many poses, at least 4.
        tolerance: the largest error of the path (m, rad).

    Raises:
        ModelError: a frame, configuration, pose or row that is none; ends that are the same; a pose on the line that
            cannot be reached; joint limits passed; or a path that leaves the line, as it does where the joints have to
            jump. It says where on the line.
    """
    first, chosen = read_configuration(arm, q_0), read_rows(rows)
    if not isinstance(samples, Integral) or not 4 <= samples <= 100_000:
        raise ModelError(Fault.LINE_SAMPLES, samples=samples)
    solve = solver or differential_solver(arm, frame, rows)
    X_0 = NumericKinematics(arm, first[np.newaxis]).pose(arm.frame_names(frame)[0])[0]
    poses = pose_line(X_0, X_f)
    if np.linalg.norm(pose_error(poses.GetPose(1.0).GetAsMatrix4(), X_0)[chosen]) < 1e-9:
        raise ModelError(Fault.LINE_OF_NO_LENGTH)
    line = _Line(arm, frame, chosen, poses)
    s = np.linspace(0.0, 1.0, samples)
    q = line.solve(solve, s, first)
    fitted = line.fit(s, q, tolerance)
    line.require_within_limits(s, q)
    return fitted


class _Line:
    """The line being solved: what the steps of it share."""

    def __init__(self, arm: Arm, frame: str, rows: list[int], poses: Any) -> None:
        self.arm, self.frame, self.rows, self.poses = arm, frame, rows, poses
        self._revolute = np.array([joint.kind == "revolute" for joint in arm.joints])

    def solve(self, solver: Solver, s: np.ndarray, first: np.ndarray) -> np.ndarray:
        """Return the joint values at each s, (K, n), each the nearest to the one before."""
        q = np.empty((len(s), len(first)))
        q[0] = first
        for k in range(1, len(s)):
            guess = q[k - 1] if k == 1 else 2 * q[k - 1] - q[k - 2]
            q[k] = self._nearest(self._solve_one(solver, s[k], guess, q[k - 1]), q[k - 1])
        return q

    def require_within_limits(self, s: np.ndarray, q: np.ndarray) -> None:
        outside = limit_notes(self.arm, q)
        if outside:
            at = next(s[k] for k in range(len(s)) if limit_notes(self.arm, q[k]))
            raise ModelError(Fault.LINE_BEYOND_LIMITS, note=outside[0], where=self._where(at))

    def fit(self, s: np.ndarray, q: np.ndarray, tolerance: float) -> StraightLine:
        """Join the joint values by a spline, and measure how far it is from the line."""
        from pydrake.trajectories import PiecewisePolynomial

        path = PiecewisePolynomial.CubicWithContinuousSecondDerivatives(s, q.T, False)
        between = np.sort(np.concatenate([s, (s[1:] + s[:-1]) / 2]))
        kinematics = NumericKinematics(self.arm, np.array([path.value(at)[:, 0] for at in between]))
        desired = np.array([self.poses.GetPose(at).GetAsMatrix4() for at in between])
        error = np.zeros((len(between), 6))
        error[:, self.rows] = pose_error(desired, kinematics.pose(self.frame))[:, self.rows]
        distance, angle = np.linalg.norm(error[:, :3], axis=1), np.linalg.norm(error[:, 3:], axis=1)
        least = np.linalg.svd(kinematics.jacobian(self.frame)[:, self.rows], compute_uv=False)[:, -1]
        off = np.maximum(distance, angle) > tolerance
        if off.any():
            first = int(np.argmax(off))
            off_by = {"distance": distance[first], "angle": angle[first], "least": least[first]}
            raise ModelError(Fault.LEAVES_LINE, **off_by, where=self._where(between[first]), count=len(s))
        lowest = int(np.argmin(least))
        return StraightLine(
            self.poses, path, float(distance.max()), float(angle.max()), float(least[lowest]), float(between[lowest])
        )

    def _solve_one(self, solver: Solver, s: float, guess: np.ndarray, before: np.ndarray) -> np.ndarray:
        X = self.poses.GetPose(s).GetAsMatrix4()
        try:
            q = np.asarray(solver(X, guess), dtype=float)
        except ModelError as error:
            J = NumericKinematics(self.arm, before[np.newaxis]).jacobian(self.frame)[0][self.rows]
            least = np.linalg.svd(J, compute_uv=False)[-1]
            raise ModelError(Fault.NO_SOLUTION_BECAUSE, where=self._where(s), reason=error, least=least) from None
        if q.shape != guess.shape:
            raise ModelError(Fault.SOLVER_SHAPE, shape=str(q.shape), expected=str(guess.shape))
        if not np.isfinite(q).all():
            raise ModelError(Fault.NO_SOLUTION, where=self._where(s))
        return q

    def _nearest(self, q: np.ndarray, before: np.ndarray) -> np.ndarray:
        turns = np.round((before - q) / (2 * np.pi))
        return q + 2 * np.pi * np.where(self._revolute, turns, 0.0)

    def _where(self, s: float) -> ModelError:
        x, y, z = self.poses.GetPose(s).translation()
        return ModelError(Fault.ON_LINE, s=s, x=x, y=y, z=z)
