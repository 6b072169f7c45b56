"""Errors repeated and carried on: a refuted equation that repeats one printed before it, or follows from one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.alignment import equal_matrices
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.state import PrintedError


def consequence_of(checker: ChainChecker, outcome: Outcome, printed: PrintedError) -> Finding | None:
    """Return that an error repeats one printed before, or follows from it; None where it stands for itself."""
    errors = checker.names.state.errors
    for error in errors:
        if error.key == printed.key and printed.cells and printed.cells.items() <= error.cells.items():
            return say(Kind.SAME_ERROR, line=error.line)
    followed = _follows(checker, errors, outcome)
    return say(Kind.FOLLOWS, line=followed) if followed else None


def _follows(checker: ChainChecker, errors: Sequence[PrintedError], outcome: Outcome) -> int | None:
    """Return the line of an earlier error that, carried on, gives just what is printed here."""
    pair = outcome.pair
    assert pair is not None and outcome.true is not None
    printed: dict[str, PrintedError] = {}
    for error in errors:
        printed.setdefault(error.key, error)
    # the pose as a product of two, the printed value of one of them in the place of the true one
    for factors in _products(checker, outcome.true.node):
        wrong = [printed.get(repr(factor)) for factor in factors]
        if not any(wrong):
            continue
        values = [_carried_on(checker, *each) for each in zip(factors, wrong, strict=True)]
        if not all(isinstance(value, Matrix) and value.shape == (4, 4) for value in values):  # a row may be missing
            continue
        product = values[0] @ values[1]
        if equal_matrices(product, pair.printed):
            return min(error.line for error in wrong if error is not None)
    return None


def _products(checker: ChainChecker, node: n.Node) -> Iterator[tuple[Quantity, Quantity]]:
    """Yield the pairs of poses ^iT_k, ^kT_j of which the pose ^iT_j is the product, for the frames k between."""
    arm, quantity = checker.names.arm, checker.quantity_of(node)
    if arm is None or quantity is None or quantity.kind != "pose" or quantity.rows or quantity.columns:
        return
    frames = list(arm.frames)
    if not {quantity.reference, quantity.frame} <= set(frames):
        return
    first, last = frames.index(quantity.reference), frames.index(quantity.frame)
    for between in frames[first + 1 : last]:
        yield Quantity("pose", between, quantity.reference), Quantity("pose", quantity.frame, between)


def _carried_on(checker: ChainChecker, factor: Quantity, error: PrintedError | None) -> Value:
    if error is None:
        return checker.exact.quantity(factor)
    return checker.member(error.node).value  # a letter that had a meaning there may have none here
