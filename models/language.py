"""The language that Armproof speaks: English, or one that has catalogues (gettext's .po, a folder a language)."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from functools import cache
from gettext import GNUTranslations, NullTranslations
from io import BytesIO
from numbers import Number
from pathlib import Path

ENGLISH = "en"  # what the sources say; it needs no catalogue, and imports none
FOLDER = Path(__file__).parent / "translations"
_SPOKEN = ContextVar("spoken", default=ENGLISH)
_ASKED = ContextVar("asked", default="")


@cache
def languages() -> tuple[str, ...]:
    """Return the languages that there are: English first, then each that has a folder of catalogues."""
    return (ENGLISH, *sorted(path.parent.name for path in FOLDER.glob("*/messages.po")))


def spoken() -> str:
    """Return the language that is spoken here and now."""
    return _SPOKEN.get()


def asked() -> str:
    """Return the language that a command was asked for by `--lang`; "" where it was asked for none."""
    return _ASKED.get()


def speak(lang: str = "", spoken: str = "") -> None:
    """Speak the language that is asked for from here on, else one that is given, else that of the environment."""
    _ASKED.set(lang)
    _SPOKEN.set(lang or spoken or language_of_environment())


def of_document(front: Mapping[str, object]) -> AbstractContextManager[None]:
    """Speak the language of a document's front matter within, where no other is asked for."""
    return use(asked() or known_language(front.get("lang") or front.get("language")))


def of_programs() -> AbstractContextManager[None]:
    """Speak English within, which programs read, where no other is asked for."""
    return use(asked() or ENGLISH)


@contextmanager
def use(lang: str) -> Iterator[None]:
    """Speak a language within; "" leaves the one that is spoken."""
    before = _SPOKEN.set(lang or spoken())
    try:
        yield
    finally:
        _SPOKEN.reset(before)


def known_language(name: object) -> str:
    """Return "fr" of "fr", "fr_FR.UTF-8" or "fr-CA"; "" of a language that has no catalogues."""
    short = re.split(r"[-_.@]", str(name or ""))[0].lower()
    return short if short in languages() else ""


def language_of_environment() -> str:
    """Return the language that the environment asks for, as gettext does; English where there is no other."""
    asked = next((text for name in ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG") if (text := os.environ.get(name))), "")
    return next((lang for name in asked.split(":") if (lang := known_language(name))), ENGLISH)


@cache
def catalogue(path: Path) -> NullTranslations:
    """Return the translations of a .po file; an entry that is missing or outdated (fuzzy) stays as the source has it."""
    from babel.messages.mofile import write_mo
    from babel.messages.pofile import read_po

    compiled = BytesIO()
    with path.open("rb") as file:
        write_mo(compiled, read_po(file))
    compiled.seek(0)
    return GNUTranslations(compiled)


def look_up(sentence: str) -> str:
    """Return a sentence, or a template, in the language that is spoken."""
    return _messages(spoken()).gettext(sentence) if sentence else ""


def look_up_plural(one: str, many: str, number: int) -> str:
    """Return the template for a number of things: in French 0 takes the form of 1."""
    return _messages(spoken()).ngettext(one, many, number)


def noted(sentence: str) -> str:
    """Return a sentence as it is: it is extracted for translation here, and looked up where it is said."""
    return sentence


def noted_plural(one: str, many: str) -> tuple[str, str]:
    """Return two templates as they are, for one thing and for several: extracted here, looked up where they are said."""
    return one, many


def number_text(value: object, form: str = "") -> str:
    """Return a value, a number as the language writes it: 0.05 is 0,05 in French; the path a.tex stays as it is."""
    text = format(value, form)
    return text.translate(_signs(spoken())) if isinstance(value, Number) and spoken() != ENGLISH else text


def separator(texts: Sequence[str]) -> str:
    """Return what stands between items: semicolons, where one holds the comma of a French number."""
    return "\u00a0; " if spoken() != ENGLISH and any("," in text for text in texts) else ", "


@cache
def _messages(lang: str) -> NullTranslations:
    return catalogue(FOLDER / lang / "messages.po") if lang in languages()[1:] else NullTranslations()


@cache
def _signs(lang: str) -> dict[int, str]:
    from babel.numbers import get_decimal_symbol, get_group_symbol

    return {ord("."): get_decimal_symbol(lang), ord(","): get_group_symbol(lang)}
