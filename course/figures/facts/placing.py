"""Frames that somebody places on an arm as it is drawn, at its zero pose, and the modified Denavit–Hartenberg table that follows from them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from armproof.course.figures.facts.dh_rows import LinkRow, LinkRows, chain_frames, linear_form, link_rows
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import load_arm
from armproof.models.dh.entry import LinearForm, read_entry

NEAR = 1e-7
Vector = tuple[LinearForm, LinearForm, LinearForm]  # a point or a direction of the drawing, in the letters of the arm
Values = Mapping[str, float]


@dataclass(frozen=True, eq=False)
class Scheme:
    """An arm as it is drawn before its frames are placed.

    Attributes:
        spec: the arm, as `load_arm` takes it; one of whose frames are those of Denavit and Hartenberg.
        marked: points of the drawing by their letters, each as three entries of a table: ("a_2", 0, 0).
    """

    spec: Any
    marked: Mapping[str, Sequence[object]]

    @cached_property
    def arm(self) -> Arm:
        """The arm."""
        return load_arm(self.spec)

    @cached_property
    def points(self) -> dict[str, Vector]:
        """The marked points."""
        return {letter: vector(entries) for letter, entries in self.marked.items()}

    @cached_property
    def generic(self) -> dict[str, float]:
        """Lengths that no number and no sum of other lengths equals by chance."""
        return {symbol: float(np.sqrt(k + 2) / 3) for k, symbol in enumerate(self.arm.lengths)}

    def axes(self, values: Values) -> tuple[np.ndarray, np.ndarray]:
        """Return a point on the axis of each joint and the axis' direction, both (n, 3)."""
        rows, frames = link_rows(self.arm), chain_frames(self.arm)
        assert rows is not None
        carried = frames[:-1] if rows.convention == "classic" else frames[1:]
        bulk, zero = bulk_of(self.arm).with_values(values), np.zeros((1, len(self.arm.joints)))
        poses = np.array([bulk.pose(zero, frame)[0] for frame in carried])
        return poses[:, :3, 3], poses[:, :3, 2]


@dataclass(frozen=True, eq=False)
class Placed:
    """Frames 1 to n as they are placed: the directions z_i and x_i, and the origins."""

    z: tuple[Vector, ...]
    origins: tuple[Vector, ...]
    x: tuple[Vector, ...]

    def at(self, values: Values) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return z, origins and x, (n, 3) each, for lengths; directions as unit vectors."""
        return directions(self.z, values), places(self.origins, values), directions(self.x, values)

    def poses(self, values: Values) -> dict[str, np.ndarray]:
        """Return the pose of each frame, (4, 4), by its number."""
        found = {}
        for number, (z, origin, x) in enumerate(zip(*self.at(values), strict=True), 1):
            found[str(number)] = np.eye(4)
            found[str(number)][:3] = np.column_stack([x, np.cross(z, x), z, origin])
        return found


def difference(end: Vector, start: Vector) -> Vector:
    """Return the way from one point to another."""
    x, y, z = (_less(form, other) for form, other in zip(end, start, strict=True))
    return x, y, z


def _less(form: LinearForm, other: LinearForm) -> LinearForm:
    symbols = dict.fromkeys(symbol for symbol, _ in (*form.symbols, *other.symbols))
    terms = [(symbol, form.coefficient(symbol) - other.coefficient(symbol)) for symbol in symbols]
    return LinearForm(tuple(term for term in terms if term[1]), form.pi - other.pi, form.number - other.number)


def vector(entries: Sequence[object]) -> Vector:
    """Return three entries as a vector; raises ModelError where one cannot be read."""
    x, y, z = map(read_entry, entries)
    return x, y, z


def places(vectors: Sequence[Vector], values: Values) -> np.ndarray:
    """Return vectors for lengths, (N, 3)."""
    return np.array([[form.value(dict(values)) for form in each] for each in vectors])


def directions(vectors: Sequence[Vector], values: Values) -> np.ndarray:
    """Return vectors as unit vectors, (N, 3)."""
    found = places(vectors, values)
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))


def parameters(placed: Placed, values: Values) -> np.ndarray:
    """Return a_{i-1}, α_{i-1}, d_i, θ_i of each frame as drawn, (n, 4); frame 0 lies on frame 1 (step 6)."""
    z, origins, x = placed.at(values)
    rows = [np.zeros(4)]
    for k in range(1, len(z)):
        way = origins[k] - origins[k - 1]
        rows.append(np.array([
            way @ x[k - 1], _angle(z[k - 1], z[k], x[k - 1]), way @ z[k], _angle(x[k - 1], x[k], z[k]),
        ]))  # fmt: skip
    return np.array(rows)


def _angle(one: np.ndarray, other: np.ndarray, axis: np.ndarray) -> float:
    angle = float(np.arctan2(np.cross(one, other) @ axis, one @ other))
    return np.pi if abs(angle + np.pi) < NEAR else angle


def table_of(scheme: Scheme, placed: Placed) -> tuple[LinkRows, dict[str, LinearForm]]:
    """Return the table that follows from frames, and what each joint variable of it is in the drawing."""
    usual, joints = dict(scheme.arm.lengths), scheme.arm.joints
    at = parameters(placed, usual)
    slopes = {symbol: parameters(placed, {**usual, symbol: value + 1.0}) - at for symbol, value in usual.items()}
    rows, drawn = [], {}
    for k, joint in enumerate(joints):
        forms = {
            name: linear_form(at[k, p], {s: each[k, p] for s, each in slopes.items()}, scheme.arm, angle=p in (1, 3))
            for p, name in enumerate(("a", "alpha", "d", "theta"))
        }
        column = "theta" if joint.kind == "revolute" else "d"
        drawn[joint.symbol] = forms[column]
        forms[column] = LinearForm(((joint.symbol, Fraction(1)),))
        rows.append(LinkRow(str(k + 1), str(k), joint.symbol, **forms))
    return LinkRows("modified", tuple(rows)), drawn


def is_linear(rows: LinkRows, drawn: Mapping[str, LinearForm], placed: Placed, values: Values) -> bool:
    """Whether the lengths between frames are what the table says for other lengths of the arm too: sums of its letters."""
    given = {**values, **{symbol: form.value(dict(values)) for symbol, form in drawn.items()}}
    lengths = np.array([[row.a.value(given), row.d.value(given)] for row in rows.rows])
    return bool(np.allclose(lengths, parameters(placed, values)[:, [0, 2]], atol=NEAR))
