r"""Of what a sentence says the display to be that it leads to: "The velocity of the centre of mass is", "The transpose of the Jacobian is".

Which point, link or frame that is, and whether it is the quantity itself, is told by the nouns behind "of"; words that are none of these classes tell nothing.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from armproof.verification.document.named_quantities import NAMED, named_quantity
from armproof.verification.document.other_arms import OF_ARM, arms_named
from armproof.verification.document.other_functions import OTHER_FUNCTION, is_of_other_function
from armproof.verification.document.told_turns import OTHER_TURN, is_other_turn
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

OTHER_PLACE = "other place"  # neither the tool, nor a link or frame with a number
LINK = "link"  # with its number: the frame at its far end
WRIST = "wrist"  # a link where the arm has a hand behind it
OTHER_BASE = "other base"  # seen from what is not the base
OPERATED = "operated"  # with the letters of what is transposed, inverted, or differentiated
ACCELERATION = "acceleration"

MOST_OF_LABEL = 2  # words of one that stands alone before a display: "Elbow:"

_lists = WordLists("""
QUANTITY position~ coordinate~ location~ velocit~ speed~ acceleration~ jacobi~ pose poses orientation~ rotation~ attitude~ twist~ transform~ coordonnée~ vitesse~ accélération~ situation lage koordinaten geschwindigkeit~ winkelgeschwindigkeit~ beschleunigung~ orientierung~ stellung posición posiciones coordenadas velocidad~ aceleración orientación rotación posizione coordinate velocità accelerazione orientamento rotazione posição velocidade aceleração orientação rotação matrice~ matrix matriz
OF of for du de d' des del della dell' dello der do da
SKIPPED back the a an o la le l' les el il lo das die den dem un une uno una its his this that unit~ linear angular linéaire angulaire geometric géométrique geometrischen velocity vector vecteur vektor point punkt punto planar spatial whole
TOOL tip tool~ tcp effector end-effector end endpoint hand gripper~ robot~ arm arms manipulator~ mechanism~ chain flange pen outil~ effecteur organe extrémité bout bras pince main bras manipulateur~ endeffektor~ effektor~ werkzeug~ greifer~ roboter~ arms ende spitze extremo efector herramienta pinza brazo manipulador~ organo utensile mano estremo estremità braccio effettore ferramenta efetuador~ garra braço origin origine ursprung origen position pose
OTHER hinge~ charnière~ scharnier~ bisagra~ cerniera~ dobradiça~ knee knie rodilla ginocchio genou hip ankle elbow~ joint shoulder~ base camera~ load payload~ motor~ mass masses gravity centroid~ articulation giunto gelenk gelenks articulación midpoint~ mid-point~ upper-arm counterweight~ sensor~ obstacle~ ground crank~ carriage~ coude épaule~ base caméra charge moteur~ gravité barycentre~ inertie ellbogen~ ellenbogen~ schulter~ basis kamera~ motors schwerpunkt~ masse massenmittelpunkt~ codo hombro cámara carga gravedad masas gomito spalla baricentro massa carico cotovelo ombro
WRIST forearm avant-bras unterarm~ antebrazo avambraccio antebraço wrist~ poignet~ handgelenk~ muñeca polso pulso
MIDDLE centre center middle milieu mitte mittelpunkt~ centro medio mezzo meio half
HAS has have hat haben tiene tienen ha hanno tem têm possède
PLACED coordinate~ coordonnée~ koordinaten coordenadas abscissa~ abscisse~ abszisse~ abscisa~ ascissa~ ordinate~ ordonnée~ ordenada~ ordinata~ position~ location~ height hauteur höhe altura altezza velocit~ speed~ vitesse~ geschwindigkeit~ velocidad~
WAY way halfway half-way mi-chemin chemin wegs weges camino strada
BETWEEN between entre zwischen tra fra
ANGLE angle winkel ángulo angolo ângulo
PROJECTION projection~ projektion~ proyección proiezione projeção
AXIS x-axis y-axis z-axis horizontal~ vertical~ horizontale~ verticale~ horizontalen vertikalen waagerechten orizzontale verticale
NUMBERED link links frame frames segment~ body bodies rod rods bar bars repère~ corps solide~ maillon~ bras segment~ glied~ glieds gliedes koordinatensystem~ system eslabón cuerpo marco braccio membro corpo terna elo
ORDINAL first second third fourth premier première deuxième second seconde troisième ersten zweiten dritten primer primero segundo tercer primo secondo terzo primeiro terceiro
BASE base basis world ground fixed inertial reference origin 0 monde fixe absolu référence welt inertialsystem mondo mundo fijo fisso
BE is are reads becomes equals est sont s'écrit vaut ist lautet liegt sind es está son è sono é
AT at in en bei liegt auf em
RELATIVE relative relativ relativa relativo respect rapport seen vue bezüglich respecto rispetto
VARIABLE variable~ angle~ coordinate~ parameter~ displacement~ winkel~ variablen ángulos
TIME time temps zeit tiempo tempo
IN in dans im en nel nella no
KIND manipulator~ robot~ arm arms configuration~ type singularit~
AXES axes axis frame coordinates repère~ achsen koordinaten ejes assi eixos
ALONG in into along onto to on dans selon sur suivant im in entlang en según nel nella negli lungo nos
FROM from du von dal del do
FROM_POINT from du depuis de d' von vom dal dalla dall' desde do da
TO_POINT to into towards au à vers jusqu' nach zum zur al alla allo hasta ao à
POINT point punkt punkto punto ponto place
BEGINS begins starts commence beginnt empieza comienza inizia começa
TO to into au vers nach zum al ao
TURNS turns turn rotates rotate moves move tourne pivote déplace dreht bewegt gira mueve ruota muove roda
MOVES moves move sits lies travels has have stands rests déplace trouve bewegt befindet liegt hat mueve encuentra está trova muove encontra move-se
CIRCLES runs stays remains describes follows reste restent décrit suit demeure bleibt beschreibt läuft permanece describe rimane descrive resta
FIXED fixed attached mounted fixée fixé montée monté attachée attaché befestigt montiert fijada fijado montada montado fissata fissato montata
TRANSPOSED transpose~ inverse inversed inverted pseudo-inverse~ pseudoinverse~ negative transposée~ opposé~ transponierte~ inverse~ inversa trasposta traspuesta~ transpuesta~ transposta pseudoinversa
SCALED scaled normali~ weighted dimensionless normiert~ normé~ pondéré~ escalad~ ponderad~
VECTOR vector vecteur vektor vettore vetor
THOSE those that celles celle ceux celui diejenigen die jene las los aquellas quelle quelli quelli as os aquelas
FOR for pour für para per
ACTS describes concerns regards décrit concerne beschreibt betrifft describe concierne descrive riguarda descreve
DERIVATIVE derivative~ dérivée~ ableitung~ zeitableitung derivada~ derivata
""")
_is, _has = _lists.holds, _lists.has
_ORDINALS = {"first": 1, "second": 2, "third": 3, "fourth": 4, "premier": 1, "première": 1, "deuxième": 2, "seconde": 2, "troisième": 3, "ersten": 1, "zweiten": 2, "dritten": 3, "primer": 1, "primero": 1, "segundo": 2, "tercer": 3, "primo": 1, "secondo": 2, "terzo": 3, "primeiro": 1, "terceiro": 3}  # fmt: skip
_CENTRES = frozenset("centre center centro zentrum mittelpunkt".split())
_WRISTS = ("wrist", "poignet", "handgelenk", "handwurzel", "muñeca", "polso", "pulso", "punho")
_LETTERS = {"jacobi": "J", "rotation": "R", "orientat": "R", "pose": "THA", "transfor": "THA", "position": "pPxyz", "accélér": "", "rotació": "R", "rotazio": "R", "posició": "pPxyz", "posizio": "pPxyz"}  # fmt: skip
_POINT = regex(r"\s*(?:\\(?:mathbf|boldsymbol|vec)\s*)?\{?[OPCAp]\}?_\{?(\d)\}?\s*")
_NUMBER = regex(r"¤?\s*(?:\\?[A-Za-z]+\s*_\s*)?\{?\s*(?:\\?[A-Za-z]+_)?(\d)\s*\}?\s*")  # 2, $2$, $R_2$, $\{2\}$
_OF_FRAME = regex(r"¤\s*(?:\\mathcal\s*)?\{?[RF]\}?_\{?([1-9])\}?\s*|¤\s*\\\{([1-9])\\\}\s*")
_OF_JOINT = regex(r"¤\s*(?:\\(?:var)?(?:theta|phi|alpha|beta)|q)(?![A-Za-z])")
_JOINT = frozenset("joint articulation gelenk gelenks articulación giunto".split())
_OF_TOOL_FRAME = regex(  # what a tool's frame does anyway: "The hand frame turns with the forearm."
    r"(?<!\S)(?:the |le |la )?(?:(?:hand|tool|gripper|end-effector|effector|tip|wrist|last)(?:' s)? (?:frame|axes)|(?:repère|référentiel) (?:de |du |lié à )?(?:la |l' )?(?:outil|pince|main|effecteur)) (?:turns|moves|rotates|travels|tourne|bouge|se déplace) (?=with |along with |avec )",
    re.IGNORECASE,
)
_FAR = 7  # words up to the verb of a sentence: "The joint between the two links runs on"
_ENDS = frozenset(",:.;!?")


def without_tool_frame(words: str) -> str:
    """Return the words of a sentence without what the tool's frame does anyway, and that tells of no other: "The hand frame turns with the forearm."."""
    return _OF_TOOL_FRAME.sub("", words)


