"""What of a wrong formula is right: its terms beside those of what is asked, or its factors, where no slip explains it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from armproof.course.feedback.claim import Claim
from armproof.course.feedback.outcome import ASKED, MOST_PLACES
from armproof.course.feedback.relation import Letters, by_places, same, wrong_entries
from armproof.models.errors import ArmproofError, counted, written
from armproof.models.language import look_up, separator
from armproof.verification.diagnosis.diagnosis import find_cell
from armproof.verification.diagnosis.slips import is_scalar_product
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

Value = Callable[[n.Node], np.ndarray | None]
Factors = tuple[n.Node, ...]

_MOST_TERMS = 24
_LONG_ANSWER = 400  # characters
_SMALL = 1e-9
_MOST_SHOWN = 3  # terms in a sentence
_SPACE = re.compile(r"\\(?:left|right)(?![A-Za-z])|\\[,;! ]")
_BRACES = re.compile(r"(?<![\w^])\{([^{}]*)\}")
_QUOTIENT = re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}")
_LONGEST = 60  # characters of a term that is shown
_FUNCTION = re.compile(
    r"\\(?:operatorname|text|mathrm)\{(\w+)\}|\\(cos|sin|tan|sqrt|arccos|arcsin|arctan)(?![A-Za-z])\s*(?=([A-Za-z\\]?))"
)


@dataclass(frozen=True)
class Part:
    """A term of a sum, or a factor of a product, and its values at the samples."""

    shown: str
    values: np.ndarray

    def times(self, other: Part) -> float:
        """Return by which number another part is multiplied to give this one; 0 where it is by none."""
        good = np.isfinite(self.values) & np.isfinite(other.values) & (other.values != 0)
        if not good.any():
            return 0.0
        ratio = float(np.median(self.values[good] / other.values[good]))
        return ratio if ratio and same(self.values, ratio * other.values) else 0.0


@dataclass
class _Compared:
    """The parts of an answer: right ones, of another sign, of another number, not among those asked; and how many are missing."""

    right: list[str] = field(default_factory=list)
    sign: list[str] = field(default_factory=list)
    number: list[str] = field(default_factory=list)
    alien: list[str] = field(default_factory=list)
    missing: int = 0

    @property
    def score(self) -> tuple[int, int]:
        """How much of an answer is recognised."""
        return len(self.right) + len(self.sign) + len(self.number), -len(self.alien)


def terms_astray(claim: Claim, latex: str, at: Letters, only: np.ndarray | None = None) -> str:
    """Return which terms of an answer are among those of what is asked and which are not, of each wrong entry; empty where it has none.

    Args:
        only: the entries to tell of.
    """
    true, obtained = claim.values_over(ASKED, at), claim.values_over(latex, at)
    if true.shape != obtained.shape:
        return ""
    node, value = claim.read(latex), claim.evaluated_over(at)
    right = _Right(claim, latex)
    told = {}
    wrong = wrong_entries(true, obtained) & (only if only is not None else True)
    for row, column in np.argwhere(wrong).tolist()[:MOST_PLACES]:
        cell = node if true[0].size == 1 else find_cell(node, row, column)
        if cell is not None and (words := _of_cell(cell, latex, right.cells(row, column, true[0].size == 1), value)):
            told[row, column] = words
    return next(iter(told.values()), "") if true[0].size == 1 else by_places(told)


@dataclass(frozen=True)
class _Right:
    """The right formula in trees: as the task has it, and multiplied out as the verdict writes it."""

    claim: Claim
    latex: str

    def cells(self, row: int, column: int, is_scalar: bool) -> Iterator[tuple[n.Node, str]]:
        """Yield an entry as a tree with its source; of a long one not as the verdict writes it, which takes its time."""
        if self.claim.truth:
            whole = self.claim.read(self.claim.truth)
            if (cell := whole if is_scalar else find_cell(whole, row, column)) is not None:
                yield cell, self.claim.truth
            if len(self.latex) > _LONG_ANSWER:
                return
        for entry in self.claim.record(self.latex).entries:
            if is_scalar or (entry.row, entry.column) == (row + 1, column + 1):
                try:
                    yield self.claim.read(entry.correct), entry.correct
                except ArmproofError:
                    continue


def _of_cell(cell: n.Node, latex: str, cells: Iterator[tuple[n.Node, str]], value: Value) -> str:
    """Return what is said of an entry, beside the first of the right trees that shares a term with it."""
    mine = parts_of_sum(cell, latex, value)
    if not mine:
        return ""
    theirs, asked = [], []
    for node, source in cells:
        if not (parts := parts_of_sum(node, source, value)):
            continue
        theirs.append(parts)
        asked.append((node, source))
        if (found := _compared(mine, parts)).score[0]:
            return _told(found, counted("one term is missing", "{number} terms are missing", found.missing))
    if not theirs:
        return ""
    if any(len(parts) > 1 and mine[0].times(_multiplied_out(parts)) for parts in theirs):
        return look_up("the terms are multiplied: they are to be added")
    return _of_factors(cell, latex, asked, value) or _none_agrees(len(mine), max(map(len, theirs)))


def _multiplied_out(parts: Sequence[Part]) -> Part:
    return Part("", np.asarray(np.prod([part.values for part in parts], axis=0)))


def _of_factors(cell: n.Node, latex: str, asked: Sequence[tuple[n.Node, str]], value: Value) -> str:
    """Say which factors of a product are right, which are not among those asked, and how many are missing."""
    mine = parts_of_product(cell, latex, value)
    theirs = [parts_of_product(node, source, value) for node, source in asked]
    found = max((_compared(mine, parts) for parts in theirs if parts), key=lambda each: each.score, default=None)
    if found is None or len(mine) < 2 or not found.right or isinstance(bare(cell), n.Sum):
        return ""
    return _told(found, counted("one factor is missing", "{number} factors are missing", found.missing))


def _told(found: _Compared, missing: str) -> str:
    clauses = [
        (counted("{parts} is right", "{parts} are right", len(found.right), parts=_listed(found.right)), found.right),
        (counted("{parts} has the wrong sign", "{parts} have the wrong sign", len(found.sign), parts=_listed(found.sign)), found.sign),
        (counted("{parts} has a wrong number", "{parts} have wrong numbers", len(found.number), parts=_listed(found.number)), found.number),
        (counted("{parts} does not belong", "{parts} do not belong", len(found.alien), parts=_listed(found.alien)), found.alien),
    ]  # fmt: skip
    told = [words for words, parts in clauses if parts] + [missing] * bool(found.missing)
    return separator(told).join(told)


def _none_agrees(mine: int, theirs: int) -> str:
    if theirs == 1:
        return counted(
            "what is asked is a single term, and yours is another",
            "what is asked is a single term, and none of your {number} terms is it", mine,
        )  # fmt: skip
    if mine == 1:
        return written("what is asked is a sum of {number} terms, and your answer is none of them: begin with one term", number=theirs)  # fmt: skip
    return written("what is asked is a sum of {number} terms, and none of yours is among them: begin with one term", number=theirs)  # fmt: skip


def _listed(parts: Sequence[str]) -> str:
    if len(parts) > _MOST_SHOWN:
        return ", ".join([*parts[:_MOST_SHOWN], "…"])
    *first, last = parts or ("",)
    return look_up(" and ").join(filter(None, [", ".join(first), last]))


def _compared(mine: Sequence[Part], theirs: Sequence[Part]) -> _Compared:
    found, left = _Compared(), list(theirs)
    for part in mine:
        other = next((each for each in left if part.times(each)), None)
        if other is None:
            found.alien.append(part.shown)
            continue
        left.remove(other)
        ratio = part.times(other)
        kind = found.right if abs(ratio - 1) < _SMALL else found.sign if abs(ratio + 1) < _SMALL else found.number
        kind.append(part.shown)
    found.missing = len(left)
    return found


def parts_of_sum(node: n.Node, latex: str, value: Value) -> list[Part]:
    """Return the terms of an entry with its brackets multiplied out, like ones as one; none where a term has no values."""
    parts: list[Part] = []
    for sign, above, below in _split(node)[:_MOST_TERMS]:
        values = _values(above, below, value)
        if values is None:
            return []
        shown = ("-" if sign < 0 else "") + _shown(above, below, latex)
        _add(parts, Part(shown, sign * values))
    return [part for part in parts if np.nan_to_num(np.abs(part.values)).max() > _SMALL]


def _add(parts: list[Part], part: Part) -> None:
    """Add a term to those before it; to a like one, if there is one."""
    for k, other in enumerate(parts):
        if part.times(other):
            parts[k] = Part(other.shown, other.values + part.values)
            return
    parts.append(part)


def parts_of_product(node: n.Node, latex: str, value: Value) -> list[Part]:
    """Return the factors of an entry without numbers, of a sum those that its terms have in common; none where one has no values."""
    (_, above, below), *others = _split(node) if isinstance(bare(node), n.Sum) else [(1, *_factors(node))]
    factors = _parts_of(above, below, latex, value)
    for _, over, under in others:
        left = _parts_of(over, under, latex, value)
        factors = [part for part in factors if _taken(part, left)]
    if others and factors:
        whole = value(node)
        rest = np.asarray(whole) / _multiplied_out(factors).values if whole is not None else np.zeros(1)
        factors.append(Part("(…)", rest))
    return factors


def _parts_of(above: Factors, below: Factors, latex: str, value: Value) -> list[Part]:
    """Return factors with their values; numbers left out, none at all where one has no values."""
    parts = []
    for factors, power in ((above, 1), (below, -1)):
        for factor in (single for each in factors for single in _factors(each)[0]):
            if (values := value(factor)) is None:
                return []
            if np.nanmax(values) - np.nanmin(values) > _SMALL:
                parts.append(Part(("1 / " if power < 0 else "") + _text(factor, latex), values**power))
    return parts


def _taken(part: Part, left: list[Part]) -> bool:
    """Whether a factor is among others, from which it is taken."""
    other = next((each for each in left if part.times(each)), None)
    if other is not None:
        left.remove(other)
    return other is not None


def _factors(node: n.Node) -> tuple[Factors, Factors]:
    """Return the factors of a tree above and below a line, with brackets as they stand and powers as so many factors."""
    node = bare(node)
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        return _factors(node.terms[0][1])
    if isinstance(node, n.Quotient):
        (above, below), (under, over) = _factors(node.numerator), _factors(node.denominator)
        return above + over, below + under
    if is_scalar_product(node):
        sides = [_factors(factor) for factor in node.factors]
        return tuple(f for above, _ in sides for f in above), tuple(f for _, below in sides for f in below)
    times = _exponent(node)
    return ((node.base,) * times, ()) if isinstance(node, n.Power) and times else ((node,), ())


def _exponent(node: n.Node) -> int:
    """Return the exponent of a power that is a small whole number; 0 of anything else."""
    number = bare(node.exponent) if isinstance(node, n.Power) else None
    is_whole = isinstance(number, n.Number) and number.value.denominator == 1 and 1 < number.value <= _MOST_SHOWN
    return int(number.value) if is_whole and isinstance(number, n.Number) else 0


def _values(above: Factors, below: Factors, value: Value) -> np.ndarray | None:
    sides = [[value(factor) for factor in factors] for factors in (above, below)]
    known = [[each for each in side if each is not None] for side in sides]
    if [*map(len, known)] != [*map(len, sides)]:
        return None
    with np.errstate(all="ignore"):
        upper, lower = (np.prod(np.array(side), axis=0) if side else np.ones(1) for side in known)
        return np.asarray(upper / lower)


def _split(node: n.Node) -> list[tuple[int, Factors, Factors]]:
    """Return the terms of a tree: the sign of each, its factors above and below a line."""
    node = bare(node)
    if isinstance(node, n.Sum) and all(sign in "+-" for sign, _ in node.terms):
        return [
            ((-1 if sign == "-" else 1) * inner, above, below)
            for sign, term in node.terms
            for inner, above, below in _split(term)
        ]
    if isinstance(node, n.Quotient):
        ((sign, over, under),) = one if len(one := _split(node.denominator)) == 1 else [(1, (node.denominator,), ())]
        return [(sign * inner, above + under, below + over) for inner, above, below in _split(node.numerator)]
    if isinstance(node, n.Power) and isinstance(bare(node.base), n.Sum) and _exponent(node) == 2:
        return _multiplied([_split(node.base)] * 2) or [(1, (node,), ())]
    if is_scalar_product(node):
        return _multiplied([_split(factor) for factor in node.factors]) or [(1, (node,), ())]
    return [(1, (node,), ())]


def _multiplied(sums: Sequence[list[tuple[int, Factors, Factors]]]) -> list[tuple[int, Factors, Factors]]:
    """Return a product of sums multiplied out; empty where it would be long."""
    if np.prod([len(terms) for terms in sums]) > _MOST_TERMS:
        return []
    return [
        (
            int(np.prod([sign for sign, _, _ in each])),
            tuple(factor for _, above, _ in each for factor in above),
            tuple(factor for _, _, below in each for factor in below),
        )
        for each in product(*sums)
    ]


def _shown(above: Factors, below: Factors, latex: str) -> str:
    over, under = (_product([_text(factor, latex) for factor in factors]) for factors in (above, below))
    if not below:
        return over
    return f"{over or '1'} / ({under})" if " " in under else f"{over or '1'} / {under}"


def _product(factors: Sequence[str]) -> str:
    """Return factors side by side, the same ones as a power."""
    counts = {factor: factors.count(factor) for factor in factors if factor != "1" or len(factors) == 1}
    shown = {factor: f"({factor})" if re.search(r"[ ^]", factor) and factor[0] != "(" else factor for factor in counts}
    return " ".join(factor if count == 1 else f"{shown[factor]}^{count}" for factor, count in counts.items())


def _text(node: n.Node, latex: str) -> str:
    """Return a factor as it is written, without the commands of LaTeX that only set it."""
    text = _SPACE.sub(" ", latex[node.span[0] : node.span[1]])
    text = _FUNCTION.sub(lambda found: f"{found[1] or found[2]}{' ' * bool(found[3])}", text)
    text = re.sub(r"\^\{(\d)\}", r"^\1", text).replace(r"\cdot", " ")
    while (plain := _QUOTIENT.sub(r"(\1) / (\2)", text)) != text:
        text = plain
    text = re.sub(r"\s+", " ", _BRACES.sub(r"(\1)", text)).strip()
    text = text if len(text) <= _LONGEST else text[:_LONGEST].rstrip() + "…"
    return f"({text})" if isinstance(bare(node), n.Sum) and not text.startswith("(") else text
