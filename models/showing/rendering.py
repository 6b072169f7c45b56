"""A picture of an arm rendered by Drake's RenderEngineVtk: its shapes, seen by a pinhole camera."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.numeric.drake_arm import drake_of, frame_of, plant_of
from armproof.models.numeric.joint_values import read_configuration
from armproof.models.showing.projection import look_along
from armproof.models.showing.viewer import add_arm

_RENDERER = "vtk"
_NEAR, _FAR = 0.01, 200.0  # m
_MOST = 8192  # pixels of an edge


@dataclass(frozen=True, eq=False)
class Camera:
    """A pinhole camera.

    Attributes:
        X_0C: (4, 4), its pose in frame 0: x to the right, y downwards in the picture, z into it.
        width, height: pixels.
        field_of_view: of the height (rad).
    """

    X_0C: np.ndarray
    width: int
    height: int
    field_of_view: float

    def pixels(self, points: np.ndarray) -> np.ndarray:
        """Return where points (N, 3) of frame 0 are in the picture, (N, 2), pixels to the right and downwards."""
        seen = (np.asarray(points, dtype=float) - self.X_0C[:3, 3]) @ self.X_0C[:3, :3]
        focal = self.height / 2 / np.tan(self.field_of_view / 2)
        centre = np.array([self.width, self.height]) / 2 - 0.5
        return np.asarray(centre + focal * seen[:, :2] / seen[:, 2:])


def look_at(
    target: np.ndarray, toward: np.ndarray, distance: float, width: int, height: int, field_of_view: float
) -> Camera:
    """Return a camera that sees a point from a direction, z_0 upwards in the picture (y_0 where it looks along z_0).

    Args:
        target: (3,), in frame 0 (m).
        toward: (3,), from the target to the camera.
        distance: between them (m).

    Raises:
        ModelError: a size of no picture.
    """
    if not (1 <= width <= _MOST and 1 <= height <= _MOST):
        raise ModelError(Fault.PICTURE_SIZE, most=_MOST, width=width, height=height)
    view = look_along(toward)
    X_0C = np.eye(4)
    X_0C[:3, :3] = np.column_stack([view.right, -view.up, -view.toward])
    X_0C[:3, 3] = np.asarray(target, dtype=float) + distance * view.toward
    return Camera(X_0C, width, height, field_of_view)


class ArmRenderer:
    """Renders one arm; the scene is built once, each picture takes a fraction of a second."""

    def __init__(self, arm: Arm) -> None:
        """Build the arm's plant and scene.

        Raises:
            ModelError: the arm was given by a DH table and has no shape, or this machine cannot render.
        """
        from pydrake.geometry import MakeRenderEngineVtk, RenderEngineVtkParams
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
        from pydrake.systems.framework import DiagramBuilder

        builder = DiagramBuilder()
        self._plant, self._scene_graph = AddMultibodyPlantSceneGraph(builder, 0.0)
        self._arm = arm
        add_arm(Parser(self._plant, self._scene_graph), arm)
        self._plant.Finalize()
        require_renderer()
        parameters = RenderEngineVtkParams(
            default_clear_color=np.ones(3), lights=_lights(), backend="EGL", cast_shadows=False
        )
        self._scene_graph.AddRenderer(_RENDERER, MakeRenderEngineVtk(parameters))
        self._diagram = builder.Build()
        self._context = self._diagram.CreateDefaultContext()

    def image(self, q: Any, camera: Camera) -> np.ndarray:
        """Return the picture at a configuration (n,), base to tool, on white: (height, width, 3), 0 … 255.

        Raises:
            ModelError: q is no configuration of the arm.
        """
        from pydrake.geometry import ClippingRange, ColorRenderCamera, RenderCameraCore
        from pydrake.math import RigidTransform
        from pydrake.systems.sensors import CameraInfo

        positions = np.zeros(self._plant.num_positions())
        positions[list(drake_of(self._arm).position_indices)] = read_configuration(self._arm, q)
        context = self._plant.GetMyContextFromRoot(self._context)
        self._plant.SetPositions(context, positions)
        X_W0 = self._frame_0(positions)
        lens = CameraInfo(camera.width, camera.height, camera.field_of_view)
        core = RenderCameraCore(_RENDERER, lens, ClippingRange(_NEAR, _FAR), RigidTransform())
        query: Any = self._scene_graph.get_query_output_port().Eval(
            self._scene_graph.GetMyContextFromRoot(self._context)
        )
        X_WC = RigidTransform(X_W0 @ camera.X_0C)
        picture = query.RenderColorImage(ColorRenderCamera(core, False), self._scene_graph.world_frame_id(), X_WC)
        return np.array(picture.data[:, :, :3])

    def _frame_0(self, positions: np.ndarray) -> np.ndarray:
        context = plant_of(self._arm).CreateDefaultContext()
        plant_of(self._arm).SetPositions(context, positions)
        return np.asarray(frame_of(self._arm, self._arm.frames[0]).CalcPoseInWorld(context).GetAsMatrix4())


def require_renderer() -> None:
    """Check that EGL can give a context to render in; without one Drake would end the process.

    Raises:
        ModelError: it cannot; what to install.
    """
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError as error:
        raise ModelError(Fault.NO_RENDERER, problem=str(error)) from None
    egl.eglGetDisplay.restype = egl.eglGetPlatformDisplay.restype = ctypes.c_void_p
    surfaceless, device = 0x31DD, 0x313F
    displays = [egl.eglGetPlatformDisplay(kind, None, None) for kind in (surfaceless, device)]
    displays.append(egl.eglGetDisplay(None))
    major, minor = ctypes.c_int(), ctypes.c_int()
    for display in displays:
        if display and egl.eglInitialize(ctypes.c_void_p(display), ctypes.byref(major), ctypes.byref(minor)):
            return
    raise ModelError(Fault.NO_RENDERER, problem=ModelError(Fault.NO_DRIVER))


def _lights() -> list[Any]:
    """Return two lights that are fixed to the camera: from above to the left, and a weaker one from the right."""
    from pydrake.geometry import LightParameter

    return [
        LightParameter(type="directional", frame="camera", intensity=0.95, direction=[0.45, 0.6, 1.0]),
        LightParameter(type="directional", frame="camera", intensity=0.35, direction=[-0.8, 0.1, 0.6]),
    ]
