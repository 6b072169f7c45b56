r"""The coordinates that a text makes the rows of J: "The task is the pair $(y, \varphi)$; its Jacobian is", "the first row of $J$ belongs to $y$".

Which rows of the arm's Jacobian they are is told where the arm is known: `equations/told_rows.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex

TASK = "task"  # with the coordinates as LaTeX, parted by semicolons, in the order of the rows of J
TASK_UNORDERED = "task of"  # with those that are named, in no order
TASK_BY_RATES = "task by"  # with those whose rates the text lists as the rows
_MARK = ";"

MAY_TELL_TASK = regex(
    r"task|tâche|aufgabe|tarea|compito|tarefa|jacob|control|contrôl|regul|regel|steuer|asserv|command|pilot|measur|mesur|mess|mide|misur|rows?\b|lignes?\b|zeilen?\b|filas?\b|righe?\b|linhas?\b|output|sortie|ausg[aä]ng|operational|opérationnel|order|ordre|reihenfolge|orden|ordine"
)
_OF_TASK = regex(  # what a tuple of coordinates is of
    r"(?<!\S)(?:tasks?|task-space|tâches?|aufgabe|arbeitsraum\w*|aufgabenkoordinaten|tareas?|compit[oi]|tarefas?|jacobians?|jacobienn?e?s?|jacobi-?matri\w*|jacobian[oa]s?|control\w*|contrôl\w*|regul\w*|geregelt|regeln|gesteuert|steuern|asserv\w*|command\w*|pilot\w*|measur\w*|mesur\w*|misst|messen|gemessen|miden?|misura\w*|outputs?|sorties?|ausgang|ausgänge|operational|opérationnel\w*|controla\w*) "
)
_OF_ROW = regex(
    r"(?<!\S)(?:(first|second|third|upper|lower|top|bottom|last) (?:rows?|line)|rows?|(?:première|deuxième|seconde|troisième|dernière)? ?lignes?|(?:erste|zweite|dritte|letzte|obere|untere)?n? ?zeilen?|(?:primera|segunda|tercera)? ?filas?|(?:prima|seconda|terza)? ?righe?|linhas?) "
)
_ONE_BY_ONE = regex(
    r"(?<!\S)(?:first|upper|top|première|premier|supérieure|erste|obere|primera|prima|primeira) (?:row|line|ligne|zeile|fila|riga|linha) (?:of |de |von |di |der )?(?:¤ )?(?:\S+ ){0,4}?¤ (?:[^.;]*?(?:second|lower|bottom|last|deuxième|seconde|inférieure|zweite|untere|segunda|seconda)[^.;]*?¤)"
)
_CONTROLLED = regex(
    r"(?<!\S)(?:control\w*|contrôl\w*|regulated?|geregelt|regeln|gesteuert|steuern|asserv\w*|command[eéo]\w*|pilot\w*|measure[sd]?|measuring|mesur\w*|gemessen|misst|controla\w*|regola\w*|controll\w*|task|tâche|tarea|compito) "
)
_ENTRIES = regex(
    r"(?:^|[^=]*=)\s*(?:\\left)?\s*(?:[\[(]|\\begin\{[bp]?matrix\})(?P<entries>[^()\[\]=]*?)(?:\\right)?\s*(?:[\])]|\\end\{[bp]?matrix\})\s*(?:\^\s*\{?\s*(?:T|\\top|\\intercal|\\mathsf\s*\{?T\}?)\s*\}?)?\s*"
)
_NAME = regex(r"(?:\\[A-Za-z]+|[A-Za-z])(?:\s*_\s*(?:\{[^{}]*\}|\w))?")
_OF_OTHERS = regex(  # joints, lengths, velocities, torques, forces, indices, one point of several
    r"[vV](?:\s*_|\Z)|\\omega|\\(?:var)?theta\s*_|[qdlar]\s*_|q\b|\\tau|[ijkmnNst]\Z|[FfMm]\s*_|\\dot|\w+\s*_\s*\{?\s*\d"
)
_COORDINATE = regex(
    r"[xyzXYZ](?:\s*_\s*(?:\{[A-Za-z\\{} ]+\}|[A-Za-z]))?|[pP]\s*_\s*\{?\s*[xyz]\s*\}?|\\(?:var)?(?:phi|psi)(?:\s*_\s*\{?[A-Za-z]+\}?)?|\\alpha|\\gamma"
)
_RATE = regex(  # of a coordinate, as a row of J gives it: \dot x, v_x, \omega_z
    r"\\dot\s*\{?\s*(?P<coordinate>[xyzXYZ]|[pP]\s*_\s*\{?\s*[xyz]\s*\}?|\\(?:var)?(?:phi|psi))\s*\}?|[vV]\s*_\s*\{?\s*(?P<axis>[xyz])\s*\}?|(?P<turn>\\omega\s*_\s*\{?\s*[xyzXYZ]\s*\}?)"
)
_MOST_RATES = 5  # rows of a task: all six are those of the whole J
_BY = regex(
    r"(?:respect to|as (?:a )?functions? of|respecto (?:de|a)|rapport (?:à|aux)|bezüglich|nach|rispetto a|em relação a|(?<!belongs )(?<!belong )(?<!corresponds )(?<!correspond )to|at|reach|points?|target|ziel|cible|punto|zum punkt)(?: the| l'| la| le| les| den)?(?: \w+){0,2} \Z"
)
_OF_Q = regex(r"(?:\\(?:mathbf|boldsymbol|vec|bm)\s*)?\{?\s*(?:q|\\[tT]heta)\s*\}?\s*=")  # the joints in their order
_JACOBIAN = regex(r"\\?(?:mathbf|boldsymbol|bm)?\s*\{?\s*J\b.*")


def told_tasks(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield the task that a sentence names: its last tuple, its coordinates as rows of J one by one, or those that are controlled."""
    small = words.lower()
    plain = [each.strip() for each in formulas]
    if _ONE_BY_ONE.search(small):
        named = [each for each in plain if _COORDINATE.fullmatch(each)]
        if len(named) > 1:
            yield _task(TASK, named)
            return
    is_ordered = re.search(r"(?<!\S)(?:order|ordre|reihenfolge|orden|ordine|ordem) ", small) is not None
    tuples = [
        entries
        for place, each in enumerate(plain)
        if (entries := _entries(each)) and not _is_argument(small, place) and not _OF_Q.match(each)
    ]
    if tuples and (_OF_TASK.search(small) or _OF_ROW.search(small) or is_ordered):
        yield _task(TASK, tuples[-1])
        return
    if rates := _listed_rates(small, plain):
        yield _task(TASK_BY_RATES, rates)
        return
    if tuples or not _CONTROLLED.search(small):
        return
    named = [name for each in plain if _COORDINATE.fullmatch(name := each.partition("=")[0].strip())]
    others = [each for each in plain if not _COORDINATE.match(each) and not _JACOBIAN.fullmatch(each)]
    if len(named) > 1 and not others:
        yield _task(TASK_UNORDERED, named)


