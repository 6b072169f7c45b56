r"""What a text tells of an arm's build, letter by letter: "Le premier segment, de longueur $l_1$, fait l'angle $\theta_1$ avec l'axe $x_0$".

A letter turns, slides, is a length, a height or a distance that may be either, as the nearest word of a table says; what the words of its clause
say besides, of an axis or of a direction, goes with it. Which chain these are of is told by equations that hold: nothing is decided here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, takewhile

from armproof.verification.document.hearing import formulas_of, with_axes, words_of
from armproof.verification.document.model import ToldPart
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

MAY_TELL_CHAIN = regex(  # in small letters: what no text lacks that tells of a length, a slide or a height of an arm
    r"length|links?\b|segment|\bbars?\b|\brods?\b|\bbarres?\b|glied|eslab|bracci|slid|extend|telescop|rises|raise|height|distance|longueur|gliss|coulisse|translat|allong|hauteur|länge|läng|schieb|höhe|abstand|longitud|desliza|altura|distancia|lunghezz|scorr|altezz|distanz|compriment|desliza"
)
OF_EACH = "of each"  # from the vertical, as every other angle counts
TURN, SLIDE, LENGTH, HEIGHT, DISTANCE, OFFSET = "turn", "slide", "length", "height", "distance", "offset"
END, PLANE = "end", "plane"  # the name of the tool's point; the axes between which the arm moves
UPRIGHT, LIFTS = "upright", "lifts"  # the axis of a turn, and what that moves
ABSOLUTE, RELATIVE, FROM_VERTICAL = "absolute", "relative", "from vertical"  # from where an angle counts
XZ, YZ = "xz", "yz"
UP, DOWN, ALONG_X, ALONG_Y, OUTWARDS = "up", "down", "x", "y", "outwards"  # where what slides goes

_lists = WordLists("""
ANGLE angle angles rotation rotations bearing inclination inclinaison orientation azimut azimuth winkel drehwinkel gelenkwinkel ángulo ángulos angolo angoli ângulo ângulos
TURNS turn~ rotat~ pivot~ swivel~ revol~ swing~ tourn~ pivote dreh~ schwenk~ gira~ giro rota rotan ruota~ roda gira swings
LENGTH length lengths long longueur longueurs länge längen longitud longitudes lunghezza lunghezze comprimento comprimentos
LINK link links segment segments bar bars rod rods barre barres glied glieder stab stäbe eslabón eslabones barra barras braccio bracci elo elos segmenti segmento segmentos
HEIGHT height high hauteur höhe altura altezza alta alto
DISTANCE distance distances abstand entfernung distancia distanza distância
SLIDES slid~ glide~ extend~ extension~ telescop~ translat~ prismatic stroke travel~ moves advances moved coulisse~ gliss~ translation allonge~ s'allonge course avance~ télescop~ déplace sort verschieb~ schieb~ sposta~ fährt hub ausgefahren ausfahren ausfährt teleskop~ desliza~ extiende~ avanza~ desplaza~ traslad~ carrera scorr~ estende~ estensione avanza corsa trasla~ prolonga~ curso desloca~ telescóp~
RISES rise~ raise~ lift~ climbs ascends monte s'élève élève lève soulève hebt steigt angehoben anhebt sube eleva alza sale solleva
FALLS lower~ descend~ sinks drops downward~ down descend descente abaisse~ bas plonge senkt absenkt abgesenkt abwärts unten baja desciende abajo scende abbassa basso desce baixa
VERTICAL vertical~ upright z-axis senkrecht~ lotrecht~ verticale verticali hochachse
ABOUT about around autour um alrededor attorno intorno torno
BASE base column turret pedestal mast post socle colonne tourelle mât embase fût säule sockel basis turm columna torreta colonna torretta coluna
ELEVATION elevation pitch élévation hausse erhebung höhenwinkel elevación elevazione elevação
LEVEL horizontal~ orizzontale ground floor waagerecht~ waagrecht~ sol suelo suolo x-axis boden
OFFSET offset offsets shifted décalé décalée décalage déport déporté versetzt versatz desplazado desfasado spostato sfalsato deslocado lateral~ seitlich~ latéral~
TOOL tip end effector end-effector gripper hand tool extrémité bout outil pince effecteur spitze ende greifer werkzeug~ endeffektor armspitze extremo efector pinza herramienta estremità estremo punta utensile terminale extremidade ponta garra
ABOVE above over au-dessus über oberhalb encima sobre sopra acima
UNIT m metre metres meter meters mètre mètres metro metros metri cm mm millimetres millimeters centimetres centimeters
FIRST first premier première ersten primer primero primo prima primeiro primeira elbow coude ellbogen codo gomito cotovelo
SECOND second seconde deuxième zweiten segundo segunda secondo seconda
CLOCKWISE clockwise counterclockwise counter-clockwise anticlockwise anti-clockwise horaire uhrzeigersinn horario antihorario orario antiorario horário
EACH each every both all chaque tous toutes jeder jede alle beide cada ambos todos ogni entrambi tutti
FROM from depuis von vom desde dal dalla da
MEASURED measured counted mesuré mesurée compté comptée gemessen gezählt medido contado misurato contato positive positif
PLANE plane plan ebene plano piano
AXIS axis axes achsen assi ejes axe d' achse eje asse eixo along parallel parallèle parallele paralelo
SAME same même gleichen mismo stessa stesso mesmo absolute absolu absolue absolus absolues absoluten absolut absolutos absoluto assoluto assoluti all tous toutes alle todos tutti
PREVIOUS first previous preceding premier première précédent précédente ersten vorigen vorhergehenden primero primer anterior primo precedente primeiro upper second deuxième zweiten segundo secondo bras oberarm celui prolongement extension verlängerung prolongación prolungamento
RELATIVE relative relativ~ between entre zwischen tra fra
JOINT joint joints variable variables articulaire articulaires gelenkvariablen variablen articulares giunto
ALONG along suivant entlang längs lungo le_long largo longo direction
X x-axis
Y y-axis own-y-axis
OUTWARDS own-x-axis radial~ horizontally horizontal outward~ out horizontalement extend~ telescop~ télescop~ allonge~ s'allonge sort teleskop~ ausfahren ausgefahren ausfährt extiende~ estende~ prolonga~
ACROSS perpendicular~ perpendiculaire~ transvers~ senkrecht normal orthogonal~ sideways
BELT belt belts courroie~ riemen zahnriemen correa cinghia correia pulley~ parallelogram~ parallélogramme~ pantograph~
MASS mass masse massen masa massa gravity pesanteur barycentre
""")
_is, _has = _lists.holds, _lists.has
_GREEK = r"\\(?:var)?(?:theta|vartheta|phi|psi|alpha|beta|gamma)"
_ANGLE = regex(rf"{_GREEK}(?:\s*_\s*(?:\{{\s*\w+\s*\}}|\w))?'?")
_ANY = regex(r"(?:[A-Za-z]|\\(?:ell|rho|delta|lambda))(?:\s*_\s*(?:\{\s*\w+\s*\}|\w))?'?")
_SIZE = regex(
    r"(\d+(?:[.,]\d+)?)(?:\\[,;: ]|[\s~{}]|\\(?:mathrm|text|rm|unit|si))*([mc]?m)?[\s}]*"
)  # 0.4 m, 250\,\mathrm{mm}
MAY_TELL_SIZE = regex(r"\d(?:\s|~|\\[,;: ]|\$|\\(?:mathrm|text)\{)*(?:[mc]?m\b|met|mèt|mill|cent)")
_NEVER = regex(r"[xyzXYZOPTJMEABCFWSVGIijkmgnptv](?:\s*_.*)?")  # points, axes, matrices, masses
_AXIS = regex(
    r"(?:\\(?:vec|hat|mathbf|boldsymbol|overrightarrow)\s*\{?\s*)?(?:O_?0?)?([xyz])\}?(?:\s*_\s*\{?\s*0\s*\}?)?"
)
_POINT = regex(r"[PEMTHABCDQ]")
_PLANE = regex(
    r"\W*(?:O\s*,?\s*)?(?:\\vec\s*\{?\s*)?([xy])\}?\s*(?:_\s*\{?\s*0\s*\}?)?\s*,?\s*(?:\\vec\s*\{?\s*)?z\}?\s*(?:_\s*\{?\s*0\s*\}?)?\W*"
)
_LOCAL_AXIS = regex(r"(?:\\(?:vec|hat|mathbf|boldsymbol)\s*\{?\s*)?([xyz])\}?\s*_\s*\{?\s*[1-9]\s*\}?")
_FENCE = regex(r"\\(?:left|right|big|Big)?\s*[()\[\]]|[()\[\]]|\\[,;:! ]|\\q?quad|\^\{?(?:T|\\top)\}?")
_AND = frozenset("and et und y e ou or o oder".split())
_BY = frozenset("by de d' um por di".split())
_ENDS = frozenset(", ; : . ! ?".split())
_NEAR, _FAR = 4, 7  # words between a letter and one before it, and between a letter and what calls it

# a word, "" with the letters of a formula
Word = tuple[str, tuple[str, ...]]


def told_parts(sentence: str, place: tuple[int | None, int], before: tuple[int, int]) -> Iterator[ToldPart]:
    """Yield what a sentence tells of letters of an arm's build, in their order; `before` is the place of the display behind it."""
    said = _words(sentence)
    yield from (ToldPart(place, before, PLANE, axes) for axes in _planes(said))
    begin, last = 0, ""
    for k in (k for k, (_, letters) in enumerate(said) if letters):
        end = _end(said, k)
        clause = [word for word, _ in said[begin : _before_and(said, k, end)]]
        left = [word for word, _ in reversed(said[max(begin, k - _FAR) : k])]
        right = [word for word, _ in said[k + 1 : end]][:_FAR]
        begin = end if end < len(said) and not said[end][1] else k + 1
        if _has(clause, "MASS"):
            continue
        for letter in said[k][1]:
            kind = _kind(letter, left, right) or (LENGTH if last == LENGTH and _goes_on(letter, left) else "")
            last = kind
            if kind:
                yield ToldPart(place, before, kind, letter, frozenset(_marks(kind, clause, right)))


