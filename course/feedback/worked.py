"""How a number follows from what is given: a formula, what slips on the way make of it, and what would have to be given instead."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import combinations

import numpy as np

from armproof.course.feedback.claim import Claim
from armproof.course.feedback.guesses import Guess, alone, instead, nearly, perhaps
from armproof.course.feedback.miscalculated import (
    done_otherwise,
    done_twice,
    leaves_of,
    misread,
    number_node,
    without_degrees,
)
from armproof.models.errors import counted, written
from armproof.models.language import look_up, noted, number_text, separator
from armproof.verification.diagnosis.slips import Letters, dropping_edits, is_trigonometric
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.writer import Notation, Writer
from armproof.verification.naming.reading import FREE

LETTER = re.compile(r"(?:[A-Za-z]|[a-z]{2,7})(?:_\w+)?")
_SPELLINGS = (
    (re.compile(r"\s*·\s*|(?<=\d) (?=\d)"), " · "),
    (re.compile(r"\^°\s*"), "°"),
    (re.compile(r"°(?=[-+])"), "° "),
    (re.compile(r"(?<=cos|sin) (?=\()"), ""),
    (re.compile(r"^-\(([^()+\- ]+)\)$"), r"-\1"),
)
IN_RADIANS = noted("an angle in degrees is taken as radians")
_EITHER = noted("this is {one} or {other}, which are the same here")
_CARRIED = noted("a one that is carried over or borrowed is lost")
_OFF_BY_ONE = noted("one digit is off by one: a slip in the reckoning?")
_EARLY = noted("rounded too early: {short:g} in place of {part}")
_ONES = (0.01, 0.1, 1, 10)  # that are carried over
_DECIMALS = 6
_AWAY = 0.1  # at most, of a given value and of another one
_PLACES = (2, 1, 0)  # decimals that are left of a number on the way
_STEPS = 12  # of the secant
_SMALL = 1e-9
_NEAR = 1e-5  # of a number that is reckoned with the digits that are written
_MOST_APART = 3  # times, of a given value and of another given one that is told in its place
_MOST_FREE = 2  # of any other


@dataclass(frozen=True)
class Worked:
    """A number as a formula of what is given.

    Attributes:
        latex: the formula.
        known: the values of its letters.
        stated: the numbers in it that are given, and are none of the rule's.
        angles: the letters that are angles given in degrees.
    """

    latex: str
    known: Mapping[str, float]
    stated: tuple[float, ...] = ()
    angles: frozenset[str] = frozenset()

    def with_values(self, known: Mapping[str, float]) -> float:
        """Return what the formula gives with other values of some letters."""
        return replace(self, known={**self.known, **known}).value

    def over(self, name: str, values: np.ndarray) -> np.ndarray:
        """Return what the formula gives for each of many values of a letter."""
        known = {each: np.full(len(values), value) for each, value in self.known.items()}
        found = self._claim.evaluated_over({**known, name: values})(self._tree)
        return np.full(len(values), np.nan) if found is None else np.broadcast_to(found, values.shape)

    def share_of(self, name: str) -> float:
        """Return how much less the formula gives where a letter is zero."""
        return self.value - self.with_values({name: 0.0})

    def has(self, name: str, value: float) -> bool:
        """Whether a letter stands in the formula, or its value as a term."""
        return name in self.letters or bool(self.term_of(value))

    def term_of(self, value: float) -> float:
        """Return a number with the sign that it has as a term of the formula; 0 where it is none."""
        total = bare(self._tree)
        terms = total.terms if isinstance(total, n.Sum) else ()
        signs = [sign for sign, term in terms if isinstance(term, n.Number) and abs(float(term.value) - value) < _SMALL]
        return (-value if signs[0] == "-" else value) if signs else 0.0

    @cached_property
    def shown(self) -> str:
        """The formula as it is told."""
        return self._shown(self._tree)

    @cached_property
    def is_short(self) -> bool:
        """Whether the formula is a sum of given values, and nothing else."""
        kinds = n.Sum | n.Name | n.Number | n.Group
        return all(isinstance(node, kinds) for node in n.walk(self._tree))

    @cached_property
    def has_powers(self) -> bool:
        """Whether a square or a root stands in the formula."""
        return any(isinstance(node, n.Power) or n.is_call(node, "sqrt") for node in n.walk(self._tree))  # fmt: skip

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters of the formula."""
        return frozenset(node.key for node in n.names(self._tree))

    @cached_property
    def taken(self) -> frozenset[str]:
        """The given values that the formula takes, letters and numbers as they are written."""
        return frozenset(map(_written, self._given))

    def exchanged(self, one: str, other: str) -> float:
        """Return what the formula gives with two given values in each other's place."""
        instead_of = {one: self._claim.read(other), other: self._claim.read(one)}
        return self._value(
            n.substitute_each(
                self._tree,
                {id(leaf): instead_of[_written(leaf)] for leaf in self._given if _written(leaf) in instead_of},
            )
        )

    @property
    def value(self) -> float:
        """The number."""
        return self._value(self._tree)

    def parts(self) -> Iterator[Guess]:
        """Yield what a part of the formula gives alone, of more than one value; no angle, and no sine alone.

        A part is a term with its sign, terms that stand next to each other, a factor of more than one value.
        """
        total = bare(self._tree)
        if isinstance(total, n.Sum):
            for count in range(1, len(total.terms)):
                for start in range(len(total.terms) - count + 1):
                    yield self._alone(replace(total, terms=total.terms[start : start + count]))
        within = {id(below) for node in n.walk(self._tree) if is_trigonometric(node) for below in n.walk(node)}
        within |= {id(term) for _, term in total.terms} if isinstance(total, n.Sum) else set()
        for node in n.walk(self._tree):
            if isinstance(node, n.Sum | n.Product | n.Quotient | n.Power | n.Call) and id(node) not in within:
                yield self._alone(node)

    def _alone(self, node: n.Node) -> Guess:
        return Guess(self._value(node), lambda: alone(self._shown(node)))

    def slips(self) -> Iterator[Guess]:
        """Yield what the formula gives with one thing done otherwise, or one letter in place of another."""
        if (in_radians := without_degrees(self._tree)) is not self._tree:
            yield Guess(self._value(in_radians), lambda: look_up(IN_RADIANS))
        if self.angles:
            in_degrees = {name: float(np.degrees(self.known[name])) for name in self.angles}
            yield Guess(self.with_values(in_degrees), lambda: look_up(IN_RADIANS))
        for trees in self._slipped:
            for tree in trees:
                yield Guess(self._value(tree), partial(self._said_of, tree, trees))

    def asked_slips(self) -> Iterator[Guess]:
        """Yield what the formula gives with one thing done otherwise, where it is not the one that is asked: this is not said, but asked."""
        for tree in (tree for trees in self._slipped for tree in trees):
            yield Guess(self._value(tree), partial(self._perhaps, tree))

    def pairs(self) -> Iterator[Guess]:
        """Yield what the formula gives with two like things done otherwise."""
        return self._told(done_twice(self._tree))

    @cached_property
    def _slipped(self) -> tuple[list[n.Node], list[n.Node]]:
        """The formulas with one thing done otherwise, and those with one letter in place of another."""
        letters = [leaf for leaf in leaves_of(self._tree) if isinstance(leaf, n.Name)]
        return [*done_otherwise(self._tree)], [*self._confused(letters)]

    def _said_of(self, tree: n.Node, trees: Sequence[n.Node]) -> str:
        """Return what a formula with a slip is; both, where another of these gives the same number of the given values and of others not."""
        other = next((other for other in trees if self._are_alike_here(tree, other)), None)
        return self._said(tree) if other is None else written(_EITHER, one=self._shown(tree), other=self._shown(other))

    def _are_alike_here(self, one: n.Node, other: n.Node) -> bool:
        """Whether two formulas give one number of the given values, and two of others."""
        return (
            abs(self._value(one) - self._value(other))
            < _SMALL
            < abs(self._elsewhere_of(one) - self._elsewhere_of(other))
        )

    def coincidences(self) -> Iterator[tuple[float, str, str]]:
        """Yield the numbers that two slips give, alike here and not elsewhere, and what is said of each of them alone."""
        for trees in self._slipped:
            found = [(self._value(tree), self._elsewhere_of(tree), tree) for tree in trees]
            for (value, elsewhere, one), (same, apart, other) in combinations(found, 2):
                if abs(value - same) < _SMALL < abs(elsewhere - apart):
                    yield value, self._said(one), self._said(other)

    def _elsewhere_of(self, tree: n.Node) -> float:
        """Return what a formula would give if other values were given, none of them in a simple relation to another."""
        stated = {value: k for k, value in enumerate(dict.fromkeys(map(abs, self.stated)), 1)}
        others = {id(leaf): number_node(self._value(leaf) + _AWAY * np.sin(stated[self._value(leaf)]))
                  for leaf in leaves_of(tree) if isinstance(leaf, n.Number) and self._value(leaf) in stated}  # fmt: skip
        known = {name: value + _AWAY * np.cos(k) for k, (name, value) in enumerate(sorted(self.known.items()))}
        return replace(self, known=known)._value(n.substitute_each(tree, others))

    def confusions(self) -> Iterator[Guess]:
        """Yield what it gives with one given value in place of another, of those that it takes and of all that are given."""
        return self._told(self._confused(self._given, self._elsewhere))

    def misreadings(self) -> Iterator[Guess]:
        """Yield what it gives with one given value that is misread."""
        return self._told(self._taken())

    def long_shots(self) -> Iterator[Guess]:
        """Yield what it gives with two things done otherwise."""
        for tree in self._twice():
            yield Guess(self._value(tree), partial(self._perhaps, tree))

    def miscarried(self) -> Iterator[Guess]:
        """Yield the sum with a one that is carried over, or borrowed, left out."""
        total = bare(self._tree)
        terms = (
            [(1 if sign == "+" else -1) * self._value(term) for sign, term in total.terms]
            if isinstance(total, n.Sum) and len(total.terms) > 1
            else []
        )
        for one in _ONES if terms else ():
            over = sum(np.sign(term) * (round(abs(term) / one, _DECIMALS) % 1) for term in terms)
            carried = one * np.floor(round(over, _DECIMALS))
            if carried:
                yield Guess(self.value - carried, lambda: look_up(_CARRIED), is_exact=True)

    def off_by_one(self) -> Iterator[Guess]:
        """Yield the number with its first or second decimal off by one."""
        for one in (0.1, -0.1, 0.01, -0.01):
            yield Guess(self.value + one, lambda: look_up(_OFF_BY_ONE), is_exact=True)

    def _told(self, trees: Iterable[n.Node]) -> Iterator[Guess]:
        for tree in trees:
            yield Guess(self._value(tree), partial(self._said, tree))

    def _said(self, tree: n.Node) -> str:
        said = alone if isinstance(_term_alone(bare(tree)), n.Name | n.Number) else instead
        return said(self._shown(tree))

    def _perhaps(self, tree: n.Node) -> str:
        return perhaps(self._shown(tree))

    def _taken(self) -> Iterator[n.Node]:
        """Yield the formula with one given value that is misread."""
        for leaf in leaves_of(self._tree):
            for number in misread(self._value(leaf)):
                yield n.substitute(self._tree, leaf, number_node(number))

    def _confused(self, leaves: Sequence[n.Node], others: Iterable[n.Node] = ()) -> Iterator[n.Node]:
        """Yield the formula with one of some values, or another, in place of one of them."""
        names = {self._shown(leaf): leaf for leaf in (*leaves, *others)}
        for leaf in leaves:
            for name, other in names.items():
                if name != self._shown(leaf) and self._is_angle(leaf) == self._is_angle(other):
                    yield n.substitute(self._tree, leaf, other)

    def _is_angle(self, leaf: n.Node) -> bool:
        return isinstance(leaf, n.Name) and leaf.key in self.angles

    @property
    def missing(self) -> str:
        """What a number leaves out that is zero: the terms that are not."""
        total = bare(self._tree)
        terms = total.terms if isinstance(total, n.Sum) else (("+", self._tree),)
        shown = [self._shown(bare(term)) for _, term in terms if abs(self._value(term)) > _SMALL]
        return counted("{terms} is missing", "{terms} are missing", len(shown), terms=separator(shown).join(shown))

    def counted_otherwise(self) -> Iterator[Guess]:
        """Yield what a count is with a part of it alone, or without one."""
        yield from self.parts()
        yield from self._told(edit.node for edit in dropping_edits(self._tree, Letters()))

    def rounded(self, is_of_the_rule: bool) -> Iterator[Guess]:
        """Yield what it gives with a part rounded, or cut off, before it is used: a part of the rule, as 15/8, or one of given values; no angle."""
        angles = {
            id(part)
            for node in n.walk(self._tree)
            if is_trigonometric(node)
            for part in n.walk(node)
            if part is not node
        }
        for node in n.walk(self._tree):
            value = self._value(node)
            is_reckoned = (
                node is not self._tree and id(node) not in angles and not isinstance(bare(node), n.Name | n.Number)
            )
            is_reckoned &= is_of_the_rule is not any(leaf in self._given for leaf in leaves_of(node))
            for places in _PLACES if is_reckoned and np.isfinite(value) else ():
                for short in (round(value, places), float(np.trunc(value * 10**places) / 10**places)):
                    has_digits = abs(short) >= 10 ** (1 - places) or not places
                    if short and has_digits and abs(short - value) > _SMALL:
                        other = self._value(n.substitute(self._tree, node, number_node(short)))
                        yield Guess(other, partial(self._rounded_early, node, short))

    def _rounded_early(self, node: n.Node, short: float) -> str:
        return written(_EARLY, part=self._shown(node), short=short)

    def _twice(self) -> Iterator[n.Node]:
        """Yield the formula with two things done otherwise."""
        for first in done_otherwise(self._tree):
            yield from done_otherwise(first)

    def instead(self, given: float) -> str:
        """Return with which value in place of a given one a number would be right, of as few digits: of several one that is given, else the shortest."""
        found: list[tuple[bool, int, float, float, str]] = []
        values = {f"{abs(value):.4g}" for value in (*self.known.values(), *self.stated)}
        for leaf in self._given:
            value = self._solved(leaf, given)
            ratio = value / self._value(leaf)
            shown, own = f"{value:.4g}", f"{self._value(leaf):.4g}"
            most = _MOST_APART if shown in values else _MOST_FREE
            if len(shown) > len(own):
                shown = f"{value:.{len(own.partition('.')[2])}f}"
            if not 1 / most < ratio < most or shown == own or len(shown) > len(own):
                continue
            made = self._value(n.substitute(self._tree, leaf, number_node(float(shown))))
            is_likely = shown in values or _is_misread(shown, own)
            if abs(made - given) < _SMALL or (is_likely and nearly(given, made)):
                found.append((shown not in values, len(shown), abs(ratio - 1), float(shown), self._shown(leaf)))
        if not found:
            return ""
        *_, value, name = min(found)
        return written("it would be right with {value:.4g} in place of {name}", value=value, name=name)

    def _solved(self, leaf: n.Node, given: float) -> float:
        """Return the value of a leaf for which the formula gives a number, by the secant; 0 where there is none."""

        def off(x: float) -> float:
            return self._value(n.substitute(self._tree, leaf, number_node(x))) - given

        one = self._value(leaf)
        other, below = 1.1 * one or 0.1, self.value - given
        for _ in range(_STEPS):
            here = off(other)
            if abs(here) < _NEAR * abs(given) + _SMALL:
                return other
            if here == below or not np.isfinite(here):
                return 0.0
            one, other, below = other, other - here * (other - one) / (here - below), here
        return 0.0

    def _shown(self, tree: n.Node) -> str:
        text = plain_text(Writer(self.latex, self._tree, Notation()).write(tree))
        for spelling, shown in _SPELLINGS:
            text = spelling.sub(shown, text)
        if number_text(0.5, "g") == "0.5":
            return text
        return re.sub(r"(?<=\d)\.(?=\d)", ",", text.replace(", ", " ; "))

    def _value(self, tree: n.Node) -> float:
        """Return the value of a tree; not a number where it has none."""
        value = self._evaluate(tree)
        return float(value[0]) if value is not None else float("nan")

    @cached_property
    def _tree(self) -> n.Node:
        return self._claim.read(self.latex)

    @cached_property
    def _given(self) -> list[n.Name | n.Number]:
        """The letters and numbers in the formula that are given: not π, nor a number of the rule."""
        stated = {*map(abs, self.stated)}
        return [
            leaf
            for leaf in leaves_of(self._tree)
            if (
                leaf.key in self.known and leaf.key not in self.angles
                if isinstance(leaf, n.Name)
                else self._value(leaf) in stated
            )
        ]

    @property
    def _elsewhere(self) -> list[n.Node]:
        """The given values that the formula does not take."""
        there = {self._value(leaf) for leaf in leaves_of(self._tree)}
        names = [name for name, value in self.known.items() if LETTER.fullmatch(name) and value not in there]
        return [
            *map(self._claim.read, names),
            *(number_node(value) for value in {*map(abs, self.stated)} if value not in there),
        ]

    @cached_property
    def _claim(self) -> Claim:
        return Claim({"symbols": {name: FREE for name in self.known if LETTER.fullmatch(name)}})

    @cached_property
    def _evaluate(self) -> Callable[[n.Node], np.ndarray | None]:
        return self._claim.evaluated_over({name: np.array([value]) for name, value in self.known.items()})


def _is_misread(shown: str, own: str) -> bool:
    """Whether a number has one digit otherwise than another one, or lacks the last ones."""
    return own.startswith(shown) or (len(shown) == len(own) and sum(map(str.__ne__, shown, own)) == 1)


def _written(leaf: n.Name | n.Number) -> str:
    return leaf.key if isinstance(leaf, n.Name) else leaf.text


def _term_alone(node: n.Node) -> n.Node:
    """Return the one term of a sum that has no other, with a minus or without."""
    return bare(node.terms[0][1]) if isinstance(node, n.Sum) and len(node.terms) == 1 else node
