r"""Letters that a sentence gives another meaning for a while: "In this section $\theta_3$ is counted from the stretched arm".

A sentence that says for how long tells a change; what a document says of its letters where they first stand, "$l_1$ is the length of the first link",
tells none. What the letter means then is not read: nothing that is written with it is decided.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.patterns import regex

MAY_RENAME = regex(  # what no such sentence lacks, in small letters
    r"section|paragra|this (?:part|task|exercise|example|chapter|time)|rest|remainder|once|moment|henceforth|hereafter|from (?:now|here)|now\b|letter|lettre|buchstabe"
    r"|partie|suite|désormais|dorénavant|fois|exercice|exemple|abschnitt|absatz|diese[mr]|ab (?:jetzt|hier)|nun an|diesmal|ausnahms"
    r"|sección|apartado|párrafo|ejercicio|ejemplo|ahora|aquí|una vez|sezione|esercizio|poi|volta"
)
_OF_SECTION = regex(  # it ends with the section in which it stands
    r"\b(?:(?:in|for|throughout) this (?:section|paragraph|part|task|exercise|example|chapter)"
    r"|dans (?:cette (?:section|partie)|ce paragraphe|cet (?:exercice|exemple))|in diesem (?:abschnitt|absatz|teil|kapitel|beispiel)"
    r"|in dieser aufgabe|en (?:esta sección|este (?:apartado|párrafo|ejercicio|ejemplo))|in quest(?:a sezione|o paragrafo|o esercizio))\b"
)
_FROM_HERE = regex(
    r"\b(?:(?:in|for) the (?:rest|remainder) of th(?:e|is)|for once|for a moment|from (?:now|here) on(?:wards?)?|henceforth|hereafter|this time"
    r"|now(?= .*\b(?:measured|counted|reckoned|numbered|stands? for|denotes?)\b)"
    r"|dans (?:la suite|le reste)|désormais|dorénavant|pour une fois|cette fois|ab (?:jetzt|hier)|diesmal|von nun an|ausnahmsweise"
    r"|a partir de (?:ahora|aquí)|por una vez|d' ora in poi|questa volta|per una volta)\b"
)
_SAYS_WHAT = regex(
    r"\b(?:is|are|stands?|denotes?|means?|designates?|counts?|counted|measured|reckoned|numbered?|lettered|called|stays?|remains?"
    r"|est|sont|désignent?|mesurée?s?|comptée?s?|numérotée?s?|vaut|ist|sind|bezeichnet|bezeichnen|gezählt|gemessen|nummeriert|heißt|steht"
    r"|es|son|denotan?|designan?|miden?|cuentan?|numerados|è|sono|denotano|indicano|indica|misurat[oaie]|contat[oaie])\b"
)
_LETTER_STAYS = regex(r"\bthe letters? (?:stays?|remains?) ¤|\bla lettre reste ¤|\bder buchstabe bleibt ¤")
_LONE = regex(r"\\?[A-Za-z]+(?:\s*_\s*(?:\{\s*\w+\s*\}|\w))?")


def holds_from_here(words: str) -> bool:
    """Whether a sentence says that something is so from here on, and so was not before."""
    return _FROM_HERE.search(words.lower()) is not None


def holds_in_section(words: str) -> bool:
    """Whether a sentence says that something is so in its section."""
    return _OF_SECTION.search(words.lower()) is not None


def letters_anew(words: str, formulas: Sequence[str]) -> tuple[tuple[str, ...], bool]:
    r"""Return the letters to which a sentence gives another meaning, as LaTeX, and whether it does so for its section alone.

    "In this section $l_1 = l_2$" gives none another: a condition is no letter alone.
    """
    small = words.lower()
    lone = tuple(each.strip() for each in formulas if _LONE.fullmatch(each.strip()))
    if not lone:
        return (), False
    if _LETTER_STAYS.search(small):
        return lone, True
    is_of_section = holds_in_section(small)
    if (is_of_section or _FROM_HERE.search(small)) and _SAYS_WHAT.search(small):
        return lone, is_of_section
    return (), False
