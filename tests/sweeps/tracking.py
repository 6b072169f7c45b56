"""Track three motions on every arm and print the errors: `python -m tests.sweeps.tracking`.

A quintic over 30 % of each joint's range at 80 % of what its drives can; the same with 30 % too much mass in the controller's
model, which has to miss; and the fastest motion through three configurations, at the limits of the model file.
Exit code 1 if a quintic is missed by more than a milliradian or a millimetre, or a wrong model is not.
"""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.computed_torque import InverseDynamics
from armproof.models.motion.joint_space import joint_path, point_to_point
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.samples import sample_motion
from armproof.models.motion.time_optimal import time_optimal
from armproof.models.motion.tracking import TrackingLog, track
from tests.models.motion.test_tracking import joint_error

TARGET = 1e-3  # rad and m
SHARE = 0.8  # of the efforts: the rest is for the controller
HEAVIER = 1.3


def main() -> int:
    """Print a line a motion; return 0 if all passed."""
    passed = True
    for name in arm_names():
        arm = load_arm(name)
        points = _points(arm)
        quintic = slow_quintic(arm, points[0], points[2])
        right = report(name, "quintic", arm, quintic)
        wrong = report(name, f"mass x {HEAVIER:g}", arm, quintic, mass_factor=HEAVIER)
        report(name, "fastest", arm, time_optimal(arm, joint_path(arm, points)).trajectory)
        passed &= error(right) < TARGET and error(wrong) > 10 * error(right)
    print("passed" if passed else "FAILED")
    return 0 if passed else 1


def slow_quintic(arm: Arm, q_0: np.ndarray, q_f: np.ndarray) -> Any:
    """Return the fastest quintic within the velocity limits and a share of the efforts, to a twentieth of its duration."""
    effort, dynamics = SHARE * read_rate_limits(arm).effort, InverseDynamics(arm)
    duration = point_to_point(arm, q_0, q_f).end_time()
    for _ in range(200):
        trajectory = point_to_point(arm, q_0, q_f, duration)
        motion = sample_motion(trajectory, np.linspace(0, duration, 101))
        needed = np.array([dynamics.torques(*row) for row in zip(motion.q, motion.v, motion.w, strict=True)])
        if (np.abs(needed) <= effort).all():
            return trajectory
        duration *= 1.05
    raise ModelError(f"arm '{arm.name}' cannot hold itself with {SHARE:.0%} of its efforts")


def report(name: str, what: str, arm: Arm, trajectory: Any, **options: Any) -> TrackingLog:
    """Track a motion and print the largest errors."""
    started = time.perf_counter()
    log = track(arm, trajectory, **options)
    duration, seconds = log.times[-1] - log.times[0], time.perf_counter() - started
    print(
        f"{name:16} {what:10} {duration:5.2f} s  joint {joint_error(log):.1e} (rad, m)  "
        f"tool {log.position_error.max():.1e} m {log.rotation_error.max():.1e} rad  "
        f"drives at their limit {log.saturated.mean():4.0%}  ({seconds:.1f} s)",
        flush=True,
    )
    return log


def error(log: TrackingLog) -> float:
    """Return the largest error of a joint (rad, m) or of the tool (m, rad)."""
    return float(max(joint_error(log), log.position_error.max(), log.rotation_error.max()))


def _points(arm: Arm) -> np.ndarray:
    """Return three configurations, 30 % of each joint's range apart in all."""
    lower, upper = np.array([[joint.lower, joint.upper] for joint in arm.joints]).T
    parts = np.array([np.full(len(lower), 0.35), np.linspace(0.45, 0.55, len(lower)), np.full(len(lower), 0.65)])
    return lower + parts * (upper - lower)


if __name__ == "__main__":
    sys.exit(main())
