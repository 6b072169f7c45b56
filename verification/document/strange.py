"""Sentences beside a display that are not understood: their words are not those in which a course leads to an equation, or speaks of one.

What denies or limits a display in words of `phrases.py` is heard. Vocabulary does not end, "Half the class lost two marks by
ending up with", so what such a sentence says of the display is not known, and the display is left open.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache

import armproof.verification.document.vocabulary as vocabulary
from armproof.verification.document.clauses import is_weighed
from armproof.verification.patterns import regex

_WORD = regex(r"[^\W\d_][\w'-]*")
# a letter that is not Latin: of words in Cyrillic, Greek, Arabic, Thai, Hangul, Kana, Han
_OF_OTHER_SCRIPT = regex(r"[^\W\d_A-Za-zªµºÀ-ɏḀ-ỿℓ]")
# letters that words of one family have in common
_PREFIXES = {"ENGLISH": 7, "FRENCH": 6, "GERMAN": 6, "SPANISH": 6, "ITALIAN": 6, "PORTUGUESE": 6}
_SHORT = 8  # words of a sentence that says little else than what becomes of the display
_HEAD = 20  # and of a sentence of the display that are looked at
_FEW = 5  # and of one that leads to the display
_RATIO = 9  # of how many words of a longer sentence one is not known where it is not understood
_SUBJECT = 5  # words of a sentence of the arm within which a word for a part of it stands
_RATIO_OF_ARM = 5  # of how many words of such a one
_MANY = 50  # words of a text that tell its language
_NO_WORDS = regex(
    r":[a-z:]+:(?=`)|\b\w{1,3}[₀-₉ₙᵢ]+|[α-ωΑ-Ω]\w{0,2}\b|\b\d\w*|https?:\S*|\S+\.(?:png|jpe?g|svg|eps|pdf|gif|md|py|m)\b|\S*[/_=]\S*|`[^`]*`|\b[lcr]{2,}\b|\b(?:turns?|rotates?|spins?|moves?|runs?) the other way\b|\b(?:kg|mm|cm|mod)\b"
)
_OF_ARM_ANYWAY = regex(  # what takes nothing back, though its words alone could: what the arm or its Jacobian loses, where a target else lies, what is not needed
    r"\b(?:los(?:es?|ing|t|s of)|perd(?:ent|re|ant|u)?|perde(?:r|re|m)?|perdono|pierden?|perte d[eu]|pérdida de|perdita di|perda de|verlier(?:t|en))(?= (?:(?!(?:and|et|und|y|e) )[^\W\d_]+ ){0,3}?(?:rank|rang|rango|posto|degrees? of freedom|dof|dofs|degrés? de liberté|freiheitsgrade?|grados? de libertad|grad[oi] di libertà|graus? de liberdade)\b)"
    r"|(?<=\brang )verlier(?:t|en)\b|(?<=\bfreiheitsgrad )verlier(?:t|en)\b|(?<=\bfreiheitsgrade )verlier(?:t|en)\b|\brang(?:verlust|abfall)\w*"
    r"|\b(?:otherwise|sonst|andernfalls|sinon|altrimenti|de lo contrario|caso contrário)\b(?= (?:, )?(?:\S+ ){0,3}?(?:target|goal|ziel|zielpunkt|cible|objetivo|obiettivo|alvo|workspace|arbeitsraum)\b)"
    r"|\b(?:without (?:using|solving|computing|inverting|calling|the need|needing|having to)|sans (?:utiliser|recourir|passer|résoudre)|ohne (?=(?:\S+ ){0,4}?zu (?:verwenden|benutzen|lösen|berechnen)\b)|sin (?:usar|utilizar|recurrir|resolver|necesidad)|senza (?:usare|utilizzare|ricorrere|risolvere)|sem (?:usar|utilizar|recorrer|resolver))\b",
    re.IGNORECASE,
)
_OF_DISPLAY = regex(  # a sentence whose subject is the display, or a part of it
    r"(?:[^\w\s]+ )*(?:(?:and|but|so|yet|however|thus|hence|et|mais|or|donc|aber|und|doch|pero|y|ma|mas|e) (?:, )?)?"
    r"(?:this|that|it|which|such|these|the (?:\S+ )?(?:formula|equation|expression|relation|result|identity|statement|claim|above|line|latter)"
    r"|(?:the|a|an|one) (?:\S+ )?(?:signs?|terms?|factors?|ind(?:ex|ices)|subscripts?|exponents?|sines?|cosines?)|(?:le|un|l'|un des) (?:signe|terme|facteur|indice|exposant|sinus|cosinus)|(?:das|ein) vorzeichen"
    r"|equation|formula|eq|c'(?! est-à-dire)|ce(?: qui)?|cela|ceci|ça|il(?! n' y | y )|elle|qui|que|(?:la|le|l'|cette|cet|ce) (?:formule|relation|équation|expression|égalité|identité|résultat|ligne)"
    r"|das|dies|es|was|(?:die|der|das|diese|dieser|dieses) (?:formel|gleichung|beziehung|ausdruck|ergebnis|aussage|identität|zeile)"
    r"|esto|eso|lo(?: que| cual)?|(?:la|el|esta|este|esa) (?:fórmula|ecuación|relación|expresión|igualdad|identidad|línea|resultado)|questo|ciò|il che"
    r"|(?:la|il|l'|questa|quest') (?:formula|relazione|equazione|espressione|uguaglianza|identità|risultato)"
    r"|isto|isso|o que|(?:a|o|essa|esta|esse|este) (?:fórmula|equação|relação|expressão|igualdade|identidade|resultado)) ",
    re.IGNORECASE,
)


def is_strange_behind(words: str) -> bool:
    """Whether a sentence behind a display, as `sentences.words_of` returns it, has words that no course has there.

    One of the display may have none of them, nor "not" or "only"; a short one none, others one in nine, and one of the arm more.
    """
    found = _words(words)
    if not found or found[0] == "Erratum":
        return False  # of the next
    if _is_foreign(found):
        return True
    subject = _subject(words)
    if subject or (words[:1].islower() and found[0] not in _table("GOES_ON") and not _follows_for_arm(words, found)):
        return bool(
            _strange(found[:_HEAD])
        )  # the subject is of known words, and what stands behind it begins no sentence
    return _is_mostly_strange(found, _SHORT if words[:1].isupper() and _is_over(words) else 0)


def is_strange_before(words: str) -> bool:
    """Whether a sentence that leads to a display has words that no course has there: one in a few, or two in more."""
    found = _words(words)
    return bool(found) and (_is_foreign(found) or _is_mostly_strange(found, 0 if _is_over(words) else _FEW))


def strange_words(words: str) -> list[str]:
    """Return the words of a sentence that no course has, each once: what else it is written in would be understood."""
    return [*dict.fromkeys(word.rstrip("'") for word in _strange(_words(words)))]


def is_in_known_language(text: str) -> bool:
    """Whether most words of a text are of a language whose words are known here; of a few words their script alone tells."""
    found = _WORD.findall(text)
    foreign, letters = len(_OF_OTHER_SCRIPT.findall(text)), sum(map(str.isalpha, text))
    if foreign and (_is_foreign(found) or 3 * foreign >= letters):  # its words stand without blanks, perhaps
        return False
    return len(found) < _MANY or 2 * len(_strange(found)) < len(found)


def _is_foreign(found: Sequence[str]) -> bool:
    """Whether a sentence is of a language in another script, of which no words are known here."""
    return 2 * sum(_OF_OTHER_SCRIPT.search(word) is not None for word in found) >= max(1, len(found))


def _subject(words: str) -> str:
    """Return the subject of a sentence that is of the display: "this" and "it", but not "this motion"; "" of another."""
    found = _OF_DISPLAY.match(words)
    is_of_arm = found is not None and words[found.end() :].partition(" ")[0].lower() in _table("OF_ARM")
    return "" if found is None or is_of_arm else found.group()


def _follows_for_arm(words: str, found: Sequence[str]) -> bool:
    """Whether a sentence says what follows for the arm, "so the arm loses rank", or a quantity, "so $O_3$ never reaches", and nothing of the display."""
    of_quantity = words.split()[1:2] == ["¤"]
    return found[0] in _table("HENCE") and (of_quantity or not _table("OF_ARM").isdisjoint(found[1:3]))


def _is_mostly_strange(found: Sequence[str], short: int) -> bool:
    """Whether a sentence that is not of the display has too many strange words; one of at most `short` words may have none."""
    strange = sum(word.lower() not in _table("LOADED") for word in _strange(found))
    if any(word.lower().rstrip("'") in _table("OF_ARM") for word in found[:_SUBJECT]):
        return strange > 2 and strange * _RATIO_OF_ARM >= len(found)
    most = 0 if len(found) <= short else 1
    return strange > most and strange * _RATIO >= len(found)


def _words(words: str) -> list[str]:
    return _WORD.findall(_NO_WORDS.sub(" ", _OF_ARM_ANYWAY.sub(" ", words)))


def _is_over(words: str) -> bool:
    return words.rstrip().endswith((".", "!"))


def _strange(found: Sequence[str]) -> list[str]:
    """Return those of the words of a sentence that no course has; within it, one that begins with a capital is a name, but in German."""
    names = set() if _table("OF_GERMAN").intersection(found) else {word for word in found[1:] if word[0].isupper()}
    return [
        word
        for word in found
        if word not in names
        and len(word.rstrip("'")) > 1
        and not re.search("[0-9_₀-₉²³]", word)
        and not _is_known(word)
    ]


def _is_known(word: str) -> bool:
    exact, begins = _known()
    return all(
        part in exact or is_weighed(part) or any(part[:length] in begins for length in set(_PREFIXES.values()))
        for part in word.lower().rstrip("'").split("-")
    )


@cache
def _known() -> tuple[frozenset[str], frozenset[str]]:
    """Return the words that are known, and how the longer ones begin."""
    words = frozenset(word for name in _PREFIXES for word in _table(name))
    begins = {word[:length] for name, length in _PREFIXES.items() for word in _table(name) if len(word) >= length}
    return words, frozenset(begins)


@cache
def _table(name: str) -> frozenset[str]:
    return frozenset(getattr(vocabulary, name).split())
