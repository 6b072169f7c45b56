"""A result of another shape than its quantity: transposed, a part of it, more than it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import Candidate, Case
from armproof.verification.findings import Finding, Kind, say


def shape_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the values that a result of this shape may have been meant for."""
    if case.fits:
        return
    flat = case.obtained.reshape(len(case.q), -1)
    if flat.shape[1] == case.true[0].size:
        for kind, values in (
            (Kind.IN_ONE_ROW, case.true),
            (Kind.IS_TRANSPOSED, case.true.transpose(0, 2, 1)),
        ):
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
