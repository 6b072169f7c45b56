"""The sampled algebra: arrays over configurations, the arm's quantities from the double plant."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator
from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ArmAlgebra, ExactAlgebra

SAMPLES = 1000
SEED = 2019
_ALL_BUT_ZERO = 1e-4  # of a denominator, beside its largest values


def plant_samples(exact: ExactAlgebra) -> SampledAlgebra:
    """Return the algebra of arrays over the configurations of an exact algebra's arm; without one, over letters alone."""
    if exact.arm is None:
        return SampledAlgebra(exact, np.zeros((SAMPLES, 0)), SEED)
    q, at_random = _configurations(exact.arm)
    return SampledAlgebra(exact, q, SEED, random=at_random)


@lru_cache(maxsize=32)
def _configurations(arm: Arm) -> tuple[np.ndarray, np.ndarray]:
    """The configurations, and which of them are drawn at random."""
    q, family = sample(arm, SAMPLES, np.random.default_rng(SEED))
    return q, np.isin(family, [FAMILIES.index("generic"), FAMILIES.index("wide")])


class SampledAlgebra(ArmAlgebra):
    """Arrays over N configurations; the arm's quantities as the double plant gives them."""

    def __init__(
        self,
        exact: ExactAlgebra,
        q: np.ndarray,
        seed: int = 0,
        overrides: Mapping[str, np.ndarray] | None = None,
        random: np.ndarray | None = None,
    ) -> None:
        """Take the configurations, (N, n), the values that replace lengths or letters, and which q are drawn at random."""
        super().__init__(exact.arm)
        self._exact = exact
        self.q = q
        self.seed = seed
        self.overrides = dict(overrides or {})
        self.free: dict[str, np.ndarray] = {}
        self._generators: dict[tuple[Ring, Generator], np.ndarray] = {}
        self._with_lengths: dict[tuple[tuple[str, float], ...], SampledAlgebra] = {}
        self.regular = np.ones(len(q), dtype=bool)
        self.random = np.ones(len(q), dtype=bool) if random is None else random
        self.kinematics = _kinematics(self.arm, len(q), q.tobytes()) if self.arm is not None else None

    @property
    def exact(self) -> ExactAlgebra:
        """The exact algebra whose values are sampled."""
        return self._exact

    @property
    def samples(self) -> int:
        """The number of configurations."""
        return len(self.q)

    @property
    def budget(self) -> Budget:
        return self.exact.budget

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

    def divide_by(self, denominator: np.ndarray) -> None:
        """Leave the samples out at which a denominator is all but zero: rounding decides the quotient there."""
        size = np.abs(denominator)
        if size.min() > _ALL_BUT_ZERO * size.max():  # which no percentile exceeds
            return
        if not np.isfinite(size).any():
            self.regular[:] = False
            return
        self.regular &= size > _ALL_BUT_ZERO * np.nanpercentile(size, 95)

    def cos_sin(self, angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.cos(angle), np.sin(angle)

    def sqrt(self, value: np.ndarray) -> np.ndarray:
        # rounding may leave a hair below zero where the root is of a square
        return np.sqrt(np.where((value < 0) & (value > -1e-9), 0.0, value))

    def arc(self, function: str, arguments: list[np.ndarray]) -> np.ndarray:
        if function == "atan2":
            self.divide_by(np.hypot(*arguments))  # atan2(0, 0) has no value
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

    def symbols(self, value: np.ndarray) -> set[str]:
        raise EvaluationError("a derivative is taken exactly, then sampled")

    def from_exact(self, value: Value) -> Value:
        """Return an exact value at the samples."""
        if isinstance(value, Matrix):
            return value.map(self.from_exact)
        ring, numerator = value.ring, self._sample(value.ring, value.numerator)
        return numerator if value.denominator.is_one() else numerator / self._sample(ring, value.denominator)

    def stacked(self, value: Value) -> np.ndarray:
        """Return a sampled matrix or scalar as an array, (N, rows, columns)."""
        rows = value.rows if isinstance(value, Matrix) else ((value,),)
        return np.moveaxis(np.array([[np.broadcast_to(cell, (self.samples,)) for cell in row] for row in rows]), -1, 0)

    def _sample(self, ring: Ring, polynomial: Any) -> np.ndarray:
        total = np.zeros(self.samples)
        for powers, coefficient in ring.terms(polynomial):
            term: Any = float(coefficient)
            for generator, power in powers.items():
                values = self._generator(ring, generator)
                term = term * (values if power == 1 else values**power)
            total += term
        return total

    def _generator(self, ring: Ring, generator: Generator) -> np.ndarray:
        """Return a generator at the samples, each computed once."""
        if (ring, generator) not in self._generators:
            self._generators[ring, generator] = self._new_generator(ring, *generator)
        return self._generators[ring, generator]

    def _new_generator(self, ring: Ring, kind: str, name: str) -> np.ndarray:
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
        matrices = np.moveaxis(stacked, -1, 0)
        has_value = np.isfinite(matrices).all(axis=(1, 2))
        ranks = np.full(self.samples, np.nan)
        ranks[has_value] = np.linalg.matrix_rank(matrices[has_value], tol=1e-9)
        # the rank is that of a generic configuration; the singular ones are left out
        self.regular &= ranks == ranks[has_value].max(initial=0)
        return ranks

    def substitute(self, value: Value, values: Mapping[str, Any]) -> Value:
        raise EvaluationError("samples are taken anew at a configuration")

    def of_either_sign(self, names: Sequence[str]) -> SampledAlgebra:
        """Return the algebra at configurations in which each of these letters is negative at half of the samples, at random."""
        signs = np.random.default_rng(self.seed).choice((-1.0, 1.0), size=(len(names), self.samples))
        return self.at({name: sign * self.symbol(name) for name, sign in zip(names, signs, strict=True)})

    def with_lengths(self, lengths: Mapping[str, float]) -> SampledAlgebra:
        """Return the algebra of the arm with other lengths, one for all equations that are held against them."""
        key = tuple(sorted(lengths.items()))
        if key not in self._with_lengths:
            self._with_lengths[key] = self.at({name: np.full(self.samples, value) for name, value in key})
        return self._with_lengths[key]

    def at(self, values: Mapping[str, np.ndarray]) -> SampledAlgebra:
        """Return the algebra at configurations in which some joint variables or lengths have other values."""
        q = self.q.copy()
        overrides = dict(self.overrides)
        for name, value in values.items():
            index = (
                next((i for i, joint in enumerate(self.arm.joints) if joint.symbol == name), None) if self.arm else None
            )
            if index is None:
                overrides[name] = value
            else:
                q[:, index] = value
        finite = np.isfinite(q).all(axis=1)
        q[~finite] = 0.0  # as where an arccosine has no value: the plant takes finite joint values only
        self.regular &= finite
        moved = SampledAlgebra(self.exact, q, self.seed, overrides, self.random)
        moved.free, moved.regular = self.free, self.regular
        return moved

    def whole(self, quantity: Quantity) -> Matrix:
        if self._has_other_lengths() and quantity.kind != "link":
            # the double plant keeps the lengths of its URDF and the angles of its table: at others the exact trace is sampled
            return self.from_exact(self.exact.whole(quantity))
        return super().whole(quantity)

    def _has_other_lengths(self) -> bool:
        return self.arm is not None and any(
            name in self.arm.lengths or name in self.arm.angles for name in self.overrides
        )

    def pose(self, frame: str, reference: str) -> Matrix:
        assert self.kinematics is not None
        return _from_stack(self.kinematics.pose(frame, reference))

    def jacobian(self, frame: str, expressed_in: str) -> Matrix:
        assert self.arm is not None and self.kinematics is not None
        return _from_stack(self.kinematics.jacobian(frame, expressed_in, self.arm.frames[0]))


@lru_cache(maxsize=16)  # some megabytes each; the same come again in an arm's next display or document
def _kinematics(arm: Arm, samples: int, q: bytes) -> NumericKinematics:
    return NumericKinematics(arm, np.frombuffer(q).reshape(samples, len(arm.joints)))


@lru_cache(maxsize=512)
def _constant(value: float, samples: int) -> np.ndarray:
    constant = np.full(samples, value)
    constant.flags.writeable = False
    return constant


def _from_stack(stack: np.ndarray) -> Matrix:
    _, rows, columns = stack.shape
    return Matrix(tuple(tuple(np.ascontiguousarray(stack[:, r, c]) for c in range(columns)) for r in range(rows)))
