"""The units behind numbers: what 1 cm^2, 1 deg/s or 1 ft is in metres, radians, seconds, kilograms and newtons."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import pi

from armproof.verification.patterns import regex

UNIT = "unit:"  # begins the mark above a number that says its unit
UNKNOWN = "?"  # begins a unit of which nobody knows what it is
PER_CENT = "%"

# the unit → how many of metres, radians, seconds, kilograms or newtons, times which power of π, and its power of a length
_KNOWN: dict[str, tuple[Fraction | int, int, int]] = {
    "m": (1, 0, 1), "meter": (1, 0, 1), "meters": (1, 0, 1), "metre": (1, 0, 1), "metres": (1, 0, 1), "mètres": (1, 0, 1),
    "mm": (Fraction(1, 1000), 0, 1), "cm": (Fraction(1, 100), 0, 1), "dm": (Fraction(1, 10), 0, 1), "km": (1000, 0, 1),
    "µm": (Fraction(1, 10**6), 0, 1), "μm": (Fraction(1, 10**6), 0, 1), "um": (Fraction(1, 10**6), 0, 1),
    "inch": (Fraction(254, 10000), 0, 1), "inches": (Fraction(254, 10000), 0, 1),
    "ft": (Fraction(3048, 10000), 0, 1), "foot": (Fraction(3048, 10000), 0, 1), "feet": (Fraction(3048, 10000), 0, 1),
    "rad": (1, 0, 0), "rads": (1, 0, 0), "radian": (1, 0, 0), "radians": (1, 0, 0), "mrad": (Fraction(1, 1000), 0, 0),
    "deg": (Fraction(1, 180), 1, 0), "degs": (Fraction(1, 180), 1, 0), "degree": (Fraction(1, 180), 1, 0),
    "degrees": (Fraction(1, 180), 1, 0), "°": (Fraction(1, 180), 1, 0), "Grad": (Fraction(1, 180), 1, 0),
    "degrés": (Fraction(1, 180), 1, 0), "gon": (Fraction(1, 200), 1, 0), "turn": (2, 1, 0), "turns": (2, 1, 0),
    "tours": (2, 1, 0), "rev": (2, 1, 0), "rpm": (Fraction(2, 60), 1, 0),
    "s": (1, 0, 0), "sec": (1, 0, 0), "ms": (Fraction(1, 1000), 0, 0), "min": (60, 0, 0),
    "kg": (1, 0, 0), "N": (1, 0, 0), "Nm": (1, 0, 1), "kN": (1000, 0, 0), "mN": (Fraction(1, 1000), 0, 0), "MN": (10**6, 0, 0),
    PER_CENT: (Fraction(1, 100), 0, 0),
}  # fmt: skip
_OLD_MARKS = {"deg": "\\circ", "cm": "cm", "mm": "mm"}  # that have a mark of their own above a number
_SUPERSCRIPTS = str.maketrans("²³⁴⁻¹", "234-1")
_LAYOUT = regex(r"\\(?:mathrm|text|rm)(?![A-Za-z])|[{}$]")
_JOINS = regex(r"\\(?:cdot|times)(?![A-Za-z])|\\[,;:! ]|[\s~·*⋅]+")
_PART = regex(r"([./]?)([^\W\d_]+|°|%)(?:\^?(-?\d))?")


@dataclass(frozen=True, slots=True)
class Unit:
    """How much one of a unit is: a number, times a power of π; `length` is its power of a length."""

    number: Fraction
    of_pi: int
    length: int


@cache
def read_unit(text: str) -> Unit | None:
    """Return what a product of powers and quotients of units is; None of one that is not known."""
    text = re.sub(r"[²³⁴⁻¹]+", lambda found: "^" + found.group().translate(_SUPERSCRIPTS), _LAYOUT.sub("", text))
    text = re.sub(r"\.+(?=[./^]|$)", "", _JOINS.sub(".", text.strip())).strip(".")
    number, of_pi, length, position = Fraction(1), 0, 0, 0
    while position < len(text):
        found = _PART.match(text, position)
        if found is None or found[2] not in _KNOWN or (position > 0 and not found[1]):
            return None
        power = int(found[3] or 1) * (-1 if found[1] == "/" else 1)
        one, half_turns, metres = _KNOWN[found[2]]
        number, of_pi, length = number * Fraction(one) ** power, of_pi + half_turns * power, length + metres * power
        position = found.end()
    return Unit(number, of_pi, length) if text else None


def mark_of(text: str, own: str = "") -> str:
    """Return the mark that a unit becomes above its number: none of one that changes no number, `own` that of the document.

    Where a document calculates in mm, what it gives in another length is not known.
    """
    unit = read_unit(text)
    if unit is None:
        return f"{UNIT}{UNKNOWN}{text.strip()}"
    if own and unit.length:
        scale = _KNOWN[own][0]
        return (
            "" if unit.number == Fraction(scale) ** unit.length and not unit.of_pi else f"{UNIT}{UNKNOWN}{text.strip()}"
        )
    if unit.number == 1 and not unit.of_pi:
        return ""
    old = next((mark for name, mark in _OLD_MARKS.items() if read_unit(name) == unit), "")
    return old or f"{UNIT}{text.strip()}"


def size_of(operator: str) -> float | None:
    """Return how much one of the unit is that an operator behind a number says, None of another operator."""
    unit = read_unit(operator)
    return None if unit is None else float(unit.number) * pi**unit.of_pi


def is_length(operator: str) -> bool:
    """Whether an operator is a unit of length but the metre."""
    unit = read_unit(operator)
    return unit is not None and unit.length == 1 and unit.number != 1
