"""What the words between the statements of a display do to them: "not", "unless" and "or" leave them open."""

from __future__ import annotations

import re
from functools import cache
from itertools import product

from armproof.verification.document.denials import denies_within
from armproof.verification.document.hearing import without_harmless
from armproof.verification.document.vocabulary import IN_DISPLAYS
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.statements import ARROWS, UNREAD
from armproof.verification.latex.vocabulary import JOINING, SPOKEN
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, Role, Verdict

CHANGES = regex(
    r"\b(?:not|never|nowhere|cannot|no longer|except|unless|only (?:if|for|when|where|at)|otherwise|false|wrong|incorrect|impossible|untrue|invalid|erroneous|fails"
    r"|neither|nor|contradicts?|without|instead of|rather than|unlike|exceeds?|differs?|ignor\w+|neglect\w*|approximat\w+|small|up to (?:a|an|the)|(?:first|second) order"
    r"|(?:seulement|uniquement) (?:si|pour|quand|lorsque)|sauf|ne|n'|ni|pas|jamais|faux|fausse|erronée?|incorrecte|inexacte?|non|sinon|sans|au lieu de|plutôt que|néglige\w*"
    r"|petits?|petites?|(?:premier|second) ordre)\b",
    re.I,
)

_PREDICATE = regex(  # "… is nonsense": what is said of an equation, unless that it is so, or what it is called
    r"\W*(?:is|are|was|were|est|sont|ist|es)\s+(?!(?:the|an?|our|thus|then|also|known|true|correct|right|valid|exact|obtained|given|called|found|le|la|un|une|donc|aussi|vraie?"
    r"|juste|correcte?|exacte?|connue?|donnée?|appelée?|obtenue?)\b|l['’])\w",
    re.I,
)

_WORD = regex(r"[^\W\d_][^\W\d_]+(?:[-'][^\W\d_]+)*")
_NO_WORDS = regex(
    r"\$[^$]*\$|\\[A-Za-z]+|(?<=[a-z])'|(?<!\w)[ldcnsLDCNS]['’]|forall|exists|because|\b(?:ref|eqref|cite|autoref)\b"
)
_OF_OTHER_LETTERS = regex(r"[^a-zà-ÿœ'-]")  # of a script in which no words are known
# "opposite of", before an equation: it is said of something else than what stands there
_OF_EQUATION = regex(
    r"\b(?<!\bvalue )(?<!\bvalues )(?<!\bexpression )(?<!\bcomponent )(?<!\bcomponents )(?<!\bcoordinates )(?<!\bsolution )(?<!\bsolutions )"
    r"(?<!\bvaleur )(?<!\bexpression )(?<!\bcase )(?<!\bcas )(?<!\bdefinition )(?:of|de|von)\s*$",
    re.IGNORECASE,
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
        or "?" in text
        or _is_strange(text)
        or _OF_EQUATION.search(text)
    ]
    unread = next((s.text for s in statements if isinstance(s, n.Connective) and s.kind == UNREAD), "")
    doubts = [say(Kind.LEFT_OUT, text=unread)] if unread else []
    doubts += [say(Kind.WORDS_CHANGE_IT, text=words[0])] if words else []
    for outcome, doubt in product(outcomes, doubts):
        if outcome.verdict in DECIDED or outcome.role is Role.DEFINITION:
            outcome.verdict, outcome.findings = Verdict.UNCHECKED, (doubt,)


def _is_strange(text: str) -> bool:
    """Whether words beside an equation are none of those that leave it what it is: "squared", "if a link is removed"."""
    words = _WORD.findall(_NO_WORDS.sub(" ", text).lower())
    return any(word not in _harmless() and not _OF_OTHER_LETTERS.search(word) for word in words)


@cache
def _harmless() -> frozenset[str]:
    return frozenset(
        [
            *IN_DISPLAYS.split(),
            *JOINING,
            *(word for spoken in SPOKEN.values() for each in spoken for word in each.split()),
        ]
    )


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
