"""Right functions of every arm, made in the styles that people write in, from the numbers of the arm's link matrices."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np
import sympy

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Entry, Rows
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.diagnosis.causes.links import CONVENTIONS, parameters
from armproof.verification.naming.quantities import numbered_frames

Function = Callable[[Any], Any]


def last_frame(arm: Arm) -> str:
    return arm.frames[-1]


@dataclass(frozen=True)
class Link:
    """^{i-1}T_i(q) = M_0 + M_1 cos q + M_2 sin q of a revolute joint, M_0 + M_1 q of a prismatic one; constant without a joint."""

    parts: tuple[np.ndarray, np.ndarray, np.ndarray]
    kind: str

    def at(self, q: Any) -> Any:
        one, first, second = self.parts
        if self.kind == "revolute":
            return one + first * np.cos(q) + second * np.sin(q)
        return one + first * q if self.kind == "prismatic" else one


def read_links(arm: Arm) -> list[Link]:
    """Return the link matrices between the arm's frames, with the joint that each holds: link k that of joint k."""
    frames = arm.frames
    links = []
    for k in range(1, len(frames)):
        kind = arm.joints[k - 1].kind if k <= len(arm.joints) else "fixed"
        q = np.zeros((3, len(arm.joints)))
        if k <= len(arm.joints):
            q[:, k - 1] = (0.0, np.pi / 2, np.pi) if kind == "revolute" else (0.0, 1.0, 0.0)
        a, b, c = np.round(NumericKinematics(arm, q).pose(frames[k], frames[k - 1]), 12)
        zero = np.zeros((4, 4))
        parts = ((a + c) / 2, (a - c) / 2, b - (a + c) / 2) if kind == "revolute" else (a, b - a, zero)
        links.append(Link(tuple(np.round(part, 12) for part in parts), kind))
    return links


def axes_of(arm: Arm) -> list[tuple[int, np.ndarray]]:
    """Return for each joint the index of a frame that it carries or stands on, and its axis in that frame."""
    q = np.full((1, len(arm.joints)), 0.7)
    J = NumericKinematics(arm, q).jacobian(last_frame(arm))[0]
    found = []
    for k, joint in enumerate(arm.joints):
        axis = J[3:, k] if joint.kind == "revolute" else J[:3, k]
        for frame in (k, k + 1):
            X = NumericKinematics(arm, q).pose(arm.frames[frame])[0]
            local = np.round(X[:3, :3].T @ axis, 9)
            to_end = NumericKinematics(arm, q).pose(last_frame(arm))[0][:3, 3] - X[:3, 3]
            fits = joint.kind == "prismatic" or np.allclose(np.cross(axis, to_end), J[:3, k])
            if fits and np.count_nonzero(local) == 1:
                found.append((frame, local))
                break
    assert len(found) == len(arm.joints)
    return found


def by_products(arm: Arm, links: Sequence[Link] | None = None, axes: Any = None) -> tuple[Function, Function]:
    """Return FK and J by products of link matrices in NumPy, J by [z × (p_n − p); z]."""
    links = links or read_links(arm)
    axes = axes or axes_of(arm)
    kinds = [joint.kind for joint in arm.joints]

    def frames(q):
        T = np.eye(4)
        found = [T]
        for k, link in enumerate(links):
            T = T @ link.at(q[k] if k < len(q) else 0.0)
            found.append(T)
        return found

    def fk(q):
        return frames(q)[-1]

    def jacobian(q):
        T = frames(q)
        J = np.zeros((6, len(q)))
        for k, (frame, axis) in enumerate(axes):
            z = T[frame][:3, :3] @ axis
            if kinds[k] == "revolute":
                J[:3, k] = np.cross(z, T[-1][:3, 3] - T[frame][:3, 3])
                J[3:, k] = z
            else:
                J[:3, k] = z
        return J

    return fk, jacobian


def entry_with(entry: Entry, lengths: dict[str, float], values: dict[str, Any], cos: Any, sin: Any, sqrt: Any) -> Any:
    """Return an exact entry written out, in whatever arithmetic the functions are of."""
    total: Any = 0
    for monomial, coefficient in entry.items():
        term: Any = float(coefficient) if coefficient.denominator != 1 else int(coefficient)
        for (kind, name), power in monomial:
            value = lengths[name] if name in lengths else values.get(name)
            if value is None and kind in ("cos", "sin"):
                value = angle_value(name)
            factor = {"cos": lambda v=value: cos(v), "sin": lambda v=value: sin(v), "symbol": lambda v=value: v,
                      "sqrt": lambda name=name: sqrt(int(name))}[kind]()  # fmt: skip
            term = term * factor**power
        total = total + term
    return total


def written_out(arm: Arm, rows: Rows, cos: Any, sin: Any, sqrt: Any, wrap: Any) -> Function:
    """Return a function with each entry written out."""
    lengths = {**arm.lengths, **arm.angles}
    symbols = [joint.symbol for joint in arm.joints]

    def function(q):
        values = dict(zip(symbols, q, strict=True))
        return wrap([[entry_with(entry, lengths, values, cos, sin, sqrt) for entry in row] for row in rows])

    return function


