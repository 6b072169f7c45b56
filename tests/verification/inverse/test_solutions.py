"""The formulas that are proved are the formulas that run: all branches of many targets, each target marked."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from armproof.course.inverse import inverse_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.inverse import InverseError, InverseKinematics, Mark
from tests.sweeps.inverse_targets import KINDS, equal_lengths, generic, out_of_reach, targets_of

COUNT = 4000
NAMES = sorted(KINDS)


@pytest.fixture(scope="module", params=NAMES)
def inverse(request: pytest.FixtureRequest) -> InverseKinematics:
    """The inverse of every arm of the course that has one."""
    return inverse_of(request.param)


@pytest.fixture
def generator() -> np.random.Generator:
    """A random generator."""
    return np.random.default_rng(7)


def miss(inverse: InverseKinematics, q: np.ndarray, targets: np.ndarray, lengths: Any = None) -> np.ndarray:
    """Return how far configurations miss their targets, angles up to whole turns."""
    error = targets_of(inverse, q, lengths) - targets
    angles = np.array(inverse.compiled(lengths).angles)
    worst: np.ndarray = np.abs(np.where(angles, np.sin(error), error)).max(axis=1)
    return worst


def test_forward_of_inverse_is_the_target_on_every_branch(
    inverse: InverseKinematics, generator: np.random.Generator
) -> None:
    targets = targets_of(inverse, generic(inverse.arm, generator, COUNT))
    found = inverse.solve(targets)
    assert found.q.shape == (COUNT, len(inverse.branches), len(inverse.arm.joints))
    for branch in range(len(inverse.branches)):
        valid = found.valid[:, branch]
        assert valid.any() and miss(inverse, found.q[valid, branch], targets[valid]).max() < 1e-10


def test_the_plant_of_doubles_reaches_the_same_target(
    inverse: InverseKinematics, generator: np.random.Generator
) -> None:
    targets = targets_of(inverse, generic(inverse.arm, generator, 50))
    q = inverse.solve(targets).q
    for pair in inverse.derivation.target.pairs:
        cells = inverse.derivation.target.cells(pair)
        for branch in range(q.shape[1]):
            X = NumericKinematics(inverse.arm, q[:, branch]).pose(*pair)
            error = [np.abs(X[:, r, c] - targets[:, k]).max() for (r, c), k in cells.items()]
            assert max(error) < 1e-10


def test_every_configuration_is_recovered_by_a_branch(
    inverse: InverseKinematics, generator: np.random.Generator
) -> None:
    q = generic(inverse.arm, generator, COUNT)
    found = inverse.solve(targets_of(inverse, q))
    revolute = np.array([joint.kind == "revolute" for joint in inverse.arm.joints])
    difference = found.q - q[:, None]
    difference = np.abs(np.where(revolute, np.sin(difference / 2), difference)).max(axis=-1)
    assert np.nanmin(difference, axis=1).max() < 1e-6
    assert (found.mark == Mark.REACHABLE).all() and found.within_limits.any(axis=1).all()


def test_the_number_of_solutions_within_reach(inverse: InverseKinematics, generator: np.random.Generator) -> None:
    targets = targets_of(inverse, generic(inverse.arm, generator, COUNT))
    assert (inverse.count(targets) == KINDS[inverse.arm.name].solutions).all()


@pytest.mark.parametrize("name", [name for name in NAMES if KINDS[name].edge is not None])
def test_fewer_solutions_on_the_edge(name: str, generator: np.random.Generator) -> None:
    inverse, kinds = inverse_of(name), KINDS[name]
    assert kinds.edge is not None
    targets = targets_of(inverse, kinds.edge(generator, COUNT, inverse.arm.lengths))
    found = inverse.solve(targets)
    assert (found.mark == Mark.EDGE).all() and found.valid.all()
    assert (inverse.count(targets) == kinds.on_edge).all()
    assert miss(inverse, found.q[:, 0], targets).max() < 1e-10


def test_infinitely_many_solutions_where_it_degenerates(
    inverse: InverseKinematics, generator: np.random.Generator
) -> None:
    kinds, lengths = KINDS[inverse.arm.name], equal_lengths(inverse.arm.name)
    assert kinds.degenerate is not None
    q = kinds.degenerate(generator, COUNT, {**inverse.arm.lengths, **(lengths or {})})
    targets = targets_of(inverse, q, lengths)
    found = inverse.solve(targets, lengths)
    assert (found.mark == Mark.DEGENERATE).all() and np.isinf(inverse.count(targets, lengths)).all()
    assert not np.isnan(found.q[found.valid]).any()
    for branch in range(found.q.shape[1]):
        valid = found.valid[:, branch]
        if valid.any():  # what is handed out nevertheless is a solution
            assert miss(inverse, found.q[valid, branch], targets[valid], lengths).max() < 1e-8


@pytest.mark.parametrize("name", [name for name in NAMES if KINDS[name].reach is not None])
def test_no_solution_out_of_reach(name: str, generator: np.random.Generator) -> None:
    inverse = inverse_of(name)
    targets = out_of_reach(inverse, generator, COUNT)
    assert targets is not None
    found = inverse.solve(targets)
    assert (found.mark == Mark.UNREACHABLE).all() and not found.valid.any()
    assert (inverse.count(targets) == 0).all() and np.isnan(found.q).all()


@pytest.mark.parametrize("name", [name for name in NAMES if KINDS[name].edge is not None])
def test_next_to_the_edge_the_solutions_are_apart(name: str, generator: np.random.Generator) -> None:
    inverse, draw = inverse_of(name), KINDS[name].edge
    assert draw is not None
    q = draw(generator, 500, inverse.arm.lengths) + 1e-5
    targets = targets_of(inverse, q)
    assert (inverse.solve(targets).mark == Mark.REACHABLE).all()
    assert (inverse.count(targets) == KINDS[name].solutions).all()


@pytest.mark.parametrize("name", ["polar_rp", "spherical_wrist", "rx90", "spatial_rrr"])
def test_next_to_a_degenerate_target_the_solutions_are_good(name: str, generator: np.random.Generator) -> None:
    inverse, draw = inverse_of(name), KINDS[name].degenerate
    assert draw is not None
    targets = targets_of(inverse, draw(generator, 500, inverse.arm.lengths) + 1e-6)
    found = inverse.solve(targets)
    assert (found.mark == Mark.REACHABLE).all()
    for branch in range(found.q.shape[1]):
        assert miss(inverse, found.q[:, branch], targets).max() < 1e-10


def test_there_is_no_nan_without_a_mark(inverse: InverseKinematics, generator: np.random.Generator) -> None:
    slots = inverse.derivation.target.slots
    targets = generator.normal(size=(COUNT, len(slots)))
    targets[::7] = 0.0
    targets[::11] = np.nan
    targets[::13, 0] = np.inf
    found = inverse.solve(targets)
    assert (np.isnan(found.q).any(axis=-1) == ~found.valid).all()
    assert (found.valid.any(axis=1) | np.isin(found.mark, [Mark.UNREACHABLE, Mark.INVALID, Mark.DEGENERATE])).all()
    assert (found.mark[::11] == Mark.INVALID).all() and (found.mark[::13] == Mark.INVALID).all()


def test_a_batch_is_solved_as_each_of_its_targets(inverse: InverseKinematics, generator: np.random.Generator) -> None:
    targets = targets_of(inverse, generic(inverse.arm, generator, 1100))
    together = inverse.solve(targets)
    for row in (0, 17, 1023, 1024, 1099):
        alone = inverse.solve(targets[row : row + 1])
        np.testing.assert_array_equal(alone.q[0], together.q[row])
    assert len(inverse.solve(targets[:0])) == 0


def test_the_arrays_are_read_only(inverse: InverseKinematics, generator: np.random.Generator) -> None:
    found = inverse.solve(targets_of(inverse, generic(inverse.arm, generator, 3)))
    for array in (found.q, found.valid, found.mark, found.within_limits):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_the_marks_do_not_hang_on_the_unit_of_length(generator: np.random.Generator) -> None:
    inverse = inverse_of("planar_2r")
    for unit in (1e-6, 1.0, 1e6):
        lengths = {name: unit * value for name, value in inverse.arm.lengths.items()}
        for draw, mark in ((KINDS["planar_2r"].edge, Mark.EDGE), (None, Mark.REACHABLE)):
            q = generic(inverse.arm, generator, 500) if draw is None else draw(generator, 500, lengths)
            assert (inverse.solve(inverse.forward(q, lengths), lengths).mark == mark).all()


def test_joint_limits_are_noted_and_not_imposed() -> None:
    inverse = inverse_of("polar_rp")
    found = inverse.solve([[0.3, 0.2]])
    assert found.valid.all() and found.within_limits.tolist() == [[True, False]]  # the ram does not reach back


# -- bad input -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("targets", "words"),
    [
        ([0.3, 0.2], r"\(N, 2\).*write one target as \[x\]"),
        ([[0.3, 0.2, 0.1]], r"the shape \(N, 2\): X, Y, not \(1, 3\)"),
        ([["a", "b"]], "real numbers"),
        ([[1j, 0]], "real numbers"),
        ([[True, False]], "real numbers"),
        ([[0.1], [0.2, 0.3]], "rows of equal length"),
        (None, "real numbers"),
    ],
)
def test_what_is_no_batch_of_targets_is_refused(targets: Any, words: str) -> None:
    with pytest.raises(InverseError, match=words):
        inverse_of("planar_2r").solve(targets)


@pytest.mark.parametrize(
    ("lengths", "words"),
    [
        ({"l_9": 1.0}, "no length 'l_9' on arm 'planar_2r'; it has l_1, l_2"),
        ({"l_1": -1.0}, "positive number"),
        ({"l_1": float("nan")}, "positive number"),
        ({"l_1": True}, "positive number"),
    ],
)
def test_lengths_are_checked(lengths: dict[str, Any], words: str) -> None:
    with pytest.raises(InverseError, match=words):
        inverse_of("planar_2r").solve([[0.3, 0.2]], lengths)


def test_what_is_no_rotation_is_no_target() -> None:
    inverse = inverse_of("rx90")
    pose = np.eye(4)
    pose[:3, 3] = 0.3, 0.2, 0.4
    spoil: list[Callable[[np.ndarray], Any]] = [
        lambda X: X.__setitem__((0, 0), 1.1),
        lambda X: X.__setitem__((slice(3), 0), -X[:3, 0]),  # a mirror image
        lambda X: X.__setitem__((3, 3), 2.0),
        lambda X: X.__setitem__((1, 3), np.nan),
    ]
    batch = np.stack([pose.copy() for _ in range(len(spoil) + 1)])
    for X, change in zip(batch[1:], spoil, strict=True):
        change(X)
    assert inverse.solve(batch).mark.tolist() == [Mark.REACHABLE] + [Mark.INVALID] * len(spoil)


def test_a_pose_is_given_as_a_matrix_or_flat(generator: np.random.Generator) -> None:
    inverse = inverse_of("rx90")
    targets = targets_of(inverse, generic(inverse.arm, generator, 5))
    np.testing.assert_array_equal(inverse.solve(targets).q, inverse.solve(targets.reshape(5, 4, 4)).q)
