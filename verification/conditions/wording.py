"""What the words between the statements of a display do to them: "not", "unless" and "or" leave them open."""

from __future__ import annotations

import re

from armproof.verification.document.denials import denies_within
from armproof.verification.document.hearing import without_harmless
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.statements import ARROWS
from armproof.verification.verdict import DECIDED, Role, Verdict

CHANGES = re.compile(
    r"\b(?:not|never|nowhere|cannot|no longer|except|unless|only (?:if|for|when|where|at)|otherwise|false|wrong|incorrect|impossible|untrue|invalid|erroneous|fails"
    r"|neither|nor|contradicts?|without|instead of|rather than|unlike|exceeds?|differs?|ignor\w+|neglect\w*|approximat\w+|small|up to (?:a|an|the)|(?:first|second) order"
    r"|(?:seulement|uniquement) (?:si|pour|quand|lorsque)|sauf|ne|n'|ni|pas|jamais|faux|fausse|erronée?|incorrecte|inexacte?|non|sinon|sans|au lieu de|plutôt que|néglige\w*"
    r"|petits?|petites?|(?:premier|second) ordre)\b",
    re.I,
)

_PREDICATE = re.compile(  # "… is nonsense": what is said of an equation, unless that it is so, or what it is called
    r"\W*(?:is|are|was|were|est|sont|ist|es)\s+(?!(?:the|an?|our|thus|then|also|known|true|correct|right|valid|exact|obtained|given|called|found|le|la|un|une|donc|aussi|vraie?"
    r"|juste|correcte?|exacte?|connue?|donnée?|appelée?|obtenue?)\b|l['’])\w",
    re.I,
)


def tell_words_that_change(statements: list[n.Statement], outcomes: list[Outcome]) -> None:
    """Beside "not", "except" or "unless" nothing is decided or defined."""
    said = [s.text for s in statements if isinstance(s, n.Connective) and s.kind == "words"]
    words = [
        text
        for text in said
        if CHANGES.search(without_harmless(text))
        or denies_within(text)
        or _PREDICATE.match(text)
        or text.strip(" .,()") in ("exists", "only", "seulement")
    ]
    for outcome in outcomes if words else ():
        if outcome.verdict in DECIDED or outcome.role is Role.DEFINITION:
            outcome.verdict, outcome.findings = Verdict.UNCHECKED, (say(Kind.WORDS_CHANGE_IT, text=words[0]),)


def is_alternative(statements: list[n.Statement], index: int) -> bool:
    """Whether an "or" stands beside a statement: A or B says of neither that it holds."""
    beside = [*statements[max(index - 1, 0) : index], *statements[index + 1 : index + 2]]
    return any(isinstance(each, n.Connective) and each.kind == "or" for each in beside)


def is_concluded(statements: list[n.Statement], index: int) -> bool:
    """Whether a statement stands behind an arrow, perhaps joined to others by "and" or "or"."""
    while index > 0 and isinstance(before := statements[index - 1], n.Connective):
        if before.kind in ARROWS:
            return True
        if before.kind not in ("and", "or"):
            return False
        index -= 2
    return False
