"""Equations between printed decimals: true to the digits shown, or at the configuration that a display gave."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import remainder, tau
from typing import TYPE_CHECKING

from armproof.verification.algebra.calculus import leaves_open, symbols_in
from armproof.verification.algebra.matrix import as_matrix, stacked
from armproof.verification.equations.alignment import is_constant
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import FEWEST, SecondRoute
from armproof.verification.equations.sides import Members
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.latex.units import is_length, size_of
from armproof.verification.verdict import Verdict

if TYPE_CHECKING:
    from armproof.verification.equations.sampled_errors import SampledErrors

FINE = 3  # decimals: a number of so many may be rounded
LARGE = 1000  # a whole number from here on may be rounded where what it stands for is none
COARSE = 2  # decimals: what holds to these is neither confirmed nor refuted
TWO_DIGITS = 10
FEW = 3  # entries: more wrong ones than that, and another configuration is meant


def finest_decimals(nodes: Iterable[n.Node]) -> int:
    """Return the most decimals of the numbers in these trees, 0 without."""
    return max((b.decimals for node in nodes for b in n.walk(node) if isinstance(b, n.Number)), default=0)


def fewest_decimals(nodes: Iterable[n.Node]) -> int:
    """Return to how many decimals numbers are printed: the fewest of the sides that are one number, else of all; 6 without."""
    nodes = [n.ungrouped(node) for node in nodes]
    alone = [node for node in nodes if isinstance(node, n.Number)]
    inside = [b for node in nodes for b in n.walk(node) if isinstance(b, n.Number) and b.decimals]
    return min((number.decimals for number in alone or inside), default=6)


@dataclass(frozen=True)
class Rounding:
    """How far a printed number may be from the true one: `near` as it is rounded, `far` at most, or it is wrong."""

    near: float
    far: float


EXACT = Rounding(1e-9, 1e-9)


def roundings(node: n.Node, shape: tuple[int, int]) -> dict[tuple[int, int], Rounding]:
    """Return how the numbers of a tree are rounded, at each place (from 0) of its value.

    A whole number among decimals has theirs, one of millimetres is rounded to these; an expression of decimals is exact, or not
    known to half a unit.
    """
    node = n.ungrouped(node)
    cells = node.cells if isinstance(node, n.Matrix) else ()
    places = [(r, c) for r in range(shape[0]) for c in range(shape[1])]
    if len(cells) != len(places):
        return dict.fromkeys(places, _rounding(node, node))
    return {place: _rounding(cell, node) for place, cell in zip(places, cells, strict=True)}


def _rounding(cell: n.Node, whole: n.Node) -> Rounding:
    decimals = [b.decimals for b in n.walk(cell) if isinstance(b, n.Number) and b.decimals]
    alone = not any(isinstance(b, n.Product | n.Quotient | n.Power | n.Call) for b in n.walk(cell))
    if not decimals and alone:
        decimals = [b.decimals for b in n.walk(whole) if isinstance(b, n.Number) and b.decimals]
    marks = [b.operator for b in n.walk(cell) if isinstance(b, n.Postfix)]
    if not decimals and not any(map(is_length, marks)) and not _is_large(cell):
        return EXACT
    unit = 10.0 ** -max(decimals, default=0) * min(filter(None, map(size_of, marks)), default=1.0)
    return Rounding(unit / 2 + 1e-9 if alone else EXACT.near, unit + 1e-9)


def may_be_rounded(members: Members, outcome: Outcome) -> bool:
    """Whether the numbers of an equation between numbers, each half a unit off, can make it right: 18.106 − 8·0.643 = 12.964.

    Those of fewer than three decimals count as exact but in degrees, and of two beside a root: a length of 0.5 is no rounded one.
    Where the last digit alone is off by one, 8.6 · 5.39 = 46.3, those of two digits are rounded ones as well.
    """
    pair = outcome.pair
    if pair is not None and (unit := _whole_unit(outcome)) is not None:
        apart = pair.true.rows[0][0] - pair.printed.rows[0][0]
        return abs(remainder(members.number(apart), tau)) <= unit
    if pair is None or symbols_in((*pair.true.cells, *pair.printed.cells)):
        return False
    slack = dict.fromkeys(outcome.wrong, 0.0)
    is_near = _is_last_digit_off(members, outcome)
    for side, value, other in ((outcome.true, pair.true, pair.printed), (outcome.printed, pair.printed, pair.true)):
        assert side is not None
        fine = COARSE if is_constant(value) and not is_constant(other) else FINE
        for number in _of_two_digits(side.node) if is_near else rounded_numbers(side.node, fine):
            off = n.Number(number.value + Fraction(1, 2 * 10**number.decimals))
            moved = as_matrix(members.evaluate(n.substitute(side.node, number, off)).value)
            if moved.shape != value.shape:
                return False
            for row, column in slack:
                slack[row, column] += abs(members.number(moved.rows[row][column] - value.rows[row][column]))
    apart = {(r, c): members.number(pair.true.rows[r][c] - pair.printed.rows[r][c]) for r, c in slack}
    return all(abs(size) <= slack[place] + EXACT.near for place, size in apart.items())


def _is_last_digit_off(members: Members, outcome: Outcome) -> bool:
    """Whether a number beside a formula of numbers is another by one in its last digit."""
    pair, sides = outcome.pair, [*map(n.ungrouped, outcome.nodes)]
    alone = [each for each in sides if isinstance(each, n.Number)]
    if pair is None or not pair.is_scalar or len(alone) != 1 or not all(map(is_number, sides)):
        return False
    apart = members.number(pair.true.rows[0][0] - pair.printed.rows[0][0])
    return abs(apart) <= 10.0 ** -alone[0].decimals + EXACT.near


def _of_two_digits(node: n.Node) -> list[n.Number]:
    """Return the decimals of a tree that have two digits or more: 8.6, and not 0.5."""
    below = [each for each in n.walk(node) if isinstance(each, n.Number) and each.decimals]
    return [each for each in below if abs(each.value) * 10**each.decimals >= TWO_DIGITS]


def slacks(members: Members, node: n.Node) -> list[dict[tuple[int, int], float]]:
    """Return how far half a unit of each rounded number takes the numbers that a formula of numbers is, at each place (from 0)."""
    if any(isinstance(below, n.Name | n.JointAngles) and not is_number(below) for below in n.walk(node)):
        return []
    value = as_matrix(stacked(members.evaluate(node).value))
    found = []
    for number in rounded_numbers(node, FINE):
        off = n.Number(number.value + Fraction(1, 2 * 10**number.decimals))
        moved = as_matrix(stacked(members.evaluate(n.substitute(node, number, off)).value))
        if moved.shape == value.shape:
            found.append({(r, c): abs(members.number(moved.rows[r][c] - value.rows[r][c])) for r, c in value.places})
    return found


def roundings_of(members: Members, numbers: n.Node, shape: tuple[int, int]) -> dict[tuple[int, int], Rounding]:
    """Return how numbers are rounded; one that is worked out, 40 · 0.866 + 30 · 0.259, by one of its own numbers."""
    allowed = roundings(numbers, shape)
    if isinstance(n.bare(numbers), n.Number | n.Matrix):
        return allowed
    off = slacks(members, numbers)
    return {place: _worked_out(each, [sizes.get(place, 0.0) for sizes in off]) for place, each in allowed.items()}


def _worked_out(rounding: Rounding, off: Sequence[float]) -> Rounding:
    return Rounding(max(rounding.near, *off), max(rounding.far, 2 * sum(off))) if off else rounding


def rounded_numbers(node: n.Node, fine: int) -> list[n.Number]:
    """Return the numbers of a tree that are rounded, perhaps: of so many decimals, or decimals of degrees."""
    below = [*n.walk(node)]
    angles = [each.base for each in below if isinstance(each, n.Postfix) and each.operator == "deg"]
    return [b for b in below if isinstance(b, n.Number) and (b.decimals >= fine or (b.decimals and b in angles))]


def _whole_unit(outcome: Outcome) -> float | None:
    """Return the unit of a whole number of degrees (mm, cm) that stands for decimals, arccos(−0.35) = 110°, or None."""
    sides = [*map(n.ungrouped, outcome.nodes)]
    if outcome.pair is None or not outcome.pair.is_scalar or not all(map(is_number, sides)):
        return None
    for whole, other in (sides, sides[::-1]):
        units = [
            b
            for b in n.walk(whole)
            if isinstance(b, n.Postfix) and size_of(b.operator) and isinstance(b.base, n.Number)
        ]
        alone = all(isinstance(b, n.Postfix | n.Number | n.Sum | n.Group) for b in n.walk(whole)) and len(units) == 1
        if alone and not finest_decimals([whole]) and finest_decimals([other]) and not isinstance(other, n.Number):
            return size_of(units[0].operator)
    return None


def holds_to_its_decimals(route: SecondRoute, outcome: Outcome, branches: bool) -> bool:
    """Confirm an equation whose numbers are rounded (1.501 for √(1.5² + 0.054²)) to the decimals they are printed with.

    Two decimals in a formula (1.57 for π/2) are too few to confirm it: it is unchecked.
    """
    assert outcome.true is not None and outcome.printed is not None
    of_numbers, sides = _decimals_of_numbers(outcome), (outcome.true.node, outcome.printed.node)
    fine = of_numbers if of_numbers is not None else route.members.decimals(*sides)
    decimals = fine if fine is not None else route.members.decimals(*sides, least=COARSE)
    if decimals is None or not _leaves_rounding(outcome, decimals):
        return False
    errors = route.sampled_errors(outcome, branches)
    if errors is None:
        return False
    units = 0.45 if fine is not None else 1.0  # of the last decimal; errors are scaled by 1 + size
    tolerance = units * 10.0**-decimals
    if of_numbers is not None:
        tolerance = max(_rounding(side.node, side.node).near for side in (outcome.true, outcome.printed)) / (
            1 + errors.size
        )
    holding = errors.where_equal(tolerance)
    left, right = sorted((outcome.true.node, outcome.printed.node), key=lambda node: node.span)
    counts = errors.on_a_branch(tolerance)
    everywhere = holding.samples == errors.samples >= FEWEST
    if not everywhere and not (route.is_solved_for(left, right) and counts):
        return False
    is_finer = fine is not None and finest_decimals(outcome.nodes) > decimals  # some digits are printed behind these
    if (not everywhere or is_finer) and errors.is_beside(tolerance, _slack_at_samples(route, outcome, branches)):
        outcome.verdict, outcome.wrong, outcome.pair = Verdict.UNCHECKED, [], None
        outcome.findings = (say(Kind.DIGITS_OFF),)
        return True
    if fine is None:
        outcome.verdict, outcome.wrong, outcome.pair = Verdict.UNCHECKED, [], None
        outcome.findings = (say(Kind.TOO_FEW_DECIMALS, decimals=decimals),)
        return True
    outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
    outcome.samples, outcome.max_error = holding.samples, holding.largest
    said = say(Kind.TO_DECIMALS, decimals=decimals)
    if not everywhere and counts is not None:
        of = {"holding": counts[0], "configurations": counts[1]}
        said = say(Kind.TO_DECIMALS_ON_A_BRANCH, decimals=decimals, **of)
    outcome.findings = (said,)
    return True


def _slack_at_samples(route: SecondRoute, outcome: Outcome, branches: bool) -> Iterator[SampledErrors]:
    """Yield how far half a unit of each number of the sides takes these, at each sample."""
    for side in outcome.sides:
        for number in rounded_numbers(side.node, FINE):
            off = n.Number(number.value + Fraction(1, 2 * 10**number.decimals))
            moved = replace(side, node=n.substitute(side.node, number, off))
            found = route.sampled_errors(replace(outcome, true=side, printed=moved, pair=None), branches)
            yield from () if found is None else (found,)


def _decimals_of_numbers(outcome: Outcome) -> int | None:
    """Return to how many decimals a number is printed that stands for another: 1.57 for π/2, 1732 for 1000√3; None of anything else."""
    sides = outcome.nodes
    if outcome.pair is None or not outcome.pair.is_scalar or not all(map(is_number, sides)):
        return None
    if not finest_decimals(sides):
        return 0 if any(map(_is_large, sides)) else None
    return fewest_decimals(sides) or None


def _is_large(node: n.Node) -> bool:
    """Whether a tree is a whole number that is so large that it may be rounded."""
    node = n.ungrouped(node)
    return isinstance(node, n.Number) and not node.decimals and node.value >= LARGE


def _leaves_rounding(outcome: Outcome, decimals: int) -> bool:
    """Whether a wrong entry may be wrong by rounding: 0.334 for 0.333 is not, the decimals printed hold 0.333 exactly."""
    assert outcome.true is not None and outcome.printed is not None
    if outcome.pair is None:
        return True
    decimals = max(decimals, finest_decimals((outcome.true.node, outcome.printed.node)))
    true, printed = outcome.pair.true.rows, outcome.pair.printed.rows
    for difference in (true[r][c] - printed[r][c] for r, c in outcome.wrong):
        roots = any(kind in ("sqrt", "pi") for kind, _ in difference.generators)
        if roots or not difference.denominator.is_one() or leaves_open(difference):
            continue
        if all((k * 10**decimals).denominator == 1 for _, k in difference.ring.terms(difference.numerator)):
            return False
    return True
