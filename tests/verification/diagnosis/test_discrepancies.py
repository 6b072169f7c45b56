"""What a refuted equation says at its counterexample: in numbers, and on the arm."""

from collections.abc import Callable

import numpy as np
import pytest

from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
POSE = r"{}^0T_2 = \begin{bmatrix} C_{12} & -S_{12} & 0 & %s \\ S_{12} & C_{12} & 0 & l_1 S_1 + l_2 S_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
ARM = {"dh": "classic", "rows": [{"a": f"l_{k}", "alpha": 0, "d": 0, "theta": f"theta_{k}"} for k in (1, 2)]}


def test_the_values_are_those_of_the_printed_and_the_true_entry(judge: Judge) -> None:
    record = judge(r"p_2 = \begin{bmatrix} l_1 C_1 - l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}", arm=ARM)
    assert record.discrepancy is not None
    at = {**load_arm(ARM).lengths, **record.counterexample}
    first, second = at["l_1"] * np.cos(at["theta_1"]), at["l_2"] * np.cos(at["theta_1"] + at["theta_2"])
    assert record.discrepancy.values[0] == pytest.approx((first - second, first + second), abs=1e-6)


@pytest.mark.parametrize("subject", ["{}^0T_2", "{}^0T_1 {}^1T_2"])
def test_a_wrong_pose_is_drawn_where_it_is_printed(judge: Judge, subject: str) -> None:
    record = judge((POSE % "l_1 C_1 - l_2 C_{12}").replace("{}^0T_2", subject), arm=ARM)
    drawn = record.discrepancy and record.discrepancy.drawn
    assert drawn is not None and (drawn.kind, drawn.frame) == ("pose", "2")
    q = [record.counterexample[joint] for joint in ("theta_1", "theta_2")]
    true, printed = np.array(drawn.true), np.array(drawn.printed)
    np.testing.assert_allclose(true, NumericKinematics(load_arm(ARM), np.array([q])).pose("2")[0], atol=1e-12)
    wrong = np.abs(true - printed) > 1e-9
    assert wrong[0, 3] and wrong.sum() == 1


def test_a_pose_in_another_frame_is_drawn_in_frame_0(judge: Judge) -> None:
    wrong = r"{}^1T_2 = \begin{bmatrix} C_2 & -S_2 & 0 & l_1 C_2 \\ S_2 & C_2 & 0 & l_2 S_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    record = judge(wrong, arm=ARM)
    assert record.discrepancy is not None and record.discrepancy.drawn is not None
    q = np.array([[record.counterexample[joint] for joint in ("theta_1", "theta_2")]])
    np.testing.assert_allclose(
        record.discrepancy.drawn.true, NumericKinematics(load_arm(ARM), q).pose("2")[0], atol=1e-12
    )


@pytest.mark.parametrize(
    ("latex", "kind"),
    [
        (
            r"J_v = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}",
            "velocity",
        ),
        (r"z_2 = \begin{bmatrix} 0 \\ 0 \\ -1 \end{bmatrix}", "axis"),
        (r"p_2 = \begin{bmatrix} l_1 C_1 \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}", "pose"),
        (r"R^0_2 = \begin{bmatrix} C_{12} & S_{12} & 0 \\ S_{12} & C_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}", "pose"),
    ],
)
def test_velocities_axes_origins_and_rotations_are_drawn(judge: Judge, latex: str, kind: str) -> None:
    record = judge(latex, arm=ARM, quantities={"J_v": {"jacobian": 2, "rows": [1, 2]}})
    assert record.verdict is Verdict.REFUTED and record.discrepancy is not None
    drawn = record.discrepancy.drawn
    assert drawn is not None and drawn.kind == kind
    assert not np.allclose(drawn.true, drawn.printed)


def test_what_is_proved_or_has_no_arm_is_not_drawn(judge: Judge) -> None:
    assert judge(POSE % "l_1 C_1 + l_2 C_{12}", arm=ARM).discrepancy is None
    general = judge(r"(a + b)^2 = a^2 + b^2", arm=None)
    assert general.discrepancy is not None and general.discrepancy.drawn is None


def test_a_side_without_a_value_at_a_probe_warns_of_nothing(judge: Judge, recwarn: pytest.WarningsRecorder) -> None:
    judge(r"a = \sqrt{x^2 - y^2} + b", r"a = \sqrt{x^2 - y^2}", arm=None)
    assert not [warning for warning in recwarn if issubclass(warning.category, RuntimeWarning)]
