"""The loaded arm: a Drake plant, its joints in order, its lengths and the frames of the document."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from armproof.models.errors import ModelError
from armproof.models.exact.offset import Offset

if TYPE_CHECKING:
    import numpy as np

    from armproof.models.bulk.bulk import BulkKinematics
    from armproof.models.dh.table import DHTable
    from armproof.models.exact.trace import Trace
    from armproof.models.numeric.plant import NumericKinematics


@dataclass(frozen=True)
class Joint:
    """A moving joint of an arm.

    Attributes:
        index: its place in the chain, from 1 at the base.
        name: its name in the plant.
        symbol: the handwritten joint variable, as "theta_1" or "d_3".
        kind: revolute (rad) or prismatic (m).
        lower, upper: the limits of the variable; infinite if it has none.
    """

    index: int
    name: str
    symbol: str
    kind: Literal["revolute", "prismatic"]
    lower: float
    upper: float


@dataclass(frozen=True, eq=False)
class Arm:
    """An arm as Drake sees it, with the names that its document uses.

    Attributes:
        name, title, source, zero: from the convention card; `zero` tells what the zero pose looks like.
        joints: base to tool.
        lengths: each length symbol with its value in the plant (m).
        angles: each constant angle symbol of a DH table with its value in the plant (rad).
        frames: the document's frames, the base frame (usually "0") first.
        plant: the finalized MultibodyPlant of doubles.
        dh: the DH table, if the arm was given by one.
        path: the model file, if the arm was read from one.
        warnings: what Drake's parser warned of.
        drake_base: the Drake body that carries the arm.
        drake_joints: the Drake joint of each of `joints`.
        drake_frames: the Drake frame of each document frame.
        offsets: the exact pose of each fixed frame that holds a symbol, by the frame's index in the plant.
    """

    name: str
    title: str
    source: str
    zero: str
    joints: tuple[Joint, ...]
    lengths: Mapping[str, float]
    angles: Mapping[str, float]
    frames: tuple[str, ...]
    plant: Any = field(repr=False)
    dh: DHTable | None = None
    path: Path | None = None
    warnings: tuple[str, ...] = ()
    drake_base: Any = field(default=None, repr=False)
    drake_joints: tuple[Any, ...] = field(default=(), repr=False)
    drake_frames: Mapping[str, Any] = field(default_factory=dict, repr=False)
    offsets: Mapping[int, Offset] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        symbols = [joint.symbol for joint in self.joints] + [*self.lengths, *self.angles]
        twice = sorted({symbol for symbol in symbols if symbols.count(symbol) > 1})
        if twice:
            raise ModelError(f"arm '{self.name}': the symbol '{twice[0]}' stands for two things; each needs its own")

    def frame(self, name: str | int) -> Any:
        """Return the Drake frame of a document frame.

        Raises:
            ModelError: the arm has no such frame.
        """
        try:
            return self.drake_frames[str(name)]
        except KeyError:
            frames = ", ".join(self.frames)
            raise ModelError(f"no frame '{name}' on arm '{self.name}'; its frames are {frames}") from None

    def frame_names(self, *names: str | int | None) -> tuple[str, ...]:
        """Return frame names as texts, the base frame for None.

        Raises:
            ModelError: the arm has no such frame.
        """
        checked = tuple(self.frames[0] if name is None else str(name) for name in names)
        for name in checked:
            self.frame(name)
        return checked

    def joint(self, symbol: str) -> Joint:
        """Return the joint of a joint variable.

        Raises:
            ModelError: the arm has no such joint variable.
        """
        for joint in self.joints:
            if joint.symbol == symbol:
                return joint
        symbols = ", ".join(joint.symbol for joint in self.joints)
        raise ModelError(f"no joint variable '{symbol}' on arm '{self.name}'; its joint variables are {symbols}")

    @cached_property
    def position_indices(self) -> tuple[int, ...]:
        """The index of each joint variable in the plant's vector of positions (and of velocities)."""
        return tuple(joint.position_start() for joint in self.drake_joints)

    @cached_property
    def trace(self) -> Trace:
        """The exact symbolic kinematics, computed on demand."""
        from armproof.models.exact.trace import Trace

        return Trace(self)

    @cached_property
    def bulk(self) -> BulkKinematics:
        """The kinematics at very many configurations, compiled on demand."""
        from armproof.models.bulk.bulk import BulkKinematics

        return BulkKinematics(self)

    def numeric(self, q: np.ndarray) -> NumericKinematics:
        """Return the kinematics of the plant of doubles at N configurations, (N, n) in the order of `joints`."""
        from armproof.models.numeric.plant import NumericKinematics

        return NumericKinematics(self, q)
