"""A second opinion on whether two formulas are equal: their values at random configurations of random arms."""

from __future__ import annotations

from enum import Enum

import numpy as np

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar
from armproof.verification.algebra.protocol import identity
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n
from tests.mutation.place import Place

SAMPLES = 24
TOLERANCE = 1e-9


def sampled_algebra(place: Place, seed: int = 1) -> SampledAlgebra:
    """Return values at random joint positions and, unlike the checker's second route, at random lengths."""
    random = np.random.default_rng(seed)
    arm = place.checker.names.arm
    if arm is None:
        return SampledAlgebra(place.checker.exact, np.zeros((SAMPLES, 0)), seed)
    q = np.column_stack([random.uniform(-2.9, 2.9, SAMPLES) for _ in arm.joints])
    lengths = {symbol: random.uniform(0.2, 1.4, SAMPLES) for symbol in arm.lengths}
    return SampledAlgebra(place.checker.exact, q, seed, lengths)


class Opinion(Enum):
    """How two formulas compare at random configurations."""

    EQUAL = "equal"
    DIFFERENT = "different"
    TURN_APART = "equal as angles, up to whole turns"
    UNKNOWN = "without a value"


def compare(place: Place, a: n.Node, b: n.Node) -> Opinion:
    """Return whether two trees have one value at every sample; 0 equals a zero matrix of any size."""
    algebra = sampled_algebra(place)
    with np.errstate(all="ignore"):
        try:
            (a_plus, a_minus), (b_plus, b_minus) = (_values(place, node, algebra) for node in (a, b))
        except (ArmproofError, TypeError, IndexError):
            return Opinion.UNKNOWN
        if a_plus.shape != b_plus.shape:
            return (
                Opinion.DIFFERENT
                if np.any([_far_from_zero(v) for v in (a_plus, a_minus, b_plus, b_minus)])
                else Opinion.EQUAL
            )
        usable = np.isfinite(a_plus) | np.isfinite(b_plus)  # a value on one side alone is a difference
        if not usable.any():
            return Opinion.UNKNOWN
        for close, opinion in ((_close, Opinion.EQUAL), (_close_as_angles, Opinion.TURN_APART)):
            together = close(a_plus, b_plus) & close(a_minus, b_minus)
            crossed = close(a_plus, b_minus) & close(a_minus, b_plus)
            if (together | crossed | ~usable).all():
                return opinion if opinion is Opinion.EQUAL or _holds_arcs(a, b) else Opinion.DIFFERENT
    return Opinion.DIFFERENT


def compare_conditions(place: Place, a: tuple[n.Node, ...], b: tuple[n.Node, ...]) -> Opinion:
    """Return whether two equations hold at the same configurations of quarter turns."""
    arm = place.checker.names.arm
    assert arm is not None
    random = np.random.default_rng(2)
    turns = random.integers(-2, 3, (400, len(arm.joints))) * 0.5
    scale = [np.pi if joint.kind == "revolute" else 1.0 for joint in arm.joints]
    lengths = {symbol: random.uniform(0.2, 1.4, len(turns)) for symbol in arm.lengths}
    algebra = SampledAlgebra(place.checker.exact, turns * scale, 2, lengths)
    try:
        holds = [_close(*(_values(place, node, algebra)[0] for node in equation)) for equation in (a, b)]
    except (ArmproofError, TypeError, IndexError):
        return Opinion.UNKNOWN
    if not np.any(holds):  # a relation with lengths is met at no quarter turn: nothing was compared
        return Opinion.UNKNOWN
    return Opinion.EQUAL if (holds[0] == holds[1]).all() else Opinion.DIFFERENT


def _values(place: Place, node: n.Node, algebra: SampledAlgebra) -> tuple[np.ndarray, np.ndarray]:
    """Return the values for either sign of ±, as arrays (rows, columns, samples)."""
    return tuple(_array(Evaluator(place.checker.names, algebra, branch).evaluate(node), algebra) for branch in (1, -1))  # type: ignore[return-value]


def _array(value: object, algebra: SampledAlgebra) -> np.ndarray:
    value = as_scalar(value)
    if isinstance(value, Identity):
        value = identity(algebra, 3)
    if isinstance(value, list):
        value = Matrix(tuple((item,) for item in value))
    rows = value.rows if isinstance(value, Matrix) else ((value,),)
    return np.array([[np.broadcast_to(cell, (algebra.samples,)) for cell in row] for row in rows])


def _close(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.abs(a - b) <= TOLERANCE * (1 + np.abs(a))


def _far_from_zero(values: np.ndarray) -> bool:
    return bool((np.abs(values) > TOLERANCE).any())


def _holds_arcs(*nodes: n.Node) -> bool:
    return any(
        isinstance(below, n.Call) and below.function in ("acos", "asin", "atan", "atan2")
        for node in nodes
        for below in n.walk(node)
    )


def _close_as_angles(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.abs(np.remainder(a - b + np.pi, 2 * np.pi) - np.pi) <= 1e-6  # the arc cosine is steep at its ends