def coordinates_of(task: str) -> tuple[list[str], bool]:
    """Return the coordinates of a task as LaTeX, and whether their order is told."""
    kind = next((each for each in (TASK_UNORDERED, TASK_BY_RATES) if task.startswith(f"{each} ")), TASK)
    return task.removeprefix(f"{kind} ").split(_MARK), kind != TASK_UNORDERED


def _is_argument(words: str, place: int) -> bool:
    """Whether a formula, by its place among them, is what something is differentiated by."""
    before = "¤".join(words.split("¤")[: place + 1])
    return _BY.search(before) is not None


def _task(kind: str, names: Sequence[str]) -> str:
    return f"{kind} {_MARK.join(dict.fromkeys(names))}"


def _listed_rates(words: str, formulas: Sequence[str]) -> list[str]:
    """Return the coordinates whose rates a sentence has as the rows of J: in a tuple, or one after another."""
    if not _OF_ROW.search(words):
        return []
    tuples = [rates for each in formulas if (rates := _rates(each))]
    alone = [each for each in formulas if _RATE.fullmatch(each)]
    return tuples[-1] if tuples else _rates(f"({','.join(alone)})")


def _rates(formula: str) -> list[str]:
    r"""Return the coordinates whose rates are the entries of a tuple, [] of another: "the rows are $(\omega_z, \dot x, \dot y)$"."""
    found = _ENTRIES.fullmatch(formula)
    entries = re.split(r",|;|&|\\\\", found["entries"]) if found is not None else []
    rates = [_RATE.fullmatch(each.strip()) for each in entries]
    if not 1 < len(rates) <= _MOST_RATES or None in rates:
        return []
    return [each["coordinate"] or each["axis"] or each["turn"] for each in rates if each is not None]


def _entries(formula: str) -> list[str]:
    """Return the entries of a tuple of names that are none of joints, lengths, indices or rates."""
    found = _ENTRIES.fullmatch(formula)
    if found is None:
        return []
    entries = [each.strip() for each in re.split(r",|;|&|\\\\", found["entries"])]
    is_task = len(entries) > 1 and all(_NAME.fullmatch(each) and not _OF_OTHERS.match(each) for each in entries)
    return entries if is_task else []
