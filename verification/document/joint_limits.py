r"""That joints do not turn all round: stops, ranges, "$|q_2| \le 140^\circ$", a column of a table. Then "only $\theta_2 = 0$" may leave nothing out."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex

LIMITED = "limited"  # joints are

MAY_LIMIT = regex(
    r"stop|limit|limite|límite|range|travel|butée|débattement|course|anschl|bereich|grenze|tope|finecorsa|batente|fold|side|côté|seite|lado|lato|\\le|\\ge|\\in|≤|≥|∈|<|>"
)
_LIMITS = regex(
    r"(?<!\S)(?:(?:mechanical |hard |end )?(?:stops|end-stops?|endstops?)|(?:joint|angle|mechanical|axis) (?:limit|range|stop|travel)s?|(?:limits?|ranges?|travel) (?:of|for) (?:the |each |motion |this )*(?:joints?|elbow|axis|axes|wrist|shoulder|¤|first|second|third|fourth|fifth|sixth|last)"
    r"|range of motion|within (?:its|their|the) (?:ranges?|limits?)|butées?(?: (?:mécaniques?|articulaires?))?|limites? (?:articulaires?|mécaniques?|des? (?:l' )?(?:articulation|axe|coude|joint)s?)|débattements?|(?:end)?anschläge?n?|(?:gelenk|winkel|achs)(?:grenzen?|bereiche?)|bewegungsbereiche?"
    r"|topes|límites? (?:articular(?:es)?|mecánicos?)|finecorsa|limiti (?:di giunto|meccanici|articolari)|batentes?"
    r"|(?:cannot|can not|can't|does not|do not|never) (?:fully |completely |quite )?(?:fold|bend|turn|rotate|close)s?(?! out)(?: back| over| all round| backwards| completely| fully)*"
    r"|ne (?:se )?(?:plie|plient|tourne|tournent|replie|replient|peut|peuvent) (?:pas|que|jamais)|(?:only|nur|solo|sólo) (?:bends?|folds?|turns?|beugt|knickt|dobla|piega) (?:\S+ ){0,3}?(?:one|einer?|un|one) (?:side|way|direction|seite|lado|lato)"
    r"|(?:bends?|folds?) (?:only )?(?:to|in|on) (?:one|a single) (?:side|way|direction)) "
)
_NONE = regex(
    r"(?<!\S)(?:no|not|without|ignor\S*|neglect\S*|unlimited|sans|aucune?s?|néglig\S*|ohne|keine?n?|sin|senza|sem|non|any) "
)
_JOINT = r"(?:\\(?:var)?(?:theta|phi|alpha|beta|chi|psi)|[qθ])(?:\s*_\s*\{?\s*\w+\s*\}?)?"
_FULL = r"(?:-?\s*(?:2\s*)?(?:\\pi|π)|-?\s*(?:180|360)\s*(?:°|\^\s*\{?\s*\\circ\s*\}?)|0)"
_BOUND = regex(
    rf"(?:\||\\lvert|\\left\|)\s*{_JOINT}\s*(?:\||\\rvert|\\right\|)\s*(?:\\leq?(?:slant)?(?![A-Za-z])|≤|<)|(?:\\leq?(?:slant)?(?![A-Za-z])|≤|<)\s*{_JOINT}\s*(?:\\leq?(?:slant)?(?![A-Za-z])|≤|<)"
    rf"|{_JOINT}\s*(?:\\in(?![A-Za-z])|∈)\s*(?:\\left\s*)?[\[(\]]"
)
_CLAIMS = regex(r"\\(?:iff|implies|impliedby|text|mathrm|(?:Long)?(?:left)?rightarrow)(?![A-Za-z])|[⇒⇔]", re.IGNORECASE)
_ALL_ROUND = regex(
    rf"\s*(?:{_FULL}\s*(?:\\leq?|≤|<)\s*{_JOINT}\s*(?:\\leq?|≤|<)\s*{_FULL}|{_JOINT}\s*(?:\\in|∈)\s*(?:\\left\s*)?[\[(\]]\s*{_FULL}\s*[,;]\s*{_FULL}\s*(?:\\right\s*)?[\])\[]|(?:\||\\lvert)\s*{_JOINT}\s*(?:\||\\rvert)\s*(?:\\leq?|≤|<)\s*(?:\\pi|π|180\S*))\s*"
)
_COLUMN = regex(
    r"^[ \t]*\|.*\|\s*\W*(?:joint |mechanical )?(?:range|limits?|stops?|travel|butées?|débattement|course|bereich|anschläge?|grenzen?|rango|límites?|limiti|corsa)\b[^|\n]*\||&\s*(?:\\text\w*\{)?\s*(?:range|limits?|butées?|débattement|bereich|anschläge?|límites?|limiti)\b[^&\n]*(?:&|\\\\)",
    re.IGNORECASE | re.MULTILINE,
)


def limits_joints(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence says that joints have stops, or bounds one by less than all the way round."""
    found = _LIMITS.search(words.lower())
    if found is not None and not _NONE.search(" ".join(words.lower()[: found.start()].split()[-4:]) + " "):
        return True
    return any(map(bounds_joint, formulas))


def bounds_joint(latex: str) -> bool:
    """Whether a formula bounds a joint by less than all the way round, and says no more: det J > 0 ⇔ 0 < θ_2 < π tells of no stop."""
    if _CLAIMS.search(latex):
        return False
    return _BOUND.search(latex) is not None and not (_ALL_ROUND.fullmatch(latex) and not _is_one_side(latex))


def _is_one_side(latex: str) -> bool:
    """Whether two bounds are half a turn apart: 0 ≤ θ_2 ≤ π."""
    plain = re.sub(r"[\s{}]", "", latex).replace("\\circ", "°").replace("^", "").replace("π", "\\pi")
    bounds = re.findall(r"(?<![\w_])-?(?:2?\\pi(?![A-Za-z])|\d+°?)", re.sub(_JOINT, "", plain))
    return len(bounds) == 2 and sorted(bounds) in (sorted(each) for each in _HALF_TURNS)


_HALF_TURNS = (("0", "\\pi"), ("-\\pi", "0"), ("0", "180°"), ("-180°", "0"), ("0°", "180°"), ("-180°", "0°"))


def columns_of_limits(text: str) -> Iterator[int]:
    """Yield where a table has a column of what joints may have."""
    yield from (found.start() for found in _COLUMN.finditer(text))
