"""The exact comparison of a function's formulas with an arm's quantities."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Sentence
from armproof.models.exact.numbers import exact_number
from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.diagnosis.causes.probes import probes
from armproof.verification.equations.alignment import Pair, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.functions.asked import Part
from armproof.verification.functions.formulas import Formulas, exact_constant
from armproof.verification.functions.returned import fit
from armproof.verification.naming.reading import read_names

MOST_GENERATORS = 128  # in a ring that is kept for the next check
_PLAIN = {Fraction(number) for number in ("0", "1/2", "1", "2")}  # numbers that a formula holds beside its lengths
SECONDS_TO_DECIDE = 1.0


class Bench:
    """An arm with its exact algebra; the ring grows with the formulas met."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm
        self.ring = Ring()
        self.exact = ExactAlgebra(self.ring, arm)
        self.names = read_names(arm, {})
        self.checker = ChainChecker(self.names, self.exact, lambda: SampledAlgebra(self.exact, probes(arm).q))
        self.numbers = {symbol: _exact(self.exact, value) for symbol, value in {**arm.lengths, **arm.angles}.items()}
        self.written: dict[Scalar, str] = {}  # the arm's own entries, by identity
        self._true: dict[Quantity, Matrix] = {}
        self._lengths_in: dict[Quantity, list[str]] = {}
        self.lifted: dict[Fraction, str] = {}
        for symbol, length in arm.lengths.items():
            value = exact_number(abs(length))
            if value not in _PLAIN:
                self.lifted.setdefault(value, symbol)

    def true(self, quantity: Quantity) -> Matrix:
        """Return a quantity of the arm, a scalar as a 1×1 matrix."""
        if quantity not in self._true:
            with self.ring.budget.of(math.inf):  # the arm's own, once for all checks
                value = self.exact.quantity(quantity)
            self._true[quantity] = as_matrix(value)
        return self._true[quantity]

    def lengths_in(self, quantity: Quantity) -> list[str]:
        """Return the lengths, and constant angles, on which a quantity depends."""
        if quantity not in self._lengths_in:
            names = symbols_in(self.true(quantity).cells)
            self._lengths_in[quantity] = [symbol for symbol in self.numbers if symbol in names]
        return self._lengths_in[quantity]

    def equal_at_the_lengths(self, one: Scalar, other: Scalar, but: Collection[str] = ()) -> bool:
        """Whether two scalars are equal with the arm's own numbers for its lengths and constant angles, but for some."""
        numbers = {symbol: number for symbol, number in self.numbers.items() if symbol not in but}
        return bool(numbers) and exactly_equal(substitute(one, numbers), substitute(other, numbers))


def _exact(exact: ExactAlgebra, value: float) -> Scalar:
    """Return the exact length, or angle in radians, that a float rounds."""
    number, unit = exact_constant(value)
    if unit == "pi":
        return exact.pi() * exact.rational(number)
    return exact.rational(exact_number(value))


def bench_of(arm: Arm) -> Bench:
    """Return the bench of an arm: the one of the check before, unless its ring has grown large or met a fraction of an angle."""
    kept = _kept_bench(arm)
    if kept.ring.size > MOST_GENERATORS or kept.ring.parts:
        _kept_bench.cache_clear()
        kept = _kept_bench(arm)
    return kept


@lru_cache(maxsize=16)
def _kept_bench(arm: Arm) -> Bench:
    return Bench(arm)


@dataclass(frozen=True)
class Proof:
    """The formulas of a traced function, one array a quantity, and which of them are proved equal to the arm's.

    Attributes:
        nodes: the traced numbers of each quantity, in its shape.
        proved: for which quantities, in their order.
        for_all_lengths: whether the lengths stayed symbols in each.
        different: the entries of each that are right at the arm's lengths alone, though the function takes lengths.
    """

    bench: Bench
    formulas: Formulas
    nodes: tuple[np.ndarray, ...]
    proved: tuple[bool, ...]
    for_all_lengths: tuple[bool, ...]
    different: tuple[tuple[tuple[int, int], ...], ...]

    def entry(self, number: int, row: int, column: int) -> Scalar:
        """Return the exact value of an entry (from 0) of a quantity (from 1); raises EvaluationError where it has none."""
        return self.formulas.scalar(self.nodes[number - 1][row, column])


def prove(arm: Arm, parts: list[Part], traced: list[np.ndarray], taken: Collection[str]) -> Proof | str:
    """Compare traced formulas with the quantities of an arm; return why it cannot be done where it cannot.

    Args:
        taken: the lengths that the function takes: they stay symbols, and no number in it is taken for a length.
    """
    try:
        return _prove(bench_of(arm), parts, traced, taken)
    except (EvaluationError, RecursionError) as problem:
        return str(problem)


def _prove(bench: Bench, parts: list[Part], traced: list[np.ndarray], taken: Collection[str]) -> Proof | str:
    formulas = Formulas(bench.exact, {} if taken else bench.lifted)
    fitted = [fit(nodes, part.shape) for part, nodes in zip(parts, traced, strict=True)]
    nodes = tuple(one.values for one in fitted if one is not None)
    if len(nodes) < len(parts):
        return Sentence("the traced function returns another shape")
    for part in parts:
        bench.true(part.asked.quantity)
    with bench.ring.budget.of(SECONDS_TO_DECIDE):
        found = [
            _compare(bench, part, formulas.matrix(values), taken) if not part.wrong else _UNEQUAL
            for part, values in zip(parts, nodes, strict=True)
        ]
    return Proof(bench, formulas, nodes, *zip(*found, strict=True))


_Compared = tuple[bool, bool, tuple[tuple[int, int], ...]]
_UNEQUAL: _Compared = (False, False, ())


def _compare(bench: Bench, part: Part, value: Matrix, taken: Collection[str]) -> _Compared:
    """Return whether all entries are equal, whether for all lengths, and those that are so at the arm's lengths alone.

    A length that the function takes stays a symbol: at its own value a wrong formula may be right by chance.
    """
    true, everywhere, different = bench.true(part.asked.quantity), True, []
    for place, a, b in Pair(true, value).entries():
        if exactly_equal(a, b):
            continue
        everywhere = False
        if bench.equal_at_the_lengths(a, b, but=taken):
            continue
        if not bench.equal_at_the_lengths(a, b):
            return _UNEQUAL
        different.append(place)
    return not different, everywhere, tuple(different)
