"""The quintic: its six conditions, its peaks and shortest duration, and its values as arrays."""

import numpy as np
import pytest
from pydrake.trajectories import PiecewisePolynomial

from armproof.models.errors import ModelError
from armproof.models.motion.limits import extremes
from armproof.models.motion.quintic import PEAK_ACCELERATION, PEAK_SPEED, quintic, shortest_duration
from armproof.models.motion.samples import sample_motion

RNG = np.random.default_rng(0)
NAN = float("nan")


@pytest.mark.parametrize("t_f", [0.01, 1.0, 2.7, 300.0])
@pytest.mark.parametrize("joints", [1, 2, 6])
def test_the_six_conditions_hold(t_f: float, joints: int):
    q_0, q_f, v_0, v_f, w_0, w_f = RNG.normal(size=(6, joints))
    trajectory = quintic(q_0, q_f, t_f, v_0=v_0, v_f=v_f, w_0=w_0, w_f=w_f, start_time=0.5)
    ends = sample_motion(trajectory, [0.5, 0.5 + t_f])
    scale = 1e-12 * (1 + 1 / t_f**2) * (1 + t_f) ** 2
    np.testing.assert_allclose(ends.q, [q_0, q_f], atol=scale)
    np.testing.assert_allclose(ends.v, [v_0, v_f], atol=scale)
    np.testing.assert_allclose(ends.w, [w_0, w_f], atol=scale)


def test_it_is_the_solution_of_the_system_of_the_document():
    q_0, q_f, v_0, v_f, w_0, w_f = RNG.normal(size=6)
    T = 1.7
    M = [
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 2, 0, 0, 0],
        [1, T, T**2, T**3, T**4, T**5],
        [0, 1, 2 * T, 3 * T**2, 4 * T**3, 5 * T**4],
        [0, 0, 2, 6 * T, 12 * T**2, 20 * T**3],
    ]
    trajectory = quintic(q_0, q_f, T, v_0=v_0, v_f=v_f, w_0=w_0, w_f=w_f)
    found = trajectory.getPolynomial(0, 0, 0).GetCoefficients()
    np.testing.assert_allclose(found, np.linalg.solve(M, [q_0, v_0, w_0, q_f, v_f, w_f]), atol=1e-12)


@pytest.mark.parametrize(("q_0", "q_f", "t_f"), [(0.2, 1.7, 1.3), (1.7, 0.2, 0.4)])
def test_the_peaks_are_those_of_the_handout(q_0: float, q_f: float, t_f: float):
    trajectory = quintic(q_0, q_f, t_f)
    move = abs(q_f - q_0)
    speed, acceleration = (np.abs(extremes(trajectory, order)).max() for order in (1, 2))
    assert speed == pytest.approx(PEAK_SPEED * move / t_f, rel=1e-12)
    assert acceleration == pytest.approx(PEAK_ACCELERATION * move / t_f**2, rel=1e-12)
    first, middle, last = t_f * (0.5 - np.sqrt(3) / 6), t_f / 2, t_f * (0.5 + np.sqrt(3) / 6)
    motion = sample_motion(trajectory, [first, middle, last])
    sign = np.sign(q_f - q_0)
    np.testing.assert_allclose(motion.w[:, 0], [sign * acceleration, 0, -sign * acceleration], atol=1e-9 * acceleration)
    assert motion.v[1, 0] == pytest.approx(sign * speed)
    assert np.ravel(extremes(trajectory)) == pytest.approx(sorted([q_0, q_f]), abs=1e-12), "it overshoots"


@pytest.mark.parametrize("order", [0, 1, 2])
def test_extremes_bound_the_values_and_are_reached(order: int):
    points = RNG.normal(size=(3, 7))
    spline = PiecewisePolynomial.CubicWithContinuousSecondDerivatives(np.cumsum(RNG.uniform(0.1, 2, 7)), points, False)
    lower, upper = extremes(spline, order)
    motion = sample_motion(spline, np.linspace(spline.start_time(), spline.end_time(), 20001))
    values = (motion.q, motion.v, motion.w)[order]
    assert (values >= lower - 1e-9).all() and (values <= upper + 1e-9).all()
    np.testing.assert_allclose([values.min(axis=0), values.max(axis=0)], [lower, upper], atol=1e-3 * np.ptp(values))
    if order == 0:
        assert (upper > points.max(axis=1) + 1e-6).any(), "no overshoot: the points alone would do"


