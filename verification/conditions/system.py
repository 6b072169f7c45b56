"""Conditions of a display as systems of equations: det J = 0, θ_2 = 0 or π, rank J < 2, S_2 = 0 and S_3 = 0."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from armproof.verification.algebra.angles import has_arcs
from armproof.verification.algebra.matrix import Matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.implication import WHOLE_NUMBERS, is_signed
from armproof.verification.equations.alignment import align
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES
from armproof.verification.latex.nodes import bare, has_branches
from armproof.verification.singularities.elimination import BeyondReach
from armproof.verification.singularities.linear import maximal_minors


class Undecided(EvaluationError):
    """Neither a proof nor a counterexample was found."""

    kind = Kind.UNDECIDED


@dataclass(frozen=True)
class System:
    """The configurations at which scalars are zero, and of each set of others not all are zero.

    `values` are joint angles that the equations fix, up to whole turns, in terms of other symbols.
    """

    zero: tuple[Scalar, ...]
    not_all_zero: tuple[tuple[Scalar, ...], ...] = ()
    values: tuple[tuple[str, Scalar], ...] = ()

    def and_(self, other: System) -> System:
        """Return the configurations of both."""
        return System(self.zero + other.zero, self.not_all_zero + other.not_all_zero, self.values + other.values)


Condition = tuple[System, ...]  # alternatives


def read_condition(
    checker: ChainChecker, alternatives: Sequence[Sequence[n.Chain]], branches: Sequence[int] = ()
) -> Condition:
    """Return where one of the alternatives holds, each of which is some chains that hold together.

    f = g gives f − g = 0; an angle θ = α gives 1 − cos(θ − α) = 0; θ ∈ {α, β} and ± are alternatives, those of a chain
    for itself, or where `branches` are given those that all chains have together; a matrix equation is one of each entry;
    det(A Aᵀ) = 0 says that all maximal minors of A vanish, rank A < k that all minors of size k do.

    Raises:
        Undecided: a chain is no such condition.
    """
    found: list[System] = []
    for chains, branch in itertools.product(alternatives, branches or (None,)):
        parts = [_of_chain(checker, chain, branch) for chain in chains]
        for choice in itertools.product(*parts):
            system = System(())
            for part in choice:
                system = system.and_(part)
            found.append(system)
    if not found:
        raise Undecided(say(Kind.NO_CONDITION))
    return tuple(found)


def _of_chain(checker: ChainChecker, chain: n.Chain, branch: int | None) -> list[System]:
    """The alternatives of one chain; one with ± holds on either branch or on the one that is chosen, θ ≠ ±α on both."""
    branches = (branch or 1,) if not has_branches(chain) or (branch and is_signed(chain)) else (1, -1)
    found = [
        system
        for branch in branches
        for system in _of_branch(checker, chain, Evaluator(checker.names, checker.exact, branch))
    ]
    return [reduce(System.and_, found)] if chain.relations == ("≠",) else found


def _of_branch(checker: ChainChecker, chain: n.Chain, evaluator: Evaluator) -> Iterator[System]:
    if len(chain.members) == 1:
        raise Undecided(say(Kind.CONDITION_IS_EQUATION))
    if chain.relations in (("∈",), ("∉",)):
        yield from _of_set(checker, chain, evaluator)
        return
    *first, last = chain.members
    if len(first) != 1:
        if (other := next((relation for relation in chain.relations if relation != "="), None)) is not None:
            raise Undecided(say(Kind.RELATION_IS_NONE, relation=other))
        if all(map(checker.members.is_symbol, first)):
            parts = [_fixed(checker, node, last, evaluator) for node in first]  # θ_1 = θ_2 = 0
        else:
            parts = [System(tuple(_equations(checker, node, last, evaluator))) for node in first]  # P_x = P_y = 0
        yield reduce(System.and_, parts)
        return
    (relation,) = chain.relations
    if (rank := _rank_condition(checker, first[0], relation, last, evaluator)) is not None:
        yield rank
    elif relation == "≠":
        yield System((), (tuple(_equations(checker, first[0], last, evaluator)),))
    elif relation == "=":
        yield System(
            tuple(_equations(checker, first[0], last, evaluator)), (), _value(checker, first[0], last, evaluator)
        )
    else:
        raise Undecided(say(Kind.RELATION_IS_NONE, relation=relation))


def _of_set(checker: ChainChecker, chain: n.Chain, evaluator: Evaluator) -> Iterator[System]:
    """θ ∈ {α, β} are alternatives, θ ∉ {α, β} is θ ≠ α and θ ≠ β; an interval (α, β) is no condition that is decided."""
    angle, values = chain.members
    if not isinstance(values, n.Sequence) or values.brackets != "{}":
        raise Undecided(say(Kind.RELATION_IS_NONE, relation=chain.relations[0]))
    systems = [_fixed(checker, angle, item, evaluator) for item in values.items]
    if chain.relations == ("∈",):
        yield from systems
    else:
        yield reduce(System.and_, [System((), (system.zero,)) for system in systems])


def _fixed(checker: ChainChecker, left: n.Node, right: n.Node, evaluator: Evaluator) -> System:
    """θ = α as a system, with the value of θ."""
    zero = _angle_or_difference(checker, left, right, evaluator)
    return System((zero,), (), _value(checker, left, right, evaluator))


def _value(checker: ChainChecker, left: n.Node, right: n.Node, evaluator: Evaluator) -> tuple[tuple[str, Scalar], ...]:
    """The joint angle that θ = α fixes; nothing where the left side is no joint angle, or the right side holds it."""
    symbol = checker.names.known_symbol(left.key) if isinstance(left, n.Name) else None
    if isinstance(left, n.Name) and checker.names.is_free(left):
        symbol = left.key
    if symbol is None or any(isinstance(b, n.Name) and b.key in WHOLE_NUMBERS for b in n.walk(right)):
        return ()
    value = as_scalar(evaluator.evaluate(right))
    if isinstance(value, Scalar) and isinstance(left, n.Name):
        value = checker.names.variable_at(symbol, value, checker.exact, left.key)
    if not isinstance(value, Scalar) or not is_angle(checker, checker.exact.symbol(symbol) - value):
        return ()
    return () if ("symbol", symbol) in value.generators else ((symbol, value),)


def _equations(checker: ChainChecker, left: n.Node, right: n.Node, evaluator: Evaluator) -> list[Scalar]:
    """The scalars that are all zero where an equation holds."""
    if isinstance(right, n.Number) and right.value == 0 and (factor := _gram_factor(left)) is not None:
        value = evaluator.evaluate(factor)
        if isinstance(value, Matrix) and value.shape[0] < value.shape[1]:
            return _minors(value, value.shape[0])
    a = as_scalar(evaluator.evaluate(left))
    if isinstance(a, Scalar) and (squares := _of_squares(checker, a, right, evaluator)) is not None:
        return [squares]
    if not isinstance(a, Matrix):
        return [_angle_or_difference(checker, left, right, evaluator)]
    b = as_scalar(evaluator.evaluate(right))
    if isinstance(b, Scalar) and b.is_zero():
        return [*a.cells]
    if not isinstance(b, Matrix):
        raise Undecided(say(Kind.MATRIX_FOR_CONDITION))
    return [x - y for _, x, y in next(align(a, b, checker.exact)).entries()]


def _of_squares(checker: ChainChecker, root: Scalar, right: n.Node, evaluator: Evaluator) -> Scalar | None:
    """√f = g as f = g², where g is a sum of positive lengths, or an absolute value: ‖p‖ = l_1 + l_2, ‖p‖ = |l_1 − l_2|."""
    (powers, factor), *more = [*checker.exact.ring.terms(root.numerator)] or [({}, Fraction(0))]
    if more or factor != 1 or not root.denominator.is_one() or [kind for kind, _ in powers] != ["radical"]:
        return None
    absolute = n.is_call(inner := bare(right), "abs")
    value = as_scalar(evaluator.evaluate(inner.arguments[0] if isinstance(inner, n.Call) and absolute else right))
    if absolute:
        return root * root - value * value if isinstance(value, Scalar) else None
    arm = checker.names.arm
    if not isinstance(value, Scalar) or not value.denominator.is_one() or arm is None:
        return None
    lengths = {("symbol", name) for name, length in arm.lengths.items() if length > 0}
    terms = [*checker.exact.ring.terms(value.numerator)]
    positive = terms and all(number > 0 and lengths.issuperset(generators) for generators, number in terms)
    return root * root - value * value if positive else None


def _gram_factor(node: n.Node) -> n.Node | None:
    """The A of det(A Aᵀ), or the Aᵀ of det(Aᵀ A)."""
    if not n.is_call(node, "det", "abs"):
        return None
    product = bare(node.arguments[0])
    if not isinstance(product, n.Product) or len(product.factors) != 2 or "×" in product.operators:
        return None
    a, b = product.factors
    if isinstance(b, n.Postfix) and b.operator == "T" and bare(b.base) == bare(a):
        return a
    return a if isinstance(a, n.Postfix) and a.operator == "T" and bare(a.base) == bare(b) else None


def _rank_condition(
    checker: ChainChecker, left: n.Node, relation: str, right: n.Node, evaluator: Evaluator
) -> System | None:
    """rank A < k, ≤ k or = k: minors of one size that all vanish, and for equality smaller ones that do not all."""
    if not (n.is_rank(left) and isinstance(right, n.Number)):
        return None
    value = evaluator.evaluate(left.arguments[0])
    if not isinstance(value, Matrix) or right.value.denominator != 1 or relation not in ("=", "<", "≤", "≠"):
        raise Undecided(say(Kind.RANK_OF_NO_MATRIX))
    size = int(right.value)
    if relation == "≠":  # a rank below the full one
        if size != min(value.shape):
            raise Undecided(say(Kind.RANK_IS_NO_NUMBER))
        relation = "<"
    above = _minors(value, size if relation == "<" else size + 1)
    return System(tuple(above), (tuple(_minors(value, size)),) if relation == "=" and size else ())


def _minors(matrix: Matrix, size: int) -> list[Scalar]:
    """All minors of a size; none is larger than the matrix."""
    if size > min(matrix.shape):
        return []
    if size < 1:
        return [matrix.rows[0][0].ring.one]
    try:
        found = maximal_minors(matrix, size)
    except BeyondReach as problem:
        raise Undecided(finding_of(problem)) from None
    return found or [matrix.rows[0][0].ring.zero]


def _angle_or_difference(checker: ChainChecker, left: n.Node, right: n.Node, evaluator: Evaluator) -> Scalar:
    """f − g, or 1 − cos(f − g) where both are angles; kπ with any integer k gives the sine."""
    periodic = _of_every_integer(checker, left, right, evaluator)
    if periodic is not None:
        return periodic
    a, b = (as_scalar(evaluator.evaluate(node)) for node in (left, right))
    if not (isinstance(a, Scalar) and isinstance(b, Scalar)):
        raise Undecided(say(Kind.MATRIX_FOR_CONDITION))
    if is_angle(checker, a - b) or has_arcs(a):
        return 1 - checker.exact.cos_sin(a - b)[0]
    return a - b


def is_angle(checker: ChainChecker, value: Scalar) -> bool:
    """Whether a scalar is a sum of joint angles and multiples of π; without an arm, of letters that mostly are angles."""
    arm = checker.names.arm
    revolute = {joint.symbol for joint in arm.joints if joint.kind == "revolute"} if arm is not None else set()
    if not value.denominator.is_one():
        return False
    terms = [powers for powers, _ in checker.exact.ring.terms(value.numerator)]
    symbols = [generator for powers in terms for generator in powers]
    linear = all(sum(powers.values()) == 1 for powers in terms)
    allowed = all(
        kind == "pi" or (kind == "symbol" and (name in revolute or (arm is None and name.partition("_")[0] in ANGLES)))
        for kind, name in symbols
    )
    return linear and allowed and any(kind == "symbol" for kind, _ in symbols)


def _of_every_integer(checker: ChainChecker, left: n.Node, right: n.Node, evaluator: Evaluator) -> Scalar | None:
    """θ = α + kβ for every integer k: sin(m(θ − α)) where β = π/m, 1 − cos(m(θ − α)) where β = 2π/m."""
    free = [
        below
        for below in n.names(right)
        if below.key in WHOLE_NUMBERS and checker.names.known_symbol(below.key) is None
    ]
    if not free:
        return None
    start, one, two = (evaluator.scalar(_with_number(right, free, k)) for k in (0, 1, 2))
    step = ((one - start) / checker.exact.pi()).as_fraction()
    if not step or not (two - one - one + start).is_zero():
        raise Undecided(say(Kind.MULTIPLE_OF_NO_FRACTION))
    turned = evaluator.scalar(left) - start
    if (1 / step).denominator == 1:
        return checker.exact.cos_sin(turned / checker.exact.rational(step))[1]
    if (2 / step).denominator == 1:
        return 1 - checker.exact.cos_sin(turned * checker.exact.rational(2 / step))[0]
    raise Undecided(say(Kind.MULTIPLE_OF_NO_PART))


def _with_number(node: n.Node, names: Sequence[n.Node], value: int) -> n.Node:
    for name in names:
        node = n.substitute(node, name, n.Number(Fraction(value), str(value), span=name.span))
    return node
