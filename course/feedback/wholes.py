"""What a whole answer is instead of what is asked: a part of it, more than it, or that of a planar arm."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from armproof.course.feedback.relation import Letters, Values, same, wrong_entries
from armproof.models.arm import Arm
from armproof.models.errors import written
from armproof.models.language import look_up
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.latex.writer import symbol_as_latex

_STEPS = 5  # of an angle round its circle: enough for its sine, its cosine, and their squares
_SMALL = 1e-9
_PARALLEL = 1e-6
_MOST_ENTRIES = 6  # that are wrong in a rotation, where entry by entry something may be said


def part_astray(true: np.ndarray, obtained: np.ndarray) -> str:
    """Say which rows or columns of what is asked an answer of another size holds; empty where it is no part of it.

    Args:
        true, obtained: what is asked and what is given, (samples, rows, columns).
    """
    obtained = obtained[..., None] if obtained.ndim == 2 else obtained
    if obtained.ndim != 3 or obtained.shape[1:] == true.shape[1:] or min(obtained.shape[1:]) == 0:
        return ""
    if obtained.shape[2] == true.shape[2] and (rows := _chosen_rows(obtained, true)):
        return written("right, but only a part: rows {rows} of what is asked; the rest is missing", rows=rows)
    is_less = all(mine <= asked for mine, asked in zip(obtained.shape[1:], true.shape[1:], strict=True))
    is_more = all(mine >= asked for mine, asked in zip(obtained.shape[1:], true.shape[1:], strict=True))
    if is_less and (place := _place_of(obtained, true)):
        return written("right, but only a part: {place} of what is asked; the rest is missing", place=place)
    if is_more and true[0].size > 1 and (place := _place_of(true, obtained)):
        return written("{place} of your answer are right; the rest does not belong", place=place)
    return ""


def _chosen_rows(part: np.ndarray, whole: np.ndarray) -> list[int]:
    """Return which rows of a matrix, not all next to each other, are those of a smaller one; none where they are not."""
    rows, start = [], 0
    for row in range(part.shape[1]):
        found = next((k for k in range(start, whole.shape[1]) if same(part[:, row], whole[:, k])), None)
        if found is None:
            return []
        rows.append(found + 1)
        start = found + 1
    return rows if rows[-1] - rows[0] >= len(rows) else []


def _place_of(part: np.ndarray, whole: np.ndarray) -> str:
    """Return which rows or columns of a matrix are a smaller one."""
    (rows, columns), (height, width) = part.shape[1:], whole.shape[1:]
    for top in range(height - rows + 1):
        for left in range(width - columns + 1):
            if same(part, whole[:, top : top + rows, left : left + columns]):
                places = [
                    _range(look_up("row {first}"), look_up("rows {first} to {last}"), top, rows, height),
                    _range(look_up("column {first}"), look_up("columns {first} to {last}"), left, columns, width),
                ]
                return ", ".join(filter(None, places))
    return ""


def _range(one: str, several: str, start: int, count: int, of: int) -> str:
    """Return the words for a range of rows; empty for all of them."""
    if count == of:
        return ""
    return (one if count == 1 else several).format(first=start + 1, last=start + count)


def no_rotation(true: np.ndarray, obtained: np.ndarray) -> str:
    """Say that the rotation of a pose is none, where most of its entries are wrong, so that no entry tells the mistake; "" otherwise."""
    if true.shape[1:] not in ((3, 3), (4, 4)) or obtained.shape != true.shape:
        return ""
    asked, given = true[:, :3, :3], obtained[:, :3, :3]
    if wrong_entries(asked, given).sum() < _MOST_ENTRIES or not same(_products(asked), np.zeros_like(asked)):
        return ""
    off = np.abs(_products(given)).max(axis=0)
    if np.diag(off).max() > _PARALLEL:
        return look_up(
            "the rotation block is no rotation: its columns have not the length 1. Is each link matrix a rotation?"
        )
    if off.max() > _PARALLEL:
        return look_up("the rotation block is no rotation: its columns are not at right angles to each other. Is each link matrix a rotation?")  # fmt: skip
    if np.linalg.det(given).max() < 0:
        return look_up("the rotation block is a mirror: its determinant is −1. Is each link matrix a rotation?")
    return ""


def _products(R: np.ndarray) -> np.ndarray:
    """Return RᵀR less the identity, of each sample."""
    return np.asarray(R.transpose(0, 2, 1) @ R - np.eye(3))


def planar_astray(arm: Arm, asked: Values, given: Values, at: Letters) -> str:
    """Say that the angles of two joints are added, as in a planar arm, though their axes are not parallel; empty where they are not.

    cos(θ_1 + θ_2) has the sum of the angles alone; what perpendicular axes give has sum and difference alike.
    """
    wrong, pairs = wrong_entries(asked(at), given(at)), _skew_pairs(arm)
    if not pairs:
        return ""
    grids = [_round(at, one, other) for one, other in pairs]
    together = {name: np.concatenate([grid[name] for grid in grids]) for name in at}
    sides = [np.split(side(together)[:, wrong], len(pairs)) for side in (asked, given)]
    for (one, other), *both in zip(pairs, *sides, strict=True):
        true, obtained = map(_frequencies, both)
        mine, theirs = (np.abs(each).max(initial=0) for each in (obtained[0] - obtained[1], true[0] - true[1]))
        if mine > _SMALL and not theirs > _SMALL and np.abs(obtained[1]).max() < _SMALL:
            return written(
                "the angles {one} and {other} are added, as in a planar arm: their axes are not parallel here, so that each keeps its own sine and cosine",
                one=symbol_as_latex(one), other=symbol_as_latex(other),
            )  # fmt: skip
    return ""


def _skew_pairs(arm: Arm) -> list[tuple[str, str]]:
    """Return the neighbouring turning joints whose axes are not parallel, at a generic configuration."""
    joints = [joint for joint in arm.joints if joint.kind == "revolute"]
    q = np.full((1, len(arm.joints)), 0.7)
    J = NumericKinematics(arm, q).jacobian(arm.frames[-1], arm.frames[0], arm.frames[0])[0]
    axes: Mapping[str, np.ndarray] = {joint.symbol: J[3:, joint.index - 1] for joint in joints}
    return [
        (one.symbol, other.symbol)
        for one, other in pairwise(joints)
        if np.linalg.norm(np.cross(axes[one.symbol], axes[other.symbol])) > _PARALLEL
    ]


def _round(at: Letters, one: str, other: str) -> dict[str, np.ndarray]:
    """Return two angles at all pairs of so many steps round the circle, all other letters at one value each."""
    steps = np.arange(_STEPS) * 2 * np.pi / _STEPS
    first, second = (each.ravel() for each in np.meshgrid(steps, steps, indexing="ij"))
    fixed = {name: np.full(len(first), values[0]) for name, values in at.items()}
    return {**fixed, one: first, other: second}


def _frequencies(values: np.ndarray) -> Sequence[np.ndarray]:
    """Return how much of the sum and how much of the difference of the two angles is in values over the grid, (samples, entries)."""
    spectrum = np.fft.fft2(np.nan_to_num(values).reshape(_STEPS, _STEPS, -1), axes=(0, 1))
    return np.abs(spectrum[1, 1]), np.abs(spectrum[1, -1])
