r"""Sentences after which an arm is another one: "The robot is put on a table of height $H$.", "All lengths are multiplied by $k$.", "With a pen of length $e$ in the gripper".

What they make of it is not computed: what is written behind them is left open.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

MAY_CHANGE_ARM = regex(  # what no such sentence lacks, in small letters
    r"robot|\barms?\b|manipul|\bbase\b|\bbras\b|roboter|\bit\b|\bil\b|link|bar\b|bars\b|length|forearm|segment|longueur|barre|länge|glied|unterarm|longitud|brazo|lunghezz|bracci|tool|outil|foot|model|maquet|scale|échelle|maßstab|escala|scala|stab|stäbe|stange|asta|aste\b|elos?\b|forearm|spindle|\bnut\b|pitch|hélico|helic|elico|\bvis\b|schraub|spindel|tornillo|\bvite\b|parafuso|replac|remplac|ersetz|sustitu|reemplaz|sostitu|substitu|pen\b|stylo|screw|tube|long\b|avant-bras|antebra|avambrac|mirror|miroir|spiegel|espejo|specchio|espelho"
)
_lists = WordLists("""
ARM robot robots arm manipulator base bras manipulateur roboter roboterarm brazo manipulador braccio manipolatore braço robô machine mechanism mécanisme it il elle er lo
MOUNTED lift~ raise~ put puts place~ placing set stand~ hang~ hung suspend~ mount~ bolt~ fix~ screwed carried rides carries move~ moving shift~ displace~ tilt~ turned rotated tourné tournée tournons gedreht girad~ ruotat~ soulev~ posé posée posons pose place~ placé placée monte~ monté~ accroch~ fixe~ fixé~ déplac~ surélev~ rehauss~ inclin~ gehoben gestellt gesetzt montiert aufgehängt hängt verschoben befestigt gekippt levantad~ coloca~ colgad~ cuelga montad~ desplaza~ sollevat~ mess~ appes~ montat~ spostat~ levantado pendurad~ desloca~
SUPPORT platform table pedestal cart carriage ceiling wall stand plinth trolley truck vehicle rail gantry column bench box turntable slope ramp plateforme plate-forme socle piédestal chariot plafond mur estrade rampe établi support colonne véhicule portique sockel tisch decke wand wagen podest schiene säule plattform mesa techo pared plataforma pedestal carro tavolo soffitto parete piattaforma piedistallo carrello mesa teto parede carrinho upside-down upside
ITS_FOOT foot base pedestal pied socle embase base fuß sockel pie piede pé robot robots roboter
LINKS membro membri segmento segmenti eslabón eslabones maillon link links bar bars rod rods segment~ length lengths longueur~ barre barres forearm upper-arm glieder stäbe längen unterarm oberarm avant-bras bras longitudes eslabones barras antebrazo lunghezze aste bracci avambraccio comprimentos elos antebraço arm~ robot~
SCALED multipl~ scaled doubl~ halved halve tripl~ quadrupl~ multiplie~ divise~ divided dédoubl~ réduit~ agrandi~ enlarg~ verdoppel~ halbier~ vervielf~ multiplizier~ duplica~ raddoppi~ moltiplica~ dobra~ twice double half lengthen~ shorten~ longer shorter rallong~ allong~ raccourci~ verläng~ verkürz~ alarga~ acorta~ allung~ accorci~ alonga~ encurta~ prolong~
ALL all both every each toutes tous les chaque alle beide jede todas todos ambas tutte tutti ambedue
HELD pen pencil screwdriver tube extension probe drill torch brush nozzle tool rod stick finger needle marker gripper hand spike pointer blade knife adapter spacer pipe stylo crayon tournevis rallonge sonde perceuse torche pinceau buse outil tige doigt aiguille feutre pince lame couteau adaptateur tuyau perche stift bleistift schraubendreher schraubenzieher verlängerung rohr bohrer pinsel düse werkzeug stab finger nadel greifer adapter lápiz destornillador tubo extensión sonda broca antorcha pincel herramienta penna matita cacciavite prolunga sonda trapano pennello utensile caneta chave extensão ferramenta
NO_LENGTH transform~ homogeneous matrix matrices matric~ matrizen product~ angle angles side sides membres seiten equation~ équation~ gleichung~ speed~ velocit~ vitesse~ geschwindigkeit~ torque~ couple couples force~ drehmoment~ rate rates area~ row rows column~ vector~ velocidad~ coppie winkel~ term terms square~ carré~
THE the this that dh la le der die das el los il lo o our its
EXCHANGED exchang~ swap~ interchang~ échang~ interverti~ permut~ vertausch~ tausch~ getauscht intercambi~ permuta~ scambi~ inverti~ troca~ troqu~
ADDED extension extensions rallonge rallonges prolongement verlängerung~ extensión prolunga extensão
TWO two both deux les beide beiden zwei dos ambas due entrambe dois duas ambos each
NO_BARS roles role rows row columns column axes axis angles angle coordinates sine cosine letters names symbols indices index signs terms factors rôles lignes colonnes angles winkel zeilen spalten rollen filas columnas righe colonne linhas colunas
SCREW screw screws screw-joint helical helicoidal spindle nut pitch hélicoïdale hélicoïdal vis pas schraube~ schraub~ spindel mutter steigung gewinde~ helicoidal tornillo husillo elicoidale vite passo fuso parafuso
TURNS turn turns turned turning rotate~ rotation tourne tournant tourner dreht drehen dreh~ gira girar girando ruota ruotando ruotare rotaz~
PART hand tool gripper quill slide joint it wrist outil main pince organe liaison articulation glissière hand werkzeug greifer gelenk schub pinole mano herramienta pinza articulación giunto utensile ferramenta junta
NEVER not no never without nicht kein keine ohne ne pas sans no sin non senza não sem motor shaft handle
MEMBER member membro membri forearm upper-arm arm robot link bar rod bras avant-bras segment barre membre unterarm oberarm arm roboter stab glied antebrazo brazo eslabón barra avambraccio braccio asta antebraço braço elo
A an a una un une eine einen ein uma um
HAS has have gets carries receives a reçoit porte hat bekommt trägt erhält tiene lleva recibe ha riceve porta tem recebe leva
WITHOUT without sans ohne sin senza sem
REMOVED removed detached unscrewed dismounted retiré retirée enlevé enlevée démonté démontée entfernt abgenommen abmontiert quitado quitada retirado retirada rimosso rimossa tolto tolta removido removida
OUTER forearm link bar rod avant-bras segment barre membre unterarm stab glied antebrazo eslabón barra avambraccio asta antebraço elo column colonne säule columna colonna coluna
PUT mount~ fix~ attach~ glue~ clamp~ screw~ weld~ bolt~ put place monte~ monté~ attach~ coll~ befestig~ montier~ mont~ fij~ fissa~ montiamo
POINT tool hand gripper pen outil main pince stylo werkzeug greifer hand herramienta pinza mano utensile ferramenta garra mão
HALF_WAY middle midpoint half-way halfway milieu mitte mitad medio metà mezzo meio
MIRROR mirror miroir spiegel espejo specchio espelho
LOOK look~ see sees seen watch~ view~ regard~ voit voyons observe~ sehen sieht betracht~ schau~ mira~ ve vemos observa~ guard~ vede vediamo osserv~ olha~ vê
MIGHT can could may might often usually typically generally peut peuvent souvent kann können oft puede pueden può possono pode podem
""")
_is, _has = _lists.holds, _lists.has
_LENGTH_LETTER = regex(
    r"\s*(?:\\(?:mathrm|mathit|text)\s*\{\s*)?(?:\\(?:varepsilon|epsilon|ell|lambda|delta|Delta|kappa|eta|rho)|[a-zA-Z])(?:\s*_\s*(?:\{[^{}]*\}|\w))?\s*\}?\s*"
)
_BY = frozenset("by of de d' um von por di height hauteur höhe altura altezza".split())
_OF_LENGTH = regex(
    r"(?<!\S)(?:(?:of|with|whose|the|de|d' une|der|mit der|von der|con|di|da|la|a|is|has|and) )*(?:length|height|longueur|hauteur|länge|höhe|longitud|altura|lunghezza|altezza|comprimento) (?:of |is |de |est |von |ist |es |di |è |é )?¤ |¤ (?:long|lang|de long|de longueur|largo|lungo) "
)
_OF_SIZE = regex(
    r"(?<!\S)(?:of|de|von|di|with) (?:(?:length|longueur|länge|longitud|lunghezza) )?(?:of |de |di )?(?:\d+(?:[.,]\d+)?|¤) ?(?:mm|cm|m|millim\w+|centim\w+|zentim\w+|metres?|meters?|mètres?|metros?|metri)(?= )"
)
_AT_SCALE = regex(r"(?<![\d:])(?:1 ?: ?(?:[2-9]|[1-9]\d+)|(?:[2-9]|[1-9]\d+) ?: ?1)(?![\d:])")
_MODEL = regex(
    r"\b(?:models?|mock-?up|maquette|modell\w*|maqueta|modello|maquete)\b|\b(?:measure|read|lit|lisons|mesur\w+|messen|lesen|medimos|leemos|misuriamo|leggiamo|lemos)\b"
)
_AS_LONG = regex(
    r"(?<!\S)(?:(?:just )?as long as (?:itself|it|the|this)|of (?:the same|its own) length|(?:de|d' une) (?:la )?même longueur|aussi longue? que|(?:gleich|ebenso) lang\w*|(?:von )?gleicher länge|de la misma longitud|tan larg[oa] como|lung[oa] quanto|della stessa lunghezza|do mesmo comprimento|tão long[oa] quanto) "
)
_TIMES_AS_LONG = regex(  # and not "as long as the upper arm"
    r"(?<!\S)(?:(?:twice|half|double|(?:two|three|four|\d) times|one third|a third) (?:as long|the length|longer)|(?:two|three|four|\d) times (?:as )?(?:long|longer|shorter)|(?:deux|trois|quatre|\d) fois (?:plus|aussi|moins) (?:longu?e?|courte?)|(?:doppelt|halb|dreimal) so (?:lang|kurz)|(?:el )?doble de larg[oa]|dos veces más larg[oa]|lung[oa] il doppio|due volte più lung[oa]|duas vezes mais long[oa]) (?!as |que |wie |come |quanto |como )"
)
_REPLACED = regex(
    r"¤ (?:\S+ ){0,2}?(?:replaced|remplacée?|ersetzt|sustituid[oa]|reemplazad[oa]|sostituit[oa]|substituíd[oa]|changed|increased|grows) (?:\S+ )?¤|(?<!\S)(?:replac\w+|remplaç\w+|remplac\w+|ersetz\w+|sustitu\w+|reemplaz\w+|sostitu\w+|substitu\w+) ¤ (?:by|with|par|durch|por|con|com) ¤|¤ durch ¤ (?:ersetzt|zu ersetzen)"
)
_EACH_OTHERS_PLACE = regex(
    r"(?<!\S)(?:in the place of the other|(?:each|one) other'? s places?|places? of each other|à la place de l' autre|an die stelle (?:des|der) anderen|en (?:el )?lugar (?:de la|del) otr[oa]|al posto dell' altr[oa]|no lugar d[oa] outr[oa])(?!\S)"
)
_NEW_ANGLE = regex(r"\s*\\(?:alpha|beta|gamma|psi|(?:var)?phi|delta|epsilon|eta)(?:\s*_\s*(?:\{[^{}]*\}|\w))?\s*")
_OF_SCREW = frozenset("la una della a di con".split())  # before Italian "vite", which is "fast" in French
_OF_PITCH = frozenset("de du le un son".split())  # before "pas", which denies nothing then
_ON = frozenset(
    "on onto upon to from at in under against along sur à au aux dans sous contre le auf an am im in unter vom von sobre en a al del bajo contra su sul sulla al nel da dal alla em no na ao sob".split()
)
_OF_ROWS = ("table", "column")  # "the table" is that of the rows
_NEAR = 8  # words between what is held and how long it is


def changes_arm(words: str, formulas: Sequence[str], letters_above: Collection[str]) -> bool:
    """Whether a sentence makes an arm another one than its displays above have it, whose letters are given."""
    said = words.lower().replace("upper arm", "upper-arm").replace("upside down", "upside-down").split()
    if said[-1:] == ["?"] or _has(said, "MIGHT"):
        return False
    if (
        _turns_as_it_slides(said)
        or _is_exchanged(said)
        or _is_a_model(words.lower())
        or _is_as_long(words.lower(), said)
        or _is_mirrored(said)
        or _is_of_other_length(words.lower(), said)
        or _lacks_part(said)
        or _has_tool_within(said)
        or _has_tool_of_a_size(words.lower(), said)
        or ("upside-down" in said and _has(said, "ARM"))
        or _has_piece(said)
    ):
        return True
    if _replaces_size(words.lower(), formulas):
        return True
    new = [bool(_LENGTH_LETTER.fullmatch(each)) and _plain(each) not in letters_above for each in formulas]
    turned = [bool(_NEW_ANGLE.fullmatch(each)) and _plain(each) not in letters_above for each in formulas]
    return _is_elsewhere(said, new, turned) or _is_scaled(said, new) or any(_holds(words.lower(), said, new))


def _is_exchanged(said: Sequence[str]) -> bool:
    """Whether the bars are put each in the other's place: "Now the two bars are exchanged"."""
    has_bars = _has(said, "LINKS") and _has(said, "TWO")
    if not has_bars or _has(said, "NO_BARS"):
        return False
    return _has(said, "EXCHANGED") or _EACH_OTHERS_PLACE.search(" ".join(said)) is not None


