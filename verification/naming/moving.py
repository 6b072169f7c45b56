"""Letters that move: those whose rates a document prints, and their order."""

from __future__ import annotations

from collections.abc import Iterable

from armproof.verification.document import Display
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex

FIRST_LETTERS = ("alpha", "beta", "gamma", "delta")
_INDEX = regex(r"\d+")
_RATE = regex(r"\\d{1,2}ot\s*\{?\s*\\?([A-Za-z]+)\s*\}?(?:\s*_\s*(?:\{\s*(\w+)\s*\}|(\w)))?")


def index_of(letter: str) -> int:
    """Return the number of a joint by its letter, 0 where it has none."""
    return int(found[0]) if (found := _INDEX.search(letter)) else 0


def place_of(letter: str) -> tuple[int, int, str]:
    """Return where a letter stands among its like: by its number, else in the Greek alphabet, else by its name."""
    return index_of(letter), FIRST_LETTERS.index(letter) if letter in FIRST_LETTERS else 0, letter


def rates_in(displays: Iterable[Display]) -> set[str]:
    r"""Return the letters, as keys, whose rates stand in displays: d_2 of \dot{d}_2, theta_1 of \dot\theta_1."""
    texts = (normalise_unicode(each.latex) for each in displays if not (each.erratum or each.denied))
    found = (match for text in texts for match in _RATE.findall(text))
    return {f"{base}_{braced or index}" if braced or index else base for base, braced, index in found}
