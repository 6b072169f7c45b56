r"""What sentences say of the variables and lengths of an arm that is not what it has for them: $\theta_2$ that a motor turns, or that is 0 where the arm is folded, $l_1$ of the forearm.

What defines a letter passes where all of its words are those with which courses define the variables of joints and the lengths of links, and are of
its own joint or link; else the letter is left open. So are the angles of a sentence of gears and motors, and of a zero pose that is bent.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from armproof.verification.document.told_levels import MAY_READ_LEVEL, reads_level
from armproof.verification.document.told_names import Definition
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

VARIABLE = "variable"  # which angles, the letter that is left open or "" for all, and the words
ANY = "any"
OTHER_LINK = "other link"  # a length or an angle of another link than its own
FROM_BASE = "from base"  # those alone that turn about the direction of a joint before them
FROM_SPACE = "from space"  # the same, as instruments on the links show them
STROKE = "stroke"  # of a slide: how far it has left its rest, and the letter of its length there
BENT = "bent"  # those at whose zero the arm is said to be bent
STANDING = "standing"  # those alone at whose zero what they move does not stand up
RAISED = "raised"  # those at whose zero the arm is said to stand up
MAY_TELL_VARIABLE = regex(  # in small letters: what no sentence lacks that tells so, and defines no letter
    rf"{MAY_READ_LEVEL}|"
    r"gear|belt|pulley|parallelogram|pantograph|encoder|motor|transmission|reduc|coupl|linkage|engrenage|courroie|poulie|parallélogramm|codeur|moteur|motrice|getriebe|riemen|zahnr|setzung|drehgeber|engranaje|correa|polea|paralelogram|ingranag|cinghia|pulegg|engrenagem|correia|polia"
    r"|zero|zéro|null|\bnul|= *0|vanish|reference|référence|referenz|referencia|riferimento|home|rest\b|repos|ruhe|reposo|riposo|repouso|length|longueur|länge|longitud|lunghezza|comprimento|\blong\b|pulled|pushed|drawn|retract|extend|slid|sorti|rentr|tiré|auszieh|ausgezog|ausgefahr|eingefahr|eingeschob|extraíd|recogid|estratt|sfilat|rientrat|puxad|recolhid|joint [12]|articulation [12]|gelenk [12]|articulación [12]|giunto [12]"
)
_lists = WordLists("""
NOUN angle~ joint~ variable~ coordinate~ rotation~ length~ displacement~ position~ link~ distance~ offset~ articulation~ coordonnée~ longueur~ position déplacement~ corps segment~ maillon~ distance~ winkel~ gelenk~ drehwinkel~ variablen länge~ abstand abstände verschiebung~ glied~ koordinate~ verschub ángulo~ articulación articulaciones variable longitud~ desplazamiento~ eslab~ distancia~ coordenada~ angolo angoli giunt~ variabil~ lunghezz~ spostament~ distanz~ coordinat~ ângulo~ junta~ variáve~ compriment~ deslocament~ distância~ elo elos
USUAL angulo angulos girado girada giro alrededor rotado articulacion articular eslabon torsion rotacion traslacion posicion var angle~ joint~ articular variable~ coordinate~ generali~ rotation~ rotat~ revolute length~ link~ distance~ offset~ displacement~ extension~ extend~ stroke translation~ prismatic slid~ segment~ bar bars rod rods arm arms member~ limb~ limbs inner outer body bodies twist parameter~ dh denavit~ hartenberg denavit-hartenberg standard classic~ modified craig~ axis axes common normal~ perpendicular turn turns turned turning about around along measured counted reckoned positive~ counterclockwise counter-clockwise anticlockwise anti-clockwise right-hand rule sense way in radian~ rad degree~ metre~ meter~ relative~ respect respectively previous preceding before next neighbouring neighboring adjacent consecutive successive two both constant~ geometric~ known given fixed value~ vector~ column n-vector actual current unknown~ control~ actuat~ time function~ velocit~ speed~ rate~ derivative~ angular linear their corresponding correspond~ generic each every all planar robot~ manipulator~ mechanism~ upper upper-arm forearm lower shoulder~ elbow~ wrist~ waist hand gripper~ tool~ end-effector effector tip end base first second third fourth fifth sixth last frame~ origin~ direction~ makes make made one ones that those which is are with by between from to and of the a an its for at on i-th ith k-th j-th j i k n th number~ written denoted symbol~ notation here also simply usual~ proximal distal internal-variable state~ configuration~ set input~ dimension~ size~ radius reach horizontal~ x-axis z-axis old new base's own  difference~ up whole times prismatic for variable's  second~ per feet foot inch~ millimet~ centimet~ mm cm well as thus we call called name named azimuth yaw pitch roll
 articulaire~ se d'axe articul~ généralis~ rotoïde~ prismatique~ rotation~ longueur~ distance~ décalage~ déplacement~ allongement~ élongation~ extension course translation~ glissière pivot liaison~ segment~ barre~ corps bras avant-bras membre~ solide~ paramètre~ axe axes normale commune autour suivant long mesuré~ compté~ positi~ trigonométrique sens radian~ degré~ mètre~ relati~ rapport précédent~ suivant~ voisin~ consécuti~ successi~ deux constante~ géométrique~ connu~ donné~ fixe valeur~ vecteur~ vitesse~ dérivée~ angulaire~ linéaire~ chaque robot~ manipulateur~ épaule coude poignet pince outil effecteur organe terminal extrémité~ base premi~ deuxième second~ troisième quatrième cinquième sixième dernier~ repère~ origine~ direction fait font le la les l' un une d' de du des et ou par au à aux son sa ses leur leurs qui que est sont entre chacun~ respectivement horizontal~ angle~
 winkel~ gelenk~ alte~ neue~ z-achse x-achse achs~ drehgelenk~ dreh~ schub~ generalisiert~ verallgemeinert~ länge~ glied~ abstand abstände verschiebung~ hub auszug ausfahr~ segment~ stab stabs stäbe oberarm~ unterarm~ arm~ körper~ achse~ gemeinsam~ normale~ um entlang gemessen gezählt positiv~ mathematisch~ gegen den uhrzeigersinn sinn relativ~ bezüglich bezug vorig~ vorhergehend~ vorangehend~ vorherig~ nächst~ benachbart~ beide~ zwei konstant~ bekannt~ gegeben~ wert~ vektor~ geschwindigkeit~ winkelgeschwindigkeit~ ableitung~ roboter~ schulter~ ellbogen~ ellenbogen~ hand~ greifer~ werkzeug~ endeffektor~ basis~ erst~ zweit~ dritt~ viert~ fünft~ sechst~ letzt~ richtung~ der die das des dem ein eine einen einer eines von vom zum zur zwischen mit und im in am an ist sind bei jeweil~ jede~ parameter~ zum nach
 ángulo~ articula~ generaliz~ giro~ rota~ longitud~ eslab~ distancia~ desplazamiento~ barra~ brazo~ antebrazo cuerpo~ parámetro~ eje ejes normal común alrededor medid~ positiv~ antihorario sentido radian~ grado~ relativ~ respecto anterior siguiente consecutiv~ dos constante~ conocid~ dad~ valor~ velocidad~ derivada~ hombro codo muñeca pinza herramienta efector extremo primer~ segund~ tercer~ cuart~ quint~ sext~ últim~ dirección el los las del al y su con una que por lo es son cada en entre respectivamente
 angol~ se lungo vettor~ punto vista n-dimensionale coordinat~ ossia unitari~ giunt~ generalizzat~ rotazion~ lunghezz~ distanz~ spostament~ braccio bracci avambraccio ast~ membr~ corp~ parametr~ asse assi normale comune attorno intorno misurat~ positiv~ antiorario senso relativ~ rispetto precedent~ successiv~ due costant~ not~ valor~ velocità derivat~ spalla gomito polso pinza utensile estremità prim~ second~ terz~ quart~ quint~ sest~ ultim~ direzione il gli i della dell' dello dei degli delle nel nella e ed alla al da tra fra ogni con è sono rispettivamente link
 ângulo~ junta~ generalizad~ rotaç~ compriment~ elo elos distância~ deslocament~ braço~ antebraço corpo~ parâmetr~ eixo~ normal comum medid~ anti-horário relaç~ anterior próximo consecutiv~ dois duas constante~ conhecid~ dad~ valor~ velocidade~ derivad~ ombro cotovelo punho garra ferramenta efetuador primeir~ segund~ terceir~ quart~ quint~ sext~ direção o os as do da dos das no na ao em um uma e é são entre cada respectivamente
