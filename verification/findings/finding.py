"""A finding: its kind, its place, its terms; and `pieces`, which alone puts it in words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cache
from string import Formatter
from typing import Any

from armproof.models.errors import ArmproofError, MessageKind, Sentence
from armproof.models.language import look_up, number_text, separator
from armproof.verification.findings.kinds import WORDS, Kind


class Audience(StrEnum):
    """Who reads a finding: a student is not told the right term, nor what concerns our proof alone."""

    REPORT = "report"
    STUDENT = "student"


class Piece(StrEnum):
    """What a piece of a sentence is: words, a formula in LaTeX, or a name or formula as the models spell it (theta_1)."""

    WORDS = "words"
    LATEX = "latex"
    NAME = "name"


ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")
_MARKS = {"$": Piece.LATEX, "`": Piece.NAME}


@dataclass(frozen=True)
class Finding:
    """One reason for a verdict.

    Attributes:
        kind: what it says; a name of the JSON report.
        terms: what the sentence names: LaTeX, symbols, frames, numbers, lists of such, or a finding within this one.
        equation, row, column: where, from 1, as far as it is about one equation or entry.
    """

    kind: MessageKind
    terms: Mapping[str, Any] = field(default_factory=dict, hash=False)
    equation: int | None = None
    row: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        return write(self)

    @property
    def is_told(self) -> bool:
        """Whether a student is told it, and all that it holds."""
        return self.kind.student != "" and all(
            term.is_told for term in self.terms.values() if isinstance(term, Finding)
        )

    def at(self, equation: int | None = None, row: int | None = None, column: int | None = None) -> Finding:
        """Return the finding with its place; what is known of it already stays."""
        return replace(
            self, equation=self.equation or equation, row=self.row or row, column=self.column or column
        )  # fmt: skip

    def renamed(self, old: str, new: str) -> Finding:
        """Return the finding with another text for one in its terms."""
        return replace(self, terms={name: _renamed(term, old, new) for name, term in self.terms.items()})

    def holds(self, other: Finding) -> bool:
        """Whether this finding, or one within it, says what another does, wherever it stands."""
        if self.kind is other.kind and dict(self.terms) == dict(other.terms):
            return True
        return any(term.holds(other) for term in self.terms.values() if isinstance(term, Finding))

    def as_json(self) -> dict[str, Any]:
        """Return the finding as the report's JSON writes it."""
        places = {"equation": self.equation, "row": self.row, "column": self.column}
        return {
            "kind": self.kind.value,
            **{name: place for name, place in places.items() if place is not None},
            "terms": {name: _plain(term) for name, term in self.terms.items()},
        }


def say(kind: MessageKind, **terms: Any) -> Finding:
    """Return a finding of a kind with its terms."""
    return Finding(kind, terms)


def finding_of(error: Exception) -> Finding:
    """Return what an error says: what it was raised with, else its text under the kind of its class."""
    said = error.args[0] if error.args else None
    if isinstance(said, Finding):
        return said
    if isinstance(error, ArmproofError) and isinstance(said, MessageKind):
        terms = error.terms.items()
        return Finding(said, {name: finding_of(term) if isinstance(term, Exception) else term for name, term in terms})
    reason = str(error)
    if isinstance(error, ArmproofError) and isinstance(said, str):
        reason = Sentence(said, **error.terms)
    return say(getattr(error, "kind", None) or Kind.PROBLEM, reason=reason)


def write(finding: Finding, audience: Audience = Audience.REPORT) -> str:
    """Return a finding in words, plain text."""
    return "".join(text for text, _ in pieces(finding, audience))


def write_all(findings: Iterable[Finding]) -> str:
    """Return findings in words, each sentence once."""
    return look_up("; ").join(map(write, distinct(findings)))


def distinct(findings: Iterable[Finding], audience: Audience = Audience.REPORT) -> list[Finding]:
    """Return the findings that have words, each sentence once."""
    found = {write(finding, audience): finding for finding in reversed(list(findings))}
    return [finding for text, finding in reversed(found.items()) if text]


def pieces(finding: Finding, audience: Audience = Audience.REPORT) -> Iterator[tuple[str, Piece]]:
    """Yield a finding in words: the only place where a sentence is made, so that formulas are told from words."""
    own = finding.kind.student if audience is Audience.STUDENT else None
    template = look_up(finding.kind.template if own is None else own)
    if not template:
        return
    parsed = _parsed(template)
    if finding.row is not None and finding.column is not None and not any(name == "row" for _, name, _ in parsed):
        yield look_up("entry ({row}, {column}): ").format(row=finding.row, column=finding.column), Piece.WORDS
    terms = {"row": finding.row, "column": finding.column, **finding.terms}
    inside = Piece.WORDS
    for literal, name, form in parsed:
        text = ""
        for character in literal:  # `theta_1` and $\theta_1$: the marks tell formulas from words
            if character not in _MARKS:
                text += character
                continue
            if text:
                yield text, inside
            text, inside = "", _MARKS[character] if inside is Piece.WORDS else Piece.WORDS
        if text:
            yield text, inside
        if name is not None:
            yield from _term(terms[name], form, inside, audience)


@cache
def _parsed(template: str) -> tuple[tuple[str, str | None, str], ...]:
    return tuple((literal, name, form or "") for literal, name, form, _ in Formatter().parse(template))


def _term(term: Any, form: str, inside: Piece, audience: Audience) -> Iterator[tuple[str, Piece]]:
    if isinstance(term, Finding):
        yield from pieces(term, audience)
    elif form == "lines":
        yield _lines(term), inside
    elif isinstance(term, list | tuple):
        items = [list(_term(item, form, inside, audience)) for item in term]
        between = separator([text for item in items for text, kind in item if kind is not Piece.LATEX or "{,}" in text])
        for index, item in enumerate(items):
            yield from [(between, Piece.WORDS), *item] if index else item
    elif form == "nth":
        yield _nth(term), inside
    else:
        if isinstance(term, str):
            term = term.said() if isinstance(term, Sentence) else look_up(term) if term in WORDS else term
        yield number_text(term, form) if inside is Piece.WORDS else format(term, form), inside


def _lines(numbers: Sequence[int]) -> str:
    """Return [7] as "line 7", and [7, 9] as "lines 7, 9"."""
    if len(numbers) == 1:
        return look_up("line {line}").format(line=numbers[0])
    return look_up("lines {lines}").format(lines=", ".join(map(str, numbers)))


def _nth(number: int) -> str:
    """Return 1 as "first": "factor 2" would be read as the number."""
    return look_up(ORDINALS[number - 1]) if number <= len(ORDINALS) else look_up("{number}th").format(number=number)


def _plain(term: Any) -> Any:
    if isinstance(term, Finding):
        return term.as_json()
    if isinstance(term, list | tuple):
        return [_plain(item) for item in term]
    return term if isinstance(term, str | int | float | None) else str(term)


def _renamed(term: Any, old: str, new: str) -> Any:
    if isinstance(term, Finding):
        return term.renamed(old, new)
    if isinstance(term, list | tuple):
        return [_renamed(item, old, new) for item in term]
    return term.replace(old, new) if isinstance(term, str) else term
