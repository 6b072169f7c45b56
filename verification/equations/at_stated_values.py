"""Equations that hold at stated values alone: numbers at a configuration, numbers where the arm has lengths."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import inf, remainder, tau
from typing import Any

from armproof.verification.algebra.calculus import are_rates, is_rate, substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.heading import encloses
from armproof.verification.equations.alignment import Pair, angle_places, exactly_equal
from armproof.verification.equations.at_listed_values import ListedValues
from armproof.verification.equations.decimals import FEW, finest_decimals, roundings_of
from armproof.verification.equations.length_values import length_values
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member, Members
from armproof.verification.equations.stated_rates import columns_of_numbers
from armproof.verification.errors import NoValue, WhereDefined
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.units import is_length
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Stated
from armproof.verification.verdict import Verdict

Place = tuple[int, int]

MANY = 3  # times as many numbers that are right as wrong: hardly by chance


@dataclass
class _Numbers:
    """What numbers of a pair are at the stated values: wrong, or open where a value is missing or is cut off."""

    pair: Pair
    wrong: list[Place] = field(default_factory=list)
    open: list[Place] = field(default_factory=list)
    largest: float = 0.0


def is_led_to(names: Names) -> bool:
    """Whether a sentence leads from values that it gives to what holds there: "For ¤, ¤ and ¤ we get"."""
    return names.state.told.is_direct and not names.state.told.in_words


@dataclass
class StatedValues:
    """Reads an equation that does not hold everywhere as one at the values that displays stated before it.

    A number beside what moves is that at the configuration stated last, and at no other. Numbers where the arm has lengths
    are the values of these, the same in the whole document. In a task none are: what is asked there holds everywhere.
    """

    members: Members
    enabled: bool = True

    @property
    def names(self) -> Names:
        """The names of the document."""
        return self.members.names

    def read(self, outcome: Outcome, pairs: Sequence[Pair]) -> Outcome | None:
        """Return what becomes of an equation that is one at stated values, or None where it is none."""
        if not self.enabled:
            return self._without_lengths(outcome)
        arm = self.names.arm
        if outcome.states_values:
            return None
        one, other = (symbols_in(side.cells) for side in (pairs[0].true, pairs[0].printed))
        if arm is None:  # numbers beside letters are those of a configuration that nobody can tell
            values = (pairs[0].printed if one else pairs[0].true).cells
            if bool(one) is bool(other) or all(value.is_zero() for value in values):
                return None
            listed = self._listed(outcome, pairs, _sides(outcome)[bool(one)].node, one | other)
            return listed or outcome.left_open(say(Kind.NUMBERS_OF_NOWHERE))
        of_arm = {*self.names.joints, *self.names.lengths}
        if not (one and other) and of_arm & (one | other):
            numbers = _sides(outcome)[bool(one)]
            if any(isinstance(each, n.JointAngles) for each in n.walk(numbers.node)):
                return None  # (1 - c_2)/(1 - c_2) is no number of a configuration
            of_names = any(self.members.quantity_of(below) is not None for below in n.walk(numbers.node))
            return None if of_names else self._numbers(outcome, pairs, numbers.node)
        if any(map(is_rate, one ^ other)) and self._is_at_rates(outcome, pairs[0], one, other):
            return self._at_rates(outcome, pairs[0], set(filter(is_rate, one | other)), one ^ other)
        return self._there(outcome, pairs[0], one, other) or self._for_lengths(outcome, pairs[0], one, other)

    def _stated(self, names: Iterable[str]) -> dict[str, Stated]:
        """The values that hold where the display stands: those of lengths everywhere, a configuration in its section and below."""
        here, lengths = self.names.state, self.names.lengths
        return {
            name: stated
            for name in sorted(names)
            if (stated := here.configuration.get(name)) is not None
            and (name in lengths or encloses(stated.section, here.section))
        }

    def _at(self, scalar: Scalar, stated: dict[str, Stated]) -> Scalar:
        return substitute(scalar, {name: self._of_variable(name, value.node) for name, value in stated.items()})

    def _of_variable(self, name: str, node: n.Node) -> Any:
        """Return the value of a variable; what is stated of a joint's letter is the table's angle where that is read so."""
        value = self.members.evaluate(node).value
        return (
            value
            if self.names.table_row(name, name) is None
            else self.names.variable_at(name, value, self.members.exact, name)
        )

    def _rest_on(self, stated: dict[str, Stated]) -> None:
        """Remember the displays that stated the values: they count as used, with all the values that they state."""
        lines = {value.line for value in stated.values()}
        given = self.names.state.configuration.items()
        self.names.state.consulted |= {(name, value.line) for name, value in given if value.line in lines}

    # -- numbers ---------------------------------------------------------------------------------------------------------

    def _numbers(self, outcome: Outcome, pairs: Sequence[Pair], numbers: n.Node) -> Outcome | None:
        tried = [self._judged(pair, numbers) for pair in pairs]
        best = min(tried, key=lambda each: (len(each.wrong), len(each.open)))
        outcome.pair, outcome.wrong = best.pair, []
        if best.wrong and len(best.wrong) <= FEW:
            stated = self._stated(symbols_in(_differences(best.pair)))
            outcome.wrong, outcome.coarse = best.wrong, best.open
            outcome.there = {name: value.value for name, value in stated.items()}
            sides = [side.map(lambda cell: self._at(cell, stated)) for side in (best.pair.true, best.pair.printed)]
            outcome.pair = replace(best.pair, true=sides[0], printed=sides[1])
        elif best.open and not best.wrong and self._says_that_it_vanishes(outcome):
            return None
        elif best.wrong or best.open:
            if listed := self._listed(outcome, pairs, numbers, symbols_in(_differences(best.pair))):
                return listed
            outcome.verdict, outcome.findings = Verdict.UNCHECKED, (say(Kind.NUMBERS_OF_NOWHERE),)
        else:
            outcome.verdict, outcome.samples, outcome.max_error = Verdict.CONFIRMED, 1, best.largest
            outcome.findings = (say(Kind.TO_DECIMALS_THERE),)
        return outcome

    def _listed(self, outcome: Outcome, pairs: Sequence[Pair], numbers: n.Node, names: set[str]) -> Outcome | None:
        """Return what becomes of numbers that are those at the values that code gives, or all but one; None where they are not."""
        stated = {name: self._of_variable(name, each.node) for name, each in self._stated(names).items()}
        return ListedValues(self.members).judge(outcome, pairs, numbers, stated)

    def _says_that_it_vanishes(self, outcome: Outcome) -> bool:
        """z_3 × (p_4 − p_3) = 0 says so of every configuration; p_4 = 0 does not."""
        zero = any(bare(side.node) == n.Number(Fraction(0)) for side in _sides(outcome))
        return zero and any(isinstance(bare(side.node), n.Sum | n.Product) for side in _sides(outcome))

    def _judged(self, pair: Pair, numbers: n.Node) -> _Numbers:
        """Compare entry by entry, as the numbers are rounded."""
        found = _Numbers(pair)
        allowed, angles = roundings_of(self.members, numbers, pair.true.shape), angle_places(pair)
        stated = self._stated(symbols_in(_differences(pair)) & set(self.names.arm.lengths if self.names.arm else ()))
        units = {_has_unit(numbers), *(_has_unit(value.node) for value in stated.values())}
        for place, rounding in allowed.items():
            difference = pair.true.rows[place[0]][place[1]] - pair.printed.rows[place[0]][place[1]]
            error = self._error(difference, place in angles)
            if error is None or rounding.near < error <= rounding.far:
                found.open.append(place)
            elif error > rounding.far:
                (found.open if len(units) > 1 else found.wrong).append(place)
            else:
                found.largest = max(found.largest, error)
        return found

    def _error(self, difference: Scalar, is_angle: bool) -> float | None:
        """The size of a difference at the stated values; None where one is missing that it depends on."""
        assert self.names.arm is not None
        names = symbols_in([difference])
        stated = self._stated(names)
        missing, lengths = names - set(stated), self.names.arm.lengths
        if not missing <= {*lengths, *list(self.names.joints)[:1]}:  # a speed is the same at any θ_1
            return None
        value = None
        with WhereDefined():
            value = self._at(difference, stated)
        if value is None:
            return None
        missing &= symbols_in([value])  # l_2 cos 90° is none
        if not missing <= set(lengths):
            return None
        if missing and not value.is_zero() and length_values([value], lengths) is not None:
            return None
        self._rest_on(stated)
        if missing and not value.is_zero():  # no lengths make d_6 + d_G zero
            return inf
        size = self.members.number(value)
        return abs(remainder(size, tau) if is_angle else size)

    # -- velocities --------------------------------------------------------------------------------------------------------

    def _is_at_rates(self, outcome: Outcome, pair: Pair, one: set[str], other: set[str]) -> bool:
        """Whether an equation may be one at rates that are stated: in a column beside J, or before it."""
        has_column = any(next(columns_of_numbers(side.node), ()) for side in _sides(outcome))
        rests = not all(any(map(is_rate, names)) for names in (one, other))
        told = has_column or (rests and self._stated(filter(is_rate, one | other)))
        return bool(told) and not any(are_rates(side.cells) for side in (pair.true, pair.printed))

    def _at_rates(self, outcome: Outcome, pair: Pair, rates: set[str], differ: set[str]) -> Outcome:
        """ṗ = J [0.1; 0.2], ẋ = -0.2 s_1: the side without rates is that at their values, where these are stated.

        It may be that where what else the sides `differ` in has its stated value, too.
        """
        if not rates <= self._stated(rates).keys():
            return outcome.left_open(say(Kind.NUMBERS_OF_NOWHERE))
        tried = [self._wrong_at(pair, self._stated(names)) for names in (rates, rates | differ)]
        there, wrong, stated = min(tried, key=lambda each: bool(each[1]))
        if len(wrong) > FEW:
            return outcome.left_open(say(Kind.NUMBERS_OF_NOWHERE))
        self._rest_on(stated)
        if wrong:
            return replace(outcome, pair=there, wrong=wrong, there={name: each.value for name, each in stated.items()})
        return replace(
            outcome, verdict=Verdict.CONFIRMED, findings=(say(Kind.HOLDS_THERE),), pair=pair, wrong=[], samples=1
        )

    def _wrong_at(self, pair: Pair, stated: dict[str, Stated]) -> tuple[Pair, list[Place], dict[str, Stated]]:
        """Return a pair at stated values, and which of its entries differ there."""
        sides = [side.map(lambda cell: self._at(cell, stated)) for side in (pair.true, pair.printed)]
        there = replace(pair, true=sides[0], printed=sides[1])
        return there, [place for place, true, printed in there.entries() if not exactly_equal(true, printed)], stated

    # -- what holds there --------------------------------------------------------------------------------------------------

    def _there(self, outcome: Outcome, pair: Pair, one: set[str], other: set[str]) -> Outcome | None:
        """P_x = l_1 behind θ_1 = 0, θ_2 = π/2: a side without the joints that have values, and equal to the other there."""
        joints = {*self.names.joints}
        stated = self._stated((joints & (one | other)) | set(filter(is_rate, one ^ other)))
        if not stated or not (set(stated).isdisjoint(one) or set(stated).isdisjoint(other)):
            return None
        if not self._vanish(pair, stated):
            return None
        if joints & (one if set(stated).isdisjoint(one) else other):  # it may be meant of every configuration
            return replace(
                outcome, verdict=Verdict.UNCHECKED, findings=(say(Kind.HOLDS_THERE_ALONE),), pair=pair, wrong=[]
            )
        self._rest_on(stated)
        return replace(
            outcome, verdict=Verdict.CONFIRMED, findings=(say(Kind.HOLDS_THERE),), pair=pair, wrong=[], samples=1
        )

    def _for_lengths(self, outcome: Outcome, pair: Pair, one: set[str], other: set[str]) -> Outcome | None:
        """P_x = 0.5 c_1 + 0.3 c_{12}: numbers where the arm has lengths; they are data, or agree with what is stated."""
        assert self.names.arm is not None
        lengths = {name: value for name, value in self.names.arm.lengths.items() if name in one | other}
        numbers = _sides(outcome)[set(lengths).isdisjoint(other)].node
        stated = self._stated(lengths)
        if lengths and one & other & lengths.keys():
            return self._for_some_lengths(outcome, pair, self._stated(lengths.keys() & (one ^ other)))
        if not lengths or not (set(lengths).isdisjoint(one) or set(lengths).isdisjoint(other)):
            return None
        here = {name for name, each in stated.items() if encloses(each.section, self.names.state.section)}
        if not _has_factor(numbers) and here != lengths.keys():  # of lengths of 1 no number is left
            return self._for_some_lengths(outcome, pair, stated) if stated.keys() == lengths.keys() else None
        try:
            differences = [self._at(each, stated) for each in _differences(pair)]
        except NoValue:  # the root of a negative number
            return None
        found = length_values(differences, lengths)
        if found is None:
            return self._rounded(outcome, numbers, differences) if len(stated) == len(lengths) else None
        self._rest_on(stated)
        if not lengths.keys() - stated.keys():
            return replace(
                outcome, verdict=Verdict.CONFIRMED, findings=(say(Kind.FOR_STATED_LENGTHS),), pair=pair, wrong=[]
            )
        given = {name: n.Number(value, str(value)) for name, value in found.items()}
        if lengths.keys() - stated.keys() - given.keys():
            return replace(
                outcome, verdict=Verdict.UNCHECKED, findings=(say(Kind.NUMBERS_OF_NOWHERE),), pair=pair, wrong=[]
            )
        return replace(
            outcome, verdict=Verdict.DEFINED, findings=(say(Kind.VALUES_OF_LENGTHS, names=sorted(given)),), pair=None,
            wrong=[], gives=given, defines=tuple(given),
        )  # fmt: skip

    def _for_some_lengths(self, outcome: Outcome, pair: Pair, stated: dict[str, Stated]) -> Outcome | None:
        """Leave open P_x = l_1 c_1 + c_{12} behind l_2 = 1: it may be meant of that length, or have lost it."""
        if not stated or not self._vanish(pair, stated):
            return None
        return outcome.left_open(say(Kind.HOLDS_THERE_ALONE))

    def _without_lengths(self, outcome: Outcome) -> Outcome | None:
        """Leave open decimals that stand where the arm has lengths to which nothing gives values: det J_v = 0.15 s_2."""
        true, printed = _sides(outcome)
        lengths = set(self.names.lengths)
        below = [*n.walk(printed.node)]
        if true.rank < 3 or not any(isinstance(each, n.Number) and each.decimals for each in below):
            return None
        symbols = {self.names.known_symbol(each.key) for each in below if isinstance(each, n.Name)}
        if symbols & lengths or lengths & self.names.state.configuration.keys():
            return None
        return outcome.left_open(say(Kind.NUMBERS_FOR_LENGTHS))

    def _rounded(self, outcome: Outcome, numbers: n.Node, differences: list[Scalar]) -> Outcome | None:
        """Coefficients that are off by less than a unit of the last decimal are rounded, perhaps."""
        unit = Fraction(1, 10 ** finest_decimals((numbers,)))
        if unit == 1 or any(
            abs(number) >= unit for each in differences for _, number in each.ring.terms(each.numerator)
        ):
            return None
        return replace(outcome, verdict=Verdict.UNCHECKED, findings=(say(Kind.NUMBERS_ROUNDED),), wrong=[])

    def _vanish(self, pair: Pair, stated: dict[str, Stated]) -> bool:
        with WhereDefined():
            return all(self._at(each, stated).is_zero() for each in _differences(pair))
        return False


def is_mostly_right(outcome: Outcome, times: int = 1) -> bool:
    """Whether numbers are refuted at stated values, and as many are right as are wrong, or some `times` as many, 0 and ±1 not counted."""
    if outcome.verdict is not Verdict.REFUTED or not outcome.there or outcome.pair is None:
        return False
    telling = {place for place, true, _ in outcome.pair.entries() if true.as_fraction() not in (-1, 0, 1)}
    return len(telling - {*outcome.wrong, *outcome.coarse}) >= times * len(outcome.wrong)


def _sides(outcome: Outcome) -> tuple[Member, Member]:
    assert outcome.true is not None and outcome.printed is not None
    return outcome.true, outcome.printed


def _differences(pair: Pair) -> list[Scalar]:
    return [a - b for _, a, b in pair.entries()]


def _has_unit(node: n.Node) -> bool:
    """Whether a value is in millimetres or centimetres: what stands beside it without a unit may be so, too."""
    return any(isinstance(below, n.Postfix) and is_length(below.operator) for below in n.walk(node))


def _has_factor(node: n.Node) -> bool:
    """Whether a number other than 0 and 1 stands in a tree as a term or a factor: no exponent, no multiple of an angle."""
    if isinstance(node, n.Number):
        return node.value not in (0, 1)
    if isinstance(node, n.Power):
        return _has_factor(node.base)
    return not n.is_call(node, "cos", "sin") and any(map(_has_factor, n.children(node)))
