"""What is to be built, what became of it, and a lesson as the others refer to it: what the processes of a build tell each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from armproof.course.sources.places import COURSE, Place
from armproof.models.language import ENGLISH

NAMES = {"en": "English", "fr": "Français"}


@dataclass(frozen=True)
class Order:
    """What is to be built: sources in the order of the lessons, their place, the edition, the languages and one of them."""

    sources: tuple[Path, ...]
    place: Place = COURSE
    solutions: bool = False
    langs: tuple[str, ...] = (ENGLISH,)
    lang: str = ENGLISH

    @property
    def suffix(self) -> str:
        """What the files of this language end in before their suffix; those of the first language in nothing."""
        return ending_of(self.lang, self.langs)

    def in_each_language(self) -> list[Order]:
        """Return the order for each of its languages."""
        return [replace(self, lang=lang) for lang in self.langs]


def ending_of(lang: str, langs: Sequence[str]) -> str:
    """Return what the files of a language end in."""
    return "" if lang == langs[0] else f".{lang}"


@dataclass(frozen=True)
class Built:
    """What became of a lesson: what of it is not on its page, and why there is no page."""

    source: Path
    warnings: tuple[str, ...] = ()
    problem: str = ""


@dataclass(frozen=True)
class Neighbour:
    """A lesson as others refer to it: its number, its title as plain text, the stem of its files, and its arm, if that is one of the catalogue."""

    number: int
    title: str
    stem: str
    arm: str = ""
    suffix: str = ""

    @property
    def page(self) -> str:
        """The file of its page."""
        return f"{self.stem}{self.suffix}.html"

    @property
    def notebook(self) -> str:
        """The file of the student's notebook."""
        return f"{self.stem}{self.suffix}.ipynb"


def switches(langs: Sequence[str], lang: str, stem: str) -> list[tuple[str, str, str]]:
    """Return of each other language its code, its own name and the file of the same page."""
    return [(each, NAMES.get(each, each), f"{stem}{ending_of(each, langs)}.html") for each in langs if each != lang]
