"""A student's answer drawn over the arm as Drake has it: a pose, an origin, or the velocity that a joint gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.functions.arguments import constants_of, read_layout
from armproof.verification.functions.asked import read_asked
from armproof.verification.functions.guarded_call import Guard
from armproof.verification.functions.returned import NotAttempted, fit, read_returned
from armproof.verification.report.html.figures import Figure, painter_of
from armproof.verification.verdict import Discrepancy, Drawn, Record, Verdict, as_rows

SECONDS = 0.5


def draw_answer(
    arm: Arm, asked: Mapping[str, Any], function: Callable[..., Any], at: Mapping[str, float]
) -> Figure | None:
    """Return the arm at a configuration with the function's result beside the true one; None where it cannot be drawn."""
    painter = painter_of(arm, "yours")
    if painter is None:
        return None
    try:
        drawn = drawn_at(arm, asked, call_at(arm, function, at), at)
    except ArmproofError:
        return None
    if drawn is None:
        return None
    discrepancy = Discrepancy(1, (), drawn)
    return painter.at_counterexample(Record(1, "", Verdict.REFUTED, counterexample=dict(at), discrepancy=discrepancy))


def drawn_at(arm: Arm, asked: Mapping[str, Any], obtained: np.ndarray, at: Mapping[str, float]) -> Drawn | None:
    """Return what an answer is at a configuration beside what is true; None where that is nothing to draw."""
    (one,) = read_asked(arm, asked)
    quantity = one.quantity
    if quantity.kind not in ("pose", "origin", "jacobian") or quantity.reference != arm.frames[0]:
        return None
    numeric = NumericKinematics(arm, np.array([[at[joint.symbol] for joint in arm.joints]]))
    pose = np.array(numeric.pose(quantity.frame)[0])
    if quantity.kind == "jacobian":
        true = numeric.jacobian(quantity.frame)[0]
        return _velocity(quantity, true, obtained)
    claimed = pose.copy()
    if quantity.kind == "pose" and not quantity.rows:
        if (fitted := fit(obtained, (4, 4))) is None:
            return None
        claimed = fitted.values
    else:
        rows = [row - 1 for row in quantity.rows] if quantity.rows else [0, 1, 2]
        flat = obtained.ravel()
        if quantity.kind == "pose" or len(flat) < len(rows) or max(rows) > 2:
            return None
        claimed[rows, 3] = flat[: len(rows)]
    return Drawn("pose", quantity.frame, as_rows(pose), as_rows(claimed))


def _velocity(quantity: Any, true: np.ndarray, obtained: np.ndarray) -> Drawn | None:
    """Return the velocity of the first column that is wrong, linear or angular as its first wrong row."""
    claimed = claimed_jacobian(quantity, true, obtained)
    if claimed is None:
        return None
    wrong = np.argwhere(~(np.abs(claimed - true) <= 1e-9).T)
    column, row = wrong[0] if len(wrong) else (quantity.columns[0] - 1 if quantity.columns else 0, 0)
    part = slice(0, 3) if row < 3 else slice(3, 6)
    kind = "velocity" if row < 3 else "angular velocity"
    sides = as_rows(true[part, column][:, None]), as_rows(claimed[part, column][:, None])
    return Drawn(kind, quantity.frame, *sides, joint=int(column) + 1)


def claimed_jacobian(quantity: Any, true: np.ndarray, obtained: np.ndarray) -> np.ndarray | None:
    """Return the true Jacobian (6, n) with what is claimed of it in the rows and columns asked; None for another shape."""
    rows = [row - 1 for row in quantity.rows] if quantity.rows else list(range(6))
    columns = [column - 1 for column in quantity.columns] if quantity.columns else list(range(true.shape[1]))
    if obtained.shape != (len(rows), len(columns)):
        return None
    claimed = true.copy()
    claimed[np.ix_(rows, columns)] = obtained
    return claimed


def call_at(arm: Arm, function: Callable[..., Any], at: Mapping[str, float]) -> np.ndarray:
    """Return what a function of the joint values gives at a configuration; raises AnswerError where that is no array."""
    layout = read_layout(arm, function)
    values = {**constants_of(arm), **at}
    passed = [symbol for symbol in layout.lengths if symbol not in layout.defaults]
    positional, named = layout.arguments(lambda name: float(values[name]), passed)
    with Guard(SECONDS) as guard:
        call = guard.call(lambda: function(*positional, **named))
    if call.error is not None and call.error.type == "NotImplementedError":
        raise NotAttempted(call.error.message)
    if call.error is not None:
        raise AnswerError(call.error.message)
    (obtained,) = read_returned(call.value, 1)
    return obtained
