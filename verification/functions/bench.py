"""What checks of one arm's functions share: its exact quantities, and the configurations at which functions are tried."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache

from armproof.models.arm import Arm
from armproof.models.exact.numbers import exact_number
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.diagnosis.causes.probes import probes
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.functions.formulas import exact_constant
from armproof.verification.naming.names import read_names

MOST_GENERATORS = 128  # in a ring that is kept for the next check
_PLAIN = {Fraction(number) for number in ("0", "1/2", "1", "2")}  # numbers that a formula holds beside its lengths


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
            self._true[quantity] = value if isinstance(value, Matrix) else Matrix(((value,),))
        return self._true[quantity]

    def lengths_in(self, quantity: Quantity) -> list[str]:
        """Return the lengths, and constant angles, on which a quantity depends."""
        if quantity not in self._lengths_in:
            cells = [cell for row in self.true(quantity).rows for cell in row]
            names = {name for cell in cells for powers, _ in self.ring.terms(cell.numerator) for _, name in powers}
            self._lengths_in[quantity] = [symbol for symbol in self.numbers if symbol in names]
        return self._lengths_in[quantity]

    def at_the_lengths(self, value: Scalar) -> Scalar:
        """Return a scalar with the arm's own numbers for its lengths and constant angles."""
        return substitute(value, self.numbers)


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
