"""Points of a set of configurations in floating point: drawn at random, projected on its conditions, and measured."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.configurations import joint_range
from armproof.verification.patterns import regex
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial

STEPS = 30
ZERO = 1e-12  # what a condition may be off at a point that counts as on it, relative to the size of its terms
_AT_REST = 1e-14  # a step below which a point has arrived: the next one would be rounding
_FRACTION = regex(r"(.+)/(\d+)")


@dataclass(frozen=True)
class Unknown:
    """A joint variable (or another symbol) that is drawn: an angle, or a number between two bounds."""

    name: str
    is_angle: bool
    lower: float = -1.0
    upper: float = 1.0


def joint_unknowns(arm: Arm) -> tuple[Unknown, ...]:
    """Return the joint variables of an arm, base to tool; a prismatic joint without limits moves between ±1 m."""
    return tuple(
        Unknown(joint.symbol, joint.kind == "revolute", *joint_range(joint.lower, joint.upper, joint.kind, slide=1.0))
        for joint in arm.joints
    )


def unknowns_of(half: HalfAngles, arm: Arm | None, constants: Mapping[str, float]) -> tuple[Unknown, ...]:
    """Return the joint variables of an arm, and what other symbols and angles occur that are no constants."""
    found = joint_unknowns(arm) if arm is not None else ()
    known = {unknown.name for unknown in found} | set(constants)
    for name in half.angles:
        symbol = _angle_symbol(name, known)[0]
        if symbol not in known:
            found, known = (*found, Unknown(symbol, True)), known | {symbol}
    for kind, name in half.others:
        if kind == "symbol" and name not in known:
            found = (*found, Unknown(name, False))
    return found


def _angle_symbol(name: str, known: Collection[str]) -> tuple[str, int]:
    """Return (θ, 2) for the angle θ/2 of a ring in which half of it is the generator."""
    match = _FRACTION.fullmatch(name)
    return (match.group(1), int(match.group(2))) if match and name not in known else (name, 1)


@dataclass(frozen=True, eq=False)
class Sampler:
    """Evaluates polynomials in half-angle coordinates at joint values.

    Attributes:
        half: the coordinates.
        unknowns: what the columns of q are.
        constants: the values of lengths and constant angles.
        columns: the places of the unknowns that move, from 0, as the columns of J; all if empty.
    """

    half: HalfAngles
    unknowns: tuple[Unknown, ...]
    constants: Mapping[str, float]
    columns: tuple[int, ...] = ()

    @cached_property
    def _place(self) -> dict[str, int]:
        return {unknown.name: k for k, unknown in enumerate(self.unknowns)}

    @cached_property
    def _known(self) -> set[str]:
        return {*self._place, *self.constants}

    def _angle(self, name: str, q: np.ndarray) -> np.ndarray:
        symbol, parts = _angle_symbol(name, self._known)
        return self._value(symbol, q) / parts

    def _value(self, symbol: str, q: np.ndarray) -> np.ndarray:
        if symbol in self._place:
            return np.asarray(q[:, self._place[symbol]])
        return np.full(len(q), self.constants[symbol])

    def solved_constants(self, values: Mapping[int, Polynomial]) -> dict[str, float]:
        """Return the constants that conditions on the lengths fix, in terms of the others."""
        x = self.coordinates(np.zeros((1, len(self.unknowns))))
        places = {self.half.slot(g): g[1] for g in self.half.others}
        return {places[slot]: float(_Terms.of(value).at(x)[0]) for slot, value in values.items() if slot in places}

    def coordinates(self, q: np.ndarray) -> np.ndarray:
        """Return the value of each variable, (variables, N): sin and cos of half angles, then the others."""
        values: list[np.ndarray] = []
        for name in self.half.angles:
            angle = self._angle(name, q) / 2
            values += [np.sin(angle), np.cos(angle)]
        for kind, name in self.half.others:
            values.append(np.full(len(q), float(name) ** 0.5) if kind == "sqrt" else self._value(name, q))
        return np.array(values).reshape(len(values), len(q))

    def values(self, polynomials: Sequence[Polynomial], q: np.ndarray) -> np.ndarray:
        """Return polynomials at N configurations, (N, polynomials)."""
        return self._values([_Terms.of(polynomial) for polynomial in polynomials], q)

    def _values(self, polynomials: Sequence[_Terms], q: np.ndarray) -> np.ndarray:
        x = self.coordinates(q)
        return np.stack([p.at(x) for p in polynomials], axis=1) if polynomials else np.zeros((len(q), 0))

    def sizes(self, polynomials: Sequence[Polynomial], q: np.ndarray) -> np.ndarray:
        """Return sums of the absolute values of the terms, sines and cosines taken as 1, (N, polynomials)."""
        x = np.abs(self.coordinates(q))
        x[: 2 * len(self.half.angles)] = 1.0
        return np.stack([_Terms.of(p).at(x, absolute=True) for p in polynomials], axis=1)

    def gradients(self, polynomials: Sequence[Polynomial], q: np.ndarray) -> np.ndarray:
        """Return ∂polynomial/∂q at N configurations, (N, polynomials, n)."""
        return self._gradients([self._slopes(polynomial) for polynomial in polynomials], q)

    def _slopes(self, polynomial: Polynomial) -> dict[int, _Terms]:
        return {j: _Terms.of(derivative) for j, derivative in self._derivatives(polynomial).items()}

    def _gradients(self, derivatives: Sequence[Mapping[int, _Terms]], q: np.ndarray) -> np.ndarray:
        x = self.coordinates(q)
        found = np.zeros((len(q), len(derivatives), len(self.unknowns)))
        for k, of_one in enumerate(derivatives):
            for j, derivative in of_one.items():
                found[:, k, j] = derivative.at(x)
        return found

    def derivatives(self, polynomial: Polynomial) -> dict[int, Polynomial]:
        """Return the derivatives with respect to the joints that move and occur, by column of J, from 0."""
        found = self._derivatives(polynomial)
        columns = self.columns or tuple(range(len(self.unknowns)))
        return {columns.index(k): derivative for k, derivative in found.items() if k in columns}

    def _derivatives(self, polynomial: Polynomial) -> dict[int, Polynomial]:
        found: dict[int, Polynomial] = {}
        angles, others = self.half.used(polynomial)
        for name in angles:
            symbol, _ = _angle_symbol(name, self._known)
            if symbol in self._place:
                found[self._place[symbol]] = angle_derivative(self.half, polynomial, name)
        for generator in others:
            if generator[1] in self._place:
                found[self._place[generator[1]]] = polynomial.derivative(self.half.slot(generator))
        return found

    def draw(self, rng: np.random.Generator, count: int) -> np.ndarray:
        """Return configurations at random: angles of a whole turn, prismatic joints within their limits, (count, n)."""
        q = np.empty((count, len(self.unknowns)))
        for k, unknown in enumerate(self.unknowns):
            low, high = (-np.pi, np.pi) if unknown.is_angle else (unknown.lower, unknown.upper)
            q[:, k] = rng.uniform(low, high, count)
        return q

    def project(self, polynomials: Sequence[Polynomial], q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return configurations near the given ones at which all polynomials vanish (Gauss–Newton), and which succeeded."""
        q = q.copy()
        moving = np.arange(len(q) if polynomials else 0)
        terms = [_Terms.of(polynomial) for polynomial in polynomials]
        derivatives = [self._slopes(polynomial) for polynomial in polynomials]
        for _ in range(STEPS):
            if not len(moving):
                break
            value, gradient = self._values(terms, q[moving]), self._gradients(derivatives, q[moving])
            step = np.einsum("nij,nj->ni", np.linalg.pinv(gradient, rcond=1e-9), value)
            length = np.linalg.norm(step, axis=1, keepdims=True)
            q[moving] -= step * np.minimum(1.0, 1.0 / np.maximum(length, 1e-300))
            moving = moving[length[:, 0] > _AT_REST]
        if not polynomials:
            return q, np.ones(len(q), dtype=bool)
        turning = [k for k, unknown in enumerate(self.unknowns) if unknown.is_angle]
        q[:, turning] = np.mod(q[:, turning] + np.pi, 2 * np.pi) - np.pi
        return q, (np.abs(self._values(terms, q)) <= ZERO * self.sizes(polynomials, q)).all(axis=1)

    def sample(self, polynomials: Sequence[Polynomial], rng: np.random.Generator, count: int) -> np.ndarray:
        """Return up to `count` configurations at which all polynomials vanish, (≤ count, n)."""
        found = np.zeros((0, len(self.unknowns)))
        for _ in range(8):
            q, good = self.project(polynomials, self.draw(rng, 2 * (count - len(found)) + 16))
            found = np.concatenate([found, q[good]])
            if len(found) >= count:
                break
        return found[:count]

    def distance(self, polynomials: Sequence[Polynomial], q: np.ndarray) -> np.ndarray:
        """Return, to first order, how far configurations are from the zeros of polynomials (rad, m), (N,)."""
        value, gradient = self.values(polynomials, q), self.gradients(polynomials, q)
        size = np.maximum(np.linalg.norm(gradient, axis=2), 1e-300)
        return np.asarray(np.max(np.abs(value) / size, axis=1, initial=0.0))


