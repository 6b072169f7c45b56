"""An arm as lines between its joints, for maps and animations where symbols would be in the way."""

from __future__ import annotations

import numpy as np

from armproof.course.figures.drawing.routes import simplify
from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import INK, PAPER
from armproof.models.arm import Arm
from armproof.models.numeric.skeleton import place_skeleton


def stick_points(arm: Arm, q: np.ndarray, frame: str) -> np.ndarray:
    """Return the origin of the arm, where its joints are, and the origin of a frame, in frame 0, (K, 3)."""
    skeleton = place_skeleton(arm, q)
    reached = arm.trace.depth(frame)
    ends = [end for joint in skeleton.joints[:reached] for end in (joint.start, joint.end)]
    return simplify(np.vstack([skeleton.frames[arm.frames[0]][:3, 3], *ends, skeleton.frames[frame][:3, 3]]))


def draw_stick(scene: Scene, arm: Arm, q: np.ndarray, frame: str, zorder: float = 8) -> None:
    """Draw an arm up to the origin of a frame as lines with a dot at each joint; gid "stick"."""
    points = stick_points(arm, q, frame)
    scene.line(points, gid="stick", zorder=zorder, color=INK, linewidth=1.6, marker="o", markersize=3, markerfacecolor=PAPER, markeredgewidth=0.8)  # fmt: skip
    tool = points[-1:]
    scene.line(tool, zorder=zorder + 0.1, color=INK, marker="o", markersize=3, linestyle="none")