DRIVE gear~ belt~ pulley~ parallelogram~ pantograph~ transmission~ reducer~ reduction coupled coupling~ engrenage~ courroie~ poulie~ réducteur~ getriebe~ riemen~ zahnrad~ untersetzung~ übersetzung~ engranaje~ correa~ polea~ paralelogramo~ ingranagg~ cinghia cinghie pulegg~ riduttor~ engrenagem engrenagens correia~ polia~
MOTOR encoder~ codeur~ drehgeber~ motor~ moteur~ motrice~ servo~
OF_MOTOR angle~ count~ tick~ pulse~ step~ coordinate~ coordonnée~ winkel~ ángulo~ angol~ ângulo~
SPEED speed~ velocit~ vitesse~ drehzahl~ geschwindigkeit~ velocidad~ velocità
FORCES torque~ force~ friction~ inertia~ mass masses weight~ power~ backlash couple~ frottement~ inertie~ masse~ poids puissance drehmoment~ moment~ kraft~ kräfte reibung~ trägheit~ leistung~ par fricción inercia~ fuerza~ coppi~ attrit~ inerzia forz~ singul~ determin~ rank rang equation~ équation~ gleichung~ ecuacion~ terms
NOT direct~ ideal~ rigid~ without no not never neither sans pas ohne kein~ nicht sin senza sem não non
ZERO zero zeros zéro nul nuls nulle nulles null nullstellung nulllage vanish vanishes vanishing cero nulo nulos nulli home reference référence referencia riferimento
REST rest repos ruhe ruhelage ruhestellung reposo riposo repouso referenzstellung referenzlage
OF_ZERO scale~ dial~ reading~ pointer~ gauge~ échelle~ cadran~ lecture~ skala skalen zeiger anzeige~ escala~ lectura~ scala scale lettur~ quadrant~ leitura~ angle~ pose posture~ position~ configuration~ winkel~ stellung~ lage ángulo~ posición angol~ posizione ângulo~ posição encoder~ variable~ joint~ coordinate~
BENT perpendicular~ perpendiculaire~ folded folds replié~ hang hangs hanging downward~ down y-axis pend pendant rechtwinklig~ gefaltet zusammengeklappt hängt hängend plegad~ cuelga~ perpendicolar~ piegat~ appes~ dobrad~ pendurad~ backwards opposite
LOWEST lowest tiefste~ bas basse inferior
UNDER under below beneath underneath sous dessous unter unterhalb debajo bajo sotto debaixo abaixo sob
ARTICLE the its a le la l' son der die das dem den seinem el de del il della dell' o do da
PLACE hinge~ shoulder~ joint~ base ceiling axis pivot~ elbow~ charnière~ épaule~ articulation plafond axe scharnier~ schulter~ gelenk~ decke basis achse bisagra~ hombro articulación techo eje cerniera spalla giunto soffitto asse dobradiça ombro junta teto eixo
IN retracted pushed rentré~ replié~ eingeschoben eingefahren recogid~ metid~ rientrat~ chiuso recolhid~ fechad~ closed
OUT pulled drawn slid extended leaves left out sorti~ tiré~ étiré~ ausgezogen ausgefahren herausgezogen herausgefahren extraíd~ sacad~ extendid~ sfilat~ estratt~ estes~ puxad~ estendid~ stroke course hub carrera corsa curso
UPRIGHT upright vertical~ upward~ senkrecht~ lotrecht~ verticale~
RIGHT right droit rechten recto retto reto quarter quart viertel
TURN angle angles winkel ángulo angolo ângulo turn tour tours
BASE_AXIS x-axis above over über oberhalb au-dessus dessus encima sobre sopra acima horizontal~ ground floor world absolute~ absolu~ sol boden suelo pavimento space room inclination~ elevation~ inclinaison~ neigung~ inclinación inclinazione
LENGTH length lengths long longueur longueurs longue länge längen lang longitud longitudes lunghezza lunghezze lungo lunga comprimento comprimentos
BEND bent bend bends inclined tilted deviates kinked plié pliée fléchi fléchie incliné inclinée gebeugt geknickt abgewinkelt geneigt doblado doblada flexionado inclinado inclinada piegato piegata inclinato inclinata dobrado dobrada fletido fletida
IS is are be ist sind est sont vaut es vale è é = equals
CALLED called named numbered labelled labeled appelé appelée appelons nommée heißt genannt nennen llamamos llamada chiamiamo chiamato chamamos chamada call name number
""")  # fmt: skip
_is, _has = _lists.holds, _lists.has
_ORDINALS = ("first premier première erste ersten erstes erster primer primera primero primo prima primeiro primeira", "second deuxième seconde zweite zweiten zweites zweiter segundo segunda secondo seconda", "third troisième dritte dritten drittes dritter tercer tercera tercero terzo terza terceiro terceira", "fourth quatrième vierte vierten cuarto quarto", "fifth cinquième fünfte quinto", "sixth sixième sechste sexto sesto")  # fmt: skip
_NUMBER_OF = {word: number for number, words in enumerate(_ORDINALS, 1) for word in words.split()}
_PLACES = {  # what a joint or link of a name may be: the numbers, of an arm with a column below its shoulder, too
    (1, 1): "base socle embase sockel",
    (1, 2): "shoulder épaule schulter schultergelenk hombro spalla ombro upper-arm oberarm inner",
    (
        2,
        4,
    ): "elbow coude ellbogen ellbogengelenk ellenbogen codo gomito cotovelo forearm avant-bras unterarm antebrazo avambraccio antebraço outer",
}
_RANGE_OF = {word: numbers for numbers, words in _PLACES.items() for word in words.split()}
_LETTER = regex(r"\s*(?:\\(?:mathrm|mathbf|boldsymbol|dot|ddot|bar)\b\s*\{?\s*)*(?P<letter>(?:\\(?:var)?(?:theta|phi|alpha|beta|gamma|ell|psi|delta|rho)|[a-zA-Z])\s*(?:_\s*\{?\s*(?P<index>\w)\s*\}?)?)[\s}]*(?:\(t\))?\s*")  # fmt: skip
_ANGLE = regex(r"\\(?:var)?theta|\\(?:var)?phi|q")
_IS_ZERO = regex(r"\s*(?:(?:\\(?:var)?(?:theta|phi)|q)(?:\s*_\s*\{?\w\}?)?\s*=\s*)+\{?0(?:\^\\circ)?\}?\s*")
_Y_AXIS = regex(r"\s*[+-]?\s*(?:\\(?:hat|vec|mathbf)\s*\{?\s*)?y(?:_\{?0\}?)?\}?\s*")
_X_AXIS = regex(r"\s*\+?\s*(?:\\(?:hat|vec|mathbf)\s*\{?\s*)?(?:x(?:_\{?0\}?)?|\\overrightarrow\{?x\}?)\}?\s*")
_VALUE = regex(
    r"\s*[+-]?\s*(?!0+\b|180\b)\d+(?:[.,]\d+)?\s*(?:\^\s*\{?\s*\\circ\s*\}?|°|\\degree|\\text\{\s*°\})\s*|\s*[+-]?\\(?:[td]?frac\s*\{?\\pi\}?\s*\{?\d\}?|pi\s*/\s*\d)\s*"
)
_NO_MOTOR = frozenset("no aucun kein keine ningún nessun nenhum".split())
_NEAR = 4


def variables_defined(defined: Definition) -> Iterator[str]:
    """Yield which letters a definition in words leaves open: it has other words than those of joints and links, or is of another one of these."""
    phrase, formulas, is_sure = defined.phrase, defined.formulas, defined.is_sure
    letters = [found for each in defined.listed if (found := _LETTER.fullmatch(each)) is not None]
    numbers = {int(each["index"]) for each in letters if (each["index"] or "").isdigit()}
    own = [word for word in phrase if any(map(str.isalpha, word)) and not any(map(str.isdigit, word))]  # θ1
    if not letters or len(letters) != len(defined.listed) or not own or defined.is_of_path:
        return
    is_other = any(_is(word, "DRIVE") or _is(word, "MOTOR") for word in own)
    if is_sure and not is_other:
        is_other = not all(
            _is(word, "USUAL") or _is(word, "BASE_AXIS") or _is(word, "UPRIGHT") or len(word) < 2 for word in own
        )
        is_other |= any(map(_Y_AXIS.fullmatch, formulas))
    which = ANY if is_other else ""
    if is_sure and _of_other_joint(phrase, numbers):  # what goes on behind a comma may be said of another letter
        which = ANY if {"¤", "…", ","} & {*defined.text} else OTHER_LINK
    if not which and is_sure and (any(map(_X_AXIS.fullmatch, formulas)) or _has(own, "BASE_AXIS")):
        which = FROM_BASE
    if not which and is_sure and _has(own, "UPRIGHT"):
        which = STANDING
    if which:
        yield from (_open(which, each["letter"], defined.text) for each in letters)


def variables_told(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield which letters a sentence leaves open that is of what drives the joints, of a zero pose, or of the lengths of places."""
    said = words.lower().replace("upper arm", "upper-arm").split()
    text = " ".join(words.replace("¤", "…").split())
    angles = [
        found["letter"] for each in formulas if (found := _LETTER.fullmatch(each)) and _ANGLE.match(found["letter"])
    ]
    if _is_of_drive(said, any("\\dot" in each for each in formulas) or bool(angles)):
        yield from (_open(ANY, each, text) for each in angles or [""])
    if which := _bent_at_zero(said, formulas):
        at_zero = [each.strip() for latex in formulas if _IS_ZERO.fullmatch(latex) for each in latex.split("=")[:-1]]
        yield from (_open(which, each, text) for each in at_zero or angles or [""])
    if reads_level(said):
        yield from (_open(FROM_SPACE, each, text) for each in angles or [""])
    yield from (_open(f"{STROKE} {rest}", each, text) for rest, each in _strokes(said, formulas))
    yield from (_open(OTHER_LINK, each, text) for each in _lengths_of_others(said, formulas))
    if _numbers_otherwise(said):
        yield _open(ANY, "", text)


