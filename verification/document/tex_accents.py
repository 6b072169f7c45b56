r"""The letters that LaTeX sets by commands: F\"ur is "Für", \'etape is "étape", na\"\i f is "naïf"."""

from __future__ import annotations

import re
import unicodedata

from armproof.verification.patterns import regex

_COMBINING = {"`": "\u0300", "'": "\u0301", "^": "\u0302", "~": "\u0303", '"': "\u0308", "c": "\u0327"}
_ACCENT = regex(
    r"(?<!\\)(?P<open>\{)?(?:\\(?P<mark>[`'^~\"])\s*(?:\{\\?(?P<braced>[A-Za-z])\s*\}|\\(?P<dotless>[ij])(?![A-Za-z])(?:\{\}|\s)?|(?P<bare>[A-Za-z]))"
    r"|\\(?P<hook>c)\s*\{(?P<hooked>[cC])\})(?(open)\})"
)
_SHARP_S = regex(r"\{\\ss\s*(?:\{\})?\}|\\ss(?:\{\}|\s+|(?![A-Za-z]))")


def with_letters(text: str) -> str:
    """Return the words of a text with their letters: what is heard in "für" is heard in f\\"ur."""
    if "\\" not in text:
        return text
    return _SHARP_S.sub("ß", _ACCENT.sub(_letter, text))


def _letter(found: re.Match[str]) -> str:
    letter = found["braced"] or found["dotless"] or found["bare"] or found["hooked"]
    return unicodedata.normalize("NFC", letter + _COMBINING[found["mark"] or found["hook"]])