def _end(said: Sequence[Word], k: int) -> int:
    """Return where the clause of a letter ends: at a stop, at the next letter; behind "measured from …", if that follows."""
    end = next((j for j in range(k + 1, len(said)) if said[j][0] in _ENDS or said[j][1]), len(said))
    if end < len(said) and said[end][1]:  # "along $y$ by $d_2$ and down by $d_3$"
        end = next((j for j in range(max(k + 1, end - _NEAR), end) if said[j][0] in _AND), end)
    behind = said[end + 1][0] if end + 1 < len(said) and said[end][0] == "," else ""
    if not _is(behind, "MEASURED"):
        return end
    return next((j for j in range(end + 1, len(said)) if said[j][0] in _ENDS | _AND or said[j][1]), len(said))


def _before_and(said: Sequence[Word], k: int, end: int) -> int:
    """Return where the words end that go with a letter: behind "and" stands what is said of the next, "along $y$ by $d_2$ and downwards by $d_3$"."""
    is_next = end < len(said) and bool(said[end][1])
    return next((j for j in range(k + 1, end) if said[j][0] in _AND), end) if is_next else end


def _goes_on(letter: str, left: Sequence[str]) -> bool:
    """Whether a letter goes on from a length: "the upper arm has length $l_2$ and the forearm $l_3$"."""
    return not letter.startswith("q") and len(left) <= _NEAR and any(word in _AND for word in left)


