"""The manipulability of an arm over the joints on which it depends most: a million configurations, and where it vanishes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.families import families_of
from armproof.course.figures.facts.highest import climb
from armproof.course.figures.facts.task import Task, joint_ranges, task_of
from armproof.models.arm import Arm
from armproof.verification.singularities.families import Family

SIDE = 1000  # a million configurations
_DRAWN = 600
_SCANNED = 73
_STEP = np.radians(5)
_SEED = 17
_DEPENDS = 1e-9


@dataclass(frozen=True, eq=False)
class JointMap:
    """The manipulability w = √det(J Jᵀ) of the task of an arm over one or two of its joints.

    Attributes:
        task: the frame and rows of J.
        joints: the places of the joints, from 0: one or two.
        base: (n,), the values of the other joints.
        axes: the values of each joint (rad, m), increasing.
        w: (len(axes[0]),), or (len(axes[1]), len(axes[0])).
        relevant: the places of all joints on which w depends.
    """

    task: Task
    joints: tuple[int, ...]
    base: np.ndarray
    axes: tuple[np.ndarray, ...]
    w: np.ndarray
    relevant: tuple[int, ...]

    def configurations(self, *values: np.ndarray) -> np.ndarray:
        """Return configurations (N, n) with the joints of the map at values (N,) each, the others at the base."""
        q = np.tile(self.base, (len(values[0]), 1))
        q[:, list(self.joints)] = np.column_stack(values)
        return q


@lru_cache(maxsize=16)
def joint_map(arm: Arm) -> JointMap:
    """Return the map of an arm: of a million configurations, or along the one joint on which w depends."""
    task = task_of(arm)
    relevant = relevant_joints(task)
    joints = _shown_joints(arm, task, relevant)
    axes = tuple(_axis(arm, k, SIDE) for k in joints)
    empty = JointMap(task, joints, _best_base(task, joints, relevant), axes, np.empty(0), relevant)
    values = [part.ravel() for part in np.meshgrid(*axes)]
    w = task.manipulability(empty.configurations(*values))
    return JointMap(task, joints, empty.base, axes, w.reshape([len(axis) for axis in axes[::-1]]), relevant)


def relevant_joints(task: Task) -> tuple[int, ...]:
    """Return the places of the joints on which w depends, from 0, the one that changes it most first."""
    arm, rng = task.arm, np.random.default_rng(_SEED)
    q = np.column_stack([rng.uniform(*_range(arm, k), _DRAWN) for k in range(len(arm.joints))])
    w = task.manipulability(q)
    changes = []
    for k in range(len(arm.joints)):
        moved = q.copy()
        moved[:, k] = rng.uniform(*_range(arm, k), _DRAWN)
        changes.append(float(np.abs(task.manipulability(moved) - w).mean()))
    order = sorted(range(len(changes)), key=lambda k: -round(changes[k] / max(float(w.max()), 1e-300), 6))
    return tuple(k for k in order if changes[k] > _DEPENDS * max(float(w.max()), 1e-300))


def _shown_joints(arm: Arm, task: Task, relevant: tuple[int, ...]) -> tuple[int, ...]:
    """Return the joints of the map, base to tool: two that one singular family relates, or else those that change w most."""
    for family in families_of(arm):
        related = sorted(family.sampler.derivatives(family.factors[0].polynomial))
        if family.codimension == 1 and len(related) == 2 and set(related) <= set(relevant):
            return tuple(related)
    return tuple(sorted(relevant[:2])) or (0,)


def _best_base(task: Task, joints: tuple[int, ...], relevant: tuple[int, ...]) -> np.ndarray:
    """Return values for the joints that the map does not show: those at which w is highest in the mean, one after the other."""
    arm, rng = task.arm, np.random.default_rng(_SEED)
    base = np.array([min(max(0.0, _range(arm, k)[0]), _range(arm, k)[1]) for k in range(len(arm.joints))])
    for k in (k for k in relevant if k not in joints):
        values = _axis(arm, k, _SCANNED)
        if arm.joints[k].kind == "revolute":
            values = np.clip(_STEP * np.unique(np.round(values / _STEP)), *_range(arm, k))
        q = np.tile(base, (64 * len(values), 1))
        for shown in joints:
            q[:, shown] = np.tile(rng.uniform(*_range(arm, shown), 64), len(values))
        q[:, k] = np.repeat(values, 64)
        means = task.manipulability(q).reshape(len(values), 64).mean(axis=1)
        good = np.flatnonzero(means >= (1 - 1e-9) * means.max())
        base[k] = values[good[int(np.argmin(np.abs(values[good])))]]
    return base


def _range(arm: Arm, k: int) -> tuple[float, float]:
    return joint_ranges(arm)[k]


def _axis(arm: Arm, k: int, count: int) -> np.ndarray:
    return np.linspace(*_range(arm, k), count)


def shown_families(found: JointMap) -> list[Family]:
    """Return the families with one condition, in which no other joint than those of the map occurs."""

    def is_shown(family: Family) -> bool:
        occurring = family.sampler.derivatives(family.factors[0].polynomial)
        return family.codimension == 1 and set(occurring) <= set(found.joints)

    return list(filter(is_shown, families_of(found.task.arm)))


def family_lines(found: JointMap, family: Family) -> list[np.ndarray]:
    """Return the lines of a family on the map, (M, 2) each, rad and m: where its polynomial is zero, by Newton's method from a grid."""
    import contourpy

    x, y = (axis[:: SIDE // 200] for axis in found.axes)
    polynomial = family.factors[0].polynomial
    q = found.configurations(*(part.ravel() for part in np.meshgrid(x, y)))
    values = family.sampler.values([polynomial], q).reshape(len(y), len(x))
    lines = contourpy.contour_generator(x, y, values).lines(0.0)
    return [_polished(found, family, np.asarray(line)) for line in lines]


def _polished(found: JointMap, family: Family, line: np.ndarray) -> np.ndarray:
    """Return points near the zeros of a polynomial moved onto them, along its gradient."""
    polynomial = family.factors[0].polynomial
    for _ in range(4):
        q = found.configurations(*line.T)
        value = family.sampler.values([polynomial], q)[:, 0]
        gradient = family.sampler.gradients([polynomial], q)[:, 0][:, list(found.joints)]
        line = line - (value / np.maximum(np.sum(gradient**2, axis=1), 1e-300))[:, None] * gradient
    return line


def highest_near(found: JointMap, place: tuple[int, ...]) -> tuple[np.ndarray, float]:
    """Return the configuration (n,) near a place on the map, its indices joint by joint, at which w is highest, and w there."""
    at = found.configurations(*(axis[[k]] for axis, k in zip(found.axes, place, strict=True)))[0]
    return climb(found.task.manipulability, at, found.joints, found.axes)


def family_zeros(found: JointMap, family: Family) -> np.ndarray:
    """Return the values of the one joint of a map at which a family's condition holds, within the limits (rad, m)."""
    polynomial = family.factors[0].polynomial
    values = family.sampler.values([polynomial], found.configurations(found.axes[0]))[:, 0]
    before = np.flatnonzero(values[:-1] * values[1:] <= 0)
    zero = found.axes[0][before, None]
    for _ in range(8):
        q = found.configurations(zero[:, 0])
        value = family.sampler.values([polynomial], q)
        gradient = family.sampler.gradients([polynomial], q)[:, 0][:, list(found.joints)]
        zero = zero - value / gradient
    return np.unique(np.round(zero[:, 0], 12))
