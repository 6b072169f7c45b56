"""Sentences in clauses, each with what it is of and what kinds of words it has: those of `word_classes.py`, in the sentence's language."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

import armproof.verification.document.word_classes as word_classes

Kinds = frozenset[str]

LANGUAGES = ("ENGLISH", "FRENCH", "GERMAN", "SPANISH", "ITALIAN", "PORTUGUESE")
SUBJECTS = ("this", "display", "part", "letter", "person", "writer", "arm", "formula")
_MOST_KNOWN = 4096  # words, so that those of all sentences are looked up once


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

    def at(self, kind: str) -> int:
        """Return the place of the first word of a kind, behind the last where there is none."""
        return next((place for place, each in enumerate(self.kinds) if kind in each), len(self.kinds))

    def begins(self, *kinds: str) -> bool:
        """Whether the first word is of one of some kinds."""
        return bool(self.kinds) and not self.kinds[0].isdisjoint(kinds)


def clauses(words: str) -> tuple[Clause, ...]:
    """Return the clauses of a sentence whose words `hearing.words_of` returns; one without a subject has that of the one before it."""
    small = words.lower().replace("n' t ", " not ")
    spoken = _spoken(small)
    found: list[Clause] = []
    for part, is_led_to in _parts(_joined(spoken, small).split(), spoken):
        kinds = tuple(_kinds(spoken, word) for word in part)
        subject = _subject(kinds) or (found[-1].subject if found else "")
        found.append(Clause(tuple(part), kinds, subject, is_led_to))
    return tuple(found)


def _spoken(words: str) -> tuple[str, ...]:
    """Return the languages that most words of a sentence are of, above all their small ones."""
    all_words = words.split()
    counts = {
        each: sum(len(_kinds((each,), word)) > 0 for word in all_words)
        + 2 * sum("language" in _kinds((each,), word) for word in all_words)
        for each in LANGUAGES
    }
    most = max(counts.values())
    return tuple(each for each, count in counts.items() if count == most)


def _parts(words: Sequence[str], spoken: tuple[str, ...]) -> Iterator[tuple[list[str], bool]]:
    """Yield the words of each clause, and whether "that" leads to it: one that ends its sentence leads to the display."""
    part: list[str] = []
    is_led_to = False
    for place, word in enumerate(words):
        kinds = _kinds(spoken, word)
        leads = "that" in kinds and part and place + 1 < len(words) and "split" not in _kinds(spoken, words[place + 1])
        if not leads and "split" not in kinds:
            part.append(word)
        elif part:
            yield part, is_led_to
            part, is_led_to = [], bool(leads)
    if part:
        yield part, is_led_to


def _subject(kinds: Sequence[Kinds]) -> str:
    """Return what a clause is of: the first noun that no preposition stands before, or the last of several in a row."""
    place = _behind_circumstance(kinds)
    while place < len(kinds) and not (place and "of" in kinds[place]):
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
    if word == "¤":
        return frozenset(["formula"])
    return frozenset(
        kind
        for language in spoken
        for kind, (exact, begins) in _table(language).items()
        if word in exact or word.startswith(begins)
    )


def _joined(spoken: Sequence[str], words: str) -> str:
    """Return words in which those that are one are joined."""
    for language in spoken:
        words = _phrases(language).sub(lambda found: found.group().replace(" ", "_"), words)
    return words


@cache
def _phrases(language: str) -> re.Pattern[str]:
    several = (each for exact, begins in _table(language).values() for each in (*exact, *begins) if "_" in each)
    ordered = sorted(several, key=len, reverse=True)
    return re.compile("|".join(rf"(?<!\S){re.escape(each.replace('_', ' '))}" + r"(?!\S)" for each in ordered) or r"(?!)")


@cache
def _table(language: str) -> dict[str, tuple[frozenset[str], tuple[str, ...]]]:
    """Return the words of each class of a language, and how others of it begin."""
    found = {}
    for line in getattr(word_classes, language).strip().split("\n"):
        kind, *words = line.split()
        exact = frozenset(each for each in words if not each.endswith("~"))
        found[kind] = (exact, tuple(each[:-1] for each in words if each.endswith("~")))
    return found
