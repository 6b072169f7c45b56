r"""Sentences that say which quantity of the arm the next display is of: "Let $\rho$ be the distance between the shoulder and the tool", « La hauteur du coude est ».

A formula for it may then be wrong, where one for a letter that only stands for the formula is what its author calls so.
"""

from __future__ import annotations

import re

TOLD_QUANTITY = "of a quantity"  # what a display defines is something of the arm, and no abbreviation

MAY_TELL_QUANTITY = re.compile(  # what no such sentence lacks, in small letters
    r"angle|distance|height|hauteur|altitude|area|aire|surface|reach|portée|allonge|inclin|orient|élévation|elevation|slope|pente|extension|radius|rayon|length|longueur|abstand|höhe|winkel|fläche|neigung|länge|ángulo|distancia|altura|área|angolo|distanza|altezza|abscissa|abscisse|ordinate|ordonnée"
)
_QUANTITY = re.compile(
    r"(?<!\S)(?:l' |d' )?(?:angle|distance|height|hauteur|altitude|area|aire|surface|reach|portée|allonge|inclination|inclinaison|orientation|élévation|elevation|slope|pente|extension|radius|rayon|length|longueur|abstand|höhe|winkel|fläche|neigung|länge|ángulo|distancia|altura|área|angolo|distanza|altezza|abscissa|abscisse|ordinate|ordonnée)(?!\w)"
)
_ABBREVIATES = re.compile(  # no quantity, or no other than what is printed
    r"(?<!\S)(?:sums?|somme|differences?|différence|abbreviat\w*|abrég\w*|abrévi\w*|shorthand|short|auxiliary|auxiliaire|put|set|pos(?:e|ons|ant)|substitut\w*|introduc\w*|introduis\w*|half|summe|abkürzung|suma|somma)(?!\w)"
)


def tells_quantity(words: str) -> bool:
    """Whether a sentence says which quantity what comes next is, and not that it abbreviates something."""
    small = words.lower()
    return _QUANTITY.search(small) is not None and _ABBREVIATES.search(small) is None
