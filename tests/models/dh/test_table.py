"""DH tables: the arm is the product of its elementary matrices, in both conventions, and bad tables are refused."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.dh.entry import read_entry
from armproof.models.errors import ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.exact.value import read_value, write_value
from armproof.models.numeric.plant import NumericKinematics
from tests.laws import examples
from tests.models.evaluation import evaluate_entries

ROW = {"a": "a_1", "alpha": 0, "d": 0, "theta": "theta_1"}
SCARA = {
    "dh": "classic",
    "rows": [
        {"a": "a_1", "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": "a_2", "alpha": "pi", "d": 0, "theta": "theta_2"},
        {"a": 0, "alpha": 0, "d": "d_3", "theta": 0},
        {"a": 0, "alpha": 0, "d": "d_4", "theta": "theta_4"},
    ],
}
RX90 = {
    "dh": "modified",
    "rows": [
        {"a": a, "alpha": alpha, "d": d, "theta": f"theta_{i}"}
        for i, (alpha, a, d) in enumerate(
            [(0, 0, 0), ("pi/2", 0, 0), (0, "a_3", 0), ("-pi/2", 0, "d_3"), ("pi/2", 0, 0), ("-90deg", 0, 0)], start=1
        )
    ],
}


def Rot(axis: int, angle: float) -> np.ndarray:
    T = np.eye(4)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    T[[i, j], [i, j]] = np.cos(angle)
    T[i, j], T[j, i] = -np.sin(angle), np.sin(angle)
    return T


def Trans(axis: int, distance: float) -> np.ndarray:
    T = np.eye(4)
    T[axis, 3] = distance
    return T


def product(table: dict[str, Any], arm: Arm, q: np.ndarray) -> list[np.ndarray]:
    """Return {}^0T_i for i = 0…n as the product of the four elementary matrices of each row, in floating point."""
    values = {**arm.lengths, **arm.angles, **{joint.symbol: q[joint.index - 1] for joint in arm.joints}}
    X = [np.eye(4)]
    for row in table["rows"]:
        a, alpha, d, theta = (_number(row[column], values) for column in ("a", "alpha", "d", "theta"))
        if table["dh"] == "classic":
            A = Rot(2, theta) @ Trans(2, d) @ Trans(0, a) @ Rot(0, alpha)
        else:
            A = Rot(0, alpha) @ Trans(0, a) @ Rot(2, theta) @ Trans(2, d)
        X.append(X[-1] @ A)
    return X


FIXED = {
    "base": {"xyz": [0, "b", 0.2], "rpy": [0, "pi/2", "-90deg"]},
    "rows": [
        {"a": 0, "alpha": 0, "d": "d_1", "theta": "theta_1"},
        {"a": "a_2", "alpha": "pi/2", "d": 0, "theta": "pi/2"},
        {"a": "a_3", "alpha": "beta", "d": "h", "theta": "pi/2 - theta_2"},
        {"a": 0, "alpha": 0, "d": "q_3", "theta": 0},
    ],
    "joints": ["theta_1", "theta_2", "q_3"],
    "tool": {"xyz": ["l_e", 0, 0]},
}


@pytest.mark.parametrize("dh", ["classic", "modified"])
def test_rows_without_a_joint_and_the_poses_of_base_and_tool_are_steps_of_the_product(dh: str) -> None:
    table = {**FIXED, "dh": dh}
    arm = load_arm(table)
    q = np.random.default_rng(4).uniform(-3, 3, (2, 3))
    assert arm.frames == ("B", "0", "1", "2", "3", "4", "E")
    assert [trace_of(arm).depth(frame) for frame in arm.frames] == [0, 0, 1, 1, 2, 3, 3]
    for k in range(2):
        base = Trans(1, arm.lengths["b"]) @ Trans(2, 0.2) @ Rot(2, -np.pi / 2) @ Rot(1, np.pi / 2)
        whole = base @ product(table, arm, q[k])[-1] @ Trans(0, arm.lengths["l_e"])
        np.testing.assert_allclose(NumericKinematics(arm, q).pose("E")[k], whole, atol=1e-12)
        np.testing.assert_allclose(evaluate_entries(arm, trace_of(arm).pose("E"), q)[k], whole, atol=1e-12)
    other = load_arm({**table, "base": {"xyz": [0, "b", 0.2], "rpy": [0, "-pi/2", "-90deg"]}})
    assert trace_of(other).pose("E") != trace_of(arm).pose("E")
    assert read_value(write_value(arm)).dh == arm.dh


def _number(text: object, values: dict[str, float]) -> float:
    """Evaluate an entry of the tables of these tests by Python's own arithmetic."""
    python = str(text).replace("deg", "*pi/180").replace("°", "*pi/180")
    return float(eval(python, {"pi": np.pi, **values}))  # noqa: S307 - a literal of this test


