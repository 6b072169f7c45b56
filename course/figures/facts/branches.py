"""Which posture an arm with a spherical wrist is in: its shoulder in front or behind, its elbow up or down, its wrist turned or not."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from armproof.course.figures.facts.dh_rows import chain_frames
from armproof.course.figures.facts.positioning import positioning_of
from armproof.models.arm import Arm
from armproof.models.showing.skeleton import place_skeleton


def corners_of(arm: Arm, q: np.ndarray) -> Mapping[str, np.ndarray]:
    """Return shoulder, elbow and wrist (3,) of a configuration; nothing where the last three axes do not meet."""
    positioning = positioning_of(arm)
    if positioning is None or not positioning.wrist:
        return {}
    pose = place_skeleton(arm, q)
    shoulder, elbow = (np.array(pose.joints[k].start) for k in (1, 2))
    return {"shoulder": shoulder, "elbow": elbow, "wrist": pose.frames[positioning.frame][:3, 3]}


def branch_of(arm: Arm, q: np.ndarray) -> tuple[str, ...]:
    """Return the keys of the words for the posture of a configuration; none without a spherical wrist.

    In front is where x_1 points, which turns with joint 1; the elbow is up where it lies above the way from shoulder to wrist.
    """
    corners = corners_of(arm, q)
    if not corners:
        return ()
    pose = place_skeleton(arm, q)
    shoulder, elbow, wrist = corners.values()
    ahead = float((wrist - np.array(pose.joints[0].start)) @ pose.frames[chain_frames(arm)[1]][:3, 0])
    way = (wrist - shoulder) / np.linalg.norm(wrist - shoulder)
    off = (elbow - shoulder) - ((elbow - shoulder) @ way) * way
    bent = float(q[-2])
    return ("in_front" if ahead > 0 else "behind", "elbow_up" if off[2] > 0 else "elbow_down", "wrist_plus" if bent > 0 else "wrist_minus")  # fmt: skip
