"""The entries of a mass matrix that a document gives: m_{12} or M_{12} of M."""

from __future__ import annotations

from typing import Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex

_ENTRY = regex(r"([1-6]),?([1-6])")


def entry_of_masses(evaluator: Evaluating, node: n.Name) -> Any:
    """Return the M_{12} or m_{12} of a square M that the document gives, or None."""
    names, found = evaluator.names, _ENTRY.fullmatch(node.sub)
    plain = not (node.sup or node.pre_sub or node.pre_sup or node.primes or node.dots)
    if found is None or node.base not in ("M", "m") or not plain or "M" not in names.state.definitions:
        return None
    if node.key in names.state.definitions:
        return None
    matrix = names.defined_value("M", evaluator.algebra)
    row, column = (int(index) - 1 for index in found.groups())
    is_there = isinstance(matrix, Matrix) and max(row, column) < matrix.shape[0] == matrix.shape[1]
    return matrix.rows[row][column] if is_there and isinstance(matrix, Matrix) else None
