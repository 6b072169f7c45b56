"""Which of several arms a text speaks of, by what it calls them: "robot A", "the second arm", "le premier robot", "the planar arm"."""

from __future__ import annotations

import re

from armproof.verification.document.hearing import STOP, words_of
from armproof.verification.document.other_arms import compares
from armproof.verification.patterns import regex

CALLED = r"\text{called: "  # what an arm is called in a sentence, and a brace

_NOUN = r"(?:arms?|robots?|manipulators?|mechanisms?|bras|manipulateurs?|mécanismes?|roboter[ns]?|arm[se]?|brazos?|manipulador(?:es)?|bracci[oa]?|manipolator[ei]|braços?|robôs?)"
_ORDINALS = {
    word: str(number)
    for number, words in enumerate(
        (
            "first premier première 1er erste ersten erster primer primero primo primeiro",
            "second deuxième seconde 2e zweite zweiten zweiter segundo secondo",
            "third troisième 3e dritte dritten dritter tercer tercero terzo terceiro",
            "fourth quatrième vierte vierten cuarto quarto",
        ),
        start=1,
    )
    for word in words.split()
}
_ORDINAL = regex(rf"(?<!\S)({'|'.join(_ORDINALS)}) (?:[^\W\d]+ )?{_NOUN} ", re.IGNORECASE)
_NUMBER = regex(rf"(?<!\S)(?i:{_NOUN}|robot) (?:(?i:no|nr|n°) )?(\d|[A-H])(?= )")
_KIND = regex(rf"(?<!\S)([^\W\d]{{4,}}) {_NOUN} |(?<!\S){_NOUN} ([^\W\d]{{4,}}) ", re.IGNORECASE)
_NO_KINDS = frozenset(
    "robot robots this that same whole entire other with avec plan's where which dieser ganze link links linked joint joints axis segment segments your their these those every each some many such both given general generic typical simple robotic robotique robótico robotico industrial industriel serial série arbitrary considered cette notre votre chaque quelconque seinem einem diesem unser jeder este esta nuestro cada questo nostro ogni nosso".split()
)


def arms_called(text: str) -> list[frozenset[str]]:
    """Return what each sentence of a text calls the arms that it speaks of, in their order: a number, a letter, a kind; sentences that compare are of none."""
    found = []
    for sentence in STOP.split(" ".join(text.replace("~", " ").split())):
        words = re.sub(r"\$\s*([A-H\d])\s*\$", r"\1", sentence)
        if (names := called_in(words_of(words))) and not compares(words_of(words)):
            found.append(names)
    return found


def called_in(words: str) -> frozenset[str]:
    """Return what the words of a sentence or a heading call arms."""
    kinds = {(each[0] or each[1]).lower() for each in _KIND.findall(words)}
    ordinals = {_ORDINALS[each.lower()] for each in _ORDINAL.findall(words)}
    return frozenset({*_NUMBER.findall(words), *ordinals, *kinds - _NO_KINDS - _ORDINALS.keys()})
