"""What a DH table claims of an arm: its rows, each with the frames that it is about, and what became of each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from armproof.models.arm import Arm
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Finding
from armproof.verification.naming.names import Names
from armproof.verification.tables.cells import Cell, nothing_stands_in
from armproof.verification.tables.columns import Columns
from armproof.verification.tables.frames import Frames
from armproof.verification.tables.row import PARAMETERS, RightRow, right_row


@dataclass(frozen=True)
class Row:
    """A row of the body: its number from 1, its frames (None: the arm has none for it), its cells by column."""

    number: int
    frames: Frames | None
    cells: Mapping[int, Cell]

    @property
    def is_empty(self) -> bool:
        """Whether the row is left to be filled in."""
        return nothing_stands_in(self.cells.values())


@dataclass
class RowVerdict:
    """What became of a row. `values` are the printed ones, `right` what the frames call for (None: no DH frames)."""

    row: Row
    right: RightRow | None = None
    values: dict[str, Scalar] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)
    problems: dict[str, Finding] = field(default_factory=dict)  # parameter → why it has no value
    unbound: dict[str, str] = field(default_factory=dict)  # parameter → the one name that the cell consists of

    @property
    def holds(self) -> bool:
        """Whether the row is the one that the frames call for."""
        if self.row.frames is None:
            return self.is_identity
        return self.right is not None and not self.wrong and not self.problems

    @property
    def is_identity(self) -> bool:
        """Whether nothing but zeros stands in the row."""
        return len(self.values) == len(PARAMETERS) and all(value.is_zero() for value in self.values.values())


@dataclass(frozen=True)
class Claim:
    """A table's claim about an arm. `lengths`: values for the arm's lengths, where the table gives them in numbers.

    What its frames call for, and what stands in its cells, is found once for all readings.
    """

    names: Names
    arm: Arm
    algebra: ExactAlgebra
    columns: Columns
    rows: tuple[Row, ...]
    lengths: Mapping[str, Scalar] = field(default_factory=dict)
    _right: dict[tuple[Frames, str], RightRow | None] = field(default_factory=dict, init=False, repr=False)
    _values: dict[tuple[int, int], list[Scalar]] = field(default_factory=dict, init=False, repr=False)

    def pose(self, frame: str, reference: str) -> Matrix:
        """Return the arm's pose {}^{reference}T_{frame}."""
        pose: Matrix = self.algebra.quantity(Quantity("pose", frame, reference))
        return self.algebra.substitute(pose, self.lengths) if self.lengths else pose

    def right_row(self, frames: Frames, convention: str) -> RightRow | None:
        """Return the row of the convention that a row's frames call for; None: they are no such DH frames."""
        if (frames, convention) not in self._right:
            pose, variables = self.pose(frames.frame, frames.reference), [joint.symbol for joint in self.arm.joints]
            self._right[frames, convention] = right_row(pose, convention, variables)
        return self._right[frames, convention]

    def values(self, row: Row, column: int) -> list[Scalar]:
        """Return the values of a cell, with the lengths in numbers; raises EvaluationError."""
        if (row.number, column) not in self._values:
            values = row.cells[column].values(self.names, self.algebra)
            if self.lengths:
                values = [self.algebra.substitute(value, self.lengths) for value in values]
            self._values[row.number, column] = values
        return self._values[row.number, column]

    def joint_symbol(self, row: Row) -> str | None:
        """Return the variable of a row's joint."""
        joint = row.frames.joint if row.frames is not None else None
        return self.arm.joints[joint - 1].symbol if joint is not None else None
