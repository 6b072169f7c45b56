"""The signs of mathematics in Unicode, and the LaTeX commands that they are read as."""

from __future__ import annotations

import unicodedata
from functools import lru_cache

from armproof.verification.latex.greek import NAMES
from armproof.verification.patterns import regex

COMMANDS = {
    "−": "-", "–": "-", "×": r"\times ", "·": r"\cdot ", "⋅": r"\cdot ", "±": r"\pm ", "∓": r"\mp ", "°": r"^\circ ",
    "º": r"^\circ ", "˚": r"^\circ ",  # as typed for a degree
    "√": r"\sqrt ", "∂": r"\partial ", "⇒": r"\Rightarrow ", "→": r"\to ", "⇔": r"\iff ", "≤": r"\leq ",
    "≥": r"\geq ", "≠": r"\neq ", "∈": r"\in ", "′": "'", "∧": r"\wedge ", "⍺": r"\alpha ", "⍵": r"\omega ", "⍴": r"\rho ",
    "∥": "‖", "…": r"\dots ", "⋯": r"\cdots ", "⋮": r"\vdots ", "⋱": r"\ddots ",
    "\u00a0": " ", "⁼": "=", "＝": "=", "（": "(", "）": ")", "，": ",", "；": ";", "：": ":", **{character: f"\\{name} " for character, name in NAMES.items()},
}  # fmt: skip
_UNSEEN = "\u2061\u2062\u2063\u200b\u200c\u200d\u2060\ufeff"  # a function applied, a product, no width at all
_STYLED = (*map(chr, range(0x1D400, 0x1D800)), "ℎ")  # letters and digits as word processors write formulas: 𝑇, 𝜃, 𝟏
COMMANDS |= dict.fromkeys(_UNSEEN, "")
COMMANDS |= {
    styled: COMMANDS.get(letter, letter)
    for styled in _STYLED
    if (letter := unicodedata.normalize("NFKC", styled)) != styled
}
COMMANDS |= {"∅": r"\varnothing ", "∇": r"\nabla ", "⌀": r"\varnothing ", "⊖": r"\ominus ", "⊕": r"\oplus "}
_GREEK = "".join(NAMES)
_BELOW = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₐₑᵢⱼₖₗₘₙₚᵣₛₜₓ", "0123456789+-aeijklmnprstx", strict=True))
_ABOVE = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁱⁿᵀᵗ", "0123456789+-inTt", strict=True))
_SCRIPTS = regex(f"(?P<below>[{''.join(_BELOW)}]+)|(?P<above>[{''.join(_ABOVE)}]+)")
_INDEXED = regex(f"[{_GREEK.replace('π', '')}](?=\\d)")
_MARKS = {"\u0307": r"\dot", "\u0308": r"\ddot", "\u0302": r"\hat", "\u20d7": r"\vec"}
_MARKED = regex(  # θ̇, q̈; in a word, two points and a hat are those of its letter: für
    rf"(?:[A-Za-z{_GREEK}](?=[\u0307\u20d7])|(?:[{_GREEK}]|(?<![A-Za-z])[A-Za-z](?=.(?![A-Za-z])))(?=[\u0308\u0302]))(?P<mark>.)"
)
COMMANDS |= {
    letter: f"{_MARKS[apart[1]]}{{{apart[0]}}}"
    for letter in map(chr, range(0xC0, 0x1F00))
    if (apart := unicodedata.normalize("NFD", letter))[1:] == "\u0307" or letter in "ẍẅ"
    if apart[0].isascii()
}
_BEHIND_A_COMMAND = regex(rf"(?<=[A-Za-z])[{''.join(_STYLED)}]")  # \cdot𝑙: no letter of the command's name


@lru_cache(maxsize=4_096)  # a display is asked for at every turn of its way
def normalise_unicode(text: str) -> str:
    """Write the Unicode signs of mathematics as their LaTeX commands."""
    return text if text.isascii() else "".join(_written(text))


def original_offset(text: str, offset: int) -> int:
    """Return the place in `text` of a place in its normalised form."""
    position = 0
    for index, written in enumerate(_written(text)):
        if position >= offset:
            return index
        position += len(written)
    return len(text)


def _written(text: str) -> list[str]:
    """Return what each character is written as."""
    apart = {found.start() for found in _BEHIND_A_COMMAND.finditer(text)}
    written = [_command(character, index in apart) for index, character in enumerate(text)]
    for found in _MARKED.finditer(text):
        written[found.start()] = f"{_MARKS[found['mark']]}{{{written[found.start()]}}}"
        written[found.start("mark")] = ""
    for run in _INDEXED.finditer(text):  # θ1 is \theta1, an index and no factor
        written[run.start()] = written[run.start()].rstrip()
    for run in _SCRIPTS.finditer(text):  # θ₁₂, J⁻¹
        written[run.start() : run.end()] = [(_BELOW if run["below"] else _ABOVE)[character] for character in run[0]]
        written[run.start()] = ("_{" if run["below"] else "^{") + written[run.start()]
        written[run.end() - 1] += "}"
    return written


def _command(character: str, is_apart: bool) -> str:
    command = COMMANDS.get(character, character)
    return f" {command}" if is_apart and command != character and not command.startswith("\\") else command
