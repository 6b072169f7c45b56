"""How far one pose is from another: the distance of the origins and the angle between the axes; and the way back."""

from __future__ import annotations

import numpy as np

from armproof.models.errors import Fault, ModelError

_RIGID = 1e-6


def pose_error(X_desired: np.ndarray, X: np.ndarray) -> np.ndarray:
    """Return the twist [Δp; φ] that takes poses to the desired ones in unit time, in the axes of their reference.

    Δp = p_d − p, and φ is the axis times the angle in [0, π] of R_d Rᵀ. It vanishes exactly where the poses agree, and to
    first order it is J Δq with the geometric Jacobian, rows [v; ω].

    Args:
        X_desired, X: (4, 4) or (N, 4, 4) poses in one reference frame.

    Returns:
        (6,) or (N, 6), m and rad.
    """
    R = X_desired[..., :3, :3] @ np.swapaxes(X[..., :3, :3], -1, -2)
    step = X_desired[..., :3, 3] - X[..., :3, 3]
    return np.concatenate([step, _rotation_vector(R)], axis=-1)


def rotations(vectors: np.ndarray) -> np.ndarray:
    """Return the rotations about vectors (…, 3) by their lengths, (…, 3, 3), by the formula of Rodrigues."""
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    x, y, z = np.moveaxis(vectors, -1, 0)
    zero = np.zeros_like(x)
    skew = np.stack([np.stack(row, axis=-1) for row in ((zero, -z, y), (z, zero, -x), (-y, x, zero))], axis=-2)
    sine = np.sinc(angle / np.pi)
    versine = 0.5 * np.sinc(angle / (2 * np.pi)) ** 2
    return np.asarray(np.eye(3) + sine * skew + versine * (skew @ skew))


def read_pose(X: object, name: str) -> np.ndarray:
    """Return a pose as a (4, 4) array.

    Raises:
        ModelError: another shape, a number that is not finite, or no rigid transform.
    """
    try:
        pose = np.array(X, dtype=float)
    except (TypeError, ValueError):
        raise ModelError(Fault.NO_ARRAY, name=name, value=f"{X!r:.60}") from None
    if pose.shape != (4, 4) or not np.isfinite(pose).all():
        raise ModelError(Fault.POSE_SHAPE, name=name, shape=str(pose.shape))
    R = pose[:3, :3]
    rigid = np.allclose(R @ R.T, np.eye(3), atol=_RIGID) and np.linalg.det(R) > 0
    if not rigid or not np.allclose(pose[3], [0, 0, 0, 1], atol=_RIGID):
        raise ModelError(Fault.POSE_FORM, name=name)
    return pose


def _rotation_vector(R: np.ndarray) -> np.ndarray:
    """Return the axis times the angle of rotations, by their unit quaternions, which stay accurate near 0 and near π."""
    quaternion = _quaternion(R)
    vector, scalar = quaternion[..., 1:], quaternion[..., :1]
    length = np.linalg.norm(vector, axis=-1, keepdims=True)
    angle = 2 * np.arctan2(length, np.abs(scalar))
    small = length < 1e-12
    factor = np.where(small, 2.0, angle / np.where(small, 1.0, length)) * np.where(scalar < 0, -1, 1)
    return np.asarray(factor * vector)


def _quaternion(R: np.ndarray) -> np.ndarray:
    """Return (w, x, y, z) of rotations: of the four rows of q qᵀ, scaled, the one with the largest diagonal."""
    xx, yy, zz = (R[..., i, i] for i in range(3))
    wx, wy, wz = R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]
    xy, xz, yz = R[..., 0, 1] + R[..., 1, 0], R[..., 0, 2] + R[..., 2, 0], R[..., 1, 2] + R[..., 2, 1]
    rows = np.stack(
        [
            np.stack([1 + xx + yy + zz, wx, wy, wz], axis=-1),
            np.stack([wx, 1 + xx - yy - zz, xy, xz], axis=-1),
            np.stack([wy, xy, 1 - xx + yy - zz, yz], axis=-1),
            np.stack([wz, xz, yz, 1 - xx - yy + zz], axis=-1),
        ],
        axis=-2,
    )
    largest = np.argmax(np.diagonal(rows, axis1=-2, axis2=-1), axis=-1)
    row = np.take_along_axis(rows, largest[..., np.newaxis, np.newaxis], axis=-2)[..., 0, :]
    return np.asarray(row / np.linalg.norm(row, axis=-1, keepdims=True))
