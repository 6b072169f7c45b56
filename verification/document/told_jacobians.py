r"""What sentences tell of J: its size, "J has six rows and seven columns", and that it maps otherwise than usual, "the rows of $J$ are those of the joints", "$J$ denotes the inverse Jacobian".

A law of any Jacobian is then asked of that size alone; where J maps otherwise, the usual laws of rates and torques are others.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex

SIZE = "size of J"  # with how its rows compare to its columns
WIDE, TALL, SQUARE = (f"{SIZE} {relation}" for relation in "<>=")
MAPS_OTHERWISE = "J maps otherwise"
MAPS_BACK = "J maps back"  # and is no Jacobian of the arm, but its inverse or another
OF_MAPS = (MAPS_OTHERWISE, MAPS_BACK)

MAY_TELL_JACOBIAN = regex(  # what no such sentence lacks, in small letters
    r"jacobi|matri|\bj\b|\$\s*\\?j|redund|redond|ridond|joint|axes|degrees|articulation|liaison|dof|ddl|gelenk|articulaci|giunti|column|colonne|spalten"
)
_TIMES = regex(r"(?<![\d.])(\d)\s*(?:\\times|\\cdot|×|x|-?by-?|par)\s*(\d)(?![\d.])")
_NUMBER = "one|two|three|four|five|six|seven|eight|nine|ten|une|un|deux|trois|quatre|cinq|sept|huit|neuf|dix|zwei|drei|vier|fünf|sechs|sieben|acht|dos|tres|cuatro|cinco|seis|siete|ocho|due|tre|quattro|cinque|sei|sette|otto"
_VALUES = {
    word: number
    for number, words in enumerate(
        [
            "one une un", "two deux zwei dos due", "three trois drei tres tre", "four quatre vier cuatro quattro",
            "five cinq fünf cinco cinque", "six sechs seis sei", "seven sept sieben siete sette",
            "eight huit acht ocho otto", "nine neuf", "ten dix",
        ],
        start=1,
    )
    for word in words.split()
}  # fmt: skip
_COUNT = rf"(?<![\w.])(?P<count>\d{{1,2}}|{_NUMBER})"
_JOINT = r"(?:joints?|axes|axis|motors?|actuators?|degrees? of freedom|dofs?|articulations?|liaisons?|pivots?|degrés? de liberté|ddl|moteurs?|actionneurs?|gelenke?n?|achsen|freiheitsgrade?|articulaciones|ejes|grados de libertad|giunti|assi|gradi di libertà)"
_TASK = r"(?:coordinates?|dimensions?|dimensional|components?|task variables?|coordonnées?|composantes?|koordinaten|dimensionen|coordenadas?|coordinate)"
_ROW = r"(?:rows?|lignes?|zeilen?|filas?|righe)"
_COLUMN = r"(?:columns?|colonnes?|spalten?|columnas?|colonne)"
_OF = {
    "joints": regex(rf"{_COUNT}[ -](?:(?:revolute|actuated|independent|active|rotoid\w*) )?{_JOINT}(?!\w)"),
    "task": regex(rf"{_COUNT}[ -]{_TASK}(?!\w)"),
    "rows": regex(rf"{_COUNT} {_ROW}(?!\w)"),
    "columns": regex(rf"{_COUNT} {_COLUMN}(?!\w)"),
}  # fmt: skip
_MORE = r"(?:more|greater|plus|mehr|más|più)"
_FEWER = r"(?:fewer|less|moins|weniger|menos|meno)"
_LIKE_COLUMNS, _LIKE_ROWS = rf"(?:{_JOINT}|{_COLUMN})", rf"(?:{_TASK}|{_ROW}|tâche|task|aufgabe)"
_NEAR = r"(?:d' |de |of |the |\S+ ){0,2}?"
_THAN = r"(?:\S+ ){0,3}?(?:than|que|als|qu'|di|che) (?:\S+ ){0,5}?"
_IS_WIDE = regex(
    rf"(?<!\S){_MORE} {_NEAR}{_LIKE_COLUMNS} {_THAN}{_LIKE_ROWS}(?!\w)|(?<!\S){_FEWER} {_NEAR}{_LIKE_ROWS} {_THAN}{_LIKE_COLUMNS}(?!\w)"
)
_IS_TALL = regex(
    rf"(?<!\S){_FEWER} {_NEAR}{_LIKE_COLUMNS} {_THAN}{_LIKE_ROWS}(?!\w)|(?<!\S){_MORE} {_NEAR}{_LIKE_ROWS} {_THAN}{_LIKE_COLUMNS}(?!\w)"
)
_IS_SQUARE = regex(
    r"(?<!\S)(?:(?:is|are|be) square(?! roots?| of)|square (?:matrix|matrices|jacobian\S*|¤|case)|carrées?|quadratisch\w*|cuadrada|quadrata|non-redundant|nonredundant|not redundant|non redondante?|pas redondante?|as many|autant)(?= )"
)
_REDUNDANT = regex(r"(?<!\S)(?:(?:kinematically )?redundant|redondante?s?|redundante?[nrs]?|ridondante)(?= )")
_LETTERS = regex(r"([nm])\s*(>|<|=|\\gt|\\lt)\s*([nm])")
_MOST_OF_TASK = 6  # coordinates of a pose: seven joints are more
_MATRIX = regex(r"(?<!\S)(?:jacobian?s?|jacobienn?e?s?|jacobi\S*|matri(?:x|ces|ce|z))(?= )")

_PLAIN = regex(
    r"\\(?:,|;|:|!|\s|quad|left|right|(?:mathbf|boldsymbol|bm|mathrm|vec|underline)(?![A-Za-z]))|[\s{}]|\((?:q|\\theta|t)\)"
)
_RATES, _TOOL = r"\\dot(?:q|\\theta|\\Theta)", r"(?:\\dot[xXpPr](?:_\w+)?|[vV](?:_\w+)?|\\xi|\\nu)"
_ALONE = regex(r"J")
_TURNED = regex(r"J\^(?:-1|\+|\\dagger|T|\\top|-T)")
_MAP = regex(rf"{_RATES}=J{_TOOL}|{_TOOL}=J\^(?:T|\\top|\\intercal|\\mathsfT){_RATES}")
_USUAL_MAP = regex(rf"{_TOOL}=J{_RATES}")
_ENTRY = regex(r"J_?ij=\\[dt]?frac\\partial\w+_j\\partial\S+_i|J_?ij=\\partial\w+_j/\\partial\S+_i")
_IS_INVERSE = regex(
    r"¤ (?:(?:here|always|now|then|thus|ici|alors|\S+ly) )?(?:denotes|is|means|designates|stands for|désigne|est|représente|bezeichnet|ist|designa|es|indica|è) (?:always |here |ici |hier )?(?:the |la |l' |die |el |il )?(?:so-called )?(?:inverse (?:kinematic )?jacobi\S*|jacobi\S* (?:inverse|inversa)|inverse of the (?:usual )?jacobi\S*)"
    r"|(?<!\S)(?:inverse jacobi\S*|jacobi\S* (?:inverse|inversa))(?: matrix)? (?P<named>¤)"
)
_IS_TRANSPOSED = regex(
    rf"(?<!\S){_ROW} (?:(?!col|spalt|deriv|dériv|gradient|respect|coord|by |par )\S+ ){{0,7}}?{_JOINT}(?!\w)|(?<!\S){_ROW} (?:a|per|par|for each|for every|pour chaque|je|por) {_JOINT}(?!\w)"
    rf"|(?<!\S){_COLUMN} (?:a|per|par|for each|for every|pour chaque) {_TASK}|(?<!\S){_COLUMN} (?:(?!row|ligne|zeile)\S+ ){{0,2}}?(?:correspond\S*|belongs?|aux?|sont celles) (?:(?!row|ligne)\S+ ){{0,2}}?{_TASK}"
    rf"|gradients? (?:\S+ ){{0,4}}?(?:in|as|en|als) (?:its |the |ses |les )?{_COLUMN}|{_COLUMN} (?:are|sont) (?:the |les )?gradients"
    r"|derivatives? of the ¤(?:-?th)? coordinate (?:with respect to|by) the ¤|(?:dérivée) de la ¤(?:-?\S+)? coordonnée (?:\S+ ){0,3}?(?:à|par) (?:\S+ )?¤"
    r"|transpose of the usual jacobi|transposée de la jacobienne (?:usuelle|habituelle)|(?:transposed|denominator|gradient)[- ](?:layout|convention)|convention transposée"
)
_OF_ITS_INVERSE = regex(
    r"(?<!\S)(?:inver(?:se|ting|sion)|l' inverse|transpos\S*|pseudo\S*) (?:of |de |d' |la |the |le )*(?:matri(?:x|ce) )?¤"
)
_OF_JOINTS = r"(?:joint|actuator|motor|drive|articula|actionneur|moteur|gelenk|antrieb|leg|jambe)\S*"
_OF_TOOL = r"(?:tool|platform|plate-?forme|hand|end|effector|gripper|outil|effecteur|pince|task|cartesian|cartésien\S*|twist|plattform|werkzeug|celle)"
_FROM = r"(?:from|for|pour|für|as (?:a )?functions? of|in terms of|en fonction|à partir|out of|given|aus)"
_GIVES = r"(?:gives?|maps?|takes?|sends?|transforms?|yields?|converts?|computes?|donne|fournit|transforme|convertit|envoie|liefert|bildet)"
_MAPS_BACK = regex(
    rf"¤ (?:\S+ ){{0,6}}?{_GIVES} (?:(?!{_OF_TOOL} )\S+ ){{0,6}}?{_OF_JOINTS} (?:\S+ ){{0,3}}?{_FROM} (?:\S+ ){{0,6}}?{_OF_TOOL}(?!\w)"
    rf"|¤ (?:\S+ ){{0,6}}?{_GIVES} (?:(?!{_OF_JOINTS} )\S+ ){{0,6}}?{_OF_TOOL} (?:(?!{_OF_JOINTS} )\S+ ){{0,5}}?(?:to|into|onto|in|en|vers|auf) (?:\S+ ){{0,4}}?{_OF_JOINTS}(?!\w)"
)
_ASKS = r"(?:asks?|finds?|computes?|gets?|obtains?|calculates?|determines?|learns?|sees?|tells?|cherche|calcule|trouve|obtient|détermine|fragt|berechnet|findet|bestimmt|erhält)"
_ASKED_BACK = regex(  # "With $J$ one asks what force …", "$J$ takes torques to forces"
    rf"(?<!\S)(?:with|by|using|from|through|via|avec|par|mit|durch) ¤ (?:\S+ )?(?:one|we|you|on|nous|man|wir) (?:\S+ )?{_ASKS} (?:(?!{_OF_TOOL} |velocit|speed|torque|couple)\S+ ){{0,4}}?(?:{_OF_JOINTS} (?:rates?|speeds?|velocit\S+|turn|move|must|should|have)|{_OF_JOINTS}geschw\S*|vitesses? {_OF_JOINTS}|forces?|kraft|kräfte)(?!\w)"
    rf"|¤ (?:\S+ ){{0,3}}?{_GIVES} (?:\S+ ){{0,3}}?(?:torques?|couples?|momente) (?:\S+ ){{0,3}}?(?:to|into|onto|en|vers|auf|in) (?:\S+ ){{0,3}}?(?:forces?|wrench\S*|efforts?|kräfte)"
    rf"|¤ (?:\S+ ){{0,3}}?{_GIVES} (?:\S+ ){{0,3}}?(?:forces?|wrench\S*|kräfte) (?:\S+ ){{0,3}}?{_FROM} (?:\S+ ){{0,3}}?(?:torques?|couples?|momente)"
)
_HOW_JOINTS_MOVE = regex(  # a question to which $J$ is no answer
    rf"(?<!\S)(?:how (?:fast|quickly)|(?:at|with|by) what (?:rates?|speeds?)|what (?:rates?|speeds?|velocit\S+)|which (?:rates?|speeds?|velocit\S+)|à quelles? vitesses?|wie schnell|mit welchen?) (?:(?!{_OF_TOOL} |for |pour |für )\S+ ){{0,4}}?{_OF_JOINTS}(?= )[^?]*\? "
)
_IS_ANSWER = regex(
    r"(?<!\S)(?:(?:this|that|which) is what ¤ |¤ (?:answers|solves|tells|says) (?:this|that|it)|(?:this|that|the) (?:question )?(?:is answered|answer is given) by ¤|¤ is the answer|(?:c' est|voilà) ce que (?:donne|dit|calcule) ¤|das (?:beantwortet|sagt) ¤)"
)


def answers_back(question: str, words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence has J as the answer to the question before it how the joints move: "This is what $J$ answers"."""
    asked = _HOW_JOINTS_MOVE.search(question.lower()) and _IS_ANSWER.search(words.lower())
    return asked is not None and any(map(_ALONE.fullmatch, map(plain_formula, formulas)))


