"""Names in MathML: letters with their scripts, primes, dots and pre-scripts, out of the tree's canonical text."""

from __future__ import annotations

import unicodedata
from functools import lru_cache

from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import LONG, one_of
from armproof.verification.latex.mathml import box
from armproof.verification.latex.mathml.box import EMPTY, Box
from armproof.verification.latex.plain import LETTERS, plain_text
from armproof.verification.patterns import regex

_DOTS = {1: "˙", 2: "¨", 3: "⃛"}
_TOKEN = regex(
    r"(?P<size>(?<=\d)x(?=[\dn]))|(?P<greek>(?:%s)(?![a-z]))|(?P<word>[A-Za-z]+?(?=(?:%s)(?![a-z])|[^A-Za-z]|$))"
    r"|(?P<number>\d+(?:\.\d+)?)|(?P<below>_)|(?P<above>\^)|(?P<sign>\S)" % (one_of(LETTERS), one_of(LONG))
)
_ACCENTS = {
    "vec": "→",
    "overrightarrow": "→",
    "hat": "^",
    "widehat": "^",
    "bar": "¯",
    "overline": "¯",
    "tilde": "~",
    "widetilde": "~",
}
_BOLD = frozenset(["mathbf", "boldsymbol", "bm", "bf"])
_STYLE = regex(r"\\(%s)(?![A-Za-z])" % "|".join([*_ACCENTS, *sorted(_BOLD)]))
_STYLE_BEFORE = regex(r"\\(?:%s)[\s{]*$" % "|".join([*_ACCENTS, *sorted(_BOLD)]))
_INDICES = regex(r"[ijkmnpq]+")


def name_box(name: n.Name, above: Box = EMPTY, before: str = "") -> Box:
    """Return a name.

    Args:
        name: the name; its arrow, hat or boldface is read off its LaTeX.
        above: an exponent or an operator that stands above it beside its own script.
        before: the LaTeX before it, where its arrow may stand.
    """
    if name.base == "words":
        return box.words(plain_text(name.text))
    if name.base == "=":  # the subject of the display before, which is not printed again
        return EMPTY
    style = _STYLE_BEFORE.search(before)
    base = decorated(name.base, f"{style.group() if style else ''}{name.text}")
    if name.dots:
        base = box.over(base, _DOTS.get(name.dots, "˙" * name.dots))
    if name.primes:  # the sign is raised by itself
        base = box.row(base, Box(f'<mo lspace="0" rspace="0">{"′" * name.primes}</mo>', 0.35 * name.primes))
    sup = script_box(name.sup)
    if above.markup and sup.markup:  # (p^0_1)^T: the name's own script and what acts on it, side by side
        sup = box.row(sup, box.thin_space(), above)
    elif above.markup:
        sup = above
    sub = script_box(name.sub)
    if name.pre_sub or name.pre_sup:
        return box.prescripted(base, script_box(name.pre_sub), script_box(name.pre_sup), sub, sup)
    return box.scripted(base, sub, sup)


def decorated(base: str, latex: str) -> Box:
    """Return a letter with the arrow, hat, bar, tilde or boldface that its LaTeX gives it."""
    style, base = _STYLE.search(latex), base.rpartition(" ")[2]
    if style is None:
        return letter_box(base)
    command = style.group(1)
    if command in _ACCENTS:
        return box.over(letter_box(base), _ACCENTS[command])
    return bold(LETTERS.get(base, base)) if command in _BOLD else letter_box(base)


def bold(text: str) -> Box:
    """Return letters in boldface, which MathML has as characters of their own."""
    return box.letter("".join(unicodedata.lookup(name) if (name := _bold_name(letter)) else letter for letter in text))


def _bold_name(letter: str) -> str:
    """Return the Unicode name of a bold Latin or Greek letter; empty where there is none."""
    words = unicodedata.name(letter, "").split()
    if len(words) != 4 or words[0] not in ("LATIN", "GREEK") or words[2] != "LETTER":
        return ""
    return f"MATHEMATICAL BOLD {words[1]} {words[3].replace('LAMBDA', 'LAMDA')}"


def letter_box(base: str) -> Box:
    """Return a letter as the tree spells it: theta, l, tool."""
    return box.letter(LETTERS.get(base, base))


@lru_cache(maxsize=4096)
def script_box(text: str) -> Box:
    """Return a script, in canonical text: "i-1", "4,x", "theta_1", "tool"."""
    parts: list[Box] = []
    attach = ""
    for token in _TOKEN.finditer(text):
        kind = token.lastgroup or ""
        if kind in ("below", "above"):
            attach = kind if parts else ""
            continue
        part = _script_part(kind, token.group())
        if attach:
            base = parts.pop()
            part = box.scripted(base, part) if attach == "below" else box.scripted(base, sup=part)
            attach = ""
        parts.append(part)
    return box.row(*parts) if parts else EMPTY


def _script_part(kind: str, text: str) -> Box:
    if kind == "greek":
        return letter_box(text)
    if kind == "number":
        return box.number(text)
    if kind == "size":
        return box.mark("×")
    if kind == "word":
        if len(text) > 1 and _INDICES.fullmatch(text):  # ij: two indices, no word
            return box.row(*(box.letter(character) for character in text))
        return box.letter(LETTERS.get(text, text))
    return box.mark({"-": "−", "'": "′"}.get(text, text))
