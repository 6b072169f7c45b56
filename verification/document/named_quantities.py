"""Which quantity a sentence names that a display beside it is said to be: "The velocity of the tip is", "It is the ordinate of the tool".

The noun counts where it is what the sentence is of, what it finds or what it is for, and no other quantity is named: "To find the velocity we need" names none.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists

NAMED = "named"  # with what is named
VELOCITY, DISTANCE, ABSCISSA, ORDINATE, ORIENTATION = "velocity", "distance", "abscissa", "ordinate", "orientation"
_OTHER = "other"

_is = WordLists("""
velocity velocity velocities speed speeds vitesse vitesses geschwindigkeit geschwindigkeiten velocidad velocidades velocità velocidade
distance how-far distance distances abstand abstände entfernung distancia distanza distância
abscissa abscissa abscisse abszisse abscisa ascissa x-coordinate x-koordinate
ordinate ordinate ordonnée ordenada ordinata y-coordinate y-koordinate height hauteur höhe altura altezza
orientation orientation orientierung orientación orientamento orientação attitude
other position~ posición posizione posição location~ situation lage acceleration~ accélération~ beschleunigung~ aceleración accelerazione aceleração jacobi~ pose poses lengths~ torque~ force~ angle angles rotation~ determinant~ rate rates
COORDINATE coordinate coordonnée koordinate coordenada coordinata position component composante komponente componente posición posizione posição
UP vertical verticale vertikale vertikalen senkrechte vertical
LEVEL horizontal horizontale horizontalen waagrechte waagerechte orizzontale
SKIPPED the a an la le l' el il lo das die den der dem un une uno una its his this that instantaneous linear end-effector
OPENING now then thus hence so finally similarly likewise also therefore and or donc alors enfin ainsi et ou or nun dann also somit und ahora entonces así y ora allora quindi e agora então , : ;
LEADS for pour für para per is are reads equals est sont vaut ist lautet sind es son è sono é são obtain obtains find finds get gets have gives give yields yield denotes describes represents means obtient obtenons trouve trouvons avons a donne désigne représente décrit erhalten erhält ergibt liefert bezeichnet beschreibt obtenemos obtiene resulta da describe representa otteniamo ottiene dà descrive rappresenta obtemos obtém dá descreve representa
FOR for pour für para per
TURNED derivative~ differentiat~ deriv~ dériv~ ableit~ abgeleitet~ derivat~ replac~ remplac~ ersetz~ also too likewise aussi auch también anche também before after once until later avant après vor nach sobald bis antes después prima dopo depois not pas nicht non não relative relativ~ needed
ALONG along horizontal vertical axis axes x-axis y-axis z-axis direction richtung waagrecht senkrecht achse horizontale verticale axe eje asse eixo wall plane floor ground
""").holds


def named_quantity(said: Sequence[str]) -> str:
    """Return the one quantity that the words of a sentence say the display beside it to be, "" where they tell none."""
    found = {place: kind for place in range(len(said)) if (kind := _kind(said, place))}
    if len({*found.values()}) != 1 or any(_is(word, "TURNED") for word in said):
        return ""
    place, kind = next(iter(found.items()))
    if kind == _OTHER or (kind == DISTANCE and any(_is(word, "ALONG") for word in said)):
        return ""
    return kind if _is_told(said, place) else ""


def _kind(said: Sequence[str], place: int) -> str:
    """Return which quantity the word at a place is: a "vertical coordinate" is an ordinate."""
    word, beside = said[place], [*said[max(0, place - 1) : place], *said[place + 1 : place + 2]]
    if _is(word, "COORDINATE"):
        turned = ((ORDINATE, "UP"), (ABSCISSA, "LEVEL"))
        return next((kind for kind, way in turned if any(_is(each, way) for each in beside)), _OTHER)
    return next((kind for kind in (VELOCITY, DISTANCE, ABSCISSA, ORDINATE, ORIENTATION, _OTHER) if _is(word, kind)), "")


def _is_told(said: Sequence[str], place: int) -> bool:
    """Whether the sentence is of the noun at a place, finds it, or begins with "for" it."""
    before = [word for word in said[:place] if not any(_is(word, kind) for kind in ("SKIPPED", "UP", "LEVEL"))]
    if "," in said[place:-1] and not (before and _is(before[-1], "FOR")):
        return False
    is_purpose = before[-2:-1] == ["to"]  # "to find the velocity"
    return not before or _is(before[-1], "OPENING") or (_is(before[-1], "LEADS") and not is_purpose)
