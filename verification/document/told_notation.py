r"""What the text says of a notation or of a force, and no formula shows: "atan2 takes the abscissa first", "$\sin^{-1}\theta$ means $1/\sin\theta$", "the force $F$ of the wall on the tool".

It holds from the heading above it on.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import DELIMITED, formulas_of
from armproof.verification.patterns import regex

MAY_NOTE = regex(  # what no such sentence lacks, in small letters
    r"at(?:an|g)2|arct(?:an|g)2|\^\s*\{?\s*-\s*1|recipro|recíproco|kehrwert|reziprok|multiplicati|moltiplicativ|inverso|force|kraft|kräfte|fuerza|forza|força|reaction|réaction|reaktion|reacción"
)
ABSCISSA_FIRST = "abscissa first"  # atan2(x, y)
ORDINATE_FIRST = "ordinate first"  # atan2(y, x), as it mostly is
RECIPROCAL = "reciprocal"  # sin^{-1} that is 1/sin
REACTION = "reaction"  # a force on the tool, and the letter of it where it has one: it is held by -J^T F

_ATAN2 = regex(r"(?:arc|a)t(?:an|g)_?\{?2\}?|arcus-?tangens", re.IGNORECASE)
_ONE_CALL = regex(
    r"(?:arc|a)t(?:an|g)_?\{?2\}?\}?\s*(?:\\left)?\s*\(\s*\\?([A-Za-z]+)\w*\s*[,;]\s*\\?([A-Za-z]+)\w*\s*(?:\\right)?\)",
    re.IGNORECASE,
)
_FIRST = r"first|in front|before|leading|vorn|voran|zuerst|zunächst|vor(?:angestellt)?|premier|première|d'abord|en premier|avant|primero|primer|primera|antes|delante|prima|primo|davanti|primeiro|primeira"
_X = r"(?:\$\s*x\s*\$|\\\(\s*x\s*\\\)|abs[ck]iss\w*|absciss\w*|ascissa|x-(?:value|coordinate|argument|component|wert|koordinate)\w*|(?:adjacent|cosine|kosinus|cosinus|coseno|cosseno)\w*)"
_Y = r"(?:\$\s*y\s*\$|\\\(\s*y\s*\\\)|ordinat\w*|ordonnée|ordenada|y-(?:value|coordinate|argument|component|wert|koordinate)\w*|(?:opposite|sine|sinus|seno)\b)"
_SECOND = r"second|behind|after|last|zweit\w*|danach|hinten|deuxième|seconde?|dernière?|après|segund[oa]|después|detrás|second[oa]|dopo|depois|último"
_ORDER = r"\b(?:order|ordre|reihenfolge|orden|ordine|ordem)\b[^.;!?]{0,20}?"


def _named_first(one: str, other: str) -> tuple[re.Pattern[str], re.Pattern[str]]:
    """Return the patterns of "the one comes first" and of "first comes the one", in which no word for the other stands."""
    near = rf"(?:(?!{other}|\b(?:{_SECOND})\b)[^.;!?]){{0,40}}?"
    is_said = rf"(?<![\w$]){one}{near}\b(?:{_FIRST})\b|{_ORDER}{one}\s*,\s*{other}"
    return re.compile(is_said, re.IGNORECASE), re.compile(rf"\b(?:{_FIRST})\b{near}(?<![\w$]){one}", re.IGNORECASE)


_X_FIRST, _Y_FIRST = _named_first(_X, _Y), _named_first(_Y, _X)
_NOT = regex(r"\b(?:not|never|nicht|nie|pas|jamais|no|nunca|non|mai|não|unlike|instead)\b|n't\b", re.IGNORECASE)

_POWER = regex(r"\\?(?:sin|cos|tan|sen)\s*\^\s*\{?\s*-\s*1")
_MINUS_ONE = regex(r"[-–−]\s*1(?!\d)|minus one|moins un|minus eins|menos uno|meno uno|menos um", re.IGNORECASE)
_OF_FUNCTION = regex(  # whose exponent it is: "an exponent $-1$ behind the name of a function"
    r"(?:\b(?:trigonometric|sines?|cosines?|tangents?|functions?|fonctions?|funktion\w*|función|funciones|funzion[ei]|funç(?:ão|ões)|sinus|cosinus|kosinus|tangens)\b.*\b(?:exponent\w*|power|superscript|exposant|puissance|hochzahl|potenz|exponente|potencia|esponente|potenza|expoente|potência)\b"
    r"|\b(?:exponent\w*|power|superscript|exposant|puissance|hochzahl|potenz|exponente|potencia|esponente|potenza|expoente|potência)\b.*\b(?:trigonometric|sines?|cosines?|tangents?|functions?|fonctions?|funktion\w*|función|funciones|funzion[ei]|funç(?:ão|ões)|sinus|cosinus|kosinus|tangens)\b)",
    re.IGNORECASE,
)
_IS_RECIPROCAL = regex(
    r"\b(?:reciprocal|multiplicative inverse|kehrwert|reziproke\w*|inverse multiplicatif|recíproco|reciproco|inverso multiplicativo)\b|"
    r"1\s*/\s*\\?(?:sin|cos|tan|sen)|\\[dt]?frac\s*\{?1\}?\s*\{?\s*\\?(?:sin|cos|tan)",
    re.IGNORECASE,
)

_AGENT = (
    r"(?:environment|surroundings|wall|workpiece|piece|part|object|obstacle|table|ground|floor|surface|load|payload|human|operator|"
    r"environnement|mur|paroi|pièce|objet|obstacle|sol|surface|charge|"
    r"umgebung|wand|werkstück|gegenstand|objekt|hindernis|tisch|boden|oberfläche|last|mensch|"
    r"entorno|pared|pieza|objeto|obstáculo|mesa|suelo|superficie|carga|"
    r"ambiente|parete|pezzo|oggetto|ostacolo|tavolo|superficie|carico|parede|peça|obstáculo)(?:s|es)?"
)
_ON = r"(?:on|onto|upon|against|at|sur|contre|à|auf|gegen|an|sobre|contra|en|su|sull|sulla|sul|contro|na|no)"
_TOOL = (
    r"(?:tool|gripper|hand|end[ -]?effector|effector|tip|arm|robot|manipulator|flange|fingers?|"
    r"outil|pince|effecteur|main|organe terminal|bras|préhenseur|"
    r"werkzeug|greifer|hand|endeffektor|spitze|arm|roboter|manipulator|tcp|"
    r"herramienta|pinza|efector|mano|brazo|garra|"
    r"utensile|organo terminale|effettore|braccio|mão|ponta|ferramenta|efetuador|efetor|braço)"
)
_BY = r"(?:by|par|durch|von|vom|por|da|dal|dalla|dall|pela|pelo|of|de|du|der|des)"
_ACTS = regex(
    r"\b(?:exert|push|press|act|appl|pull|exerc|pouss|repouss|appu|agi|tir|drück|ausüb|ausgeüb|wirk|ejerc|empuj|aplic|act[úu]|esercit|spin|prem|exerc|empurr|zieh|schieb|stöß|repel|drag|shov|jala|pux|preme|presi|reaction|réaction|reaktion|reacc|reazion|reaç)",
    re.IGNORECASE,
)
_NEAR = r"(?:(?!\b(?:and|et|und|y|while|whereas|but)\b)[^.;:!?]){0,60}?"
_ON_TOOL = regex(
    rf"(?<!\w){_AGENT}\b(?!\s*(?:'s)?\s*(?:frame|coordinates)){_NEAR}(?<!\w){_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL}(?!\w)|"
    rf"(?<!\w){_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL}(?!\w){_NEAR}(?<!\w){_BY}\b\W*(?:\w+\W+){{0,2}}?{_AGENT}(?!\w)",
    re.IGNORECASE,
)
_OWN = rf"(?:{_TOOL}|forearm|wrist|elbow|avant-bras|poignet|coude|motors?|actuators?|joints?|links?|body|bodies|drives?|moteurs?|actionneurs?|articulations?|segments?|motoren|antriebe?|gelenke?|actuadores|juntas?|motori|giunti)"
_ARTICLE = r"(?:the|an?|this|that|its|our|les?|la|l['’]|une?|des?|der|die|das|eine?|el|los|las|una?|il|lo|uno|os?|as)"
_EXERTS = r"(?:exerts?|pulls?|pushes|push|presses|press|drags?|exerce(?:nt)?|tire(?:nt)?|pousse(?:nt)?|appuie(?:nt)?|drückt|zieht|ausübt|ejercen?|empujan?|esercitano?|spingono|spinge|exercem?|empurram?)"
_BY_OTHER = regex(  # whoever it is that exerts it: "the scale pulls on the tip", "exerted on the arm by a spring"
    rf"\b{_ARTICLE}\s*(?!{_OWN}\b)(?:(?!{_OWN}\b)[\w-]+ ){{1,3}}{_EXERTS} (?:(?:\w+ ){{0,2}}?){_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL}(?!\w)|"
    rf"(?:exerted|applied|exercée?|appliquée?|ejercida|aplicada|esercitata|applicata) {_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL} {_BY} {_ARTICLE}\s*(?!{_OWN}\b)(?:\w+ )?(?!{_OWN}\b)\w+",
    re.IGNORECASE,
)
_PUSHES = r"(?:pushes|push|presses|press|pulls?|drags?|repels?|shoves?|(?:re)?pousse(?:nt)?|tire(?:nt)?|presse(?:nt)?|drückt|drücken|schiebt|schieben|zieht|ziehen|stößt|empujan?|presionan?|jalan?|spingono|spinge|premono|preme|tirano|tira|empurram?|puxam?)"
_PUSHES_TOOL = regex(  # with no preposition: "the wall pushes the hand away"
    rf"\b{_ARTICLE}\s*(?!{_OWN}\b)(?:(?!{_OWN}\b)[\w-]+ ){{1,3}}{_PUSHES} (?:back |away )?{_ARTICLE}\s*{_TOOL}(?!\w)",
    re.IGNORECASE,
)
_EMPHASIS = regex(r"\\(?:emph|textit|textbf|underline)\s*\{([^{}]*)\}|\*+")
_FORCE = regex(
    r"^[\s{]*(?:\\(?:vec|mathbf|boldsymbol|bm|underline|mathrm|mathcal)\s*\{?\s*)*([FfWwHh])(?![A-Za-z])(?!\s*_\s*\{?\s*g)"
)


def notations_told(sentence: str) -> Iterator[str]:
    """Yield what a sentence says of a notation or a force; with the letter of a force, if it has one."""
    sentence = " ".join(sentence.split())
    if _ATAN2.search(sentence) and (order := _order_said(sentence)):
        yield order
    names_power = _POWER.search(sentence) or (_OF_FUNCTION.search(sentence) and _MINUS_ONE.search(sentence))
    if names_power and _IS_RECIPROCAL.search(sentence) and not _NOT.search(sentence):
        yield RECIPROCAL
    if _ACTS.search(sentence) and _is_on_tool(_EMPHASIS.sub(lambda found: found[1] or "", sentence)):
        formulas = formulas_of(sentence)
        letters = dict.fromkeys(found[1] for formula in formulas if (found := _FORCE.search(formula)) is not None)
        yield from (f"{REACTION} {letter}" for letter in letters or ("",))


def _is_on_tool(sentence: str) -> bool:
    """Whether a force of a sentence acts on the tool, and not from it on something else."""
    plain = DELIMITED.sub("¤", sentence)
    return any(each.search(plain) for each in (_ON_TOOL, _BY_OTHER, _PUSHES_TOOL))


def _order_said(sentence: str) -> str:
    """Return which of x and y a sentence about atan2 says to come first: in words, or by atan2(x, y) with no atan2(y, x) beside it."""
    alone = DELIMITED.sub(
        lambda found: " " if "=" in found.group() else found.group(), sentence
    )  # θ_1 = atan2(x, y) is one claim
    calls = {(one.lower(), other.lower()) for one, other in _ONE_CALL.findall(alone)}
    if _NOT.search(sentence):
        return ""
    if {("x", "y"), ("y", "x")} & calls:
        return ORDINATE_FIRST if ("y", "x") in calls else ABSCISSA_FIRST
    for x_first, y_first in zip(_X_FIRST, _Y_FIRST, strict=True):  # "the ordinate first and the abscissa second"
        found = [bool(each.search(sentence)) for each in (x_first, y_first)]
        if any(found):
            return "" if all(found) else (ABSCISSA_FIRST if found[0] else ORDINATE_FIRST)
    return ""
