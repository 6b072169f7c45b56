"""Equations that hold whatever their names are: sin θ = ±√(1 − cos² θ) tells nothing of what was said of θ before."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import HOLDS

Check = Callable[[], list[Outcome]]


def rests_on_nothing(names: Names, chain: n.Chain, outcomes: Sequence[Outcome], again: Check) -> bool:
    """Return whether a chain of names that displays define holds without these definitions, in a document without an arm.

    There a definition counts by what rests on it alone, and such a chain would let a mistaken one pass.
    """
    written = {below.key for member in chain.members for below in n.names(member)}
    defined = written & names.state.definitions.keys()
    holds = bool(outcomes) and all(each.verdict in HOLDS for each in outcomes)
    if names.arm is not None or not (holds and defined):
        return False
    with names.state.unchanged():
        for key in defined:
            del names.state.definitions[key]
        return all(each.verdict in HOLDS for each in again())
