"""Traced formulas in the exact algebra: each node once, constants as the exact numbers that they round."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from armproof.models.exact.numbers import TOLERANCE, exact_number, pi_multiple, square_of_root
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.algebra.ring import Scalar
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.functions.tracing.number import TracedNumber

_ARITHMETIC: dict[str, Callable[..., Scalar]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "negative": operator.neg,
}


class Formulas:
    """Turns traced numbers into scalars of a ring.

    A float is the short decimal, the fraction, the multiple of π or the square root of a rational that it rounds. One that
    equals a length of the arm may be lifted to its symbol: every claim about the symbols then holds at that value.
    """

    def __init__(self, exact: ExactAlgebra, lifted: Mapping[Fraction, str] | None = None) -> None:
        self.exact = exact
        self.lifted = dict(lifted or {})
        self._values: dict[int, Scalar] = {}
        self._angles: dict[int, Scalar] = {}
        self._pairs: dict[Any, tuple[Scalar, Scalar]] = {}

    def matrix(self, nodes: np.ndarray) -> Matrix:
        """Return a two-dimensional array of traced numbers as a matrix; raises EvaluationError for what has no value."""
        return Matrix(tuple(tuple(self.scalar(node) for node in row) for row in nodes))

    def scalar(self, node: TracedNumber) -> Scalar:
        """Return a traced number as a scalar."""
        return self._evaluate(node, self._values, lift=True)

    def _evaluate(self, root: TracedNumber, known: dict[int, Scalar], lift: bool) -> Scalar:
        """Evaluate what a node is made of before the node, without recursion: formulas of loops are deep."""
        pending = [root]
        while pending:
            node = pending[-1]
            if id(node) in known:
                pending.pop()
                continue
            is_leaf = node.operation in ("cos", "sin", "tan", "constant", "symbol")
            below = [] if is_leaf else [below for below in node.arguments if isinstance(below, TracedNumber)]
            missing = [operand for operand in below if id(operand) not in known]
            if missing:
                pending.extend(missing)
                continue
            known[id(node)] = self._value(node, [known[id(operand)] for operand in below], lift)
            pending.pop()
        return known[id(root)]

    def _value(self, node: TracedNumber, values: list[Scalar], lift: bool) -> Scalar:
        operation = node.operation
        if operation == "constant":
            return self._constant(node.arguments[0], lift)
        if operation == "symbol":
            return self.exact.symbol(node.arguments[0])
        if operation in ("cos", "sin", "tan"):
            cosine, sine = self._cos_sin(node.arguments[0])
            return cosine if operation == "cos" else sine if operation == "sin" else sine / cosine
        if operation in _ARITHMETIC:
            return _ARITHMETIC[operation](*values)
        if operation == "power":
            return values[0] ** node.arguments[1]
        if operation == "sqrt":
            return self.exact.sqrt(values[0])
        if operation == "abs":
            return self.exact.absolute(values[0])
        if operation in ("acos", "asin", "atan", "atan2"):
            return self.exact.arc(operation, values)
        raise OutsideAlgebra("the function {operation}", operation=operation)

    def _cos_sin(self, angle: TracedNumber) -> tuple[Scalar, Scalar]:
        value = self._evaluate(angle, self._angles, lift=False)
        key = frozenset((frozenset(powers.items()), c) for powers, c in value.ring.terms(value.numerator))
        if not value.denominator.is_one():
            return self.exact.cos_sin(value)
        if key not in self._pairs:
            self._pairs[key] = self.exact.cos_sin(value)
        return self._pairs[key]

    def _constant(self, number: int | float | Fraction, lift: bool) -> Scalar:
        if not isinstance(number, float):
            return self.exact.rational(Fraction(number))
        value, times = exact_constant(number)
        if times == "pi":
            return self.exact.pi() * self.exact.rational(value)
        if times == "sqrt":
            root = self.exact.sqrt(self.exact.rational(abs(value)))
            return root if value > 0 else -root
        if lift and abs(value) in self.lifted:
            symbol = self.exact.symbol(self.lifted[abs(value)])
            return symbol if value > 0 else -symbol
        return self.exact.rational(value)


@lru_cache(maxsize=4096)
def exact_constant(value: float) -> tuple[Fraction, str]:
    """Return the exact number that a float rounds: (x, "") for x, (x, "pi") for x π, (±x, "sqrt") for ±√x.

    Short decimals and small fractions come first; then multiples of π with a denominator up to 360, square roots of
    rationals up to 1000, and else the decimal of twelve digits.
    """
    number = exact_number(value)
    if abs(value) <= TOLERANCE or abs(number.denominator) <= 10**9:
        return number, ""
    if (multiple := pi_multiple(value)) is not None:
        return multiple, "pi"
    if (square := square_of_root(value)) is not None:
        return square if value > 0 else -square, "sqrt"
    return number, ""
