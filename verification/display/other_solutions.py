r"""Another solution of the inverse problem, from one that is known: \theta_1' = \theta_1 + \pi, \theta_2' = \pi - \theta_2.

What a display says with it is that the tool is where it was: f(q') = f(q), an identity in q. It is decided where it holds; where it
does not, another point, or another task, may be meant.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError, WhereDefined
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex
from armproof.verification.verdict import Role, Verdict

_NUMBER = regex(r"\((?:2|3|4|ii|II|b)\)")  # \theta_1^{(2)}
_TASKS = (("pose", Kind.OTHER_SOLUTION_OF_POSE), ("origin", Kind.OTHER_SOLUTION_OF_POSITION))


def as_other_solution(
    statements: Sequence[n.Statement], outcomes: list[Outcome], checker: ChainChecker
) -> list[Outcome]:
    """Return the outcomes of a display, those of new names for joints proved where the tool is at their values where it was."""
    arm = checker.names.arm
    if arm is None or len(outcomes) != len(statements) or any(each.verdict is not Verdict.DEFINED for each in outcomes):
        return outcomes
    values: dict[str, Scalar] = {}
    for statement in statements:
        joint = _joint_of(statement, checker)
        if joint is None or joint in values or not isinstance(statement, n.Chain):
            return outcomes
        value = None
        with suppress(EvaluationError):
            value = Evaluator(checker.names, checker.exact).scalar(statement.members[1])
        if not isinstance(value, Scalar) or not symbols_in([value]) <= checker.names.joints.keys():
            return outcomes
        values[joint] = value
    for kind, finding in _TASKS:
        if values and _is_unmoved(Quantity(kind, arm.frames[-1], arm.frames[0]), values, checker):
            found = (say(finding),)
            return [replace(each, role=Role.CLAIM, verdict=Verdict.PROVED, findings=found) for each in outcomes]
    return outcomes


def _joint_of(statement: n.Statement, checker: ChainChecker) -> str | None:
    """Return the joint for which an equation gives another value, by its primes or its number: θ_1' = …, θ_1^{(2)} = …."""
    name = n.bare(statement.members[0]) if isinstance(statement, n.Chain) and statement.relations == ("=",) else None
    if not isinstance(name, n.Name) or name.dots or bool(name.primes) == bool(name.sup):
        return None
    if name.sup and not _NUMBER.fullmatch(name.sup):
        return None
    joint = checker.names.known_symbol(replace(name, primes=0, sup="").key)
    return joint if joint in checker.names.joints else None


def _is_unmoved(quantity: Quantity, values: dict[str, Scalar], checker: ChainChecker) -> bool:
    """Whether a quantity has the same value at other values of the joints, and is moved by one that they change."""
    cells = as_matrix(checker.exact.quantity(quantity)).cells
    ring = checker.exact.ring
    changed = {joint for joint, value in values.items() if not exactly_equal(value, ring.symbol(joint))}
    if not changed & symbols_in(cells):
        return False
    with WhereDefined():
        return all(exactly_equal(substitute(each, values), each) for each in cells)
    return False
