"""Show an arm in Drake's model visualizer, with its document frames as triads and a slider for each joint."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.offset import frame_at
from armproof.models.numeric.drake_arm import frame_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.shapes import with_shapes

_TRIADS_IN_REACH = 8  # a triad's axis is this part of the arm's reach


def view_arm(arm: Arm, *, browser: bool = True) -> None:
    """Show an arm until the user stops it.

    Args:
        arm: an arm that was read from a model file.
        browser: open a browser window; without it, Drake logs the address.

    Raises:
        ModelError: the arm was given by a DH table and has no shape to show.
    """
    from pydrake.visualization import ModelVisualizer

    _model_file(arm)
    visualizer = ModelVisualizer(browser_new=browser, publish_contacts=False)
    add_arm(visualizer.parser(), arm)
    visualizer.Run()


def add_arm(parser: Any, arm: Arm) -> None:
    """Add an arm, its base welded to the world and a triad at each document frame, to the plant and scene of a parser.

    A triad's geometries are named after the document frame: "_frames::frame 3::x-axis".

    Raises:
        ModelError: the arm was given by a DH table.
    """
    from pydrake.visualization import AddFrameTriadIllustration

    path = _model_file(arm)
    _add_model(parser, arm, path)
    plant = parser.plant()
    _weld_base(plant)
    length = _triad_length(arm)
    for name in arm.frames:
        AddFrameTriadIllustration(
            scene_graph=parser.scene_graph(),
            frame=frame_at(plant, int(frame_of(arm, name).index())),  # the same file gives the same indices
            name=f"frame {name}",
            length=length,
            radius=length / 40,
        )


def _add_model(parser: Any, arm: Arm, path: Path) -> None:
    """Add the model as Drake read it; links whose meshes are not there as rods from joint to joint."""
    if path.name.endswith(".dmd.yaml"):
        parser.package_map().PopulateFromFolder(path.parent)
    shown = with_shapes(arm.model or path.read_text(encoding="utf-8"), path.parent) if path.suffix == ".urdf" else ""
    if shown or arm.model:
        parser.AddModelsFromString(shown or arm.model, "urdf")
    else:
        parser.AddModels(path)


def _model_file(arm: Arm) -> Path:
    if arm.path is None:
        raise ModelError(Fault.NO_SHAPE, arm=arm.name)
    return arm.path.resolve()


def _weld_base(plant: Any) -> None:
    """Weld to the world each body that no joint carries, as a loaded arm has it."""
    from pydrake.multibody.tree import BodyIndex

    carried = {plant.get_joint(index).child_body().index() for index in plant.GetJointIndices()}
    for index in range(1, plant.num_bodies()):
        body = plant.get_body(BodyIndex(index))
        if body.index() not in carried:
            plant.WeldFrames(plant.world_frame(), body.body_frame())


def _triad_length(arm: Arm) -> float:
    """Return the length of a triad's axes in metres: part of the farthest frame's distance at the zero pose."""
    kinematics = NumericKinematics(arm, np.zeros((1, len(arm.joints))))
    reach = max(float(np.linalg.norm(kinematics.pose(name, arm.frames[0])[0, :3, 3])) for name in arm.frames)
    return max(reach, 0.2) / _TRIADS_IN_REACH
