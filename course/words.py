"""The words that figures and sheets write, by a key of words.toml, in the language that is asked for or spoken."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from armproof.models.language import look_up, use


@cache
def words() -> dict[str, str]:
    """Return what each key says in English, with {placeholders} for what is put in."""
    return tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))


def say(key: str, lang: str = "", **values: object) -> str:
    """Return the words of a key in a language, with the values put in for its placeholders."""
    with use(lang):
        return look_up(words()[key]).format(**values)
