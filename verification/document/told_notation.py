r"""What the text says of a notation or of a force, and no formula shows: "atan2 takes the abscissa first", "$\sin^{-1}\theta$ means $1/\sin\theta$", "the force $F$ of the wall on the tool".

It holds from the heading above it on.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import DELIMITED, formulas_of

MAY_NOTE = re.compile(  # what no such sentence lacks, in small letters
    r"at(?:an|g)2|arct(?:an|g)2|\^\s*\{?\s*-\s*1|force|kraft|kräfte|fuerza|forza|força|reaction|réaction|reaktion|reacción"
)
ABSCISSA_FIRST = "abscissa first"  # atan2(x, y)
RECIPROCAL = "reciprocal"  # sin^{-1} that is 1/sin
REACTION = "reaction"  # a force on the tool, and the letter of it where it has one: it is held by -J^T F

_ATAN2 = re.compile(r"(?:arc|a)t(?:an|g)_?\{?2\}?|arcus-?tangens", re.IGNORECASE)
_ONE_CALL = re.compile(
    r"(?:arc|a)t(?:an|g)_?\{?2\}?\}?\s*(?:\\left)?\s*\(\s*\\?([A-Za-z]+)\w*\s*[,;]\s*\\?([A-Za-z]+)\w*\s*(?:\\right)?\)",
    re.IGNORECASE,
)
_FIRST = r"first|in front|before|leading|vorn|voran|zuerst|zunächst|vor(?:angestellt)?|premier|première|d'abord|en premier|avant|primero|primer|primera|antes|delante|prima|primo|davanti|primeiro|primeira"
_X = r"(?:\$\s*x\s*\$|\\\(\s*x\s*\\\)|abs[ck]iss\w*|absciss\w*|ascissa|x-(?:value|coordinate|argument|component|wert|koordinate)\w*|(?:adjacent|cosine|kosinus|cosinus|coseno|cosseno)\w*)"
_Y = r"(?:\$\s*y\s*\$|\\\(\s*y\s*\\\)|ordinat\w*|ordonnée|ordenada|y-(?:value|coordinate|argument|component|wert|koordinate)\w*|(?:opposite|sine|sinus|seno)\b)"
_X_FIRST = re.compile(
    rf"(?<![\w$]){_X}(?:(?!{_Y})[^.;!?]){{0,40}}?\b(?:{_FIRST})\b|\b(?:{_FIRST})\b(?:(?!{_Y})[^.;!?]){{0,40}}?(?<![\w$]){_X}|"
    rf"\b(?:order|ordre|reihenfolge|orden|ordine|ordem)\b[^.;!?]{{0,20}}?{_X}\s*,\s*{_Y}",
    re.IGNORECASE,
)
_NOT = re.compile(r"\b(?:not|never|nicht|nie|pas|jamais|no|nunca|non|mai|não|unlike|instead)\b|n't\b", re.IGNORECASE)

_POWER = re.compile(r"\\?(?:sin|cos|tan|sen)\s*\^\s*\{?\s*-\s*1")
_IS_RECIPROCAL = re.compile(
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
    r"utensile|organo terminale|effettore|braccio|ferramenta|efetuador|efetor|braço)"
)
_BY = r"(?:by|par|durch|von|vom|por|da|dal|dalla|dall|pela|pelo|of|de|du|der|des)"
_ACTS = re.compile(
    r"\b(?:exert|push|press|act|appl|pull|exerc|pouss|appu|agi|tir|drück|ausüb|ausgeüb|wirk|ejerc|empuj|aplic|act[úu]|esercit|spin|prem|exerc|empurr|reaction|réaction|reaktion|reacc|reazion|reaç)",
    re.IGNORECASE,
)
_NEAR = r"(?:(?!\b(?:and|et|und|y|while|whereas|but)\b)[^.;:!?]){0,60}?"
_ON_TOOL = re.compile(
    rf"(?<!\w){_AGENT}\b(?!\s*(?:'s)?\s*(?:frame|coordinates)){_NEAR}(?<!\w){_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL}(?!\w)|"
    rf"(?<!\w){_ON}\b\W*(?:\w+\W+){{0,2}}?{_TOOL}(?!\w){_NEAR}(?<!\w){_BY}\b\W*(?:\w+\W+){{0,2}}?{_AGENT}(?!\w)",
    re.IGNORECASE,
)
_FORCE = re.compile(
    r"^[\s{]*(?:\\(?:vec|mathbf|boldsymbol|bm|underline|mathrm|mathcal)\s*\{?\s*)*([FfWwHh])(?![A-Za-z])(?!\s*_\s*\{?\s*g)"
)


def notations_told(sentence: str) -> Iterator[str]:
    """Yield what a sentence says of a notation or a force; with the letter of a force, if it has one."""
    sentence = " ".join(sentence.split())
    if _ATAN2.search(sentence) and _says_abscissa_first(sentence):
        yield ABSCISSA_FIRST
    if _POWER.search(sentence) and _IS_RECIPROCAL.search(sentence) and not _NOT.search(sentence):
        yield RECIPROCAL
    if _ACTS.search(sentence) and _ON_TOOL.search(DELIMITED.sub("¤", sentence)):
        formulas = formulas_of(sentence)
        letters = dict.fromkeys(found[1] for formula in formulas if (found := _FORCE.search(formula)) is not None)
        yield from (f"{REACTION} {letter}" for letter in letters or ("",))


def _says_abscissa_first(sentence: str) -> bool:
    """Whether a sentence about atan2 says that x comes first: in words, or by atan2(x, y) with no atan2(y, x) beside it."""
    alone = DELIMITED.sub(
        lambda found: " " if "=" in found.group() else found.group(), sentence
    )  # θ_1 = atan2(x, y) is one claim
    calls = {(one.lower(), other.lower()) for one, other in _ONE_CALL.findall(alone)}
    if ("y", "x") in calls or _NOT.search(sentence):
        return False
    return ("x", "y") in calls or _X_FIRST.search(sentence) is not None
