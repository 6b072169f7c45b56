"""Where a condition can hold: solved for one joint variable, with the lengths for which there is a solution."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod

from armproof.models.arm import Joint
from armproof.verification.algebra.calculus import angles_in, derivative
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.roots import sqrt
from armproof.verification.algebra.written import write_scalar
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.singularities.factors import Factor
from armproof.verification.singularities.writing import compact_notation, condition_scalar, write_condition


@dataclass(frozen=True)
class Existence:
    """When a condition has solutions, and what they are.

    Attributes:
        solved: LaTeX of the condition solved for one joint variable.
        condition: LaTeX of what the lengths must satisfy; "" where there is a solution for all lengths, None where it is not
            known in closed form.
    """

    solved: str
    condition: str | None


@dataclass(frozen=True)
class _Linear:
    """A cos θ + B sin θ + C, or A r + C for a prismatic variable (B is then zero)."""

    joint: Joint
    a: Scalar
    b: Scalar
    c: Scalar

    @property
    def rank(self) -> tuple[bool, int]:
        """How plain the solution is: without a constant term first, then with few terms."""
        return not self.c.is_zero(), sum(len(part.numerator) for part in (self.a, self.b, self.c))


def existence(factor: Factor, joints: Sequence[Joint]) -> Existence:
    """Return a condition solved for the joint variable in which that is plainest."""
    if factor.angle_sum is not None:
        return Existence(write_condition(factor), "")
    forms = [form for joint in joints if (form := _linear(factor, joint)) is not None]
    if not forms:
        return Existence(write_condition(factor), None)
    form = min(forms, key=lambda found: found.rank)
    if form.joint.kind == "prismatic":
        return Existence(f"{symbol_as_latex(form.joint.symbol)} = {_write(-form.c / form.a)}", "")
    return Existence(_solved(form), _solvable(form))


def _linear(factor: Factor, joint: Joint) -> _Linear | None:
    """Return the condition as a linear form in the cosine and sine of a joint (or in a prismatic variable), or None."""
    half = factor.half
    angles, others = half.used(factor.polynomial)
    value = condition_scalar(factor)
    ring = half.ring
    if joint.kind == "prismatic":
        if ("symbol", joint.symbol) not in others or factor.polynomial.degrees()[
            half.slot(("symbol", joint.symbol))
        ] > 1:
            return None
        slope = derivative(value, ring.symbol(joint.symbol))
        return _Linear(joint, slope, ring.zero, value - slope * ring.symbol(joint.symbol))
    if joint.symbol not in angles or half.degree(factor.polynomial, joint.symbol) != 2:
        return None
    parts = _linear_parts(value, joint.symbol)
    return None if parts is None else _Linear(joint, *parts)


def _linear_parts(value: Scalar, angle: str) -> tuple[Scalar, Scalar, Scalar] | None:
    """Return A, B, C of A cos θ + B sin θ + C; None where a term holds more than one of the two."""
    ring = value.ring
    parts = {"cos": ring.zero, "sin": ring.zero, "": ring.zero}
    for powers, coefficient in ring.terms(value.numerator):
        own = {g: power for g, power in powers.items() if g in (("cos", angle), ("sin", angle))}
        if sum(own.values()) > 1:
            return None
        others = (ring.generator(g) ** power for g, power in powers.items() if g not in own)
        key = next((kind for kind, _ in own), "")
        parts[key] = parts[key] + prod(others, start=ring.rational(coefficient))
    return parts["cos"], parts["sin"], parts[""]


def _write(value: Scalar) -> str:
    return write_scalar(value, compact_notation())


def _solved(form: _Linear) -> str:
    """Write θ = atan2(−A, B) + kπ, or θ = atan2(B, A) ± arccos(−C/√(A² + B²))."""
    symbol = symbol_as_latex(form.joint.symbol)
    if form.c.is_zero():
        return f"{symbol} = \\operatorname{{atan2}}({_write(-form.a)}, {_write(form.b)}) + k\\pi"
    size = f"\\sqrt{{{_write(form.a * form.a + form.b * form.b)}}}"
    return (
        f"{symbol} = \\operatorname{{atan2}}({_write(form.b)}, {_write(form.a)}) "
        f"\\pm \\arccos\\frac{{{_write(-form.c)}}}{{{size}}}"
    )


def _solvable(form: _Linear) -> str | None:
    """Write the lengths for which C² ≤ max (A² + B²) over the other joints; None where that is not plain."""
    if form.c.is_zero():
        return ""
    if angles_in(form.c):
        return None
    greatest = _greatest(form.a * form.a + form.b * form.b)
    if greatest is None:
        return None
    squared = form.c * form.c
    if (squared - greatest[0]).is_zero():
        return ""
    if greatest[1] is not None:
        return f"{_magnitude(form.c)} \\le {_write(greatest[1])}"
    return f"{_write(squared)} \\le {_write(greatest[0])}"


def _magnitude(value: Scalar) -> str:
    """Write |value|; a single length is positive."""
    if len(value.numerator) == 1:
        return _write(value if value.numerator.leading_coefficient() > 0 else -value)
    return f"\\left|{_write(value)}\\right|"


def _greatest(value: Scalar) -> tuple[Scalar, Scalar | None] | None:
    """Return the greatest value of P + Q cos φ + S sin φ, P + √(Q² + S²), and its root where that is u + v; None if no such form."""
    angles = angles_in(value)
    if not angles:
        return value, sqrt(value) if len(value.numerator) == 1 else None
    if len(angles) > 1:
        return None
    parts = _linear_parts(value, angles.pop())
    if parts is None:
        return None
    cosine, sine, constant = parts
    squared = cosine * cosine + sine * sine
    return constant + sqrt(squared), _sum_of_two(constant, squared)


def _sum_of_two(constant: Scalar, squared: Scalar) -> Scalar | None:
    """Return u + v with u² + v² = constant and 4u²v² = squared, u a product of lengths; None if there are none."""
    ring = constant.ring
    _, factors = squared.numerator.factor()
    u = ring.one
    for factor, power in factors:
        if power % 2 == 0 and len(factor) == 1:
            u = u * ring.scalar(factor) ** (power // 2)
    v_squared = squared / (u * u) * ring.rational(1) / ring.rational(4)
    return u + sqrt(v_squared) if (u * u + v_squared - constant).is_zero() else None
