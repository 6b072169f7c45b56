r"""Letters that a text calls a size: "a torch of length $L$", "à la hauteur $H$", "the moment $M$", "ein Gewicht $P$".

In a document about no known arm a capital letter may be much: a point, a matrix, a force. What the text calls a length, a height, a
weight or a moment is a number.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

SIZE, MOMENT = "size", "moment"
MAY_CALL_SIZE = regex(  # in small letters: what no sentence lacks that calls a letter so
    r"length|height|distance|radius|offset|width|weight|load|moment|torque|longueur|hauteur|rayon|largeur|décalage|poids|charge|couple|läng|höhe|abstand|entfernung|breite|gewicht|last|drehmoment|longitud|altura|distancia|radio|anch|peso|carga|lunghezz|altezz|distanz|raggio|larghezz|carico|coppia|comprimento|raio|largura"
)
_is = WordLists("""
SIZE length lengths height heights distance distances radius offset width longueur longueurs hauteur distance rayon largeur décalage länge längen höhe abstand entfernung breite versatz longitud longitudes altura distancia radio anchura desplazamiento lunghezza lunghezze altezza distanza raggio larghezza comprimento comprimentos distância raio largura
WEIGHT weight load poids charge gewicht last peso carga carico
MOMENT moment torque couple drehmoment momento coppia
BE is are denotes be est sont désigne vaut ist sind sei es son è sono é são
DEFINITE the its a an la le les l' sa son une un die der das den eine ein el los las una un il lo i gli o os
AND and et und y e ,
""").holds
_LETTER = regex(r"([A-Za-z])(?:\s*_\s*(?:(\w)|\{\s*(\w+)\s*\}))?\s*(?:=.*)?")
_AXES = ("x-axis", "y-axis", "z-axis")
_NO_SIZE = frozenset("TJR")  # matrices, whatever a sentence calls by the way


def told_scalars(sentence: str) -> Iterator[str]:
    """Yield what a sentence calls letters, with their keys: "size L", "moment M"."""
    formulas, said = formulas_of(sentence), words_of(sentence).lower().split()
    marks = ["¤"] if said.count("¤") == len(formulas) else ["¤", *_AXES]  # an axis is one word with its letter
    if sum(map(said.count, marks)) != len(formulas):
        return
    for place, word in enumerate(said):
        kind = MOMENT if _is(word, "MOMENT") else SIZE if _is(word, "SIZE") or _is(word, "WEIGHT") else ""
        for each in _named(said, place) if kind else ():
            letter = _LETTER.fullmatch(formulas[sum(map(said[:each].count, marks))].strip())
            if letter is not None and letter[1] not in _NO_SIZE:
                sub = letter[2] or letter[3]
                yield f"{kind} {letter[1]}_{sub}" if sub else f"{kind} {letter[1]}"


def _named(said: Sequence[str], place: int) -> Iterator[int]:
    """Yield the places of the letters to which a noun is put: "lengths ¤ and ¤", "¤ is the length"."""
    at = place + 1
    while at < len(said) and (said[at] == "¤" or (_is(said[at], "AND") and at > place + 1)):
        if said[at] == "¤":
            yield at
        at += 1
    before = [*said[:place]]
    while before and _is(before[-1], "DEFINITE"):
        before.pop()
    if len(before) > 1 and _is(before[-1], "BE") and before[-2] == "¤":
        yield len(before) - 2
