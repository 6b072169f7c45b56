"""Numbers that are worked out step by step: 40 · 0.866 + 30 · 0.2588 = 34.64 + 7.76 = 42.40 cm, each rounded on its way."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.decimals import fewest_decimals, roundings
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, is_number
from armproof.verification.latex.units import is_length, read_unit, size_of
from armproof.verification.naming.state import Stated
from armproof.verification.verdict import Verdict

FEWEST = 2  # decimals of a number that is rounded; 0.8 for 0.75 is another one
DEGREES = 10  # a whole number from here on is hardly an angle in radians
FEWEST_CELLS = 3  # such numbers in a matrix that is of values given under another heading


def holds_as_worked(members: Members, outcome: Outcome) -> bool:
    """Confirm an equation between numbers of which each term is that of the other side, rounded to its decimals; the last may have a unit."""
    sides = [*map(bare, outcome.nodes)]
    if outcome.pair is None or not outcome.pair.is_scalar or len(sides) != 2 or not all(map(is_number, sides)):
        return False
    sides = without_unit(sides)
    terms = [*map(_terms, sides)]
    steps = list(zip(*(terms if len(terms[0]) == len(terms[1]) else [[("+", side)] for side in sides]), strict=True))
    try:
        errors = [_error(members, *step) for step in steps]
    except EvaluationError:
        return False
    if None in errors:
        return False
    decimals = fewest_decimals(node for each in terms for _, node in each)
    outcome.verdict, outcome.wrong, outcome.findings = (
        Verdict.CONFIRMED,
        [],
        (say(Kind.TO_DECIMALS, decimals=decimals),),
    )
    outcome.samples, outcome.max_error = 1, max(filter(None, errors), default=0.0)
    return True


def as_added_up(compare: Callable[..., Outcome], before: Member, outcome: Outcome) -> Outcome:
    """Return what is refuted as right where it is the sum of rounded numbers that stands before it: 0.2294 + 0.2954 = 0.5248.

    That holds beside what is true, so that its numbers are rounded right, and the sum is off by no more than they.
    """
    printed = outcome.printed
    if (
        printed is None
        or not isinstance(bare(before.node), n.Sum)
        or not all(map(is_number, (before.node, printed.node)))
    ):
        return outcome
    if not all(
        isinstance(bare(node), n.Number) for node in (*(term for _, term in _terms(bare(before.node))), printed.node)
    ):
        return outcome
    again = compare(before, printed, outcome.equation, False)
    if again.verdict is not Verdict.PROVED:
        return outcome
    decimals = fewest_decimals((printed.node,))
    return replace(again, verdict=Verdict.CONFIRMED, findings=(say(Kind.TO_DECIMALS, decimals=decimals),), samples=1)


def without_unit(sides: Sequence[n.Node]) -> list[n.Node]:
    """Return the sides without the unit behind one of them, where none of the other's numbers has one."""
    marks = [any(isinstance(b, n.Postfix) and size_of(b.operator) for b in n.walk(side)) for side in sides]
    return [side if other else _plain(side) for side, other in zip(sides, reversed(marks), strict=True)]


def in_the_unit_behind(chain: n.Chain) -> tuple[n.Chain, str]:
    """Return 3 · 90 / 2 = 135° = 2.36 rad with the degrees of what comes out behind the numbers that it is worked out of.

    And the first that may be in radians as well, "" where all are made of whole numbers that nobody means so.
    """
    members, unsure = list(chain.members), ""
    for place, (one, other) in enumerate(pairwise(members)):
        if _is_in_degrees(other) and _is_worked_out(one):
            numbers = [b for b in n.walk(one) if isinstance(b, n.Number)]
            members[place] = n.Postfix(n.Group(one, span=one.span), "deg", span=one.span)
            if not any(not each.decimals and each.value >= DEGREES for each in numbers):
                unsure = unsure or str(float(numbers[0].value))
    return (replace(chain, members=tuple(members)) if members != [*chain.members] else chain), unsure


def _is_in_degrees(node: n.Node) -> bool:
    """Whether a side is one number of degrees, or of degrees in a time: 90°, 90°/s."""
    node = bare(node)
    marked = bare(node.numerator) if isinstance(node, n.Quotient) else node
    if not isinstance(marked, n.Postfix) or not isinstance(bare(marked.base), n.Number):
        return False
    unit = read_unit(marked.operator)
    return unit is not None and unit.of_pi == 1 and unit.length == 0


def _is_worked_out(node: n.Node) -> bool:
    """Whether a side is worked out of numbers without a unit, a function or π."""
    plain = all(isinstance(b, n.Number | n.Sum | n.Product | n.Quotient | n.Group) for b in n.walk(node))
    return plain and not isinstance(bare(node), n.Number)


def _plain(node: n.Node) -> n.Node:
    """Return a number without its unit of length."""
    return bare(node.base) if isinstance(node, n.Postfix) and is_length(node.operator) else node


def _terms(node: n.Node) -> list[tuple[str, n.Node]]:
    return list(node.terms) if isinstance(node, n.Sum) else [("+", node)]


def _error(members: Members, one: tuple[str, n.Node], other: tuple[str, n.Node]) -> float | None:
    """Return how far a term is from that of the other side, None where it is further than rounding takes it."""
    values = [members.evaluate(node).value for _, node in (one, other)]
    if one[0] != other[0] or not all(isinstance(value, Scalar) for value in values):
        return None
    error = abs(members.number(values[0] - values[1]))  # type: ignore[operator, arg-type]
    return error if error <= max(_near(node) for _, node in (one, other)) else None


def _near(node: n.Node) -> float:
    """Return how far a number alone is rounded; what is no number alone is exact."""
    alone = bare(node)
    rounds = isinstance(alone, n.Number) and alone.decimals >= FEWEST
    return roundings(alone, (1, 1))[0, 0].near if rounds else 1e-9


def unitless(given: Mapping[str, Stated]) -> Iterator[Mapping[str, Stated]]:
    """Yield given values as they stand, and without their units of length where they have such."""
    yield given
    plain = {key: replace(each, node=_plain(bare(each.node))) for key, each in given.items()}
    if any(plain[key].node != given[key].node for key in given):
        yield plain


def tells_values(node: n.Node) -> bool:
    """Whether numbers are those of some values, and hardly of others: 0.433, 2 cos 30°; 1 may be that of many. Of a matrix several are to tell."""
    cells = [cell for row in written_rows(bare(node)) for cell in row]
    return all(map(is_number, cells or [node])) and sum(map(_tells, cells or [node])) >= (FEWEST_CELLS if cells else 1)


def _tells(node: n.Node) -> bool:
    fine = any(isinstance(b, n.Number) and b.decimals >= FEWEST for b in n.walk(node))
    return fine or any(isinstance(b, n.Postfix) and b.operator == "deg" for b in n.walk(node))
