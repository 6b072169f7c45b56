r"""What a text tells of directions: where an axis points, from where and to which side an angle is counted, along what the arm lies at zero.

"$y$ points down", "$\theta_2$ is the angle of depression below the horizontal", "when all angles are zero the arm points along $y$":
an arm that is taken from the very formulas fits each of them with any sign.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.patterns import regex

AXIS_DOWN = "axis down"  # and the axis that points there
RISES, FALLS = "rises", "falls"  # an angle that lifts what it moves from the horizontal, or lowers it, and its letter
AT_ZERO = "at zero"  # and the direction in which the arm lies where all angles are zero: x, -y, up, down

MAY_ORIENT = regex(  # what no such sentence lacks, in small letters
    r"down|\bbas\b|unten|abwärts|abajo|basso|baixo|depress|dépress|depres|elevat|élévat|elevac|elevaz|erhebung|höhenwinkel|horizont|orizzont|waagerecht|waagrecht|zero|null|cero|\bnul"
)
_LETTER_OF_AXIS = regex(r"\$\s*([xyz])(?:_\{?0\}?)?\s*\$(?:[ -](?:axis|achse|axe|eje|asse|eixo)(?!\w))?", re.IGNORECASE)
_BARE_AXIS = regex(r"(?<![\w$-])([xyz])[ -](?:axis|achse)(?!\w)", re.IGNORECASE)
_BEFORE_AXIS = regex(r"(?<!\S)(?:l' |d' )?(?:axe|eje|asse|eixo) (?=[xyz]-axis)")
_JOINT = regex(r"\\(?:var)?(?:theta|phi|beta|alpha|psi|gamma)(?:_\{?\d\}?)?|q_\{?\d\}?")
_DOWN = r"(?:down|downwards?|unten|abwärts|bas|abajo|basso|baixo)"
_UP = r"(?:up|upwards?|oben|aufwärts|haut|arriba|alto|cima)"
_OTHERS = (  # what no words between an axis and its direction are
    r"not|nicht|pas|no|non|não|of|des|du|der|del|della|do|da|tool|frame|joint|if|when|wenn|si|from|von|depuis|desde|¤|\S+-axis"
)
_POINTS = (
    r"points?|pointing|pointed|is|are|runs?|directed|positive|measured|counted|pointe|pointant|est|dirigée?|orientée?|comptée?|zeigt|weist|ist|geht|läuft|gerichtet|positiv"
    r"|apunta|está|es|dirigid[oa]|punta|è|rivolt[oa]|dirett[oa]|aponta"
)
_AXIS_DOWN = regex(
    rf"(?<!\S)([xyz])-axis (?:(?=(?:[^\s,;:.]+ ){{0,2}}?(?:{_POINTS}) )(?:(?!(?:{_OTHERS}) )[^\s,;:.]+ ){{1,5}}?)?(?:vers le |nach |hacia |verso il |para )?{_DOWN}(?!\S)"
)
_OF_FORCE = regex(  # what is down along an axis
    r"(?<!\S)(?:forces?|gravity|weight|load|acceleration|kraft|last|schwerkraft|gewicht|erdbeschleunigung|poids|pesanteur|gravité|charge|fuerza|gravedad|peso|carga|forza|gravità|carico|força|gravidade)(?!\S)"
)
_NEGATIVE = regex(r"(?<!\S)(?:negativ\w*|négati\w*)(?!\S)")
_LEVEL = r"(?:horizontal\w*|orizzontale|waagr?e?rechten?|ground|boden|sol|suelo)"
OF_LEVEL = regex(rf"\b{_LEVEL}\b")
_ARTICLE = r"(?:the |l' |la |le |der |die |dem |den |el |il |de |de l' |de la |della |dell' |à )*"
_ABOVE = rf"(?:above|over|über|oberhalb|au-dessus|dessus|encima|sobre|sopra|acima) {_ARTICLE}{_LEVEL}"
_BELOW = rf"(?:below|under|beneath|unter|unterhalb|au-dessous|en-dessous|dessous|sous|debajo|bajo|sotto|abaixo) {_ARTICLE}{_LEVEL}"
_FROM = rf"(?:from|von|ab|depuis|à partir|desde|da|dall'|dalla|a partir) {_ARTICLE}{_LEVEL} (?:¤ )?(?:aus |vers |le |la |nach |hacia |verso |il |para |measured |counted |positive )*"
_RISES = regex(
    rf"(?<!\S)(?:(?:angle of )?elevations?|élévation|elevación|elevazione|elevação|erhebungswinkel|höhenwinkel|elevationswinkel)(?!\S)|(?<!\S){_ABOVE}|(?<!\S){_FROM}{_UP}(?!\S)"
)
_FALLS = regex(
    rf"(?<!\S)(?:angle of )?(?:depression|dépression|depresión|depressione|depressão|depressionswinkel|senkungswinkel)(?!\S)|(?<!\S){_BELOW}|(?<!\S){_FROM}{_DOWN}(?!\S)"
)
_OF_ALL_AT_ZERO = regex(
    r"(?<!\S)(?:(?:all|alle|tous|toutes|todos|todas|tutti|tutte|both|beide|every|each)(?: [^\s,;:.]+){0,4}? (?:(?:are|is|sind|sont|son|sono|são|equal|gleich|to|auf|valen|est) )*(?:zero|0|null|nuls?|nulles?|cero|nulos|nulas|nulli|nulle|zeros?)(?!\S)"
    r"|(?:zero|null)[ -]?(?:position|posture|configuration|pose|stellung|lage)(?!\S)|(?:nullstellung|nulllage|nullposition)(?!\S)"
    r"|(?:position|posture|configuration|posición|posizione|configuración|configurazione|posição) (?:zéro|cero|zero|nulle|nula|nulla)(?!\S))"
)
_HINGE = r"(?:hinge|pivot|shoulder|base|first joint|charnière|épaule|scharnier|gelenk|schulter|drehpunkt|bisagra|hombro|cerniera|spalla|perno|dobradiça|ombro|articulação|articulación|articulation)"
_ALONG = regex(
    r"(?:along|entlang|längs|selon|suivant|le long|según|lungo|a lo largo|in|in richtung|dans|en|ao longo)(?: (?:the|der|die|de|del|l'|la|positive|positiven|direction|du|del|do|axes?|direzione|dirección|richtung|of|dell'|des|sens)){0,4} (-?)([xyz])-axis"
    rf"|(?:right|directly|straight|exactly|genau|direkt|senkrecht|juste|exactement|justo|directamente|proprio|esattamente|exatamente|mesmo|logo) (?:(?P<under>under|below|beneath|unter|sous|au-dessous|debajo|sotto|abaixo|embaixo)|(?P<over>above|over|über|au-dessus|encima|sopra|acima)) {_ARTICLE}(?:(?:do|da|del|dem|der|du) )?{_HINGE}(?!\S)"
    rf"|(?:points?|pointing|stands?|zeigt|weist|steht|pointe|dirigé|dressé|apunta|punta|rivolto|straight)(?: [^\s,;:.]+){{0,3}}? (?:(?P<up>{_UP})|(?P<down>{_DOWN}))(?!\S)"
)
_ARM = regex(
    r"(?<!\S)(?:arm|robot|roboter|bras|brazo|braccio|braço|manipulator|links?|tool|hand|gripper|lamp|hook|load|pince|lampe|werkzeug|greifer|haken|pinza|gancho|garra|it|er|il)(?!\S)"
)
_BY_MEANS = regex(r"(?<!\S)(?:by|using|through|par|grâce|durch|mittels|mediante|usando|tramite|através)(?!\S)")
_DENIES = regex(r"(?<!\S)(?:not|nicht|never|no|non|não|ne|n'|keine?|unlike|instead|statt)(?!\S)")


def told_orientations(sentence: str) -> Iterator[str]:
    """Yield what a sentence tells of directions, as what holds of the displays in its section: each with the sentence on a second line."""
    line = " ".join(sentence.split())
    yield from (f"{each}\n{line}" for each in _told(line))


def _told(sentence: str) -> Iterator[str]:
    plain = _BARE_AXIS.sub(r"\1-axis", _LETTER_OF_AXIS.sub(r"\1-axis", sentence))
    words = _BEFORE_AXIS.sub("", words_of(plain).lower())
    if _DENIES.search(words):
        return
    if not _OF_FORCE.search(words):
        yield from (f"{AXIS_DOWN} {found[1]}" for found in _AXIS_DOWN.finditer(words))
    formulas = formulas_of(plain)
    for kind, pattern in ((RISES, _RISES), (FALLS, _FALLS)):
        for found in pattern.finditer(words) if not _NEGATIVE.search(words) else ():
            if (letter := _letter_by(words, formulas, found)) is not None:
                yield f"{kind} {letter}"
    of_one_axis = len({*re.findall(r"[xyz]-axis", words)}) < 2  # of two, one points along the other
    if of_one_axis and _OF_ALL_AT_ZERO.search(words) and _ARM.search(words):
        lying = [*_ALONG.finditer(words)]
        for along in sorted(lying, key=lambda each: each[2] is None)[:1]:  # an axis tells more than "up"
            yield f"{AT_ZERO} {'up' if along['up'] or along['over'] else 'down' if along['down'] or along['under'] else (along[1] or '') + along[2]}"


def _letter_by(words: str, formulas: list[str], found: re.Match[str]) -> str | None:
    """Return the letter of the angle that a phrase speaks of: the one that stands right behind it, "elevation φ", the last before it, else the first behind."""
    at = words.count("¤", 0, found.start())
    before = [each.strip() for each in formulas[:at] if _JOINT.fullmatch(each.strip())]
    behind = [each.strip() for each in formulas[at:] if _JOINT.fullmatch(each.strip())]
    if _BY_MEANS.search(words, words.rfind("¤", 0, found.start()) if before else 0, found.start()):
        return None  # "we compute ¤ by decomposing the elevation angle"
    is_called = words[found.end() :].startswith(" ¤") and _JOINT.fullmatch(formulas[at].strip())
    return before[-1] if before and not is_called else next(iter(behind), None)