def row_strategy(i: int) -> st.SearchStrategy[dict[str, Any]]:
    length = st.sampled_from([0, 0.75, "3/4", "l_1", f"-l_{i}", "l_1 + 2*l_2", "l_2/3 - 0.1"])
    angle = st.sampled_from(
        [0, "pi/2", "-pi", "90deg", "pi/4", "2*pi/5", "-pi/12", "0.3", "alpha_1", "-alpha_1 - pi/3"]
    )
    sign = st.sampled_from(["", "-"])
    revolute = st.builds(
        lambda a, alpha, d, theta, s: {"a": a, "alpha": alpha, "d": d, "theta": f"{s}theta_{i} + {theta}"},
        length, angle, length, angle.filter(lambda text: not str(text).startswith("-")), sign,
    )  # fmt: skip
    prismatic = st.builds(
        lambda a, alpha, d, theta, s: {"a": a, "alpha": alpha, "d": f"{s}d_{i} + {d}", "theta": theta},
        length, angle, length.filter(lambda text: not str(text).startswith("-")), angle, sign,
    )  # fmt: skip
    return st.one_of(revolute, prismatic)


@st.composite
def tables(draw: st.DrawFn) -> dict[str, Any]:
    rows = [draw(row_strategy(i)) for i in range(1, draw(st.integers(1, 3)) + 1)]
    joints = [next(s for s in (f"theta_{i}", f"d_{i}") if s in str(row)) for i, row in enumerate(rows, start=1)]
    return {"dh": draw(st.sampled_from(["classic", "modified"])), "rows": rows, "joints": joints}


@examples(60)
@given(tables())
def test_the_arm_of_a_table_is_the_product_of_its_elementary_matrices(table: dict[str, Any]) -> None:
    arm = load_arm(table)
    q = np.random.default_rng(3).uniform(-3, 3, (4, len(arm.joints)))
    numeric = NumericKinematics(arm, q)
    for k in range(len(q)):
        for i, X in enumerate(product(table, arm, q[k])):
            np.testing.assert_allclose(numeric.pose(str(i))[k], X, atol=1e-12)
            np.testing.assert_allclose(evaluate_entries(arm, trace_of(arm).pose(str(i)), q)[k], X, atol=1e-12)


@pytest.mark.parametrize(("name", "table"), [("scara", SCARA), ("rx90", RX90)])
def test_the_table_of_a_document_and_the_urdf_of_its_arm_agree_exactly(name: str, table: dict[str, Any]) -> None:
    arm, other = load_arm(name), load_arm(table)
    assert other.frames == arm.frames
    for frame in arm.frames:
        assert trace_of(arm).pose(frame) == trace_of(other).pose(frame)
        assert trace_of(arm).jacobian(frame) == trace_of(other).jacobian(frame)


@pytest.mark.parametrize(
    "slip",
    [(1, "alpha", 0), (1, "alpha", "-pi/2"), (0, "a", "a_2"), (1, "theta", "-theta_2"), (2, "d", "-d_3"), (3, "d", 0)],
)
def test_a_wrong_row_of_a_table_does_not_agree(slip: tuple[int, str, object]) -> None:
    number, column, entry = slip
    rows = [dict(row) for row in SCARA["rows"]]
    rows[number][column] = entry
    wrong = load_arm({**SCARA, "rows": rows})
    assert trace_of(wrong).pose("4") != trace_of(load_arm("scara")).pose("4")


