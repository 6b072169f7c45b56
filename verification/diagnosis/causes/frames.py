"""The right thing of another kind: transposed, inverted, of or in another frame, with another sign, of another shape."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from armproof.verification.algebra.quantity import COMPONENTS
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import Candidate, Case, changed
from armproof.verification.findings import Finding, Kind, say


def other_poses(case: Case) -> Iterator[Candidate]:
    """Yield what else of the arm a pose, a rotation, an origin or an axis could be taken for."""
    quantity = case.quantity
    if case.is_printed:  # of a rotation, an author swaps the indices; a function transposes
        yield from _inverted(case, Kind.INVERSE_PRINTED)
    if case.true.shape[1] == case.true.shape[2] > 1 or not case.fits:
        yield say(Kind.TRANSPOSED), case.true.transpose(0, 2, 1)
    yield say(Kind.SIGN_OF_WHOLE), -case.true
    if not case.is_printed:
        yield from _inverted(case, Kind.INVERSE_COMPUTED)
    if kind_of(quantity).matrix == "pose":
        yield from _other_frames(case)
    if quantity.kind == "axis":
        yield from _other_axes(case)
    if quantity.kind == "difference":
        yield from _other_differences(case)


def _inverted(case: Case, kind: Kind) -> Iterator[Candidate]:
    quantity = case.quantity
    if quantity.kind in ("pose", "rotation"):
        yield say(kind, reference=quantity.reference, frame=quantity.frame), case.selected(np.linalg.inv(case.whole))


def _other_frames(case: Case) -> Iterator[Candidate]:
    quantity, arm = case.quantity, case.arm
    is_pose = quantity.kind in ("pose", "rotation")
    for frame in arm.frames:
        if frame != quantity.frame:
            kind = Kind.POSE_OF_OTHER_FRAME if is_pose else Kind.OF_OTHER_FRAME
            finding = say(kind, other=frame, frame=quantity.frame)
            yield finding, case.selected(case.kinematics.pose(frame, quantity.reference))
        if frame != quantity.reference:
            kind = Kind.POSE_IN_OTHER_FRAME if is_pose else Kind.IN_OTHER_FRAME
            finding = say(kind, other=frame, reference=quantity.reference)
            yield finding, case.selected(case.kinematics.pose(quantity.frame, frame))


def _other_differences(case: Case) -> Iterator[Candidate]:
    quantity = case.quantity
    for start, frame in permutations(case.arm.frames, 2):
        # with one end right, a term is missing; the other way round is the sign of the whole
        if start != quantity.start and frame != quantity.frame and (start, frame) != (quantity.frame, quantity.start):
            p, p_start = (case.kinematics.pose(each, quantity.reference)[:, :3, 3:] for each in (frame, start))
            terms = {"other_start": start, "other": frame, "start": quantity.start, "frame": quantity.frame}
            yield say(Kind.OTHER_DIFFERENCE, **terms), p - p_start


def _other_axes(case: Case) -> Iterator[Candidate]:
    quantity, X = case.quantity, case.whole
    own = COMPONENTS[quantity.along]
    for name, column in COMPONENTS.items():
        if name != quantity.along:
            yield say(Kind.OTHER_AXIS, axis=name), X[:, :3, column : column + 1]
    yield say(Kind.ROW_FOR_COLUMN, number=own + 1), X[:, 2, :3, None]


def pose_slips(case: Case) -> Iterator[Candidate]:
    """Yield a pose, a rotation, an origin or an axis with a slip in it: a row, a sign, a unit, the rotation alone."""
    quantity = case.quantity
    if kind_of(quantity).matrix != "pose":
        return
    X, rotation, origin = case.whole, np.s_[:, :3, :3], np.s_[:, :3, 3]
    yield say(Kind.ROTATION_TRANSPOSED), case.selected(changed(X, rotation, X[rotation].transpose(0, 2, 1)))
    if quantity.kind != "axis":
        yield from _rows_and_columns(case, X)
    if quantity.kind in ("origin", "axis"):
        yield from _turned(case, X)
    if quantity.kind in ("pose", "origin"):
        for unit, factor in (("millimetres", 1000.0), ("kilometres", 0.001)):
            scaled = changed(X, origin, X[origin] * factor)
            yield say(Kind.ORIGIN_IN_OTHER_UNIT, unit=unit), case.selected(scaled)
    if quantity.kind == "pose":
        yield say(Kind.ROTATION_MISSING), changed(X, rotation, np.eye(3))
        yield say(Kind.ORIGIN_MISSING), changed(X, origin, 0)


def _rows_and_columns(case: Case, X: np.ndarray) -> Iterator[Candidate]:
    has_columns = case.quantity.kind in ("pose", "rotation")
    for i, j in ((0, 1), (0, 2), (1, 2)):
        order = [0, 1, 2, 3]
        order[i], order[j] = j, i
        finding = say(Kind.ROWS_SWAPPED, one=i + 1, other=j + 1, axis="xyz"[i], other_axis="xyz"[j])
        yield finding, case.selected(X[:, order])
        if has_columns:
            yield say(Kind.COLUMNS_SWAPPED, one=i + 1, other=j + 1), case.selected(X[:, :, order])
    for i, name in enumerate("xyz"):
        signs = np.ones(4)
        signs[i] = -1
        yield say(Kind.SIGN_OF_ROW, number=i + 1), case.selected(X * signs[:, None])
        if has_columns:
            yield say(Kind.SIGN_OF_COLUMN, number=i + 1, axis=name), case.selected(X * signs)


def _turned(case: Case, X: np.ndarray) -> Iterator[Candidate]:
    """A point or an axis turned into the axes of a frame, but not moved to its origin."""
    quantity = case.quantity
    for frame in case.arm.frames:
        if frame != quantity.reference:
            R = case.kinematics.pose(frame, quantity.reference)[:, :3, :3].transpose(0, 2, 1)
            turned = changed(X, np.s_[:, :3], R @ X[:, :3])
            yield say(Kind.IN_OTHER_AXES, other=frame, reference=quantity.reference), case.selected(turned)


def constant_offset(case: Case) -> Finding | None:
    """Return that the result is the right pose or point up to a constant transform at the base or at the tool."""
    if not case.fits:
        return None
    if case.quantity.kind == "origin":
        off = case.obtained - case.true
        is_constant = np.ptp(off, axis=0).max() < 1e-9
        return say(Kind.CONSTANT_OFFSET, values=[float(value) for value in off[0].ravel()]) if is_constant else None
    if case.quantity.kind != "pose" or case.true.shape[1:] != (4, 4):
        return None
    for kind, off in (
        (Kind.OTHER_BASE, case.obtained @ np.linalg.inv(case.true)),
        (Kind.OTHER_TOOL, np.linalg.inv(case.true) @ case.obtained),
    ):
        if np.ptp(off, axis=0).max() < 1e-9:
            return say(kind)
    return None


def shape_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the values that a result of this shape may have been meant for."""
    if case.fits:
        return
    flat = case.obtained.reshape(len(case.q), -1)
    if flat.shape[1] == case.true[0].size:
        for kind, values in ((Kind.IN_ONE_ROW, case.true), (Kind.IS_TRANSPOSED, case.true.transpose(0, 2, 1))):
            yield say(kind), values.reshape(case.obtained.shape)
    quantity = case.quantity
    if quantity.kind == "jacobian":
        J = case.whole
        for kind, part in (
            (Kind.LINEAR_PART_ALONE, J[:, :3]),
            (Kind.ANGULAR_PART_ALONE, J[:, 3:]),
            (Kind.PLANE_PART_OF_V, J[:, :2]),
            (Kind.PLANE_PART, J[:, [0, 1, 5]]),
            (Kind.WHOLE_TWIST, J),
            (Kind.ZERO_ROWS_LEFT_OUT, J[:, np.abs(J).max(axis=(0, 2)) > 1e-9]),
        ):
            yield say(kind), part
            yield say(Kind.AND_TRANSPOSED, cause=say(kind)), part.transpose(0, 2, 1)
        return
    if kind_of(quantity).matrix == "pose":
        X = case.whole
        for kind, part in (
            (Kind.IS_ROTATION, X[:, :3, :3]),
            (Kind.IS_ORIGIN, X[:, :3, 3]),
            (Kind.IS_ORIGIN, X[:, :3, 3:]),
            (Kind.IS_HOMOGENEOUS_ORIGIN, X[:, :, 3]),
            (Kind.LAST_ROW_MISSING, X[:, :3]),
            (Kind.IS_POSE, X),
            (Kind.Z_MISSING, X[:, :2, 3]),
            (Kind.IS_PLANE_POSE, X[:, [0, 1, 3]][:, :, [0, 1, 3]]),
        ):
            yield say(kind), np.asarray(part)


def permutation_cause(case: Case) -> Finding | None:
    """Say so where the rows, or the columns, are all there in another order."""
    if not case.fits:
        return None
    for kind, obtained, true in (
        (Kind.OTHER_ORDER_OF_ROWS, case.obtained, case.true),
        (Kind.OTHER_ORDER_OF_COLUMNS, case.obtained.transpose(0, 2, 1), case.true.transpose(0, 2, 1)),
    ):
        order = [
            next((k for k in range(true.shape[1]) if np.abs(true[:, k] - row).max() < 1e-9), -1)
            for row in obtained.transpose(1, 0, 2)
        ]
        if sorted(order) == list(range(len(order))):
            return say(kind, order=[k + 1 for k in order])
    return None