def _open(which: str, letter: str, text: str) -> str:
    return "\t".join((VARIABLE, which, letter, text))


def _of_other_joint(phrase: Sequence[str], numbers: set[int]) -> bool:
    """Whether a definition is of joints and links with numbers, or names, that are not those of its letters."""
    told = {_NUMBER_OF[word] for word in phrase if word in _NUMBER_OF}
    told |= {
        int(word) for word, before in zip(phrase[1:], phrase, strict=False) if word.isdigit() and _is(before, "NOUN")
    }
    between = any(word in ("relative", "relatively", "respect", "between", "from", "relatif", "rapport", "entre", "zwischen", "gegenüber", "respecto", "rispetto") for word in phrase)  # fmt: skip
    if not numbers or any(word.startswith(("prismati", "slid", "schub", "glissi")) for word in phrase):
        return False  # the one joint that slides may have a number of its own
    if told and not (told & numbers or (between and told & {number - 1 for number in numbers})):
        return True
    places = [_RANGE_OF[word] for word in phrase if word in _RANGE_OF]
    return bool(places) and not between and not any(low <= number <= high for low, high in places for number in numbers)


def _is_of_drive(said: Sequence[str], has_letters: bool) -> bool:
    """Whether a sentence is of what stands between motors and joints, or of the angles of motors: not of their torques, and none that is denied.

    That their speed is measured, or controlled, says nothing of a letter unless it holds one.
    """
    drives = [place for place, word in enumerate(said) if _is(word, "DRIVE")]
    denied = any(_is(word, "NOT") for place in drives for word in said[max(0, place - _NEAR) : place])
    if denied or _has(said, "FORCES"):
        return False
    if drives:
        return True
    at = [k for k, word in enumerate(said) if _is(word, "MOTOR") and (k == 0 or said[k - 1] not in _NO_MOTOR)]
    kinds = ("OF_MOTOR", "SPEED") if has_letters else ("OF_MOTOR",)
    return any(_is(word, kind) for kind in kinds for place in at for word in said[max(0, place - _NEAR) : place + 2])


