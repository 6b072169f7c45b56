"""Sentences that count coordinates from elsewhere than the base of the arm: "Coordinates are taken from the corner of the table", "The shoulder has the coordinates $(a, b)$"."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.hearing import hears
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

MAY_TELL_ORIGIN = regex(  # what no such sentence lacks, in small letters
    r"origin|ursprung|nullpunkt|origen|zero of the|zéro des|coord|koord|shoulder|épaule|schulter|hombro|spalla|ombro|base|basis|foot|\\bpied|fuß"
)
_lists = WordLists("""
ORIGIN origin zero origine ursprung nullpunkt origen origem
OF_BASE of the coordinate~ coordinates system base world frame axes 0 des de du la le l' coordonnées repère der des koordinaten koordinatensystems basis las los coordenadas del sistema delle coordinate da das
LIES lies sits stands placed located taken chosen put at in trouve situé située pris prise choisi choisie placé placée liegt gelegt gewählt sitzt está sitúa toma elige trova posta preso scelta fica
IS is est ist es è é
COUNTED taken measured counted reckoned read given mesurées comptées prises données relevées gemessen gezählt genommen medidas tomadas contadas misurate prese contate
FROM from relative depuis partir rapport à von vom ab aus desde dal dalla da
COORDINATES coordinates coordonnées koordinaten coordenadas coordinate
BASE base robot~ arm's arm shoulder first joint 1 foot fixed axis axes z_0 centre center middle pedestal column mount common own its same intersection world global z-axis ¤ the a of at in on as and so it that point where to be which with intersect meet both with respect always here
 épaule première premier articulation socle pied axe embase centre bras fixe monde intersection liaison la le l' d' un une du de des au à dans sur en et est
 schulter~ basis~ sockel~ fuß~ erst~ gelenk~ achse~ mitte roboter~ arm~ fest~ schnittpunkt der die das dem den des im in am an auf und ist zum
 hombro primera primer articulación pie eje fija centro brazo el los las del al con y
 spalla primo giunto piede asse fisso centro braccio il lo nella nel del della al alla e
 ombro primeira junta pé eixo fixa braço o os as no na do da ao e
ELSEWHERE tool~ tip hand gripper~ elbow~ wrist~ end-effector corner~ outil main pince coude poignet coin werkzeug~ greifer~ hand ellbogen~ ecke~ herramienta mano codo esquina utensile gomito angolo ferramenta garra cotovelo canto table floor ground tisch boden sol
SHOULDER base shoulder foot épaule pied socle schulter basis sockel fuß hombro pie spalla piede ombro pé
OF_ARM of the arm robot du de la l' bras robot des der roboters arms del brazo della dell'
HAS has is est ist es è é stands lies sits se a trouve hat steht liegt tiene está ha si tem fica
""")  # fmt: skip
_is, _has = _lists.holds, _lists.has
_OTHER_FRAME = regex(r"\{?[1-9n]\}?|\\\{[1-9n]\\\}|[OFR]_\{?[1-9n]\}?")
_TUPLE = regex(r"\s*\\?(?:left)?\(\s*[^(),;]+(?:[,;]\s*[^(),;]+)+\\?(?:right)?\)(?:\^\{?(?:T|\\top)\}?)?\s*")
_NOUGHT = regex(r"\s*\\?(?:left)?\(\s*0(?:\s*[,;]\s*0)*\s*\\?(?:right)?\)")
_ENDS = frozenset(",:.;!?")
_FAR = 8
_SHIFTS = regex(r"\bby \Z|height \Z")
LETTER_OF_HEIGHT = regex(r"(?:[a-zHDL]|\\ell)(?:\s*_\s*(?:\{\s*\w+\s*\}|\w))?")


def shift_of_base(words: str, formulas: Sequence[str]) -> str:
    """Return the letter by which a shoulder is shifted, or of the height at which it stands: "shifted by d2 along it"; "" where none is said."""
    found = hears("OTHER_ORIGIN", words)
    if found is None or "¤" in found.group() or not _SHIFTS.search(found.group()):
        return ""
    behind, place = words[found.end() :].split()[:1], words.count("¤", 0, found.end())
    return "".join(formulas[place : place + 1] if behind == ["¤"] else behind).strip()


def is_from_elsewhere(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence counts coordinates from a place that is not the base of the arm, or has the base elsewhere."""
    numbers = iter(formulas)
    said = [f"¤{next(numbers, '')}" if each == "¤" else each for each in words.lower().split()]
    return any(
        _is_origin_at(said, place) or _is_counted_from(said, place) or _is_base_at(said, place)
        for place in range(len(said))
    )


def _clause(said: Sequence[str]) -> list[str]:
    end = next((place for place, word in enumerate(said) if word in _ENDS), len(said))
    return [*said[:end]]


def _is_origin_at(said: Sequence[str], place: int) -> bool:
    if not _is(said[place], "ORIGIN") or (said[place] == "zero" and said[place + 1 : place + 2] != ["of"]):
        return False
    at = place + 1
    while at < len(said) and _is(said[at], "OF_BASE") and not _is(said[at], "LIES"):
        at += 1
    behind = _clause(said[at:])
    if said[place] in ("zero", "nullpunkt") and not _has(said[place:at], "COORDINATES"):
        return False
    lies = next((k for k, word in enumerate(behind[:4]) if _is(word, "LIES")), None)
    if behind and (_is(behind[0], "IS") or lies == 0) and lies is not None:
        return _is_elsewhere(behind[lies + 1 :])
    return bool(behind) and _is(behind[0], "IS") and _has(behind[1:5], "ELSEWHERE")


def _is_counted_from(said: Sequence[str], place: int) -> bool:
    if not _is(said[place], "COORDINATES"):
        return False
    behind = _clause(said[place + 1 :])
    counted = next((k for k, word in enumerate(behind[:5]) if _is(word, "COUNTED")), None)
    if counted is None or not _has(behind[counted + 1 : counted + 3], "FROM"):
        return False
    return _is_elsewhere(behind[counted + 2 :])


def _is_base_at(said: Sequence[str], place: int) -> bool:
    """Whether the base is at a point with coordinates that are not all zero."""
    if not _is(said[place], "SHOULDER"):
        return False
    near = [word for word in _clause(said[place + 1 : place + 1 + _FAR]) if not _is(word, "OF_ARM")]
    is_at = bool(near) and _is(near[0], "HAS")
    points = [word[1:] for word in near if word.startswith("¤")]
    return is_at and bool(points) and _TUPLE.fullmatch(points[0]) is not None and _NOUGHT.match(points[0]) is None


def _is_elsewhere(phrase: Sequence[str]) -> bool:
    """Whether a place is told in other words than those for the base; that of another frame is not meant."""
    if any(_OTHER_FRAME.fullmatch(word.removeprefix("¤").strip()) for word in phrase):
        return False
    return not all(word.startswith("¤") or len(word) < 2 or _is(word, "BASE") for word in phrase)
