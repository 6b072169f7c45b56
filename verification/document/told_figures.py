r"""What a text tells of a figure in its formulas: "$\overrightarrow{OA} = l_1 \vec x_1$", "$\theta_1 = (\vec x_0, \vec x_1)$"."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import formulas_of
from armproof.verification.patterns import regex

MAY_TELL_FIGURE = regex(r"\\(?:vec|overrightarrow|vect)(?![A-Za-z])")
_ARROWS = MAY_TELL_FIGURE
_TAKEN_BACK = regex(
    r"\b(?:pas|jamais|faux|fausses?|erreurs?|erronée?s?|incorrecte?s?|si|supposons|supposant|wrong|false|not|never|if|suppose|error|mistake)\b|n['’]",
    re.IGNORECASE,
)


def told_formulas(sentence: str) -> Iterator[str]:
    """Yield the formulas of a sentence that tell a vector or an angle between axes; nothing of one that denies or supposes."""
    words = re.sub(r"\$[^$]*\$|\\\(.*?\\\)", " ", sentence)
    if not _TAKEN_BACK.search(words):
        yield from (each for each in formulas_of(sentence) if "=" in each and _ARROWS.search(each))
