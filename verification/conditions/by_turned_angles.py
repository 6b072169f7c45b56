r"""J by the angles of the table, where the document's variables count them the other way: with $q_2 = -\theta_2$ the second column of $\partial p / \partial \theta$ has the other sign."""

from __future__ import annotations

from math import prod

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, equal_matrices
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict


def unless_by_angles(outcome: Outcome, checker: ChainChecker) -> Outcome:
    """Leave open what is refuted of J by the variables, and may be right of it by the angles of the table."""
    arm = checker.names.arm
    if outcome.verdict is not Verdict.REFUTED or arm is None:
        return outcome
    turned = checker.names.offset_joints
    signs = [turned[joint.symbol].sign if joint.symbol in turned else 1 for joint in arm.joints]
    below = [each for node in (*outcome.nodes, *outcome.conditions) for each in n.walk(node)]
    name = next((each for each in below if checker.members.jacobian_name(each, True) is not None), None)
    if min(signs, default=1) == 1 or not isinstance(name, n.Name) or not _may_be_turned(outcome.pair, signs):
        return outcome
    return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=name.key))


def _may_be_turned(pair: Pair | None, signs: list[int]) -> bool:
    """Whether what is printed is what is true with its columns, or the product of them, turned; unknown where it is neither a matrix of them nor a scalar."""
    if pair is None:
        return True
    if pair.is_scalar:
        true, printed = pair.true.cells[0], pair.printed.cells[0]
        is_opposite = isinstance(true, Scalar) and isinstance(printed, Scalar) and (true + printed).normal().is_zero()
        return is_opposite and prod(signs) == -1
    if pair.true.shape != pair.printed.shape or pair.true.shape[1] != len(signs):
        return True
    rows = tuple(tuple(cell * sign for cell, sign in zip(row, signs, strict=True)) for row in pair.true.rows)
    return equal_matrices(Matrix(rows), pair.printed)