def _has_piece(said: Sequence[str]) -> bool:
    """Whether a link has an extension: "the forearm has an extension"."""
    return any(
        _is(each, "ADDED")
        and place > 1
        and _is(said[place - 1], "A")
        and _has(said[max(0, place - 3) : place - 1], "HAS")
        and _has(said[:place], "MEMBER")
        for place, each in enumerate(said)
    )


def _replaces_size(words: str, formulas: Sequence[str]) -> bool:
    """Whether a letter is replaced by something with itself in it: "with $a_3$ replaced by $a_3 + t$"."""
    for found in _REPLACED.finditer(words):
        at = words.count("¤", 0, found.start())
        letter, other = (_plain(each) for each in (*formulas[at : at + 2], "", "")[:2])
        if letter and letter != other and re.search(rf"(?<![A-Za-z\\]){re.escape(letter)}(?![\w])", other):
            return True
    return False


def _is_of_other_length(words: str, said: Sequence[str]) -> bool:
    """Whether a sentence is of a link that is longer or shorter than the one above: "A forearm that is twice as long gives"."""
    found = _TIMES_AS_LONG.search(words)
    before = said[: len(words[: found.start()].split())] if found is not None else []
    return any(_is(a, "A") and _is(part, "MEMBER") for a, part in pairwise(before[-_NEAR:]))


