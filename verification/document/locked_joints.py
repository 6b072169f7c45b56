r"""Sentences that lock joints: "The brake holds the elbow; only $\theta_1$ moves", "$d_2$ ist konstant", "the third joint is locked".

Which joint is held is not read: whatever it is, an equation of rates behind it may lack what that joint would add.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

LOCKED = "locked"  # joints: rates behind it are those of others; with the letter that is said to be constant

MAY_LOCK = regex(
    r"lock|block|brak|clamp|jam|stuck|broken|froz|freez|fixed|[ck]onst|costant|unchang|inchang|unver|only|alone|keep|held|holds?\b|still|immobil|stand|verrou|bloqu|frein|panne|seul|garde|figé|gesperrt|sperr|gebremst|brems|blockier|fest|verriegel|arretier|behält|nur\b|allein|fren|solo|sólo|inmóvil|quiet|conserva|mantien|rest|trav|apenas|só\b|reste|fail|dead|defekt|ausgefallen|switched off|averi"
)
_lists = WordLists("""
LOCKED locked blocked braked clamped jammed stuck broken frozen immobile immobilised immobilized locks blocks seized failed verrouill~ bloqué~ bloque bloquent bloquons freiné~ panne immobile~ immobilis~ figé~ coincé~ gesperrt~ sperrt sperren gebremst~ blockiert~ verriegel~ arretier~ festgeklemmt~ festgehalten~ festgestellt~ klemmt defekt ausgefallen bloquead~ frenad~ inmóvil~ averiad~ trabad~ bloccat~ frenat~ blocca bloccano fermo ferma travad~ parad~ bloquead~
HELD fixed constant constants fixe fixes fixé~ constante~ constant~ fest konstant~ fijo fija fijos constante~ fisso fissa costante~ fixo fixa unchanged inchangé~ unverändert~ value valeur wert valor valore still
HOLDS is are stays stay remains remain kept keeps keep held holds hold stands stand being est sont reste restent demeure garde gardent conserve conservent maintenu~ tient bleibt bleiben ist sind wird werden behält behalten gehalten hält es son queda quedan permanece~ mantiene~ conserva~ está están è sono resta restano rimane rimangono tiene tenuto mantém fica permanece~
PART joint joints elbow shoulder wrist axis motor motors slide telescope forearm drive actuator articulation~ coude épaule poignet axe moteur~ glissière~ liaison~ gelenk~ ellbogen schulter handgelenk achse~ motor motoren schub schubgelenk antrieb unterarm articulaci~ codo hombro muñeca eje motor giunt~ gomito spalla polso asse motore motori junta~ cotovelo ombro punho eixo
""")
_is, _has = _lists.holds, _lists.has
_JOINT = regex(r"(?:\\(?:var)?(?:theta|phi)|[qdr])(?:\s*_\s*(?:\{\s*\w+\s*\}|\w))?")
_BRAKE = regex(
    r"(?<!\S)(?:brakes?|locks?|pins?|bolts?|freins?|bremsen?|frenos?|freni|freno|freios?) (?:\S+ )?(?:holds?|keeps?|locks?|blocks?|tient|bloque|retient|immobilise|hält|halten|blockiert|sperrt|sujeta|mantiene|bloquea|tiene|blocca|segura|on) "
)
_ALONE = regex(
    r"(?<!can )(?<!may )(?<!\S)(?:(?:only|seule?s?|nur|solo|sólo|solamente|soltanto|apenas|somente|só) (?:[^,;:.\s]+ ){0,4}?(?:moves?|turns?|rotates?|slides?|varies|vary|runs?|works?|changes?|bouge|tourne|varie|se déplace|bewegt|dreht|ändert|läuft|mueve|gira|varía|muove|ruota|varia|move|is driven|is actuated)"
    r"|(?:moves?|turns?|bouge|tourne|bewegt sich|dreht sich|se mueve|si muove|gira) (?:only|alone|seule?|nur|allein|solo|da solo)"
    r"|(?:does not|do not|doesn' t|don' t|cannot|can' t|no longer) (?:\S+ )?(?:move|turn|rotate|slide|change|vary)(?! (?:its|the|this|a))|ne (?:bouge|tourne|varie|se déplace|bougent|tournent) (?:pas|plus)|(?:bewegt|dreht|ändert) sich (?:nicht|nicht mehr)|no (?:se )?(?:mueve|gira|cambia)|non (?:si )?(?:muove|gira|cambia)) "
)
_FEW = 4  # words from a verb to what it says
_FASTENED = (
    "to",
    "on",
    "in",
    "by",
    "at",
    "à",
    "au",
    "sur",
    "an",
    "am",
    "mit",
    "a",
    "al",
    "en",
)  # and no joint that is held
_JOINING = (",", "and", "et", "und", "y", "e")
_BY_RATE = regex(r"\\dot\s*\{?\s*(?:\\(?:var)?theta|[qdr])[^=]*=\s*0\s*\Z")


def locks(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence holds a joint still."""
    small = words.lower()
    said = small.split()
    has_joint = any(map(_JOINT.fullmatch, map(str.strip, formulas)))
    names_part = has_joint or _has(said, "PART")
    if small.endswith("? ") or not (names_part or _BRAKE.search(small)):
        return any(map(_BY_RATE.search, map(str.strip, formulas)))
    if _has(said, "LOCKED") or _ALONE.search(small) or _BRAKE.search(small):
        return True
    return any(_is(each, "HOLDS") and _is_held(said, place) for place, each in enumerate(said))


def held_letters(words: str, formulas: Sequence[str]) -> list[str]:
    """Return the letters of which alone a sentence says that they are constant, "$d_2$ est une constante"; none where it may hold another joint."""
    small = words.lower()
    said = small.split()
    if _has(said, "LOCKED") or _ALONE.search(small) or _BRAKE.search(small):
        return []
    found: list[str] = []
    for place, each in enumerate(said):
        if not (_is(each, "HOLDS") and _is_held(said, place)):
            continue
        at = (
            place - 1 if place and _is(said[place - 1], "HELD") else place
        )  # "¤ konstant bleibt", and "bleibt ¤ konstant"
        count = _listed_before(said, at) or _listed_before(said, place + 2)
        end = said[: at if _listed_before(said, at) else place + 2].count("¤")
        letters = [formula.strip() for formula in formulas[end - count : end]]
        if not letters or not all(map(_JOINT.fullmatch, letters)):
            return []
        found += letters
    return found


def _listed_before(said: Sequence[str], place: int) -> int:
    """Return how many formulas stand before a word, one after another: "¤ , ¤ and ¤ are"."""
    count = 0
    for each in reversed(said[:place]):
        if each == "¤":
            count += 1
        elif each not in _JOINING:
            break
    return count


def _is_held(said: Sequence[str], place: int) -> bool:
    """Whether a verb says that something stays as it is: "is kept constant", "fest bleibt", and not "is fixed to"."""
    near = [at for at in range(place - 1, min(place + _FEW, len(said))) if at >= 0 and _is(said[at], "HELD")]
    return any(said[at + 1] not in _FASTENED if at + 1 < len(said) else True for at in near)
