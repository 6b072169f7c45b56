"""Targets of the course's arms whose number of solutions is known: within reach, on an edge, degenerate, out of reach."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import BulkKinematics
from armproof.verification.inverse import InverseKinematics

Draw = Callable[[np.random.Generator, int, Mapping[str, float]], np.ndarray]
PI = np.pi


@dataclass(frozen=True)
class Kinds:
    """How to draw targets of an arm.

    Attributes:
        solutions, on_edge: the number of solutions of a target within reach, and on an edge.
        equal: the lengths that have to be equal for the arm to have degenerate targets.
        edge, degenerate: draw configurations of such targets, (N, n); None where the arm has none.
        reach: the farthest and the nearest that the target comes to the centre; None where every target is within reach.
        height: the length by which the centre stands above the origin.
        planar: whether the height of the target does not count.
    """

    solutions: int
    on_edge: int = 1
    equal: tuple[str, ...] = ()
    edge: Draw | None = None
    degenerate: Draw | None = None
    reach: Callable[[Mapping[str, float]], tuple[float, float]] | None = None
    height: str = ""
    planar: bool = False


def _any(generator: np.random.Generator, count: int, joints: int) -> np.ndarray:
    return generator.uniform(-PI, PI, (count, joints))


def _with(joints: int, column: int, *values: float) -> Draw:
    """Draw any configuration with one joint at one of some values."""

    def draw(generator: np.random.Generator, count: int, _lengths: Mapping[str, float]) -> np.ndarray:
        q = _any(generator, count, joints)
        q[:, column] = generator.choice(values, count)
        return q

    return draw


def _on_the_axis(first: str, second: str, sign: int) -> Draw:
    """Draw configurations of a spatial arm whose tool stands on the first axis: a C_2 ± b S_23 = 0."""

    def draw(generator: np.random.Generator, count: int, lengths: Mapping[str, float]) -> np.ndarray:
        q = _any(generator, count, 3)
        ratio = lengths[first] * np.cos(q[:, 1]) / lengths[second]
        while np.any(bad := np.abs(ratio) > 0.999):
            q[bad, 1] = generator.uniform(-PI, PI, int(bad.sum()))
            ratio = lengths[first] * np.cos(q[:, 1]) / lengths[second]
        q[:, 2] = np.arcsin(-sign * ratio) - q[:, 1]
        return q

    return draw


def _rx90_degenerate(generator: np.random.Generator, count: int, lengths: Mapping[str, float]) -> np.ndarray:
    q = _any(generator, count, 6)
    half = count // 2
    q[:half, 4] = generator.choice([0.0, PI, -PI], half)
    q[half:, :3] = _on_the_axis("a_3", "d_3", -1)(generator, count - half, lengths)
    return q


def _polar_degenerate(generator: np.random.Generator, count: int, _lengths: Mapping[str, float]) -> np.ndarray:
    return np.column_stack([generator.uniform(-PI, PI, count), np.zeros(count)])


KINDS: dict[str, Kinds] = {
    "planar_2r": Kinds(2, 1, ("l_1", "l_2"), _with(2, 1, 0.0, PI, -PI), _with(2, 1, PI, -PI),
                       lambda a: (a["l_1"] + a["l_2"], abs(a["l_1"] - a["l_2"])), planar=True),
    "planar_3r": Kinds(2, 1, ("l_1", "l_2"), _with(3, 1, 0.0, PI, -PI), _with(3, 1, PI, -PI),
                       lambda a: (a["l_1"] + a["l_2"] + a["l_3"], 0.0), planar=True),
    "polar_rp": Kinds(2, 2, (), None, _polar_degenerate),
    "scara_column": Kinds(2, 1, ("a_1", "a_2"), _with(4, 1, 0.0, PI, -PI), _with(4, 1, PI, -PI),
                          lambda a: (a["a_1"] + a["a_2"], abs(a["a_1"] - a["a_2"])), planar=True),
    "spatial_rrr": Kinds(4, 2, (), _with(3, 2, PI / 2, -PI / 2), _on_the_axis("l_2", "l_3", 1),
                         lambda a: (a["l_2"] + a["l_3"], abs(a["l_2"] - a["l_3"])), height="l_1"),
    "spherical_wrist": Kinds(2, 2, (), None, _with(3, 1, 0.0, PI, -PI)),
    "rx90": Kinds(8, 4, (), _with(6, 2, PI / 2, -PI / 2), _rx90_degenerate,
                  lambda a: (a["a_3"] + a["d_3"], abs(a["a_3"] - a["d_3"]))),
}  # fmt: skip


def generic(arm: Arm, generator: np.random.Generator, count: int) -> np.ndarray:
    """Return configurations within the limits of the joints, (N, n)."""
    lower = np.array([max(joint.lower, -PI) for joint in arm.joints])
    upper = np.array([min(joint.upper, PI) for joint in arm.joints])
    return generator.uniform(lower, upper, (count, len(arm.joints)))


def targets_of(inverse: InverseKinematics, q: np.ndarray, lengths: Mapping[str, float] | None = None) -> np.ndarray:
    """Return the targets, (N, m), of configurations: poses by models/bulk/bulk.py, names that displays define by their formulas."""
    target = inverse.derivation.target
    values = inverse.forward(q, lengths).copy()
    bulk = BulkKinematics(inverse.arm, dict(lengths or {}))
    for pair in target.pairs:
        X = bulk.pose(q, *pair)
        for (row, column), index in target.cells(pair).items():
            values[:, index] = X[:, row, column]
    return values


def out_of_reach(inverse: InverseKinematics, generator: np.random.Generator, count: int) -> np.ndarray | None:
    """Return targets out of reach: beyond the workspace, and in its hole where it has one; None where all are within reach."""
    kinds, lengths = KINDS[inverse.arm.name], inverse.arm.lengths
    if kinds.reach is None:
        return None
    targets = targets_of(inverse, generic(inverse.arm, generator, count))
    far, near = kinds.reach(lengths)
    columns = [k for k, slot in enumerate(inverse.derivation.target.slots) if not slot.is_name and slot.column == 3]
    columns = [k for k in columns if inverse.derivation.target.slots[k].row < (2 if kinds.planar else 3)]
    direction = generator.normal(size=(count, len(columns)))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    distance = far * (1.0 + 10.0 ** generator.uniform(-6.0, 2.0, count))
    if near > 0:
        inside = generator.random(count) < 0.3
        distance[inside] = near * (1.0 - 10.0 ** generator.uniform(-6.0, -0.01, int(inside.sum())))
    targets[:, columns] = direction * distance[:, None]
    if kinds.height:
        targets[:, columns[-1]] += lengths[kinds.height]
    return targets


def equal_lengths(name: str) -> dict[str, float] | None:
    """Return the lengths with which an arm has degenerate targets; None where its own will do."""
    return dict.fromkeys(KINDS[name].equal, 0.4) or None
