"""An arm as a document gives it, its convention still open: rows of DH parameters as front matter writes them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex

_SYMBOL = regex(r"[A-Za-z]\w*'*")


@dataclass(frozen=True)
class Candidate:
    """One reading of what a document shows of its arm.

    Attributes:
        source, line, cell: what it was read from ("table", "matrices" or "closed form"), and where that stands in the file.
        rows: a, alpha, d, theta as text.
        joints: the joint variable of each row, "" where nothing moves.
        symbols: letters of the document that an arm's symbol cannot be → the symbol that stands for them.
        conventions: those that it can be read in.
        frames: the names of all frames, where rows are fixed.
        quantities: names of the document that are usually something else.
        products: where matrices stand that a product shows factor by factor: all of such a display is data.
        stated: the convention that the headers of a table state, α_{i-1} and a_{i-1}, or "".
        several_tools: whether the table shows more end effectors than the one of the last row.
        mended: the links, from 1, whose matrices are none as printed, and would be with another entry.
        in_words: whether the text names the arm of a Jacobian that stands alone, so that it is no other.
        is_alone: whether an equation of another display must hold: a Jacobian by itself may be any.
        told_by: the joint of which an equation must hold, where nothing else could tell that this arm is meant.
    """

    source: str
    line: int
    cell: int | None
    rows: tuple[Mapping[str, str], ...]
    joints: tuple[str, ...]
    symbols: Mapping[str, str] = field(default_factory=dict)
    conventions: tuple[str, ...] = ("classic", "modified")
    more_lines: tuple[tuple[int | None, int], ...] = ()
    frames: tuple[str, ...] = ()
    quantities: Mapping[str, Any] = field(default_factory=dict)
    products: tuple[tuple[int | None, int], ...] = ()
    stated: str = ""
    several_tools: bool = False
    told_by: str = ""
    is_alone: bool = False
    mended: frozenset[int] = frozenset()
    in_words: bool = False

    @property
    def lines(self) -> frozenset[tuple[int | None, int]]:
        """The places (cell, line) of all that it was read from."""
        return frozenset(((self.cell, self.line), *self.more_lines))

    @property
    def indices(self) -> tuple[int, ...]:
        """The numbers of the joint variables that have one."""
        numbers = [re.search(r"_(\d+)'*$", joint) for joint in self.joints if joint]
        return tuple(int(number[1]) for number in numbers if number is not None)

    @property
    def kinds(self) -> str:
        """R for each joint that turns, P for each that slides, from the base on."""
        moving = ((row, joint) for row, joint in zip(self.rows, self.joints, strict=True) if joint)
        return "".join("R" if joint in row["theta"] else "P" for row, joint in moving)

    @property
    def twists(self) -> tuple[str, ...]:
        """How each joint's axis lies to the next."""
        return tuple(row["alpha"] for row in self.rows)

    @property
    def first(self) -> int:
        """The number of the base's frame: 3, where the joints are θ_4, θ_5 and θ_6."""
        begin = self.indices[0] if self.indices else 1
        return begin - 1 if begin > 1 and self.indices == tuple(range(begin, begin + len(self.joints))) else 0

    @property
    def last(self) -> int:
        """The number of the last row's frame."""
        return self.first + len(self.joints)

    def lacks(self, used: Iterable[int]) -> int:
        """Return the largest of some joints' numbers that no joint has, 0 where each has one: that of a fixed row is none's."""
        fixed = "" in self.joints and len(self.indices) == sum(map(bool, self.joints))
        return max((k for k in used if k > self.last or (fixed and k > 0 and k not in self.indices)), default=0)

    @property
    def lengths(self) -> set[str]:
        """The letters of its lengths, none of which moves."""
        entries = (row[column] for row in self.rows for column in ("a", "d"))
        return {letter for entry in entries for letter in _SYMBOL.findall(entry)} - {*self.joints}

    @property
    def is_numeric(self) -> bool:
        """Whether its lengths are numbers."""
        entries = [row[column] for row in self.rows for column in ("a", "d")]
        return all(not re.search("[A-Za-z]", entry) or entry in self.joints for entry in entries)

    def is_other_than(self, before: Candidate) -> bool:
        """Whether it is another arm than one before it: not the same once more, nor the same with numbers for letters."""
        if self.is_numeric == before.is_numeric:
            return (self.rows, self.joints) != (before.rows, before.joints)
        angles = [[(row["alpha"], row["theta"]) for row in one.rows] for one in (self, before)]
        return self.joints != before.joints or angles[0] != angles[1]

    def holds_more_than(self, told: Candidate) -> bool:
        """Whether it is another arm with more lengths: without these its joints and lengths stand in the same order."""
        return self.lengths > told.lengths and self._in_order(told) == told._in_order(told)

    def _in_order(self, of: Candidate) -> list[str]:
        """Return the joints and lengths of an arm that this one has, with their signs, from the base on."""
        entries = [row[column] for row in self.rows for column in ("theta", "d", "a")]
        letters = {*of.joints, *of.lengths}
        found = [each for entry in entries for each in re.findall(r"-?[A-Za-z]\w*", entry)]
        return [each for each in found if each.lstrip("-") in letters]

    def front(self, convention: str) -> dict[str, Any]:
        """Return the keys of front matter that name this arm in a convention."""
        rows = [{name: int(entry) if entry.isdigit() else entry for name, entry in row.items()} for row in self.rows]
        arm: dict[str, Any] = {"dh": convention, "rows": rows, "joints": [joint for joint in self.joints if joint]}
        if self.frames:
            arm["frames"] = list(self.frames)
        elif self.first:
            arm["first"] = self.first
        named = {"symbols": dict(self.symbols), "quantities": dict(self.quantities)}
        return {"arm": arm, **{key: value for key, value in named.items() if value}}


