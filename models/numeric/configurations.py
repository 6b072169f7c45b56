"""Configurations: six families at which a formula that is wrong betrays itself, and one without any special angle."""

from __future__ import annotations

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.plant import NumericKinematics

FAMILIES = ("generic", "zero", "tiny", "quarter turns", "wide", "near-singular")
_TINY = 1e-7
_NEAR = 1e-6
_WIDE = 50.0  # rad
_WIDE_SLIDE = 5.0  # m
_CANDIDATES = 4
_PARTS = (0.37, 0.61, 0.23, 0.53, 0.41, 0.31, 0.59)  # of the range of each joint


def sample(
    arm: Arm, count: int = 1000, rng: np.random.Generator | None = None, *, near_singular: bool = True
) -> tuple[np.ndarray, np.ndarray]:
    """Draw configurations of the six families in equal shares.

    generic: within the joint limits. zero: all joints at 0. tiny: within ±1e-7. quarter turns: within 1e-6 of multiples
    of π/2 (prismatic joints as in generic). wide: within ±50 rad and ±5 m. near-singular: of several times as many
    candidates, those with the smallest ratio of extreme singular values of the Jacobian of the last frame, or of its rows of v.

    Args:
        count: how many, in all; the first families get the remainder.
        rng: the random generator; without one, a new generator of seed 0.
        near_singular: whether the last family is drawn too, which takes longer than all the others; its share is left out.

    Returns:
        q, a (count, n) array (rad, m), base to tool; and the family of each row, a (count,) array of indices in FAMILIES.
    """
    rng = np.random.default_rng(0) if rng is None else rng
    shares = [len(part) for part in np.array_split(np.arange(count), len(FAMILIES))]
    draw = (_generic, _zero, _tiny, _quarter_turns, _wide, *([_near_singular] if near_singular else []))
    q = np.concatenate([family(arm, share, rng) for family, share in zip(draw, shares, strict=False)])
    return q, np.repeat(np.arange(len(draw)), shares[: len(draw)])


def _generic(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    lower, upper = np.array([joint_range(j.lower, j.upper, j.kind, slide=1.0) for j in arm.joints]).T
    return rng.uniform(lower, upper, (count, len(arm.joints)))


def _zero(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    return np.zeros((count, len(arm.joints)))


def _tiny(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    return rng.uniform(-_TINY, _TINY, (count, len(arm.joints)))


def _quarter_turns(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    q = _generic(arm, count, rng)
    near = np.pi / 2 * rng.integers(-4, 5, q.shape) + rng.uniform(-_NEAR, _NEAR, q.shape)
    return np.where(_revolute(arm), near, q)


def _wide(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    q = rng.uniform(-1.0, 1.0, (count, len(arm.joints)))
    return q * np.where(_revolute(arm), _WIDE, _WIDE_SLIDE)


def _near_singular(arm: Arm, count: int, rng: np.random.Generator) -> np.ndarray:
    """Snap some joints of generic candidates to quarter turns and keep the candidates nearest to a singularity."""
    if not count:
        return np.empty((0, len(arm.joints)))
    q = _generic(arm, _CANDIDATES * count, rng)
    near = np.pi / 2 * rng.integers(-2, 3, q.shape) + rng.uniform(-1e-3, 1e-3, q.shape)
    q = np.where(_revolute(arm) & (rng.random(q.shape) < 0.5), near, q)
    last = max(arm.frames, key=lambda name: (name.isdigit(), int(name) if name.isdigit() else 0))
    J = NumericKinematics(arm, q).jacobian(last)
    nearness = np.minimum(_conditioning(J), _conditioning(J[:, :3]))
    return q[np.sort(np.argsort(nearness, kind="stable")[:count])]


def _conditioning(J: np.ndarray) -> np.ndarray:
    """Return the ratio of the smallest singular value, of those that are not always zero, to the largest."""
    singular_values = np.linalg.svd(J, compute_uv=False)
    largest = np.maximum(singular_values[:, 0], 1e-300)
    rank = max(int(np.sum(singular_values > 1e-9 * largest[:, None], axis=1).max()), 1)
    return np.asarray(singular_values[:, rank - 1] / largest)


def _revolute(arm: Arm) -> np.ndarray:
    return np.array([joint.kind == "revolute" for joint in arm.joints])


def generic_configuration(arm: Arm) -> np.ndarray:
    """Return a configuration without any special angle, within the limits of the joints, (n,)."""
    ranges = [joint_range(joint.lower, joint.upper, joint.kind) for joint in arm.joints]
    parts = [_PARTS[k % len(_PARTS)] for k in range(len(ranges))]
    return np.array([low + part * (high - low) for part, (low, high) in zip(parts, ranges, strict=True)])


def joint_range(lower: float, upper: float, kind: str, slide: float = 0.5) -> tuple[float, float]:
    """Return the limits of a joint, with half a turn, or a length (m), to each side where there is none."""
    most = np.pi if kind == "revolute" else slide
    return (lower if np.isfinite(lower) else -most, upper if np.isfinite(upper) else most)