def _lacks_part(said: Sequence[str]) -> bool:
    """Whether a link is taken away: "Without the forearm", "the second link is removed"."""
    for place, each in enumerate(said):
        if (
            _is(each, "WITHOUT")
            and _has(said[place + 1 : place + 4], "OUTER")
            and _has(said[place + 1 : place + 2], "THE")
        ):
            return True
        if _is(each, "REMOVED") and _has(said[max(0, place - 4) : place], "OUTER"):
            return True
    return False


def _has_tool_of_a_size(words: str, said: Sequence[str]) -> bool:
    """Whether something of a length in numbers is held: "With a tool of 10 cm in the hand"."""
    for found in _OF_SIZE.finditer(words):
        before = said[: len(words[: found.start()].split())]
        if len(before) > 1 and _is(before[-1], "HELD") and _is(before[-2], "A"):
            return True
    return False


def _has_tool_within(said: Sequence[str]) -> bool:
    """Whether the tool is put elsewhere than at the end: "We now mount the tool at the middle of the forearm"."""
    for place, each in enumerate(said):
        behind = said[place + 1 : place + 1 + _NEAR]
        if _is(each, "PUT") and _has(behind[:3], "POINT") and _has(behind, "HALF_WAY"):
            return True
    return False


def _is_mirrored(said: Sequence[str]) -> bool:
    """Whether one looks at the arm in a mirror."""
    at = next((place for place, each in enumerate(said) if _is(each, "MIRROR")), 0)
    is_in = any(each in ("in", "dans", "im", "en", "nello", "no") for each in said[max(0, at - 2) : at])
    return is_in and _has(said, "ARM") and _has(said[:at], "LOOK")


