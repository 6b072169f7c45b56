"""What the text behind a formula adds to it: "$\\theta_1 = 30$ degrees", "$l_1$ = 250 mm"."""

from __future__ import annotations

import re

from armproof.verification.patterns import regex

MOST_BEHIND = 160  # characters behind a formula that may hold its unit
_SPACE = r"(?:[\s~]|\\[,; ])*"
_DEGREES = r"°|º|\\(?:text)?degree\b|deg\b|degrees?\b|degrés?\b|grados?\b|graus?\b|Grad\b"
_IN_UNIT = r"[(,]?[ ~]?(?:(?:both|all|each|given|tous|toutes|tous deux|les deux|beide|ambos) )?(?:in|en|em) "
_UNIT = regex(
    rf"{_SPACE}(?:(?P<degrees>(?:{_DEGREES})(?! (?:of|de|von) )|{_IN_UNIT}(?:{_DEGREES})(?=\s*(?:[).,;:]|\Z)))|(?P<length>[mc]m)\b)"
)
_LETTERS = {  # what has a unit with others behind it, "$\\theta_1 = 30$ and $\\theta_2 = 60$ degrees"
    "degrees": r"\\(?:var)?(?:theta|phi|psi|alpha|beta|gamma)",
    "length": r"(?:[lLaAdrh]|\\ell)",
}
_INDEX = r"(?:\s*_\s*(?:\w|\{\w+\}))?"
_NUMBER = rf"{_SPACE}={_SPACE}-?\d+(?:[.,]\d+)?"
_AND = rf"{_SPACE}(?:, ?)?(?:(?:and|et|und|y|e) )?"
_VALUE = regex(rf"{_SPACE}={_SPACE}(-?\d+(?:[.,]\d+)?)")
_NAME = regex(r"\s*\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?\s*")


def with_unit(latex: str, behind: str) -> str:
    """Return a formula with the value of its name, and the degrees or millimetres of its number, that stand in the text behind it."""
    if _NAME.fullmatch(latex) and (value := _VALUE.match(behind)) is not None:
        latex, behind = f"{latex} = {value[1]}", behind[value.end() :]
    unit = (_UNIT.match(behind) or _shared(latex, behind)) if latex.rstrip()[-1:].isdigit() and "=" in latex else None
    if unit is None:
        return latex
    return rf"{latex}^\circ" if unit["degrees"] else rf"{latex}\,\text{{{unit['length']}}}"


def _shared(latex: str, behind: str) -> re.Match[str] | None:
    """Return the unit that stands behind the last of several values alike, of angles or of lengths."""
    for kind, letter in _LETTERS.items():
        value = rf"{_SPACE}{letter}{_INDEX}{_NUMBER}{_SPACE}"
        shown = rf"(?:\$(?:{value})\$|\\\((?:{value})\\\)|:math:`(?:{value})`)"
        others = re.compile(rf"(?:{_AND}{shown})+(?={_UNIT.pattern})")
        found = others.match(behind) if re.fullmatch(value, latex) else None
        unit = _UNIT.match(behind, found.end()) if found is not None else None
        if unit is not None and unit[kind]:
            return unit
    return None
