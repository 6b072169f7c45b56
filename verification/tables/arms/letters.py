"""A document's equations before its arm is known: each letter in them stands for itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.algebra.protocol import Value
from armproof.verification.document import Display
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names


def equations_of(display: Display, names: Names) -> Iterator[n.Chain]:
    """Yield the chains of = of a display; none of an erratum, or of what cannot be read."""
    if display.erratum or not display.closed:
        return
    try:
        statements = names.reader.read(display.latex)
    except (ReadError, RecursionError):
        return
    yield from (each for each in statements if isinstance(each, n.Chain) and set(each.relations) == {"="})


def value_in_letters(node: n.Node, names: Names, algebra: ExactAlgebra) -> tuple[Value, tuple[n.Name, ...]] | None:
    """Return the value of a formula in its own letters, with them; None where it has none."""
    letters = tuple(below for below in n.walk(node) if isinstance(below, n.Name) and below.key != "pi")
    try:
        return Evaluator(replace(names, symbols={name.key: name.key for name in letters}), algebra).evaluate(
            node
        ), letters
    except (EvaluationError, RecursionError):
        return None
