"""A document's equations before its arm is known: each letter in them stands for itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import takewhile

from armproof.verification.algebra.protocol import Value
from armproof.verification.document import Display
from armproof.verification.equations.series import written_out
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex

_JOINT = regex(r"(?:theta|Theta|q|[dr](?=_))(?:_\d+)?")  # what a pose or a position is a function of


def equations_of(display: Display, names: Names) -> Iterator[n.Chain]:
    """Yield the chains of = of a display, sums with known limits written out; none of an erratum, or of what cannot be read."""
    if display.erratum or display.denied or not display.closed:
        return
    latex = normalise_unicode(display.latex)
    try:
        statements = names.reader.read(latex)
    except (ReadError, RecursionError):
        return
    for statement in statements:
        each = written_out(statement, latex, names)
        if isinstance(each, n.Chain):
            equal = len(list(takewhile("=".__eq__, each.relations)))  # T = […] ∈ SE(3)
            if equal:
                yield replace(each, members=each.members[: equal + 1], relations=each.relations[:equal])


def unapplied(node: n.Node) -> n.Node:
    """Return a name without the joint variables that it is applied to: the T_{01} of T_{01}(q_1), the p of p(θ)."""
    node = bare(node)
    if not n.is_call(node, "name"):
        return node
    name, *arguments = node.arguments
    return name if all(isinstance(each, n.Name) and _JOINT.fullmatch(each.key) for each in arguments) else node


def value_in_letters(node: n.Node, names: Names, algebra: ExactAlgebra) -> tuple[Value, tuple[n.Name, ...]] | None:
    """Return the value of a formula in its own letters, with them; None where it has none.

    Nor where it is one of half an angle: tan(θ/2) would make functions of that of all cos θ and sin θ.
    """
    if any(_is_of_half_an_angle(below) for below in n.walk(node)):
        return None
    letters = tuple(below for below in n.names(node) if below.key not in ("pi", *_unit_blocks(node)))
    try:
        return Evaluator(replace(names, symbols={name.key: name.key for name in letters}), algebra).evaluate(
            node
        ), letters
    except (EvaluationError, RecursionError):
        return None


def _unit_blocks(node: n.Node) -> set[str]:
    """Return the I of [I, p; 0, 1], where a matrix stands beside it."""
    cells = [[n.bare(cell) for cell in each.cells] for each in n.walk(node) if isinstance(each, n.Matrix)]
    blocks = (row for row in cells if any(isinstance(cell, n.Matrix) for cell in row))
    return {cell.key for row in blocks for cell in row if isinstance(cell, n.Name) and cell.key == "I"}


def _is_of_half_an_angle(node: n.Node) -> bool:
    quotients = n.walk(node) if n.is_call(node, "cos", "sin", "tan") else ()
    return any(isinstance(each, n.Quotient) and _holds_a_letter(each.numerator) for each in quotients)


def _holds_a_letter(node: n.Node) -> bool:
    return any(isinstance(below, n.Name) and below.key != "pi" for below in n.walk(node))
