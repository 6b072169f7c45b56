"""LaTeX as plain text, for words that hold a formula: `\\theta_1 - \\frac{\\pi}{2}` is "θ_1 − π/2"."""

from __future__ import annotations

import re
from functools import lru_cache

from armproof.verification.latex.greek import GREEK
from armproof.verification.patterns import regex

LETTERS = {**GREEK, "ell": "ℓ", "varnothing": "∅", "nabla": "∇", "infty": "∞", "top": "⊤"}
_SIGNS = {
    "cdot": "·", "times": "×", "pm": "±", "mp": "∓", "leq": "≤", "le": "≤", "geq": "≥", "ge": "≥", "neq": "≠", "ne": "≠",
    "approx": "≈", "equiv": "≡", "in": "∈", "forall": "∀", "exists": "∃", "because": "∵", "Rightarrow": "⇒", "implies": "⇒",
    "iff": "⇔", "to": "→", "dots": "…", "ldots": "…", "cdots": "⋯", "vdots": "⋮", "ddots": "⋱", "circ": "°", "prime": "′",
    "partial": "∂", "sqrt": "√", "quad": " ", "qquad": " ", "sum": "∑", "prod": "∏", "wedge": "∧", "dagger": "†",
    "dot": "˙", "ddot": "¨", "left": "", "right": "",
}  # fmt: skip
_STYLES = regex(
    r"\\(?:math[a-z]+|text[a-z]*|operatorname\*?|boldsymbol|bm|vec|mbox|hbox|displaystyle|textstyle|limits|bf|rm)(?![A-Za-z])"
)
_ENVIRONMENT = regex(r"\\(?:begin|end)\s*\{\w+\*?\}(?:\{[lcr| ]+\})?")
_FRACTION = regex(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_MACRO = regex(r"\\([A-Za-z]+)\s?")


@lru_cache(maxsize=4096)
def plain_text(latex: str) -> str:
    """Return LaTeX without its commands: nothing of it is lost to a reader but the layout."""
    text = _ENVIRONMENT.sub(" ", _STYLES.sub("", latex))
    while (found := _FRACTION.search(text)) is not None:
        above, below = (f"({part})" if re.search(r"[+\- ]", part.strip()) else part for part in found.groups())
        text = f"{text[: found.start()]}{above}/{below}{text[found.end() :]}"
    text = text.replace("\\\\", "; ").replace("&", " ")
    text = _MACRO.sub(lambda macro: LETTERS.get(macro[1]) or _SIGNS.get(macro[1], f"{macro[1]} "), text)
    text = re.sub(r"\\[,;:!> ]", " ", text)
    text = re.sub(r"[\\{}$]", "", text)
    return re.sub(r"\s+", " ", text).strip()
