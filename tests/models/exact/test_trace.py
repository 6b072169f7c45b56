"""The laws of the exact trace, on every arm: it is the kinematics of Drake's plants of doubles and of AutoDiff."""

from fractions import Fraction

import numpy as np
import pytest
from pydrake.autodiffutils import ExtractGradient, ExtractValue, InitializeAutoDiff

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.numbers import IDENTITY
from armproof.models.exact.polynomial import (
    ONE,
    ZERO,
    Rows,
    add,
    generator,
    generators,
    matrix_product,
    multiply,
    scale,
    transpose,
)
from armproof.models.exact.trace import Trace, trace_of
from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.models.numeric.drake_arm import drake_of, frame_of, plant_of
from armproof.models.numeric.plant import NumericKinematics
from tests.laws import SWEEP
from tests.models.evaluation import evaluate_entries

TOLERANCE = 1e-12


def configurations(arm: Arm, count: int = 1000 if SWEEP else 240) -> tuple[np.ndarray, np.ndarray]:
    """Return configurations of the six families, and a tolerance for each, scaled by the largest coordinate."""
    q, _ = sample(arm, count, np.random.default_rng(20))
    return q, TOLERANCE * np.maximum(1.0, np.abs(q).max(axis=1))[:, None, None]


def assert_agrees(exact: np.ndarray, double: np.ndarray, tolerance: np.ndarray) -> None:
    worst = np.max(np.abs(exact - double) / tolerance)
    assert worst <= 1, f"{worst} times the tolerance"


def test_exact_poses_are_those_of_the_double_plant(arm: Arm) -> None:
    q, tolerance = configurations(arm)
    numeric = NumericKinematics(arm, q)
    base, last = arm.frames[0], arm.frames[-1]
    for frame in arm.frames:
        for reference in (base, last) if SWEEP or frame == base else (base,):
            assert_agrees(
                evaluate_entries(arm, trace_of(arm).pose(frame, reference), q),
                numeric.pose(frame, reference),
                tolerance,
            )


def test_exact_jacobians_are_those_of_the_double_plant(arm: Arm) -> None:
    q, tolerance = configurations(arm)
    numeric = NumericKinematics(arm, q)
    base, last = arm.frames[0], arm.frames[-1]
    for frame, expressed_in in ((last, base), (last, last), (arm.frames[1], base)):
        exact = evaluate_entries(arm, trace_of(arm).jacobian(frame, expressed_in), q)
        assert_agrees(exact, numeric.jacobian(frame, expressed_in), tolerance)


