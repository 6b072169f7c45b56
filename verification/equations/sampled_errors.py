"""How far the two sides of an equation are from each other at samples of the double plant; loaded where that is asked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, align, angle_places
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

SINGULAR = 1e7  # samples beyond this size lie at a singularity of the formula and are left out
LEAST_SHARE = 0.05  # of the configurations drawn at random
LEAST = 8
FEW_NEAR = 4  # of the configurations drawn at random may be near a singularity: a wrong formula is so at many more
SETS_OF_LENGTHS = 3
EXACTLY = 1e-9
BESIDE = 50  # times the rounding: what is off by no more is hardly on another branch


@dataclass(frozen=True)
class SampledErrors:
    """The errors of an equation.

    Attributes:
        scaled: by 1 + size, (rows, columns, samples).
        counted: the samples at which they count, (samples,): the formulas have a value there.
        at_random: the samples that are drawn at random, (samples,).
        size: the largest true value among them.
    """

    scaled: np.ndarray
    counted: np.ndarray
    at_random: np.ndarray
    size: float

    @property
    def samples(self) -> int:
        """The number of samples at which they count."""
        return int(self.counted.sum())

    @property
    def largest(self) -> float:
        """The largest error at a sample that counts; 0 without one."""
        return float(self.scaled[..., self.counted].max(initial=0.0))

    @property
    def telling(self) -> SampledErrors:
        """The errors at the samples that are drawn at random alone, without the few largest: near a singularity a root of large numbers has few digits."""
        usable = self.counted & self.at_random
        largest = np.where(usable, self.scaled.max(axis=(0, 1)), -1.0)
        usable[np.argsort(largest)[-FEW_NEAR:]] = False
        return replace(self, counted=usable)

    @property
    def places(self) -> list[tuple[int, int]]:
        """The rows and columns of all entries, from 0."""
        return [(r, c) for r, row in enumerate(self.scaled) for c in range(len(row))]

    def wrong(self, tolerance: float) -> list[tuple[int, int]]:
        """Return the rows and columns of the entries that differ somewhere, from 0."""
        return [(int(r), int(c)) for r, c in np.argwhere((self.scaled[..., self.counted] > tolerance).any(axis=-1))]

    def where_equal(self, tolerance: float) -> SampledErrors:
        """Return the errors where only samples count at which every entry agrees."""
        return replace(self, counted=self._equal(tolerance) & self.counted)

    def holding(self, tolerance: float) -> np.ndarray:
        """Return at which samples that are drawn at random every entry agrees, (samples,)."""
        return self._equal(tolerance) & self.counted & self.at_random

    def on_a_branch(self, tolerance: float) -> tuple[int, int] | None:
        """Return at how many of how many configurations every entry agrees, or None where it is no branch.

        Square roots and arc functions have branches: an equation printed with one of them holds on that branch only.
        θ = arctan(y/x), θ = arccos D and sin θ = √(1 − D²) leave half a turn or a sign open that the configuration decides:
        each agrees with the arm in an open set of configurations. A wrong formula, being piecewise analytic, agrees nowhere
        but by chance, so that the families that are not drawn at random (zero, quarter turns) are left out.
        """
        usable = self.counted & self.at_random
        count, total = int((self._equal(tolerance) & usable).sum()), int(usable.sum())
        return (count, total) if count >= max(LEAST, LEAST_SHARE * total) else None

    def is_beside(self, tolerance: float, slacks: Iterable[SampledErrors]) -> bool:
        """Whether at many samples the sides differ by more than half a unit of each number makes, and by little more than rounding.

        On another branch they differ by any amount; by little at so many samples where a digit is wrong.
        """
        error, usable = self.scaled.max(axis=(0, 1)), self.counted & self.at_random
        slack = sum((each.scaled.max(axis=(0, 1)) for each in slacks), np.full_like(error, EXACTLY))
        beside = usable & (error > np.nan_to_num(slack, nan=np.inf)) & (error <= BESIDE * tolerance)
        return int(beside.sum()) >= max(LEAST, LEAST_SHARE * int(usable.sum()))

    def _equal(self, tolerance: float) -> np.ndarray:
        return np.all(self.scaled <= tolerance, axis=(0, 1))


def errors_between(
    names: Names,
    sampled: SampledAlgebra,
    true: n.Node,
    printed: n.Node,
    exact: Pair | None,
    branches: bool,
    only: int | None = None,
) -> SampledErrors | None:
    """Return the errors between two sides, on the nearest of their branches; None where one cannot be evaluated.

    `exact` are their exact values, where they have some: they tell the entries that are angles, equal up to whole turns.
    `only` is the sign that ± has, where the branches of the other one do not count.
    """
    places = angle_places(exact) if exact is not None else set()
    # without exact values the trees tell: a side that is an arc function is an angle
    loose = exact is None and any(_is_arc(node) for node in (true, printed))

    def angles(r: int, c: int) -> bool:
        return loose or (r, c) in places

    best: np.ndarray | None = None  # of the branch on which the equation as a whole is nearest, at each sample
    sizes: np.ndarray | None = None
    with np.errstate(all="ignore"):
        sampled.regular[:] = True
        for branch in names.state.signs.branches(branches):
            if only not in (None, branch):
                continue
            try:
                one = Evaluator(names, sampled, branch)
                pair = _aligned(one.evaluate(true), one.evaluate(printed), sampled, exact)
            except EvaluationError:
                return None
            errors = entry_errors(pair, angles)
            errors = np.broadcast_to(errors, (*errors.shape[:2], sampled.samples))
            size = np.abs(np.array([[np.broadcast_to(c, (sampled.samples,)) for c in row] for row in pair.true.rows]))
            if best is None:
                best = errors
            else:
                nearer = np.nan_to_num(errors, nan=np.inf).max(axis=(0, 1)) < np.nan_to_num(best, nan=np.inf).max(
                    axis=(0, 1)
                )
                best = np.where(nearer, errors, best)
            sizes = size if sizes is None else np.maximum(sizes, size)
        assert best is not None and sizes is not None
        scaled = best / (1.0 + sizes)
        finite = sampled.regular & np.isfinite(scaled).all(axis=(0, 1)) & (sizes < SINGULAR).all(axis=(0, 1))
    return SampledErrors(scaled, finite, sampled.random, float(sizes[..., finite].max(initial=0.0)))


def _aligned(true: Value, printed: Value, sampled: SampledAlgebra, exact: Pair | None) -> Pair:
    """Return two values as their exact ones were compared: rounding hides which rows of a Jacobian are zero."""
    if exact is not None and exact.true_rows is not None and isinstance(true, Matrix) and isinstance(printed, Matrix):
        columns = exact.true_columns or tuple(range(true.shape[1]))
        if (len(exact.true_rows), len(columns)) == printed.shape and max(exact.true_rows) < true.shape[0]:
            return Pair(true.block(exact.true_rows, columns), printed, exact.note)
    pairs = list(align(true, printed, sampled))
    return next((each for each in pairs if exact is None or each.note == exact.note), pairs[0])


def with_lengths(sampled: SampledAlgebra, stated: Mapping[str, float], unit: float = 1) -> Iterator[SampledAlgebra]:
    """Yield the samples of arms of other lengths than the model's, where the document states none: at random, and all alike."""
    lengths = [name for name in sampled.arm.lengths if name not in stated] if sampled.arm is not None else []
    if not lengths:
        return
    assert sampled.arm is not None
    fixed = {name: value for name, value in stated.items() if name in sampled.arm.lengths}
    generator = np.random.default_rng(len(lengths))
    for _ in range(SETS_OF_LENGTHS):
        drawn = {name: unit * generator.uniform(0.2, 1.2) for name in lengths}
        yield sampled.with_lengths({**drawn, **fixed})
    yield sampled.with_lengths({**dict.fromkeys(lengths, 0.5 * unit), **fixed})