def _bent_at_zero(said: Sequence[str], formulas: Sequence[str]) -> str:
    """Return which angles are not those of the arm in a sentence that has it bent, or upright, where they are zero; "" in another one."""
    at = [place for place, word in enumerate(said) if _is(word, "ZERO")]
    zeros = _has(said, "REST") or any(_is_of_zero(said, place) for place in at)
    zeros = zeros or any(_is_letter_zero(said, formulas, place) for place in at)
    if not (zeros or any(map(_IS_ZERO.fullmatch, formulas))) or _has(said, "FORCES"):
        return ""
    pairs = [*pairwise(said)]
    is_turned = any((_is(a, "RIGHT") and _is(b, "TURN")) or (_is(b, "RIGHT") and _is(a, "TURN")) for a, b in pairs)
    is_turned |= _has(said, "LOWEST") or _is_under_a_place(said)
    if is_turned or _is_bent_by(said, formulas) or _has(said, "BENT") or any(map(_Y_AXIS.fullmatch, formulas)):
        return BENT
    return RAISED if _has(said, "UPRIGHT") else ""


def _is_bent_by(said: Sequence[str], formulas: Sequence[str]) -> bool:
    """Whether an arm is said to be bent by an angle that is neither nought nor half a turn: "bent by $30^\\circ$"."""
    return _has(said, "BEND") and any(map(_VALUE.fullmatch, formulas))


