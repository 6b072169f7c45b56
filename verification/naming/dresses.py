r"""Letters that a document has in two dresses, D and \mathcal D, e and \mathbf e, J and \hat J, d and d^*: they are two names there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.latex.greek import VARIANTS
from armproof.verification.latex.indexed import STARRED, TRANSFORM_LETTERS, VECTOR_LETTERS
from armproof.verification.latex.tokens import canonical_script
from armproof.verification.latex.vocabulary import DRESSES
from armproof.verification.patterns import regex

_SCRIPT_LETTERS = ("cal", "frak")  # nobody means by them what the plain letter is beside them
_MATRICES = TRANSFORM_LETTERS | {"J"}  # estimated under a hat; a unit vector has its hat or none
_WHOLE = VECTOR_LETTERS | _MATRICES | {"q", "theta", "Theta"}  # bold as vectors, plain with an index
_LETTER = r"(?:\\[A-Za-z]+|(?<![A-Za-z\\])[A-Za-z])(?![A-Za-z])"
_DRESS = r"\\(%s)(?![A-Za-z])[\s{]*" % "|".join(DRESSES)
_SUB = r"\s*_\s*(\{[^{}]*\}|\w)"
_STAR = r"\s*\^\s*\{?\s*(?:\*|\\ast|\\star)(?![A-Za-z])\s*\}?"
_WORDS = regex(r"\\(?:text\w*|begin|end|mbox|operatorname)\s*\{[^{}]*\}")
_DRESSED = regex(rf"{_DRESS}({_LETTER})")
_HEAD = regex(rf"(?:^|[,;&\n]|\\\\|quad)\s*(?:{_DRESS})?({_LETTER})[\s}}]*(?:{_SUB})?\s*&?\s*:?=\s*([^=,;&\n]*)")
_NAME = regex(rf"({_LETTER})[\s}}]*(?:{_SUB})?({_STAR})?(?:{_SUB})?")
_STARRED_HEAD = regex(
    rf"(?:^|[,;&=\n]|\\\\|quad)\s*({_LETTER})[\s}}]*(?:{_SUB})?{_STAR}(?:{_SUB})?\s*&?\s*:?=\s*([^=,;&\n]*)"
)
_NO_LETTER = regex(r"\\[A-Za-z]+|(?<![A-Za-z])(?:cm|mm|m|rad|deg)(?![A-Za-z])")


def dressed_letters(texts: Sequence[str]) -> frozenset[str]:
    """Return the letters whose dress tells them from the plain one, as cal D: a script letter or an estimate beside it, a vector given another value."""
    texts = [_WORDS.sub(" ", text) for text in texts]
    dressed = {(DRESSES[dress], letter) for text in texts for dress, letter in _DRESSED.findall(text)}
    plain = {letter for text in texts for letter in re.findall(_LETTER, _DRESSED.sub(" ", text))}
    values: dict[tuple[str, str, str], str] = {}
    for text in texts:
        for dress, letter, sub, value in _HEAD.findall(text):
            values.setdefault((DRESSES.get(dress, ""), letter, canonical_script(sub)), re.sub(r"\s", "", value))
    others = {
        (dress, letter)
        for (dress, letter, sub), value in values.items()
        if dress and letter.lstrip("\\") not in _WHOLE and values.get(("", letter, sub), value) != value
    }
    found = others | {
        (dress, letter)
        for dress, letter in dressed
        if letter in plain and (dress in _SCRIPT_LETTERS or (dress == "hat" and letter in _MATRICES))
    }
    return frozenset(f"{dress} {letter.lstrip(chr(92))}" for dress, letter in found)


def starred_names(texts: Sequence[str]) -> frozenset[str]:
    """Return the keys of names that have a value with a star and stand without it too: l_2 of l_2^* = 2, d of d = l_1 and d^* = l_2, θ_2 of θ_2^* = -θ_2."""
    texts = [_WORDS.sub(" ", text) for text in texts]
    plain = {_key(*found[:2]) for text in texts for found in _NAME.findall(text) if not found[2]}
    given = {_key(letter, sub) for text in texts for _, letter, sub, _ in _HEAD.findall(text)}
    return frozenset(key for key, tells in _starred(texts) if key in plain and (tells or key in given))


def _starred(texts: Sequence[str]) -> Iterator[tuple[str, bool]]:
    """Yield the keys of starred names that an equation begins with, and whether it tells them from the plain ones: by a number, or a formula of these."""
    for text in texts:
        for letter, one, other, value in _STARRED_HEAD.findall(text):
            if letter.lstrip("\\") in STARRED:
                key = _key(letter, one or other)
                is_number = not re.search(r"[A-Za-z]", _NO_LETTER.sub("", value))
                yield key, is_number or key in {_key(*found[:2]) for found in _NAME.findall(value) if not found[2]}


def _key(letter: str, sub: str) -> str:
    base, script = letter.lstrip("\\"), canonical_script(sub)
    base = VARIANTS.get(base, base)
    return f"{base}_{script}" if script else base
