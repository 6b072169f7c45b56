"""A motion of an arm as one page with Drake's Meshcat viewer, which needs no server and no network."""

from __future__ import annotations

import logging
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.offset import frames_of
from armproof.models.motion.samples import interval, sample_motion
from armproof.models.numeric.drake_arm import drake_of
from armproof.models.showing.viewer import add_arm

RATE = 32.0  # frames a second
_AZIMUTH, _ELEVATION = np.radians(-50.0), np.radians(20.0)  # from where the arm is seen
_DISTANCE = 2.5  # of the camera, in radii of what the arm's frames reach


def record_page(arm: Arm, trajectory: Any) -> str:
    """Return a page (HTML) in which the arm goes along a trajectory, with a triad at each document frame.

    A Meshcat server is started for it on this machine only, and ended.

    Args:
        trajectory: a pydrake Trajectory with values of the shape (n, 1), base to tool.

    Raises:
        ModelError: the arm was given by a DH table and has no shape, or the trajectory is no motion of it.
    """
    from pydrake.geometry import Meshcat, MeshcatParams, MeshcatVisualizer, MeshcatVisualizerParams
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
    from pydrake.systems.framework import DiagramBuilder

    start, end = interval(trajectory, len(arm.joints))
    builder = DiagramBuilder()
    plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.0)
    add_arm(Parser(plant, scene_graph), arm)
    plant.Finalize()
    logger = logging.getLogger("drake")
    level = logger.level
    logger.setLevel(logging.WARNING)  # the address of a server that nobody is to visit
    try:
        meshcat = Meshcat(MeshcatParams(host="localhost", show_stats_plot=False))
    finally:
        logger.setLevel(level)
    visualizer = MeshcatVisualizer.AddToBuilder(
        builder, scene_graph, meshcat, MeshcatVisualizerParams(publish_period=1 / RATE)
    )
    diagram = builder.Build()
    context = diagram.CreateDefaultContext()
    times = np.linspace(start, end, max(round((end - start) * RATE), 1) + 1)
    positions = np.zeros(plant.num_positions())
    seen: list[np.ndarray] = []
    visualizer.StartRecording(set_transforms_while_recording=False)
    for time, q in zip(times - start, sample_motion(trajectory, times).q, strict=True):
        positions[list(drake_of(arm).position_indices)] = q
        context.SetTime(time)
        plant_context = plant.GetMyMutableContextFromRoot(context)
        plant.SetPositions(plant_context, positions)
        seen += [frame.CalcPoseInWorld(plant_context).translation() for frame in frames_of(plant)]
        diagram.ForcedPublish(context)
    visualizer.StopRecording()
    visualizer.PublishRecording()
    meshcat.SetCameraPose(*_camera(np.array(seen)))
    return str(meshcat.StaticHtml())


def _camera(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where the camera stands and what it looks at, so that points (N, 3) of the world fill the view."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 0.3)
    flat = np.cos(_ELEVATION)
    away = np.array([flat * np.cos(_AZIMUTH), flat * np.sin(_AZIMUTH), np.sin(_ELEVATION)])
    return middle + _DISTANCE * radius * away, middle