def _is_letter_zero(said: Sequence[str], formulas: Sequence[str], place: int) -> bool:
    """Whether a letter of an angle is said to be the zero at a place: "$\\theta_2$ is zero there"."""
    if said[max(0, place - 2) : place - 1] != ["¤"] or not _is(said[place - 1], "IS"):
        return False
    latex = formulas[said[:place].count("¤") - 1 :][:1]
    found = _LETTER.fullmatch(latex[0]) if latex else None
    return found is not None and _ANGLE.match(found["letter"]) is not None


def _is_of_zero(said: Sequence[str], place: int) -> bool:
    """Whether the zero at a place is that of angles or of a posture: "the zero of $\\theta_2$", "all angles being zero"."""
    near = said[max(0, place - _NEAR) : place + _NEAR]
    return _has(near, "OF_ZERO") or said[place + 1 : place + 3] in (
        ["of", "¤"],
        ["de", "¤"],
        ["von", "¤"],
    )


def _is_under_a_place(said: Sequence[str]) -> bool:
    """Whether something is said to be under a part of the arm, or the ceiling: "right under the hinge", and not "the formula below"."""
    for place in (at for at, word in enumerate(said) if _is(word, "UNDER")):
        behind = [word for word in said[place + 1 : place + 1 + _NEAR] if not _is(word, "ARTICLE")]
        if behind and _is(behind[0], "PLACE"):
            return True
    return False


