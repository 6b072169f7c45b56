"""The right thing of another kind: transposed, inverted, of another frame, in another frame, with another sign."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from armproof.verification.algebra.quantity import COMPONENTS
from armproof.verification.diagnosis.causes.case import Candidate, Case


def inverse(X: np.ndarray) -> np.ndarray:
    """Return the inverses of homogeneous transforms, (N, 4, 4)."""
    result = np.zeros_like(X)
    R = X[:, :3, :3].transpose(0, 2, 1)
    result[:, :3, :3], result[:, :3, 3:], result[:, 3, 3] = R, -R @ X[:, :3, 3:], 1.0
    return result


def frame_candidates(case: Case) -> Iterator[Candidate]:
    """Yield what else a pose, a rotation, an origin or an axis could be taken for."""
    quantity = case.quantity
    if case.true.shape[1] == case.true.shape[2] > 1 or not case.fits:
        yield "the matrix is transposed", case.true.transpose(0, 2, 1)
    yield "the sign of the whole is wrong", -case.true
    if quantity.kind not in ("pose", "rotation", "origin", "axis"):
        return
    X = case.kinematics.pose(quantity.frame, quantity.reference)
    words = f"the inverse is computed: the pose of frame {quantity.reference} in frame {quantity.frame}"
    yield words, case.selected(inverse(X))
    turned = X.copy()
    turned[:, :3, :3] = X[:, :3, :3].transpose(0, 2, 1)
    yield "the rotation is transposed", case.selected(turned)
    yield from _axes(case, X)
    yield from _other_frames(case)
    if quantity.kind in ("pose", "origin"):
        for words, factor in (("millimetres", 1000.0), ("kilometres", 0.001)):
            scaled = X.copy()
            scaled[:, :3, 3] *= factor
            yield f"the origin is in {words}: lengths are in metres", case.selected(scaled)
    if quantity.kind == "pose":
        straight = X.copy()
        straight[:, :3, :3] = np.eye(3)
        yield "the rotation is missing: an identity stands in its place", straight
        moved = X.copy()
        moved[:, :3, 3] = 0
        yield "the origin is missing: zeros stand in its place", moved


def _axes(case: Case, X: np.ndarray) -> Iterator[Candidate]:
    quantity = case.quantity
    if quantity.kind == "axis":
        for name, column in COMPONENTS.items():
            if name != quantity.along:
                yield f"this is the {name} axis", X[:, :3, column : column + 1]
        column = COMPONENTS[quantity.along]
        yield f"this is the third row of the rotation, not its column {column + 1}", X[:, 2, :3, None]
        return
    for i, j in ((0, 1), (0, 2), (1, 2)):
        order = [0, 1, 2, 3]
        order[i], order[j] = j, i
        axes = f"{'xyz'[i]} and {'xyz'[j]}, or sine and cosine"
        yield f"rows {i + 1} and {j + 1} are swapped: {axes}", case.selected(X[:, order])
        if quantity.kind in ("pose", "rotation"):
            yield f"columns {i + 1} and {j + 1} are swapped", case.selected(X[:, :, order])
    for i, name in enumerate("xyz"):
        signs = np.ones(4)
        signs[i] = -1
        yield f"the sign of row {i + 1} is wrong", case.selected(X * signs[:, None])
        if quantity.kind in ("pose", "rotation"):
            yield f"the sign of column {i + 1}, the {name} axis, is wrong", case.selected(X * signs)


def _other_frames(case: Case) -> Iterator[Candidate]:
    quantity, arm = case.quantity, case.arm
    for frame in arm.frames:
        if frame != quantity.frame:
            words = f"this is that of frame {frame}, not {quantity.frame}"
            yield words, case.selected(case.kinematics.pose(frame, quantity.reference))
    for reference in arm.frames:
        if reference != quantity.reference:
            words = f"it is expressed in frame {reference}, not {quantity.reference}"
            yield words, case.selected(case.kinematics.pose(quantity.frame, reference))
            if quantity.kind in ("origin", "axis"):  # turned into the axes of a frame, but not moved to its origin
                turned = case.kinematics.pose(quantity.frame, quantity.reference).copy()
                R = case.kinematics.pose(reference, quantity.reference)[:, :3, :3].transpose(0, 2, 1)
                turned[:, :3] = R @ turned[:, :3]
                words = f"it is expressed in the axes of frame {reference}, not {quantity.reference}"
                yield words, case.selected(turned)


def constant_offset(case: Case) -> str:
    """Say so where the result is the right pose or point up to a constant transform at the base or at the tool."""
    if not case.fits:
        return ""
    if case.quantity.kind == "origin":
        off = case.obtained - case.true
        if np.ptp(off, axis=0).max() < 1e-9:
            values = ", ".join(f"{value:.6g}" for value in off[0].ravel())
            return f"the origin is off by the constant ({values}): an offset of the base is missing or wrong"
        return ""
    if case.quantity.kind != "pose" or case.true.shape[1:] != (4, 4):
        return ""
    for words, off in (
        ("the base frame is another: a constant transform before the first joint is missing or wrong",
         case.obtained @ inverse(case.true)),
        ("the tool frame is another: a constant transform after the last joint is missing or wrong",
         inverse(case.true) @ case.obtained),
    ):  # fmt: skip
        if np.ptp(off, axis=0).max() < 1e-9:
            return words
    return ""
