"""What a text tells of the indices of transforms, and of points that are rows, beside the matrices that are printed."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.document import Display
from armproof.verification.document.index_directions import (
    LEFT_LOWER,
    LEFT_UPPER,
    REFERENCE,
    ROWS,
    has_scripts_around,
)
from armproof.verification.document.sentences import quoted
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.tokens import PRE_SCRIPTS
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.names import Names
from armproof.verification.verdict import DECIDED


def unless_told_otherwise(outcome: Outcome, display: Display, names: Names) -> Outcome:
    """Leave open a transform that is written out where the text tells another of its indices to be the reference, or has points as rows.

    Of scripts before a letter the document shows by its products which is the reference, {}^A_CT = {}^B_CT {}^A_BT; where
    one of them stands behind it, the upper one always is.
    """
    if not (outcome.verdict in DECIDED or outcome.defines):
        return outcome
    below = [each for node in outcome.nodes for each in n.walk(node)]
    is_printed = any(isinstance(each, n.Matrix) for each in below)
    transforms = [each for each in below if isinstance(each, n.Name) and each.base in "TAHR" and not each.pre_sup]
    for fact, _, text in (each.partition("\n") for each in display.directions):
        is_otherwise = fact in (LEFT_LOWER, LEFT_UPPER) and _are_otherwise(display.latex, fact, names)
        if is_otherwise or (is_printed and any(_is_otherwise(each, fact, names) for each in transforms)):
            doubt = say(Kind.TOLD_INDICES, text=quoted(text))
            return replace(outcome.left_open(doubt), defines=(), as_usual=None)
    return outcome


def _are_otherwise(latex: str, told: str, names: Names) -> bool:
    """Whether scripts before letters are read in another way than the text tells."""
    if has_scripts_around(latex):
        return told == LEFT_LOWER
    return PRE_SCRIPTS.search(normalise_unicode(latex)) is not None and names.reader.spelling.reference_below != (
        told == LEFT_LOWER
    )


def _is_otherwise(name: n.Name, told: str, names: Names) -> bool:
    """Whether a transform is read in another way than the text tells."""
    if told == ROWS:
        return True
    index = told.removeprefix(REFERENCE).strip()
    is_pair = len(name.sub.replace(",", "")) > 1 and not name.sup
    if index in ("first", "second"):
        return index == "second" and is_pair
    return index in ("upper", "lower") and bool(name.sub and name.sup) and index != names.transforms