def within_half_a_turn(sampled: SampledAlgebra, joints: Iterable[str]) -> SampledAlgebra:
    """Return samples at which joints have the angle of (−π, π] that they have but for whole turns."""
    turned = {joint: sampled.symbol(joint) for joint in joints}
    return sampled.at({joint: q - 2 * np.pi * np.round(q / (2 * np.pi)) for joint, q in turned.items()})


def vanishes_for_lengths(
    sampled: SampledAlgebra, stated: Mapping[str, float], scalar: Scalar, values: Mapping[str, Scalar]
) -> bool:
    """Whether a scalar is zero at the samples where joints have given values, for every set of lengths."""
    for other in with_lengths(sampled, stated):
        there = other.at({name: other.from_exact(value) for name, value in values.items()})
        if np.nanmax(np.abs(there.from_exact(scalar))) > 1e-6:
            return False
    return True


def entry_errors(pair: Pair, angles: Callable[[int, int], bool] = lambda _r, _c: False) -> np.ndarray:
    """Return |printed − true| of sampled values as an array (rows, columns, samples); up to whole turns for `angles`."""
    errors = []
    for place, a, b in pair.entries():
        error = np.abs(a - b)
        if angles(*place):
            error = np.minimum(error, np.abs(np.remainder(a - b + np.pi, 2 * np.pi) - np.pi))
        errors.append(error)
    return np.array(errors).reshape(*pair.true.shape, -1)


def _is_arc(node: n.Node) -> bool:
    """Whether an arc function stands in a tree outside of cosines and other functions."""
    if isinstance(node, n.Call):
        return node.function in n.ARCS
    return any(_is_arc(below) for below in n.children(node))
