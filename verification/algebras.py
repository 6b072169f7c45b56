"""The two algebras in which an expression is evaluated: exact scalars, and samples on the double plant.

Both offer the same operations, so that one evaluator serves the proof and its numerical second route. The exact one
takes the arm's quantities from its symbolic trace, the sampled one from the double plant.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any, Protocol

import numpy as np

from models.arm import Arm
from models.exact import angle_value
from verification.errors import EvaluationError, TooComplex
from verification.matrix import Matrix, column, exact_rank
from verification.quantities import COMPONENTS, Quantity
from verification.trig import Ring, Scalar

Value = Any  # a scalar of the algebra, or a Matrix of them


class OutsideAlgebra(EvaluationError):
    """The exact algebra has no such function; the equation can only be confirmed."""


class Algebra(Protocol):
    """What the evaluator needs of scalars."""

    def check_time(self) -> None:
        """Raise TooComplex when the display at hand has had its time."""
        ...

    def rational(self, value: Fraction) -> Any:
        """Return a rational constant."""
        ...

    def pi(self) -> Any:
        """Return π."""
        ...

    def symbol(self, name: str) -> Any:
        """Return a joint variable, a length, a constant angle or a free letter."""
        ...

    def cos_sin(self, angle: Any) -> tuple[Any, Any]:
        """Return the cosine and sine of an angle."""
        ...

    def sqrt(self, value: Any) -> Any:
        """Return the non-negative square root."""
        ...

    def arc(self, function: str, arguments: list[Any]) -> Any:
        """Return acos, asin, atan (one argument) or atan2 (y, x)."""
        ...

    def absolute(self, value: Any) -> Any:
        """Return the absolute value."""
        ...

    def derivative(self, value: Any, variable: Any) -> Any:
        """Return the partial derivative with respect to a variable."""
        ...

    def rank(self, matrix: Matrix) -> Any:
        """Return the rank of a matrix, as a scalar."""
        ...

    def quantity(self, quantity: Quantity) -> Value:
        """Return a quantity of the arm: a Matrix, or a scalar where one component is meant."""
        ...

    def substitute(self, value: Value, values: Mapping[str, Any]) -> Value:
        """Return a value with joint variables or lengths replaced."""
        ...



class ExactAlgebra:
    """Scalars of a ring; the arm's quantities as its symbolic trace gives them."""

    def __init__(self, ring: Ring, arm: Arm | None) -> None:
        self.ring = ring
        self.arm = arm
        self._cache: dict[Quantity, Value] = {}

    def check_time(self) -> None:
        self.ring.check_time()

    def rational(self, value: Fraction) -> Scalar:
        return self.ring.rational(value)

    def pi(self) -> Scalar:
        return self.ring.generator(("pi", ""))

    def symbol(self, name: str) -> Scalar:
        return self.ring.symbol(name)

    def cos_sin(self, angle: Scalar) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of a sum of angles; raises OutsideAlgebra for what is none, such as cos(ω t)."""
        try:
            return self.ring.cos_sin(angle)
        except TooComplex:
            raise
        except EvaluationError as problem:
            raise OutsideAlgebra(str(problem)) from None

    def sqrt(self, value: Scalar) -> Scalar:
        return self.ring.sqrt(value)

    def arc(self, function: str, arguments: list[Scalar]) -> Scalar:
        """Return an arc function as an angle whose cosine and sine are known."""
        ring = self.ring
        if function == "atan2":
            return ring.atan2(*arguments)
        (u,) = arguments
        if function == "atan":
            return ring.atan2(u, ring.one)
        other = ring.sqrt(ring.one - u * u)
        return ring.arc(u, other) if function == "acos" else ring.arc(other, u)

    def absolute(self, value: Scalar) -> Scalar:
        number = value.as_fraction()
        if number is None:
            raise OutsideAlgebra("an absolute value")
        return self.ring.rational(abs(number))

    def derivative(self, value: Scalar, variable: Scalar) -> Scalar:
        return self.ring.derivative(value, variable)

    def rank(self, matrix: Matrix) -> Scalar:
        return self.ring.rational(exact_rank(matrix))

    def substitute(self, value: Value, values: Mapping[str, Scalar]) -> Value:
        """Return a value with joint variables and lengths replaced."""
        if isinstance(value, Matrix):
            return value.map(lambda cell: self.ring.substitute(cell, values))
        return self.ring.substitute(value, values)

    def quantity(self, quantity: Quantity) -> Value:
        if quantity not in self._cache:
            self._cache[quantity] = _select(quantity, self.whole(quantity))
        return self._cache[quantity]

    def whole(self, quantity: Quantity) -> Matrix:
        if quantity.kind == "link":
            return link_matrix(self, quantity.frame)
        assert self.arm is not None
        if quantity.kind in ("joint", "vector"):
            symbols = [quantity.frame] if quantity.kind == "joint" else [joint.symbol for joint in self.arm.joints]
            return column([self.symbol(symbol) for symbol in symbols])
        trace = self.arm.trace
        if quantity.kind == "jacobian":
            rows: Any = trace.jacobian(quantity.frame, quantity.reference, self.arm.frames[0])
        elif quantity.kind == "difference":
            to, start = (self._poses(frame, quantity.reference) for frame in (quantity.frame, quantity.start))
            return column([a - b for a, b in zip(to.block(range(3), [3]).vector(), start.block(range(3), [3]).vector(), strict=True)])
        else:
            return _part_of_pose(quantity, self._poses(quantity.frame, quantity.reference))
        return self._from_entries(rows)

    def _poses(self, frame: str, reference: str) -> Matrix:
        assert self.arm is not None
        return self._from_entries(self.arm.trace.pose(frame, reference))

    def _from_entries(self, rows: Any) -> Matrix:
        return Matrix(tuple(tuple(self.ring.from_entry(entry) for entry in row) for row in rows))


class SampledAlgebra:
    """Arrays over N configurations; the arm's quantities as the double plant gives them."""

    def __init__(
        self, exact: ExactAlgebra, q: np.ndarray, seed: int = 0, overrides: Mapping[str, np.ndarray] | None = None
    ) -> None:
        self.exact = exact
        self.arm = arm = exact.arm
        self.q = q
        self.seed = seed
        self.overrides = dict(overrides or {})
        self.free: dict[str, np.ndarray] = {}
        self.regular = np.ones(len(q), dtype=bool)
        self.random = np.ones(len(q), dtype=bool)  # which samples are drawn at random, and not at a special configuration
        self._numeric = arm.numeric(q) if arm is not None else None
        self._cache: dict[Quantity, Value] = {}

    @property
    def samples(self) -> int:
        """The number of configurations."""
        return len(self.q)

    def check_time(self) -> None:
        self.exact.ring.check_time()

    def rational(self, value: Fraction) -> np.ndarray:
        return _constant(float(value), self.samples)

    def pi(self) -> np.ndarray:
        return _constant(np.pi, self.samples)

    def symbol(self, name: str) -> np.ndarray:
        if name in self.overrides:
            return self.overrides[name]
        if self.arm is not None:
            for index, joint in enumerate(self.arm.joints):
                if joint.symbol == name:
                    return self.q[:, index]
            known = {**self.arm.lengths, **self.arm.angles}
            if name in known:
                return _constant(known[name], self.samples)
        if name not in self.free:
            digest = np.frombuffer(name.encode("utf-8"), dtype=np.uint8)
            generator = np.random.default_rng([self.seed, *digest.tolist()])
            values = generator.uniform(0.3, 2.2, self.samples)
            self.free[name] = values
        return self.free[name]

    def exclude_near_zeros(self, denominator: np.ndarray) -> None:
        """Mark the samples at which a denominator is smaller than a ten-thousandth of what it usually is."""
        size = np.abs(denominator)
        if not np.isfinite(size).any():
            self.regular[:] = False
            return
        self.regular &= size > 1e-4 * np.nanpercentile(size, 95)

    def cos_sin(self, angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.cos(angle), np.sin(angle)

    def sqrt(self, value: np.ndarray) -> np.ndarray:
        # rounding may leave a hair below zero where the root is of a square
        return np.sqrt(np.where((value < 0) & (value > -1e-9), 0.0, value))

    def arc(self, function: str, arguments: list[np.ndarray]) -> np.ndarray:
        if function == "atan2":
            return np.arctan2(*arguments)
        (u,) = arguments
        if function == "atan":
            return np.arctan(u)
        self.regular &= np.abs(np.abs(u) - 1) > 1e-8  # at ±1 half the digits are lost
        near = np.where((np.abs(u) > 1) & (np.abs(u) < 1 + 1e-9), np.sign(u), u)
        return np.arccos(near) if function == "acos" else np.arcsin(near)

    def absolute(self, value: np.ndarray) -> np.ndarray:
        return np.abs(value)

    def derivative(self, value: np.ndarray, variable: np.ndarray) -> np.ndarray:
        raise EvaluationError("a derivative is taken exactly, then sampled")

    def from_exact(self, value: Value) -> Value:
        """Return an exact value at the samples."""
        if isinstance(value, Matrix):
            return value.map(self.from_exact)
        ring = value.ring
        return self._sample(ring, value.numerator) / self._sample(ring, value.denominator)

    def _sample(self, ring: Ring, polynomial: Any) -> np.ndarray:
        total = np.zeros(self.samples)
        for powers, coefficient in ring.terms(polynomial):
            term = np.full(self.samples, float(coefficient))
            for generator, power in powers.items():
                term = term * self._generator(ring, generator) ** power
            total = total + term
        return total

    def _generator(self, ring: Ring, generator: tuple[str, str]) -> np.ndarray:
        kind, name = generator
        if kind == "symbol":
            return self.symbol(name)
        if kind in ("cos", "sin"):
            angle = self._angle(name)
            return np.cos(angle) if kind == "cos" else np.sin(angle)
        if kind == "pi":
            return self.pi()
        if kind == "sqrt":
            return self.rational(Fraction(int(name))) ** 0.5
        if kind == "radical":
            return self.sqrt(self.from_exact(ring.radicand(name)))
        cosine, sine = ring.arcs[name]
        return np.arctan2(self.from_exact(sine), self.from_exact(cosine))

    def _angle(self, name: str) -> np.ndarray:
        if "pi/" in name or re.fullmatch(r"[\d.]+", name):
            return _constant(angle_value(name), self.samples)
        symbol, _, parts = name.rpartition("/")
        if symbol and parts.isdigit():
            return self.symbol(symbol) / int(parts)
        return self.symbol(name)

    def rank(self, matrix: Matrix) -> np.ndarray:
        stacked = np.array([[np.broadcast_to(cell, (self.samples,)) for cell in row] for row in matrix.rows])
        ranks = np.linalg.matrix_rank(np.moveaxis(stacked, -1, 0), tol=1e-9).astype(float)
        self.regular &= ranks == ranks.max()  # the rank is that of a generic configuration; the singular ones are left out
        return ranks

    def substitute(self, value: Value, values: Mapping[str, Any]) -> Value:
        raise EvaluationError("samples are taken anew at a configuration")

    def at(self, values: Mapping[str, np.ndarray]) -> SampledAlgebra:
        """Return the algebra at configurations in which some joint variables or lengths have other values."""
        q = self.q.copy()
        overrides = dict(self.overrides)
        for name, value in values.items():
            index = next((i for i, joint in enumerate(self.arm.joints) if joint.symbol == name), None) if self.arm else None
            if index is None:
                overrides[name] = value
            else:
                q[:, index] = value
        moved = SampledAlgebra(self.exact, q, self.seed, overrides)
        moved.free, moved.regular, moved.random = self.free, self.regular, self.random
        return moved

    def quantity(self, quantity: Quantity) -> Value:
        if quantity not in self._cache:
            self._cache[quantity] = _select(quantity, self.whole(quantity))
        return self._cache[quantity]

    def whole(self, quantity: Quantity) -> Matrix:
        if quantity.kind == "link":
            return link_matrix(self, quantity.frame)
        if self.arm is not None and any(name in self.arm.lengths or name in self.arm.angles for name in self.overrides):
            # the double plant keeps the lengths of its URDF and the angles of its table: at others the exact trace is sampled
            return self.from_exact(self.exact.whole(quantity))
        assert self.arm is not None and self._numeric is not None
        if quantity.kind in ("joint", "vector"):
            symbols = [quantity.frame] if quantity.kind == "joint" else [joint.symbol for joint in self.arm.joints]
            return column([self.symbol(symbol) for symbol in symbols])
        if quantity.kind == "jacobian":
            return _from_stack(self._numeric.jacobian(quantity.frame, quantity.reference, self.arm.frames[0]))
        pose = _from_stack(self._numeric.pose(quantity.frame, quantity.reference))
        if quantity.kind == "difference":
            start = _from_stack(self._numeric.pose(quantity.start, quantity.reference))
            pairs = zip(pose.block(range(3), [3]).vector(), start.block(range(3), [3]).vector(), strict=True)
            return column([a - b for a, b in pairs])
        return _part_of_pose(quantity, pose)


@lru_cache(maxsize=512)
def _constant(value: float, samples: int) -> np.ndarray:
    constant = np.full(samples, value)
    constant.flags.writeable = False
    return constant


def _from_stack(stack: np.ndarray) -> Matrix:
    _, rows, columns = stack.shape
    return Matrix(tuple(tuple(np.ascontiguousarray(stack[:, r, c]) for c in range(columns)) for r in range(rows)))


def _part_of_pose(quantity: Quantity, pose: Matrix) -> Matrix:
    if quantity.kind == "rotation":
        return pose.block(range(3), range(3))
    if quantity.kind == "origin":
        return pose.block(range(4 if quantity.homogeneous else 3), [3])
    if quantity.kind == "axis":
        return pose.block(range(4 if quantity.homogeneous else 3), [COMPONENTS[quantity.along]])
    return pose


def _select(quantity: Quantity, whole: Matrix) -> Value:
    size, width = whole.shape
    rows = quantity.rows or tuple(range(1, size + 1))
    columns = quantity.columns or tuple(range(1, width + 1))
    if max(rows) > size or max(columns) > width:
        raise EvaluationError(f"row {max(rows)} or column {max(columns)} of a {whole.size} matrix")
    chosen = whole.block([r - 1 for r in rows], [c - 1 for c in columns])
    return chosen.rows[0][0] if quantity.scalar else chosen


def elementary(algebra: Algebra, function: str, axis: str, amount: Any) -> Matrix:
    """Return Rot(axis, θ) or Trans(axis, d), 4×4."""
    one, zero = algebra.rational(Fraction(1)), algebra.rational(Fraction(0))
    rows = [[one if r == c else zero for c in range(4)] for r in range(4)]
    k = COMPONENTS[axis]
    if function == "Trans":
        rows[k][3] = amount
    else:
        c, s = algebra.cos_sin(amount)
        i, j = (k + 1) % 3, (k + 2) % 3
        rows[i][i], rows[i][j], rows[j][i], rows[j][j] = c, -s, s, c
    return Matrix(tuple(tuple(row) for row in rows))


def link_matrix(algebra: Algebra, convention: str) -> Matrix:
    """Return the general link matrix ^{i-1}T_i of a convention.

    modified: Rot_x(α_{i-1}) Trans_x(a_{i-1}) Rot_z(θ_i) Trans_z(d_i) (Khalil & Kleinfinger 1986; Craig);
    classic: Rot_z(θ_i) Trans_z(d_i) Trans_x(a_i) Rot_x(α_i) (Denavit & Hartenberg 1955).
    """
    index = "i-1" if convention == "modified" else "i"
    theta, d = algebra.symbol("theta_i"), algebra.symbol("d_i")
    a, alpha = algebra.symbol(f"a_{index}"), algebra.symbol(f"alpha_{index}")
    along_z = elementary(algebra, "Rot", "z", theta) @ elementary(algebra, "Trans", "z", d)
    along_x = elementary(algebra, "Trans", "x", a) @ elementary(algebra, "Rot", "x", alpha)
    return along_x @ along_z if convention == "modified" else along_z @ along_x
