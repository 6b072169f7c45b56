"""Skew matrices: what nine entries made of the components of a vector are, but for a slip."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.algebra.calculus import symbol_of, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Role, Verdict

SETS = (("x", "y", "z"), ("1", "2", "3"))
PLACES = (((2, 1), (1, 2)), ((0, 2), (2, 0)), ((1, 0), (0, 1)))  # of each component, and of its opposite


def unless_skewed(outcome: Outcome, names: Names) -> Outcome:
    """Leave open a name for a matrix of the components of one vector that is nearly its skew matrix, and not quite."""
    value = outcome.true.value if outcome.true is not None else None
    if not isinstance(value, Matrix) or value.shape != (3, 3):
        return outcome
    letters = _components(value)
    if not letters or all(_stands_there(value, *each) for each in zip(letters, PLACES, strict=True)):
        return outcome
    finding = say(Kind.NEAR_SKEW, letters=letters)
    for name in outcome.defines:
        names.leave_open(name, finding)
    return replace(outcome, findings=(finding,), verdict=Verdict.UNCHECKED, role=Role.DEFINITION)


def _components(value: Matrix) -> list[str]:
    """Return the three components that a matrix with zeros on its diagonal holds, each with either sign; else nothing."""
    beside = [cell for (row, column), cell in zip(value.places, value.cells, strict=True) if row != column]
    if not all(isinstance(cell, Scalar) for cell in value.cells) or not all(
        value.rows[k][k].is_zero() for k in range(3)
    ):
        return []
    letters = sorted(symbols_in(beside))
    alone = all(symbol_of(cell) or symbol_of(-cell) for cell in beside)
    bases, indices = (
        zip(*((base, index) for base, _, index in (each.rpartition("_") for each in letters)), strict=True)
        if letters
        else ((), ())
    )
    return letters if alone and len(set(bases)) == 1 and tuple(indices) in SETS else []


def _stands_there(value: Matrix, letter: str, places: tuple[tuple[int, int], tuple[int, int]]) -> bool:
    (row, column), (opposite, other) = places
    return symbol_of(value.rows[row][column]) == letter and symbol_of(-value.rows[opposite][other]) == letter
