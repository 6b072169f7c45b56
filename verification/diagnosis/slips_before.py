"""A refuted equation that no slip in it explains may be right: what a display before it says of one of its names may hold the slip."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.diagnosis.mend import LearntNotation
from armproof.verification.diagnosis.slips import plain_edits
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.state import Definition

MOST_EDITS = 60  # of one formula


def slip_before(checker: ChainChecker, learnt: LearntNotation, outcome: Outcome) -> Finding | None:
    """Return that an equation holds with one slip mended in what its document says of a name in it, or None.

    What something else holds with that rests on it has none.
    """
    if outcome.true is None or outcome.printed is None or outcome.pair is None or not outcome.pair.is_scalar:
        return None
    made = checker.names.state.definitions
    for key, line in sorted(outcome.uses):
        definition = made.get(key)
        formula = definition.formula if definition is not None else None
        is_held = (key, line) in checker.names.state.held
        if definition is None or formula is None or is_held or definition.line != line or line == 0:
            continue
        for edit in islice(plain_edits(formula, learnt.letters(formula)), MOST_EDITS):
            checker.exact.budget.check()
            if _holds_with(checker, key, definition, edit.node, outcome):
                return say(Kind.SLIP_BEFORE, name=key, line=line, change=edit.finding)
    return None


def _holds_with(checker: ChainChecker, key: str, definition: Definition, formula: n.Node, outcome: Outcome) -> bool:
    """Whether both sides are equal where a name has another formula."""
    made = checker.names.state.definitions
    made[key] = replace(definition, evaluate=checker.members.meaning(formula))
    try:
        values = [as_scalar(checker.member(node).value) for node in outcome.nodes]
        return all(isinstance(each, Scalar) for each in values) and (values[0] - values[1]).is_zero()  # type: ignore[operator, union-attr]
    except EvaluationError:
        return False
    finally:
        made[key] = definition
