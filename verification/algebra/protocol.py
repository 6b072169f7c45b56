"""What an algebra is: the operations on scalars in which an expression is evaluated, and the matrices made of them.

The exact algebra and the samples on the double plant offer the same operations, so that one evaluator serves the
proof and its numerical second route.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, Protocol

from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind

Value = Any  # a scalar of the algebra, or a Matrix of them


class OutsideAlgebra(EvaluationError):
    """The exact algebra has no such function; the equation can only be confirmed."""

    kind = Kind.OUTSIDE_THE_ALGEBRA


class Algebra(Protocol):
    """What the evaluator needs of scalars; an algebra that computes its own values need not say so."""

    @property
    def budget(self) -> Budget:
        """The time that the display at hand has."""
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

    def symbols(self, value: Any) -> set[str]:
        """Return the symbols that a scalar holds, wherever they stand in it."""
        ...

    def rank(self, matrix: Matrix) -> Any:
        """Return the rank of a matrix, as a scalar."""
        ...

    def quantity(self, quantity: Quantity) -> Value:
        """Return a quantity of the arm: a Matrix, or a scalar where one component is meant."""
        ...

    @property
    def exact(self) -> Algebra | None:
        """The algebra whose values this one samples; None for one that computes its own."""
        return None

    def from_exact(self, value: Value) -> Value:
        """Return a value of that algebra in this one."""
        return value

    def at(self, values: Mapping[str, Any]) -> Algebra | None:
        """Return the algebra where variables have other values; None for one in which they are substituted."""
        return None

    def divide_by(self, denominator: Any) -> None:
        """Take note that something is divided by a denominator, which is not zero."""
        return

    def substitute(self, value: Value, values: Mapping[str, Any]) -> Value:
        """Return a value with joint variables or lengths replaced."""
        ...


def identity(algebra: Algebra, size: int, scale: Any = None) -> Matrix:
    """Return the identity matrix of a size, times a scalar if one is given."""
    one, zero = algebra.rational(Fraction(1)) if scale is None else scale, algebra.rational(Fraction(0))
    return Matrix(tuple(tuple(one if r == c else zero for c in range(size)) for r in range(size)))


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