def subjects(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield of what a sentence, with its words and formulas, says the display to be that it leads to."""
    said = words.lower().replace("upper arm", "upper-arm").replace("how far", "how-far").split()
    numbers = iter(formulas)
    said = [f"¤{next(numbers, '')}" if each == "¤" else each for each in said]
    of_tool = _for_the_tool(said)
    for place, word in enumerate(said):
        if place >= of_tool and _is(word, "QUANTITY") and _has(said[place + 1 : place + 3], "OF"):
            behind = next(k for k in (place + 1, place + 2) if _is(said[k], "OF")) + 1
            yield from _of_place(_phrase(said[behind:]))
        if _is(word, "AXES") and _has(said[max(0, place - 3) : place], "ALONG"):
            yield from _along(said[place + 1 :])
        if _is(word, "IN") and place + 1 < len(said) and _OF_FRAME.fullmatch(said[place + 1]):
            yield OTHER_BASE
        if _is(word, "FIXED") and any(
            _is(each, "OTHER") and not _is(each, "BASE") for each in _phrase(said[place + 2 : place + 5])
        ):
            yield OTHER_PLACE
        if _is(word, "RELATIVE"):
            yield from _seen_from(said, place)
        if _is(word, "ACTS") or (place == 0 and _is(word, "FOR")):
            yield from _of_thing(_phrase(said[place + 1 :]))
        if _is(word, "VECTOR") and _is((*said[place + 1 :], "")[0], "FROM"):
            yield from _of_thing(_phrase(said[place + 2 :])[:1])
    yield from _of_those(said)
    yield from _of_subject(said)
    if _is_label_of_middle(said):
        yield OTHER_PLACE
    label = [each for each in _unskipped(said) if each not in _ENDS]
    if (
        0 < len(label) <= MOST_OF_LABEL
        and "joint" not in label
        and not any(_is(e, k) for e in label for k in ("BE", "QUANTITY"))
    ):
        yield from _of_place(label)
    yield from _of_two_frames(said)
    spoken = [each for each in said if each not in _ENDS]
    clause = said[len(said) - 1 - said[:-1][::-1].index(",") :] if "," in said[:-1] else said
    is_placed = _has(clause, "BE") and _is((spoken or [""])[-1], "AT")
    if is_placed:
        beside = " ".join(said).split(" , ")[1:-1]  # "The wrist, at the end of link 2, is at"
        apposed = [number for each in beside if (number := _number(each.split()))]
        yield from [f"{LINK} {apposed[0]}"] if apposed else _of_place(_phrase(clause) or _phrase(said))
    elif _moves(_unskipped(said)) and not _has(said, "TOOL"):
        yield OTHER_PLACE
    yield from _quantity(said)
    if is_of_other_function(said):
        yield OTHER_FUNCTION
    if is_other_turn(said):
        yield OTHER_TURN
    if _is_of_other_vector(said) or _begins_part(said):
        yield OTHER_PLACE
    if named := named_quantity(said):
        yield f"{NAMED} {named}"
    yield from (f"{OF_ARM} {each}" for each in arms_named(words))


def _of_subject(said: Sequence[str]) -> Iterator[str]:
    """Yield of what place a sentence is that begins with it: "The middle of the bar has the coordinates", "Halfway from the elbow to the tip"."""
    leads = _is(([each for each in said if each not in _ENDS] or [""])[-1], "BE")
    for place, word in enumerate(said):
        behind, beside = said[place + 1 : place + 5], said[place + 1 : place + 9]
        has = _is(word, "HAS") or (word in ("a", "ont") and _is((*behind, "")[0], "FOR"))
        if has and place and _has(behind, "PLACED"):
            yield from _of_place(_phrase(said[:place]))
        points = [each for each in beside if each not in _JOINT]  # and not "from joint space to the plane"
        part = len(word) > len("way") or _has(said[max(0, place - 2) : place], "OF")
        if _is(word, "WAY") and part and any(_is(e, kind) for e in points for kind in ("OTHER", "WRIST", "TOOL")):
            yield OTHER_PLACE
        joins = _has(behind[:2], "BETWEEN") or behind[:2] == ["que", "font"]
        of_links = leads and _is(word, "ANGLE") and joins and _has(beside, "NUMBERED")
        if of_links and not any(_is(each, "AXIS") or _is(each, "BASE") for each in beside):  # as the tool's angle has
            yield OTHER_PLACE
        if leads and _is(word, "PROJECTION") and not word.endswith("s") and _number(_phrase(behind)):
            yield OTHER_PLACE


def _is_label_of_middle(said: Sequence[str]) -> bool:
    """Whether words without a verb are of a middle: "Middle of the outer bar", but not "Centre of the workspace"."""
    words = [each for each in _unskipped(said) if each not in _ENDS]
    is_part = any(_is(each, "NUMBERED") or _is(each, "OTHER") or _is(each, "WRIST") for each in words)
    return (
        bool(words)
        and _is(words[0], "MIDDLE")
        and is_part
        and not any(_is(each, kind) for each in words for kind in ("BE", "HAS"))
    )


def _is_of_other_vector(said: Sequence[str]) -> bool:
    """Whether a sentence is of a vector that leads from elsewhere than the base, or to it: "the vector from the tip back to the shoulder"."""
    vector = next((place for place, word in enumerate(said) if _is(word, "VECTOR")), len(said))
    begin = next((place for place in range(vector, len(said)) if _is(said[place], "FROM_POINT")), len(said))
    end = next((place for place in range(begin, len(said)) if _is(said[place], "TO_POINT")), len(said))
    source, target = _phrase(said[begin + 1 : min(end, begin + 4)]), _phrase(said[end + 1 : end + 4])
    kinds = ("TOOL", "OTHER", "WRIST", "MIDDLE")
    is_from_other = any(_is(word, kind) and not _is_at_base(word) for word in source for kind in kinds)
    return end < len(said) and (is_from_other or (bool(target) and _is_at_base(target[0])))


def _is_at_base(word: str) -> bool:
    return _is(word, "BASE") or word.startswith(
        ("base", "basis", "shoulder", "épaule", "schulter", "hombro", "spalla", "ombro")
    )


def _begins_part(said: Sequence[str]) -> bool:
    """Whether a sentence is of the point where a link begins, which is the one before it."""
    for place, word in enumerate(said):
        near = said[place + 1 : place + 7]
        if _is(word, "POINT") and _has(near, "BEGINS") and _has(near, "NUMBERED"):
            return True
    return False


def _for_the_tool(said: Sequence[str]) -> int:
    """Return the place where a sentence says that it is for the tool, 0 where it does not: "Knowing that of the elbow we find for the tip"."""
    for place in range(len(said) - 1, 0, -1):
        if _is(said[place], "FOR") and (phrase := _phrase(said[place + 1 : place + 4])) and _is(phrase[0], "TOOL"):
            return place if not _number(_phrase(said[place + 1 :])) else 0
    return 0


def places_of_those(words: str) -> Iterator[str]:
    """Yield of what place something near a sentence is said to be, wherever the sentence stands: "The coordinates are those of the elbow."."""
    yield from _of_those(words.lower().split())


def _of_those(said: Sequence[str]) -> Iterator[str]:
    for place, word in enumerate(said):
        is_told = _has(said[max(0, place - 2) : place], "BE")
        if is_told and _is(word, "THOSE") and _is((*said[place + 1 :], "")[0], "OF"):
            yield from _of_thing(_phrase(said[place + 2 :]))


def _of_thing(phrase: Sequence[str]) -> Iterator[str]:
    """Yield of what place a phrase is that begins with its noun: "the elbow", but not "the elbow-up branch", nor "the joint angles"."""
    noun, behind = (*phrase, "", "")[:2]
    is_place = (_is(noun, "OTHER") and not _is(noun, "BASE")) or _is(noun, "WRIST")
    if is_place and "-" not in noun and noun not in _JOINT and behind not in ("up", "down"):
        of_part = _is(noun, "WRIST") and _is(behind, "OTHER")  # the wrist camera
        yield from _of_place(phrase[1:2] if of_part else phrase[:1] if _is(behind, "OF") else phrase[:2])


def _along(behind: Sequence[str]) -> Iterator[str]:
    """Yield that components are along the axes of something else than the base: of the forearm, $x_2$."""
    if not behind:
        return
    phrase = _phrase(behind[1:5]) if _is(behind[0], "OF") else []
    is_numbered = behind[0].startswith("¤") and (found := _NUMBER.fullmatch(behind[0])) is not None and found[1] != "0"
    is_of_other = any(_is(each, kind) for each in phrase for kind in ("TOOL", "OTHER", "WRIST")) or _number(
        phrase
    ) not in ("", "0")
    if is_numbered or (is_of_other and not _has(phrase, "BASE")):
        yield OTHER_BASE


def _unskipped(said: Sequence[str]) -> list[str]:
    return [each for each in said if not _is(each, "SKIPPED")]


def _moves(said: Sequence[str]) -> bool:
    """Whether a sentence says how a place that is not the tool moves, or begins with one and says where it lies: "The elbow moves with"."""
    for place, word in enumerate(said):
        is_other = _is(word, "OTHER") or (_is(word, "MIDDLE") and place == 0)
        if is_other and any(
            _is(each, "TURNS") or (_is(each, "MOVES") and place == 0) for each in said[place + 1 : place + 4]
        ):
            return True
        if is_other and place == 0 and _has(said[1:_FAR], "CIRCLES"):
            return True
    return False


def _of_two_frames(said: Sequence[str]) -> Iterator[str]:
    """Yield to which frame a transform leads from the base, or that it leads from another: from frame 0 to frame 1."""
    begins = [place for place, word in enumerate(said) if _is(word, "FROM")]
    ends = [place for place, word in enumerate(said) if _is(word, "TO") and begins and place > begins[0]]
    if not ends or not _has(said, "NUMBERED"):
        return
    source, target = _phrase(said[begins[0] + 1 : ends[0]]), _phrase(said[ends[0] + 1 :])
    number = _number(target)
    if _number(source) == "0" or _has(source, "BASE"):
        yield from [f"{LINK} {number}"] if number else []
    elif _number(source) and number:
        yield OTHER_BASE


def _of_place(phrase: Sequence[str]) -> Iterator[str]:
    """Yield of what place a phrase is, by the first noun in it that tells: "end of the first link" is link 1."""
    number = _number(phrase)
    for place, (word, behind) in enumerate(zip(phrase, (*phrase[1:], ""), strict=False)):
        if word in _CENTRES and any(each.startswith(_WRISTS) for each in phrase[place + 1 : place + 4]):
            yield f"{LINK} {WRIST}"  # where its axes meet
            return
        if _is(word, "OTHER") and _is(behind, "KIND"):  # the elbow manipulator
            return
        if (found := _POINT.fullmatch(word.removeprefix("¤"))) and word.startswith("¤"):
            yield f"{LINK} {found[1]}"
            return
        is_half_way = _is(word, "MIDDLE") and not (_has(phrase, "TOOL") and not number)
        if _is(word, "OTHER") or is_half_way:
            yield OTHER_PLACE
            return
        if _is(word, "WRIST"):
            yield f"{LINK} {WRIST}"
            return
        if _is(word, "TOOL") and not number and _is(behind, "OF") and _is((*phrase[place + 2 :], "")[0], "OTHER"):
            continue  # the tip of the upper arm
        if _is(word, "TOOL") or _is(word, "NUMBERED"):
            if number:
                yield f"{LINK} {number}"
            return


def _number(phrase: Sequence[str]) -> str:
    """Return the number of the link or frame in a phrase, "" of none: "second link", "frame 2", "link $1$"."""
    for place, word in enumerate(phrase):
        if not _is(word, "NUMBERED"):
            continue
        before, behind = phrase[place - 1] if place else "", phrase[place + 1] if place + 1 < len(phrase) else ""
        if (found := _NUMBER.fullmatch(behind)) is not None:
            return found[1]
        if before in _ORDINALS:
            return str(_ORDINALS[before])
    return ""


def _seen_from(said: Sequence[str], place: int) -> Iterator[str]:
    """Yield that something is seen from another thing than the base, or that it is a relative velocity."""
    if any(map(_OF_JOINT.match, said[:place])) and _has(said[:place], "BE"):
        return  # an angle is relative to the link before
    if _OF_JOINT.match("".join(said[max(0, place - 1) : place])):
        return  # so is "the elbow angle $\\theta_2$ (relative to link 1)"
    is_first = not _has(said[: max(0, place - 1)], "QUANTITY")
    if is_first and any(
        _is(each, "QUANTITY") for each in (*said[max(0, place - 1) : place], *said[place + 1 : place + 2])
    ):
        yield OTHER_PLACE
        return
    behind = [*said[place + 1 : place + 6]]
    end = next(
        (k for k, each in enumerate(behind) if each in _ENDS or _is(each, "BE") or each in ("by", "durch", "par")),
        len(behind),
    )
    behind = behind[:end]
    if _has(behind[:3], "TIME"):
        return  # "Differentiating with respect to time relates the joint velocities"
    if any(word in _JOINT and _is(then, "VARIABLE") for word, then in pairwise(behind)):
        return  # "with respect to the joint variables"
    for word in behind:
        if _is(word, "BASE") or word in _ENDS or (_is(word, "NUMBERED") and _number(behind) == "0"):
            return
        if any(_is(word, each) for each in ("TOOL", "OTHER", "WRIST", "NUMBERED")) or (
            word in _ORDINALS and ({behind[-1], *behind[behind.index(word) + 1 :][:1]} & {word, "one"})
        ):
            yield OTHER_BASE
            return


def _quantity(said: Sequence[str]) -> Iterator[str]:
    """Yield what is done to the quantity that a sentence speaks of last, with its letters: the transpose of the Jacobian."""
    places = [
        place
        for place, word in enumerate(said)
        if _is(word, "QUANTITY") and word not in ("matrix", "matrice", "matriz")
    ]
    if not places:
        return
    last = places[-1]
    letters = next((letter for stem, letter in _LETTERS.items() if said[last].startswith(stem)), "")
    before = said[max(0, last - 4) : last]
    beside = [*before[-1:], *said[last + 1 : last + 2]]
    is_of = _has(before, "OF") and any(_is(each, "TRANSPOSED") or _is(each, "DERIVATIVE") for each in before)
    if letters and (is_of or any(_is(each, "TRANSPOSED") or _is(each, "SCALED") for each in beside)):
        yield f"{OPERATED} {letters}"
    if all(said[place].startswith(("acceler", "accélér", "beschleun", "aceler")) for place in places):
        yield ACCELERATION  # and not "Laws of velocities and accelerations"


def _phrase(said: Sequence[str]) -> list[str]:
    """Return the words up to the verb, a comma, or what says whence something is seen."""
    found: list[str] = []
    for word in said:
        if word in _ENDS or _is(word, "BE") or _is(word, "RELATIVE"):
            break
        if not _is(word, "SKIPPED"):
            found.append(word)
    return found