def told_jacobians(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield the size of J that a sentence tells, and whether J maps otherwise there."""
    small, plain = words.lower(), [plain_formula(each) for each in formulas]
    if (size := _size(small, plain, formulas)) is not None:
        yield size
    if any(_MAP.fullmatch(each) or _ENTRY.search(each) for each in plain) or _is_otherwise(small, plain):
        yield MAPS_OTHERWISE
    if _is_of_j(small, plain) and _maps_back(small, plain):
        yield MAPS_BACK


def plain_formula(latex: str) -> str:
    """Return a formula without blanks, braces, fonts and the arguments of J(q)."""
    return _PLAIN.sub("", latex.strip().rstrip(".,;"))


def maps_otherwise(latex: str) -> bool | None:
    r"""Return whether a display says that J maps otherwise than usual, \dot q = J \dot x; None where it says no such thing."""
    plain = plain_formula(latex)
    if _MAP.fullmatch(plain):
        return True
    return False if _USUAL_MAP.fullmatch(plain) else None


def _is_of_j(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence is of J alone, and not of its inverse or transpose."""
    is_alone = any(map(_ALONE.fullmatch, formulas)) or "jacobi" in words
    return is_alone and not any(map(_TURNED.search, formulas)) and _OF_ITS_INVERSE.search(words) is None


def _is_otherwise(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence says of J that it maps otherwise, or has its rows and columns exchanged."""
    if not _is_of_j(words, formulas):
        return False
    if _IS_TRANSPOSED.search(words) and not re.search(r"(?<!\S)(?:table|tableau|tabelle|tabla|tabella) ", words):
        return True
    return _maps_back(words, formulas)


def _maps_back(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence of J says that it is the inverse, or leads from the tool to the joints, or from torques to forces."""
    found = _IS_INVERSE.search(words) or _MAPS_BACK.search(words) or _ASKED_BACK.search(words)
    at = words[: found.start()].count("¤") if found is not None else 0
    return found is not None and at < len(formulas) and _ALONE.fullmatch(formulas[at]) is not None


def _size(words: str, plain: Sequence[str], formulas: Sequence[str]) -> str | None:
    """Return how the rows of J compare to its columns."""
    if _IS_SQUARE.search(words):
        return SQUARE
    is_of_j = _MATRIX.search(words) is not None or any(each.startswith("J") for each in plain)
    sizes = [found for each in (*formulas, words) if (found := _TIMES.search(each)) is not None] if is_of_j else []
    if sizes:
        return _compared(*map(int, sizes[-1].groups()))
    for each in plain:
        if found := _LETTERS.fullmatch(each):
            left, relation, right = found.groups()
            turned = {">": "<", "<": ">", "\\gt": "<", "\\lt": ">"}.get(relation, "=")  # n joints, m coordinates
            return f"{SIZE} {turned}" if (left, right) == ("n", "m") else _turned(f"{SIZE} {turned}")
    if _IS_WIDE.search(words):
        return WIDE
    if _IS_TALL.search(words):
        return TALL
    count = {kind: _count(found["count"]) for kind, each in _OF.items() if (found := each.search(words)) is not None}
    count = {kind: number for kind, number in count.items() if number > 1}  # one row for each coordinate
    joints = count.get("columns") or count.get("joints")
    rows = count.get("rows") or count.get("task")
    if joints is not None and rows is not None:
        return _compared(rows, joints)
    if joints is not None and joints > _MOST_OF_TASK:
        return WIDE
    return WIDE if _REDUNDANT.search(words) else None


def _count(text: str) -> int:
    return int(text) if text.isdigit() else _VALUES[text]


def _compared(rows: int, columns: int) -> str:
    return SQUARE if rows == columns else WIDE if rows < columns else TALL


def _turned(size: str) -> str:
    return {WIDE: TALL, TALL: WIDE}.get(size, size)
