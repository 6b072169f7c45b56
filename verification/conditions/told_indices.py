"""What a text tells of the indices of transforms, and of points that are rows, beside the matrices that are printed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.document.index_directions import REFERENCE, ROWS
from armproof.verification.document.sentences import quoted
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import DECIDED


def unless_told_otherwise(outcome: Outcome, told: Sequence[str], names: Names) -> Outcome:
    """Leave open a transform that is written out where the text tells another of its indices to be the reference, or has points as rows."""
    below = [each for node in outcome.nodes for each in n.walk(node)]
    if not any(isinstance(each, n.Matrix) for each in below) or not (outcome.verdict in DECIDED or outcome.defines):
        return outcome
    transforms = [each for each in below if isinstance(each, n.Name) and each.base in "TAHR" and not each.pre_sup]
    for fact, _, text in (each.partition("\n") for each in told):
        if any(_is_otherwise(each, fact, names) for each in transforms):
            doubt = say(Kind.TOLD_INDICES, text=quoted(text))
            return replace(outcome.left_open(doubt), defines=(), as_usual=None)
    return outcome


def _is_otherwise(name: n.Name, told: str, names: Names) -> bool:
    """Whether a transform is read in another way than the text tells."""
    if told == ROWS:
        return True
    index = told.removeprefix(REFERENCE).strip()
    is_pair = len(name.sub.replace(",", "")) > 1 and not name.sup
    if index in ("first", "second"):
        return index == "second" and is_pair
    return index in ("upper", "lower") and bool(name.sub and name.sup) and index != names.transforms
