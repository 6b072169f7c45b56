"""Names that handouts use for an arm's quantities without saying so: what each may stand for, by its letter and indices.

A letter with few indices has several meanings: x_2 is a coordinate or an axis, J_{v2} a block or a column. All are given
here, the likelier first; the size of what the name is equated to chooses among them (equations/conventional.py).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.models.arm import Arm
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import ANGULAR, LINEAR, Quantity, numbered_frames

END = frozenset("e E ee EE ef EF eff tool Tool tcp TCP t end h hand G g OT ot terminal eef".split())
LAST = frozenset("n N".split())
POSITIONS = frozenset("p P o O r d t X x c".split())
POSES = frozenset("T H A M g".split())
FUNCTIONS = frozenset("f F FK fk fkine DK MGD DGM MGDpos h k".split())
LINEAR_VELOCITIES, ANGULAR_VELOCITIES = frozenset("v V".split()), frozenset("omega w W Omega".split())
TWISTS = frozenset("V xi nu eta t".split())
ORIENTATIONS = frozenset("phi psi alpha gamma theta Phi".split())
MANIPULABILITIES = frozenset("w mu m M".split())
AXES = "xyz"


def conventional(name: n.Name, arm: Arm, transforms: str) -> tuple[Quantity, ...]:
    """Return what a name may stand for on an arm by convention, the likelier first; nothing where it is no usual name."""
    if name.dots or name.primes or (name.pre_sub and name.pre_sup and name.sub):
        return ()
    reference = _reference(name, arm)
    if reference is None:
        return ()
    index = name.pre_sub or name.sub
    found = dict.fromkeys(_all(name.base, index, reference, arm, bool(name.pre_sup or name.sup)))
    return tuple(found)


def _reference(name: n.Name, arm: Arm) -> str | None:
    """The frame in which a name is expressed: what stands above it, else the first; None where that is no frame."""
    above = name.pre_sup or name.sup
    if not above or (name.pre_sup and name.sup):
        return arm.frames[0] if not above else None
    return above if above in arm.frames else None


def _all(base: str, index: str, reference: str, arm: Arm, placed: bool) -> Iterator[Quantity]:
    for frame, component, given in _indices(index, reference, arm):
        origin = Quantity("origin", frame, given)
        if component is None:
            if base in POSITIONS:
                yield origin
                if base in ("X", "x", "p") and is_planar(arm):
                    yield Quantity("task", frame, given)
            if base.lower() in AXES and len(base) == 1:
                yield _component(origin, base.lower())
                if index:
                    yield Quantity("axis", frame, given, along=base.lower())
            if base in POSES:
                yield Quantity("pose", frame, given)
            if base == "R":
                yield Quantity("rotation", frame, given)
            if base == "J" and index:
                yield Quantity("jacobian", frame, given)
            if base in ORIENTATIONS and not placed and is_planar(arm):
                yield Quantity("angle", frame, given, scalar=True)
        elif base in POSITIONS:
            yield _component(origin, component)
        yield from _velocities(base, frame, given, component)
    if base == "J":
        yield from _blocks(index, reference, arm)
    if base in MANIPULABILITIES and not index and not placed:
        yield Quantity("manipulability", _last(arm), reference, scalar=True)


def _velocities(base: str, frame: str, reference: str, component: str | None) -> Iterator[Quantity]:
    """v_i and ω_i as J_i q̇, whole or one component; of a planar arm ω is its z component."""
    for letters, first in ((LINEAR_VELOCITIES, 1), (ANGULAR_VELOCITIES, 4)):
        if base not in letters:
            continue
        if component is None:
            yield Quantity("velocity", frame, reference, rows=(first, first + 1, first + 2))
        if component is not None or first == 4:
            row = first + AXES.index(component or "z")
            yield Quantity("velocity", frame, reference, rows=(row,), scalar=True)
    if base in TWISTS and component is None:
        yield Quantity("velocity", frame, reference)


def _blocks(index: str, reference: str, arm: Arm) -> Iterator[Quantity]:
    """J_{v2}, J_{ω_2}, J_{P_2}: the rows of one velocity in the Jacobian of a frame."""
    found = re.fullmatch(r"([A-Za-z]+?)_?,?(\d|[eEnN]|tool|EE|ee)?", index)
    if found is None:
        return
    letters, number = found.groups()
    frame = _frame(number, arm) if number else _last(arm)
    rows = (1, 2, 3) if letters in LINEAR else (4, 5, 6) if letters in ANGULAR else None
    if frame is not None and rows is not None:
        yield Quantity("jacobian", frame, reference, rows=rows)


def _indices(index: str, reference: str, arm: Arm) -> Iterator[tuple[str, str | None, str]]:
    """Yield (frame, component or None, reference) for the readings of an index: "", "2", "e,x", "x2", "02", "0→2"."""
    if not index:
        for frame in dict.fromkeys((_tool(arm), _last(arm))):
            yield frame, None, reference
        return
    plain = re.sub(r",?(?:ORG|org|orig)$", "", index)
    if (frame := _frame(plain, arm)) is not None:
        yield frame, None, reference
        return
    if plain in AXES:
        for frame in dict.fromkeys((_tool(arm), _last(arm))):
            yield frame, plain, reference
        return
    two = re.fullmatch(r"(\w+?)(?:,|to|_|-)?(\w+)", plain)
    for first, second in _splits(plain) if two else ():
        if second in AXES and (frame := _frame(first, arm)) is not None:
            yield frame, second, reference
        elif first in AXES and (frame := _frame(second, arm)) is not None:
            yield frame, first, reference
        elif (start := _frame(first, arm)) is not None and (frame := _frame(second, arm)) is not None:
            yield frame, None, start


def _splits(index: str) -> Iterator[tuple[str, str]]:
    """Yield the ways to cut an index in two: at its separator, or between any two letters."""
    parts = re.split(r",|_|-|to(?=\w)", index, maxsplit=1)
    if len(parts) == 2 and all(parts):
        yield parts[0], parts[1]
        return
    for place in range(1, len(index)):
        yield index[:place], index[place:]


def _frame(text: str, arm: Arm) -> str | None:
    if text in arm.frames:
        return text
    if text in LAST:
        return _last(arm)
    return _tool(arm) if text in END else None


def _tool(arm: Arm) -> str:
    return arm.frames[-1]


def _last(arm: Arm) -> str:
    return numbered_frames(arm)[-1]


def _component(quantity: Quantity, axis: str) -> Quantity:
    return replace(quantity, rows=(AXES.index(axis) + 1,), scalar=True)
