"""Equations that hold whatever their names are: sin θ = ±√(1 − cos² θ) tells nothing of what was said of θ before."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import DocumentState
from armproof.verification.verdict import HOLDS

Check = Callable[[], list[Outcome]]


def rests_on_nothing(names: Names, chain: n.Chain, outcomes: Sequence[Outcome], again: Check) -> bool:
    """Return whether a chain of names that displays define holds without all that was said before, in a document without an arm.

    There a definition counts by what rests on it alone, and such a chain would let a mistaken one pass.
    """
    written = {below.key for member in chain.members for below in n.names(member)}
    defined = written & names.state.definitions.keys()
    holds = bool(outcomes) and all(each.verdict in HOLDS for each in outcomes)
    if names.arm is not None or not (holds and defined):
        return False
    if not all(each.true is not None and isinstance(each.true.value, Scalar) for each in outcomes):
        return False  # matrices have laws of their own: J^+ = (J^T J)^{-1} J^T
    with names.state.unchanged() as before:
        names.state.become(DocumentState(notation=before.notation))
        return all(each.verdict in HOLDS for each in again())
