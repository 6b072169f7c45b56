"""The terms of the field in two languages, as terms.csv lists them, and whether a translation uses them."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from pathlib import Path
from unicodedata import combining, normalize

from armproof.course.sources.places import COURSE
from tests.translations.catalogues import entries

_CODE = re.compile(
    r"\{[^{}]*\}|`[^`]*`|\$[^$]*\$|(?<!\w)'[^']*'(?!\w)|--\w+|\w+\.\w+|<[^<>]*>"
    r"|\b\w+(?:: ?[\[…]| ?=|\()|armproof \w+ \w+|\w+/\S+|\w+: \[.*?\]"
)  # a field, a formula, an option
_ASIDE = re.compile(
    r"\*[^*]*\*|\([^()]*\)|\"[^\"]*\"|[\w-]+\.md"
)  # what is foreign, an aside, quoted or a file may be said otherwise


@dataclass(frozen=True)
class Term:
    """A term: the English one, its translations, the first of which is preferred, words that are never used for it, and a remark.

    A word of a translation may end in other letters than the list has: articulations, prismatiques.
    """

    source: str
    translations: tuple[str, ...]
    never: tuple[str, ...] = ()
    note: str = ""

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """What finds the term in English prose, in the singular or plural."""
        return re.compile(rf"(?<![\w-]){_english(self.source)}(?![\w-])", re.IGNORECASE)

    @cached_property
    def begins(self) -> str:
        """What the term begins with in all its forms, in small letters."""
        return self.source.split(" ")[0][:-1].lower()

    @cached_property
    def inflected(self) -> tuple[re.Pattern[str], ...]:
        """What finds its translations in prose."""
        return tuple(re.compile(_inflected(each)) for each in self.translations)

    def stands_in(self, translation: str) -> bool:
        """Whether a translation holds the term in its language."""
        return any(pattern.search(_plain(translation)) for pattern in self.inflected)

    def misnamed(self, translation: str) -> str:
        """Return the word of a translation that is never used for the term; empty where there is none."""
        own = re.sub(r"«[^»]*»", " ", translation)  # not what is quoted
        return next((each for each in self.never if re.search(rf"\b{re.escape(_plain(each))}s?\b", _plain(own))), "")


def terms_file(lang: str) -> Path:
    return COURSE.root / "translations" / lang / "terms.csv"


def misused_in(catalogue: Path, lang: str) -> list[str]:
    """Return where the entries of a catalogue do not use the listed terms."""
    terms = read_terms(terms_file(lang)) if terms_file(lang).exists() else ()
    found = [each for source, forms in entries(catalogue, lang) for each in misused(terms, source[-1], forms[-1])]
    return [f"another term: {catalogue.name}: {each}" for each in found]


@cache
def read_terms(file: Path) -> tuple[Term, ...]:
    """Return the terms of a list, the longest first: `forward kinematics` is found before `kinematics`."""
    with file.open(encoding="utf-8", newline="") as rows:
        terms = [
            Term(row["english"], _several(row["translation"]), _several(row["never"]), row["note"])
            for row in csv.DictReader(rows)
        ]
    return tuple(sorted(terms, key=lambda term: -len(term.source)))


def misused(terms: Sequence[Term], text: str, translation: str) -> Iterator[str]:
    """Yield where a translation does not use the listed term for one of the text, or uses a word that is never used."""
    left, translation = _ASIDE.sub(" ", _CODE.sub(" ", text)), _CODE.sub(" ", translation)
    small = left.lower()
    for term in (each for each in terms if each.begins in small):
        left, count = term.pattern.subn(" ", left)
        if count and not term.stands_in(translation):
            yield f"'{term.source}' is '{' or '.join(term.translations)}': {translation}"
        elif count and (wrong := term.misnamed(translation)):
            yield f"'{term.source}' is never '{wrong}': {translation}"


def _several(cell: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in cell.split("|") if part.strip())


def _english(source: str) -> str:
    *before, last = source.split(" ")
    plural = rf"(?:{re.escape(last)}s?|{re.escape(last[:-1])}ies)" if last.endswith("y") else rf"{re.escape(last)}(?:s|es)?"  # fmt: skip
    return r"[\s-]+".join([*map(re.escape, before), plural])


def _inflected(words: str) -> str:
    """Return what finds words in their inflected forms: the last letters of each are free."""
    stems = [_plain(word) for word in words.split()]
    return r"\W+(?:\w+\W+)?".join(rf"\b{re.escape(stem[:-1] if len(stem) > 4 else stem)}\w{{0,4}}" for stem in stems)


@lru_cache
def _plain(text: str) -> str:
    return "".join(c for c in normalize("NFKD", text.lower().replace("’", "'")) if not combining(c))