def _is_a_model(words: str) -> bool:
    """Whether sizes are those of a model, or are read in a drawing, of another scale: "At a model of the scale 1:10 we measure"."""
    return _AT_SCALE.search(words) is not None and _MODEL.search(words) is not None


def _is_as_long(words: str, said: Sequence[str]) -> bool:
    """Whether a link grows by something of its own length: "The forearm carries an extension as long as itself"."""
    grows = _has(said, "SCALED") or _has(said, "ADDED")
    return grows and _has(said, "LINKS") and _AS_LONG.search(words) is not None


def _turns_as_it_slides(said: Sequence[str]) -> bool:
    """Whether a joint is a screw that turns the hand, which no table has: "sliding it also turns the hand", "La troisième liaison est hélicoïdale"."""
    pairs = zip(["", *said], said, strict=False)
    has_screw = any(_is(each, "SCREW") and (each != "vite" or before in _OF_SCREW) for before, each in pairs)
    plain = [each for before, each in zip(["", *said], said, strict=False) if before not in _OF_PITCH]
    if not has_screw or _has(plain, "NEVER"):
        return False
    return _has(said, "TURNS") and _has(said, "PART")


def _plain(latex: str) -> str:
    return re.sub(r"[{}\s]", "", latex)


def _is_elsewhere(said: Sequence[str], new: Sequence[bool], turned: Sequence[bool]) -> bool:
    """Whether a robot is put on something, or moved by a length or an angle of its own: "lifted by the height $H$"."""
    if not _has(said, "ARM") or not _has(said, "MOUNTED"):
        return False
    is_on = any(
        _is(each, "SUPPORT")
        and (each.startswith("upside") or any(near in _ON for near in said[max(0, place - 3) : place]))
        and not (each in _OF_ROWS and _has(said[max(0, place - 2) : place], "THE"))
        for place, each in enumerate(said)
    )
    return is_on or any(_by_new(said, new)) or (_has(said, "ITS_FOOT") and any(_by_new(said, turned, 3)))


def _by_new(said: Sequence[str], new: Sequence[bool], most: int = 2) -> Iterator[bool]:
    """Yield of each formula whether it is a new length by which something is moved or grows."""
    at = [place for place, each in enumerate(said) if each == "¤"]
    for place, is_new in zip(at, new, strict=False):
        yield is_new and any(each in _BY for each in said[max(0, place - most) : place])


def _is_scaled(said: Sequence[str], new: Sequence[bool]) -> bool:
    """Whether all lengths are multiplied, or a link grows by a length of its own."""
    for place, word in enumerate(said):
        near = said[max(0, place - 6) : place + 7]
        if _is(word, "SCALED") and _has(near, "LINKS"):
            is_of_all = _has(near, "ALL") and not _has(near, "NO_LENGTH")
            return is_of_all or any(_by_new(said, new))
    return False


def _holds(words: str, said: Sequence[str], new: Sequence[bool]) -> Iterator[bool]:
    """Yield of each length that is told whether something is held that has it, and that no display above knows."""
    for found in _OF_LENGTH.finditer(words):
        number = words.count("¤", 0, found.end()) - 1
        place = len(words[: found.start()].split())
        near = said[max(0, place - _NEAR) : place]
        yield number < len(new) and new[number] and _has(near, "HELD")
