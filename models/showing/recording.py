"""A motion of an arm as one page with Drake's Meshcat viewer, which needs no server and no network."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.motion.samples import interval, sample_motion
from armproof.models.showing.stage import RATE, Stage


def record_page(arm: Arm, trajectory: Any) -> str:
    """Return a page (HTML) in which the arm goes along a trajectory, with a triad at each document frame.

    A Meshcat server is started for it on this machine only, and ended.

    Args:
        trajectory: a pydrake Trajectory with values of the shape (n, 1), base to tool.

    Raises:
        ModelError: the arm was given by a DH table and has no shape, or the trajectory is no motion of it.
    """
    start, end = interval(trajectory, len(arm.joints))
    times = np.linspace(start, end, max(round((end - start) * RATE), 1) + 1)
    stage = Stage(arm)
    stage.visualizer.StartRecording(set_transforms_while_recording=False)
    seen = [stage.move(q, time) for time, q in zip(times - start, sample_motion(trajectory, times).q, strict=True)]
    stage.visualizer.StopRecording()
    stage.visualizer.PublishRecording()
    stage.look_at(np.vstack(seen))
    return str(stage.meshcat.StaticHtml())
