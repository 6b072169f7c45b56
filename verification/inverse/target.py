"""The target of an inverse, as the front matter says: which cells of which poses are given, and which angles that displays define."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import KINDS, kind_of
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import read_quantity
from armproof.verification.naming.reading import name_key

OPTIONS = ("target", "solve")
_WHOLE = ("pose", "rotation", "origin")
_PARTS = [kind.name for kind in KINDS.values() if kind.matrix == "pose"]
_EXAMPLE = "target: [X, Y, psi], or target: {pose: 6}"
Pair = tuple[str, str]  # frame, reference
Part = tuple[
    str, str, Quantity | None
]  # as it is spelt, as displays are read, and what it is; None where a display says so


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


def read_claim(spec: object, names: Names) -> tuple[Target, tuple[str, ...]]:
    """Return what a front-matter entry `inverse: {target: …, solve: …}` gives, and the order of the joints (empty: as displayed).

    Raises:
        DocumentError: an unknown key, target or joint, with the valid choices; a quantity that is no part of a pose.
    """
    arm = names.arm
    if arm is None:
        raise DocumentError(say(Kind.INVERSE_WITHOUT_ARM), "inverse")
    if not isinstance(spec, Mapping) or "target" not in spec:
        raise DocumentError(say(Kind.INVERSE_OF_NOTHING, example=_EXAMPLE, value=repr(spec)), "inverse")
    unknown = [str(key) for key in spec if key not in OPTIONS]
    if unknown:
        raise DocumentError(say(Kind.UNKNOWN_INVERSE_OPTION, unknown=unknown, options=list(OPTIONS)), "inverse")
    parts = _read_parts(spec["target"], arm, names)
    order = _read_order(spec.get("solve"), arm, names)
    return _target(parts), order


def _read_parts(spec: object, arm: Arm, names: Names) -> list[Part]:
    if isinstance(spec, Mapping):
        if not any(kind in spec for kind in _WHOLE):
            raise DocumentError(say(Kind.UNKNOWN_TARGET, targets=list(_WHOLE)), "inverse")
        try:
            return [("the target", "", read_quantity("inverse", spec, arm))]
        except DocumentError as error:
            raise DocumentError(finding_of(error), "inverse") from None
    listed = [spec] if isinstance(spec, str) else spec
    if not (isinstance(listed, list) and listed and all(isinstance(name, str) for name in listed)):
        raise DocumentError(say(Kind.NO_TARGET, example=_EXAMPLE, value=repr(spec)), "inverse")
    keys = [_key(names, name) for name in listed]
    if len(set(keys)) < len(keys):
        raise DocumentError(say(Kind.NAME_TWICE, target=repr(listed)), "inverse")
    return [(name, key, names.quantities.get(key)) for name, key in zip(listed, keys, strict=True)]


def _read_order(spec: object, arm: Arm, names: Names) -> tuple[str, ...]:
    if spec is None:
        return ()
    symbols = [joint.symbol for joint in arm.joints]
    if not (isinstance(spec, list) and all(isinstance(name, str) for name in spec)):
        raise DocumentError(say(Kind.NO_JOINTS_TO_SOLVE, joints=symbols, value=repr(spec)), "inverse")
    order = [names.known_symbol(_key(names, name)) or name for name in spec]
    if sorted(order) != sorted(symbols):
        given = [str(name) for name in spec]
        raise DocumentError(say(Kind.NOT_EACH_JOINT, arm=arm.name, joints=symbols, given=given), "inverse")
    return tuple(order)


def _key(names: Names, name: str) -> str:
    try:
        return name_key(names.reader, name)
    except DocumentError as error:
        raise DocumentError(say(Kind.OF_INVERSE, problem=finding_of(error)), "inverse") from None


def _target(parts: list[Part]) -> Target:
    slots = tuple(slot for part in parts for slot in _slots(*part))
    whole = parts[0][2]
    shape: tuple[int, ...] = (len(slots),)
    if len(parts) == 1 and whole is not None and not whole.scalar:
        rows, columns = kind_of(whole).block(whole)
        shape = (len(rows), len(columns)) if len(columns) > 1 else (len(rows),)
    return Target(slots, shape, tuple(name for name, _, _ in parts))


def _slots(name: str, key: str, quantity: Quantity | None) -> list[Slot]:
    if quantity is None:
        return [Slot(name, key)]
    if quantity.kind not in _PARTS or quantity.homogeneous:
        raise DocumentError(say(Kind.NO_PART_OF_TARGET, name=name, kind_name=quantity.kind, shapes=_PARTS), "inverse")
    rows, columns = kind_of(quantity).block(quantity)
    cells = [(r, row, c, column) for r, row in enumerate(rows, 1) for c, column in enumerate(columns, 1)]
    frame, reference = quantity.frame, quantity.reference
    if len(cells) == 1:
        return [Slot(name, "", frame, reference, rows[0], columns[0])]
    return [Slot(f"row {r}, column {c} of {name}", "", frame, reference, row, column) for r, row, c, column in cells]
