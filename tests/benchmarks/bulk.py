"""Kinematics in bulk beside loops in Python over Drake and Pinocchio: pose and 6×n Jacobian of each configuration.

All fill arrays of poses and Jacobians from the same configurations on one core. The loops do no more than they must: one
context, bound methods, results copied into arrays made before the clock starts. All three are compared before they are timed.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import load_arm
from armproof.models.numeric.drake_arm import frame_of, plant_of

LOOPED = 2_000  # configurations of a loop
BULK = 100_000
MAP = 1_000_000
ROUNDS = 15
DRAKE_ROWS = [3, 4, 5, 0, 1, 2]  # where the rows of [v; ω] stand in Drake's [ω; v]
AGREEMENT = 1e-12

Loop = Callable[[], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class BulkTimes:
    """Seconds a configuration; `pinocchio` is None where it is not installed."""

    bulk: float
    drake: float
    pinocchio: float | None


def measure(name: str, frame: str) -> BulkTimes:
    """Time one arm, in turns; the least of several rounds counts."""
    arm = load_arm(name)
    q = np.random.default_rng(0).uniform(-3.0, 3.0, (BULK, len(arm.joints)))
    loops = {"drake": drake_loop(arm, frame, q[:LOOPED]), "pinocchio": pinocchio_loop(arm, frame, q[:LOOPED])}
    ran = {what: loop for what, loop in loops.items() if loop is not None}
    for what, loop in ran.items():
        X, J = loop()
        J = J[:, DRAKE_ROWS] if what == "drake" else J
        _compare(name, what, (X, J), bulk_of(arm).pose_and_jacobian(q[:LOOPED], frame))
    best = dict.fromkeys(("bulk", *ran), np.inf)
    for _ in range(ROUNDS):
        for what, loop in ran.items():
            best[what] = min(best[what], _seconds(loop) / LOOPED)
        best["bulk"] = min(best["bulk"], _seconds(lambda: bulk_of(arm).pose_and_jacobian(q, frame)) / BULK)
    return BulkTimes(best["bulk"], best["drake"], best.get("pinocchio"))


def time_map() -> float:
    """Return the seconds for the manipulability of a million configurations of the RX-90."""
    arm = load_arm("rx90")
    q = np.random.default_rng(0).uniform(-3.0, 3.0, (MAP, len(arm.joints)))
    return min(_seconds(lambda: bulk_of(arm).manipulability(q, "6")) for _ in range(3))


def drake_loop(arm: Arm, frame: str, q: np.ndarray) -> Loop:
    """Return the loop over Drake's plant of doubles; the rows of its Jacobians stay as Drake stacks them, [ω; v]."""
    from pydrake.multibody.tree import JacobianWrtVariable

    plant, context = plant_of(arm), plant_of(arm).CreateDefaultContext()
    tool, base = frame_of(arm, frame), frame_of(arm, arm.frames[0])
    set_positions, relative, jacobian = (
        plant.SetPositions,
        plant.CalcRelativeTransform,
        plant.CalcJacobianSpatialVelocity,
    )
    origin, wrt = np.zeros(3), JacobianWrtVariable.kV
    X, J = np.empty((len(q), 4, 4)), np.empty((len(q), 6, q.shape[1]))

    def run() -> tuple[np.ndarray, np.ndarray]:
        for k, configuration in enumerate(q):
            set_positions(context, configuration)
            X[k] = relative(context, base, tool).GetAsMatrix4()
            J[k] = jacobian(context, wrt, tool, origin, base, base)
        return X, J

    return run


def pinocchio_loop(arm: Arm, frame: str, q: np.ndarray) -> Loop | None:
    """Return the loop over Pinocchio's model of the same URDF; None where Pinocchio is not installed."""
    try:
        import pinocchio as pin
    except ImportError:
        return None
    model: Any = pin.buildModelFromUrdf(str(arm.path))
    data = model.createData()
    tool = model.getFrameId(frame_of(arm, frame).body().name(), pin.BODY)
    joints, placement, jacobian = pin.computeJointJacobians, pin.updateFramePlacement, pin.getFrameJacobian
    axes = pin.LOCAL_WORLD_ALIGNED
    X, J = np.empty((len(q), 4, 4)), np.empty((len(q), 6, q.shape[1]))

    def run() -> tuple[np.ndarray, np.ndarray]:
        for k, configuration in enumerate(q):
            joints(model, data, configuration)
            X[k] = placement(model, data, tool).homogeneous
            J[k] = jacobian(model, data, tool, axes)
        return X, J

    return run


def _compare(arm: str, what: str, loop: tuple[np.ndarray, np.ndarray], bulk: tuple[np.ndarray, np.ndarray]) -> None:
    worst = max(float(np.abs(one - other).max()) for one, other in zip(loop, bulk, strict=True))
    if worst > AGREEMENT:
        raise SystemExit(f"{arm}: {what} and the bulk differ by {worst:.1e}; nothing is timed before they agree")


def _seconds(run: Callable[[], object]) -> float:
    started = time.perf_counter()
    run()
    return time.perf_counter() - started
