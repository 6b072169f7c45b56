r"""What a sentence says to be done to what the next display prints: "Half of the trace is", "The absolute value of the determinant is".

Where the display names the result and goes on with something else, `t = \det J = …`, that the two are equal shows nothing of the name.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

OPERATION = "operation"  # with its kind
NEVER_NEGATIVE, LENGTH, SQUARE, SCALED, COMPOSED, TRACE = "never negative", "length", "square", "scaled", "composed", "trace"  # fmt: skip
MAY_TELL_OPERATION = regex(  # what no such sentence lacks, in small letters
    r"manip|magnitude|modul|absol|assol|betrag|singul|speed|distan|abstand|entfernung|length|longueur|länge|longitud|lunghezz|comprimento|carré|square|quadr|cuadr|half|moiti|hälfte|mitad|metà|metade|twice|double|doppelt|doble|doppio|dobro|inverse|recipro|invers|kehrwert|area|aire|fläche|área|sum|somm|soma|product|produ|trace|spur|traza|traccia|traço|derivat|dériv|ableit|deriva|opposite|opposé|mean|average|moyenne|mittel|media|third|tiers|drittel"
    r"|reach|\bfar\b|hypot|portée|radius|rayon|reichw|alcance|raggio|portata|volum"
)
_is = WordLists("""
never_negative manipulability manipulabilité manipulierbarkeit manipulabilidad manipolabilità manipulabilidade magnitude modulus betrag absolute absolue absolutbetrag absoluto assoluto singular singulière~ singulär~ singolari volume volumen
length speed distance distances abstand entfernung distancia distanza distância length longueur länge longitud lunghezza comprimento norm norme
square square squared carré quadrat cuadrado quadrato quadrado
scaled half moitié hälfte mitad metà metade twice double doppelte doble doppio dobro inverse reciprocal kehrwert inverso reciproco opposite opposé area aire fläche área third tiers drittel
composed sum somme summe suma somma soma difference différence differenz diferencia differenza product produit produkt producto prodotto produto derivative dérivée ableitung derivada derivata mean average moyenne mittelwert
trace trace spur traza traccia traço
FAR far reach hypotenuse hypoténuse hypothenuse hipotenusa ipotenusa portée radius rayon reichweite alcance raio raggio portata
SIZE manipulability manipulabilité manipulierbarkeit manipulabilidad manipolabilità manipulabilidade magnitude modulus absolutbetrag volume volumen
ABSOLUTE absolute absolue absoluto absoluten absoluta assoluto
VALUE value values valeur valeurs wert werte valor valores valore valori
ROOT root racine wurzel raíz radice raiz
ANGLE angle~ winkel~ ángulo~ angol~ ângulo~ matrix matrice jacobian jacobienne kinematic~ kinematik~ problem model~ modèle transform~ pose
ARTICLE the a an la le l' les un une der die das den el los las il lo o its his their son sa leur sein~ ihr~ su suo sua this that of de d' von di then so now hence thus here and finally
""").holds  # fmt: skip
_KINDS = ("never_negative", "square", "scaled", "composed", "trace", "length")
_HEAD = regex(r" (?:, |: |; )| (?:which|that|qui|que|che|with|avec|mit|con) ")


def told_operation(words: str) -> str:
    """Return the kind of the operation whose result a sentence leads to, by its first word that is of one, "" without one."""
    head = _HEAD.split(words.lower(), maxsplit=1)[0].split()
    if any(_is(word, "ROOT") or _is(word, "ANGLE") for word in head) or words.endswith("? "):
        return ""
    for place, word in enumerate(head):
        kind = next((each for each in _KINDS if _is(word, each)), "")
        if kind:
            return kind.replace("_", " ") if _begins(head[:place]) else _size_within(head)
    return _size_within(head)


def _size_within(head: Sequence[str]) -> str:
    """Return the kind of a size that a sentence names anywhere, "We find for the distance", "the absolute value of": one that no square is said of."""
    if any(_is(word, "square") for word in head):
        return ""
    of_value = any(_is(word, "VALUE") for word in head)
    if any(_is(word, "SIZE") or (_is(word, "ABSOLUTE") and of_value) for word in head):
        return NEVER_NEGATIVE
    return LENGTH if any(_is(word, "length") or _is(word, "FAR") for word in head) else ""


def _begins(before: Sequence[str]) -> bool:
    """Whether nothing but articles and small words stand before the noun that a sentence is of."""
    return all(_is(word, "ARTICLE") or word in (",", ":") for word in before)
