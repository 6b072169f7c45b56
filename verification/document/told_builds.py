r"""What a text says of a mechanism that is not the one above, or not as usual: an axis that is turned round, a second robot, frames counted from 1, rows listed from the tool.

What it makes of the arm is not computed: what is written with it is left open.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.document.hearing import says
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

TURNED_ROUND = "turned round"  # with the joint, as LaTeX or as its number; of all joints without
OTHER_BUILD = "other build"  # the arm is another one
JOINTS_FROM_ZERO = "joints from zero"  # the first one has the number 0
COUNTED_FROM_ONE = "counted from one"  # the frames are: that of the base is the first
FROM_TOOL = "from tool"  # the rows of the table are listed so

MAY_TELL_BUILD = regex(  # what no such sentence lacks, in small letters
    r"round|direction|revers|invert|invers|flip|backward|sense\b|\bsens\b|envers|umgekehrt|umgedreht|gegen|anders ?herum|umgepolt|revés|sentido|contrari|verso|retourn|polarity"
    r"|second|other|another|deuxième|autre|zweite|andere|segund|otro|altro|outro|third|different"
    r"|base|basis|inertial|fixed frame|ground|repère (?:fixe|0)|number|nummer|numérot|frame|from zero|from 0|gezählt|nummeriert|table|rows?\b|tableau|ligne|zeile|tabelle|tabla|fila|tabella|righ"
)
_is = WordLists("""
PART joint joints axis axes motor motors slide slides scale encoder drive actuator angle angles articulation liaison axe moteur glissière codeur gelenk schubgelenk schub achse antrieb drehgeber articulación eje giunto motore asse junta eixo telescope cylinder
""").holds
_REVERSED = regex(
    r"(?<!\S)(?:turned (?:a?round|over|back to front)|the (?:other|opposite) way(?: a?round)?|(?:in|to|has|have|runs?|with) (?:the |an )?(?:opposite|reverse|reversed|contrary|other) (?:direction|sense)"
    r"|(?:direction|sense|sign|scale|polarity)(?: of (?:\S+ ){1,5}?| )(?:is|are|was|has been|have been) (?:now |then )?(?:reversed|inverted|changed|flipped|opposite)"
    r"|(?:is|are|was|has been|have been) (?:now |then )?(?:reversed|inverted|flipped)|(?:reverse|reverses|invert|inverts|flip|flips|change|changes|reversing|inverting) (?:now )?(?:the )?(?:direction|sense|sign|polarity|second|first|third|motor|joint|axis)"
    r"|(?:runs?|counts?|turns?) (?:now )?backwards|(?:inverse|inversons|inversant|change|changeons|retourne|retournons) (?:maintenant |alors |désormais |ensuite )?(?:le sens|l' axe|le moteur|la polarité)"
    r"|(?:est|sont) (?:maintenant |désormais )?(?:inversée?s?|retournée?s?)|sens (?:contraire|opposé|inverse)|à l' envers"
    r"|umgekehrt|umgedreht|umgepolt|gegensinnig|andersherum|anders herum|entgegengesetzt|gegenrichtung|(?:kehrt|kehren|dreht|drehen) (?:\S+ ){1,6}?um(?= (?:[.,:;!?)]|und |oder |\Z))"
    r"|(?:se )?inviert(?:e|imos) (?:ahora )?(?:el|la)|(?:está|queda) (?:ahora )?invertid[oa]|al revés|sentido (?:contrario|opuesto|inverso)"
    r"|(?:si )?invert(?:e|iamo) (?:ora |adesso )?(?:il|la|l')|è (?:ora |adesso )?invertit[oa]|(?:verso|senso) (?:contrario|opposto|inverso)|ao contrário|sentido (?:contrário|oposto)) "
)
_SEEN = regex(
    r"(?<!\S)(?:(?:seen|viewed|looked at) from|looking (?:down|up|from)|vue?s? (?:de|du|d'|depuis|par)|von (?:oben|unten|vorn|vorne|hinten)(?: (?:gesehen|betrachtet))?|vist[oa]s? (?:desde|de|dall'|dal|da|por)) "
)
_FROM_HERE = regex(
    r"(?<!\S)(?:from (?:now|here) on|henceforth|désormais|dorénavant|à partir de (?:maintenant|là)|ab (?:jetzt|hier)|von nun an|a partir de (?:ahora|aquí)|d' ora in poi|a partir de agora) "
)
_NOW = regex(
    r"(?<!\S)(?:now|this time|maintenant|cette fois|jetzt|nun|nunmehr|diesmal|ahora|esta vez|ora|adesso|agora) |(?<!\S)(?:a |un |ein |une )?positi(?:ve[rs]?|f|vo|ver|ves) (?:(?:value|angle|winkel|wert|valeur) (?:of|von|de) )?¤ |¤ positi(?:f|vo) "
)
_ORDINALS = [
    "first premier première erste erster ersten erstes primer primera primo prima primeiro primeira",
    "second deuxième seconde zweite zweiter zweiten zweites segundo segunda secondo elbow coude ellbogen codo gomito",
    "third troisième dritte dritter dritten drittes tercer tercera terzo terza terceiro terceira",
    "fourth quatrième vierte vierter vierten cuarto quarto",
    "fifth cinquième fünfte fünfter fünften quinto",
    "sixth sixième sechste sechster sechsten sexto sesto",
]
_NUMBERS = {word: number for number, words in enumerate(_ORDINALS, start=1) for word in words.split()}
_JOINT = regex(r"\\?(?:var)?(?:theta|phi|q|d|r|alpha|beta)(?:\s*_\s*(?:\{\s*\w+\s*\}|\w))?")
_RELATION = regex(r"(?:theta|q|d|r)\s*_\s*\{?\s*\d\s*\}?\s*=")
_MACHINE = r"(?:robots?|arms?|manipulators?|mechanisms?|machines?|bras|manipulateurs?|mécanismes?|roboters?|mechanismus|brazos?|manipuladore?s?|braccio|manipolatore|braço|robô)"
_SECOND = regex(
    r"\A\W*(?:(?:for|in|on|consider|take|now|also|pour|considérons|prenons|für|bei|beim|betrachten wir|para|consideremos|per|consideriamo) )?(?:now |maintenant |nun |ahora |ora )?(?:(?:the|an?|our|le|la|une?|notre|der|die|das|dem|den|eine?[nm]?|unser|el|los?|una?|il|o|um) )?"
    r"(?:second|other|another|next|third|different|new|deuxième|autre|troisième|nouveau|nouvel|zweite[nrs]?|andere[nrs]?|dritte[nrs]?|nächste[nrs]?|neue[nrs]?|segundo|otro|tercer|nuevo|secondo|altro|terzo|nuovo|outro|terceiro|novo) "
    rf"(?:\S+ )?{_MACHINE} "
)
_FRAME = r"(?:frame|system|coordinate system|coordinate frame|reference frame|repère|référentiel|koordinatensystem|sistema|referencia|terna|referencial)"
_BASE_IS = regex(
    rf"(?<!\S)(?:(?:base|ground|inertial|fixed|world) {_FRAME}|base|{_FRAME} (?:de (?:la )?base|della base|di base|da base|fixe|fijo|fisso)|basis(?:koordinaten)?system|weltsystem|basis)"
    rf" (?:is|are|heißt|ist|est|es|è|é|has|hat|a|porte|lleva|trägt|bears|gets|carries|called|numbered|named)(?: (?:bei uns|hier|here|called|numbered|named|the|our|das|die|der|le|el|il|lo|la|number|numéro|nummer|numero|número|with|index|indice|índice|{_FRAME}))* (?:¤|1|one|eins|un|uno|um) "
)
_ONE = regex(r"(?:\\(?:mathcal|mathrm|mathbf|text)?\s*\{?\s*|\\?\{\s*|[A-Z]\s*_\s*\{?\s*)*1\s*(?:\\?\}\s*)*")
_COUNTED = regex(
    rf"(?<!\S)(?:{_FRAME}s?|repères|systeme|sistemi) (?:\S+ )?(?:numbered|counted|numérotés?|nummeriert|numerados?|numerat[aie]|start|starts|begin|begins|gezählt) (?:from|at|with|à partir de|ab|von|desde|a partir de|da) (?:¤|1|one|eins|un|uno) (?!to |bis |à |a |al |to |up )"
)
_NEXT = regex(r"\s*\{?\s*i\s*\+\s*1\s*\}?\s*")
_HOLDS_LINK = regex(
    r"¤ (?:\S+ )?(?:is|sits|est|ist|es|está|è) (?:\S+ )?(?:fixed|attached|rigidly|glued|bound|solidaire|lié|liée|attaché|fest|befestigt|fijo|unido|solidale|fissat[oa]) (?:\S+ ){0,3}?(?:link|segment|corps|glied|eslabón|membro|braccio|solide) ¤"
)
_TOOL = r"(?:tool|tip|end[ -]effector|hand|gripper|last joint|last link|outil|effecteur|l' outil|l' effecteur|la pince|werkzeug|spitze|greifer|endeffektor|letzten gelenk|herramienta|efector|pinza|extremo|utensile|ferramenta)"
_LISTED = regex(
    rf"(?<!\S)(?:table|rows?|lists?|listed|tableau|lignes?|tabelle|zeilen?|tabla|filas?|tabella|righe|tabela|linhas) (?:[^.;:\s]+ )*?(?:(?:from|beginning with|beginning at|starting with|starting at|starting from|begins? with|begins? at|starts? (?:with|at|from)|à partir de|en partant de|commence par|(?:vom|von der)(?= \S+ (?:aus|her) )|ab dem|beginnt (?:mit|beim|bei)(?: dem| der)?|desde|empieza (?:por|con)|a partire da|desde) (?:the |l' |la |le |el |lo )?{_TOOL}"
    r"|1 (?:is|belongs to|holds|est|gehört zum|ist|es|è) (?:the |that of |of |celle de |das |la |l' |della |de )*(?:last|dernière|letzten?|última|ultimo|tool)) "
)
_BESIDE_TOOL = regex(
    r"from (?:the )?tool (?:frame|coordinates|pose|position|data)|row 1 (?:is )?not|\bloops?\b|\bboucles?\b|\bschleifen?\b|\bbucles?\b|\bcicl[oi]\b|\blaços?\b"
)
_TABLE = regex(r"^[ \t>]*\|[^\n]*(?:α|alpha)|\\begin\{(?:array|tabular)\}[^$]{0,120}(?:α|\\alpha)", re.MULTILINE)


_NEGATIVE_TURNS = regex(
    r"(?<!\S)(?:negative[rns]?|négati(?:f|ve)|negativ[oa])(?: (?:value|values|wert|valeur|valor|valore)(?: of| von| de| di)?)? ¤ "
)


def turned_round(words: str, formulas: Sequence[str]) -> tuple[tuple[str, ...], str]:
    """Return the joints whose direction a sentence turns round, and since when: "from here", "now", or "beside" where it may be said of what is near alone."""
    small = words.lower()
    of_part = [each for each in formulas if _JOINT.fullmatch(each.strip())]
    said = small.split()
    if not _REVERSED.search(small) or any(map(_RELATION.search, formulas)) or small.endswith("? "):
        return (), ""
    if not of_part and not any(_is(each, "PART") for each in said):
        return (), ""
    if _SEEN.search(small) and not (_FROM_HERE.search(small) or _NOW.search(small)):
        return (), ""  # where the sense is that of who looks, and none is turned round
    if _NEGATIVE_TURNS.search(small) and not (_FROM_HERE.search(small) or _NOW.search(small)):
        return (), ""  # as it does of any joint
    numbers = [str(_NUMBERS[each]) for each in said if each in _NUMBERS]
    which = tuple(f"{TURNED_ROUND} {each}" for each in (map(str.strip, of_part) if of_part else numbers))
    since = "from here" if _FROM_HERE.search(small) else "now" if _NOW.search(small) else "beside"
    return which or (TURNED_ROUND,), since


def is_of_other_machine(words: str) -> bool:
    """Whether a sentence begins with a second robot: "The second arm has the same bars, but …"."""
    return _SECOND.match(words.lower()) is not None


def told_build(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield how a sentence counts frames, or lists the rows of a table, that is not as usual."""
    small = words.lower()
    if _counts_from_one(small, formulas):
        yield COUNTED_FROM_ONE
    if says("JOINTS_FROM_ZERO", words):
        yield JOINTS_FROM_ZERO
    if _LISTED.search(small) and not _BESIDE_TOOL.search(small):
        yield FROM_TOOL


def _counts_from_one(words: str, formulas: Sequence[str]) -> bool:
    for each in (_BASE_IS, _COUNTED):
        found = each.search(words)
        if found is not None and ("¤" not in found.group() or _ONE.fullmatch(_formula(words, found.end(), formulas))):
            return True
    held = _HOLDS_LINK.search(words)
    if held is None:
        return False
    return _NEXT.fullmatch(_formula(words, held.start() + 1, formulas)) is not None


def _formula(words: str, end: int, formulas: Sequence[str]) -> str:
    """Return the last formula up to a place of the words."""
    place = words.count("¤", 0, end) - 1
    return formulas[place].strip() if 0 <= place < len(formulas) else ""


def next_table(text: str, start: int) -> int | None:
    """Return where the next table of an arm stands in a text."""
    found = _TABLE.search(text, start)
    return None if found is None else found.start()
