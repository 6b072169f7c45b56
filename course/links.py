"""Link matrices and elementary transforms: what answers of the tasks are made of, beside those that students are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np


def modified_link(a: Any, alpha: Any, d: Any, theta: Any) -> np.ndarray:
    """Return Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d), (4, 4); a and α are those of the link before (rad, m)."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st, 0, a], [st * ca, ct * ca, -sa, -d * sa], [st * sa, ct * sa, ca, d * ca], [0, 0, 0, 1]])


def classic_link(a: Any, alpha: Any, d: Any, theta: Any) -> np.ndarray:
    """Return Rot_z(θ) Trans_z(d) Trans_x(a) Rot_x(α), (4, 4); (rad, m)."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -ca * st, sa * st, a * ct], [st, ca * ct, -sa * ct, a * st], [0, sa, ca, d], [0, 0, 0, 1]])


def product(rows: Iterable[Sequence[Any]], link: Callable[..., np.ndarray] = modified_link) -> np.ndarray:
    """Return the product of the link matrices of a table, (4, 4); each row is (a, α, d, θ)."""
    X = np.eye(4)
    for row in rows:
        X = X @ link(*row)
    return X


def turn(sp: Any, axis: str, angle: Any) -> Any:
    """Return the rotation about an axis as a SymPy matrix, 4×4."""
    c, s = sp.cos(angle), sp.sin(angle)
    rows = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return sp.diag(sp.Matrix(rows[axis]), 1)


def shift(sp: Any, x: Any = 0, y: Any = 0, z: Any = 0) -> Any:
    """Return the translation by (x, y, z) as a SymPy matrix, 4×4."""
    return sp.Matrix([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])
