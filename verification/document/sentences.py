"""What sentences say of the display that they lead to, follow or stand in: "It is not true that", "Suppose that", "to first order".

The words are those of `phrases.py`; a sentence is read on one line, formulas as ¤, without its emphasis and parentheses.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache, lru_cache

import armproof.verification.document.phrases as phrases
from armproof.verification.document.heading import sections_around
from armproof.verification.document.joint_values import joint_values
from armproof.verification.document.model import INLINE, Display
from armproof.verification.document.postures import SINGULAR, is_of_singularities
from armproof.verification.document.strange import is_strange_before, is_strange_behind, strange_words

DENIED_ABOVE, LIMITED_ABOVE = r"\text{denies above}", r"\text{limits above}"  # what a text says of the display above it
DENIED = r"\text{denies below}"  # and of the one that it leads to
GENERAL = r"\text{in general}"  # what ends a configuration
FROM_VALUES = r"\text{from values}"  # what leads to what holds at the values that it gives: "For ¤ and ¤ we get"
SUPPOSED = r"\text{under a hypothesis}"  # what is supposed, sought, quoted, of another case, or an approximation
OTHER_POINT = r"\text{of another point}"  # what is no coordinate of the tool in the base
OTHER_FRAME = r"\text{in another frame}"  # what is none of anything in the base
# what is not understood of the display above it, or of the one below; the sentence follows
STRANGE_ABOVE, STRANGE = r"\text{strange above}", r"\text{strange}"
OF_NEXT = (DENIED, SUPPOSED, OTHER_POINT, OTHER_FRAME, STRANGE)  # what is said of one display, and of no configuration

_GENERAL = re.compile(
    r"\b(?:in general|generally|(?:for|in|at|holds for|true for) (?:all|any|every|each|arbitrary) (?:possible )?(?:joint )?"
    r"(?:angles?|values?|configurations?|positions?|postures?|variables?)(?: of the (?:joints|arm|robot|angles))?"
    r"|en général|de (?:façon|manière) générale|(?:pour|dans|en) (?:toutes? (?:les )?)(?:configurations?|positions?|postures?)"
    r"|quel(?:le)?s? que soi(?:en)?t (?:la|les) (?:configuration|position|angles?|valeurs?))\b",
    re.IGNORECASE,
)
_ALTERNATIVES = re.compile(  # $s_3 = 0$ or; a blank is of one part alone, or a list of twenty formulas has a million ways to be none
    r"(?:\s*+(?>\$[^$]+\$|\\\(.+?\\\)|:math:`[^`]+`)(?:\s*+,)?+(?:\s*+(?:oder|or|ou|o|and|und|et|y))?+)+\s*\Z"
)
_FORMULA = re.compile(r"\$\$?[^$]*\$\$?|\\\(.*?\\\)|:math:`[^`]*`")
AXIS = re.compile(
    r"\$\s*([xyz])(?:_0)?\s*\$[ -]?(?:axis|achse|direction|coordinate)|\b([xyz])[ -](?:axis|achse|direction)|\b(?:axe|eje) \$\s*([xyz])(?:_0)?\s*\$"
    r"|(?<=with )\$\s*(y)\s*\$",
    re.IGNORECASE,
)
_LAYOUT = re.compile(
    r"\\(?:begin|end)\s*\{\w+\*?\}|\\[A-Za-z]+\*?|[{}()\[\]\"“”«»*~>|¿¡]|(?<!\w)_+(?=\w)|(?<=\w)_+(?!\w)|(?<!\S)[-–—]+(?!\S)"
)
_ARGUMENTS = re.compile(  # \begin{frame}<2->[fragile]{Title}, \section{Inverse}, ![a figure](arm.png)
    r"\\begin\s*\{\w+\*?\}(?:<[^<>]*>|\[[^\[\]]*\]|\{[^{}]*\})*|\\(?:(?:sub)*section|chapter|paragraph|label|\w*ref|cite|includegraphics|caption|[vh]space|setcounter)\*?"
    r"(?:\[[^\[\]]*\])?\{[^{}]*\}|!\[[^\[\]]*\]\([^()]*\)|<[^<>\s][^<>]{0,200}>"
)
_STOP = re.compile(r"(?<!\\)[.;!?](?=\s+\S)")
_IS_OVER = re.compile(r"[.!]\W*\Z")
_WORDS_WITHIN = re.compile(r"\\(tag\*?|text(?:rm|bf|it|sf|up|normal)?|mbox)\s*\{([^{}]*)\}")
_GAP = r"(?<![,:;] )(?:(?!(?:true|right|correct|valid|holds?|vraie?|exacte?|correcte|richtig|wahr) )[^\s,:;.!?]\S* ){0,4}?"  # no comma, no verdict
_LIGHT = frozenset(re.split(r"[/\s]+", phrases.LIGHT.strip()))
MOST_KNOWN = 4096  # sentences, so that those of a text that is read again are heard once
MOST_CHARACTERS = 500  # of a sentence that is read
_SHORT = 6  # words of one that is heard with the one before it
_LONGEST_QUOTED = 40  # characters of a formula in one that is quoted
_MOST = 14  # words before a denial of what stands above it
_FARTHEST = 10  # and behind one of what stands below


def said_above(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield what a text says of the display that it stands right behind."""
    later = (DENIED_ABOVE,) if _denies_later(text) else ()
    for each in dict.fromkeys((*later, *_heard_behind(_first_sentence(text)))):
        yield Display(line, each, section=section, opening=INLINE)