def test_classic_and_modified_read_the_same_rows_differently() -> None:
    assert trace_of(load_arm(SCARA)).pose("4") != trace_of(load_arm({**SCARA, "dh": "modified"})).pose("4")


def test_lengths_are_positive_pairwise_different_and_always_the_same() -> None:
    rows = [{"a": f"a_{i}", "alpha": f"alpha_{i}", "d": f"l_{i}", "theta": f"theta_{i}"} for i in range(1, 13)]
    arm = load_arm({"dh": "classic", "rows": rows})
    values = list(arm.lengths.values())
    assert len(set(values)) == len(values) == 24
    assert all(0.2 <= value <= 0.9 for value in values)
    assert len(set(arm.angles.values())) == 12
    assert load_arm(SCARA).lengths == load_arm({**SCARA, "joints": ["theta_1", "theta_2", "d_3", "theta_4"]}).lengths


def test_joints_are_found_where_they_stand() -> None:
    arm = load_arm(SCARA)
    assert [(joint.symbol, joint.kind) for joint in arm.joints] == [
        ("theta_1", "revolute"), ("theta_2", "revolute"), ("d_3", "prismatic"), ("theta_4", "revolute"),
    ]  # fmt: skip
    rows = [{"a": 0, "alpha": 0, "d": "r", "theta": "beta"}, {"a": 0, "alpha": 0, "d": "l + d_2", "theta": "phi"}]
    assert [joint.symbol for joint in load_arm({"dh": "classic", "rows": rows}).joints] == ["r", "d_2"]
    listed = load_arm({"dh": "classic", "rows": rows[1:], "joints": ["phi"]})
    assert listed.joints[0].kind == "revolute" and set(listed.lengths) == {"l", "d_2"}


