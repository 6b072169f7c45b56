"""Equations about one name alone that hold whatever it is, as sin θ = ±√(1 - cos² θ) does: they confirm nothing of what defines it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.models.errors import ArmproofError
from armproof.verification.check.limits import SECONDS_TO_EXPLAIN
from armproof.verification.display.statements import Statements
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import HOLDS, Record


def resting_on_nothing(records: Sequence[Record], statements: Statements) -> tuple[Record, ...]:
    """Return the records of a document, those that hold of any value of their one name as resting on no definition of it."""
    return tuple(
        replace(each, outcomes=tuple(replace(one, uses=frozenset()) for one in each.outcomes))
        if _may_be_identity(each) and _is_identity(each, statements)
        else each
        for each in records
    )


def _may_be_identity(record: Record) -> bool:
    """Whether a display decides something by a definition, and is about an angle: told by its words, before it is read again."""
    is_of_angle = any(word in record.latex for word in ("sin", "cos", "tan", "sen", "sec", "csc"))
    return is_of_angle and any(one.verdict in HOLDS and one.uses and not one.links for one in record.outcomes)


def _is_identity(record: Record, statements: Statements) -> bool:
    """Whether all that a display holds of one name holds as well where nothing says what that is."""
    names, state = statements.checker.names, statements.checker.names.state
    try:
        keys = {each.key for statement in names.reader.read(record.latex) for each in n.names(statement)}
        if len(keys) != 1 or not keys <= {key for one in record.outcomes for key, _ in one.uses}:
            return False
        with state.unchanged(), statements.checker.exact.budget.of(SECONDS_TO_EXPLAIN):
            del state.definitions[min(keys)]
            return all(one.verdict in HOLDS for one in statements.tried(record.latex))
    except (ArmproofError, RecursionError, KeyError):
        return False