def _strokes(said: Sequence[str], formulas: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the length of what slides where it is pushed in, and the letter of how far it is pulled out, each of a clause of one sentence."""
    letters = iter(formulas)
    resting, moving = list[str](), list[str]()
    for clause in _clauses(said):
        own = [found["letter"] for word in clause if word == "¤" if (found := _LETTER.fullmatch(next(letters, "")))]
        is_out = _has(clause, "OUT")
        if len(own) == 1 and is_out is not _has(clause, "IN"):
            (moving if is_out else resting).append(own[0])
    if len(resting) == 1:
        yield from ((resting[0], each) for each in moving if each != resting[0])


def _clauses(said: Sequence[str]) -> Iterator[Sequence[str]]:
    """Yield the clauses of a sentence, which commas, semicolons and "and" part; one without a formula belongs to the next."""
    begin = 0
    for place, word in enumerate((*said, ",")):
        if "¤" in said[begin:place] and word in (",", ";", ":", "and", "et", "und", "y", "e", "while", "tandis", "während", "mientras", "mentre", "enquanto"):  # fmt: skip
            yield said[begin:place]
            begin = place + 1


def _lengths_of_others(said: Sequence[str], formulas: Sequence[str]) -> Iterator[str]:
    """Yield the lengths that a sentence gives to other links than their own: "the bar at the base has the length $l_2$"."""
    at = [place for place, word in enumerate(said) if word == "¤"]
    begin = 0
    for place, latex in zip(at, formulas, strict=False):
        near = [*said[max(0, place - 2) : place], *said[place + 1 : place + 2]]
        found = _LETTER.fullmatch(latex)
        if found is not None and (found["index"] or "").isdigit() and _has(near, "LENGTH"):
            clause = said[begin:place]
            if _of_other_joint(clause, {int(found["index"])}):
                yield found["letter"]
        begin = place + 1


def _numbers_otherwise(said: Sequence[str]) -> bool:
    """Whether joints are numbered from the hand: "the joint at the elbow is called joint 1"."""
    if not _has(said, "CALLED"):
        return False
    joints = ("joint", "link", "articulation", "gelenk", "articulación", "giunto", "junta")
    begin = 0
    for place, word in enumerate(said):
        if word in (",", ";", ".", "and", "et", "und", "y", "e"):
            begin = place
        if word in joints and (number := (*said[place + 1 :], "")[0]).isdigit():
            places = [_RANGE_OF[each] for each in said[begin:place] if each in _RANGE_OF]
            if places and not any(low <= int(number) <= high for low, high in places):
                return True
    return False
