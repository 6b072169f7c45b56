"""A straight motion of the tool past or up to a singular configuration, and the joint rates that it asks for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.curves import into_limits
from armproof.course.figures.facts.families import families_of
from armproof.course.figures.facts.lines import correct, follow, line_poses
from armproof.course.figures.facts.task import Task, joint_ranges, task_of, within_limits
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.motion.inverse_velocity import damped_inverse, joint_rates
from armproof.models.motion.pose_error import pose_error
from armproof.verification.singularities.families import Family

SAMPLES = 241
DURATION = 2.0  # s
_SEED = 23
_DRAWN = 24
_BESIDE = 0.06  # rad, m: how far the motion stays off the singular configuration
_ALONE = 0.25  # rad, m: how far it is from the other families
_LENGTH = 0.3  # of half the width of the workspace, to each side
_TURN = 0.7  # rad, to each side
_STEPS = 16
_FOLLOWED = 1e-7
_SHARP = 3.0  # times the median rate that the highest one has to be
_DAMPING = 1.5  # times the least singular value
_GAIN = 5.0  # 1/s, of the feedback of the tool's error


@dataclass(frozen=True, eq=False)
class NearSingular:
    """A motion of the tool at constant velocity near a singular configuration.

    Attributes:
        task, family: what the tool does, and the singular family that it nears.
        passes: whether it goes on beyond the nearest configuration; otherwise it ends there.
        nearest: the place of the nearest configuration in the times.
        twist: (6,), the constant twist of the tool in frame 0, rows [v; ω] (m/s, rad/s).
        times: (S,), s.
        poses: (S, 4, 4), where the tool is to be.
        q: (S, n), joint values that have it there exactly.
        rates: (S, n), J⁺ v along q.
        damping: λ of the damped least squares.
        q_damped: (S, n), where the joints go with the damped inverse and feedback of the error.
        rates_damped: (S, n), Jᵀ (J Jᵀ + λ² I)⁻¹ (v + K e) along q_damped.
        error: (S, m), what the tool is off there, in the rows of the task (m, rad).
        least: the least singular value of J along q.
    """

    task: Task
    family: Family
    passes: bool
    nearest: int
    twist: np.ndarray
    times: np.ndarray
    poses: np.ndarray
    q: np.ndarray
    rates: np.ndarray
    damping: float
    q_damped: np.ndarray
    rates_damped: np.ndarray
    error: np.ndarray
    least: float


@dataclass(frozen=True, eq=False)
class _Candidates:
    """Configurations beside singular ones (K, n), twists of length 1 (K, 6), and the family of each."""

    q: np.ndarray
    twists: np.ndarray
    families: np.ndarray


@lru_cache(maxsize=16)
def near_singular(arm: Arm) -> NearSingular | None:
    """Return the motion past a singular configuration that asks for the highest joint rates; up to one, if none goes past.

    None where the arm has no singular configuration within its joint limits that a straight motion nears.
    """
    task = task_of(arm)
    families = list(families_of(arm))
    found = _candidates(task, families)
    for passes in (True, False):
        best = _best(task, found, passes) if len(found.q) else None
        if best is not None:
            return _motion(task, families[found.families[best]], found.q[best], found.twists[best], passes)
    return None


def _candidates(task: Task, families: list[Family]) -> _Candidates:
    rng = np.random.default_rng(_SEED)
    q: list[np.ndarray] = []
    owners: list[int] = []
    for k, family in enumerate(families):
        on_it = into_limits(task.arm, family.sample(rng, _DRAWN))
        clear = within_limits(task.arm, on_it).all(axis=1)
        for other in families[:k] + families[k + 1 :]:
            clear &= other.distance(on_it) > _ALONE
        on_it = on_it[clear]
        gradient = family.sampler.gradients([family.factors[0].polynomial], on_it)[:, 0]
        away = gradient / np.maximum(np.linalg.norm(gradient, axis=1, keepdims=True), 1e-12)
        for side in (1, -1):
            q.append(on_it + side * _BESIDE * away)
            owners += [k] * len(on_it)
    beside = np.vstack(q) if q else np.empty((0, len(task.arm.joints)))
    return _with_twists(task, beside, np.array(owners, dtype=int))


def _with_twists(task: Task, q: np.ndarray, families: np.ndarray) -> _Candidates:
    """Return each configuration with the translation and the turn that it is losing, in both senses."""
    if not len(q):
        return _Candidates(q, np.empty((0, 6)), families)
    lost = np.zeros((len(q), 6))
    lost[:, task.places] = np.linalg.svd(task.jacobian(q))[0][:, :, -1]
    parts: list[tuple[np.ndarray, np.ndarray]] = []
    for columns in (slice(0, 3), slice(3, 6)):
        size = np.linalg.norm(lost[:, columns], axis=1)
        large = np.flatnonzero(size > 0.3)
        twists = np.zeros((len(large), 6))
        twists[:, columns] = lost[large, columns] / size[large, None]
        parts += [(large, twists), (large, -twists)]
    chosen = np.concatenate([places for places, _ in parts])
    return _Candidates(q[chosen], np.vstack([twists for _, twists in parts]), families[chosen])


def _extents(task: Task, twists: np.ndarray) -> np.ndarray:
    """Return how far the motions go to each side (m, rad), (K,)."""
    rng = np.random.default_rng(_SEED)
    points = task.points(np.column_stack([rng.uniform(*limits, 200) for limits in joint_ranges(task.arm)]))
    reach = float(np.ptp(points, axis=0).max()) / 2
    return np.where(np.linalg.norm(twists[:, :3], axis=1) > 0.5, _LENGTH * reach, _TURN)


def _best(task: Task, found: _Candidates, passes: bool) -> int | None:
    """Return the candidate whose highest rate stands out most; translations before turns."""
    X = task.pose(found.q)
    twists = _extents(task, found.twists)[:, None] * found.twists
    good = np.ones(len(found.q), dtype=bool)
    rates = []
    ways = np.linspace(0.0, 1.0, _STEPS) ** 2  # small steps where the joints are fast
    for side in (-1.0, 1.0) if passes else (-1.0,):
        q, error = follow(task, found.q, line_poses(X, twists, side * ways))
        good &= (error.max(axis=0) < _FOLLOWED) & within_limits(task.arm, q).all(axis=(0, 2))
        rates.append(np.abs(np.diff(q, axis=0)).max(axis=2) / np.diff(ways)[:, None])
    largest = np.vstack(rates)
    sharpness = largest.max(axis=0) / np.maximum(np.median(largest, axis=0), 1e-9)
    translates = np.linalg.norm(found.twists[:, :3], axis=1) > 0.5
    good &= sharpness > _SHARP
    if not good.any():
        return None
    return int(np.argmax(np.where(good, np.minimum(sharpness, 12) + 100 * translates, -np.inf)))


def _motion(task: Task, family: Family, q_near: np.ndarray, direction: np.ndarray, passes: bool) -> NearSingular:
    extent = float(_extents(task, direction[None])[0])
    s = np.linspace(-1.0, 1.0 if passes else 0.0, SAMPLES)
    X = task.pose(q_near[None])
    poses = line_poses(X, extent * direction[None], s)[:, 0]
    q = _exact(task, q_near, X, extent * direction, s, poses)
    twist = extent * (s[-1] - s[0]) / DURATION * direction
    rows, J = task.places, task.jacobian(q)
    rates = joint_rates(J, np.tile(twist[rows], (SAMPLES, 1))).rates
    least = np.linalg.svd(J, compute_uv=False)[:, -1]
    damping = float(f"{_DAMPING * least.min():.1g}")
    times = np.linspace(0.0, DURATION, SAMPLES)
    damped = _damped(task, q[0], poses, twist[rows], damping, times[1])
    return NearSingular(
        task, family, passes, int(np.argmin(least)), twist, times, poses, q, rates, damping, *damped, float(least.min())
    )


def _exact(
    task: Task, q_near: np.ndarray, X: np.ndarray, twist: np.ndarray, s: np.ndarray, poses: np.ndarray
) -> np.ndarray:
    """Return joint values that have the tool at the poses: followed in coarse steps, then corrected at all poses at once."""
    coarse = np.linspace(0.0, 1.0, 2 * _STEPS) ** 2
    sides = np.array([-1.0, 1.0] if s[-1] > 0 else [-1.0])
    ends, starts = sides[:, None] * twist, np.tile(q_near, (len(sides), 1))
    followed, _ = follow(task, starts, line_poses(np.repeat(X, len(sides), axis=0), ends, coarse))
    at = (sides[:, None] * coarse).ravel()
    values = followed.transpose(1, 0, 2).reshape(len(at), -1)[np.argsort(at, kind="stable")]
    at = np.sort(at, kind="stable")
    guess = np.column_stack([np.interp(s, at, values[:, k]) for k in range(values.shape[1])])
    return correct(task, guess, poses, rounds=8)[0]


def _damped(
    task: Task, q_0: np.ndarray, poses: np.ndarray, twist: np.ndarray, damping: float, step: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return joint values, rates and errors with the damped inverse and feedback of the error, one step of time after the other."""
    rows = task.places
    q, rates = np.empty((len(poses), len(q_0))), np.empty((len(poses), len(q_0)))
    error = np.empty((len(poses), len(rows)))
    now = np.array(q_0)
    for k in range(len(poses)):
        X, J = bulk_of(task.arm).pose_and_jacobian(now[None], task.frame)
        q[k], error[k] = now, pose_error(poses[k], X[0])[rows]
        rates[k] = damped_inverse(J[0][rows], damping) @ (twist + _GAIN * error[k])
        now = now + step * rates[k]
    return q, rates, error
