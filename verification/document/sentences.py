"""What sentences say of the display that they lead to, follow or stand in: "It is not true that", "Suppose that", "to first order".

The phrases are those of `phrases.py`; `hearing.py` hears them, `denials.py` tells what denies.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from armproof.verification.document.arms_called import CALLED, arms_called
from armproof.verification.document.clauses import clauses, is_of_display, says_what_would_be
from armproof.verification.document.denials import denies_before, denies_behind, denies_later, faults_another
from armproof.verification.document.denying_clauses import judges_in_other_words, leads_on
from armproof.verification.document.hearing import (
    FORMULA,
    IS_OVER,
    before_leading,
    first_sentence,
    formulas_of,
    hears,
    leading,
    says,
    with_axes,
    without,
    without_harmless,
    words_of,
)
from armproof.verification.document.joint_values import joint_values
from armproof.verification.document.limiting_clauses import (
    is_whole,
    limits_what_is_above,
    limits_what_is_below,
    limits_what_is_near,
)
from armproof.verification.document.model import INLINE, Display
from armproof.verification.document.moving_on import said_of_motion
from armproof.verification.document.named_quantities import NAMED
from armproof.verification.document.strange import is_strange_before, is_strange_behind, strange_words
from armproof.verification.document.subjects import (
    OTHER_BASE,
    OTHER_PLACE,
    places_of_those,
    subjects,
    without_tool_frame,
)
from armproof.verification.document.told_motions import may_tell_motion, told_motion, without_motion
from armproof.verification.document.told_origins import LETTER_OF_HEIGHT, shift_of_base
from armproof.verification.document.told_singularities import (
    SINGULAR,
    is_of_singularities,
    singularities_told,
    without_place,
)
from armproof.verification.patterns import regex

DENIED_ABOVE, LIMITED_ABOVE = r"\text{denies above}", r"\text{limits above}"  # what a text says of the display above it
FAULTED_ABOVE = r"\text{faults above}"  # or of something that may be that
DENIED = r"\text{denies below}"  # and of the one that it leads to
GENERAL = r"\text{in general}"  # what ends a configuration
FROM_VALUES = r"\text{from values}"  # what leads to what holds at the values that it gives: "For ¤ and ¤ we get"
NOT_THERE = r"\text{not there}"  # what may lead elsewhere than to values of a heading: "Away from this case"
SUPPOSED = r"\text{under a hypothesis}"  # what is supposed, sought, quoted, of another case, or an approximation
OTHER_POINT = r"\text{of another point}"  # what is no coordinate of the tool in the base
OTHER_FRAME = r"\text{in another frame}"  # what is none of anything in the base
# what is not understood of the display above it, or of the one below; the sentence follows
STRANGE_ABOVE, STRANGE = r"\text{strange above}", r"\text{strange}"
PROSE = r"\text{prose}"  # that there are words between two displays: without them what leads to one leads to the next
MEANT = r"\text{meant}"  # of which link it is, which quantity, or what is done to it; that follows
SAME_POINT = "same point"  # of the point that the display above is of: "Its velocity is"
EVERYWHERE = "everywhere"  # what is said of every configuration
WOULD_BE = "would be"  # of another case than that at hand: it says there what a letter is
ABOVE = r"\text{above}"  # before a place or a quantity that is said of the display above
OF_ABOVE = (DENIED_ABOVE, FAULTED_ABOVE, LIMITED_ABOVE, STRANGE_ABOVE, ABOVE)
OF_NEXT = (
    DENIED,
    SUPPOSED,
    OTHER_POINT,
    OTHER_FRAME,
    MEANT,
    STRANGE,
)  # what is said of one display, and of no configuration

_GENERAL = regex(
    r"\b(?:in general|generally|(?:for|in|at|holds for|true for) (?:all|any|every|each|arbitrary) (?:possible )?(?:joint )?"
    r"(?:angles?|values?|configurations?|positions?|postures?|variables?)(?: of the (?:joints|arm|robot|angles))?"
    r"|en général|de (?:façon|manière) générale|(?:pour|dans|en) (?:toutes? (?:les )?)(?:configurations?|positions?|postures?)"
    r"|quel(?:le)?s? que soi(?:en)?t (?:la|les) (?:configuration|position|angles?|valeurs?))\b",
    re.IGNORECASE,
)
_COMPARES = regex(r"[=≠<>≈]|\\(?:neq?|not|[lg]eq?|setminus)(?![A-Za-z])")
_OF_THE_SAME = regex(
    r"\W*(?:(?:and|so|then|thus|hence|so that|et|donc|alors|und|y|e) )?(?:its|their|sa|son|ses|seine?|ihre?|su|sus|(?:la |il |le )?su[aoe]i?|(?:a |o )?seus?) \S",
    re.IGNORECASE,
)
_NAMES_TOOL = regex(
    r"(?<!\S)(?:tool|tip|end[ -]effector|gripper|hand|outil|l' outil|effecteur|l' effecteur|pince|werkzeugs?|greifers?|herramienta|efector|utensile|pinza) "
)
_WORD = regex(r"[^\W\d_]+")
_ALTERNATIVES = (
    regex(  # $s_3 = 0$ or; a blank is of one part alone, or a list of twenty formulas has a million ways to be none
        r"(?:\s*+(?>\$[^$]+\$|\\\(.+?\\\)|:math:`[^`]+`)(?:\s*+,)?+(?:\s*+(?:oder|or|ou|o|and|und|et|y))?+)+\s*\Z"
    )
)
_ARGUMENTS = regex(  # \begin{frame}<2->[fragile]{Title}, \section{Inverse}, ![a figure](arm.png)
    r"\\begin\s*\{\w+\*?\}(?:<[^<>]*>|\[[^\[\]]*\]|\{[^{}]*\})*|\\(?:(?:sub)*section|chapter|paragraph|label|\w*ref|cite|includegraphics|caption|[vh]space|setcounter)\*?"
    r"(?:\[[^\[\]]*\])?\{[^{}]*\}|!\[[^\[\]]*\]\([^()]*\)|<[^<>\s][^<>]{0,200}>"
)
# a label, and no "est corrigé plus bas"
_ANSWER = regex(r"\A[\W_]*(?:Corrigé|Svolgimento|Musterlösung)[\s*_}]*[.:][\s*_}]*(?=\w)")
_QUESTION = regex(  # *Question 2.* What is asked behind it is asked of what comes
    r"\A[\W_]*(?:Question|Exercise|Exercice|Frage|Aufgabe|Übung|Pregunta|Ejercicio|Domanda|Esercizio|Pergunta|Exercício)(?:\s*\d+)?[\s*_}]*[.:)][\s*_}]*(?=\w|¿)"
)
_LISTS_VALUES = regex(  # a sentence of formulas alone, with their units, behind a label
    r"(?:(?:\W{1,2}|\w{1,2}|numerical|worked|test|check|numbers?|values?|data|application|examples?|question|zahlen\w*|werte|beispiel|exemple|valeurs|données|num[eé]ri\w+|ejemplo|datos|valores|esempio|dati|valori|exemplo|dados) )*?"
    r"(?:(?:with|for|let|take|put|given|avec|pour|soit|soient|prenons|mit|für|sei|seien|con|para|sea|sean|per|sia|siano|com|seja|sejam) )?"
    r"(?:¤ (?:(?:mm|cm|m|rad|deg|degrees|degrés|grad|kg|n|nm|n m|rad/s|m/s|°/s) )?(?:(?:, |; )?(?:and |et |und |y |e )?(?:with |for |at |avec |pour |mit |für |bei |con |para |per |com )?)){2,}[:.,]? ?\Z",
    re.IGNORECASE,
)
_MISTAKE = regex(  # **Mistake 2.** of a list of them: what stands behind it is one
    r"[\W_]*(?:(?:textbf|textit|emph|paragraph|item)\W*)*(?:mistake|error|pitfall|trap|slip|erreur|faute|piège|fehler|falle|errore|erro|trampa)\s*(?:n°|nr\.?|no\.?|#)?\s*\d+\s*[.:)–—]",
    re.IGNORECASE,
)
_JOINING = frozenset("and or et ou und oder y o e ed bzw resp".split())
_OF_LETTERS = regex(
    r"angle|ángulo|ângulo|angol|winkel|measur|count|mesur|compt|mess|zähl|medid|length|longu|läng|lungh|absol|assol|convention|letter|symbol|lettre|zeichen|letra|letter"
)
_SUPPOSING = ("MAY_LIMIT", "SOUGHT", "CHANGED_BEFORE", "HELD_IN_WORDS")
_FOR = regex(r"(?<!\S)(?:for|pour|für|para|per) ")  # "The formula for the ordinate follows"
_MOST_OF_LABEL = 4  # words with their stop: "The elbow."
MOST_KNOWN = 4096  # sentences, so that those of a text that is read again are heard once
_LONGEST_QUOTED = 40  # characters of a formula in one that is quoted


def said_above(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield what a text says of the display that it stands right behind."""
    later = (DENIED_ABOVE,) if denies_later(text) else ()
    for each in dict.fromkeys((*later, *_heard_behind(first_sentence(text)))):
        yield Display(line, each, section=section, opening=INLINE)


