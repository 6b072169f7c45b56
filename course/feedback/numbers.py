"""Numbers as students write them: a list, a text with decimal commas, with units, with names or words between them."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import is_function, read_plain
from armproof.course.feedback.spelling import with_powers
from armproof.models.language import ENGLISH, spoken

_DECIMAL_COMMAS = re.compile(r"\s*[\[(]?\s*[-+]?\d+(?:,\d+)?(?:\s*;\s*[-+]?\d+(?:,\d+)?)*\s*[\])]?\s*")
_ONE_DECIMAL_COMMA = re.compile(r"\s*[-+]?(?:0,\d+|\d+,(?!\d{3}\s*$)\d+)\s*")  # 1,500 may be a thousand and a half
_THOUSANDS = re.compile(r"(?<=\d)[ \xa0\u202f](?=\d{3}(?!\d))")  # 28 648
_BLANKS = {0xA0: " ", 0x202F: " "}  # that do not break, as they stand in French
_NAMED = re.compile(
    r"(?:(?<=^)|(?<=[\[(,;\s]))(?:\\?(?:sin|cos|tan|d?dot)\s*)?\\?[^\W\d]\w*['′]*\s*(?:=|≈|\\approx)\s*"
)
_SAID = re.compile(r"\s*(?P<word>[^\W\d]{3,})(?:\s*:\s*|\s+)(?P<value>[-−+]?[\dπp\\].*)")  # roll -pi/2
_BEFORE_WORD = r"\s+(?=[^\W\d]{3,}\s)"  # roll -pi/2 pitch 0
_SUM = re.compile(r"(?P<whole>\d+|[^\W\d_]+)\s*\((?P<parts>\d+(?:\s*\+\s*\d+)*)\)")  # 6 (3+3), six (6)
_AS_COLUMN = re.compile(r"\\(?:begin|end)\{[bp]?matrix\}|\^\{?(?:T|\\top)\}?\s*$")
_SEPARATORS = re.compile(r"\\\\|[|&]")  # of a column in LaTeX, of coordinates (1 | 2)
_SCALES = {
    "m": {"m": 1.0, "cm": 0.01, "mm": 0.001, "km": 1000.0},
    "m/s": {"m/s": 1.0, "cm/s": 0.01, "mm/s": 0.001},
    "rad": {"rad": 1.0, "deg": np.pi / 180, "°": np.pi / 180},
    "rad/s": {"rad/s": 1.0, "deg/s": np.pi / 180, "°/s": np.pi / 180, "s^-1": 1.0, "/s": 1.0},
}
_WORDS: dict[str, float] = {
    word: number
    for number, words in enumerate((
        "zero none no zéro aucun aucune", "one un une", "two deux", "three trois", "four quatre", "five cinq", "six",
        "seven sept", "eight huit", "nine neuf", "ten dix", "eleven onze", "twelve douze",
    ))
    for word in words.split()
}  # fmt: skip
_WORDS |= dict.fromkeys(("infinite", "infinity", "infinitely many", "infini", "infinité", "∞", "inf"), float("inf"))
_FRACTION = re.compile(r"\\[dt]?frac\s*(?:\{([^{}]*)\}|(\d))\s*(?:\{([^{}]*)\}|(\d))")
_PLAIN = {"pi": "pi", "cdot": "*", "times": "*"}
_IN_LATEX = re.compile(r"\\(pi|cdot|times)(?![A-Za-z])")
_RECKONING = re.compile(
    r"pi|sqrt|root|racine|sin|cos|tan|minus|moins|plus|times|fois|not|pas|or|ou|over|sur|frac|dfrac|half|demi|about|environ",
    re.I,
)
_TEXT = re.compile(r"\\(?:text|mathrm)\{([^{}]*)\}")
_MARKS = re.compile("[\u0300-\u036f]")  # a dot above a letter
_ASIDE = re.compile(r"(?<=\d)\s*\([^()]*[^\W\d_]{3,}[^()]*\)\s*$")  # 6 (3 rotations, 3 translations)
_ABOUT = re.compile(r"^\s*(?:about|approximately|roughly|environ|≈|~)\s*", re.I)
_ZERO_BARE = re.compile(r"(?<![\d.,])[-+]?0(?:[.,]0+)?(?=\s*(?:[,;\])]|$))")
_TIMES = re.compile(r"(?:(?<=^)|(?<=[\[(,;\s]))[x×]\s*(?=\d)")  # ×2, ×4
_COMMAS = re.compile(r"[^,]*?(?:(?<![\d,.])\d+,\d{1,2}(?![\d.])|(?<![\d,])0,\d+)[^,]*(?:\d,\d[^,]*)*")
_BETWEEN = ("and", "et", "to", "by", "à", "row", "is", "est")  # short words that are no units
_KNOWN = sorted(
    {unit for scales in _SCALES.values() for unit in scales} | {"kg", "N", "s", "rpm"}, key=len, reverse=True
)
_UNIT = re.compile(rf"(?<=[\d\])])\s*({'|'.join(map(re.escape, _KNOWN))})(?![\w/])")


def numbers_in(answer: Any, unit: str = "–", count: int = 0) -> np.ndarray:
    """Return the numbers of an answer in a unit: of a list, a text, SymPy, a function without arguments.

    Args:
        unit: of what is asked; another of its kind is converted.
        count: how many are asked; of one alone, "2,5" has a decimal comma.

    Raises:
        AnswerError: a unit of another kind.
        ValueError, TypeError: they are no numbers.
    """
    if is_function(answer):
        answer = answer()
    if hasattr(answer, "tolist"):
        answer = answer.tolist()
    if isinstance(answer, list | tuple):
        answer = _with_points(answer)
        return np.array([value for item in answer for value in numbers_in(item, unit, 1).tolist()], dtype=float)
    if isinstance(answer, str):
        return _of_text(answer, unit, count)
    return np.array([float(answer)])


def _with_points(items: Any) -> Any:
    """Return a list whose texts have decimal points, where one of them shows that its comma is a decimal one."""
    texts = [item for item in items if isinstance(item, str)]
    if not any(map(_ONE_DECIMAL_COMMA.fullmatch, texts)):
        return items
    return [re.sub(r"(?<=\d),(?=\d)", ".", item) if isinstance(item, str) else item for item in items]


def _of_text(text: str, unit: str, count: int) -> np.ndarray:
    """Return the numbers of a text: "[0, 2]", "0 2", "pi/2", "x = 250 mm"; of "0,05 ; 0,55", which is French, two."""
    text = _MARKS.sub("", text)
    if count == 1 or ";" in text:
        text = _THOUSANDS.sub("", text)
    if count == 1:
        text = re.sub(r"\s*×\s*(?=\d)", "*", with_powers(text).strip().strip("$")).removeprefix("=")
    else:
        text = _without_words(_SEPARATORS.sub(",", _AS_COLUMN.sub("", text)), count)
    if count == 1 and (worked := _worked_out(text, unit)) is not None:
        return worked
    text = _ASIDE.sub("", text) if count == 1 else _TIMES.sub("", text)
    if count > 1 and re.fullmatch(rf"\s*\d{{{count}}}\s*", text):  # 0001 for four of them
        text = " ".join(text.strip())
    text = _TEXT.sub(r" \1", text).replace("\\,", " ").replace("\\ ", " ")
    text = _NAMED.sub(
        "", re.sub(r"\b(?:minus|moins)\s+", "-", text).replace("−", "-").replace("·", "*").translate(_BLANKS)
    )
    text = _ABOUT.sub("", text) if count == 1 else text
    scales = [_scale(found, unit) for found in _UNIT.findall(text)]
    values = _of_bare(_UNIT.sub("", text), count)
    if len(scales) > 1 and len(scales) == np.count_nonzero(values) < len(values):  # zero has no need of a unit
        left = iter(scales)
        scales = [next(left) if value else 1.0 for value in values.tolist()] if _ZERO_BARE.search(text) else scales
    if scales and len(scales) not in (1, len(values)):
        raise ValueError("some numbers have a unit and some have none")
    return values * np.array(scales or [1.0])


def _without_words(text: str, count: int) -> str:
    """Return a list without the word before each of its numbers, roll -pi/2, pitch 0; and with commas between them."""
    items = re.split(";" if ";" in text else "," if "," in text else _BEFORE_WORD, text)
    if count < 2 or len(items) != count:
        return text
    said = [_SAID.fullmatch(item) for item in items]
    words = [found["word"].lower() for found in said if found is not None]
    if len({*words}) == count and not any(map(_RECKONING.fullmatch, words)):
        items = [found["value"] for found in said if found is not None]
    elif ";" not in text:
        return text
    return ", ".join(re.sub(r"(?<=\d),(?=\d)", ".", item) for item in items)


def _worked_out(text: str, unit: str) -> np.ndarray | None:
    """Return the number at the end of a chain of equal ones, 3 + 3 = 6, or before the sum that it is, 6 (3+3); None of anything else."""
    if (found := _SUM.fullmatch(text.strip())) is not None:
        members = [found["parts"], str(_WORDS.get(found["whole"].lower(), found["whole"]))]
    else:
        members = _NAMED.sub("", text).split("=")
    if len(members) < 2:
        return None
    values = [_of_text(member, unit, 1) for member in members]
    return values[-1] if np.allclose(values, values[-1], rtol=1e-3) else None


def _scale(found: str, unit: str) -> float:
    if unit not in _SCALES:
        raise ValueError("no unit is asked for")
    if found not in _SCALES.get(unit, {}):
        raise AnswerError("{found} is not the unit: {unit} is asked for", found=found, unit=unit)
    return _SCALES[unit][found]


def _of_bare(text: str, count: int) -> np.ndarray:
    has_comma = _DECIMAL_COMMAS.fullmatch(text) and (";" in text or spoken() != ENGLISH)
    if has_comma or (count == 1 and _ONE_DECIMAL_COMMA.fullmatch(text)):
        text = text.replace(",", ".").replace(";", ",")
    if count == 1 and _COMMAS.fullmatch(text):
        text = re.sub(r"(?<=\d),(?=\d)", ".", text)
    if (number := _WORDS.get(text.strip(" .").lower())) is not None:
        return np.array([float(number)])
    plain = read_plain(_IN_LATEX.sub(lambda found: _PLAIN[found[1]], _FRACTION.sub(_divided, text)))
    if plain is None and count > 1 and re.fullmatch(r"[^,]*\d,\d[^,]*(?:\b(?:et|and)\b|;)[^,]*\d,\d[^,]*", text):
        return _of_bare(re.sub(r"\b(?:et|and)\b", ";", re.sub(r"(?<=\d),(?=\d)", ".", text)).replace(";", ","), count)
    if plain is None and (among := _among_words(text)) is not None and len(among) == count:
        return among
    if plain is None:
        return np.array([float(part) for part in re.split(r"[,;\s]+|\band\b", text.strip(" []()")) if part])
    return np.array([float(item) for item in _flat(plain)])


def _flat(value: Any) -> list[Any]:
    return [item for each in value for item in _flat(each)] if isinstance(value, list) else [value]


def _divided(found: re.Match[str]) -> str:
    """Return a fraction of LaTeX as Python writes it."""
    above, below = found[1] or found[2], found[3] or found[4]
    return f"(({above})/({below}))"


def _among_words(text: str) -> np.ndarray | None:
    """Return the numbers of a text of words, "row 1, column 2" or "6×7, 7×1"; None where it may be a sum or a doubt."""
    text = re.sub(r"(?<=\d)\s*[x×]\s*(?=\d)", " ", text)
    text = re.sub(r"(?<=\d)\s*[x×](?=\W|$)", " ", text)
    text = re.sub(r"[^\W\d_]+", lambda found: str(_WORDS.get(found.group().lower(), found.group())), text)
    words = re.findall(r"[^\W\d_]{2,}", text)
    behind = re.findall(r"\d\s*([^\W\d_]+)", text)  # 0.375 s has another unit
    if any(map(_RECKONING.fullmatch, words)) or any(len(word) < 4 and word not in _BETWEEN for word in behind):
        return None
    rest = re.sub(r"\\?[^\W\d_]+(?:_\w+)?", " ", text)
    if not re.fullmatch(r"[\s,;:=.()\[\]°+\-\d]*", rest):
        return None
    parts = [part for part in re.split(r"[\s,;:=()\[\]°]+", rest) if part.strip(".")]
    try:
        return np.array([float(part.rstrip(".")) for part in parts])
    except ValueError:
        return None
