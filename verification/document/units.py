"""What the text behind a formula adds to it: "$\\theta_1 = 30$ degrees", "$l_1$ = 250 mm"."""

from __future__ import annotations

import re

_SPACE = r"(?:[\s~]|\\[,; ])*"
_DEGREES = r"°|º|\\(?:text)?degree\b|deg\b|degrees?\b|degrés?\b|grados?\b|graus?\b|Grad\b"
_UNIT = re.compile(rf"{_SPACE}(?:(?P<degrees>{_DEGREES})(?! (?:of|de|von) )|(?P<length>[mc]m)\b)")
_VALUE = re.compile(rf"{_SPACE}={_SPACE}(-?\d+(?:[.,]\d+)?)")
_NAME = re.compile(r"\s*\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?\s*")


def with_unit(latex: str, behind: str) -> str:
    """Return a formula with the value of its name, and the degrees or millimetres of its number, that stand in the text behind it."""
    if _NAME.fullmatch(latex) and (value := _VALUE.match(behind)) is not None:
        latex, behind = f"{latex} = {value[1]}", behind[value.end() :]
    unit = _UNIT.match(behind) if latex.rstrip()[-1:].isdigit() and "=" in latex else None
    if unit is None:
        return latex
    return rf"{latex}^\circ" if unit["degrees"] else rf"{latex}\,\text{{{unit['length']}}}"
