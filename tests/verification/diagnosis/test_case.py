"""What is right needs no cause: a result that differs from the arm by rounding alone, beside numbers that are large."""

from __future__ import annotations

import numpy as np
import pytest

from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.diagnosis.causes.case import Case, Explanation
from armproof.verification.findings import Kind, say


@pytest.mark.parametrize("kind", ["pose", "jacobian"])
def test_no_cause_is_sought_where_nothing_is_wrong(kind: str) -> None:
    arm = load_arm("planar_2r")
    kinematics = NumericKinematics(arm, np.array([[0.3, 0.4], [1.0, -0.2]]))
    true = kinematics.pose("2", "0") if kind == "pose" else kinematics.jacobian("2", "0", "0")
    candidates = [(say(Kind.THE_MATRIX), 2 * true)]
    right, wrong = (Case(arm, Quantity(kind, "2", "0"), kinematics, true, obtained) for obtained in (true, 2 * true))
    assert right.explained_by(candidates) == Explanation()
    assert wrong.explained_by(candidates).is_whole
