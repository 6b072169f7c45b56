r"""What a text tells of the indices of a transform: "$T_i^j$ gives frame i in frame j", "$p_i = T_{ij} p_j$"; and that points are rows."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import formulas_of, says, words_of
from armproof.verification.patterns import regex

REFERENCE = "reference"  # which index is the reference: upper or lower, first or second
LEFT_LOWER = "left lower"  # of the scripts before a letter the lower one is the reference: {}^A_BT is A in B
LEFT_UPPER = "left upper"  # the upper one is, as it mostly is
ROWS = "rows"  # points are rows, and matrices stand behind them

MAY_INDEX = regex(  # what no such sentence lacks, in small letters
    r"frame|rep[eè]re|system|sistema|marco|terna|referencial|coord|koord|\brows?\b|zeilen|lignes?\b|\bfilas?\b|\brig[ah]e?\b|linha|[tahr]\s*_"
)
_INDEX, _ANY = r"\{?\s*(\w)\s*\}?", r"\{?\s*\w\s*\}?"
_LETTER = r"(?:\\\w+\s*\{)?[TAHR]\}?\s*"
_MATRIX = regex(
    rf"{_LETTER}(?:_\s*{_INDEX}\s*\^\s*{_INDEX}|\^\s*{_INDEX}\s*_\s*{_INDEX}|_\s*\{{\s*(\w)\s*,?\s*(\w)\s*\}})"
)
_BEFORE = rf"(?:\{{\}}\s*\^\s*{_INDEX}\s*)?"
_LEFT = regex(
    rf"\{{\}}\s*\^\s*{_INDEX}(?:\s*_\s*{_INDEX}\s*{_LETTER}|\s*{_LETTER}_\s*{_INDEX})|\{{\}}\s*_\s*{_INDEX}\s*\^\s*{_INDEX}\s*{_LETTER}"
)
_MAPS = regex(  # p_i = T_{ij} p_j, {}^j p = T_i^j {}^i p
    rf"\s*{_BEFORE}([a-z])(?:_\s*{_INDEX})?\s*=\s*(?P<matrix>{_LETTER}(?:_\s*{_ANY}\s*\^\s*{_ANY}|\^\s*{_ANY}\s*_\s*{_ANY}|_\s*\{{[^{{}}]*\}}))"
    rf"\s*(?:\\,|\\;|\\cdot)?\s*{_BEFORE}\2(?:_\s*{_INDEX})?\s*"
)
_FRAME = r"(?:frame|system|sistema|repère|koordinatensystem|referencial|marco|terna|link|base|hand|tool|gripper|effector|world|basis|greifer|werkzeug|pince|outil|mano|pinza)"
_ARTICLE = (
    r"(?:the |a |le |la |l' |el |das |des |der |dem |den |die |il |o |da |do |del |dell' |della |du |de |von |of )*"
)
_PLACE = rf"{_ARTICLE}(?:coordinate )?({_FRAME})(?: (\w)(?!\w))?"
_AS_SEEN = r"(?:is|are|as|expressed|described|written|given|seen|viewed|exprimé|décrit|vu|ausgedrückt|beschrieben|gesehen|expresado|visto|espresso|relative|relativ|with|respect|par|rapport|con|respecto|rispetto)"
_SEEN = regex(  # "from frame 0 to frame 1" says neither
    rf"(?<!\S){_PLACE} (?:(?:{_AS_SEEN} )*(?:in|im|en|dans|nel|nella|no|na|bezüglich)|(?:{_AS_SEEN} )+(?:to|al|a|à|au|from|aus|von|desde|depuis|dal|dalla)) {_PLACE}"
)
_TURNS = regex(
    rf"(?<!\S)(?:coordinates|coordonnées|koordinaten|coordenadas|coordinate) {_ARTICLE}(?:in |im |en |dans |from |aus )?{_PLACE} (?:in |into |to |en |a |à |auf )(?:those|celles|jene|die|las|los|quelle|coordinates|coordonnées|koordinaten|coordenadas)(?: in| im| en| dans)? {_PLACE}"
)
_INTO = regex(  # "coordinates in A into coordinates in B"
    r"(?<!\S)(?:coordinates|components|coordonnées|composantes|koordinaten|coordenadas|coordinate) (?:in|of|dans|en|im|von|de) (\w) (?:in|into|to|en|auf|a) (?:coordinates|components|those|coordonnées|composantes|celles|koordinaten|die|solche|coordenadas|las|coordinate|quelle) (?:in|of|dans|en|im|von|de) (\w)(?!\w)"
)
_SCRIPT = r"(?:left |leading |gauche |linke )?(?:{} (?:left |leading |linke )?(?:index|script)|{}|indice {}(?: gauche| de gauche)?)"
_UPPER = _SCRIPT.format("(?:upper|top|obere)", "superscript|exposant", "supérieur")
_LOWER = _SCRIPT.format("(?:lower|bottom|untere)", "subscript", "inférieur")
_NAMES_FRAME = rf"(?:names|is|denotes|gives|tells|désigne|est|donne|nennt|ist|bezeichnet) {_ARTICLE}(?:frame|repère|system|koordinatensystem)"
_SEEN_ABOVE = regex(  # "the upper index names the frame that is described", "the lower one that in which it is"
    rf"(?<!\S){_UPPER} {_NAMES_FRAME} (?:,? ?(?:that|which) is (?:being )?(?:described|located)|being described|described|décrit|qui est décrit|, das beschrieben wird)(?! in )"
    rf"|(?<!\S){_LOWER} {_NAMES_FRAME} (?:(?:in|with respect to|relative to) which|of reference|de référence|dans lequel|par rapport auquel|, in dem)"
)
_BEFORE_LETTER = regex(r"(?<!\S)(?:left|leading|gauche|linke)(?!\S)")
_TELLS_OF = regex(
    r"(?<!\S)(?:columns?|axes|pose|position|orientation|expres\w*|express\w*|describ\w*|décrit|beschreibt|gives|giving|donne|gibt|expresa|esprime|descrive|transform\w*|trasforma\w*|turns?|maps?|rotates?|takes?|überführt|convierte|converte|convertit|denotes|is|are|est|ist|es|è)(?!\S)"
)
_BASE = ("base", "world", "basis")


def told_indices(sentence: str) -> Iterator[str]:
    """Yield what a sentence tells of indices, as what holds of the displays in its section: each with the sentence on a second line."""
    line = " ".join(sentence.split())
    yield from (f"{each}\n{line}" for each in dict.fromkeys(filter(None, _told(line))))


def _told(sentence: str) -> Iterator[str]:
    words = words_of(sentence)
    if says("ROW_VECTORS", words):
        yield ROWS
    formulas = [each.strip() for each in formulas_of(sentence)]
    for formula in formulas:
        if (found := _MAPS.fullmatch(formula)) is not None:
            reference, seen = found[1] or found[3], found[5] or found[6]
            yield from _reference(found["matrix"], seen or "", reference or "")
    matrices = [each for each in formulas if _MATRIX.fullmatch(each)]
    plain = words_of(re.sub(r"\$\s*(\w)\s*\$", r"\1", sentence)).lower()
    if _SEEN_ABOVE.search(plain):
        yield LEFT_LOWER if _BEFORE_LETTER.search(plain) else f"{REFERENCE} lower"
    yield from (_left_reference(each, plain) for each in formulas)
    if len({*matrices}) == 1 and _TELLS_OF.search(plain):
        for found in (*_SEEN.finditer(plain), *_TURNS.finditer(plain)):
            indices = [each for group in _MATRIX.fullmatch(matrices[0]).groups() if (each := group)]  # type: ignore[union-attr]
            seen, reference = (
                number or _index_of(frame, indices) for frame, number in ((found[1], found[2]), (found[3], found[4]))
            )
            yield from _reference(matrices[0], seen, reference)


def has_scripts_around(latex: str) -> bool:
    """Whether a transform with a script before its letter and one behind it stands in a display: {}^AT_B."""
    return any(each[3] for each in _LEFT.finditer(latex))


def _left_reference(formula: str, words: str) -> str:
    """Return which script of {}^A_BT, or of {}^AT_B, a sentence says to be the reference, "" where it does not.

    It gives the other frame in that one, or turns coordinates in the other into those in that one.
    """
    if (found := _LEFT.fullmatch(formula)) is None or not _TELLS_OF.search(words):
        return ""
    pair = (found[1], found[2] or found[3]) if found[1] else (found[5], found[4])
    upper, lower = map(str.lower, pair)
    told = [(each[1], each[2]) for each in _INTO.finditer(words)]
    told += [(each[2] or "", each[4] or "") for pattern in (_SEEN, _TURNS) for each in pattern.finditer(words)]
    return LEFT_LOWER if (upper, lower) in told else LEFT_UPPER if (lower, upper) in told else ""


def _index_of(frame: str, indices: list[str]) -> str:
    """Return the index of the base, 0 or B, or of what is no base: "" where it has none."""
    of_base = [each for each in indices if each in "0Bb"]
    if len(of_base) != 1:
        return ""
    return of_base[0] if frame in _BASE else next(each for each in indices if each not in of_base)


def _reference(matrix: str, seen: str, reference: str) -> Iterator[str]:
    """Yield which index of a matrix is the reference, where the two are its own."""
    found = _MATRIX.fullmatch(matrix)
    if found is None:
        return
    lower, upper = (found[1], found[2]) if found[1] else (found[4], found[3])
    pair = {"lower": lower, "upper": upper} if lower else {"first": found[5], "second": found[6]}
    if seen != reference and {seen.lower(), reference.lower()} == {each.lower() for each in pair.values()}:
        yield f"{REFERENCE} {next(name for name, each in pair.items() if each.lower() == reference.lower())}"
