r"""What sentences tell of a letter in passing, without a word that defines it: "The laser on the elbow delivers $\dot x$", "$\theta_2$ grows when the forearm swings to the right".

Each rule is of kinds of words. What it makes of the letter is not computed: what is written with it in the section is left open.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

OTHERWISE, RELATIVE_NOT, REORDERED = "otherwise", "not relative", "reordered"  # a letter, an angle; rows or columns
MAY_TELL_IN_PASSING = regex(  # what no such sentence lacks, in small letters
    r"rechts|right|droite|derecha|destra|direita|clockwise|gyro|giro|gyroskop|pendul|pendel|péndulo|pêndulo|inclin|neigungs|level|niveau|wasserwaage|livella|nivel|nível|imu\b"
    r"|camera|caméra|kamera|cámara|câmara|câmera|telecamera|laser|láser|tracker|scanner|sensor|capteur|arrow|vector|vecteur|vektor|pfeil|flèche|flecha|freccia|vettore|vetor|seta\b"
    r"|compass|boussole|kompass|brújula|bussola|bússola|scale|échelle|maßstab|massstab|escala|scala|base|basis|top\b|upper|oben|obere|haut|supérieur|arriba|superior|sopra|superiore|cima\b"
    r"|differen|différen|diferen"
)
_lists = WordLists("""
TOP upper top topmost uppermost first oben obere~ oberste~ erste~ haut supérieure supérieur première arriba superior primera alto superiore sopra prima cima primeira
BOTTOM lower bottom below beneath under underneath second last unten untere~ unterste~ darunter zweite~ bas inférieure inférieur dessous seconde deuxième abajo inferior debajo segunda basso inferiore sotto seconda baixo abaixo
ROW row rows entry entries line component half place ligne~ composante~ zeile~ eintrag einträge komponente~ fila~ componente~ riga righe linha~ entrada~
ALONE top oben darunter bottom haut arriba sopra cima
RATE rate rates speed speeds velocity velocities vitesse vitesses geschwindigkeit~ velocidad velocidades velocità velocidade velocidades
USUAL linear upper-arm translation~ position~ x-axis horizontal~ abscissa shoulder first linéaire~ abscisse épaule première premier lineare~ translator~ abszisse schulter~ erste~ lineal~ abscisa hombro primera primer lineari ascissa spalla primo abcissa ombro primeiro primeira advance forward vortrieb
USUAL_LAST angular rotation~ orientation~ y-axis vertical~ ordinate elbow forearm second last angulaire~ ordonnée coude avant-bras deuxième seconde dernière winkelgeschwindigkeit~ dreh~ ordinate ellbogen~ unterarm~ zweite~ ordenada codo antebrazo segunda angolar~ ordinata gomito avambraccio seconda cotovelo antebraço
GAUGE gyroscope~ gyro gyros inclinometer~ tiltmeter~ pendulum pendulums pendula imu imus accelerometer~ spirit-level gyromètre~ pendule pendules inclinomètre~ accéléromètre~ gyroskop~ kreisel~ pendel neigungsmesser neigungssensor~ wasserwaage~ giroscopio~ giróscopo~ péndulo~ inclinómetro~ acelerómetro~ nivel giroscopi pendolo pendoli inclinometr~ livella livelle giroscópio~ pêndulo~ inclinômetro~
NO_GAUGE double inverted triple simple furuta doppel~ inverse inversé doble invertido doppio inverso duplo
SHOWS show~ read~ reading~ measure~ measured measuring display~ indicat~ deliver~ give~ return~ report~ record~ supply supplies provide~ send~ yield~ track~ indique~ mesure~ relève~ fournit donne~ affiche~ renvoie lecture~ zeig~ misst messen gemessen~ liefer~ anzeig~ ablesung lies~ muestra~ mide~ medid~ entrega~ lectura~ da mostra~ misura~ fornisc~ lettura letture restituisc~ mede~ medid~ leitura~ fornece~
SENSOR camera~ caméra~ kamera~ cámara~ câmara~ câmera~ telecamera laser~ láser tracker~ scanner~ sensor~ capteur~ sonde radar~ lidar theodolit~ théodolite
TOOL hand tool tip gripper end-effector effector end flange tcp nail pen pince outil effecteur bout main werkzeug~ greifer~ hand spitze endeffektor~ pinza herramienta efector mano punta utensile estremità garra ferramenta efetuador mão ponta
ELSEWHERE elbow forearm upper-arm hinge middle midpoint half-way coude avant-bras charnière milieu ellbogen~ ellenbogen~ unterarm~ oberarm~ mitte scharnier~ codo antebrazo bisagra gomito avambraccio cerniera cotovelo antebraço dobradiça
BASE base basis shoulder foot origin pedestal ground world épaule socle origine sol schulter~ sockel~ fuß ursprung hombro origen pie spalla piede ombro origem
ARROW arrow arrows vector vectors vecteur~ flèche~ pfeil~ vektor~ flecha~ vettor~ frecc~ vetor~ seta setas
STARTS starts start starting begins beginning leads goes runs points leaves departs part commence va geht beginnt führt zeigt läuft parte empieza va comienza comincia inizia começa vai
ENDS ends end ending to towards toward at aboutit arrive finit vers endet zu zum zur bei nach termina acaba hasta hacia finisce arriva verso até
CONVERT convert~ conversion turns turn transform~ map~ takes carries translates expresses rewrites convertit convertir transforme fait passe überführt rechnet~ wandelt umrechn~ überträgt bildet convierte~ converte~ trasforma~ traduce traduit traduz leva porta passa
OF_COORDINATES coordinates components component forces force vector vectors points axes coordonnées composantes vecteur~ koordinaten komponenten kräfte vektor~ achsen coordenadas componentes vectores fuerzas ejes coordinate componenti vettor~ forze assi vetor~ forças eixos
COUNT count~ counted grow~ increase~ positive positively measure~ reckon~ zähl~ gezählt wächst wachsen zunimmt positiv gemessen messen compt~ croît croissant augmente positif positive mesur~ cuenta~ contamos crece aumenta positivo mide~ medido conta~ contiamo contato cresce positivo misur~ medimos
NO_COUNT negativ~ négati~ not never no nicht kein~ ne pas non não
RIGHT right rechts droite derecha destra direita rightwards
TO to nach vers à la zur a hacia verso para towards der
COMPASS compass boussole kompass brújula bussola bússola
SCALE scale échelle maßstab massstab escala scala
OTHER_FUNCTION difference half double product differenz hälfte doppelten produkt~ différence moitié produit diferencia mitad producto differenza metà prodotto diferença metade produto
""")  # fmt: skip
_is, _has = _lists.holds, _lists.has
_COORDINATE = regex(
    r"\s*(?:\\(?:d?dot|mathbf|vec|boldsymbol)\s*\{?\s*)?(?:[xyzp])(?:_\{?\w+\}?)?\s*\}?\s*", re.IGNORECASE
)
_VECTOR = regex(r"\s*(?:\\(?:mathbf|vec|boldsymbol|overrightarrow|dot)\s*\{?\s*)?[a-zA-Z](?:_\{?\w+\}?)?\s*\}?\s*")
_MATRIX = regex(r"\s*(?:\\(?:mathbf|boldsymbol|mathrm)\s*\{?\s*)?[TARH](?:\([^()]*\))?\s*\}?\s*")
_JOINT = regex(r"\s*(?:\\(?:var)?(?:theta|phi)|q)(?:\s*_\s*\{?\s*\w\s*\}?)?\s*")
_RATES = regex(
    r"\s*(?:\\dot\s*\{?\s*(?:\\mathbf\s*\{?\s*|\\boldsymbol\s*\{?\s*)?(?:q|\\theta)\s*\}*|J|\\mathbf\s*\{?\s*J\s*\}?)\s*"
)
_ANGLE = regex(r"\s*(?:\\(?:var)?(?:theta|phi|psi|gamma|alpha|beta)|q)(?:\s*_\s*\{?\s*\w\s*\}?)?\s*")
_SHORTHAND = regex(r"\s*[cCsS]_?\{?\d{2,3}\}?\s*")
_DOTS = regex(r"\\d?dot(?![A-Za-z])")
_RATIO = regex(r"\b1\s*(?::|/|to|zu|à|a)\s*([2-9]|\d\d+)\b")
_PLAIN = regex(r"\\(?:d?dot|mathbf|boldsymbol|vec|var)(?![A-Za-z])|[{}\s]")
_NAME_OF = {
    "x": "x-axis",
    "v_x": "x-axis",
    "y": "y-axis",
    "v_y": "y-axis",
    "v": "linear",
    "\\omega": "angular",
    **{f"{letter}_{number}": name for letter in ("q", "\\theta") for number, name in ((1, "first"), (2, "second"))},
}
_PARTING = frozenset(", ; and et und y e ed".split())
_NEAR = 10  # words


def told_in_passing(words: str, formulas: Sequence[str], before: str) -> Iterator[tuple[str, str]]:
    """Yield what a sentence tells of which letter, "" of none: with the words of those right before it."""
    said, earlier = _words(words), _words(before)
    if _reorders(_named(said, formulas), formulas):
        yield REORDERED, ""
    if _is_of_gauge(said, earlier):
        angles = [each for each in formulas if _JOINT.fullmatch(each)]
        yield from ((RELATIVE_NOT, each.strip()) for each in angles)
        if any(map(_RATES.fullmatch, formulas)):
            yield REORDERED, ""
    letters = [
        *_of_elsewhere(said, formulas, earlier),
        *_of_arrow(said, formulas),
        *_of_conversion(said, formulas, earlier),
        *_of_scale(words, said, formulas),
        *_counted_rightwards(said, formulas),
        *_by_compass(said, earlier, formulas),
    ]
    yield from ((OTHERWISE, _DOTS.sub("", each).strip()) for each in letters)
    if any(map(_SHORTHAND.fullmatch, formulas)) and _has(said, "OTHER_FUNCTION"):
        yield RELATIVE_NOT, ""


def _words(words: str) -> list[str]:
    small = words.lower().replace("upper arm", "upper-arm").replace("end effector", "end-effector")
    return small.replace("spirit level", "spirit-level").replace("niveau à bulle", "inclinomètre").split()


def _named(said: Sequence[str], formulas: Sequence[str]) -> list[str]:
    """Return words in which letters of coordinates, of joints and of velocities stand as words."""
    letters = iter(formulas)
    return [_NAME_OF.get(_PLAIN.sub("", next(letters, "")), each) if each == "¤" else each for each in said]


def _reorders(said: Sequence[str], formulas: Sequence[str]) -> bool:
    """Whether a sentence of rates says what stands above and below, and not the usual: x, the linear part, or the first joint above."""
    if not _has(said, "RATE") or _is_denied(said):
        return False
    tops = [place for place, word in enumerate(said) if _is(word, "TOP") and _stands(said, place)]
    bottoms = [place for place, word in enumerate(said) if _is(word, "BOTTOM") and tops and place > tops[0]]
    of_rates = any(map(_RATES.fullmatch, formulas)) or any(_is(said[place], "ALONE") for place in tops)
    if not tops or not bottoms or not of_rates:
        return False
    parted = max((place for place in range(bottoms[0]) if said[place] in _PARTING), default=bottoms[0])
    above, below = (
        [word for place, word in enumerate(said) if place not in (*tops, *bottoms) and (place < parted) is is_above]
        for is_above in (True, False)
    )
    is_usual = _has(above, "USUAL") or _has(below, "USUAL_LAST")
    return not is_usual or _has(above, "USUAL_LAST") or _has(below, "USUAL")


def _stands(said: Sequence[str], place: int) -> bool:
    """Whether a word for above is of a row, or stands alone: no "upper arm", no "first joint"."""
    return _is(said[place], "ALONE") or _has(said[place + 1 : place + 2], "ROW")


def _is_denied(said: Sequence[str]) -> bool:
    return _has(said, "NO_COUNT")


def _is_of_gauge(said: Sequence[str], earlier: Sequence[str]) -> bool:
    """Whether a sentence is of what sensors show that know no joint: of a gyroscope, a pendulum or a spirit level, but of no double pendulum."""
    for text in (said, earlier):
        at = [place for place, word in enumerate(text) if _is(word, "GAUGE")]
        if any(not _has(text[max(0, place - 1) : place], "NO_GAUGE") for place in at):
            return _has(said, "SHOWS") or (text is not said and _has(earlier, "SHOWS"))
    return False


def _of_elsewhere(said: Sequence[str], formulas: Sequence[str], earlier: Sequence[str]) -> Iterator[str]:
    """Yield the coordinates that a sensor delivers of another place than the tool, which the sentences before name."""
    letters = [each for each in formulas if _COORDINATE.fullmatch(each)]
    if not letters or not _has(said, "SENSOR") or not _has(said, "SHOWS"):
        return
    told = said if _has(said, "TOOL", "ELSEWHERE") else earlier
    if _has(told, "ELSEWHERE") and not _has(told, "TOOL"):
        yield from letters


def _of_arrow(said: Sequence[str], formulas: Sequence[str]) -> Iterator[str]:
    """Yield the arrow that starts at the tool, or elsewhere than at the base, and ends at the base."""
    at = next((place for place, word in enumerate(said) if _is(word, "ARROW")), len(said))
    if "¤" not in said[at : at + 3]:
        return
    letter = formulas[said[:at].count("¤") :][:1]
    starts = next((place for place in range(at, len(said)) if _is(said[place], "STARTS")), len(said))
    nouns = [
        (word, place)
        for place, word in enumerate(said)
        if place > starts and (_has([word], "TOOL", "ELSEWHERE", "BASE"))
    ]
    nouns = [each for each in nouns if not _is(each[0], "ENDS")]
    if len(nouns) < 2:
        return
    (source, first), (target, second) = nouns[:2]
    has_end = _has(said[first + 1 : second], "ENDS")
    if has_end and not _is(source, "BASE") and _is(target, "BASE") and any(map(_VECTOR.fullmatch, letter)):
        yield from letter


def _of_conversion(said: Sequence[str], formulas: Sequence[str], earlier: Sequence[str]) -> Iterator[str]:
    """Yield the matrix that leads from coordinates in the base to those in the tool."""
    letters = [each for each in formulas if _MATRIX.fullmatch(each)]
    if len({each.strip() for each in letters}) != 1 or not _has(said, "CONVERT") or _is_denied(said):
        return
    text = said if _has(said, "BASE") else [*earlier, *said]
    for place, word in enumerate(text):
        if not _is(word, "OF_COORDINATES"):
            continue
        near = text[place + 1 : place + 1 + _NEAR]
        base = next((k for k, each in enumerate(near) if _is(each, "BASE")), None)
        tool = next((k for k, each in enumerate(near) if _is(each, "TOOL")), None)
        behind = text[place + 1 :] if base is not None else []
        if base is not None and (tool is None or base < tool) and _has(behind[base + 1 :], "TOOL"):
            yield letters[0]
            return
        if base is not None or tool is not None:
            return


def _of_scale(words: str, said: Sequence[str], formulas: Sequence[str]) -> Iterator[str]:
    """Yield the letters that a sentence measures at a model, or a drawing, of another scale."""
    if _has(said, "SCALE") and any(map(_RATIO.search, (words, *formulas))):
        yield from (each for each in formulas if _COORDINATE.fullmatch(each))


def _counted_rightwards(said: Sequence[str], formulas: Sequence[str]) -> Iterator[str]:
    """Yield the angle of a joint that grows to the right."""
    letters = [each for each in formulas if _JOINT.fullmatch(each)]
    rights = [
        place for place, word in enumerate(said) if _is(word, "RIGHT") and _has(said[max(0, place - 2) : place], "TO")
    ]
    if len(letters) == 1 and rights and _has(said, "COUNT") and not _is_denied(said):
        yield from letters


def _by_compass(said: Sequence[str], earlier: Sequence[str], formulas: Sequence[str]) -> Iterator[str]:
    """Yield the angles that are told as on a compass."""
    if _has(said, "COMPASS") or _has(earlier, "COMPASS"):
        yield from (each for each in formulas if _ANGLE.fullmatch(each))
