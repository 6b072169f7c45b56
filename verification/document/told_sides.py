r"""On which side a solution has the elbow, or which way it turns the forearm: "the elbow lies on the left of the line from the base to the hand".

Seen from the tip of z the elbow of a planar arm is on the left of that line where \theta_2 is negative, and the forearm is then turned clockwise against the upper arm.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

UNCLEAR = ""  # a side that no formula says
LEFT_OF_LINE, RIGHT_OF_LINE = "\\theta_2 < 0", "\\theta_2 > 0"
MAY_TELL_SIDE = r"clockwise|uhrzeiger|horaire|horari|orari|horári|aiguilles|agujas|lancette|ponteiros|behind|back|derrière|dos\b|arrière|hinte|rücken|atrás|espalda|detrás|dietro|schiena|indietro|trás|costas"

_CLOCKWISE = regex(
    r"(?<!\S)(?P<counter>counter-?clockwise|anti-?clockwise|counter clockwise|(?:gegen den|entgegen dem) uhrzeigersinn|(?:inverse|contraire) (?:à celui |du sens |au sens |de celui )?(?:des aiguilles|horaire)|trigonométrique|anti-?horaire|antihorario|contrario (?:a|al de) las agujas|antiorario|anti-horário|contrário a\w* (?:dos )?ponteiros)"
    r"|(?<!\S)(?:clockwise|(?:im )?uhrzeigersinn|horaire|(?:des )?aiguilles|(?:las )?agujas|horario|orario|lancette|horário|ponteiros)(?!\w)"
)
_lists = WordLists("""
ELBOW elbow~ knee coude~ ellbogen~ ellenbogen~ codo gomito cotovelo
FOREARM forearm avant-bras unterarm~ antebrazo avambraccio antebraço
LEFT left gauche links linke~ izquierd~ sinistr~ esquerd~
RIGHT right droite rechts rechte~ derech~ destr~ direit~
NO_SIDE angle angles angled hand-side winkel~ winklig~ handed
LINE line chord segment linie gerade~ verbindungslinie~ strecke ligne droite segment línea recta retta linea segmento reta linha look~ schau~ blick~ regard~ mira~ guard~ olha~
BASE base shoulder~ origin column socle épaule origine basis schulter~ ursprung hombro origen spalla origine ombro origem
TOOL hand tool tip gripper end-effector target main outil pince cible greifer~ werkzeug~ ziel mano herramienta pinza objetivo utensile bersaglio mão ferramenta garra alvo
AGAINST against relative relatively respect gegen gegenüber rapport relativement respecto rispetto relação
CHOICE solution~ branch~ posture~ configuration~ choose chose~ choice take keep pick lösung~ zweig~ stellung~ haltung~ wähl~ nehmen branche~ choisi~ prenons gardons solución soluciones rama~ elegi~ tomamos postura~ configuración soluzion~ ramo rami scegli~ prendiamo configurazion~ soluç~ escolh~ configuraç~
BEHIND behind backwards derrière arrière hinten hinter rücken atrás espalda~ detrás dietro schiena indietro trás costas
ARM arm arm's robot~ manipulator~ bras manipulateur~ roboter~ brazo braccio braço robô
OWN its the his son le seinem seinen ihrem ihren dem den su la sua seu sus suas
BACK back dos rücken espalda~ schiena costas
WRITTEN equation~ formula~ formulae expression~ book~ text gleichung~ formel~ buch~ équation~ formule~ livre ecuaci~ fórmula~ libro~ equazion~ equaç~ livro
IS are is was were be been nothing
COUNTED positive~ positiv~ counted measured gezählt gemessen compté~ mesuré~ contad~ medid~ misurat~
NOT not never no nicht nie kein~ pas jamais nunca non mai não
PRONOUN it he she il elle er es sie lo ele ela esso
""")
_is, _has = _lists.holds, _lists.has
_BEGINS = 3  # words of a sentence within which its pronoun stands


def told_side(words: str) -> str | None:
    """Return the sign of θ_2 that a sentence tells by the side of the elbow or the turn of the forearm, UNCLEAR where it may be either; None of another sentence."""
    small = words.lower()
    said = small.split()
    if _has(said, "WRITTEN"):
        return None
    if _has(said, "ELBOW") and (side := _sides(said)):
        return _of_line(said, side)
    is_choice = _has(said, "CHOICE")
    if not is_choice:
        return None
    clockwise = _CLOCKWISE.search(small)
    if clockwise is not None and _has(said, "FOREARM"):
        return _of_turn(said, clockwise)
    backs = (at for at, word in enumerate(said) if _is(word, "BACK") and at and _is(said[at - 1], "OWN"))
    is_behind = _has(said, "BEHIND") and _has(said, "ARM")
    return UNCLEAR if is_behind or next(backs, None) is not None else None


def goes_on_with_side(words: str, before: str) -> bool:
    """Whether a sentence says on which side "it" is, of which the sentence before has an elbow."""
    said = words.lower().split()
    is_of_it = _has(said[:_BEGINS], "PRONOUN")
    return is_of_it and bool(_sides(said)) and _has(before.lower().split(), "ELBOW")


def _sides(said: Sequence[str]) -> list[int]:
    """Return where the words of a side stand, and not those of a right angle, or of a straight line, « la droite »."""
    return [
        at
        for at, word in enumerate(said)
        if (_is(word, "LEFT") or _is(word, "RIGHT"))
        and not _has(said[at + 1 : at + 2], "NO_SIDE")
        and not (word == "left" and _has(said[at - 1 : at], "IS") and said[at + 1 : at + 2] != ["of"])
        and not (word == "droite" and said[at - 1 : at] in (["la"], ["une"], ["cette"]))
        and not (word.startswith("recht") and said[at - 1 : at] == ["im"])
    ]


def _of_line(said: Sequence[str], sides: Sequence[int]) -> str:
    """Return the sign of θ_2 with the elbow on a side of the line that leads from the base to the tool; UNCLEAR of any other."""
    elbow = next(at for at, word in enumerate(said) if _is(word, "ELBOW"))
    line = next((at for at, word in enumerate(said) if at > sides[0] and _is(word, "LINE")), None)
    ends = [word for word in said[line:] if _is(word, "BASE") or _is(word, "TOOL")] if line is not None else []
    is_plain = len(sides) == 1 and elbow < sides[0] and not _has(said, "NOT")
    if not is_plain or [_is(word, "BASE") for word in ends] != [True, False]:
        return UNCLEAR
    return LEFT_OF_LINE if _is(said[sides[0]], "LEFT") else RIGHT_OF_LINE


def _of_turn(said: Sequence[str], clockwise: re.Match[str]) -> str | None:
    """Return the sign of θ_2 where the forearm is turned so against the upper arm; None where a sentence says how angles are counted."""
    if _has(said, "COUNTED"):
        return None
    is_plain = _has(said, "AGAINST") and not _has(said, "NOT")
    if not is_plain:
        return UNCLEAR
    return RIGHT_OF_LINE if clockwise["counter"] else LEFT_OF_LINE