def symbol_of(key: str) -> str:
    """Return a symbol that an arm may have for a letter of a document."""
    return key if _SYMBOL.fullmatch(key) else re.sub(r"\W", "_", key)


def entry_text(value: Scalar) -> str:
    """Return a sum of symbols, a multiple of π and a number as an entry of a DH table; raises EvaluationError."""
    value = value.normal()
    if not value.denominator.is_one():
        raise EvaluationError(say(Kind.NO_DH_ENTRY, value=_plain(value)))
    terms = [_term(powers, factor) for powers, factor in value.ring.terms(value.numerator)]
    if None in terms:
        raise EvaluationError(say(Kind.NO_DH_ENTRY, value=_plain(value)))
    return " + ".join(sorted((str(term) for term in terms), key=_rank)).replace("+ -", "- ") or "0"


def _plain(value: Scalar) -> str:
    """Return a value that is no entry by its letters."""
    return ", ".join(sorted({name or kind for kind, name in value.generators}))


def _term(powers: Mapping[tuple[str, str], int], factor: Fraction) -> str | None:
    if any(power != 1 or kind not in ("symbol", "pi") for (kind, _), power in powers.items()) or len(powers) > 1:
        return None
    name = next(("pi" if kind == "pi" else symbol_of(name) for kind, name in powers), "")
    if not name:
        return _number(factor)
    above = {1: name, -1: f"-{name}"}.get(factor.numerator, f"{factor.numerator}*{name}")
    return above if factor.denominator == 1 else f"{above}/{factor.denominator}"


def _number(value: Fraction) -> str:
    decimal = value.denominator > 1 and 10**9 % value.denominator == 0
    return f"{float(value):.9f}".rstrip("0") if decimal else str(value)


def _rank(term: str) -> int:
    """Symbols stand before π, and π before a number."""
    bare = term.lstrip("-")
    return 2 if bare[0].isdigit() and not re.search(r"[A-Za-z]", bare) else 1 if re.search(r"\bpi\b", bare) else 0


def renamed(names: Iterable[n.Name]) -> dict[str, str]:
    """Return the letters whose symbol is spelt otherwise, and names of several letters, each with that symbol."""
    names = tuple(names)
    words = {name.key: name.key for name in names if re.fullmatch(r"[A-Z]{2,3}_\d+", name.key)}
    return {**words, **{name.text: symbol_of(name.key) for name in names if symbol_of(name.key) != name.key}}
