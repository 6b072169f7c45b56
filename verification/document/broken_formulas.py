"""A formula that its author broke over several pairs of dollars: **$P_x =$** $l_1 c_1$ + $l_2 c_{12}$, alone in its paragraph or item."""

from __future__ import annotations

from collections.abc import Sequence

from markdown_it.token import Token

from armproof.verification.patterns import regex

_EMPHASIS = frozenset(["strong_open", "strong_close", "em_open", "em_close"])
_OPERATOR = regex(r"\s*(?:[=+≈≃·×−–-])?\s*")
_GOES_ON = regex(r"(?:[=+\-≈]|\\(?:approx|simeq|equiv|cdot|times)(?![A-Za-z]))(?:\s|\\[,;:! ])*\Z")
_CONTINUES = regex(r"(?:\s|\\[,;:! ])*(?:[=+\-≈]|\\(?:approx|simeq|equiv|cdot|times)(?![A-Za-z]))")
_SIGNS = str.maketrans({"−": "-", "–": "-"})
_STOPS = " .,;，。；"


def broken_formula(children: Sequence[Token]) -> str | None:
    """Return the formula that the formulas of a paragraph make together, or None where they are several or words stand among them.

    Each goes on with the next: an operator ends it, begins the next, or stands between them. An equation and another
    one behind it, with nothing or a comma between, are two.
    """
    parts = [child for child in children if child.type not in _EMPHASIS]
    while parts and not parts[-1].content.strip(_STOPS):
        parts.pop()
    if sum(part.type == "math_inline" for part in parts) < 2:
        return None
    latex, between = "", ""
    for part in parts:
        if part.type == "math_inline" and not part.content.startswith("`"):
            if latex and not (between.strip() or _GOES_ON.search(latex) or _CONTINUES.match(part.content)):
                return None
            latex, between = f"{latex}{between} {part.content}", ""
        elif part.type == "softbreak":
            between += "\n"
        elif part.type == "text" and _OPERATOR.fullmatch(part.content) and not between.strip():
            between += part.content.translate(_SIGNS)
        else:
            return None
    return latex.strip() if not between.strip() else None
