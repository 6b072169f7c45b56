"""Sentences of a text, their words, and the phrases of `phrases.py` that are heard in them.

A sentence is read on one line, formulas as ¤, without its emphasis and parentheses.
"""

from __future__ import annotations

import re
from functools import cache

import armproof.verification.document.phrases as phrases
from armproof.verification.patterns import regex

DELIMITED = regex(r"\$([^$]*)\$|\\\((.*?)\\+\)|:math:`([^`]*)`")  # a formula of a sentence, its LaTeX in a group
FORMULA = regex(r"\$\$?[^$]*\$\$?|\\\(.*?\\\)|:math:`[^`]*`")
AXIS = regex(
    r"\$\s*([xyz])(?:_0)?\s*\$[ -]?(?:axis|achse|direction|coordinate)|\b([xyz])[ -](?:axis|achse|direction)|\b(?:axe|eje|asse|eixo)(?: des| de las| delle| dos)? \$\s*([xyz])(?:_0)?\s*\$"
    r"|(?<=with )\$\s*(y)\s*\$",
    re.IGNORECASE,
)
_LAYOUT = regex(
    r"\\(?:begin|end)\s*\{\w+\*?\}|\\[A-Za-z]+\*?|[{}()\[\]\"“”«»*~>|¿¡]|(?<!\w)_+(?=\w)|(?<=\w)_+(?!\w)|(?<!\S)[-–—]+(?!\S)"
)
STOP = regex(r"(?<!\\)[.;!?](?=\s+\S)")
_LABEL = regex(
    r"(?<=\n)[ \t]*(?:[-*+][ \t]+)?(?:\(?[A-Za-z0-9]{1,2}[.)]|\\item(?:\[[^\]\n]*\])?)?\s*\Z"
)  # "A." of an item that is a display
IS_OVER = regex(r"[.!]\W*\Z")
_GAP = r"(?<![,:;] )(?:(?!(?:true|right|correct|valid|holds?|vraie?|exacte?|correcte|richtig|wahr) )[^\s,:;.!?]\S* ){0,4}?"  # no comma, no verdict
MOST_CHARACTERS = 500  # of a sentence that is read
_SHORT = 6  # words of one that is heard with the one before it


def first_sentence(text: str) -> str:
    """Return the first sentence of a text on one line, its stop with it, or part of one before a semicolon."""
    line = " ".join(text.split())
    stop = STOP.search(line)
    return (line if stop is None else line[: stop.end()])[:MOST_CHARACTERS]


def leading(text: str) -> str:
    """Return the last sentence of a text on one line, which leads to what comes next."""
    return _sentences(text)[-1][-MOST_CHARACTERS:]


def _sentences(text: str) -> list[str]:
    """Return the sentences of a text on one line, without the label of an item that the next display is."""
    found = _LABEL.search(text)
    plain = text if found is None or not text[: found.start()].strip() else text[: found.start()]
    return STOP.split(" ".join(plain.split()))


def before_leading(text: str) -> str:
    """Return the sentence that a short last one goes on from: "Then we get" says little alone, nor does "Its velocity is"."""
    *before, last = _sentences(text)
    words = words_of(last)
    is_short = words.count(" ") <= _SHORT or hears("THEN", words) or hears("OF_THE_ONE_BEFORE", words)
    return before[-1][-MOST_CHARACTERS:] if before and is_short else ""


def formulas_of(text: str) -> list[str]:
    r"""Return the LaTeX of the formulas in a sentence, between dollars, \( and \) or in a role of reStructuredText."""
    return ["".join(each) for each in DELIMITED.findall(text)]


def words_of(text: str) -> str:
    """Return a sentence word by word, each with a blank behind it: formulas as ¤, x-axis one word, marks of their own."""
    text = with_axes(text)
    text = FORMULA.sub(lambda found: " ¤ ≪ " if "\\ll" in found.group() else " ¤ ", text)
    text = _LAYOUT.sub(" ", text.replace("’", "'").replace("'", "' "))
    return " ".join(re.sub(r"([,:.;!?])(?=\s|\Z|[,:.;!?])", r" \1 ", text).split()) + " "


def with_axes(text: str) -> str:
    """Return a text in which the $x$ axis is the x-axis."""
    return AXIS.sub(lambda found: f"{next(filter(None, found.groups()))}-axis", text)


def hears(name: str, words: str) -> re.Match[str] | None:
    """Return where a phrase of a table stands in the words of a sentence."""
    return _phrases(name).search(words.lower())


def hears_denied(name: str, words: str) -> bool:
    """Whether "not" or "no" stands shortly before a phrase of a table, or in it."""
    found = _phrases(name).search(words.lower())
    if found is None:
        return False
    before = words[: found.start()].split()[-4:]
    phrase = found.group().removeprefix("no ")  # "no referencial da garra"
    return hears("NOT", f"{' '.join([*before, phrase])} ") is not None


def says(name: str, words: str) -> bool:
    """Whether a phrase of a table stands in the words of a sentence, and is not denied there."""
    return hears(name, words) is not None and not hears_denied(name, words)


def without(name: str, words: str) -> str:
    """Return the words of a sentence without the phrases of a table."""
    return _phrases(name).sub("", words.lower())


def without_harmless(text: str) -> str:
    """Return the words of a text without its denials that deny nothing: "not trivial", "no approximation"."""
    return _harmless().sub("", words_of(text))


@cache
def _harmless() -> re.Pattern[str]:
    return re.compile(_pattern(phrases.HARMLESS), re.IGNORECASE)


@cache
def _phrases(name: str) -> re.Pattern[str]:
    return re.compile(_pattern(getattr(phrases, name)))


def _pattern(table: str) -> str:
    """Return the pattern of the phrases of a table, a line each, in the small letters of what `words_of` returns."""
    return rf"(?<!\S)(?:{'|'.join(''.join(map(_of_word, line.split())) for line in table.strip().split(chr(10)))})"


def _of_word(word: str) -> str:
    special = {
        "^": r"\A", "$": r"(?:[,:.!?] )*\Z", "…": _GAP, "*": r"(?:[^:;.\s]+ )*?", "%": r"(?:[^:;.\s¤]+ )*?", ",": ", ",
        "&": rf"(?:(?:{'|'.join(phrases.JOINING)}) (?:, )?)*",
    }  # fmt: skip
    if word in special:
        return special[word]
    if word.startswith("(") and word.endswith(")"):
        return f"(?:{_of_word(word[1:-1])})?"
    any_of = "|".join(re.escape(each).replace(r"\~", r"[\w'-]*").replace(r"\#", r"\d") for each in word.split("/"))
    return rf"(?:{any_of}) (?:[,:] )??"
