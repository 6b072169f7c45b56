"""The target of an inverse: which cells of which poses are given, and which angles that displays define."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.claim import InverseClaim, TargetPart

_SHAPES = {"pose": (4, 4), "rotation": (3, 3), "origin": (3, 1), "axis": (3, 1)}
Pair = tuple[str, str]  # frame, reference


@dataclass(frozen=True)
class Slot:
    """One number of the target.

    Attributes:
        label: how it is called in messages: "X", "(1, 4) of the target".
        key: the name whose value it is, "" for a cell of a pose.
        frame, reference, row, column: the cell, rows and columns from 0.
    """

    label: str
    key: str = ""
    frame: str = ""
    reference: str = ""
    row: int = 0
    column: int = 0

    @property
    def is_name(self) -> bool:
        """Whether a display defines it: an angle such as ψ = θ_1 + θ_2 − θ_4."""
        return bool(self.key)

    @property
    def is_constant(self) -> bool:
        """Whether it stands in the last row of a pose."""
        return not self.is_name and self.row == 3


@dataclass(frozen=True)
class Target:
    """The numbers that are given, in order; `shape` is that of one target where it is one matrix."""

    slots: tuple[Slot, ...]
    shape: tuple[int, ...]
    names: tuple[str, ...]

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """The poses of which cells are given."""
        return tuple(dict.fromkeys((slot.frame, slot.reference) for slot in self.slots if not slot.is_name))

    @cached_property
    def rotations(self) -> tuple[Pair, ...]:
        """The poses of which the whole rotation is given."""
        nine = {(row, column) for row in range(3) for column in range(3)}
        return tuple(pair for pair in self.pairs if nine <= set(self.cells(pair)))

    def cells(self, pair: Pair) -> dict[tuple[int, int], int]:
        """Return the cells given of a pose, each with the index of its slot."""
        return {
            (slot.row, slot.column): index
            for index, slot in enumerate(self.slots)
            if not slot.is_name and (slot.frame, slot.reference) == pair
        }


def read_target(claim: InverseClaim) -> Target:
    """Return the slots of a claim; raises DocumentError for a quantity that is no part of a pose."""
    slots = tuple(slot for part in claim.target for slot in _part_slots(part))
    whole = claim.target[0].quantity
    shape: tuple[int, ...] = (len(slots),)
    if len(claim.target) == 1 and whole is not None and not whole.scalar:
        rows, columns = _cells(whole)
        shape = (len(rows), len(columns)) if len(columns) > 1 else (len(rows),)
    return Target(slots, shape, tuple(part.name for part in claim.target))


def _part_slots(part: TargetPart) -> list[Slot]:
    quantity = part.quantity
    if quantity is None:
        return [Slot(part.name, key=part.key)]
    if quantity.kind not in _SHAPES or quantity.homogeneous:
        raise DocumentError(
            say(Kind.NO_PART_OF_TARGET, name=part.name, kind_name=quantity.kind, shapes=list(_SHAPES)), "inverse"
        )
    rows, columns = _cells(quantity)
    one = len(rows) == len(columns) == 1
    return [
        Slot(
            part.name if one else f"row {r + 1}, column {c + 1} of {part.name}",
            frame=quantity.frame,
            reference=quantity.reference,
            row=row,
            column=column,
        )
        for r, row in enumerate(rows)
        for c, column in enumerate(columns)
    ]


def _cells(quantity: Quantity) -> tuple[list[int], list[int]]:
    """Return the rows and columns of the pose that a quantity is, from 0."""
    height, width = _SHAPES[quantity.kind]
    rows = [row - 1 for row in quantity.rows or range(1, height + 1)]
    columns = [column - 1 for column in quantity.columns or range(1, width + 1)]
    if quantity.kind == "origin":
        columns = [3]
    elif quantity.kind == "axis":
        columns = [COMPONENTS[quantity.along]]
    return rows, columns
