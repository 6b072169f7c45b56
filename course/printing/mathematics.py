"""The mathematics of a sheet in Typst, out of the MathML that the checked tree is written in.

The tree has one printed form, that of verification/latex/mathml, which is well-formed and uses a dozen elements. Here
these are given to Typst: an HTML sheet and a PDF sheet show the same formula, and both show what was checked.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable
from xml.etree import ElementTree

_ACCENTS = {"˙": "dot", "¨": "dot.double", "⃛": "dot.triple", "→": "arrow", "^": "hat", "¯": "macron", "~": "tilde"}
_PLAIN = frozenset("+=<>*")  # of ASCII; all other punctuation is escaped
_RELATIONS = frozenset("=≈≤≥≠∈⇒⇔⇐")
_SPACED = _RELATIONS | frozenset("+−×⋅±∓∧")
_MARKS = ("wrong", "right")


def typst_mathematics(markup: str) -> str:
    """Return the inside of a Typst equation for the inside of a <math> element.

    Raises:
        ValueError: the markup is not well-formed, or has an element that the tree is never written in.
    """
    try:
        root = ElementTree.fromstring(f"<math>{markup}</math>")
    except ElementTree.ParseError as error:
        raise ValueError(f"not well-formed MathML: {error}") from None
    return _all(root)


def _all(elements: Iterable[ElementTree.Element]) -> str:
    """Return elements side by side.

    A blank stands only where two would be read as one, since beside words it would be printed, and where it is to be
    printed: between a sign and brackets that are drawn, which Typst sets no space around.
    """
    written, before = "", ""
    for part in _parts(elements):
        joint = written[-1:] + part[:1]
        together = len(joint) == 2 and (joint.isalnum() or not joint.strip("".join(_PLAIN)))
        after_sign = before in _SPACED and (written != before or before in _RELATIONS) and _is_drawn(part)
        apart = after_sign or (part in _SPACED and _is_drawn(before))
        written += f" {part}" if together or apart else part
        before = part
    return written


def _is_drawn(part: str) -> bool:
    return part.startswith(("fenced(", "attach(fenced(", "braced(", "attach(limits(braced("))


def _parts(elements: Iterable[ElementTree.Element]) -> list[str]:
    """Return elements one by one, a letter with the primes after it as one."""
    parts: list[str] = []
    for element in elements:
        text = element.text or ""
        if parts and element.tag == "mo" and text and not text.strip("′"):
            parts[-1] = f"attach({parts[-1]}, t: {' '.join(['prime'] * len(text))})"
        else:
            parts.append(_one(element))
    return parts


def _one(element: ElementTree.Element) -> str:
    write = _WRITERS.get(element.tag)
    if write is None:
        raise ValueError(f"no <{element.tag}> is known; the elements are {', '.join(_WRITERS)}")
    return _marked(element, write(element))


def _marked(element: ElementTree.Element, written: str) -> str:
    kind = element.get("class", "")
    return f"{kind}Part({written})" if kind in _MARKS and written else written


# -- letters, numbers and signs ----------------------------------------------------------------------------------------


def _identifier(element: ElementTree.Element) -> str:
    text = element.text or ""
    plain = unicodedata.normalize("NFKC", text)
    if plain != text and "BOLD" in unicodedata.name(text[0], ""):
        return f"bold(upright({quoted(plain)}))"
    if len(text) == 1 and text.isalpha():
        return f"upright({text})" if element.get("mathvariant") == "normal" else text
    return f"upright({quoted(text)})"


def _sign(element: ElementTree.Element) -> str:
    return " ".join(_character(character) for character in element.text or "")


def _character(character: str) -> str:
    if character == "′":
        return "prime"
    if character.isalnum() and character.isascii():
        return quoted(character)
    return f"\\{character}" if character.isascii() and character not in _PLAIN and character != " " else character


def quoted(text: str) -> str:
    """Return a text as a string of Typst: nothing in it is markup."""
    inside = "".join(" " if unicodedata.category(c) == "Cc" else c for c in text)
    return '"' + inside.replace("\\", "\\\\").replace('"', '\\"') + '"'


# -- what has parts ----------------------------------------------------------------------------------------------------


def _row(element: ElementTree.Element) -> str:
    """Return what stands side by side; around a table, brackets are drawn by the template."""
    children = list(element)
    fences = [child for child in (children[0], children[-1]) if child.get("fence")] if children else []
    if not fences:
        return _all(children)
    if element.find(".//mtable") is None:
        return f"lr({_all(children)})"
    opening, closing = (
        quoted(child.text or "") if child.get("fence") else '""' for child in (children[0], children[-1])
    )
    inside = [child for child in children if child not in fences]
    return f"fenced(#{opening}, #{closing}, {_all(inside)})"


def _attached(base: str, **scripts: str) -> str:
    primed = re.fullmatch(r"attach\((\w+), t: (prime(?: prime)*)\)", base)
    if primed is not None:  # a letter, its primes and its scripts in one, so that they stand above each other
        base = primed.group(1)
        scripts["t"] = f"{primed.group(2)} {scripts.get('t', '')}".rstrip()
    filled = ", ".join(f"{place}: {script}" for place, script in scripts.items() if script)
    return f"attach({base or quoted('')}, {filled})" if filled else base


def _scripted(element: ElementTree.Element) -> str:
    """Return a base with the scripts below or above it that the element is named after."""
    base, *scripts = map(_one, element)
    base = f"limits({base})" if element.tag == "munderover" else base
    return _attached(base, **dict(zip("t" if element.tag == "msup" else "bt", scripts, strict=False)))


def _scripts(element: ElementTree.Element) -> str:
    base, below, above, _, before_below, before_above = (
        "" if child.tag == "mprescripts" else _one(child) for child in element
    )
    return _attached(base, tl=before_above, bl=before_below, t=above, b=below)


def _fraction(element: ElementTree.Element) -> str:
    above, below = map(_one, element)
    return f"frac({above or quoted('')}, {below or quoted('')})"


def _over(element: ElementTree.Element) -> str:
    base, above = element
    if element.get("accent") == "true":
        return f"accent({_one(base)}, {_ACCENTS.get(above.text or '', 'dot')})"
    if above.text == "⏞":
        return f"braced(#top, {_one(base)})"
    return _attached(f"limits({_one(base)})", t=_one(above))


def _under(element: ElementTree.Element) -> str:
    base, below = element
    if below.text == "⏟":
        return f"braced(#bottom, {_one(base)})"
    return _attached(f"limits({_one(base)})", b=_one(below))


def _table(element: ElementTree.Element) -> str:
    rows = "; ".join(", ".join(_entry(cell, len(row)) for cell in row) for row in element)
    return f"grid{'Lines' if element.get('class') == 'left' else 'Cells'}({rows})"


def _entry(cell: ElementTree.Element, columns: int) -> str:
    """Return a cell; a fraction in a narrow matrix has room to be read."""
    size = "display" if columns < 3 and cell.find(".//mfrac") is not None else "inline"
    return f"{size}({_one(cell) or quoted('')})"


_WRITERS: dict[str, Callable[[ElementTree.Element], str]] = {
    "mi": _identifier,
    "mn": lambda element: quoted(element.text or ""),
    "mo": _sign,
    "mtext": lambda element: quoted((element.text or "").replace("\u2002", " ")),
    "mspace": lambda element: "thin" if element.get("width") == "0.17em" else "med med",
    "mrow": _row,
    "mmultiscripts": _scripts,
    "mfrac": _fraction,
    "msqrt": lambda element: f"sqrt({_all(element)})",
    "mover": _over,
    "munder": _under,
    "mtable": _table,
    "mtd": _all,
    **dict.fromkeys(("msub", "msup", "msubsup", "munderover"), _scripted),
}
