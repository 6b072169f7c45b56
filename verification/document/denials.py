"""What denies a display: a sentence before or behind it, a heading, or words in it: "It is not true that", "This is wrong."."""

from __future__ import annotations

import re

from armproof.verification.document.denying_clauses import (
    denies_as_heading,
    denies_beside,
    denies_what_is_above,
    denies_what_is_below,
    finds_fault_with_another,
    lists_mistakes,
)
from armproof.verification.document.heading import sections_around
from armproof.verification.document.hearing import (
    IS_OVER,
    MOST_CHARACTERS,
    STOP,
    first_sentence,
    hears,
    leading,
    without_harmless,
    words_of,
)
from armproof.verification.document.marked_wrong import WRONG
from armproof.verification.patterns import regex

_WORDS_WITHIN = regex(r"\\(tag\*?|text(?:rm|bf|it|sf|up|normal)?|mbox)\s*\{([^{}]*)\}")
_NOT_TO_COPY = regex(  # what a heading or a title says of what is no claim
    r"\b(?:(?:do not|don't|never) (?:copy|use|write|memori[sz]e|repeat)|not to be (?:copied|used)|withdrawn|superseded|(?:ne|à ne) (?:pas|jamais) (?:re)?(?:copie[rz]|utilise[rz]|écri\w+|faire)|nicht (?:so )?(?:schreiben|kopieren|verwenden|abschreiben)"
    r"|no (?:copiar|usar|copie|copies)\b|non (?:copiare|usare)|não (?:copiar|usar|copie))",
    re.IGNORECASE,
)


def denies_above(text: str) -> bool:
    """Whether a text begins with a denial of what stands above it: "This is wrong."."""
    return denies_behind(words_of(first_sentence(text)))


def denies_below(text: str) -> bool:
    """Whether a text leads to what it denies: "It is not true that"."""
    sentence = leading(text)
    return denies_before(sentence, words_of(sentence))


def denies_behind(words: str) -> bool:
    """Whether the words of a sentence deny the display that it stands behind."""
    return (
        hears("DENIED_BEHIND", words) is not None or _is_error(words) or denies_what_is_above(without_harmless(words))
    )


def faults_another(words: str) -> bool:
    """Whether the words of a sentence that seem to deny the display above them find fault with something else."""
    is_certain = hears("DENIED_BEHIND", words) is not None or _is_error(words)
    return not is_certain and finds_fault_with_another(without_harmless(words))


def denies_later(text: str) -> bool:
    """Whether a later sentence of a text denies what stands above it, and says that it is of that: "The formula above is wrong."."""
    line = " ".join(text.split())[:MOST_CHARACTERS]
    later = map(words_of, STOP.split(line)[1:]) if len(line) < MOST_CHARACTERS else ()
    return any(hears("ABOVE", words) and denies_behind(words) for words in later)


def denies_before(sentence: str, words: str) -> bool:
    """Whether a sentence, with its words, denies the display that it leads to; one that is over does if it points below."""
    if IS_OVER.search(sentence) and words.count(" ") > 3 and not hears("POINTS_BELOW", words):
        return False
    return hears("DENIED_BEFORE", words) is not None or denies_what_is_below(without_harmless(words))


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
    return _is_error(words) or denies_beside(without_harmless(words)) or is_not_to_copy(text)


def is_not_to_copy(text: str) -> bool:
    """Whether a title says that what it stands above is not to be copied, or is withdrawn."""
    return _NOT_TO_COPY.search(text) is not None


def heading_may_deny(section: str) -> bool:
    """Whether a heading is of mistakes and of another thing: "The first three joints, and four mistakes"; which stands below it tells the text."""
    around = sections_around(section) if hears("TRUE", words_of(section)) is None else ()
    return any(lists_mistakes(without_harmless(words_of(each))) for each in (section, *around))


def heading_denies(section: str) -> bool:
    """Whether a heading says that what stands below it is wrong: "A common mistake"."""
    words = words_of(section)
    if is_not_to_copy(section) or WRONG.search(section) is not None:
        return True
    if lists_mistakes(without_harmless(words)):
        return False
    return hears("DENYING_HEADING", words) is not None or denies_as_heading(without_harmless(words))


def is_denied_by_headings(section: str) -> bool:
    """Whether the heading of a section denies what stands below it, or one around it does and its own does not say that it is right."""
    around = sections_around(section) if hears("TRUE", words_of(section)) is None else ()
    return any(map(heading_denies, (section, *around)))


def _is_error(words: str) -> bool:
    return re.fullmatch(r"(?:error|erreur|fehler|typo|nope|no|non|nein|×) (?:[!.] )?", words, re.IGNORECASE) is not None