@lru_cache(maxsize=MOST_KNOWN)
def _heard_behind(sentence: str) -> tuple[str, ...]:
    if _MISTAKE.match(sentence):
        return ()
    words = words_of(_QUESTION.sub("", sentence))
    heard = [FAULTED_ABOVE if faults_another(words) else DENIED_ABOVE] if denies_behind(words) else []
    if _limits(words):
        heard.append(LIMITED_ABOVE)
    if is_of_display(words):
        heard += (ABOVE + each for each in _subjects(sentence, words) if not (_FOR.search(words) and NAMED in each))
    is_of_next = leads_on(words) and denies_before(sentence, words)
    is_open = not ({DENIED_ABOVE, FAULTED_ABOVE} & {*heard}) and not is_of_next
    if is_open and is_strange_behind(_plain(sentence)):
        heard.append(STRANGE_ABOVE + sentence)
    elif is_open and judges_in_other_words(words):
        heard.append(DENIED_ABOVE)
    return tuple(heard)


def not_known_in(sentence: str) -> list[str]:
    """Return the words for which a sentence is strange."""
    return strange_words(_plain(sentence))


def quoted(sentence: str) -> str:
    """Return a sentence as findings quote it, its long formulas as "…"."""
    return FORMULA.sub(lambda found: found.group() if len(found.group()) <= _LONGEST_QUOTED else "…", sentence)


