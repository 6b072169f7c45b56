r"""Twists as matrices and their exponentials: e^{\hat\xi_1 θ_1} of ξ = (v, ω), e^{[S_1]θ_1} of S = (ω, v), and the Jacobians of their products."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Matrix, inverse_pose, is_zero, pose_of
from armproof.verification.algebra.protocol import Algebra, identity
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

HAT = "hat "
_JACOBIANS = {
    ("s", ""): True,
    ("", "s"): True,
    ("st", "s"): True,
    ("b", ""): False,
    ("", "b"): False,
    ("st", "b"): False,
}


@dataclass(frozen=True)
class Twist:
    """An axis to move along: its direction ω, 0 of a slide, and its velocity v; of a rotation alone v is empty."""

    omega: tuple[Any, ...]
    v: tuple[Any, ...] = ()

    def matrix(self, algebra: Algebra) -> Matrix:
        """Return the skew matrix of ω, beside v and above zeros where there is a v."""
        x, y, z = self.omega
        zero = algebra.rational(Fraction(0))
        rows = ((zero, -z, y), (z, zero, -x), (-y, x, zero))
        if not self.v:
            return Matrix(rows)
        return Matrix((*((*row, each) for row, each in zip(rows, self.v, strict=True)), (zero,) * 4))

    def motion(self, algebra: Algebra, amount: Any) -> Matrix | None:
        """Return the exponential, amount times this twist; None where ω is neither a unit vector nor 0.

        e^{ωθ} = I + sin θ [ω] + (1 − cos θ) [ω]², and p = (I − e^{ωθ})(ω × v) + ω (ω·v) θ; v θ of a slide.
        """
        zero, one = algebra.rational(Fraction(0)), algebra.rational(Fraction(1))
        square = sum((each * each for each in self.omega), zero)
        turns = is_zero(square - one)
        if not (turns or is_zero(square)):
            return None
        unit = identity(algebra, 3)
        cosine, sine = algebra.cos_sin(amount) if turns else (one, zero)
        skew = Twist(self.omega).matrix(algebra)
        turn = unit + skew.map(lambda cell: cell * sine) + (skew @ skew).map(lambda cell: cell * (one - cosine))
        if not self.v:
            return turn
        omega, v = (Matrix(tuple((each,) for each in part)) for part in (self.omega, self.v))
        along = (omega @ (omega.transpose @ v)) if turns else v
        place = (unit + -turn) @ (skew @ v) + along.map(lambda cell: cell * amount)
        return pose_of(turn, place, zero, one)

    def column(self, direction_first: bool) -> tuple[Any, ...]:
        """Return the six components, ω above v or below."""
        return (*self.omega, *self.v) if direction_first else (*self.v, *self.omega)


def twist_in(matrix: Matrix) -> Twist:
    """Return the twist that a 4×4 matrix is of, or the axis of a 3×3 one."""
    rows = matrix.rows
    omega = (rows[2][1], rows[0][2], rows[1][0])
    return Twist(omega, tuple(row[3] for row in rows[:3]) if len(rows) == 4 else ())


def twist_value(evaluator: Evaluating, node: n.Node) -> Twist | None:
    r"""Return the twist that \hat\xi_1 or [S_1] writes as a matrix; None of anything else. Raises UnboundName."""
    node = in_brackets(node) or node
    name = node.inner if isinstance(node, n.Group) else node
    if not isinstance(name, n.Name):
        return None
    is_hat = name.base.startswith(HAT)
    if is_hat and name.key not in evaluator.names.state.definitions:
        name = replace(name, base=name.base.removeprefix(HAT))
    value = evaluator.evaluate(name)
    if isinstance(value, Matrix) and value.shape in ((3, 3), (4, 4)):
        return twist_in(value)
    cells = tuple(value) if isinstance(value, list) else value.cells if isinstance(value, Matrix) else ()
    if len(cells) not in (3, 6) or any(isinstance(cell, Matrix | list) for cell in cells):
        return None
    if len(cells) == 3:
        return Twist(cells)
    return Twist(cells[:3], cells[3:]) if isinstance(node, n.Group) else Twist(cells[3:], cells[:3])


def exponential(evaluator: Evaluating, exponent: n.Node) -> Matrix | None:
    """Return the motion that e to a twist times an amount is, None of another exponent."""
    written, amount = split(exponent)
    twist = twist_value(evaluator, written) if _is_written(written) else None
    return twist.motion(evaluator.algebra, evaluator.scalar(amount)) if twist is not None else None


def is_exponential(node: n.Node) -> n.Node | None:
    """Return the exponent of e^{…} or exp(…), None of another node."""
    if isinstance(node, n.Power) and isinstance(node.base, n.Name) and node.base.key == "e":
        return node.exponent
    is_call = n.is_call(node, "exp") and len(node.arguments) == 1
    return node.arguments[0] if is_call else None  # type: ignore[attr-defined]


def split(exponent: n.Node) -> tuple[n.Node, n.Node]:
    """Return the first factor of an exponent, and what it is multiplied by."""
    node = exponent.inner if isinstance(exponent, n.Group) and exponent.brackets != "[]" else exponent
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        sign, term = node.terms[0]
        written, amount = split(term)
        return written, n.Sum(((sign, amount),), span=node.span)
    if isinstance(node, n.Quotient):
        written, amount = split(node.numerator)
        return written, replace(node, numerator=amount)
    if isinstance(node, n.Product) and not any(node.operators):
        first, *others = node.factors
        rest = others[0] if len(others) == 1 else replace(node, factors=tuple(others), operators=node.operators[1:])
        return first, rest
    return node, n.Number(Fraction(1), "1", span=node.span)


def screw_matrix(evaluator: Evaluating, node: n.Group) -> Matrix | None:
    """Return the matrix that [S_1] is in a document whose exponents write it so."""
    name = node.inner
    letters = evaluator.names.reader.spelling.screws
    if node.brackets != "[]" or not isinstance(name, n.Name) or not letters:
        return None
    twist = twist_value(evaluator, node)
    return twist.matrix(evaluator.algebra) if twist is not None else None


def jacobian_of_screws(evaluator: Evaluating, name: n.Name) -> Matrix | None:
    """Return J_s, J_b, or a column ξ_2' of the first, of the product of exponentials that was defined last; else None."""
    factors = _last_product(evaluator)
    if factors is None or name.pre_sup or name.pre_sub:
        return None
    pose, exponents = factors
    parts = [split(exponent) for exponent in exponents]
    direction_first = any(in_brackets(written) for written, _ in parts)
    if name.primes == 1 and not name.sup:
        keys = [key_of(written) for written, _ in parts]
        place = keys.index(replace(name, primes=0).key) if replace(name, primes=0).key in keys else None
        columns = _columns(evaluator, pose, [parts[place][1]], True, direction_first) if place is not None else []
        return Matrix(tuple((each,) for each in columns[0])) if columns else None
    in_space = _JACOBIANS.get((name.sub, name.sup)) if name.base == "J" and not name.primes else None
    if in_space is None:
        return None
    columns = _columns(evaluator, pose, [amount for _, amount in parts], in_space, direction_first)
    return Matrix(tuple(zip(*columns, strict=True)))


