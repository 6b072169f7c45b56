"""Sentences in clauses, each with what it is of and what kinds of words it has: those of `word_classes.py`, in the sentence's language."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

import armproof.verification.document.word_classes as word_classes
from armproof.verification.document.word_lists import classes_of
from armproof.verification.patterns import regex

Kinds = frozenset[str]

LANGUAGES = ("ENGLISH", "FRENCH", "GERMAN", "SPANISH", "ITALIAN", "PORTUGUESE")
_NO_LONGER = regex(r"(?<!\S)((?:ne|n') \S+ )plus ")  # "ne vaut plus" denies, "plus" does not
_ONLY = regex(r"(?<!\S)((?:ne|n') \S+ (?:(?!pas|jamais|plus)\S+ )?)qu(?:e|') ")
SUBJECTS = ("this", "display", "part", "letter", "person", "writer", "arm", "formula")
_POLITE = regex(r"^(?:(?:please|bitte|veuillez|prière de|por favor|per favore|si prega di) (?:, )?)+")
_WEIGHED = frozenset("part person must only general given neutral use counted claim".split())
_IT_IS = frozenset(
    "es son è sono é são".split()
)  # what begins a sentence without a subject is of what stands before it
_OF_NO_CLAIM = (
    "not",
    "if",
    "neutral",
    "same",
    "change",
    "would",
)  # "It would be the velocity", "The other equation gives the ordinate"
_PARTS_OF_MORE = frozenset(
    "basis sum start beginning part consequence key somme début partie grundlage summe anfang teil folge suma inicio somma inizio soma início".split()
)  # "It is the basis of"
_FEW = 2  # words of a clause that is the end of the one before it
_WOULD_BE = frozenset("would_have aurait auraient faudrait".split())  # what must have been, too
OF_DISPLAY = ("this", "display", "part")
_SHORT = 8  # words of what says little else than when the display above it holds
_MOST_KNOWN = 4096  # words, and sentences, so that each is looked up once


@dataclass(frozen=True)
class Clause:
    """A part of a sentence between commas and conjunctions: its words, the kinds of each, and the kind of its subject, "" of none."""

    words: tuple[str, ...]
    kinds: tuple[Kinds, ...]
    subject: str
    is_led_to: bool = False  # by "that": "it is not true that …"

    def has(self, *kinds: str) -> bool:
        """Whether a word is of one of some kinds."""
        return any(not each.isdisjoint(kinds) for each in self.kinds)

    @property
    def is_of_display(self) -> bool:
        """Whether the subject is the display, or a part of it."""
        return self.subject in OF_DISPLAY

    def at(self, kind: str) -> int:
        """Return the place of the first word of a kind, behind the last where there is none."""
        return next((place for place, each in enumerate(self.kinds) if kind in each), len(self.kinds))

    def begins(self, *kinds: str) -> bool:
        """Whether the first word is of one of some kinds."""
        return not self.kinds[0].isdisjoint(kinds)

    def ends(self, *kinds: str) -> bool:
        """Whether the last word is of one of some kinds."""
        return not self.kinds[-1].isdisjoint(kinds)


@lru_cache(maxsize=_MOST_KNOWN)
def clauses(words: str) -> tuple[Clause, ...]:
    """Return the clauses of a sentence whose words `hearing.words_of` returns; one without a subject has that of the one before it."""
    small = _NO_LONGER.sub(
        r"\1jamais ", _ONLY.sub(r"\1seulement ", _POLITE.sub("", words.lower()).replace("n' t ", " not "))
    )
    spoken = _spoken(small)
    found: list[Clause] = []
    for part, is_led_to in _parts(_joined(spoken, small).split(), spoken):
        kinds = _of_predicate([_kinds(spoken, word) for word in part])
        subject = _subject(kinds)
        if found and _goes_back(subject, kinds[0], found[0].subject in ("", *OF_DISPLAY)):
            subject = found[-1].subject
        found.append(Clause(tuple(part), kinds, subject, is_led_to))
    return tuple(found)


def _goes_back(subject: str, first: Kinds, may_be_display: bool) -> bool:
    """Whether a later clause is of what the one before it is: by "it", by no noun, or by "this" where the sentence is of another thing."""
    if subject == "":
        return "article" not in first
    return "pronoun" in first or (subject == "this" and not may_be_display)


def _of_predicate(kinds: Sequence[Kinds]) -> tuple[Kinds, ...]:
    """Return the kinds of the words of a clause without the "not" behind a preposition: "with no factor" denies nothing."""
    before = (frozenset[str](), *kinds)
    return tuple(each - {"not"} if {"of", "with"} & then else each for then, each in zip(before, kinds, strict=False))


def goes_on(words: str) -> bool:
    """Whether a sentence goes on from the display that it stands behind: "if the arm is straight.", or is short."""
    return words[:1].islower() or words.count(" ") <= _SHORT


def is_of_display(words: str) -> bool:
    """Whether a sentence, with its words, tells what the display is that it stands behind: "It describes the elbow"."""
    found = clauses(words)
    if (
        not found
        or words.endswith(": ")
        or found[0].has(*_OF_NO_CLAIM)
        or not _PARTS_OF_MORE.isdisjoint(found[0].words)
    ):
        return False
    begin = found[0]
    is_named = begin.subject == "display" and (begin.has("this") or begin.begins("article"))
    return begin.words[0] in _IT_IS or begin.subject == "this" or is_named


def mentions_only(words: str) -> bool:
    """Whether a sentence says that what it is of has no part in what is at hand: "The centre of mass is not needed", "In the tool frame it would be longer"."""
    found = clauses(words)
    is_without = bool(found) and not found[0].is_of_display and found[0].has("not") and found[0].has("neutral")
    return is_without or any(each.has("would") for each in found)


def says_what_would_be(words: str, at_its_end: bool = False) -> bool:
    """Whether a sentence, or its last clause, is of another case than that at hand: "Would it change for a prismatic joint? In that case"."""
    found = clauses(words)
    if at_its_end and found:  # "we would" and "have", with "then" between them
        found = found[-1 if len(found[-1].words) > _FEW else -2 :]
    return any(map(is_of_what_would_be, found))


def is_of_what_would_be(clause: Clause) -> bool:
    """Whether a clause is of another case than that at hand: "on aurait alors"."""
    return clause.has("would") or not _WOULD_BE.isdisjoint(clause.words)


def is_weighed(word: str) -> bool:
    """Whether a word is of a kind by which a clause is judged but for what is wrong: a sentence is understood with it."""
    return not _kinds(LANGUAGES, word).isdisjoint(_WEIGHED)


def _spoken(words: str) -> tuple[str, ...]:
    """Return the languages whose words most words of a sentence are; small words weigh more."""
    counts = [sum(weights) for weights in zip(*map(_weights, words.split()), strict=True)] or [0] * len(LANGUAGES)
    most = max(counts)
    return tuple(each for each, count in zip(LANGUAGES, counts, strict=True) if count == most)


@lru_cache(maxsize=_MOST_KNOWN)
def _weights(word: str) -> tuple[int, ...]:
    """Return how much a word tells of each language."""
    kinds = (_kinds((each,), word) for each in LANGUAGES)
    return tuple(2 * bool(each) + ("language" in each) for each in kinds)


def _parts(words: Sequence[str], spoken: tuple[str, ...]) -> Iterator[tuple[list[str], bool]]:
    """Yield the words of each clause, and whether "that" leads to it: one that ends its sentence leads to the display."""
    part: list[str] = []
    is_led_to = False
    for place, word in enumerate(words):
        kinds = _kinds(spoken, word)
        leads = "that" in kinds and 0 < place < len(words) - 1 and "split" not in _kinds(spoken, words[place + 1])
        if not leads and "split" not in kinds:
            part.append(word)
        elif part:
            yield part, is_led_to
            part, is_led_to = [], leads
    if part:
        yield part, is_led_to


def _subject(kinds: Sequence[Kinds]) -> str:
    """Return what a clause is of: the first noun that no preposition, "not" or fault stands before, or the last of several in a row."""
    place = _behind_circumstance(kinds)
    while place < len(kinds) and not (place and kinds[place] & {"of", "not", "fault"}):
        found = _of(kinds[place])
        while found and place + 1 < len(kinds) and (then := _of(kinds[place + 1])) in _NOUNS:
            place, found = place + 1, then
        if found:
            return found
        place += 1
    return ""


def _behind_circumstance(kinds: Sequence[Kinds]) -> int:
    """Return the place behind what a clause begins with by a preposition, "in this line", or behind its "if"."""
    if not kinds or not kinds[0] & {"of", "if"} or "this" in kinds[0]:
        return 0
    if "of" not in kinds[0]:
        return 1
    is_of_this = len(kinds) > 1 and "this" in kinds[1]
    return next((place + 1 for place, each in enumerate(kinds) if each & _NOUNS), 2 if is_of_this else 1)


_NOUNS = frozenset(["display", "part", "letter", "person", "arm"])


def _of(kinds: Kinds) -> str:
    return next((each for each in SUBJECTS if each in kinds), "")


@lru_cache(maxsize=_MOST_KNOWN)
def _kinds(spoken: tuple[str, ...], word: str) -> Kinds:
    """Return the classes that a word is of in some languages: by itself, or by one of the stems that it begins with."""
    if word == "¤":
        return frozenset(["formula"])
    found: set[str] = set()
    for language in spoken:
        table = _table(language)
        stems = (table.get(f"{word[:length]}~", ()) for length in range(1, len(word) + 1))
        found.update(table.get(word, ()), table.get(word.rstrip("'"), ()), *stems)
    return frozenset(found)


def _joined(spoken: Sequence[str], words: str) -> str:
    """Return words in which those that are one are joined."""
    for language in spoken:
        words = _phrases(language).sub(lambda found: found.group().replace(" ", "_"), words)
    return words


@cache
def _phrases(language: str) -> re.Pattern[str]:
    """Return the pattern of what is several words in a text and one in the classes of a language, the longest first."""
    several = sorted((each.replace("_", " ") for each in _table(language) if "_" in each), key=len, reverse=True)
    return re.compile(rf"(?<!\S)(?:{'|'.join(re.escape(each) for each in several)})(?!\S)")


@cache
def _table(language: str) -> dict[str, Kinds]:
    """Return the words and stems of a language, those with "~", each with its classes."""
    found: dict[str, set[str]] = {}
    for kind, words in classes_of(getattr(word_classes, language)):
        for word in words:
            found.setdefault(word, set()).add(kind)
    return {word: frozenset(kinds) for word, kinds in found.items()}