def _words(sentence: str) -> list[Word]:
    """Return the words of a sentence, letters that are listed as one."""
    plain = with_axes(" ".join(sentence.split()))
    formulas, said = formulas_of(plain), words_of(plain).lower().replace("le long", "le_long").split()
    if said.count("¤") != len(formulas):
        return []
    numbers = iter(formulas)
    found: list[Word] = []
    for place, word in enumerate(said):
        if place and _is(word, "UNIT") and found[-1][1] and found[-1][1][0][0].isdigit():
            continue
        formula = next(numbers) if word == "¤" else word
        size = _size(formula, (*said[place + 1 :], "")[0])
        if word != "¤" and not size:
            found.append((word, ()))
            continue
        local = _LOCAL_AXIS.fullmatch(formula.strip())
        axis, plane = _AXIS.fullmatch(formula.strip()), _PLANE.fullmatch(formula)
        letters = () if axis or plane or local else (size,) if size else tuple(_letters(formula))
        if axis:
            found.append((f"{axis[1]}-axis", ()))
        elif local:
            found.append((f"own-{local[1]}-axis", ()))
        elif plane:
            found.append((f"{plane[1]}z", ()))
        elif letters and _listed(found):
            while found[-1][0]:
                found.pop()
            found[-1] = ("", (*found[-1][1], *letters))
        else:
            found.append(("" if letters else "¤", letters))
    return found


