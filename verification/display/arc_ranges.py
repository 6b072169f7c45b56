"""θ = arctan(…), θ ∈ (−π/2, π/2): an interval behind an arc function that holds all of its values says nothing besides."""

from __future__ import annotations

from fractions import Fraction

from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_HALF = Fraction(1, 2)
_RANGES = {  # in half turns, and whether they hold their ends
    "acos": (Fraction(0), Fraction(1), True),
    "asin": (-_HALF, _HALF, True),
    "atan": (-_HALF, _HALF, False),
    "atan2": (Fraction(-1), Fraction(1), True),
}


def is_range_of_arc(statement: n.Statement, before: n.Statement | None) -> bool:
    """Whether a statement gives the interval in which the angle is that the statement before equates to an arc function."""
    if not (isinstance(statement, n.Chain) and isinstance(before, n.Chain) and set(before.relations) == {"="}):
        return False
    if statement.relations != ("∈",) or bare(statement.members[0]) != bare(before.members[0]):
        return False
    interval = n.interval_of("∈", statement.members[1])
    ends = [_half_turns(bare(each)) for each in interval.items] if interval is not None else []
    arcs = [_range_of(bare(each)) for each in before.members[1:]]
    if interval is None or None in ends or len(arcs) != 1 or arcs[0] is None:
        return False
    low, high, holds_ends = arcs[0]
    is_wide = ends[0] < low and high < ends[1]  # type: ignore[operator]
    return is_wide or (ends[0] <= low and high <= ends[1] and (interval.brackets == "[]" or not holds_ends))  # type: ignore[operator]


def _range_of(node: n.Node) -> tuple[Fraction, Fraction, bool] | None:
    """Return the range of an arc function, or of one with a minus before it; None of anything else."""
    if isinstance(node, n.Sum) and len(node.terms) == 1 and node.terms[0][0] == "-":
        found = _range_of(bare(node.terms[0][1]))
        return None if found is None else (-found[1], -found[0], found[2])
    return _RANGES.get(node.function) if isinstance(node, n.Call) else None


def _half_turns(node: n.Node) -> Fraction | None:
    """Return an angle in half turns: 0, π, −π/2, 90°."""
    if isinstance(node, n.Number):
        return Fraction(0) if node.value == 0 else None
    if isinstance(node, n.Name):
        return Fraction(1) if node.key == "pi" else None
    if isinstance(node, n.Postfix):
        is_degrees = node.operator == "deg" and isinstance(bare(node.base), n.Number)
        return bare(node.base).value / 180 if is_degrees else None  # type: ignore[attr-defined]
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        size = _half_turns(bare(node.terms[0][1]))
        return size if size is None or node.terms[0][0] == "+" else -size
    if isinstance(node, n.Quotient) and isinstance(bare(node.denominator), n.Number):
        size = _half_turns(bare(node.numerator))
        return None if size is None else size / bare(node.denominator).value  # type: ignore[attr-defined]
    return None
