"""The arm as plain data: its joints in order, its lengths and the frames of the document.

What else is known of an arm is reached through functions that stand beside what they return, and that this file knows
nothing of: `drake_of` and `plant_of` (models/numeric/drake_arm.py), `trace_of` (models/exact/trace.py), `bulk_of`
(models/bulk/bulk.py), and `NumericKinematics` (models/numeric/plant.py) at some configurations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import wraps
from pathlib import Path
from typing import Any, Literal, TypeVar, cast

from armproof.models.dh.table import DHTable
from armproof.models.errors import Fault, ModelError

T = TypeVar("T")


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
    """An arm with the names that its document uses.

    Attributes:
        name, title, source, zero: from the convention card; `zero` tells what the zero pose looks like.
        joints: base to tool.
        lengths: each length symbol with its value in the plant (m).
        angles: each constant angle symbol of a DH table with its value in the plant (rad).
        frames: the document's frames, the base frame (usually "0") first.
        exact: what gives its exact kinematics, for `trace_of`.
        drake: the arm as Drake has it, for `drake_of`; None if the arm was read from a value.
        dh: the DH table, if the arm was given by one.
        path: the model file, if the arm was read from one.
        model: the text that Drake read, where it is not that of the file.
        digest: SHA-256 of what the arm was loaded from: the model file and its card, or the table.
        warnings: what Drake's parser warned of.
        kept: what has been computed of the arm, for `once_per_arm`.
    """

    name: str
    title: str
    source: str
    zero: str
    joints: tuple[Joint, ...]
    lengths: Mapping[str, float]
    angles: Mapping[str, float]
    frames: tuple[str, ...]
    exact: Any = field(default=None, repr=False)
    drake: Any = field(default=None, repr=False)
    dh: DHTable | None = None
    path: Path | None = None
    model: str = field(default="", repr=False)
    digest: str = ""
    warnings: tuple[str, ...] = ()
    kept: dict[Any, Any] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        symbols = [joint.symbol for joint in self.joints] + [*self.lengths, *self.angles]
        twice = sorted({symbol for symbol in symbols if symbols.count(symbol) > 1})
        if twice:
            raise ModelError(Fault.SYMBOL_TWICE, arm=self.name, symbol=twice[0])

    def frame_names(self, *names: str | int | None) -> tuple[str, ...]:
        """Return frame names as texts, the base frame for None.

        Raises:
            ModelError: the arm has no such frame.
        """
        checked = tuple(self.frames[0] if name is None else str(name) for name in names)
        for name in checked:
            if name not in self.frames:
                raise ModelError(Fault.NO_FRAME, frame=name, arm=self.name, frames=list(self.frames))
        return checked

    def joint(self, symbol: str) -> Joint:
        """Return the joint of a joint variable.

        Raises:
            ModelError: the arm has no such joint variable.
        """
        for joint in self.joints:
            if joint.symbol == symbol:
                return joint
        symbols = [joint.symbol for joint in self.joints]
        raise ModelError(Fault.NO_JOINT_VARIABLE, symbol=symbol, arm=self.name, symbols=symbols)


def once_per_arm(compute: Callable[[Arm], T]) -> Callable[[Arm], T]:
    """Make a function of an arm keep its result with the arm: computed on demand, once."""

    @wraps(compute)
    def kept(arm: Arm) -> T:
        if compute not in arm.kept:
            arm.kept[compute] = compute(arm)
        return cast("T", arm.kept[compute])

    return kept
