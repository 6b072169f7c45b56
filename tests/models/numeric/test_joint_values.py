"""Joint values are read in one place: what is accepted, what is refused, and in which words."""

from decimal import Decimal

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.joint_values import limit_notes, outside_limits, read_configuration, read_joint_values
from armproof.models.numeric.plant import NumericKinematics
from tests.models.evaluation import evaluate_entries

ROUTES = {
    "bulk": lambda arm, q: bulk_of(arm).pose(q, arm.frames[-1]),
    "double plant": lambda arm, q: NumericKinematics(arm, q),
    "trace": lambda arm, q: evaluate_entries(arm, trace_of(arm).pose(arm.frames[1]), q),
    "reader": read_joint_values,
}


@pytest.fixture(params=ROUTES)
def route(request: pytest.FixtureRequest):
    return ROUTES[request.param]


@pytest.mark.parametrize(
    "q",
    [
        [[0.5, 1, -0.1, 2]],
        ((0.5, 1, -0.1, 2),),
        np.array([[0.5, 1, -0.1, 2]], dtype=np.float64, order="F"),
        [np.array([0.5, 1, -0.1, 2])],
    ],
)
def test_lists_tuples_and_arrays_are_read_alike(q) -> None:
    np.testing.assert_array_equal(read_joint_values(load_arm("scara"), q), [[0.5, 1, -0.1, 2]])


@pytest.mark.parametrize("dtype", ["i1", "u2", "i8", "f2", "f4", "f8", ">f8"])
def test_every_real_number_type_becomes_double(dtype: str) -> None:
    q = read_joint_values(load_arm("scara"), np.ones((3, 4), dtype=dtype))
    assert q.dtype == np.float64 and (q == 1).all()


def test_no_configurations_are_configurations() -> None:
    assert read_joint_values(load_arm("scara"), np.empty((0, 4))).shape == (0, 4)


@pytest.mark.parametrize(
    ("q", "message"),
    [
        (
            np.zeros((1, 4), dtype=bool),
            r"joint values of arm 'scara' are real numbers \(rad, m\), not booleans \(bool\)",
        ),
        (np.zeros((1, 4), dtype=complex), "not complex numbers"),
        ([["0", "1", "2", "3"]], "not text"),
        (b"0000", "not text"),
        ([[None] * 4], "not objects"),
        ([[Decimal(1)] * 4], "not objects"),
        ([[10**400] * 4], "not objects"),
        ({"theta_1": 0.0}, "not objects"),
        ([[0, 0, 0, 0], [0, 0]], "equal lengths: 4 joint values, theta_1 "),
        (np.ma.masked_equal(np.zeros((1, 4)), 0), "are real numbers; 4 of those given are masked"),
        (0.0, r"have the shape \(N, 4\), not \(\)"),
        ([], r"have the shape \(N, 4\), not \(0,\)"),
        ([0, 0, 0, 0], r"not \(4,\).*write one configuration as \[q\]$"),
        (
            np.zeros((2, 3)),
            r"^configurations of arm 'scara' have the shape \(N, 4\), not \(2, 3\); "
            r"the 4 joint values are theta_1 \(rad\), theta_2 \(rad\), d_3 \(m\), theta_4 \(rad\)$",
        ),
        (np.zeros((1, 1, 4)), r"not \(1, 1, 4\)"),
        ([[0, 0, 0, 0], [0, np.nan, 0, 0]], r"finite numbers; q\[1, 1\], theta_2 of arm 'scara', is nan$"),
        ([[0, 0, -np.inf, 0]], r"q\[0, 2\], d_3 of arm 'scara', is -inf$"),
        (np.full((1, 4), np.longdouble("1e400")), r"q\[0, 0\], theta_1 of arm 'scara', is inf$"),
    ],
)
def test_what_is_no_configuration_is_refused_on_every_route(route, q, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        route(load_arm("scara"), q)


def test_one_configuration_is_read_on_its_own() -> None:
    arm = load_arm("scara")
    np.testing.assert_array_equal(read_configuration(arm, (0, 1, 2, 3)), [0.0, 1.0, 2.0, 3.0])
    with pytest.raises(
        ModelError, match=r"a configuration of arm 'scara' has the shape \(4,\), not \(1, 4\); .*d_3 \(m\)"
    ):
        read_configuration(arm, [[0, 1, 2, 3]])
    with pytest.raises(ModelError, match=r"q\[3\], theta_4 of arm 'scara', is nan"):
        read_configuration(arm, [0, 1, 2, np.nan])


def test_values_beyond_the_limits_are_told_not_refused(arm: Arm) -> None:
    upper = np.array([joint.upper if np.isfinite(joint.upper) else 0.0 for joint in arm.joints])
    limited = np.array([np.isfinite(joint.upper) for joint in arm.joints])
    q = np.stack([upper, upper + 1e-9, upper - 1e-9])
    outside = outside_limits(arm, q)
    np.testing.assert_array_equal(outside, np.stack([~limited & False, limited, ~limited & False]))
    assert len(limit_notes(arm, q)) == limited.sum()
    assert bulk_of(arm).pose(q, arm.frames[-1]).shape == (3, 4, 4)


def test_a_note_names_the_joint_its_limits_and_how_often() -> None:
    arm = load_arm("scara")
    joint = arm.joint("d_3")
    q = np.zeros((3, 4))
    q[1:, 2] = joint.upper + 1
    note = f"d_3 is outside its limits [{joint.lower:g}, {joint.upper:g}] m at 2 of 3 configurations"
    assert limit_notes(arm, q) == (note,)
    assert limit_notes(arm, q[0]) == ()
    assert outside_limits(arm, q[1]).tolist() == [False, False, True, False]


@pytest.mark.parametrize("q", [[[0, 0, 0, 0], [0]], [0, 0], [np.nan] * 4, "0000"])
def test_limits_of_what_is_no_configuration_are_refused(q) -> None:
    for ask in (outside_limits, limit_notes):
        with pytest.raises(ModelError, match="arm 'scara'"):
            ask(load_arm("scara"), q)
