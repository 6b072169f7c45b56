r"""What sentences, tables and captions say a name to be that is not what it usually is: "Let $P_2$ be the middle of the second link".

A definition whose words are all those of the usual quantities, points and frames of an arm tells nothing new. Any other word may
make the name something else, known or not: then convention does not tell what it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.document.letters_anew import holds_from_here, holds_in_section
from armproof.verification.document.told_words import holds as is_of
from armproof.verification.document.told_words import is_other, is_told, is_usual_word, number_of
from armproof.verification.patterns import regex

TOLD = "told"  # a name that the text says to be something; with its place, and the words
OTHER, STRANGE, WANTED, POINT = "other", "strange", "wanted", "point"  # strange: in words that are not known
TOOL, WRIST, INNER, LINK = "tool", "wrist", "inner", "link"
USUAL = ""  # where a definition tells no more than convention does
MAY_TELL_NAMES = regex(  # in small letters: what no text that defines a name in words lacks
    r"\b(?:let|call|denot|stands? for|mean|designat|represent|is|are|be|was|soi(?:t|ent)|note|notons|notée?|appel|nomm|désign|est|sont|sei|seien|ist|sind|bezeichne|nenn|heiß|sea|sean|llam|denomin|es|son|sia|siano|chiam|indic|è|sono|seja|sejam|cham|é|são|start|begin|pass|motion|move|wobei|où)"
    r"|\$\s*(?::|—|–|\||&)"
)
_NAME = regex(
    r"\s*(?:\{\s*\}\s*\^\s*\{?0\}?\s*)?(?:\\(?!frac|sqrt|sin|cos|det|left|begin|text\b)[A-Za-z]+\s*|[A-Za-z]\w?(?![A-Za-z])|[{}]\s*)+(?:[_^]\s*(?:\w|\{[^{}=+]*\}|\\\w+)\s*)*[{}]*(?:\s*\((?:t|q|\\theta)\))?\s*"
)
_NUMBER = regex(r"\s*\\?\{?\s*(\d)\s*\\?\}?\s*")
_TUPLE = regex(r"\s*\\?(?:left)?[(\[]([^()\[\]=]*)\\?(?:right)?[)\]]\s*(?:\^\{?(?:T|\\top)\}?)?\s*")
_ITEM = regex(r"\s*(?:[-*+•]\s+|\d+[.)]\s+|\\item\s+)?(?:\*\*)?((?:\$[^$]+\$(?:\s*(?:,|and|et|und|y|e)\s*)?)+)(?:\*\*)?\s*(?::|=|—|–|--+|-)\s*(?!\s*\$\$)(?=[^\W\d_])")  # fmt: skip
_ROW = regex(r"(?<=\|)[^|\n]*(?=\|)")
_TABULAR = regex(r"\\begin\{(?:tabular|longtable|tabularx|array)\*?\}.{0,4000}?\\end\{(?:tabular|longtable|tabularx|array)\*?\}", re.DOTALL)  # fmt: skip
_MOST_BETWEEN = 14  # words between a verb and the name that it gives
_MOST_OF_NOUN = 4  # words of an apposition


@dataclass(frozen=True)
class Told:
    """What a text says a name to be: its LaTeX, the place or `OTHER`, and its words."""

    name: str
    place: str
    words: str
    is_anew: bool = False  # from the sentence on

    def as_meant(self) -> str:
        """Return it as what holds of a display."""
        return "\t".join((TOLD, self.name, self.place, self.words))


@dataclass(frozen=True)
class Definition:
    """Names that a sentence defines, with the words by which it does and their formulas: surely, or by a noun that they are put to."""

    listed: Sequence[str]
    phrase: Sequence[str]
    formulas: Sequence[str]
    text: str
    is_sure: bool = True
    is_anew: bool = False
    is_of_path: bool = False
    is_of_section: bool = False
    is_predicate: bool = False  # what is said of a name, and defines none but a variable: "is measured from"


def told_names(defined: Iterable[Definition]) -> Iterator[Told]:
    """Yield what the definitions of a sentence say names to be, where that may be something else than they usually are."""
    for each in defined:
        if each.is_of_path:
            yield from (Told(name, POINT, each.text) for name in each.listed)
        elif each.phrase and not each.is_predicate:
            for told in _told(each.listed, each.phrase, each.is_sure):
                yield Told(told.name, OTHER, each.text, True) if each.is_anew else replace(told, words=each.text)


_ASKING = frozenset(
    "where how why whether où comment pourquoi wo wohin wie warum ob dónde cómo dove come onde como".split()
)


def definitions(plain: str) -> Iterator[Definition]:
    """Yield the names of a sentence, each group with the words by which it is defined, and with what is said of it."""
    formulas = formulas_of(plain)
    said, names = words_of(plain).split(), dict[int, list[str]]()
    places = [place for place, word in enumerate(said) if word == "¤"]
    if len(places) != len(formulas):
        return
    for place, latex in zip(places, formulas, strict=True):
        if found := _names(latex):
            names[place] = found
    numbers = {
        place: digit[1] for place, latex in zip(places, formulas, strict=True) if (digit := _NUMBER.fullmatch(latex))
    }
    written = {word.lower(): word for word in said}
    said = [numbers.get(place, word.lower()) for place, word in enumerate(said)]
    is_anew, is_of_section = holds_from_here(" ".join(said)), holds_in_section(" ".join(said))
    item = _ITEM.match(plain)
    for start, end in _groups(said, names):
        phrase, is_sure = _defined(said, start, end, names, item is not None and not said[:start])
        if _ASKING.issuperset(phrase):  # "Note where $z_2$ points" defines nothing
            phrase = []
        listed = [each for place in range(start, end) for each in names.get(place, ())]
        if is_of_path := _is_of_a_path(said[:start]):
            phrase = [*_clause(said[:start]), "¤"]
        behind = [latex for place, latex in zip(places, formulas, strict=True) if place >= end and place not in numbers]
        text = _text([written.get(word, word) for word in phrase])
        within = behind[: phrase.count("¤")] if is_sure else []
        yield Definition(listed, phrase, within, text, is_sure, is_anew, is_of_path, is_of_section)
        if (predicate := _predicate(said[end:])) and not (phrase and is_sure):
            text, within = _text([written.get(word, word) for word in predicate]), behind[: predicate.count("¤")]
            yield Definition(listed, predicate, within, text, is_of_section=is_of_section, is_predicate=True)


def defined_in_rows(text: str) -> Iterator[tuple[int, Definition]]:
    """Yield what the rows of tables define names by, each with the offset of its row: | $p_1$ | middle of bar 1 |."""
    at = 0
    for line in text.split("\n"):
        if line.count("|") > 1:
            yield from ((at, each) for each in _of_cells(_ROW.findall(line)))
        at += len(line) + 1
    for table in _TABULAR.finditer(text):
        at = table.start()
        for row in table.group().split(r"\\"):
            yield from ((at + len(row) - len(row.lstrip()), each) for each in _of_cells(row.split("&")))
            at += len(row) + 2


def _of_cells(cells: Sequence[str]) -> Iterator[Definition]:
    if len(cells) > _MOST_OF_NOTATION:
        return  # a row of parameters, with the limits of its joint behind its angle
    for cell, behind in pairwise(cells):
        formulas = formulas_of(cell)
        own = [word for word in words_of(cell).split() if word not in (*_AND, "¤", ":")]
        said = words_of(behind).lower().split()
        listed = [name for latex in formulas for name in _names(latex)]
        if listed and not own and sum(map(is_told, said)) > 0:
            yield Definition(listed, said, formulas_of(behind), _text(words_of(behind).split()))


_MOST_OF_NOTATION = 4  # cells of a row that says what a letter is: with a number, and a unit
_AND = (",", "and", "et", "und", "y", "e", "ed", "sowie", "&", "or", "ou", "oder", "o")


def _names(latex: str) -> list[str]:
    """Return the names that a formula consists of: one, or those of a tuple or of a list; else []."""
    inside = found[1] if (found := _TUPLE.fullmatch(latex)) is not None else latex
    parts = [each for each in re.split(r",(?![^{]*\})|;", inside) if each.strip(" \\;,")]
    return [each.strip() for each in parts] if parts and all(map(_NAME.fullmatch, parts)) else []


def _groups(said: Sequence[str], names: dict[int, list[str]]) -> Iterator[tuple[int, int]]:
    """Yield where names stand one after another: "$x_2$, $y_2$ and $z_2$"."""
    place = 0
    while place < len(said):
        if place not in names:
            place += 1
            continue
        start = end = place
        while end in names:
            end += 1
            behind = next((k for k in range(end, len(said)) if said[k] not in _AND), len(said))
            end = behind if behind in names and behind > end else end
        last = _begins_anew(said, start, end)
        if last > start:
            yield start, last
        yield last, end
        place = end


def _begins_anew(said: Sequence[str], start: int, end: int) -> int:
    """Return where the names before a verb begin: behind "$x_i$ is a component of the pose $x$" its last one alone is "and $\\theta_j$ is"."""
    comma = max((k for k in range(start, end) if said[k] == "," and is_of(said[k + 1], "AND")), default=0)
    before = _clause(said[:start])
    is_ended = "¤" in before and any(is_of(word, "BE") for word in before[before.index("¤") :])
    return comma + 2 if comma and is_ended and said[end : end + 1] and is_of(said[end], "BE") else start


def _defined(
    said: Sequence[str], start: int, end: int, names: dict[int, list[str]], is_item: bool
) -> tuple[list[str], bool]:
    """Return the words by which names that stand at a place are defined, and whether these define: else a known other word alone tells."""
    before, behind = said[:start], said[end:]
    verb = _verb_before(before)
    named = next((k for k, word in enumerate(behind[:3]) if is_of(word, "NAMES")), None)
    if before and is_of(before[-1], "BY") and named is not None:
        ahead = _phrase(behind[named + 1 :])
        own = [word for word in ahead if is_told(word)]
        return (ahead, True) if own else (_clause(before[:-1]), True)
    if is_item or (behind and is_of(behind[0], "STANDS")):
        first = behind[0] if behind else ""
        return _phrase(behind[1:] if is_of(first, "STANDS") or first in (":", "=") else behind), True
    is_joined = before[-2:-1] == [","] and is_of(before[-1], "AND")  # a clause of its own: ", and $p_1$ is"
    if behind and is_of(behind[0], "BE") and (is_joined or not (before and is_of(before[-1], "OF"))):
        is_definite = len(behind) > 1 and (is_of(behind[1], "DEFINITE") or is_of(behind[1], "COUNT"))
        if is_definite or (behind[0] in ("be", "sei", "seien", "stands") and verb is None):
            return _phrase(behind[1:]), True
    if before and is_of(before[-1], "WHERE") and behind and is_of(behind[0], "DEFINITE"):
        return _phrase(behind), True
    if verb is not None:
        between = [word for word in before[verb + 1 :] if not (is_of(word, "BY") or is_of(word, "WE"))]
        if any(is_told(word) for word in between):
            return between, True
        ahead = _phrase(behind)
        return (ahead, True) if any(map(is_told, ahead)) else (_clause(before[:verb]), True)
    if before and (is_of(before[-1], "AND") or before[-1] == ",") and behind and is_of(behind[0], "DEFINITE"):
        return _phrase(behind), any(is_of(word, "NAMES") or is_of(word, "BE") for word in before)
    ends = not behind or behind[0] in (".", ":", ",", ";")
    if before and is_of(before[-1], "BE") and ends:
        return _clause(before[:-1]), False
    return _noun(before), False


def _verb_before(before: Sequence[str]) -> int | None:
    """Return the place of the verb that gives the name behind it, None where none does: "we denote by", "let", not "note that"."""
    for back, word in enumerate(reversed(before[-_MOST_BETWEEN:])):
        if word in (".", ";", ":", "¤", ",") or is_of(word, "THAT"):
            return None
        if is_of(word, "NAMES"):
            return len(before) - 1 - back
    return None


def _phrase(behind: Sequence[str]) -> list[str]:
    """Return the words of a definition: up to the end of its clause, or the next name that has one."""
    found: list[str] = []
    for place, word in enumerate(behind):
        if word in (".", ";", "!", "?", ":") and found:
            break
        ahead = behind[place + 1 : place + 3]
        if (
            word in _AND
            and ahead[:1] == ["¤"]
            and (len(ahead) < 2 or any(is_of(ahead[1], kind) for kind in ("DEFINITE", "BE", "STANDS")))
        ):
            break
        found.append(word)
    return found


def _clause(before: Sequence[str]) -> list[str]:
    """Return the words of a clause that ends, behind the last mark."""
    start = max((k + 1 for k, word in enumerate(before) if word in (".", ";", ":", "!", "?", ",")), default=0)
    return [*before[start:]]


def _noun(before: Sequence[str]) -> list[str]:
    """Return the noun to which a name is put: "the middle $P_1$ of the bar", no verb and no preposition between."""
    if not before or any(is_of(before[-1], kind) for kind in ("OF", "BY", "BE", "WHERE", "AND", "NAMES", "DEFINITE")):
        return []
    found: list[str] = []
    for word in reversed(before[-_MOST_OF_NOUN:]):
        if not word[:1].isalpha() or is_of(word, "BE") or is_of(word, "BY"):
            break
        found.insert(0, word)
    return found


def _predicate(behind: Sequence[str]) -> list[str]:
    """Return the words that say of a variable how it is counted, or what it is: "is measured from", "is how far"."""
    is_told = len(behind) > 1 and is_of(behind[0], "BE") and is_of(behind[1], "REACHES")
    return _phrase(behind[1:]) if is_told else []


def _is_of_a_path(before: Sequence[str]) -> bool:
    """Whether a name is of a point where a motion begins, ends or leads through: "starts at $p_1$", "from $p_1$ to $p_2$"."""
    end = len(before)
    if end and is_of(before[-1], "POINTS"):
        end -= 1 + (end > 1 and is_of(before[-2], "DEFINITE"))
    is_there = end > 0 and (is_of(before[end - 1], "AT") or is_of(before[-1], "AFTERWARDS"))
    return is_there and _moves(before)


def _moves(before: Sequence[str]) -> bool:
    said = [word for word, behind in zip(before, (*before[1:], ""), strict=True) if not _is_an_end(word, behind)]
    said = [word for word in said if word[:1].isalpha()]
    return any(is_of(word, "MOVES") for word in said) and not any(is_of(word, "FRAME") for word in said)


def _is_an_end(word: str, behind: str) -> bool:
    """Whether a word is no verb but the end of something: "the far end of the forearm"."""
    return word in ("end", "ends") and behind == "of"


def _told(listed: Sequence[str], phrase: Sequence[str], is_sure: bool) -> Iterator[Told]:
    """Yield what the words of a definition make of names: of what other thing, or of which place of the arm."""
    text = _text(phrase)
    comma = phrase.index(",") if "," in phrase else len(phrase)
    own = [word for word in phrase if is_told(word)]
    is_strange = any(not is_usual_word(word) for word in own if word in phrase[:comma])
    is_computed = any(is_of(word, "COMPUTED") for word in phrase)
    if is_other(phrase):
        yield from (Told(each, OTHER, text) for each in listed)
    elif is_sure and is_strange and not is_computed:
        yield from (Told(each, STRANGE, text) for each in listed)
    elif is_sure and own:
        yield from (Told(each, _place(phrase[:comma]), text) for each in listed)


def _text(said: Sequence[str]) -> str:
    """Return words as they are quoted."""
    return re.sub(r"(?<=') | (?=[,:;.])", "", " ".join(said).replace("¤", "…"))


def _place(phrase: Sequence[str]) -> str:
    """Return of which place of the arm a definition is, `USUAL` where it tells none."""
    if any(is_of(word, "WANTED") for word in phrase):
        return WANTED
    if number := number_of(phrase):
        return f"{LINK} {number}"
    for kind, place in (("WRIST", WRIST), ("INNER", INNER), ("TOOL", TOOL)):
        if any(is_of(word, kind) for word in phrase):
            return place
    return USUAL
