r"""Sentences that say which quantity of the arm the next display is of: "Let $\rho$ be the distance between the shoulder and the tool", « La hauteur du coude est ».

A formula for it may then be wrong, where one for a letter that only stands for the formula is what its author calls so.
"""

from __future__ import annotations

import re

from armproof.verification.patterns import regex

TOLD_QUANTITY = "of a quantity"  # what a display defines is something of the arm, and no abbreviation

TOLD_THING = "of a thing"  # it is called something: "The trace of $A$ is"

MAY_TELL_QUANTITY = regex(  # what no such sentence lacks, in small letters
    r"angle|distance|height|hauteur|altitude|area|aire|surface|reach|portée|allonge|inclin|orient|élévation|elevation|slope|pente|extension|radius|rayon|length|longueur|abstand|höhe|winkel|fläche|neigung|länge|ángulo|distancia|altura|área|angolo|distanza|altezza|abscissa|abscisse|ordinate|ordonnée"
    r"|(?<!\S)(?:is|are|equals|est|sont|vaut|ist|beträgt|lautet|es|vale|è|tangent|tangente)\s*:?\s*\Z"
)
_LEADS = regex(  # a thing that has its article, up to a verb that what comes next ends
    r"\A\W*(?:(?:then|so|now|hence|thus|and|here|donc|alors|dann|also) (?:, )?)?(?:the|its|their|le|la|l'|son|sa|leur|der|die|das|seine?|ihre?|el|los|las|su|il|lo|suo|sua|o|a) (?!(?:abbreviation|shorthand|notation)\w* )\w.* (?:is|are|equals|est|sont|vaut|ist|beträgt|lautet|es|vale|è|(?:tangent|tangente)) (?:: )?\Z"
)
_QUANTITY = regex(
    r"(?<!\S)(?:l' |d' )?(?:angle|distance|height|hauteur|altitude|area|aire|surface|reach|portée|allonge|inclination|inclinaison|orientation|élévation|elevation|slope|pente|extension|radius|rayon|length|longueur|abstand|höhe|winkel|fläche|neigung|länge|ángulo|distancia|altura|área|angolo|distanza|altezza|abscissa|abscisse|ordinate|ordonnée)(?!\w)"
)
_ABBREVIATES = regex(  # no quantity, or no other than what is printed
    r"(?<!\S)(?:sums?|somme|differences?|différence|abbreviat\w*|abrég\w*|abrévi\w*|shorthand|short|auxiliary|auxiliaire|put|set|pos(?:e|ons|ant)|substitut\w*|introduc\w*|introduis\w*|half|summe|abkürzung|suma|somma)(?!\w)"
)


def tells_quantity(words: str) -> bool:
    """Whether a sentence says which quantity what comes next is, and not that it abbreviates something."""
    small = words.lower()
    return _QUANTITY.search(small) is not None and _ABBREVIATES.search(small) is None


def names_thing(words: str) -> bool:
    """Whether a sentence leads to what a thing is that it names: "The trace of $A$ is"."""
    small = words.lower()
    head = re.split(r" (?:of|de|du|des|der|von|del|di) |,", small, maxsplit=1)[0]
    return _LEADS.match(small) is not None and _ABBREVIATES.search(head) is None
