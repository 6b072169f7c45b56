"""Displays that the text around them denies: "It is not true that", "This is wrong.", a tag that says so."""

from __future__ import annotations

import re

_WRONG = (
    r"(?:wrong|false|incorrect|untrue|erroneous|mistaken|invalid|impossible|absurd|nonsense|faux|fausse|erroné(?:e)?|incorrecte?|inexacte?|impossible|"
    r"absurde|falso|falsa|falsch|incorrecto|incorrecta)"
)
_FALSE_TO = r"(?:to|that|,? si|que|de|d['’]écrire)\b"
_FORMULA = r"(?:formula|equation|identity|relation|claim|statement|result|line|expression|formule|équation|identité|affirmation|ligne|égalité)"
_DENIES_BELOW = re.compile(
    rf"(?:\b(?:it is|it['’]s|it would be|il est|il serait|c['’]est)\s+(?:clearly |plainly |simply |just )?(?:{_WRONG}|not (?:true|correct|right|so|the case)|a mistake|une erreur)\s+{_FALSE_TO}"
    rf"|\bil n['’]est pas (?:vrai|correct|exact) {_FALSE_TO}|\bce n['’]est pas vrai que\b|\b(?:no es (?:cierto|verdad)|es falso|non è vero) (?:que|che)\b|\bes ist (?:nicht (?:wahr|richtig)|falsch),? dass\b"
    rf"|\b(?:following|suivante?|{_FORMULA})(?: {_FORMULA})? (?:is|are|est) {_WRONG}\s*:|(?:\A|[,;]\s*)(?:not true|{_WRONG})\s*[:.!]\s*\Z|[✗✘❌]\s*\Z|\b(?:wrong|false|incorrect|faux|fausse) {_FORMULA}\b[^.:]{{0,40}}:?\s*\Z"
    r"|\b(?:common|frequent|typical|classic|usual) (?:mistake|error|slip)\b|\berreur (?:fréquente|courante|classique)\b|\btempted to write\b|\btenté d['’]écrire\b"
    r"|\b(?:(?:one|we|you) (?:cannot|can never|can['’]t|must not|may not|should not|do not|don['’]t)|never|do not|don['’]t) (?:write|have|say|use)\b"
    r"|\bon ne (?:peut|doit) (?:pas|jamais) (?:écrire|avoir|poser)\b|\bil ne faut (?:pas|jamais) écrire\b|\bn['’]écri(?:vez|s) (?:pas|jamais)\b"
    r"|\b(?:wrongly|erroneously|mistakenly|à tort)\b)[^.;!?]*:?\s*\Z",
    re.IGNORECASE,
)
_RIGHT = re.compile(
    r"\b(?:right|correct(?:ly|ed)?|instead|rather|but|should be|mais|plutôt|correct|corrigée?)\b[^.;!?]*\Z",
    re.IGNORECASE,
)
_NOT = r"(?:\s+(?:clearly|of course|however|bien sûr|donc|thus))?"
_UNLESS = (
    r"(?! (?:if|when|whenever|where|for|unless|that|to|si|quand|pour|que|lorsque|de|où)\b)"  # then it holds elsewhere
)
_SUBJECT = (
    rf"(?:(?:but|however|of course|note that|beware,?|mais|or|attention,?)[\s,:]+)?(?:this|that|it|which|cela|ceci|ce|il|elle|ce qui|esto|eso|questo|ciò|das|dies"
    rf"|the (?:above )?(?:last |previous )?{_FORMULA}(?: above)?|cette (?:dernière )?{_FORMULA}|l['’](?:équation|expression|égalité)(?: ci-dessus)?"
    r"|esta (?:ecuación|fórmula)|questa (?:equazione|formula)|diese (?:gleichung|formel))\s+"
)
_IS_WRONG = (
    rf"(?:(?:is|are|was|would be|est|sont|serait|ist|es|è){_NOT}\s+(?:{_WRONG}|not (?:true|correct|right|so|the case|possible|valid)|nicht (?:richtig|wahr)|sbagliat[oa])\b"
    r"|(?:does|can|could|did) ?not (?:hold|be (?:so|true|right|correct))\b|cannot (?:hold|be (?:so|true|right|correct))\b|never holds?\b"
    r"|n['’]est (?:pas|jamais) (?:vraie?|correcte?|exacte?|possible|valable)\b|ne (?:tient|vaut) (?:pas|jamais)\b"
    r"|no es (?:cierta?|correcta?|verdad)\b|non è (?:vero|vera|corrett[oa])\b)"
)
_DENIES_ABOVE = re.compile(
    rf"[\s.,;:)—–-]*(?:{_SUBJECT})?(?:{_IS_WRONG}{_UNLESS}|(?:holds?|is (?:true|right|valid|correct)) only\b|n['’]est (?:vraie?|exacte?|valable) que\b|ne (?:tient|vaut) que\b)|[\s.,;:(—–-]*(?:c['’]est {_WRONG}|(?:not true|{_WRONG})\s*[.!)])|\s*[✗✘❌]",
    re.IGNORECASE,
)
_IN_DISPLAY = re.compile(
    rf"\\tag\*?\s*\{{[^{{}}]*(?:\b{_WRONG}\b|[✗✘×]|\?)[^{{}}]*\}}|\\[bx]?cancel\s*\{{(?:[^{{}}]|\{{[^{{}}]*\}})*=",
    re.IGNORECASE,
)


def denies_above(text: str) -> bool:
    """Whether a text begins with a denial of what stands above it: "This is wrong."."""
    return _DENIES_ABOVE.match(_plain(text)) is not None


def denies_below(text: str) -> bool:
    """Whether a text leads to what it denies: "It is not true that"."""
    sentence = last_sentence(_plain(text))
    found = _DENIES_BELOW.search(sentence)
    return found is not None and not _RIGHT.search(sentence, found.start())


def denied_in(latex: str) -> bool:
    """Whether a display denies itself: a tag says that it is wrong, or it is crossed out."""
    return _IN_DISPLAY.search(latex) is not None


def last_sentence(text: str) -> str:
    """Return the last sentence of a text on one line, or part of one behind a semicolon."""
    return re.split(r"[.;!?](?=\s+\S)", text)[-1]


def _plain(text: str) -> str:
    return re.sub(r"[*~]+|(?<!\w)_+(?=\w)|(?<=\w)_+(?!\w)", "", " ".join(text.split()))
