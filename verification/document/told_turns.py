"""Sentences that lead to an angle or an angular velocity that is not that of the hand in the base: "The angle between the last link and the vertical is", "A gyro on the inner bar reads".

What names an angle, or how fast something turns, passes where all of its words are those of the direction of the hand, counted from the first axis of the base.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

OTHER_TURN = "other turn"

_lists = WordLists("""
ANGLE angle orientation direction inclination bearing attitude heading inclinaison winkel orientierung richtung neigung ángulo orientación dirección angolo orientamento direzione ângulo orientação direção
TURNS turns turn turning rotates gyro spins open opens tourne tournent pivote s'ouvre dreht drehen gira giran girano ruota ruotano
OF_SPEED angular angulaire winkelgeschwindigkeit drehgeschwindigkeit angolare
RATE velocity speed rate vitesse geschwindigkeit velocidad velocità velocidade
LEADS is are reads equals with angle be by est sont vaut avec ist lautet mit es son con è sono é são com
OTHER_QUANTITY position~ velocities jacobi~ acceleration~ torque~ force~ rotations matrix matrice matriz joint
OF_HAND the a an its between this that angle~ orientation direction inclination attitude bearing heading of hand tool~ gripper~ end-effector effector end tip last third outer second link bar forearm arm robot~ manipulator~ makes make made has have with to x-axis horizontal~ base~ world fixed ground frame axis is are turn~ rotat~ angular velocit~ speed rate~ total absolute sum both all three two joints together in plane planar and then thus hence so also therefore now finally where here it by from measured counted counterclockwise counter-clockwise positive as for on gyro reads equals seen be we get obtain find given simply just resulting last about around isolat~ solv~ finally rearrang~ written closed-form solution yields gives overall global be's pose posture whose respect relative inertial since because simply just add adds
 l' la le les un une d' de du des angle~ orientation direction inclinaison main pince outil effecteur organe terminal dernier dernière segment barre bras avant-bras robot fait que entre avec axe repère base sol est sont tourne vitesse angulaire rotation totale absolue somme et donc alors ainsi isolant autour finalement par rapport à au dans plan on a obtient trouve puisque comme simplement s'ajoutent s'additionnent ajoutent
 der die das des dem den winkel~ orientierung richtung hand~ greifers werkzeug~ endeffektor~ letzten letzte gliedes glieds glied zwischen stabs unterarms arms roboters gegen zur mit und ist beträgt also somit dann dreht sich winkelgeschwindigkeit drehgeschwindigkeit in der ebene basis~ im gegenüber um auflösen ergibt folgt x-achse horizontalen waagerechten lautet aus weil einfach addieren
 el los las del al ángulo orientación dirección mano pinza herramienta efector último última eslabón brazo entre robot con eje base es son y por tanto gira velocidad angular total suma plano alrededor despejando respecto a de la en
 il lo gli dello della dell' angolo orientamento direzione mano pinza utensile organo ultimo ultima braccio tra fra robot con asse base è sono e quindi ruota velocità angolare totale somma piano attorno isolando rispetto alla nel di
 o a os as do da dos das ângulo orientação direção mão garra ferramenta efetuador último elo braço entre com eixo base é são e portanto gira velocidade angular total soma plano isolando em relação à no
FROM relative respect rapport gegenüber respecto rispetto relação from to with avec mit con com
BETWEEN between entre zwischen tra fra
LINK link links bar bars forearm arm segment segments barre barres bras avant-bras glied glieds glieder glieder eslabón braccio elo
ABOUT about around autour um alrededor attorno intorno
UP_AXIS vertical~ y-axis senkrecht~ lotrecht~ y-achse verticale
""")  # fmt: skip
_is, _has = _lists.holds, _lists.has
_NAME_OF_HAND = regex(
    r"\s*(?:\\(?:hat|vec|mathbf)\s*\{?\s*)?(?:x(?:_\{?0\}?)?|O_\{?0\}?x(?:_\{?0\}?)?|\\(?:var)?(?:phi|psi|alpha|gamma|omega|theta)(?:_\{?\w\}?)?)\}?\s*"
)
_MOST = 25  # words of a sentence that leads to what it names


def is_other_turn(said: Sequence[str]) -> bool:
    """Whether a sentence leads to an angle or a rate of turn, with words that are not all of the hand's in the base; formulas as ¤ and their LaTeX."""
    words = [word for word in said if word not in (",", ":", ".", ";")]
    if not words or len(words) > _MOST or _has(words, "OTHER_QUANTITY"):
        return False
    is_angle = _has(words, "ANGLE")
    is_rate = _has(words, "OF_SPEED") or _has(words, "TURNS")
    leads = any(_is(words[-1], kind) for kind in ("LEADS", "ANGLE", "RATE"))
    if not (is_angle or is_rate) or not leads:
        return False
    if any(_is(word, "UP_AXIS") and not _is(before, "ABOUT") for before, word in pairwise(_without_articles(words))):
        return True
    return not all(_passes(word) for word in words) or _is_of_lower_link(words)


def _without_articles(words: Sequence[str]) -> list[str]:
    return [word for word in words if word not in ("the", "la", "le", "l'", "die", "der", "el", "axis", "axe")]


def _passes(word: str) -> bool:
    if word.startswith("¤"):
        return _NAME_OF_HAND.fullmatch(word[1:]) is not None
    return len(word) < 2 or _is(word, "OF_HAND") or _is(word, "UP_AXIS")


def _is_of_lower_link(words: Sequence[str]) -> bool:
    """Whether a direction is counted from a link: "relative to the second link", "with the forearm", and not "between the last link and the base"."""
    place = next((place for place, word in enumerate(words) if _is(word, "FROM")), len(words))
    between = _has(words, "BETWEEN")
    links = [word for word in words[0 if between else place :] if _is(word, "LINK")]
    return len(links) > between