@lru_cache(maxsize=MOST_KNOWN)
def _heard_behind(sentence: str) -> tuple[str, ...]:
    words = words_of(sentence)
    heard = [DENIED_ABOVE] if _denies_behind(words) else []
    if _limits(words):
        heard.append(LIMITED_ABOVE)
    if DENIED_ABOVE not in heard and is_strange_behind(_plain(sentence)):
        heard.append(STRANGE_ABOVE + sentence)
    return tuple(heard)


def not_known_in(sentence: str) -> list[str]:
    """Return the words for which a sentence is strange."""
    return strange_words(_plain(sentence))


def quoted(sentence: str) -> str:
    """Return a sentence as findings quote it, its long formulas as "…"."""
    return _FORMULA.sub(lambda found: found.group() if len(found.group()) <= _LONGEST_QUOTED else "…", sentence)


def said_in_general(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield that a text speaks of every configuration, if it does."""
    if _GENERAL.search(" ".join(text.split())):
        yield Display(line, GENERAL, section=section, opening=INLINE)


def said_below(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield what the last sentence of a text, formulas and all, says of the display that follows."""
    for each in _heard_before(_leading(text), _before_leading(text)):
        yield Display(line, each, section=section, opening=INLINE)


@lru_cache(maxsize=MOST_KNOWN)
def _heard_before(sentence: str, before: str) -> tuple[str, ...]:
    """Return what a sentence says of the display that it leads to, with the one before it where it is short."""
    words, words_before = words_of(sentence), words_of(before)
    points_below = hears("POINTS_BELOW", words_before) is not None
    is_denied = _denies_before(sentence, words) or (points_below and hears("DENIED_BEFORE", f"{words_before}{words}"))
    heard = [DENIED] if is_denied else []
    if _supposes(words, _IS_OVER.search(sentence) is not None) or hears("MAY_LIMIT", words_before):
        heard.append(SUPPOSED)
    if is_of_other_place(words):
        heard.append(OTHER_POINT)
    if hears("OTHER_FRAME", words) and not hears_denied("OTHER_FRAME", words):
        heard.append(OTHER_FRAME)
    if DENIED not in heard and is_strange_before(_plain(sentence)):
        heard.append(STRANGE + sentence)
    if hears("AT_VALUES", words) or (hears("AT_WORDS", words) and any(joint_values(sentence))):
        heard.append(FROM_VALUES)
    found = _ALTERNATIVES.search(sentence)
    if found is not None and is_of_singularities(sentence[: found.start()].rstrip()):
        heard.append(SINGULAR)
    return tuple(heard)


def denies_above(text: str) -> bool:
    """Whether a text begins with a denial of what stands above it: "This is wrong."."""
    return _denies_behind(words_of(_first_sentence(text)))


def denies_below(text: str) -> bool:
    """Whether a text leads to what it denies: "It is not true that"."""
    sentence = _leading(text)
    return _denies_before(sentence, words_of(sentence))


def _denies_behind(words: str) -> bool:
    return hears("DENIED_BEHIND", words) is not None or _is_error(words) or _denies(words, is_behind=True)


def _denies_later(text: str) -> bool:
    """Whether a later sentence of a text denies what stands above it, and says that it is of that: "The formula above is wrong."."""
    line = " ".join(text.split())[:MOST_CHARACTERS]
    later = map(words_of, _STOP.split(line)[1:]) if len(line) < MOST_CHARACTERS else ()
    return any(hears("ABOVE", words) and _denies_behind(words) for words in later)


def _denies_before(sentence: str, words: str) -> bool:
    if _IS_OVER.search(sentence) and words.count(" ") > 3 and not hears("POINTS_BELOW", words):
        return False
    if hears("DENIED_BEFORE", words) or _denies(words):
        return True
    return not words.rstrip().endswith((":", ".")) and hears("NOT_AT_ITS_END", without_harmless(words)) is not None


def denied_in(latex: str) -> bool:
    """Whether a display denies itself: words in it, under a brace or in its tag, say that it is wrong, or it is crossed out."""
    if re.search(r"\\[bx]?cancel\s*\{(?:[^{}]|\{[^{}]*\})*=", latex):
        return True
    words = _WORDS_WITHIN.findall(latex)
    return any(denies_within(said) or (kind.startswith("tag") and "?" in said) for kind, said in words)


def denies_within(text: str) -> bool:
    """Whether words in a display deny what stands beside them: (wrong), \\text{which is false}."""
    if len(text) > MOST_CHARACTERS:
        return True  # more than is read may deny
    words = words_of(text)
    return _denies(words) or _is_error(words)


def without_harmless(text: str) -> str:
    """Return the words of a text without its denials that deny nothing: "not trivial", "no approximation"."""
    return _harmless().sub("", words_of(text))


def _plain(sentence: str) -> str:
    """Return the words of a sentence without what denies nothing, headings, and the arguments of environments and commands."""
    return without_harmless(_ARGUMENTS.sub(" ", sentence))


def _is_error(words: str) -> bool:
    return re.fullmatch(r"(?:error|erreur|fehler|typo|nope|no|non|nein|×) (?:[!.] )?", words, re.IGNORECASE) is not None


def heading_denies(section: str) -> bool:
    """Whether a heading says that what stands below it is wrong: "A common mistake"."""
    words = words_of(section)
    return hears("DENYING_HEADING", words) is not None or (hears("WRONG", words) is not None and _denies(words))


def is_denied_by_headings(section: str) -> bool:
    """Whether the heading of a section denies what stands below it, or one around it does and its own does not say that it is right."""
    around = sections_around(section) if hears("TRUE", words_of(section)) is None else ()
    return any(map(heading_denies, (section, *around)))


def is_of_a_case(section: str) -> bool:
    """Whether the heading of a section says that what stands there holds in one case alone."""
    return hears("CASE", words_of(section)) is not None


def is_of_other_place(words: str) -> bool:
    """Whether a sentence is of another point, frame or origin than the tool in the base, and does not say that it is not."""
    return any(
        hears(place, words) and not hears_denied(place, words)
        for place in ("OTHER_POINT", "OTHER_FRAME", "OTHER_ORIGIN")
    )


def _first_sentence(text: str) -> str:
    """Return the first sentence of a text on one line, its stop with it, or part of one before a semicolon."""
    line = " ".join(text.split())
    stop = _STOP.search(line)
    return (line if stop is None else line[: stop.end()])[:MOST_CHARACTERS]


def _leading(text: str) -> str:
    """Return the last sentence of a text on one line, which leads to what comes next."""
    return _STOP.split(" ".join(text.split()))[-1][-MOST_CHARACTERS:]


def _before_leading(text: str) -> str:
    """Return the sentence that a short last one goes on from: "Then we get" says little alone."""
    *before, last = _STOP.split(" ".join(text.split()))
    is_short = words_of(last).count(" ") <= _SHORT or hears("THEN", words_of(last))
    return before[-1][-MOST_CHARACTERS:] if before and is_short else ""


def words_of(text: str) -> str:
    """Return a sentence word by word, each with a blank behind it: formulas as ¤, x-axis one word, marks of their own."""
    text = with_axes(text)
    text = _FORMULA.sub(lambda found: " ¤ ≪ " if "\\ll" in found.group() else " ¤ ", text)
    text = _LAYOUT.sub(" ", text.replace("’", "'").replace("'", "' "))
    return " ".join(re.sub(r"([,:.;!?])(?=\s|\Z|[,:.;!?])", r" \1 ", text).split()) + " "


def with_axes(text: str) -> str:
    """Return a text in which the $x$ axis is the x-axis."""
    return AXIS.sub(lambda found: f"{next(filter(None, found.groups()))}-axis", text)


def _denies(words: str, is_behind: bool = False) -> bool:
    """Whether a sentence denies: it has a word for what is wrong, or "not" and a word for what is true, and no remedy behind it.

    "Nothing is wrong" and "not only" do not; behind a display what is denied must be that, and not so in some case alone.
    """
    tags = [(str(found.lastgroup), found.start(), found.end()) for found in _tagged().finditer(words.lower())]
    for place, (tag, start, end) in enumerate(tags):
        follower, begin, stop = tags[place + 1] if place + 1 < len(tags) else ("", 0, 0)
        if tag == "NOT" and follower == "TRUE" and words.count(" ", end, begin) <= 2:
            end = stop
        elif tag == "TRUE" and is_behind:
            return False
        elif tag not in ("WRONG", "DENIAL"):
            continue
        if is_behind:
            before, behind = words[:start].split(), words[end:].split()
            is_of_it = len(before) <= _MOST and all(not each.isalnum() or each.lower() in _LIGHT for each in before)
            return is_of_it and behind[:1] != ["¤"] and (behind or [""])[0].lower() not in _elsewhere()
        if words.count(" ", end) <= _FARTHEST and not any(other == "REMEDY" and at >= end for other, at, _ in tags):
            return True
    return False


def _supposes(words: str, is_over: bool) -> bool:
    """Whether the sentence before a display supposes it, asks for it, or says that it is of a case or nearly so."""
    if words.endswith("? ") or hears("SUPPOSED", words) or (hears("ON_CONDITION", words) and not hears("WE_DO", words)):
        return True
    if (hears("NEARLY", words) and not hears_denied("NEARLY", words)) or hears("SPECIAL", words):
        return True
    if hears("MAY_LIMIT", words):
        return True
    return not is_over and any(hears(each, words) for each in ("OF_A_PART", "OF_NO_CLAIM"))


def _limits(words: str) -> bool:
    """Whether a sentence that goes on from the display above it says when, or how nearly, that holds; or asks whether."""
    is_question = words.endswith("? ") and not hears("OPEN_QUESTION", words)
    if is_question or any(hears(each, words) for each in ("ASKED_BEHIND", "SPECIAL", "SAYS_LIMITS")):
        return True
    if hears("MAY_LIMIT", words):
        return True
    is_short, goes_on = words.count(" ") <= 6, words[:1].islower()
    if goes_on and hears("LIMITED_BEHIND", words):
        return True
    return (goes_on or is_short) and hears("NEARLY", words) is not None and not hears_denied("NEARLY", words)


def hears(name: str, words: str) -> re.Match[str] | None:
    """Return where a phrase of a table stands in the words of a sentence."""
    return _phrases(name).search(words.lower())


def hears_denied(name: str, words: str) -> bool:
    """Whether "not" or "no" stands shortly before a phrase of a table, or in it."""
    found = _phrases(name).search(words.lower())
    if found is None:
        return False
    before = words[: found.start()].split()[-4:]
    return hears("NOT", f"{' '.join([*before, found.group()])} ") is not None


@cache
def _harmless() -> re.Pattern[str]:
    return re.compile(_pattern(phrases.HARMLESS), re.IGNORECASE)


@cache
def _elsewhere() -> frozenset[str]:
    return frozenset(re.split(r"[/\s]+", phrases.ELSEWHERE.strip()))


@cache
def _tagged() -> re.Pattern[str]:
    """Return the pattern of the phrases that make up a denial, a group a kind; what is harmless goes first."""
    kinds = ("HARMLESS", "DENIAL", "WRONG", "NOT", "TRUE", "REMEDY")
    return re.compile("|".join(f"(?P<{kind}>{_pattern(getattr(phrases, kind))})" for kind in kinds))


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
