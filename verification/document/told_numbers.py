r"""What the text says of numbers that are not what they are read as: rates in degrees per second, lengths of a drawing at a scale, "1.000 mm" that is a thousand."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

TOLD_NUMBERS = "numbers told"  # and the words, behind a tab

MAY_TELL_NUMBERS = regex(  # what no such sentence lacks, in small letters
    r"per second|/s\b|rpm|/min|per minute|per hour|par seconde|par minute|pro sekunde|je sekunde|pro minute|por segundo|por minuto|al secondo|per secondo|al minuto|scale|maßstab|échelle|escala|scala|\d\.\d{3}(?!\d)"
    r"|°/s|tours|umdrehungen|giri\b|grad pro|\bin (?:milli|centi|deci)?m|\ben (?:milli|centi|déci)?m|zentimeter|millimeter|centím|milím|centim|millim"
)
_OTHER_UNIT = regex(  # of rates that are no radians per second, said of them all: no number stands before it
    r"(?<!\S)(?<!\d )(?<!¤ )(?:degrees? (?:per|a) (?:second|minute)|deg/s|°/s|rpm|(?:revolutions|turns|rotations) (?:per|a) (?:second|minute)|rev/(?:s|min)|r/min|degrés (?:par|à la) seconde|tours (?:par|à la) (?:minute|seconde)|tr/(?:min|s)|grad (?:pro|je) sekunde|(?:umdrehungen|drehungen) (?:pro|je) (?:minute|sekunde)|u/min"
    r"|grados por segundo|(?:vueltas|revoluciones) por (?:minuto|segundo)|gradi (?:al|per) secondo|giri (?:al|per) (?:minuto|secondo)|giri/min|graus por segundo|(?:voltas|rotações) por (?:minuto|segundo))(?!\w)"
)
_UNIT_OF_RATE = regex(_OTHER_UNIT.pattern.replace(r"(?<!\d )(?<!¤ )", ""))  # with a number before it, too
_RATE_OF = regex(
    r"\s*(?:\\dot\s*(?:\{[^{}]*(?:\{\w+\})?\}|\\\w+|\w)|\\(?:omega|Omega)|\\?varomega)(?:\s*_\s*(?:\w|\{\w+\}))?\s*=\s*(?P<number>-?\d+(?:[.,]\d+)?)\s*"
)
_LENGTH_UNITS = {
    "mm": r"mm\b|millim\w+|milím\w+", "cm": r"cm\b|centim\w+|zentim\w+|centím\w+", "m": r"m\b|met(?:re|er)s?\b|mètres?\b|metros?\b|metri\b",
    "inch": r"inch\w*|pouces?\b|zoll\b", "feet": r"feet\b|foot\b|pieds?\b",
}  # fmt: skip
_A_NUMBER = regex(r"-?\d+(?:\.\d+)?")
_BEFORE_UNIT = r"(?:\d|\d\$|(?<!\w)(?:in|en|em))[\s~]*(?:\\[,; ]\s*)?(?:\\(?:text|mathrm)\s*\{\s*)?"
_RATIO = regex(r"(?<![\d:.,])(\d+) ?[:/] ?(\d+)(?![\d:])")
_GROUPED = regex(r"(?<![\d.,])[1-9]\d{0,2}(?:\.\d{3})+(?![\d.,])")
_POINT = regex(r"(?<![\d.,])(?:0\.\d+|\d+\.(?:\d{1,2}|\d{4,}))(?![\d.])")  # which parts no thousands off
_COMMA = regex(r"(?<![\d.,])\d+(?:\{,\}|,)(?:\d{1,2}|\d{4,})(?![\d,])")
_FORMULAS = regex(r"\$\$?[^$]+\$\$?|\\[(\[].*?\\[)\]]|:math:`[^`]+`", re.DOTALL)
_lists = WordLists("""
RATE rate~ velocit~ speed~ vitesse~ geschwindigkeit~ winkelgeschwindigkeit~ drehzahl~ velocidad~ velocità
CONVERTED convert~ turned umgerechnet umgewandelt wandeln converti~ convertid~ convier~ konvert~ transform~
NOT no not never without neither kein~ nicht ohne pas sans aucun~ sin senza non sem não nunca
SCALE scale scaled maßstab~ échelle escala scala
READ read reads measur~ take taken taking lesen ablesen abgelesen messen gemessen entnehmen entnommen lisons lit lire lues lus mesur~ relev~ leemos leer leíd~ medimos medir medid~ leggiamo leggere lett~ misur~ lemos ler lidas lidos
ENGLISH the and is of with that
COMMA der die das und ist mit sind le les des est une avec el los las una con il gli della sono di o os um uma com são que
""")
_is, _has = _lists.holds, _lists.has


def units_told(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence says that rates are in another unit than radians per second, and not that they are converted, or bear it."""
    small = words.lower()
    if not _OTHER_UNIT.search(small) or any("circ" in each or "°" in each for each in formulas):
        return False
    said = small.split()
    is_converted = _has(said, "CONVERTED") and not _has(said, "NOT")
    return _has(said, "RATE") and not is_converted


