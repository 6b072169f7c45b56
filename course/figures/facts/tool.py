"""The tool of an arm: its frame and where it is."""

from __future__ import annotations

import numpy as np

from armproof.models.arm import Arm


def tool_frame(arm: Arm) -> str:
    """Return the frame of the tool: of the frames that the last joint carries, the one at the end of the chain."""
    moved = [frame for frame in arm.frames if arm.trace.depth(frame) == len(arm.joints)]
    if not moved:
        return arm.frames[-1]
    end = arm.frame(moved[-1]).index()
    return next(name for name in moved if arm.frame(name).index() == end)


def tool_points(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return the origin of the tool's frame in frame 0 at configurations (N, n), on the double plant, (N, 3), metres."""
    return np.asarray(arm.numeric(q).pose(tool_frame(arm))[:, :3, 3])
