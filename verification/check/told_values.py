"""Values that the text of a section gives to letters, where no arm tells which are its joints: "Numbers: a = 2 m, φ_1 = 30°"."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document import Display
from armproof.verification.document.model import Listing
from armproof.verification.patterns import regex

_VALUE = regex(r"(?P<name>\\?[A-Za-z]+(?:\s*_\s*(?:\{[^{}]*\}|\w))?(?:\s*=\s*\\?[A-Za-z]+(?:\s*_\s*(?:\{[^{}]*\}|\w))?)*)\s*=\s*(?P<value>[^=]*\d[^=]*)")  # fmt: skip


def values_in_text(displays: Sequence[Display], display: Display) -> Listing | None:
    """Return the values that the text above a display gives in its section, the last one of each letter."""
    found: dict[str, str] = {}
    for each in displays:
        if each.said and each.section == display.section:
            below = each.said[each.said_above :] if each.said_above <= len(each.said) else ()
            for name, value in (pair for text in below for pair in _values(text)):
                found[name] = value
        if each.line == display.line and each.place == display.place:
            break
    values = tuple(f"{name} = {value}" for name, value in found.items())
    return Listing(0, values, display.section, in_text=True) if values else None


def _values(text: str) -> list[tuple[str, str]]:
    """Return the letters to which an equation gives a number, with that: l_1 = l_2 = 0.3 gives it to both."""
    told = _VALUE.fullmatch(text.strip())
    return [(name.strip(), told["value"].strip()) for name in told["name"].split("=")] if told is not None else []
