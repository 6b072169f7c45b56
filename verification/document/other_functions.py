"""Whether a sentence is of another function of a quantity than its value: "The mean of the abscissa is", "Twice the height is", "The change of $x$ is".

It counts where the last clause begins with it: "From the square of the distance we get" is of something else.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists

OTHER_FUNCTION = "other function"

_is = WordLists("""
FUNCTION mean means average~ expectation expected median variance logarithm~ log half twice double thrice triple third quarter reciprocal change changes increment increments increase decrease variation deviation excess maximum minimum maximal minimal largest smallest greatest highest lowest farthest least extreme extremum integral square cube moyenne moyen logarithme moitié inverse écart accroissement changement plus maximale minimale intégrale carré mittelwert mittlere durchschnitt~ logarithmus hälfte doppelte zweifache kehrwert änderung zunahme abnahme größte größter größtes kleinste kleinster kleinstes maximale minimale integral quadrat media promedio logaritmo mitad doble cambio incremento recíproco máximo máxima mínimo mínima mayor menor cuadrado metà doppio variazione incremento reciproco massimo massima minimo minima quadrato média metade dobro variação maior menor quadrado
QUANTITY position~ coordinate~ abscissa~ ordinate~ height~ velocit~ speed~ acceleration~ jacobi~ determinant~ orientation~ inclination~ manipulability coordonnée~ abscisse~ ordonnée~ hauteur~ vitesse~ accélération~ déterminant~ lage koordinate~ abszisse~ höhe~ geschwindigkeit~ beschleunigung~ determinante~ posición coordenada~ abscisa~ ordenada~ altura~ velocidad~ aceleración posizione coordinata ascissa~ ordinata~ altezza~ velocità accelerazione posição abscissa velocidade aceleração x-coordinate y-coordinate z-coordinate
SKIPPED the a an la le l' les el il lo das die den der dem des un une uno una its their sa son ses seine ihre su suo sua of de d' del della dell' dello di von do da time zeit temporal temps possible tool robot
OPENING now then thus hence so finally similarly and or donc alors enfin ainsi et ou nun dann also somit und ahora entonces así y ora allora quindi e agora então :
BE is are reads becomes equals est sont vaut ist lautet sind wird es son vale è sono são
RATE rate rates taux
PROBLEM problem problems kinematics mapping solution problème cinématique problema cinematica cinemática
""").holds
_FAR = 6  # words between a function and the quantity that it is of


def is_of_other_function(said: Sequence[str]) -> bool:
    """Whether the words of a sentence, formulas with ¤ before them, are of a function of a quantity."""
    clause = [*said]
    while "," in clause[:-1]:
        clause = clause[clause.index(",") + 1 :]
    while clause and (_is(clause[0], "SKIPPED") or _is(clause[0], "OPENING")):
        clause = clause[1:]
    if not clause or not _is(clause[0], "FUNCTION"):
        return False
    end = next((place for place, word in enumerate(clause) if _is(word, "BE") or word in ":;."), len(clause))
    behind = clause[1 : min(end, 1 + _FAR)]
    return any(_is(word, "QUANTITY") or word.startswith("¤") for word in behind) and not any(
        _is(word, "RATE") or _is(word, "PROBLEM") for word in behind
    )
