r"""What is written in a notation that the text says to be another than usual: atan2(x, y), \sin^{-1} for 1/sin, the torques of a force on the tool."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document import Display
from armproof.verification.document.told_notation import ABSCISSA_FIRST, REACTION, RECIPROCAL
from armproof.verification.equations.forces import TORQUES
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader

ATAN2 = "atan2"
_ARCS = ("asin", "acos", "atan")
_FORCES = frozenset("FfwWhH")


def written_as_told(outcome: Outcome, display: Display, reader: Reader) -> str | None:
    """Return what in an equation the text says to be something else than it is read as; None where nothing is."""
    meant = display.meant
    if not any(each.startswith((ABSCISSA_FIRST, RECIPROCAL, REACTION)) for each in meant):
        return None
    sides: Sequence[n.Node] = (*outcome.nodes, *outcome.conditions)
    if not sides:  # a law has none
        sides = [each for chain in reader.read(display.latex) if isinstance(chain, n.Chain) for each in chain.members]
    below = [each for node in sides for each in n.walk(node)]
    calls = [each for each in below if isinstance(each, n.Call)]
    if ABSCISSA_FIRST in meant and any(n.is_call(each, ATAN2) for each in calls):
        return ATAN2
    powers = (each.head for each in calls if each.function in _ARCS and "-1" in each.head.replace(" ", ""))
    if RECIPROCAL in meant and (head := next(powers, None)) is not None:
        return head
    told = [each.removeprefix(REACTION).strip() for each in meant if each.startswith(REACTION)]
    return _reaction_in(below, told) if told else None


def _reaction_in(below: Sequence[n.Node], told: Sequence[str]) -> str | None:
    """Return the name of torques, where no other force stands beside them than one on the tool: J^T F is what the tool exerts."""
    named = [each for each in below if isinstance(each, n.Name)]
    torques = next((each.key for each in named if each.base in TORQUES), None)
    forces = {each.base for each in named} & _FORCES
    is_of_other = bool(forces) and "" not in told and forces.isdisjoint(told)
    return None if is_of_other else torques
