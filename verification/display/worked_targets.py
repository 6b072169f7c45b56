"""Inverse kinematics by numbers: a document says in numbers where the tool is to be, and works out what reaches it.

    P = (0.4, 0.3, 0.6),  θ_1 = atan2(0.3, 0.4) = 36.87°,  D = -0.175,  θ_3 = 100.08°,  …

The numbers that it prints for the joints are near a configuration q that reaches the target exactly, f(q) = p, which Newton's
method finds from them. Every other number of the example is that of a quantity of the arm at this q.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import islice, product
from math import degrees, isfinite, remainder, tau

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display
from armproof.verification.equations.decimals import COARSE, EXACT, FINE, finest_decimals, rounded_numbers, roundings
from armproof.verification.equations.inequalities import is_numbers
from armproof.verification.equations.sides import Members
from armproof.verification.errors import EvaluationError, ReadError, TooComplex
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, is_number
from armproof.verification.naming.conventions import is_usual
from armproof.verification.patterns import regex

KINDS = ("origin", "pose", "rotation", "angle")
MOST_STARTS = 16
SAME = 1e-5  # of one angle to another
FEWEST = 2  # joints whose printed numbers are those of the configuration
_DIGIT = regex(r"\d")
Numbers = dict[str, float]
Asked = tuple[Scalar, float]  # an entry of a quantity of the arm, and the value that it is to have


@dataclass
class _Example:
    """Where the tool is to be, since a line, and the numbers printed behind it for the joints, with how far each is rounded."""

    line: int
    asked: dict[str, tuple[Asked, ...]] = field(default_factory=dict)
    joints: dict[str, list[tuple[float, float]]] = field(default_factory=dict)


class Reached:
    """A configuration that reaches a target, and the numbers there."""

    def __init__(self, members: Members, q: Numbers, lengths: Numbers) -> None:
        from armproof.verification.evaluation.reaching import algebra_at

        self.members = members
        self.algebra = algebra_at(members.exact, q, lengths)

    def value(self, node: n.Node) -> list[float] | None:
        """Return the entries of a side there, row by row; None where it has no value."""
        with suppress(EvaluationError, TooComplex, ZeroDivisionError):
            value = Evaluator(self.members.names, self.algebra).evaluate(node)
            cells = [float(cell[0]) for cell in as_matrix(value).cells]
            return cells if all(map(isfinite, cells)) else None
        return None

    def errors(self, node: n.Node, true: Sequence[float]) -> list[tuple[float, float]] | None:
        """Return how far each number of a side is from the true one, and how far it may be; None where it is of another size."""
        printed = self.value(node)
        if printed is None or len(printed) != len(true):
            return None
        cells = written_cells(node)
        if isinstance(bare(node), n.Matrix) and len(cells) == len(true):
            near = [each.near for each in roundings(node, (len(cells), 1)).values()]
            allowed = [
                max(self._slacks(cell, 1)[0], _allowed(cell, off)) for cell, off in zip(cells, near, strict=True)
            ]
        else:
            off = _allowed(node, roundings(node, (1, 1))[0, 0].near)
            allowed = [max(each, off) for each in self._slacks(node, len(true))]
        turns = any(isinstance(b, n.Postfix) and b.operator == "deg" for b in n.walk(node))
        return [(abs(_apart(a, b, turns)), off) for a, b, off in zip(printed, true, allowed, strict=True)]

    def _slacks(self, node: n.Node, size: int) -> list[float]:
        """Return how far half a unit of each rounded number of a side takes each of its entries: each alone, all at their worst."""
        total = [EXACT.near] * size
        before = self.value(node)
        for number in rounded_numbers(node, FINE) if before is not None and not _is_alone(node) else ():
            moved = self.value(
                n.substitute(node, number, n.Number(number.value + Fraction(1, 2 * 10**number.decimals)))
            )
            if before is not None and moved is not None and len(moved) == len(before) == size:
                total = [each + abs(a - b) for each, a, b in zip(total, before, moved, strict=True)]
        return total


def _is_alone(node: n.Node) -> bool:
    return not any(
        isinstance(b, n.Product | n.Quotient | n.Power | n.Call) or _is_sum(b) for b in n.walk(n.ungrouped(node))
    )


def _is_sum(node: n.Node) -> bool:
    return isinstance(node, n.Sum) and len(node.terms) > 1


def _allowed(node: n.Node, near: float) -> float:
    """Return how far a number that stands alone may be: half a unit of its last decimal.

    One of a single decimal is exact: nobody rounds so much on his way.
    """
    return near if _is_alone(node) and finest_decimals([node]) != 1 else EXACT.near


class WorkedTargets:
    """The examples of a document in which a target is reached, and the configurations that reach them."""

    def __init__(self, displays: Sequence[Display], members: Members) -> None:
        self.displays, self.members, self.names = displays, members, members.names

    def at(self, told: Mapping[str, float]) -> Reached | None:
        """Return the configuration that the text tells, where it tells every joint."""
        arm = self.names.arm
        joints = [joint.symbol for joint in arm.joints] if arm is not None else []
        if not joints or not all(joint in told for joint in joints):
            return None
        return Reached(self.members, {joint: told[joint] for joint in joints}, self._lengths())

    def is_worked(self, node: n.Node) -> bool:
        """Whether a side is made of numbers, and of matrices and vectors at most that the arm has: {}^0_1R [0.7399, 0.4571, 0]."""
        if is_numbers(node):
            return True
        names = [each for each in n.walk(node) if isinstance(each, n.Name)]
        return finest_decimals([node]) >= FINE and all(self._is_whole(each) for each in names)

    def _is_whole(self, name: n.Name) -> bool:
        known = self.names.quantity(name)
        quantity = known or next(iter(self.names.usual(name) if is_usual(name) else ()), None)
        return quantity is not None and not quantity.scalar

    def reached(self, line: int) -> Iterator[Reached]:
        """Yield the configurations that reach the target last stated above a line, which the document prints behind it."""
        from armproof.verification.evaluation.reaching import reaching

        arm = self.names.arm
        example = self._example_at(line) if arm is not None and line else None
        if arm is None or example is None or len(example.joints) < FEWEST:
            return
        joints = [joint.symbol for joint in arm.joints]
        lengths = self._lengths()
        asked = [each for some in example.asked.values() for each in some]
        missing = symbols_in(entry for entry, _ in asked) - {*joints, *lengths}
        if missing or not asked:
            return
        met: list[Numbers] = []
        printed = [example.joints.get(joint, [(0.0, 0.0)]) for joint in joints]
        for start in islice(product(*printed), MOST_STARTS):
            q = reaching(asked, joints, lengths, dict(zip(joints, (value for value, _ in start), strict=True)))
            if q is not None and not any(_same(q, other) for other in met) and self._is_printed(q, example):
                met.append(q)
                yield Reached(self.members, q, lengths)

    def _is_printed(self, q: Numbers, example: _Example) -> bool:
        """Whether the numbers that are printed for the joints are those of a configuration, all but one of many."""
        arm = self.names.arm
        assert arm is not None
        turning = {joint.symbol for joint in arm.joints if joint.kind == "revolute"}
        held = [
            any(abs(_apart(q[joint], value, joint in turning)) <= off for value, off in numbers)
            for joint, numbers in example.joints.items()
        ]
        return sum(held) >= max(FEWEST, len(held) - 1)

    def _lengths(self) -> Numbers:
        state = self.names.state
        told = {**state.given_last, **state.told_lengths, **state.configuration}
        return {key: each.value for key, each in told.items() if key in self.names.lengths}

    def _example_at(self, line: int) -> _Example | None:
        """Return the example in which a display stands: behind its target, and before the next."""
        found: _Example | None = None
        for display in self.displays:
            for chain in self._chains(display):
                if (asked := self._asked(chain)) and display.line <= line:
                    if found is None or found.joints or found.asked.keys() & asked.keys():
                        found = _Example(display.line)
                    found.asked |= asked
                elif asked and found is not None and found.joints and found.asked.keys() & asked.keys():
                    return found
                elif found is not None and (joint := self._of_joint(chain)) is not None:
                    found.joints.setdefault(joint[0], []).append(joint[1:])
        return found

    def _chains(self, display: Display) -> Iterator[n.Chain]:
        """Yield the equations with digits of the text before a display, and its own."""
        own = () if display.erratum or display.denied or not display.closed else (display.latex,)
        for latex in (*display.said, *own):
            with suppress(ReadError, RecursionError):
                found = self.names.reader.read(latex) if _DIGIT.search(latex) else ()
                yield from (each for each in found if isinstance(each, n.Chain) and {*each.relations} <= {"=", "≈"})

    def _asked(self, chain: n.Chain) -> dict[str, tuple[Asked, ...]]:
        """Return the quantities of the tool to which a chain gives numbers and nothing else: (x, y) = (0.4, 0.3), P_x = 0.5, T = [...]."""
        *named, numbers = chain.members
        if len(named) != 1:
            return {}
        names, values = cells_of(named[0]), cells_of(numbers)
        pairs = [*zip(names, values, strict=True)] if names and len(names) == len(values) else [(named[0], numbers)]
        found: dict[str, tuple[Asked, ...]] = {}
        for name, value in pairs:
            asked = self._of_name(name, value)
            if asked is None:
                return {}
            found |= asked
        return found

    def _of_name(self, node: n.Node, number: n.Node) -> dict[str, tuple[Asked, ...]] | None:
        name = bare(node)
        given = bare(number)
        cells = given.cells if isinstance(given, n.Matrix) else cells_of(given) or (given,)
        if not isinstance(name, n.Name) or name.dots or not all(map(is_number, cells)):
            return None
        known = self.names.quantity(name)
        usual = self.names.usual(name) if known is None and is_usual(name) else ()
        quantity = known or next(iter(usual), None)
        if quantity is None or quantity.kind not in KINDS:
            return None
        with suppress(EvaluationError, TooComplex):
            whole = as_matrix(self.members.exact.quantity(quantity)).cells
            numbers = [self._number(cell) for cell in cells]
            if len(whole) != len(numbers) or None in numbers:
                return None
            joints = {*self.names.joints}
            pairs = zip(whole, numbers, strict=True)
            moving = tuple(
                (entry, value)
                for entry, value in pairs
                if isinstance(entry, Scalar) and value is not None and not symbols_in([entry]).isdisjoint(joints)
            )
            return {name.key: moving} if moving else None
        return None

    def _of_joint(self, chain: n.Chain) -> tuple[str, float, float] | None:
        """Return the joint for which a chain ends with a number, the number, and how far it is rounded."""
        first, *_, last = chain.members if len(chain.members) > 1 else (None, None)
        name = bare(first) if first is not None else None
        if not isinstance(name, n.Name) or name.dots or last is None or not is_number(last):
            return None
        symbol = self.names.known_symbol(name.key)
        value = self._number(last) if symbol in self.names.joints else None
        if symbol is None or value is None:
            return None
        return symbol, value, 2 * roundings(last, (1, 1))[0, 0].near

    def _number(self, node: n.Node) -> float | None:
        value = self.members.evaluate(node).value
        return self.members.number(value) if isinstance(value, Scalar) and not symbols_in([value]) else None


def written_cells(node: n.Node) -> tuple[n.Node, ...]:
    """Return the entries of a matrix as it is written, or the side itself."""
    plain = bare(node)
    return tuple(plain.cells) if isinstance(plain, n.Matrix) else (node,)


def with_right_entry(printed: n.Node, entry: int, true: float) -> n.Node | None:
    """Return a side with the right number in the place of a misprint; None where it is none."""
    plain, cells = bare(printed), written_cells(printed)
    right = is_misprint(cells[entry], true) if entry < len(cells) else None
    if right is None or not isinstance(plain, n.Matrix):
        return right
    width = len(plain.rows[0])
    new = [*cells[:entry], right, *cells[entry + 1 :]]
    return replace(plain, rows=tuple(tuple(new[k : k + width]) for k in range(0, len(new), width)))


def is_misprint(printed: n.Node, true: float) -> n.Node | None:
    """Return the right number for one that is a slip of the pen away from it, and not in its last digit: 110.08° for 100.08°; else None.

    A digit is another one, two are swapped, or the sign is missing or too many: what is rounded on the way differs otherwise.
    """
    is_angle = any(isinstance(b, n.Postfix) and b.operator == "deg" for b in n.walk(printed))
    numbers = [b for b in n.walk(printed) if isinstance(b, n.Number)]
    signs = [b.terms[0][0] for b in n.walk(printed) if isinstance(b, n.Sum)]
    if len(numbers) != 1 or numbers[0].decimals < COARSE or len(signs) > 1:
        return None
    number = numbers[0]
    value = degrees(true) if is_angle else true
    digits = f"{abs(value):.{number.decimals}f}"
    is_turned = (signs == ["-"]) != (value < 0)
    right = n.Number(Fraction(digits), digits)
    node: n.Node = n.Postfix(right, "deg") if is_angle else right
    node = n.Sum((("-", node),)) if value < 0 else node
    return node if is_turned == (number.text == digits) and _is_slip(number.text, digits, is_turned) else None


def _is_slip(printed: str, right: str, is_turned: bool) -> bool:
    if is_turned or len(printed) != len(right):
        return is_turned and printed == right
    apart = [k for k, (a, b) in enumerate(zip(printed, right, strict=True)) if a != b]
    swapped = len(apart) == 2 and (printed[apart[0]], printed[apart[1]]) == (right[apart[1]], right[apart[0]])
    return (len(apart) == 1 and apart[0] < len(right) - 2) or (swapped and apart[0] < len(right) - 2)


def _same(one: Numbers, other: Numbers) -> bool:
    return all(abs(remainder(one[key] - other[key], tau)) < SAME for key in one)


def _apart(one: float, other: float, turns: bool) -> float:
    return remainder(one - other, tau) if turns else one - other
