"""Relations other than equality: sizes, groups, inequalities and approximations; what is open is a condition."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby
from typing import Any

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, as_scalar, is_zero
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import finest_decimals
from armproof.verification.equations.order_of_factors import are_exchanged
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.rigid import is_pose, is_rotation
from armproof.verification.equations.worked_numbers import without_unit
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.verdict import Verdict, worst

GROUPS = ("SO", "SE")
ORDERS = frozenset("<>≤≥")


def parts_of(chain: n.Chain) -> Iterator[tuple[int, n.Chain]]:
    """Yield the equations of a chain and what stands between them, each with the number of its first relation."""
    numbered = enumerate(chain.relations)
    for _, run in groupby(numbered, key=lambda each: each[1] == "="):
        numbers = [number for number, _ in run]
        members = chain.members[numbers[0] : numbers[-1] + 2]
        span = (members[0].span[0], members[-1].span[1])
        relations = chain.relations[numbers[0] : numbers[-1] + 1]
        yield numbers[0], replace(chain, members=members, relations=relations, span=span)


def check_relation(checker: ChainChecker, chain: n.Chain, equation: int) -> Outcome:
    """Return the verdict of a chain with ≤, <, ≠, ≈, ∈ and no =: the worst of its relations."""
    pairs = zip(chain.members, chain.relations, chain.members[1:], strict=False)
    found = [_check(checker, left, relation, right, equation) for left, relation, right in pairs]
    verdicts = [outcome.verdict for outcome in found]
    if Verdict.REFUTED not in verdicts and Verdict.DEFINED in verdicts:  # one that is open leaves the chain open
        return found[verdicts.index(Verdict.DEFINED)]
    return found[verdicts.index(worst(verdicts))]


def _check(checker: ChainChecker, left: n.Node, relation: str, right: n.Node, equation: int) -> Outcome:
    outcome = Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)
    if relation == "∈":
        return _membership(checker, left, right, outcome)
    if relation == "≈" and (there := _at_configuration(checker, left, right, equation)) is not None:
        return there
    sides = checker.member(left), checker.member(right)
    known = all(side.known for side in sides)
    if relation == "≠":
        exchanged = checker.names.arm is None and are_exchanged(left, right, checker.names)
        if known and not exchanged and _identical(sides[0].value, sides[1].value):
            return replace(outcome, verdict=Verdict.REFUTED, findings=(say(Kind.ALWAYS_EQUAL),))
        return outcome
    if relation in ORDERS and (bound := _of_the_arm(checker, left, relation, right, outcome)) is not None:
        return bound
    constant = known and all(_is_constant(side.value) for side in sides)
    if (isinstance(left, n.Name) or isinstance(right, n.Name)) and not constant:
        of_arm = known and any(map(checker.members.is_symbol, (left, right)))
        checker.names.state.compares_lengths |= of_arm or checker.names.arm is None
        checker.names.state.compare(n.Chain((left, right), (relation,)), checker.names.lengths)
        return outcome  # a bound on a variable: a condition
    if relation not in ("≤", "<", "≥", ">", "≈"):
        return outcome
    sampled = checker.sampled()
    with checker.exact.budget.paused():
        from armproof.verification.equations.sampled_relations import check_approximation, check_inequality

    if relation == "≈":
        left, right = without_unit((left, right)) if constant else (left, right)
        return check_approximation(checker, sampled, (left, right), constant, outcome)
    return check_inequality(checker, sampled, (left, right), relation, outcome)


def _of_the_arm(checker: ChainChecker, left: n.Node, relation: str, right: n.Node, outcome: Outcome) -> Outcome | None:
    """Return what samples confirm of a coordinate, x ≤ l_1 + l_2; elsewhere it may be a condition, and None is returned."""
    arm, members, before = checker.names.arm, checker.members, checker.names.state.copy()
    alone = {members.names.known_symbol(each.key) for each in (left, right) if isinstance(each, n.Name)}
    if arm is None or checker.names.joints.keys() & alone:  # limits of a joint
        return None
    checker.conventions.infer_tool([left, right])
    names = [below for side in (left, right) for below in n.names(side)]
    values = [as_scalar(checker.member(each).value) for each in names]
    cells = [c for v in values for c in (v.cells if isinstance(v, Matrix) else (v,)) if isinstance(c, Scalar)]
    if not symbols_in(cells).isdisjoint(checker.names.joints):
        sampled = checker.sampled()
        with checker.exact.budget.paused():
            from armproof.verification.equations.sampled_relations import check_inequality
        found = check_inequality(checker, sampled, (left, right), relation, outcome)
        if found.verdict is Verdict.CONFIRMED:
            return found
    checker.names.state.become(before)
    return None


def _at_configuration(checker: ChainChecker, left: n.Node, right: n.Node, equation: int) -> Outcome | None:
    """P_x ≈ 0.346 behind a stated configuration is decided as P_x = 0.346, None elsewhere; P_x ≈ 1 is refuted by nothing."""
    if not checker.names.state.configuration or is_number(left) or not is_numbers(right):
        return None
    (found,) = checker.check(n.Chain((left, right), ("=",)), equation, 0, define=False)
    if found.verdict is Verdict.CONFIRMED or (found.verdict is Verdict.REFUTED and finest_decimals((right,))):
        return found
    return None


def is_numbers(node: n.Node) -> bool:
    """Whether a side is a number, or a matrix of numbers."""
    cells = [cell for row in written_rows(node) for cell in row] or [node]
    return all(map(is_number, cells))


def _identical(a: Any, b: Any) -> bool:
    a, b = as_scalar(a), as_scalar(b)
    if isinstance(a, Matrix) and isinstance(b, Matrix):
        return a.shape == b.shape and is_zero(a + -b)
    if isinstance(a, Scalar) and isinstance(b, Scalar):
        return (a - b).is_zero()
    if isinstance(a, Matrix) and isinstance(b, Scalar):
        return b.is_zero() and is_zero(a)
    return False


def _is_constant(value: Value) -> bool:
    """Whether a value holds no joint variable and no length: π and roots of numbers may stand in it."""
    return isinstance(value, Scalar) and all(kind in ("pi", "sqrt") for kind, _ in value.generators)


# -- sets ---------------------------------------------------------------------------------------------------------------


def _membership(checker: ChainChecker, left: n.Node, right: n.Node, outcome: Outcome) -> Outcome:
    """ℝ^n by size, a group of rotations or of poses by its law; other sets leave a condition."""
    member = checker.member(left)
    if not member.known:
        return outcome
    value = as_scalar(member.value)
    if isinstance(right, n.Name) and "mathbb" in right.text and right.key == "R" and isinstance(value, Scalar):
        return replace(outcome, verdict=Verdict.PROVED, findings=(say(Kind.IN_SPACE),))
    if not isinstance(value, Matrix):
        return outcome
    if (size := _size_of_space(right)) is not None:
        if value.shape == size:
            return replace(outcome, verdict=Verdict.PROVED, findings=(say(Kind.IN_SPACE),))
        smaller = all(one <= other for one, other in zip(value.shape, size, strict=True))
        if smaller and any(_may_be_block(cell, checker) for row in written_rows(left) for cell in row):
            return outcome
        other = say(Kind.NOT_IN_SPACE, size=value.size, space=f"{size[0]}×{size[1]}")
        return replace(outcome, verdict=Verdict.REFUTED, findings=(other,))
    group = _group(right)
    rows = group[1] + (group[0] == "SE") if group is not None else 0
    if group is None or value.shape != (rows, rows):
        return outcome
    inside = is_pose(value) if group[0] == "SE" else is_rotation(value)
    name = f"{group[0]}({group[1]})"
    if inside:
        return replace(outcome, verdict=Verdict.PROVED, findings=(say(Kind.IN_GROUP, group=name),))
    return replace(outcome, verdict=Verdict.REFUTED, findings=(say(Kind.NOT_IN_GROUP, group=name),))


def _may_be_block(cell: n.Node, checker: ChainChecker) -> bool:
    """Whether a cell holds a letter that may be a block of a larger matrix, [ω; v] ∈ ℝ^6: nothing binds it."""
    letters = [below for below in n.names(cell) if below.key != "pi"]
    return any(not checker.members.is_symbol(each) and checker.quantity_of(each) is None for each in letters)


def _group(node: n.Node) -> tuple[str, int] | None:
    """SO(3) → ("SO", 3), however it is set."""
    letters = "".join(below.base for below in n.names(node))
    sizes = [int(below.value) for below in n.walk(node) if isinstance(below, n.Number)]
    return (letters, sizes[0]) if letters in GROUPS and len(sizes) == 1 and sizes[0] in (2, 3) else None


def _size_of_space(node: n.Node) -> tuple[int, int] | None:
    """ℝ^{6×4} → (6, 4); ℝ^3 → (3, 1)."""
    if not (isinstance(node, n.Power) and isinstance(node.base, n.Name) and node.base.base == "R"):
        return None
    exponent = node.exponent
    if isinstance(exponent, n.Number):
        return int(exponent.value), 1
    if isinstance(exponent, n.Product) and exponent.operators == ("×",):
        sizes = [int(f.value) for f in exponent.factors if isinstance(f, n.Number)]
        return (sizes[0], sizes[1]) if len(sizes) == 2 else None
    return None
