"""What a program starts from at each block: the inputs of its graph, computed from the values that it is called with."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from armproof.models.arm import Joint
from armproof.models.exact.polynomial import Generator


class Inputs(Protocol):
    """The inputs that occur."""

    @property
    def generators(self) -> Sequence[Generator]:
        """The inputs in the order of their rows."""

    def write(self, rows: np.ndarray, block: np.ndarray) -> None:
        """Write the inputs, (their number, B), of the values of a block, (B, columns)."""


class JointInputs:
    """The cosines and sines of the angles that occur, then the variables of the prismatic joints."""

    def __init__(self, joints: Sequence[Joint], occurring: set[Generator]) -> None:
        names = {name for _, name in occurring}
        used = [joint for joint in joints if joint.symbol in names]
        angles, slides = ([joint for joint in used if joint.kind == kind] for kind in ("revolute", "prismatic"))
        self._angles, self._slides = ([joint.index - 1 for joint in some] for some in (angles, slides))
        self.generators = [(kind, joint.symbol) for kind in ("cos", "sin") for joint in angles]
        self.generators += [("symbol", joint.symbol) for joint in slides]

    def write(self, rows: np.ndarray, block: np.ndarray) -> None:
        """Write cosines, sines and prismatic variables, by t = tan θ/2: cos θ = 2/(1 + t²) − 1, sin θ = 2t/(1 + t²).

        One tangent and one division take less than half the time of a cosine and a sine, and both come out within 4e-16.
        """
        count = len(self._angles)
        cosines, sines = rows[:count], rows[count : 2 * count]
        for row, column in zip(sines, self._angles, strict=True):
            np.multiply(block[:, column], 0.5, row)
        np.tan(sines, sines)
        np.multiply(sines, sines, cosines)
        np.add(cosines, 1.0, cosines)
        np.divide(2.0, cosines, cosines)
        np.multiply(sines, cosines, sines)
        np.subtract(cosines, 1.0, cosines)
        for row, column in zip(rows[2 * count :], self._slides, strict=True):
            row[:] = block[:, column]


class ColumnInputs:
    """Columns of the values themselves; an input is named by the number of its column."""

    def __init__(self, occurring: set[Generator]) -> None:
        self.generators = sorted(occurring)
        self._columns = [int(name) for _, name in self.generators]

    def write(self, rows: np.ndarray, block: np.ndarray) -> None:
        """Write the columns that occur."""
        for row, column in zip(rows, self._columns, strict=True):
            row[:] = block[:, column]
