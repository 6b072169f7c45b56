"""The signs of mathematics in Unicode, and the LaTeX commands that they are read as."""

from __future__ import annotations

import re

from armproof.verification.latex.greek import NAMES

COMMANDS = {
    "−": "-", "–": "-", "×": r"\times ", "·": r"\cdot ", "⋅": r"\cdot ", "±": r"\pm ", "∓": r"\mp ", "°": r"^\circ ",
    "º": r"^\circ ", "˚": r"^\circ ",  # as typed for a degree
    "√": r"\sqrt ", "∂": r"\partial ", "⇒": r"\Rightarrow ", "→": r"\to ", "⇔": r"\iff ", "≤": r"\leq ",
    "≥": r"\geq ", "≠": r"\neq ", "∈": r"\in ", "′": "'", "∧": r"\wedge ", "…": r"\dots ", "⋯": r"\cdots ",
    "\u00a0": " ", "⁼": "=", "＝": "=", "（": "(", "）": ")", "，": ",", "；": ";", "：": ":", **{character: f"\\{name} " for character, name in NAMES.items()},
}  # fmt: skip
_SIGNS = re.compile("[" + "".join(COMMANDS) + "]")


def normalise_unicode(text: str) -> str:
    """Write the Unicode signs of mathematics as their LaTeX commands."""
    return _SIGNS.sub(lambda found: COMMANDS[found.group()], text) if not text.isascii() else text


def original_offset(text: str, offset: int) -> int:
    """Return the place in `text` of a place in its normalised form."""
    position = 0
    for index, character in enumerate(text):
        if position >= offset:
            return index
        position += len(COMMANDS.get(character, character))
    return len(text)
