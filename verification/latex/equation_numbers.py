r"""The number of an equation that its author sets beside it by hand: x = a \;\; (2), x = a. ~ (3.1), x = a \hfill (4)."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex

_LAYOUT = r"(?:\\(?:displaystyle|textstyle|hfill|hfil|dotfill|hrulefill|mathstrut|relax|null)(?![A-Za-z])|\{\s*\})"
_GAP = rf"(?:\\[,;:! ]|\\q?quad(?![A-Za-z])|~|\\(?:thin|med|thick)?space(?![A-Za-z])|\\(?:hspace\*?|hskip)\s*\{{[^{{}}]*\}}|{_LAYOUT}|\.{{3,}})"
_STOP = r"[.,;。，；]"
_WORDS = r"\\(?:text|textrm|textbf|textnormal|mathrm|mbox|hbox|rm)\s*"
_LABEL = r"(?:[A-Z]\s*[.-]?\s*)?[1-9]\d{0,2}(?:\s*[.–-]\s*\d{1,3})*\s*[a-z]?'?"
_NUMBER = regex(
    rf"(?<=[\w)\]}}'|])(?P<gap>\s*(?:{_STOP}\s*)?(?:{_GAP}\s*)+|\s*{_STOP}\s+)(?P<label>(?:\\(?:left|big|Big)\s*)?[(（]\s*{_LABEL}\s*(?:\\(?:right|big|Big)\s*)?[)）]"
    rf"|{_WORDS}\{{\s*[(（]\s*{_LABEL}\s*[)）]\s*\}})(?=\s*{_STOP}?\s*(?:\\\\|\Z|\\end\s*\{{))"
)
_NO_LINES = regex(r"\\(?P<which>begin|end)\s*\{(?:\w*matrix\*?|array|d?cases|rcases)\}")


def without_numbers(text: str) -> str | None:
    """Return a display with the numbers of its equations blank, as long as it was; None where it has none.

    They stand last in a display or a line, behind a blank or a stop. The last entry of a row of a matrix is none.
    """
    if not ("(" in text or "（" in text):
        return None
    found = [each for each in _NUMBER.finditer(text) if _is_outside(text, each.start())]
    letters = list(text)
    for each in found:
        begin, end = each.start("gap"), each.end("label")
        letters[begin:end] = " " * (end - begin)
    return "".join(letters) if found else None


def _is_outside(text: str, place: int) -> bool:
    """Whether no matrix is open at a place."""
    marks = [found["which"] for found in _NO_LINES.finditer(text, 0, place)]
    return marks.count("begin") == marks.count("end")


def either_factor(text: str, numbered: list[n.Statement], plain: list[n.Statement]) -> list[n.Statement]:
    r"""Return the statements without the numbers of their equations; one behind numbers alone, 6 = 2 \; (3), may be a factor."""
    if len(numbered) != len(plain):
        return plain
    return [_either(text, *pair) for pair in zip(numbered, plain, strict=True)]


def _either(text: str, numbered: n.Statement, plain: n.Statement) -> n.Statement:
    if not (isinstance(numbered, n.Chain) and isinstance(plain, n.Chain)) or numbered.relations != plain.relations:
        return plain
    factor, label = numbered.members[-1], plain.members[-1]
    if factor == label or n.names(factor) or not plain.relations:
        return plain
    unclear = n.Ambiguous((label, factor), text[slice(*factor.span)], "label", span=factor.span)
    return replace(plain, members=(*plain.members[:-1], unclear))
