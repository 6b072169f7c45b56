"""The ten arms against the closed forms of their documents: proved, and equal to the double plant and to AutoDiff.

Forward kinematics {}^{base}T_{tool} and the geometric Jacobian [v; ω] of the tool's origin in the base frame, written by hand.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydrake.autodiffutils import ExtractGradient, ExtractValue, InitializeAutoDiff

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.numeric.configurations import sample
from armproof.models.numeric.drake_arm import drake_of, frame_of, plant_of
from armproof.verification.check import DocumentChecker
from armproof.verification.document import Display, Document
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.verdict import DocumentResult, Record, Verdict

TOLERANCE = 1e-12  # for configurations up to 1; scaled by their size beyond


@dataclass(frozen=True)
class ClosedForm:
    """An arm's frames of base and tool, definitions, and the closed forms of pose and Jacobian."""

    tool: str
    pose: str
    jacobian: str
    base: str = "0"
    definitions: tuple[str, ...] = ()

    @property
    def front(self) -> dict[str, Any]:
        return {
            "quantities": {"X": {"pose": self.tool, "in": self.base}, "J": {"jacobian": self.tool, "in": self.base}}
        }


def matrix(*rows: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


def planar(x: str, y: str, angle: str, height: str = "0", tool: str = "up") -> str:
    """Return the pose of a tool that turns about the vertical, its z axis up or down."""
    c, s = rf"\cos({angle})", rf"\sin({angle})"
    if tool == "up":
        return matrix(f"{c} & -{s} & 0 & {x}", f"{s} & {c} & 0 & {y}", f"0 & 0 & 1 & {height}", "0 & 0 & 0 & 1")
    return matrix(f"{c} & {s} & 0 & {x}", f"{s} & -{c} & 0 & {y}", f"0 & 0 & -1 & {height}", "0 & 0 & 0 & 1")


SCARA_X, SCARA_Y = "a_1 c_1 + a_2 c_{12}", "a_1 s_1 + a_2 s_{12}"
SCARA_J = matrix(
    "-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0", "a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0", "0 & 0 & -1 & 0",
    "0 & 0 & 0 & 0", "0 & 0 & 0 & 0", "1 & 1 & 0 & -1",
)  # fmt: skip
ZEROS = ("0 & 0 & 0",) * 3

CLOSED_FORMS = {
    "planar_2r": ClosedForm(
        "2",
        planar("l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}", r"\theta_1 + \theta_2"),
        matrix("-l_1 s_1 - l_2 s_{12} & -l_2 s_{12}", "l_1 c_1 + l_2 c_{12} & l_2 c_{12}", "0 & 0", "0 & 0", "0 & 0", "1 & 1"),
    ),
    "planar_3r": ClosedForm(
        "3",
        planar("l_1 c_1 + l_2 c_{12} + l_3 c_{123}", "l_1 s_1 + l_2 s_{12} + l_3 s_{123}", r"\theta_1 + \theta_2 + \theta_3"),
        matrix(
            "-l_1 s_1 - l_2 s_{12} - l_3 s_{123} & -l_2 s_{12} - l_3 s_{123} & -l_3 s_{123}",
            "l_1 c_1 + l_2 c_{12} + l_3 c_{123} & l_2 c_{12} + l_3 c_{123} & l_3 c_{123}",
            *ZEROS, "1 & 1 & 1",
        ),
    ),
    "polar_rp": ClosedForm(
        "2",
        planar(r"r\cos\theta", r"r\sin\theta", r"\theta"),
        matrix(r"-r\sin\theta & \cos\theta", r"r\cos\theta & \sin\theta", "0 & 0", "0 & 0", "0 & 0", "1 & 0"),
    ),
    "scara": ClosedForm("4", planar(SCARA_X, SCARA_Y, r"\theta_1 + \theta_2 - \theta_4", "-d_3 - d_4", "down"), SCARA_J),
    "scara_column": ClosedForm("4", planar(SCARA_X, SCARA_Y, r"\theta_1 + \theta_2 - \theta_4", "d_1 - d_3 - d_4", "down"), SCARA_J),
    "scara_modified": ClosedForm(
        "4",
        planar("a_2 c_1 + a_3 c_{12}", "a_2 s_1 + a_3 s_{12}", r"\theta_1 + \theta_2 + \theta_4", "-d_2"),
        matrix(
            "-a_2 s_1 - a_3 s_{12} & -a_3 s_{12} & 0 & 0", "a_2 c_1 + a_3 c_{12} & a_3 c_{12} & 0 & 0", "0 & 0 & -1 & 0",
            "0 & 0 & 0 & 0", "0 & 0 & 0 & 0", "1 & 1 & 0 & 1",
        ),
    ),
    "spherical_wrist": ClosedForm(
        "6",
        matrix(
            "c_4 c_5 c_6 - s_4 s_6 & -c_4 c_5 s_6 - s_4 c_6 & c_4 s_5 & d_6 c_4 s_5",
            "s_4 c_5 c_6 + c_4 s_6 & -s_4 c_5 s_6 + c_4 c_6 & s_4 s_5 & d_6 s_4 s_5",
            "-s_5 c_6 & s_5 s_6 & c_5 & d_6 c_5", "0 & 0 & 0 & 1",
        ),
        matrix(
            "-d_6 s_4 s_5 & d_6 c_4 c_5 & 0", "d_6 c_4 s_5 & d_6 s_4 c_5 & 0", "0 & -d_6 s_5 & 0",
            "0 & -s_4 & c_4 s_5", "0 & c_4 & s_4 s_5", "1 & 0 & c_5",
        ),
        base="3",
    ),
    "spatial_rrr": ClosedForm(
        "P",
        matrix(
            r"c_1 c_{23} & s_1 & c_1 s_{23} & c_1 \rho", r"s_1 c_{23} & -c_1 & s_1 s_{23} & s_1 \rho",
            "s_{23} & 0 & -c_{23} & l_1 + l_2 s_2 - l_3 c_{23}", "0 & 0 & 0 & 1",
        ),
        matrix(
            r"-s_1 \rho & c_1 (l_3 c_{23} - l_2 s_2) & l_3 c_1 c_{23}", r"c_1 \rho & s_1 (l_3 c_{23} - l_2 s_2) & l_3 s_1 c_{23}",
            r"0 & \rho & l_3 s_{23}", "0 & s_1 & s_1", "0 & -c_1 & -c_1", "1 & 0 & 0",
        ),
        definitions=(r"\rho = l_2 c_2 + l_3 s_{23}",),
    ),
    "rx90": ClosedForm(
        "6",
        matrix(
            r"R_z(\theta_1) R_x(\tfrac{\pi}{2}) R_z(\theta_2 + \theta_3) R_x(-\tfrac{\pi}{2}) R_z(\theta_4) R_x(\tfrac{\pi}{2})"
            r" R_z(\theta_5) R_x(-\tfrac{\pi}{2}) R_z(\theta_6) & " + matrix("c_1 e", "s_1 e", "f"),
            "0 & 1",
        ),
        matrix(
            "-s_1 e & -c_1 f & -d_3 c_1 c_{23} & 0 & 0 & 0", "c_1 e & -s_1 f & -d_3 s_1 c_{23} & 0 & 0 & 0",
            "0 & e & -d_3 s_{23} & 0 & 0 & 0",
            "0 & s_1 & s_1 & -c_1 s_{23} & c_1 c_{23} s_4 + s_1 c_4 & -c_1 (c_{23} c_4 s_5 + s_{23} c_5) + s_1 s_4 s_5",
            "0 & -c_1 & -c_1 & -s_1 s_{23} & s_1 c_{23} s_4 - c_1 c_4 & -s_1 (c_{23} c_4 s_5 + s_{23} c_5) - c_1 s_4 s_5",
            "1 & 0 & 0 & c_{23} & s_{23} s_4 & c_{23} c_5 - s_{23} c_4 s_5",
        ),
        definitions=("e = a_3 c_2 - d_3 s_{23}", "f = a_3 s_2 + d_3 c_{23}"),
    ),
    "kr210": ClosedForm(
        "G",
        matrix(
            r"R_z(\theta_1) R_y(\theta_2 + \theta_3) R_x(\theta_4) R_y(\theta_5) R_x(\theta_6) & " + matrix("x", "y", "h"), "0 & 1",
        ),
        matrix(
            r"\begin{matrix} -y \\ x \\ 0 \end{matrix} & \begin{matrix} c_1 (h - d_1 - d_2) \\ s_1 (h - d_1 - d_2) \\ a_1 - \rho \end{matrix}"
            r" & \begin{matrix} c_1 (h - d_1 - d_2 - a_2 c_2) \\ s_1 (h - d_1 - d_2 - a_2 c_2) \\ a_1 + a_2 s_2 - \rho \end{matrix}"
            r" & D f \times e & D g \times e & 0",
            r"\begin{matrix} 0 \\ 0 \\ 1 \end{matrix} & \begin{matrix} -s_1 \\ c_1 \\ 0 \end{matrix} & \begin{matrix} -s_1 \\ c_1 \\ 0 \end{matrix} & f & g & e",
        ),
        definitions=(
            "D = d_6 + d_G", "u = c_{23} c_5 - s_{23} c_4 s_5", "w = s_{23} c_5 + c_{23} c_4 s_5",
            r"\rho = a_1 + a_2 s_2 + (d_4 + d_5) c_{23} - a_3 s_{23} + D u",
            "h = d_1 + d_2 + a_2 c_2 - (d_4 + d_5) s_{23} - a_3 c_{23} - D w",
            r"x = c_1 \rho - D s_1 s_4 s_5", r"y = s_1 \rho + D c_1 s_4 s_5",
            "e = " + matrix("c_1 u - s_1 s_4 s_5", "s_1 u + c_1 s_4 s_5", "-w"),
            "f = " + matrix("c_1 c_{23}", "s_1 c_{23}", "-s_{23}"),
            "g = " + matrix("c_1 s_{23} s_4 - s_1 c_4", "s_1 s_{23} s_4 + c_1 c_4", "c_{23} s_4"),
        ),
    ),
}  # fmt: skip

arms = pytest.mark.parametrize("name", CLOSED_FORMS)


def checker(name: str, *displays: str, confirm: bool = True) -> DocumentChecker:
    closed = CLOSED_FORMS[name]
    lines = [Display(line, latex) for line, latex in enumerate((*closed.definitions, *displays), 1)]
    return DocumentChecker(Document(Path(f"{name}.md"), closed.front, tuple(lines), ()), load_arm(name), confirm)


@cache
def result(name: str) -> DocumentResult:
    """Return the verdicts of the definitions, the pose and the Jacobian of an arm."""
    closed = CLOSED_FORMS[name]
    return checker(name, f"X = {closed.pose}", f"J = {closed.jacobian}").run()


def judge(name: str, *displays: str) -> list[Record]:
    return list(checker(name, *displays, confirm=False).run().equations[-len(displays) :])


def test_every_arm_of_the_catalogue_has_its_closed_forms() -> None:
    assert set(CLOSED_FORMS) == set(arm_names())


@arms
def test_the_closed_forms_are_proved(name: str) -> None:
    *definitions, pose, jacobian = result(name).equations
    assert [record.verdict for record in definitions] == [Verdict.DEFINED] * len(definitions)
    assert pose.verdict is Verdict.PROVED, pose.message
    assert jacobian.verdict is Verdict.PROVED, jacobian.message
    assert not pose.message and not jacobian.message  # all 16 and all 6n entries: in no smaller reading


@arms
def test_the_closed_forms_are_those_of_the_double_plant_at_a_thousand_configurations(name: str) -> None:
    for record in result(name).equations[-2:]:
        assert record.samples == 1000 and record.max_error is not None and record.max_error <= TOLERANCE


@arms
def test_the_closed_jacobian_is_the_derivative_of_the_plants_forward_kinematics(name: str) -> None:
    arm, closed = load_arm(name), CLOSED_FORMS[name]
    printed = values(name, closed.jacobian)
    derivative = np.stack([differentiated(arm, closed, q) for q in configurations(arm)])
    size = np.maximum(1.0, np.abs(configurations(arm)).max(axis=1))[:, None, None]
    assert (np.abs(printed - derivative) / size).max() <= TOLERANCE
    turned = printed * np.where(np.arange(printed.shape[2]) == 0, -1.0, 1.0)
    assert (np.abs(turned - derivative) / size).max() > 0.1


@arms
def test_one_joint_the_other_way_is_caught_and_named(name: str) -> None:
    jacobian, arm = CLOSED_FORMS[name].jacobian, load_arm(name)
    count = len(arm.joints)
    for k, joint in enumerate(arm.joints):
        signs = ", ".join("-1" if i == k else "1" for i in range(count))
        shown, wrong = f"J = {jacobian}", rf"J = {jacobian} \operatorname{{diag}}({signs})"
        _, record = judge(name, shown, wrong)  # what shorthands say may be the mistake, where nothing holds with them
        assert record.verdict is Verdict.REFUTED
        assert {entry.column for entry in record.entries} == {k + 1}
        assert (
            len(record.entries) == 1 or record.message == f"column {k + 1}: joint {joint.symbol} is taken the other way"
        )


@arms
def test_one_mirrored_axis_is_caught(name: str) -> None:
    pose = CLOSED_FORMS[name].pose
    mirror = r"\operatorname{diag}(1, -1, 1, 1)"
    (_, before), (_, after) = (
        judge(name, f"X = {pose}", f"X = {turned}") for turned in (f"{mirror} {pose}", f"{pose} {mirror}")
    )  # of two, what both rest on may be the mistake
    assert before.verdict is after.verdict is Verdict.REFUTED
    assert {entry.row for entry in before.entries} == {2} and {entry.column for entry in after.entries} == {2}


# -- the two other routes ------------------------------------------------------------------------------------------------------


@cache
def configurations(arm: Arm) -> np.ndarray:
    return sample(arm, 1000, np.random.default_rng(31))[0]


def values(name: str, latex: str) -> np.ndarray:
    """Return a closed form in NumPy at the configurations, (N, rows, columns)."""
    document = checker(name)
    document.run()
    arm = load_arm(name)
    sampled = document.sampled().at({joint.symbol: configurations(arm)[:, k] for k, joint in enumerate(arm.joints)})
    value = Evaluator(document.names, sampled).evaluate(document.names.reader.read_expression(latex))
    stacked = np.array([[np.broadcast_to(cell, (1000,)) for cell in row] for row in value.rows])
    return np.moveaxis(stacked, -1, 0)


@cache
def autodiff(arm: Arm) -> tuple[Any, Any]:
    plant = plant_of(arm).ToAutoDiffXd()
    return plant, plant.CreateDefaultContext()


def differentiated(arm: Arm, closed: ClosedForm, q: np.ndarray) -> np.ndarray:
    """Return dFK/dq as [v; ω] by AutoDiff: columns of dp/dq, and ω from dR/dq Rᵀ."""
    plant, context = autodiff(arm)
    base, tool = (plant.get_frame(frame_of(arm, frame).index()) for frame in (closed.base, closed.tool))
    positions = np.zeros(plant.num_positions())
    positions[list(drake_of(arm).position_indices)] = q
    plant.SetPositions(context, InitializeAutoDiff(positions).ravel())
    X = plant.CalcRelativeTransform(context, base, tool).GetAsMatrix4()
    R = ExtractValue(X[:3, :3])
    gradient = np.asarray(ExtractGradient(X[:3].reshape(-1, 1))).reshape(3, 4, -1)[:, :, drake_of(arm).position_indices]
    angular = np.einsum("ikq,jk->ijq", gradient[:, :3], R)
    return np.stack([*gradient[:, 3], angular[2, 1], angular[0, 2], angular[1, 0]])
