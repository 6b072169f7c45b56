"""Where a solution branches, ends and degenerates, in the document's own words: its roots, arc functions and denominators."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.formulas import Formula
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names


@dataclass(frozen=True)
class Conditions:
    """What the formulas of a solution say of the number of solutions, as LaTeX.

    Attributes:
        edges: what is not negative at a reachable target, and where it vanishes the two signs coincide: "1 - D^2".
        degenerate: what leaves a joint free: "Y = X = 0".
    """

    edges: tuple[str, ...]
    degenerate: tuple[str, ...]


def read_conditions(compiled: Compiled) -> Conditions:
    """Return the conditions of the formulas that a derivation uses, in its order."""
    derivation = compiled.derivation
    used = [meaning for meaning in derivation.choice.values() if not isinstance(meaning, Quantity)]
    formulas = sorted([*used, *(step.formula for step in derivation.steps)], key=lambda formula: formula.line)
    signs = {formula.key for formula in formulas if formula.branching}
    edges = [edge for formula in formulas if formula.branching or _names(formula) & signs for edge in _edges(formula)]
    degenerate = [place for formula in formulas for place in _degenerate(formula, compiled)]
    return Conditions(tuple(dict.fromkeys(edges)), tuple(dict.fromkeys(degenerate)))


def _edges(formula: Formula) -> Iterator[str]:
    for call in _calls(formula, "sqrt", "acos", "asin"):
        argument = n.ungrouped(call.arguments[0])
        text = formula.text(argument)
        if not text:
            continue
        if call.function == "sqrt":
            yield text
        else:
            long = isinstance(argument, n.Sum) or "\\frac" in text
            yield rf"1 - \left( {text} \right)^2" if long else f"1 - {text}^2"


def _degenerate(formula: Formula, compiled: Compiled) -> Iterator[str]:
    names = compiled.derivation.names
    for call in _calls(formula, "atan2"):
        first, second = (formula.text(n.ungrouped(argument)) for argument in call.arguments)
        if compiled.varies(formula, call.arguments):  # those of a point of the unit circle never vanish together
            yield f"{first} = {second} = 0"
    for below in n.walk(formula.node):
        if isinstance(below, n.Quotient) and not _is_constant(below.denominator, names):
            yield f"{formula.text(n.ungrouped(below.denominator))} = 0"


def _names(formula: Formula) -> set[str]:
    return {below.key for below in n.names(formula.node)}


def _calls(formula: Formula, *functions: str) -> Iterator[n.Call]:
    for below in n.walk(formula.node):
        if isinstance(below, n.Call) and below.function in functions:
            yield below


def _is_constant(node: n.Node, names: Names) -> bool:
    """Whether a tree is made of numbers and lengths."""
    return not any(
        isinstance(below, n.JointAngles)
        or (isinstance(below, n.Name) and below.key != "pi" and names.known_symbol(below.key) not in names.lengths)
        for below in n.walk(node)
    )