def exact_rows(arm: Arm, quantity: str) -> Rows:
    return trace_of(arm).pose(last_frame(arm)) if quantity == "pose" else trace_of(arm).jacobian(last_frame(arm))


def in_entries(arm: Arm, quantity: str) -> Function:
    return written_out(arm, exact_rows(arm, quantity), np.cos, np.sin, np.sqrt, np.array)


def in_math(arm: Arm, quantity: str) -> Function:
    """Plain math and lists, the entries written out by a function that looks them up in the module `math`."""
    rows, lengths, symbols = (
        exact_rows(arm, quantity),
        {**arm.lengths, **arm.angles},
        [joint.symbol for joint in arm.joints],
    )

    def cell(entry, values):
        return entry_with(entry, lengths, values, math.cos, math.sin, math.sqrt)

    def function(q):
        values = dict(zip(symbols, map(float, q), strict=True))
        return [[cell(entry, values) for entry in row] for row in rows]

    return function


def in_sympy(arm: Arm, quantity: str) -> Function:
    return written_out(arm, exact_rows(arm, quantity), sympy.cos, sympy.sin, sympy.sqrt, sympy.Matrix)


def by_table(arm: Arm) -> tuple[Function, Function] | None:
    """Return FK and J by a loop over a DH table with `math`, where the arm's frames follow a convention."""
    frames = numbered_frames(arm)
    if list(arm.frames) != frames:
        return None
    q = np.vstack([np.zeros(len(arm.joints)), np.full(len(arm.joints), 0.4)])
    links = [NumericKinematics(arm, q).pose(frames[k], frames[k - 1]) for k in range(1, len(frames))]
    for convention in CONVENTIONS:
        rows = [parameters(convention, L) for L in links]
        if any(row is None for row in rows):
            continue
        table = []
        for row, joint in zip(rows, arm.joints, strict=True):
            a, alpha, d, theta = np.round([getattr(row, name) for name in ("a", "alpha", "d", "theta")], 12)
            moves, stays = (theta, d) if joint.kind == "revolute" else (d, theta)
            if any(np.ptp(values) > 0 for values in (a, alpha, stays)):  # a joint along x, say
                return None
            sign = float(np.sign(math.sin(moves[1] - moves[0])))
            table.append((a[0], alpha[0], d[0], theta[0], sign))
        return _loop(arm, table, convention)
    return None


def _loop(arm: Arm, table: list[tuple[float, ...]], convention: str) -> tuple[Function, Function]:
    kinds = [joint.kind for joint in arm.joints]

    def rot_z(angle):
        return np.array([[math.cos(angle), -math.sin(angle), 0, 0], [math.sin(angle), math.cos(angle), 0, 0],
                         [0, 0, 1, 0], [0, 0, 0, 1]], dtype=float)  # fmt: skip

    def rot_x(angle):
        return np.array([[1, 0, 0, 0], [0, math.cos(angle), -math.sin(angle), 0],
                         [0, math.sin(angle), math.cos(angle), 0], [0, 0, 0, 1]], dtype=float)  # fmt: skip

    def shift(x, z):
        T = np.eye(4)
        T[0, 3], T[2, 3] = x, z
        return T

    def chain(q):
        T, found = np.eye(4), [np.eye(4)]
        for (a, alpha, d, theta, sign), kind, value in zip(table, kinds, q, strict=True):
            theta, d = (theta + sign * value, d) if kind == "revolute" else (theta, d + sign * value)
            about_z, about_x = rot_z(theta) @ shift(0, d), rot_x(alpha) @ shift(a, 0)
            T = T @ (about_x @ about_z if convention == "modified" else about_z @ about_x)
            found.append(T)
        return found

    def jacobian(q):
        T, columns = chain(q), []
        for k, kind in enumerate(kinds):
            frame = T[k + 1] if convention == "modified" else T[k]
            z = table[k][4] * frame[:3, 2]
            v = np.cross(z, T[-1][:3, 3] - frame[:3, 3])
            columns.append(np.hstack((v, z)) if kind == "revolute" else np.hstack((z, np.zeros(3))))
        return np.column_stack(columns)

    return lambda q: chain(q)[-1], jacobian


STYLES = ("products", "entries", "math", "sympy", "table")


def right(name: str, style: str) -> tuple[Function, Function] | None:
    """Return FK and J of an arm in a style; None where the arm has no such form."""
    arm = load_arm(name)
    if style == "products":
        return by_products(arm)
    if style == "table":
        return by_table(arm)
    write = {"entries": in_entries, "math": in_math, "sympy": in_sympy}[style]
    return write(arm, "pose"), write(arm, "jacobian")


def product(matrices: Sequence[np.ndarray]) -> np.ndarray:
    return reduce(np.matmul, matrices)