@pytest.mark.parametrize("limits", [(2.0, 5.0), (0.1, 50.0), ([1.0, 0.3], [9.0, np.inf]), (np.inf, 2.0)])
def test_the_shortest_duration_reaches_a_limit_and_a_shorter_one_passes_it(limits):
    q_0, q_f = np.array([0.1, -0.4]), np.array([1.3, 0.9])

    def use(duration: float) -> float:
        peaks = [np.abs(extremes(quintic(q_0, q_f, duration), order)).max(axis=0) for order in (1, 2)]
        return max(float((peak / np.array(limit)).max()) for peak, limit in zip(peaks, limits, strict=True))

    duration = shortest_duration(q_0, q_f, *limits)
    assert use(duration) == pytest.approx(1, rel=1e-9)
    assert use(0.99 * duration) > 1


def test_the_limit_changes_at_the_distance_of_the_handout():
    k_v, k_a = 1.4, 6.0
    d = 128 * k_v**2 / (45 * np.sqrt(3) * k_a)
    assert shortest_duration(0, d, k_v, k_a) == pytest.approx(15 * d / (8 * k_v))
    assert shortest_duration(0, 0.9 * d, k_v, k_a) > shortest_duration(0, 0.9 * d, k_v, np.inf)
    assert shortest_duration(0, 1.1 * d, k_v, k_a) == shortest_duration(0, 1.1 * d, k_v, np.inf)


def test_outside_its_interval_a_motion_is_held():
    trajectory = quintic([0.0, 1.0], [1.0, 3.0], 2.0, v_0=0.5, v_f=-0.5, w_f=1.0)
    motion = sample_motion(trajectory, [-1.0, 0.0, 2.0, 2.5])
    np.testing.assert_allclose(motion.q, [[0, 1], [0, 1], [1, 3], [1, 3]], atol=1e-14)
    np.testing.assert_allclose(motion.v, [[0, 0], [0.5, 0.5], [-0.5, -0.5], [0, 0]], atol=1e-13)
    np.testing.assert_allclose(motion.w[[0, 3]], 0)
    with pytest.raises(ValueError, match="read-only"):
        motion.q[0] = 1


def test_no_displacement_stays():
    motion = sample_motion(quintic([0.3, 0.4], [0.3, 0.4], 1.0), np.linspace(0, 1, 5))
    np.testing.assert_array_equal(motion.q, np.tile([0.3, 0.4], (5, 1)))
    assert not motion.v.any() and shortest_duration(1.0, 1.0, 1.0, 1.0) == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0, 1], [0, 1, 2], 1), r"q_f: a vector of the shape \(2,\) is needed, not \(3,\)"),
        (([[0, 1]], [0, 1], 1), r"q_0: .* not \(1, 2\)"),
        (([], [], 1), "q_0"),
        (([0, NAN], [0, 1], 1), "q_0: every number is finite; number 2 is not"),
        (("far", [0, 1], 1), "no vector of numbers"),
        ((0, 1, 0), "duration: a motion takes a positive time between 1e-09 and 1e.09 s, not 0"),
        ((0, 1, -2), "not -2"),
        ((0, 1, NAN), "duration: every number is finite"),
        ((0, 1, [1, 2]), "duration"),
        ((-1e308, 1e308, 1), "too large"),
    ],
)
def test_what_is_no_motion_is_refused(arguments, message):
    with pytest.raises(ModelError, match=message):
        quintic(*arguments)


def test_rates_and_start_times_are_checked_too():
    with pytest.raises(ModelError, match=r"v_f: a vector of the shape \(2,\)"):
        quintic([0, 1], [1, 2], 1, v_f=[0, 0, 0])
    with pytest.raises(ModelError, match="too far apart"):
        quintic(0, 1, 1, start_time=1e18)
    with pytest.raises(ModelError, match="neither a velocity nor an acceleration limit"):
        shortest_duration(0, 1, np.inf, np.inf)
    for limit in (0, -1, NAN, [1, 2, 3], "fast"):
        with pytest.raises(ModelError, match="acceleration"):
            shortest_duration([0, 0], [1, 1], 1, limit)


def test_what_is_no_trajectory_is_refused():
    square = PiecewisePolynomial(np.eye(2))
    with pytest.raises(ModelError, match=r"values of the shape \(n, 1\), not \(2, 2\)"):
        sample_motion(square, [0.0])
    with pytest.raises(ModelError, match=r"a trajectory of pydrake.trajectories, not a function"):
        sample_motion(lambda t: t, [0.0])
    with pytest.raises(ModelError, match="times: every number is finite"):
        sample_motion(quintic(0, 1, 1), [0.0, NAN])