def test_jacobians_between_any_three_frames_agree(arm: Arm) -> None:
    q, tolerance = configurations(arm, 30)
    numeric = NumericKinematics(arm, q)
    middle = arm.frames[len(arm.frames) // 2]
    for frame, expressed_in, reference in ((middle, arm.frames[-1], arm.frames[-1]), (arm.frames[-1], middle, middle)):
        exact = evaluate_entries(arm, trace_of(arm).jacobian(frame, expressed_in, reference), q)
        assert_agrees(exact, numeric.jacobian(frame, expressed_in, reference), tolerance)


def test_jacobian_is_the_derivative_of_the_forward_kinematics(arm: Arm) -> None:
    q, tolerance = configurations(arm, 2 * len(FAMILIES))
    plant = plant_of(arm).ToAutoDiffXd()
    context = plant.CreateDefaultContext()
    frame = plant.get_frame(frame_of(arm, arm.frames[-1]).index())
    base = plant.get_frame(frame_of(arm, arm.frames[0]).index())
    exact = evaluate_entries(arm, trace_of(arm).jacobian(arm.frames[-1]), q)
    for k in range(len(q)):
        positions = np.zeros(plant.num_positions())
        positions[list(drake_of(arm).position_indices)] = q[k]
        plant.SetPositions(context, InitializeAutoDiff(positions).ravel())
        X = plant.CalcRelativeTransform(context, base, frame).GetAsMatrix4()
        R = ExtractValue(X[:3, :3])
        gradient = ExtractGradient(X[:3].reshape(-1, 1)).reshape(3, 4, -1)[:, :, drake_of(arm).position_indices]
        angular = np.einsum("ikq,jk->ijq", gradient[:, :3], R)  # dR/dq Rᵀ, the cross-product matrix of ω
        derivative = np.stack([*gradient[:, 3], angular[2, 1], angular[0, 2], angular[1, 0]])
        assert_agrees(exact[k], derivative, tolerance[k])


def rotation_of(arm: Arm, frame: str, reference: str | None = None) -> Rows:
    return tuple(row[:3] for row in trace_of(arm).pose(frame, reference)[:3])


def test_rotations_are_orthonormal_exactly(arm: Arm) -> None:
    R = rotation_of(arm, arm.frames[1])
    assert matrix_product(R, transpose(R)) == IDENTITY
    minors = [
        add(multiply(R[1][j], R[2][k]), scale(multiply(R[1][k], R[2][j]), -1)) for j, k in ((1, 2), (2, 0), (0, 1))
    ]
    assert add(*(multiply(R[0][i], minor) for i, minor in enumerate(minors))) == ONE


def test_a_frame_seen_from_itself_is_the_identity_exactly(arm: Arm) -> None:
    for frame in arm.frames:
        pose = trace_of(arm).pose(frame, frame)
        assert pose == tuple(tuple(ONE if i == j else ZERO for j in range(4)) for i in range(4))


def test_the_inverse_transform_is_that_of_the_swapped_frames_exactly(arm: Arm) -> None:
    base, frame = arm.frames[0], arm.frames[1]
    assert transpose(rotation_of(arm, frame)) == rotation_of(arm, base, frame)


def test_entries_are_in_normal_form_and_exact(arm: Arm) -> None:
    for row in (*trace_of(arm).pose(arm.frames[-1]), *trace_of(arm).jacobian(arm.frames[-1])):
        for entry in row:
            for monomial, coefficient in entry.items():
                assert isinstance(coefficient, Fraction) and coefficient
                assert monomial == tuple(sorted(monomial))
                assert all(power == 1 for (kind, _), power in monomial if kind in ("sin", "sqrt"))


def test_every_generator_is_a_joint_a_length_a_constant_or_a_root(arm: Arm) -> None:
    trace = trace_of(arm)
    rows = [*trace.pose(arm.frames[-1]), *trace.jacobian(arm.frames[-1])]
    revolute = {joint.symbol for joint in arm.joints if joint.kind == "revolute"}
    symbols = {joint.symbol for joint in arm.joints if joint.kind == "prismatic"} | set(arm.lengths)
    for kind, name in generators(entry for row in rows for entry in row):
        assert (
            (kind in ("cos", "sin") and name in revolute | set(trace.constants))
            or (kind == "symbol" and name in symbols)
            or (kind == "sqrt" and name in ("2", "3"))
        )


def test_scara_entries_are_those_of_its_document() -> None:
    c1, c2, s1, s2 = (generator(kind, f"theta_{i}") for kind in ("cos", "sin") for i in (1, 2))
    a1, a2, d3, d4 = (generator("symbol", name) for name in ("a_1", "a_2", "d_3", "d_4"))
    c12 = add(multiply(c1, c2), scale(multiply(s1, s2), -1))
    trace = trace_of(load_arm("scara"))
    assert trace.pose("4")[0][3] == add(multiply(a1, c1), multiply(a2, c12))
    assert trace.pose("4")[2][3] == scale(add(d3, d4), -1)
    assert [row[2] for row in trace.jacobian("4")] == [ZERO, ZERO, scale(ONE, -1), ZERO, ZERO, ZERO]


def test_a_slip_in_one_entry_is_caught() -> None:
    arm = load_arm("scara")
    q, tolerance = configurations(arm)
    swap = {"a_1": "a_2", "a_2": "a_1"}
    swapped = tuple(
        tuple(
            {tuple(sorted(((kind, swap.get(name, name)), p) for (kind, name), p in m)): c for m, c in entry.items()}
            for entry in row
        )
        for row in trace_of(arm).pose("4")
    )
    with pytest.raises(AssertionError, match="times the tolerance"):
        assert_agrees(evaluate_entries(arm, swapped, q), NumericKinematics(arm, q).pose("4"), tolerance)


def test_a_trace_is_computed_once_and_read_only() -> None:
    arm = load_arm("planar_2r")
    assert trace_of(arm) is trace_of(arm)
    assert trace_of(arm).pose("2") is trace_of(arm).pose("2", "0")
    with pytest.raises(TypeError):
        trace_of(arm).pose("2")[0][0][()] = Fraction(1)  # type: ignore[index]


@pytest.mark.parametrize("ask", [Trace.pose, Trace.jacobian])
def test_an_unknown_frame_is_named_with_those_there_are(ask) -> None:
    with pytest.raises(ModelError, match=r"^no frame '7' on arm 'scara'; its frames are 0, 1, 2, 3, 4$"):
        ask(trace_of(load_arm("scara")), "7")


def test_an_unknown_reference_is_refused() -> None:
    trace = trace_of(load_arm("scara"))
    with pytest.raises(ModelError, match="no frame '9' on arm 'scara'"):
        trace.pose("4", "9")
    with pytest.raises(ModelError, match="no frame '9' on arm 'scara'"):
        trace.jacobian("4", expressed_in="9")


def test_a_table_with_too_many_symbolic_angles_is_refused_at_once() -> None:
    rows = [{"a": f"a_{i}", "alpha": f"alpha_{i}", "d": 0, "theta": f"theta_{i}"} for i in range(1, 9)]
    trace = trace_of(load_arm({"dh": "classic", "rows": rows}))
    with pytest.raises(ModelError, match="too many symbolic angles between frames 8, 0 to multiply out"):
        trace.pose("8")
    assert trace.pose("8", "6")
