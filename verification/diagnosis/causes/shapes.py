"""A result of another shape than its quantity: transposed, a part of it, more than it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from armproof.verification.diagnosis.causes.case import Candidate, Case


def shape_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the values that a result of this shape may have been meant for."""
    if case.fits:
        return
    flat = case.obtained.reshape(len(case.q), -1)
    if flat.shape[1] == case.true[0].size:
        for words, values in (
            ("its entries are in one row", case.true),
            ("it is transposed", case.true.transpose(0, 2, 1)),
        ):
            yield words, values.reshape(case.obtained.shape)
    quantity = case.quantity
    if quantity.kind == "jacobian":
        J = case.kinematics.jacobian(quantity.frame, quantity.reference, case.arm.frames[0])
        for words, part in (
            ("it is the linear part alone, without the rows of ω", J[:, :3]),
            ("it is the angular part alone, without the rows of v", J[:, 3:]),
            ("it is the plane part of v alone", J[:, :2]),
            ("it is the plane part: v_x, v_y, ω_z", J[:, [0, 1, 5]]),
            ("it is the whole of [v; ω]", J),
            ("its rows of zeros are left out", J[:, np.abs(J).max(axis=(0, 2)) > 1e-9]),
        ):
            yield words, part
            yield f"{words}, transposed", part.transpose(0, 2, 1)
        return
    if quantity.kind in ("pose", "rotation", "origin", "axis"):
        X = case.kinematics.pose(quantity.frame, quantity.reference)
        for words, part in (
            ("it is the rotation alone", X[:, :3, :3]),
            ("it is the origin alone", X[:, :3, 3]),
            ("it is the origin alone", X[:, :3, 3:]),
            ("it is the origin alone, in homogeneous coordinates", X[:, :, 3]),
            ("the last row 0 0 0 1 is missing", X[:, :3]),
            ("it is the whole pose", X),
            ("the z coordinate is missing", X[:, :2, 3]),
            ("it is the pose in the plane", X[:, [0, 1, 3]][:, :, [0, 1, 3]]),
        ):
            yield words, np.asarray(part)


def permutation_cause(case: Case) -> str:
    """Say so where the rows, or the columns, are all there in another order."""
    if not case.fits:
        return ""
    for name, obtained, true in (
        ("rows", case.obtained, case.true),
        ("columns", case.obtained.transpose(0, 2, 1), case.true.transpose(0, 2, 1)),
    ):
        order = [
            next((k for k in range(true.shape[1]) if np.abs(true[:, k] - row).max() < 1e-9), -1)
            for row in obtained.transpose(1, 0, 2)
        ]
        if sorted(order) == list(range(len(order))):
            return f"the {name} stand in the wrong order: {', '.join(str(k + 1) for k in order)}"
    return ""
