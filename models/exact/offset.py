"""The fixed poses of a plant, made exact: every constant of an arm's kinematics stands in a FixedOffsetFrame."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from math import pi
from typing import Any

from armproof.models.exact.numbers import angle_value, exact_number, exact_rotation
from armproof.models.exact.polynomial import Entry, Rows, generators, number

_NEARLY = 2e-3  # rad


@dataclass(frozen=True)
class Offset:
    """An exact constant pose X_PF of a frame F fixed in its parent P: rotation R_PF (3×3) and origin p_PF (3, m)."""

    rotation: Rows
    translation: tuple[Entry, ...]


def exact_offset(X_PF: Any) -> Offset:
    """Return the exact pose that a RigidTransform of doubles stands for.

    Raises:
        ModelError: a coordinate that is not finite.
    """
    translation = tuple(number(exact_number(float(value))) for value in X_PF.translation())
    return Offset(exact_rotation(X_PF.rotation().matrix()), translation)


def exact_offsets(plant: Any, but: Collection[int] = ()) -> dict[int, Offset]:
    """Return the exact pose of every FixedOffsetFrame of a finalized plant in its parent, by the index of the frame; of all `but` these."""
    from pydrake.multibody.tree import FixedOffsetFrame

    context = plant.CreateDefaultContext()
    return {
        int(frame.index()): exact_offset(frame.GetPoseInParentFrame(context))
        for frame in frames_of(plant)
        if isinstance(frame, FixedOffsetFrame) and int(frame.index()) not in but
    }


def frame_at(plant: Any, index: int) -> Any:
    """Return the frame of a plant with an index."""
    from pydrake.multibody.tree import FrameIndex

    return plant.get_frame(FrameIndex(index))


def frames_of(plant: Any) -> list[Any]:
    """Return the frames of a plant; the world's, which is the arm's foot, among them."""
    return [frame_at(plant, index) for index in range(plant.num_frames())]


def nearly_right_angles(plant: Any, source: str) -> tuple[str, ...]:
    """Return a warning for each fixed pose that turns by nearly, but not exactly, a multiple of pi/4.

    Such an angle, 1.5708 say, is taken as it stands, and then no equation with a right angle holds on the arm.
    """
    warnings = []
    for index, offset in exact_offsets(plant).items():
        for kind, name in sorted(generators(entry for row in offset.rotation for entry in row)):
            if kind == "cos" and "pi" not in name:
                quarters = round(angle_value(name) / (pi / 4))
                if quarters and abs(angle_value(name) - quarters * pi / 4) < _NEARLY:
                    exact = f"{quarters * pi / 4:.16f}"
                    frame = frame_at(plant, index).name()
                    warnings.append(
                        f"{source}: frame '{frame}' turns by {name} rad, nearly {quarters}*pi/4; write {exact}"
                    )
    return tuple(warnings)
