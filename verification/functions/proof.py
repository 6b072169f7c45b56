"""The exact comparison of a function's formulas with an arm's quantities."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from armproof.models.arm import Arm
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.errors import EvaluationError
from armproof.verification.functions.bench import Bench, bench_of
from armproof.verification.functions.formulas import Formulas
from armproof.verification.functions.part import Part
from armproof.verification.functions.returned import fit

SECONDS_TO_DECIDE = 1.0


@dataclass(frozen=True)
class Proof:
    """The formulas of a traced function, one array a quantity, and which of them are proved equal to the arm's.

    Attributes:
        nodes: the traced numbers of each quantity, in its shape.
        proved: for which quantities, in their order.
        for_all_lengths: whether the lengths stayed symbols in each.
    """

    bench: Bench
    formulas: Formulas
    nodes: tuple[np.ndarray, ...]
    proved: tuple[bool, ...]
    for_all_lengths: tuple[bool, ...]

    def entry(self, number: int, row: int, column: int) -> Scalar:
        """Return the exact value of an entry (from 0) of a quantity (from 1); raises EvaluationError where it has none."""
        return self.formulas.scalar(self.nodes[number - 1][row, column])


def prove(arm: Arm, parts: list[Part], traced: list[np.ndarray], symbolic: bool) -> Proof | str:
    """Compare traced formulas with the quantities of an arm; return why it cannot be done where it cannot.

    Args:
        symbolic: whether the function takes its lengths as symbols; then no number in it is taken for a length.
    """
    try:
        return _prove(bench_of(arm), parts, traced, symbolic)
    except (EvaluationError, RecursionError) as problem:
        return str(problem)


def _prove(bench: Bench, parts: list[Part], traced: list[np.ndarray], symbolic: bool) -> Proof | str:
    formulas = Formulas(bench.exact, {} if symbolic else bench.lifted)
    fitted = [fit(nodes, part.shape) for part, nodes in zip(parts, traced, strict=True)]
    nodes = tuple(one.values for one in fitted if one is not None)
    if len(nodes) < len(parts):
        return "the traced function returns another shape"
    for part in parts:
        bench.true(part.asked.quantity)
    with bench.ring.budget.of(SECONDS_TO_DECIDE):
        found = [_compare(bench, part, formulas.matrix(values)) if not part.wrong else (False, False)
                 for part, values in zip(parts, nodes, strict=True)]  # fmt: skip
    return Proof(bench, formulas, nodes, tuple(equal for equal, _ in found), tuple(symbols for _, symbols in found))


def _compare(bench: Bench, part: Part, value: Matrix) -> tuple[bool, bool]:
    """Return whether all entries are equal, at the arm's lengths at least, and whether for all lengths."""
    true, everywhere = bench.true(part.asked.quantity), True
    for true_row, row in zip(true.rows, value.rows, strict=True):
        for a, b in zip(true_row, row, strict=True):
            if exactly_equal(a, b):
                continue
            everywhere = False
            if not _equal_at_the_lengths(bench, a, b):
                return False, False
    return True, everywhere


def _equal_at_the_lengths(bench: Bench, a: Scalar, b: Scalar) -> bool:
    return bool(bench.numbers) and exactly_equal(bench.at_the_lengths(a), bench.at_the_lengths(b))