def said_in_general(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield that a text speaks of every configuration, or of another than before, and of which arm, if it does."""
    if _GENERAL.search(" ".join(text.split())):
        yield Display(line, GENERAL, section=section, opening=INLINE)
    for each in said_of_motion(text):
        yield Display(line, each, section=section, opening=INLINE)
    for names in arms_called(text):
        yield Display(line, f"{CALLED}{' '.join(sorted(names))}}}", section=section, opening=INLINE)
    if _is_prose(text):
        yield Display(line, PROSE, section=section, opening=INLINE)


def _is_prose(text: str) -> bool:
    """Whether a text says anything: more than "and", "(b)" or a command that sets it apart."""
    words = words_of(_ARGUMENTS.sub(" ", text)).lower()
    return any(len(word) > 1 and word not in _JOINING for word in _WORD.findall(words)) or "¤" in words


def said_below(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield what the last sentence of a text, formulas and all, says of the display that follows."""
    if not text.strip():
        return
    for each in (*_heard_before(leading(text), before_leading(text)), *singularities_told(text)):
        yield Display(line, each, section=section, opening=INLINE)


@lru_cache(maxsize=MOST_KNOWN)
def _heard_before(sentence: str, before: str) -> tuple[str, ...]:
    """Return what a sentence says of the display that it leads to, with the one before it where it is short."""
    sentence = _ANSWER.sub("", sentence)
    words, words_before = words_of(sentence), words_of(before)
    points_below = hears("POINTS_BELOW", words_before) is not None
    is_denied = denies_before(sentence, words) or (points_below and hears("DENIED_BEFORE", f"{words_before}{words}"))
    heard = [DENIED] if is_denied or _MISTAKE.match(sentence) else []
    if (
        _supposes(without_motion(words_of(without_place(sentence))), IS_OVER.search(sentence) is not None)
        or hears("MAY_LIMIT", words_before)
        or limits_what_is_near(words_before)
        or (may_tell_motion(words) and not told_motion(words))
        or (hears("THEN", words) and says_what_would_be(words_before))
    ):
        heard.append(SUPPOSED)
    if motion := told_motion(words) or (hears("THEN", words) and told_motion(words_before)):
        heard.append(MEANT + motion)
    if says_what_would_be(words, at_its_end=True):
        heard.append(MEANT + WOULD_BE)
    if _is_of_all(sentence, words) or (hears("THEN", words) and _is_of_all(before, words_before)):
        heard.append(MEANT + EVERYWHERE)
    if is_of_other_place(words, formulas_of(with_axes(sentence))) or (
        hears("OF_THE_ONE_BEFORE", words) and is_of_other_place(words_before, formulas_of(with_axes(before)))
    ):
        heard.append(OTHER_POINT)
    if _OF_THE_SAME.match(words) and not any(_NAMES_TOOL.search(each.lower()) for each in (words, words_before)):
        heard.append(MEANT + SAME_POINT)
    if says("OTHER_FRAME", without_tool_frame(words)):
        heard.append(OTHER_FRAME)
    is_label = words.count(" ") <= _MOST_OF_LABEL
    own = words_of(_ARGUMENTS.sub(" ", sentence))
    if is_label or IS_OVER.search(sentence) is None or hears("ASKED_FOR", own):
        heard += _subjects(sentence, words)
    heard += (OTHER_POINT for each in places_of_those(words) if each == OTHER_PLACE)
    if DENIED not in heard and is_strange_before(_plain(sentence)):
        heard.append(STRANGE + sentence)
    if _is_at_values(own, words_before) or (hears("AT_WORDS", words) and any(joint_values(sentence))):
        heard.append(FROM_VALUES)
    elif _leads_away(words, words_before):
        heard.append(NOT_THERE)
    found = _ALTERNATIVES.search(sentence)
    if found is not None and is_of_singularities(sentence[: found.start()].rstrip()):
        heard.append(SINGULAR)
    return tuple(heard)


def _is_of_all(sentence: str, words: str) -> bool:
    """Whether a sentence says that something is so in every configuration, and leaves none out: no formula of it compares anything."""
    compares = any(_COMPARES.search(found.group()) for found in FORMULA.finditer(sentence))
    return not compares and hears("EVERYWHERE", words) is not None and hears("BUT_SOMEWHERE", words) is None


def _leads_away(words: str, words_before: str) -> bool:
    """Whether a sentence, or the one before it where it is short, may lead elsewhere than to values that are given."""
    return any(hears("NOT_THERE", each) for each in (words, words_before))


def _is_at_values(words: str, words_before: str) -> bool:
    """Whether a sentence leads to what holds at the values that it gives, or, being short, the one before it."""
    if _leads_away(words, words_before) or hears("GOAL", words.rpartition("¤")[2]):
        return False
    plain = without("OF_A_POSTURE", words)
    if _LISTS_VALUES.match(words) or _LISTS_VALUES.match(words_before):  # "Numbers: ¤ m, ¤ m, ¤. The speed is"
        return True
    if hears("AT_VALUES", plain) or (IS_OVER.search(words) and hears("GIVES_VALUES", plain)):
        return True
    goes_on = hears("THEN", words) or hears("BECOMES", words)
    return goes_on is not None and hears("GIVES_VALUES", without("OF_A_POSTURE", words_before)) is not None


@lru_cache(maxsize=MOST_KNOWN)
def said_within(text: str) -> tuple[str, ...]:
    """Return of what place or quantity words within a display are."""
    return (*said_by_heading(text), *_subjects(text, words_of(text)))


@lru_cache(maxsize=MOST_KNOWN)
def said_by_heading(text: str) -> tuple[str, ...]:
    """Return of what place a heading is; under "The wrist" or "The inverse Jacobian" stands much that is not of that."""
    words = words_of(text)
    heard = [
        marker for marker, name in ((OTHER_POINT, "OTHER_POINT"), (OTHER_FRAME, "OTHER_FRAME")) if says(name, words)
    ]
    return (*heard, *(each for each in _subjects(text, words) if not each.startswith(MEANT)))


def _subjects(sentence: str, words: str) -> Iterator[str]:
    """Yield of what place a sentence is, and of what quantity, where that is not the tool in the base."""
    markers = {OTHER_PLACE: OTHER_POINT, OTHER_BASE: OTHER_FRAME}
    formulas = [found.group().strip("$") for found in FORMULA.finditer(sentence)]
    yield from (markers.get(each, MEANT + each) for each in dict.fromkeys(subjects(words, formulas)))


def _plain(sentence: str) -> str:
    """Return the words of a sentence without what denies nothing, headings, and the arguments of environments and commands."""
    return without_harmless(_ARGUMENTS.sub(" ", sentence))


def is_of_a_case(section: str) -> bool:
    """Whether the heading of a section says that what stands there holds in one case alone."""
    return hears("CASE", words_of(section)) is not None


@lru_cache(maxsize=MOST_KNOWN)
def values_of(section: str) -> tuple[str, ...]:
    """Return the values at which all holds that stands under a heading, as formulas: those of "Case 1: $\\theta_2 = 0$"."""
    words = words_of(section)
    if not (hears("OF_VALUES", words) or hears("OF_VALUES", without("OF_A_POSTURE", words))):
        return ()
    return tuple(found.group().strip("$") for found in FORMULA.finditer(section))


def is_of_other_place(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence is of another point, frame or origin than the tool in the base, and does not say that it is not; a shoulder at the height $h$ may be the arm's."""
    if any(says(place, without_tool_frame(words)) for place in ("OTHER_POINT", "OTHER_FRAME")):
        return True
    return says("OTHER_ORIGIN", words) and not LETTER_OF_HEIGHT.fullmatch(shift_of_base(words, formulas))


def _supposes(words: str, is_over: bool) -> bool:
    """Whether the sentence before a display supposes it, asks for it, or says that it is of a case or nearly so."""
    if words.endswith("? ") or hears("SUPPOSED", words) or (hears("ON_CONDITION", words) and not hears("WE_DO", words)):
        return True
    if says("NEARLY", words) or any(hears(each, words) for each in _SUPPOSING):
        return True
    plain = without_harmless(words)
    if is_over:
        return limits_what_is_near(plain)
    is_claim = is_whole(plain) or hears("ITS_ANSWER", words)
    is_no_claim = hears("OF_A_PART", words) or (hears("OF_NO_CLAIM", words) and not is_claim)
    return bool(is_no_claim) or limits_what_is_below(plain)


def _is_of_next(words: str) -> bool:
    """Whether a sentence leads to the next display, of which alone it says when, or where, it holds: what it says of angles or lengths holds of both."""
    begins = words[:1].isupper() or hears("AND_ITS", words) is not None
    if not begins or not (words.endswith(": ") or hears("LEADS_ON", words)):
        return False
    first = next(iter(clauses(words)), None)
    if first is None or first.is_of_display or first.begins("pronoun"):
        return False
    limit = hears("MAY_LIMIT", words)
    return limit is None or _OF_LETTERS.search(limit.group()) is None


def _asks_for_reason(words: str) -> bool:
    """Whether a question asks why something is so that it takes for so: "Why does c_{23} appear?", and not "Why would it?"."""
    found = clauses(words)
    is_doubt = any(each.has("not", "would", "only", "good", "fault", "error", "if") for each in found)
    return hears("REASON_ASKED", words) is not None and not is_doubt and not any(each.is_of_display for each in found)


def _limits(words: str) -> bool:
    """Whether a sentence that goes on from the display above it says when, or how nearly, that holds; or asks whether."""
    if _is_of_next(words) or (words.endswith("? ") and hears("SINGULAR_ASKED", words)):
        return False
    is_question = words.endswith("? ") and not (hears("OPEN_QUESTION", words) or _asks_for_reason(words))
    if is_question or any(hears(each, words) for each in ("ASKED_BEHIND", "SAYS_LIMITS")):
        return True
    leads_on = words[:1].isupper() and not words.endswith((". ", "? ", "! "))  # to the next: "The pose of the frame is"
    if hears("MAY_LIMIT", words) and not leads_on:
        return True
    if limits_what_is_above(without_harmless(words)):
        return True
    is_short, goes_on = words.count(" ") <= 6, words[:1].islower()
    if goes_on and hears("LIMITED_BEHIND", words):
        return True
    return (goes_on or is_short) and says("NEARLY", words)
