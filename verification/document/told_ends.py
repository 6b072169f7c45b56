r"""Where a text puts the tool in the arm's last frame: "La pince P a pour coordonnées $(e, 0, 0)$ dans $R_3$"."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.document.told_words import holds as is_of
from armproof.verification.patterns import regex

MAY_TELL_END = regex(r"coord|koord")  # in small letters: what no such sentence lacks
_COORDINATES = regex(r"(?<!\S)(?:coordonnées|coordinates|koordinaten|coordenadas|coordinate) ")
_PLACED = regex(
    r"¤ (?:dans|in|im|en|nel|nella|em|no) (?:(?:le|la|the|das|dem|el|il|o) )?"
    r"(?:repère |frame |system |koordinatensystem |sistema |terna |referencial )?(?:¤|\d) "
)
_POINT = regex(
    r"\s*\\?(?:left)?\(\s*([^(),;]+?)\s*[,;]\s*([^(),;]+?)\s*[,;]\s*([^(),;]+?)\s*\\?(?:right)?\)\s*(?:\^\{?(?:T|\\top)\}?)?\s*"
)
_OF_FRAME = regex(
    r"\s*(?:(?:\\mathcal|\\mathrm)?\s*\{?\s*[RFS]\s*\}?\s*_\s*\{?\s*(\d)\s*\}?|\\?\{?\s*(\d)\s*\\?\}?)\s*"
)


def told_ends(sentence: str) -> Iterator[str]:
    """Yield the frame in which a sentence gives the coordinates of the tool, and these, set apart by tabs; not of the frame's own origin."""
    words, formulas = words_of(sentence).lower(), formulas_of(sentence)
    noun = _COORDINATES.search(words)
    if noun is None or not any(is_of(word, "TOOL") for word in words.split()):
        return
    for found in _PLACED.finditer(words, noun.end()):
        place = words.count("¤", 0, found.start())
        behind = found.group().split()[-1]
        point = _POINT.fullmatch(formulas[place])
        frame = _OF_FRAME.fullmatch(formulas[place + 1] if behind == "¤" else behind)
        if point is not None and frame is not None and set(point.groups()) != {"0"}:
            yield "\t".join((frame[1] or frame[2], *point.groups()))