@pytest.mark.parametrize(
    ("row", "message"),
    [
        (1, "row 1: a row has the keys a, alpha, d, theta, not 1"),
        ({"a": 0}, "row 1: a row has the keys a, alpha, d, theta, not a"),
        ({**ROW, "b": 1}, "row 1: a row has the keys a, alpha, d, theta, not a, alpha, d, theta, b"),
        ({**ROW, "a": None}, r"row 1, a: None is not a finite number or a text; an entry reads 0, 0\.75, 3/4"),
        ({**ROW, "a": True}, "row 1, a: True is not a finite number"),
        ({**ROW, "a": float("nan")}, "row 1, a: nan is not a finite number"),
        ({**ROW, "a": ""}, "row 1, a: '' is unreadable: it is empty"),
        ({**ROW, "a": "1 +"}, r"row 1, a: '1 \+' is unreadable: it ends too early"),
        ({**ROW, "a": "(1"}, r"a '\)' is missing"),
        ({**ROW, "a": "1 2"}, "'2' is not expected here"),
        ({**ROW, "a": "1)"}, r"'\)' is not expected here"),
        ({**ROW, "a": "sqrt(2)"}, "'sqrt' is not expected here"),
        ({**ROW, "theta": "2 cos theta_1"}, "'cos' is not expected here"),
        ({**ROW, "a": "a_1*b_1"}, "a product of two symbols is not linear"),
        ({**ROW, "a": "1/a_1"}, "only a number other than 0 divides"),
        ({**ROW, "a": "1/0"}, "only a number other than 0 divides"),
        ({**ROW, "a": "__import__('os')"}, "'_' is not understood"),
        ({**ROW, "a": "9e9999"}, "a number is too large or too small"),
        ({**ROW, "a": "(" * 5000}, "is unreadable: it is nested too deeply"),
        ({**ROW, "a": "pi deg"}, "degrees follow a number"),
        ({**ROW, "a": "pi"}, "row 1, a: 'pi' is an angle; a is a length"),
        ({**ROW, "alpha": 90}, "row 1, alpha: '90' is more than a turn in radians; write 90deg"),
        ({**ROW, "alpha": 1.5708}, "row 1, alpha: '1.5708' is nearly pi/2, which no equation can match; write pi/2"),
        ({**ROW, "theta": "theta_1 - 3.1416"}, r"is nearly -pi, which no equation can match; write -pi"),
        ({**ROW, "alpha": "b/2"}, "row 1, alpha: 'b' has the factor 1/2; an angle takes each symbol a whole number of times"),
        ({**ROW, "theta": "0"}, r"row 1: the joint variable is neither in theta \(theta_i, q_i\) nor in d; list them"),
        ({**ROW, "theta": "theta_1 + theta_2"}, "row 1: the joint variable could be theta_1 or theta_2; list them"),
        ({**ROW, "theta": "2*theta_1"}, "row 1: 'theta_1' has the factor 2; a joint variable enters as theta_1 or -theta_1"),
        ({**ROW, "d": "theta_1"}, "row 1: its joint variable 'theta_1' stands in d and theta"),
        ({**ROW, "alpha": "a_1"}, "'a_1' stands in a length and in an angle"),
    ],
)  # fmt: skip
def test_a_bad_row_is_refused_with_its_number(row: object, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        load_arm({"dh": "classic", "rows": [row]})


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ({"dh": "standard", "rows": [ROW]}, "dh is classic or modified, not 'standard'"),
        ({"rows": [ROW]}, "dh is classic or modified, not None"),
        ({"dh": "classic"}, "rows is a list of rows, base to tool, not None"),
        ({"dh": "classic", "rows": [{"a": 0, "alpha": 0, "d": 0, "theta": "q_1"}], "first": -1}, "0 or more, not -1"),
        ({"dh": "classic", "rows": []}, "rows is a list of rows"),
        ({"dh": "classic", "rows": [ROW], "link": 1}, "unknown key 'link'; the keys are dh, rows, joints"),
        ({"dh": "classic", "rows": [ROW, ROW]}, "row 2: 'theta_1' is the joint variable of row 1 already"),
        ({"dh": "classic", "rows": [ROW], "joints": "theta_1"}, "'joints' is a list of joint variables, not 'theta_1'"),
        ({"dh": "classic", "rows": [ROW], "joints": ["q"]}, "row 1: its joint variable 'q' stands nowhere"),
        ({"dh": "classic", "rows": [ROW], "joints": ["q", "r"]}, r"1 rows but 2 joints \(q, r\); each stands in a row"),
        (
            {"dh": "classic", "rows": [ROW, {**ROW, "theta": "theta_2", "d": "theta_1"}]},
            "row 2: d holds 'theta_1', the joint variable of row 1; a joint variable stands in one row",
        ),
        ({**FIXED, "dh": "classic", "joints": ["theta_1", "q_3"]}, "4 rows but 2 joints"),
        ({**FIXED, "dh": "classic", "joints": ["theta_2", "theta_1", "q_3"]}, "4 rows but 3 joints"),
        ({**FIXED, "dh": "classic", "frames": ["B", 0, 1, 2, 3, 4]}, "a list of 7 different names"),
        ({**FIXED, "dh": "classic", "tool": {"xyz": [0, 0]}}, r"tool is a pose with xyz, rpy, three entries each"),
        ({**FIXED, "dh": "classic", "tool": {"xyz": [0, 0, "pi"]}}, "tool: .* does not fit: xyz holds lengths"),
        ({"dh": "classic", "rows": [{**ROW, "a": object()}]}, "a DH table holds numbers and texts only"),
    ],
)
def test_a_bad_table_is_refused(table: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        load_arm(table)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (0, 0), (0.75, 0.75), ("3/4", 0.75), ("pi/2", np.pi / 2), ("-pi", -np.pi), ("90deg", np.pi / 2), ("-90°", -np.pi / 2),
        ("x", 2), ("-x", -2), ("x + y", 5), ("2x - y/3", 3), ("-(x - 1)*2", -2), ("2*pi/5", 0.4 * np.pi), ("1.5e-1", 0.15),
        ("π/3 + 30 deg", np.pi / 2), ("0.5(x + y)", 2.5), (".5", 0.5), ("+x", 2), ("x - x", 0), ("--x", 2),
    ],
)  # fmt: skip
def test_entries_read_as_they_are_written(text: object, value: float) -> None:
    assert read_entry(text).value({"x": 2.0, "y": 3.0}) == pytest.approx(value, abs=1e-15)
