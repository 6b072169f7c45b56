"""An arm in Drake's Meshcat viewer, moved from Python: a server of its own, on this machine only, without a display."""

from __future__ import annotations

import logging
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.offset import frames_of
from armproof.models.numeric.drake_arm import drake_of
from armproof.models.showing.viewer import add_arm

RATE = 32.0  # frames a second
_AZIMUTH, _ELEVATION = np.radians(-50.0), np.radians(20.0)  # from where the arm is seen
_DISTANCE = 2.5  # of the camera, in radii of what the arm's frames reach


class Stage:
    """An arm that is shown, with a triad at each document frame.

    Raises:
        ModelError: the arm was given by a DH table and has no shape, or no server can be started.

    Attributes:
        meshcat: the server; it ends with this object.
        visualizer: what publishes the arm there.
    """

    def __init__(self, arm: Arm) -> None:
        from pydrake.geometry import MeshcatVisualizer, MeshcatVisualizerParams
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
        from pydrake.systems.framework import DiagramBuilder

        builder = DiagramBuilder()
        self._plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.0)
        add_arm(Parser(self._plant, scene_graph), arm)
        self._plant.Finalize()
        self._places = list(drake_of(arm).position_indices)
        self.meshcat = _server(arm)
        parameters = MeshcatVisualizerParams(publish_period=1 / RATE)
        self.visualizer = MeshcatVisualizer.AddToBuilder(builder, scene_graph, self.meshcat, parameters)
        self._diagram = builder.Build()
        self._context = self._diagram.CreateDefaultContext()

    def move(self, q: np.ndarray, time: float = 0.0) -> np.ndarray:
        """Show the arm at a configuration (n,), at a time of what is recorded; returns where its frames are in the world, (K, 3)."""
        context = self._plant.GetMyMutableContextFromRoot(self._context)
        positions = np.zeros(self._plant.num_positions())
        positions[self._places] = q
        self._context.SetTime(time)
        self._plant.SetPositions(context, positions)
        self._diagram.ForcedPublish(self._context)
        return np.array([frame.CalcPoseInWorld(context).translation() for frame in frames_of(self._plant)])

    def mark(self, pose: np.ndarray, length: float) -> None:
        """Show a pose (4, 4) of the world as three thin lines: where an answer has a frame."""
        from pydrake.geometry import Rgba

        for k, letter in enumerate("xyz"):
            ends = np.column_stack([pose[:3, 3], pose[:3, 3] + length * pose[:3, k]])
            self.meshcat.SetLine(f"answer/{letter}", ends, 5.0, Rgba(*np.eye(3)[k], 1.0))

    def look_at(self, points: np.ndarray) -> None:
        """Put the camera where points (N, 3) of the world fill the view."""
        self.meshcat.SetCameraPose(*camera(points))


def _server(arm: Arm) -> Any:
    """Return a Meshcat server, whose address Drake need not log."""
    from pydrake.geometry import Meshcat, MeshcatParams

    logger = logging.getLogger("drake")
    level = logger.level
    logger.setLevel(logging.WARNING)
    try:
        return Meshcat(MeshcatParams(host="localhost", show_stats_plot=False))
    except RuntimeError as problem:
        raise ModelError(Fault.NO_MESHCAT, arm=arm.name, reason=str(problem)) from None
    finally:
        logger.setLevel(level)


def camera(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where the camera stands and what it looks at, so that points (N, 3) of the world fill the view."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 0.3)
    flat = np.cos(_ELEVATION)
    away = np.array([flat * np.cos(_AZIMUTH), flat * np.sin(_AZIMUTH), np.sin(_ELEVATION)])
    return middle + _DISTANCE * radius * away, middle
