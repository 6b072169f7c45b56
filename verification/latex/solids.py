r"""The notation of the kinematics of solids, as French courses write it, made plain, every character at its place.

\vec V(B, 2/0) and \overrightarrow{V_{B \in S_2/R_0}} become V_{B,2/0}, the velocity of a point of one solid seen from another,
\vec\Omega(2/0) becomes \Omega_{2/0}; an index comes out from under its arrow; d/dt seen from R_0 is that of components in the base.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from armproof.verification.patterns import regex

ARROWS = frozenset(["vec", "overrightarrow", "vect", "vecteur", "vv"])
_ARROW = rf"\\(?:{'|'.join(sorted(ARROWS))})(?![A-Za-z])"
_LETTER = r"[A-Z]|[xyzijkuvw]|\\Omega|\\omega|\\Gamma"
_BELOW = r"_\s*(?:\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\w)"
_IN_ARROW = regex(
    rf"(?P<arrow>{_ARROW}\s*\{{)\s*(?P<letter>{_LETTER})\s*(?P<tail>{_BELOW}|(?:\\left\s*)?\([^()]*\))\s*\}}"
)
_FRAME = r"(?:\\(?:mathcal|mathrm|mathscr|text|cal|rm)(?![A-Za-z])\s*\{?\s*)?(?:[SR]\s*\}?\s*_?\s*)?"
_SOLID = rf"\(?\s*{_FRAME}\{{?\s*(\d)\s*\}}?\s*\)?"
_SOLIDS = regex(rf"\s*{_SOLID}\s*/\s*{_SOLID}\s*")
_OF_POINT = regex(
    rf"\s*([A-Z])(?:\s*_\s*\{{?\s*(\w)\s*\}}?)?\s*(?:(?:,|\\in(?![A-Za-z])|\\[,;!]|\s)+{_SOLID}\s*/\s*{_SOLID}|/\s*{_SOLID})\s*"
)
_VECTORS = r"[Va]|\\Omega|\\omega|\\Gamma"
_VECTOR = regex(
    rf"(?P<head>{_ARROW}\s*(?:\{{\s*(?:{_VECTORS})\s*\}}|(?:{_VECTORS})(?![A-Za-z])))\s*"
    r"(?:(?:\\left|\\[bB]ig+l?)?\s*\((?P<in>(?:[^()]|\([^()]*\))*?)(?:\\right|\\[bB]ig+r?)?\s*\)|_\s*\{(?P<below>(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\})"
)
_NUMBERED = regex(  # as they are written once they are plain
    r"(?:V|\\Omega|\\omega)\s*\}?\s*_\{(?:[A-Z](?:_\w)?(?:,(\d))?|(\d))/(\d)\}"
)
_AXIS = rf"{_ARROW}\s*\{{?\s*[xyzijk]\s*\}}?\s*_\s*\{{?\s*(\d)\s*\}}?"
_BETWEEN_AXES = regex(rf"\(\s*{_AXIS}\s*,(?:\s|\\[,;!])*{_AXIS}\s*(?:\\right\s*)?\)")  # (\vec x_0, \vec x_1)
_POINT = r"\(?\s*(?P<{}>[A-Z](?:_\{{?\w\}}?)?)\s*(?:,[^{{}}]*(?:\{{[^{{}}]*\}}[^{{}}]*)*)?\)?"
_TORSOR = regex(  # \{V_{2/0}\} = \{\begin{matrix} … \end{matrix}\}_B, one vector above the other
    r"(?P<name>(?:\\left\s*)?\\\{\s*\\(?:mathcal|mathscr|mathbb|cal)(?![A-Za-z])\s*\{?\s*V\s*\}?\s*(?:_\s*\{(?P<below>[^{}]*(?:\{[^{}]*\}[^{}]*)*)\}|\((?P<in>[^()]*)\))"
    r"\s*(?:\\right\s*)?\\\}(?:_\s*\{?\s*(?P<own>[A-Z](?:_\w)?)\s*\}?)?)(?P<equal>\s*&?\s*=\s*&?\s*)(?P<open>(?:\\left\s*)?\\\{\s*)?(?P<matrix>\\begin\s*\{(?P<kind>B?matrix|array)\}"
    rf"[^&]*?\\end\s*\{{(?P=kind)\}})(?P<close>\s*(?:\\right\s*)?\\\}})?(?P<point>\s*_\s*(?:\{{{_POINT.format('braced')}\}}|(?P<bare>[A-Z](?![A-Za-z]))))"
)
_PRINTED = regex(r"\\end\s*\{(?:B?matrix|array)\}")
_OF_BASE = r"_\s*(?:\{\s*(?:/|t\s*,)?\s*(?:\(?\\?(?:mathcal|mathrm|text)?\s*\{?\s*[RB]\s*\}?\s*_?\s*\{?\s*0\s*\}?\)?|0)\s*\}|0|R_0)"
_QUOTIENT = r"\\d?frac\s*\{(?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*\}\s*\{(?:[^{}]|\{[^{}]*\})*(?<![A-Za-ce-z])t\s*\}"
_SEEN_FROM_BASE = regex(
    rf"(?P<open>\\left\s*(?:\.|\[|\()|\[|\()?(?P<rate>\s*{_QUOTIENT}\s*(?:{_ARROW}\s*\{{[^{{}}]*\}})?\s*)"
    rf"(?P<close>\\right\s*(?:\||\]|\)|\\vert|\\rvert)|\\[bB]igg?r?\s*(?:\||\\vert)|\||\\vert|\]|\))\s*(?P<seen>{_OF_BASE})"
)


def with_solids(text: str) -> str:
    """Return a display with velocities and rotations of solids as names with an index, as long as it was."""
    if "\\" not in text or ("/" not in text and "_" not in text):
        return text
    text = _IN_ARROW.sub(_out_of_arrow, text)
    if "/" in text:
        text = _VECTOR.sub(_indexed, text)
        text = (
            _TORSOR.sub(_stacked, text) if len(_PRINTED.findall(text)) == 1 else text
        )  # of two, at two points perhaps
    return _SEEN_FROM_BASE.sub(_rate, text) if "frac" in text else text


def first_solid(texts: Iterable[str]) -> str:
    """Return the smallest number that texts give a solid in a velocity or an angle between axes, "" where they number none."""
    plain = [with_solids(text) for text in texts]
    found = (match for text in plain for pattern in (_NUMBERED, _BETWEEN_AXES) for match in pattern.finditer(text))
    return min((number for match in found for number in match.groups() if number), default="")


def _out_of_arrow(found: re.Match[str]) -> str:
    return f"{found['arrow']}{found['letter']}}}{found['tail']}".ljust(len(found.group()))


def _indexed(found: re.Match[str]) -> str:
    """Return V_{B,2/0} for V(B, 2/0); what names no solids stays as it is."""
    arguments = found["in"] if found["in"] is not None else found["below"]
    letter = re.search(rf"(?:{_VECTORS})(?=[\s}}]*$)", found["head"])
    assert letter is not None
    pattern = _SOLIDS if letter[0] in ("\\Omega", "\\omega") else _OF_POINT
    told = pattern.fullmatch(arguments)
    if told is None:
        return found.group()
    if pattern is _SOLIDS:
        index = f"{told[1]}/{told[2]}"
    else:
        point = told[1] + (f"_{told[2]}" if told[2] else "")
        index = f"{point},{told[3]}/{told[4]}" if told[3] else f"{point}/{told[5]}"
    whole = len(found.group())
    spelt = (f"{found['head']}_{{{index}}}", f"{letter[0]}_{{{index}}}")
    return next((each.ljust(whole) for each in spelt if len(each) <= whole), found.group())


def _stacked(found: re.Match[str]) -> str:
    """Return V_{t,B,2/0} = the matrix of a torsor that is written with its point."""
    told = _SOLIDS.fullmatch(found["in"] if found["in"] is not None else found["below"])
    is_fenced = bool(found["open"]) and bool(found["close"])
    if told is None or (found["kind"] != "Bmatrix" and not is_fenced) or bool(found["open"]) != bool(found["close"]):
        return found.group()
    point = re.sub(r"[{}\s]", "", found["bare"] or found["braced"])
    if found["own"] and found["own"] != point:
        return found.group()
    name = f"V_{{t,{point},{told[1]}/{told[2]}}}"
    if len(name) > len(found["name"]):
        return found.group()
    blank = [" " * len(found[group] or "") for group in ("open", "close", "point")]
    return f"{name.ljust(len(found['name']))}{found['equal']}{blank[0]}{found['matrix']}{blank[1]}{blank[2]}"


def _rate(found: re.Match[str]) -> str:
    """Return the rate without what says that it is seen from the base, in parentheses as long as those were."""
    if bool(found["open"]) != (found["close"].endswith(("]", ")")) or found["close"].startswith("\\right")):
        return found.group()
    opened = "(".rjust(len(found["open"])) if found["open"] else ""
    closed = ")" if found["open"] else ""
    return f"{opened}{found['rate']}{closed}".ljust(len(found.group()))