def key_of(written: n.Node) -> str:
    r"""Return the name of the twist that \hat\xi_1 or [S_1] is of."""
    name = bare(written)
    return name.key.removeprefix(HAT) if isinstance(name, n.Name) else ""


def _columns(
    evaluator: Evaluating, pose: n.Node, amounts: Sequence[n.Node], in_space: bool, direction_first: bool
) -> list[tuple[Any, ...]]:
    """Return the twist of each joint, (∂T/∂θ) T^{-1} in space and T^{-1} ∂T/∂θ in the body."""
    value = evaluator.evaluate(pose)
    rates = [evaluator.evaluate(n.Derivative(pose, amount)) for amount in amounts]
    back = inverse_pose(value)
    found = [rate @ back if in_space else back @ rate for rate in rates]
    return [twist_in(each).column(direction_first) for each in found]


def written_out(node: n.Product) -> n.Product:
    """Return a product of exponentials with those that an ellipsis leaves out between two of them: e^{[S_1]θ_1} … e^{[S_6]θ_6}."""
    at = next((k for k, factor in enumerate(node.factors) if isinstance(factor, n.Dots)), 0)
    around = node.factors[at - 1 : at] + node.factors[at + 1 : at + 2]
    indices = [_index(factor) for factor in around] if at else []
    if len(indices) != 2 or not 0 < indices[0] < indices[1]:
        return node
    first, last = indices
    between = tuple(_with_index(around[1], last, k) for k in range(first + 1, last))
    operators = node.operators[: at - 1] + ("",) * (len(between) + 1) + node.operators[at + 1 :]
    return replace(node, factors=(*node.factors[:at], *between, *node.factors[at + 1 :]), operators=operators)


def _index(factor: n.Node) -> int:
    """Return the one index of the names in an exponential, 0 without."""
    exponent = is_exponential(factor)
    found = {below.sub for below in n.names(exponent)} if exponent is not None else set()
    return int(index) if len(found) == 1 and (index := found.pop()).isdigit() else 0


def _with_index(factor: n.Node, old: int, new: int) -> n.Node:
    names = [below for below in n.names(factor) if below.sub == str(old)]
    return n.substitute_each(factor, {id(name): replace(name, sub=str(new)) for name in names})


def _last_product(evaluator: Evaluating) -> tuple[n.Node, tuple[n.Node, ...]] | None:
    """Return the product of two exponentials or more that a name was defined as last, with their exponents; None where one is unread."""
    for definition in reversed(evaluator.names.state.definitions.values()):
        pose = written_out(definition.node) if isinstance(definition.node, n.Product) else definition.node
        exponents = tuple(exponents_in(pose)) if pose is not None else ()
        amounts = {each.key for each in (split(each)[1] for each in exponents) if isinstance(each, n.Name)}
        if pose is not None and len(amounts) == len(exponents) > 1:
            return pose, exponents
    return None


def exponents_in(node: n.Node) -> Iterator[n.Node]:
    """Yield the exponents of the exponentials of twists in a tree, from left to right."""
    found = (exponent for below in n.walk(node) if (exponent := is_exponential(below)) is not None)
    return (each for each in found if _is_written(split(each)[0]))


def in_brackets(node: n.Node) -> n.Group | None:
    """Return the [S_1] that a node is, or None."""
    return node if isinstance(node, n.Group) and node.brackets == "[]" and isinstance(node.inner, n.Name) else None


def _is_written(node: n.Node) -> bool:
    """Whether a factor is a name, perhaps with a hat or in brackets."""
    return in_brackets(node) is not None or isinstance(node, n.Name)
