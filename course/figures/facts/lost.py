"""What an arm cannot do at a singular configuration: the direction that is lost, at the point where it is plainest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.plant import NumericKinematics

_ZERO = 1e-7
_NEAR = 1e-5  # of the way to a regular configuration


@dataclass(frozen=True, eq=False)
class LostDirection:
    """A direction in which the tool cannot move.

    Attributes:
        kind: velocity: the point of the last link has no velocity along it; rotation: the last link has no angular velocity
            about it while the point stays where it is.
        frame: the frame at whose origin the point is; None if it is at no frame.
        point: the point (3,) in frame 0 (m).
        direction: a unit vector (3,).
    """

    kind: Literal["velocity", "rotation"]
    frame: str | None
    point: np.ndarray
    direction: np.ndarray


def lost_direction(
    arm: Arm, tool: str, rows: tuple[int, ...], q: np.ndarray, regular: np.ndarray, rank: int
) -> LostDirection:
    """Return what is lost at a singular configuration.

    A wrench w = (f, m) with wᵀJ = 0 does no work on any motion. About the point of the last link that most joints leave at
    rest, as the centre of a wrist, either m is zero and the velocity along f is lost, or f is beside it and a rotation is.

    Args:
        tool, rows: the frame of J and its rows of [v; ω], from 1.
        q, regular: the singular configuration and a regular one, (n,).
        rank: the rank of J at the singular configuration, from the exact analysis.
    """
    f, m = _wrench(arm, tool, rows, q, regular, rank)
    at = NumericKinematics(arm, q[None]).pose(tool)[0, :3, 3]
    frame = tool if max(rows) <= 3 else quiet_frame(arm, tool, q)
    point = NumericKinematics(arm, q[None]).pose(frame)[0, :3, 3]
    if min(rows) > 3:
        return LostDirection("rotation", frame, point, _unit(m))
    moment = m - np.cross(point - at, f)
    reach = max(float(np.linalg.norm(point)), 0.1)
    if np.linalg.norm(moment) <= _ZERO * reach * np.linalg.norm(f):
        return LostDirection("velocity", frame, point, _unit(f))
    if abs(f @ moment) <= _ZERO * np.linalg.norm(f) * np.linalg.norm(moment) and np.linalg.norm(f) > _ZERO:
        return LostDirection("velocity", None, point + np.cross(f, moment) / (f @ f), _unit(f))
    return LostDirection("rotation", frame, point, _unit(moment))


def reachable_rates(arm: Arm, tool: str, rows: tuple[int, ...], lost: LostDirection, q: np.ndarray) -> np.ndarray:
    """Return B (3, k) such that B u, with u of norm 1, are the velocities, or rotations, that the joints give at the point.

    Velocities of the point for joint rates of norm 1; angular velocities for those of them that leave the point at rest.
    """
    numeric = NumericKinematics(arm, q[None])
    point = numeric.pose(lost.frame)[0, :3, 3] if lost.frame is not None else lost.point
    J_v, J_w = velocity_and_rotation(arm, tool, point, q)
    if lost.kind == "velocity" or min(rows) > 3:
        return J_v if lost.kind == "velocity" else J_w
    _, singular_values, Vt = np.linalg.svd(J_v)
    rank = int(np.sum(singular_values > _ZERO * max(float(singular_values.max(initial=0.0)), 1e-300)))
    return np.asarray(J_w @ Vt[rank:].T)


def velocity_and_rotation(arm: Arm, tool: str, point: np.ndarray, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the Jacobian of the velocity of a point (3,) of the last link, and that of its angular velocity, (3, n) each."""
    numeric = NumericKinematics(arm, q[None])
    J = numeric.jacobian(tool)[0]
    arm_to_point = point - numeric.pose(tool)[0, :3, 3]
    return J[:3] + np.cross(J[3:].T, arm_to_point).T, J[3:]


def quiet_frame(arm: Arm, tool: str, q: np.ndarray) -> str:
    """Return the frame at whose origin a point of the last link is left at rest by most joints; of several, the last."""
    numeric = NumericKinematics(arm, q[None])
    best, most = tool, -1
    for frame in (*arm.frames, tool):
        J_v, _ = velocity_and_rotation(arm, tool, numeric.pose(frame)[0, :3, 3], q)
        at_rest = int(np.sum(np.linalg.norm(J_v, axis=0) < _ZERO))
        if at_rest >= most and trace_of(arm).depth(frame) > 0:
            best, most = frame, at_rest
    return best


def _wrench(
    arm: Arm, tool: str, rows: tuple[int, ...], q: np.ndarray, regular: np.ndarray, rank: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the force and the moment about the tool's origin that do no work at q, but do at regular configurations."""
    picked = [row - 1 for row in rows]
    J = NumericKinematics(arm, q[None]).jacobian(tool)[0][picked]
    if J.shape[0] > min(J.shape[1], rank + 1):  # some wrench does no work anywhere: take the one that does nearby
        J = NumericKinematics(arm, (q + _NEAR * (regular - q))[None]).jacobian(tool)[0][picked]
    U, _, _ = np.linalg.svd(J)
    w = np.zeros(6)
    w[picked] = U[:, rank]
    w[np.abs(w) < 1e-12] = 0.0
    return w[:3], w[3:]


def _unit(vector: np.ndarray) -> np.ndarray:
    vector = vector / np.linalg.norm(vector)
    vector[np.abs(vector) < 1e-12] = 0.0
    leading = next(part for part in vector[[2, 1, 0]] if part)
    return np.asarray(vector if leading > 0 else -vector)
