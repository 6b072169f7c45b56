r"""Sentences of a letter that are not understood: "A camera watches the elbow and delivers $x$ and $y$".

What a sentence in unknown words says of a letter, it may say of all displays of its section behind it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import formulas_of
from armproof.verification.document.sentences import not_known_in
from armproof.verification.document.vocabulary import LOADED, OF_NO_LETTER
from armproof.verification.patterns import regex

STRANGE_LETTER = "letter in strange words"  # the letter, and the sentence
_LETTER = regex(r"\s*(?:\\(?:d?dot|mathbf|boldsymbol|vec|bm|mathrm)\b\s*\{?\s*)*(?:\\?[A-Za-z]+)(?:\s*_\s*\{?\s*\w+\s*\}?)?\s*\}*\s*")  # fmt: skip
_NO_SENTENCE = regex(r"^[ \t]*\||\bErratum\b|\\(?:documentclass|usepackage|begin\s*\{tabular)", re.MULTILINE)
_FEWEST = 2
_OF_NO_LETTER = frozenset((LOADED + OF_NO_LETTER).split())


def strange_letters(sentence: str) -> Iterator[str]:
    """Yield the letters that stand alone in a sentence of which two words or more are not known: one alone is of the subject, mostly."""
    if sentence.rstrip().endswith(":"):
        return  # it leads to a display, and is heard there
    letters = [each for each in formulas_of(sentence) if _LETTER.fullmatch(each)]
    if not letters or _NO_SENTENCE.search(sentence) is not None:
        return
    if len({*map(str.lower, not_known_in(sentence))} - _OF_NO_LETTER) >= _FEWEST:
        yield from ("\t".join((STRANGE_LETTER, each.strip(), " ".join(sentence.split()))) for each in letters)
