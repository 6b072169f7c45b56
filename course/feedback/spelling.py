"""How a formula is spelt in a text: several of them with commas between, small digits of Unicode, decimal commas."""

from __future__ import annotations

import re
from typing import Any

from armproof.models.dh.entry import as_typed
from armproof.verification.latex.greek import NAMES

_ABOVE = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_POWERS = re.compile("⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_BELOW = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_INDICES = re.compile("[₀₁₂₃₄₅₆₇₈₉]+")
_BEHIND_GREEK = re.compile(r"(?<=[α-ωϑϕ])\d+")
_FRACTIONS = re.compile(r"(?<=[{/*(])(\d+),(\d+)(?=[}/*)])")  # \frac{0,5}{2}
_FIRST = re.compile(r"^\s*(\d+),(\d+)(?=\s*[*/\\a-zA-Z(])")  # 1,875 (q_f - q_0)
_SYSTEM = re.compile(r"^\s*\\begin\{(aligned|align|cases|gathered|split)\*?\}(.*)\\end\{\1\*?\}\s*$", re.DOTALL)
_OPEN, _CLOSE = "([{", ")]}"


def with_powers(text: str) -> str:
    """Return a text with the small digits of Unicode as indices and powers: a₁² as a_1^2."""
    text = _INDICES.sub(lambda found: "_" + _bracketed(found.group().translate(_BELOW)), text)
    return _POWERS.sub(lambda found: "^" + _bracketed(found.group().translate(_ABOVE)), text)


def with_indices(text: str) -> str:
    """Return a text with the digits behind a Greek letter as its index: θ2 as θ_2, θ12 as θ_{12}."""
    return _BEHIND_GREEK.sub(lambda found: "_" + _bracketed(found.group()), text)


def as_entry(cell: Any) -> Any:
    """Return an entry of a table as it is typed, a text in Greek letters, small digits or LaTeX: θ₁ as theta_1; a number as it is."""
    if not isinstance(cell, str):
        return cell
    return as_typed("".join(NAMES.get(character, character) for character in with_powers(cell)))


def _bracketed(digits: str) -> str:
    return digits if len(digits) == 1 else f"{{{digits}}}"


def with_decimal_points(text: str) -> str:
    """Return a text with a point for the decimal comma of a factor in front, or alone above or below a line."""
    return _FIRST.sub(r"\1.\2", _FRACTIONS.sub(r"\1.\2", text))


def parts_of(text: str) -> list[str] | None:
    """Return the formulas of a text that holds several, "X = a, Y = b" or a system of equations; None where it is one."""
    if (system := _SYSTEM.match(text)) is not None:
        parts = [line.replace("&", "") for line in re.split(r"\\\\(?:\[\w+\])?", system.group(2))]
        parts = [part.strip(" ,;.\n") for part in parts if part.strip(" ,;.\n")]
    else:
        parts = _apart(text)
    return parts if len(parts) > 1 and all(part.strip() for part in parts) else None


def _apart(text: str) -> list[str]:
    """Split a text at the commas and semicolons that stand in no brackets, and are no spaces of LaTeX."""
    depth, start, parts = 0, 0, []
    for place, character in enumerate(text):
        depth += (character in _OPEN) - (character in _CLOSE)
        if character in ",;" and depth == 0 and text[place - 1 : place] != "\\":
            parts.append(text[start:place])
            start = place + 1
    return [*parts, text[start:]]
