"""The words that figures and sheets write, by a key: a translator finds all of them in words.toml."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

LANGUAGES = ("en", "fr")


@cache
def words() -> dict[str, dict[str, str]]:
    """Return the catalogue: of each key what it is in each language, with {placeholders} for what is put in."""
    return tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))


def say(key: str, lang: str, **values: object) -> str:
    """Return the words of a key in a language, with the values put in for its placeholders."""
    return words()[key][lang].format(**values)