def _size(formula: str, behind: str) -> str:
    """Return the length that a number with a unit is, "0.4 m", or "" for anything else; its unit stands in the formula or is the word behind."""
    found = _SIZE.fullmatch(formula.strip())
    unit = (found[2] or (behind if _is(behind, "UNIT") else "")) if found is not None else ""
    if found is None or not unit:
        return ""
    return f"{found[1].replace(',', '.')} {'mm' if unit.startswith('mi') else 'cm' if unit.startswith('ce') else 'm' if unit.startswith(('me', 'mè')) else unit}"


def _planes(said: Sequence[Word]) -> Iterator[str]:
    """Yield the upright planes that a sentence names: "le plan vertical $(x, z)$"."""
    for (word, letters), (behind, _) in pairwise(said):
        if behind in (XZ, YZ) and (_is(word, "PLANE") or _is(word, "VERTICAL")) and not letters:
            yield behind


def _listed(found: Sequence[Word]) -> bool:
    """Whether what comes goes on a list of letters: a comma or "and" alone stands between."""
    between = 0
    while between < len(found) and (found[-1 - between][0] in _AND or found[-1 - between][0] == ","):
        between += 1
    return 0 < between < len(found) and bool(found[-1 - between][1])


def _letters(formula: str) -> Iterator[str]:
    """Yield the letters of a formula that may be joints or lengths: of a list, of OP = r, of l_1 = 0.4."""
    for part in _FENCE.sub(" ", formula).split(","):
        sides = [side.strip() for side in part.split("=")]
        own = [
            side
            for side in sides
            if _ANGLE.fullmatch(side) or _POINT.fullmatch(side) or (_ANY.fullmatch(side) and not _NEVER.fullmatch(side))
        ]
        if own and len(sides) <= 2:
            yield own[0]


def _kind(letter: str, left: Sequence[str], right: Sequence[str]) -> str:
    """Return what the words nearest to a letter call it, those before it first."""
    if _ANGLE.fullmatch(letter):
        return TURN
    if _POINT.fullmatch(letter):
        return END if _has((*left[:3], *right[:4]), "TOOL") else ""
    is_q = letter.startswith("q")
    before = next((kind for word in left if (kind := _called(word, is_q))), "")
    behind = next((kind for word in right if (kind := _called(word, is_q))), "")
    kind = before or behind or (HEIGHT if _is_above(right) else "")
    lead = [*takewhile(lambda word: word != ",", left)]
    if _has(lead, "OFFSET"):
        return OFFSET
    if kind in ("", LENGTH) and any(
        _is(word, "ALONG") and any(map(_is_axis, right[k + 1 : k + 4])) for k, word in enumerate(right)
    ):
        return SLIDE
    if not kind and left[:1] and left[0] in _BY and any(map(_is_axis, left[1:3])) and _has(left[2:4], "ALONG"):
        return SLIDE  # along y by d_2
    near = (*left, *right) if kind == DISTANCE else lead if kind in (HEIGHT, LENGTH) else ()
    if any(_is(word, each) for word in near for each in ("SLIDES", "RISES", "FALLS")):
        return SLIDE
    return kind