def angle_derivative(half: HalfAngles, polynomial: Polynomial, angle: str) -> Polynomial:
    """Return ½ (u ∂_t − t ∂_u): the derivative with respect to the angle where t² + u² = 1."""
    t, u = half.slots(angle)
    sine, cosine = half.pair(angle)
    return (cosine * polynomial.derivative(t) - sine * polynomial.derivative(u)) / 2


@dataclass(frozen=True, eq=False)
class _Terms:
    """The coefficients (terms,) and exponents (terms, variables) of a polynomial, to be evaluated at many points."""

    numbers: np.ndarray
    exponents: np.ndarray

    @staticmethod
    def of(polynomial: Polynomial) -> _Terms:
        numbers = [float(c.p) / float(c.q) for c in polynomial.coeffs()]
        variables = polynomial.context().nvars()
        return _Terms(np.array(numbers), np.array(polynomial.monoms(), dtype=int).reshape(len(numbers), variables))

    def at(self, x: np.ndarray, *, absolute: bool = False) -> np.ndarray:
        """Return the value where the variables are the rows of x, (variables, N); of the terms without their signs."""
        terms = np.repeat((np.abs(self.numbers) if absolute else self.numbers)[:, None], x.shape[1], axis=1)
        for k in np.flatnonzero(self.exponents.any(axis=0)):
            powers = x[k] ** np.arange(self.exponents[:, k].max() + 1)[:, None]
            terms *= powers[self.exponents[:, k]]
        return np.asarray(terms.sum(axis=0))
