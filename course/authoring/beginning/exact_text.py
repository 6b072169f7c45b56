"""The exact value of a quantity of an arm, written: as LaTeX in two forms, and as the entries of a Python function."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from armproof.course.authoring.beginning.python_text import NotPython, names_in, write_python
from armproof.models.arm import Arm
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring
from armproof.verification.algebra.written import write_bounded, write_scalar
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.writer import Notation
from armproof.verification.naming.quantities import read_quantity

SECONDS = 5.0
LONGEST = 4000  # characters of a matrix that anybody would type


@dataclass(frozen=True)
class ExactText:
    """A quantity written out: cells of LaTeX with sums of angles folded, and expanded; cells of Python, if it can be."""

    cells: tuple[tuple[str, ...], ...]
    expanded: tuple[tuple[str, ...], ...]
    python: tuple[tuple[str, ...], ...] | None
    names: tuple[str, ...]

    @property
    def latex(self) -> str:
        """The matrix, or the scalar."""
        return as_matrix(self.cells)

    @property
    def expanded_latex(self) -> str:
        """The same with every sine and cosine of one angle."""
        return as_matrix(self.expanded)


def as_matrix(cells: tuple[tuple[str, ...], ...]) -> str:
    """Return cells as a bmatrix; a single one as it is."""
    if len(cells) == len(cells[0]) == 1:
        return cells[0][0]
    return r"\begin{bmatrix} " + r" \\ ".join(" & ".join(row) for row in cells) + r" \end{bmatrix}"


def write_quantity(arm: Arm, spec: Mapping[str, Any]) -> ExactText | None:
    """Return a quantity of an arm written out; None where it is too long for anybody to type."""
    try:
        return _write(arm, spec)
    except EvaluationError:
        return None


def _write(arm: Arm, spec: Mapping[str, Any]) -> ExactText | None:
    value = ExactAlgebra(Ring(Budget(SECONDS)), arm).quantity(read_quantity("asked", spec, arm))
    rows = value.rows if isinstance(value, Matrix) else ((value,),)
    short = Notation(style="index", cosine="C")
    cells = tuple(tuple(write_bounded(cell, short) for cell in row) for row in rows)
    if any(r"\ldots" in cell for row in cells for cell in row) or len(as_matrix(cells)) > LONGEST:
        return None
    plain = tuple(tuple(write_scalar(cell, Notation()) for cell in row) for row in rows)
    expanded = tuple(tuple(write_scalar(cell, Notation(), folded=False) for cell in row) for row in rows)
    nodes = [[Reader().read_expression(cell) for cell in row] for row in plain]
    try:
        python = tuple(tuple(write_python(node) for node in row) for row in nodes)
    except NotPython:
        return ExactText(cells, expanded, None, ())
    return ExactText(
        cells, expanded, python, tuple(sorted({name for row in nodes for node in row for name in names_in(node)}))
    )