def _is_above(right: Sequence[str]) -> bool:
    """Whether a length is one above the floor."""
    return (
        bool(right) and _is(right[0], "ABOVE") and any(_is(each, "LEVEL") or _is(each, "BASE") for each in right[1:4])
    )


def _is_axis(word: str) -> bool:
    return word.endswith("-axis") or _is(word, "VERTICAL")


def _called(word: str, is_q: bool) -> str:
    kinds = [("SLIDES", SLIDE), ("RISES", SLIDE), ("FALLS", SLIDE), ("DISTANCE", DISTANCE)]
    turns = [("ANGLE", TURN), ("TURNS", TURN)]
    lengths = [("LENGTH", LENGTH), ("HEIGHT", HEIGHT), ("LINK", LENGTH)]
    for name, kind in (*turns, *kinds) if is_q else (*lengths, *kinds, ("JOINT", SLIDE)):
        if _is(word, name):
            return kind
    return ""


def _has_level_axis(clause: Sequence[str]) -> bool:
    """Whether what lies level is an axis about which something turns, and nothing to count an angle from."""
    return any(
        {"LEVEL", "AXIS"} <= {name for name in ("LEVEL", "AXIS") for word in pair if _is(word, name)}
        for pair in pairwise(clause)
    )


def _has_upright_axis(clause: Sequence[str]) -> bool:
    return any(_is(one, "AXIS") and _is(other, "VERTICAL") for one, other in pairwise(clause))


def _is_across(clause: Sequence[str]) -> bool:
    """Whether something slides across a link: "perpendicular to the link"."""
    return any(_is(word, "ACROSS") and _has(clause[at : at + _NEAR], "LINK") for at, word in enumerate(clause))


def _counts_from_vertical(clause: Sequence[str]) -> bool:
    """Whether an angle counts from the vertical, in a sense that no clock tells: what that is seen from is not known."""
    if any(_is(word, "CLOCKWISE") for word in clause):
        return False
    places = (place for place, word in enumerate(clause) if _is(word, "FROM"))
    return any(_is(word, "VERTICAL") for place in places for word in clause[place + 1 : place + 4])


def _marks(kind: str, clause: Sequence[str], right: Sequence[str]) -> Iterator[str]:
    """Yield what the words of a clause say of its letter besides."""
    has = {name for name in ("VERTICAL", "ABOUT", "BASE", "ELEVATION", "LEVEL", "SAME", "PREVIOUS", "RELATIVE", "RISES", "FALLS", "X", "Y", "OUTWARDS")
           if any(_is(word, name) for word in clause)}  # fmt: skip
    if _has_level_axis(clause) and not any(word.endswith("-axis") for word in clause):
        has.discard("LEVEL")
    if kind == END:
        yield from (mark for name, mark in (("FIRST", "1"), ("SECOND", "2")) if any(_is(word, name) for word in right))
        return
    if kind == TURN:
        if (
            {"ABOUT", "VERTICAL"} <= has
            or _has_upright_axis(clause)
            or ("BASE" in has and not has & {"RISES", "ELEVATION"})
        ):
            yield UPRIGHT
        if has & {"RISES", "ELEVATION"}:
            yield LIFTS
        if _counts_from_vertical(clause) and not has & {"ABOUT", "RELATIVE"}:
            yield OF_EACH if _has(clause, "EACH") else FROM_VERTICAL
        if (has & {"LEVEL", "SAME"} and not has & {"RELATIVE", "ABOUT"}) or _has(clause, "BELT"):
            yield ABSOLUTE
        if has & {"RELATIVE", "PREVIOUS"} and "LEVEL" not in has:
            yield RELATIVE
        if "FALLS" in has:
            yield DOWN
        return
    if "FALLS" in has and not ({"RISES"} & has and kind == SLIDE) and "up" not in clause:
        yield DOWN
    elif kind == SLIDE and ("up" in clause or has & {"RISES", "VERTICAL"}):
        yield UP
    if "X" in has:
        yield ALONG_X
    if "Y" in has or (kind == SLIDE and _is_across(clause)):
        yield ALONG_Y
    if "OUTWARDS" in has and not has & {"RISES", "FALLS"}:
        yield OUTWARDS