def rates_without_unit(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence prints a rate as the bare number of what it is in another unit: "at 30 degrees per second, $\\dot\\theta_1 = 30$"."""
    small = words.lower()
    said, told = small.split(), _UNIT_OF_RATE.search(small)
    rates = {found["number"].replace(",", ".") for each in formulas if (found := _RATE_OF.fullmatch(each))}
    is_converted = _has(said, "CONVERTED") and not _has(said, "NOT")
    if told is None or not rates or is_converted:
        return False
    number = "".join(small[: told.start()].split()[-1:]).replace(",", ".")
    return number in rates or _A_NUMBER.fullmatch(number) is None


def in_two_units(sentence: str, before: str) -> bool:
    """Whether a sentence says in which unit of length something is, and it, or the one before, has lengths in another: "$l_1 = 30$ cm, … (in metres)"."""
    asked = {*_units(r"(?<!\w)(?:in|en|em) ", sentence.lower())}
    return bool(asked) and len(asked | {*_units(_BEFORE_UNIT, f"{before} {sentence}".lower())}) > 1


def _units(before: str, text: str) -> Iterator[str]:
    yield from (unit for unit, name in _LENGTH_UNITS.items() if re.search(rf"{before}(?:{name})", text))


def reads_scaled(sentence: str, words: str, behind: str) -> bool:
    """Whether a sentence is of a drawing at a scale that is not 1:1, from which it, or the next one, reads its numbers."""
    said = words.lower().split()
    if not _has(said, "SCALE"):
        return False
    is_scaled = any(found[1] != found[2] for found in _RATIO.finditer(sentence))
    return is_scaled and _has((*said, *behind.lower().split()), "READ")


def may_be_grouped(formulas: Sequence[str], text: str) -> bool:
    """Whether a number of a sentence may have its thousands parted by a point, "1.000 mm" in a text that writes commas, or whose language does."""
    return any(map(_GROUPED.search, formulas)) and _parts_thousands(text)


@lru_cache(maxsize=2)
def _parts_thousands(text: str) -> bool:
    """Return whether a text writes decimal commas, or is of a language that does, and nowhere a decimal point."""
    inside = " ".join(found.group() for found in _FORMULAS.finditer(text))
    if _POINT.search(inside):
        return False
    if _COMMA.search(inside):
        return True
    said = re.findall(r"[^\W\d_]+", text.lower())
    return sum(_is(word, "COMMA") for word in said) > sum(_is(word, "ENGLISH") for word in said)


def as_told(sentence: str) -> str:
    """Return what a sentence says of numbers as what holds of a display."""
    return f"{TOLD_NUMBERS}\t{' '.join(sentence.split())}"


def numbers_told(meant: Sequence[str]) -> Iterator[str]:
    """Yield the sentences that tell something of a display's numbers."""
    yield from (each.partition("\t")[2] for each in meant if each.startswith(TOLD_NUMBERS))
