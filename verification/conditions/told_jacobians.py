"""Laws of any Jacobian where the text tells the size of J, or that J maps otherwise than usual."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from armproof.verification.document import Display
from armproof.verification.document.told_jacobians import MAPS_BACK, OF_MAPS, SIZE, SQUARE, WIDE
from armproof.verification.document.told_statics import FORCE_ELSEWHERE
from armproof.verification.equations.any_jacobian import holds_of_size, is_of_motion_or_load
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

_FORCES = ("F", "f", "W", "w", "h", "H")
_OF_LAWS = (Kind.OF_ANY_JACOBIAN, Kind.SLIP_OF_ANY_JACOBIAN)


def unless_of_told_jacobian(outcome: Outcome, display: Display, names: Names) -> Outcome:
    """Leave open a law that has no value or does not hold for the size that is told, and one of what J maps where it maps otherwise."""
    if FORCE_ELSEWHERE in display.meant and any(map(_is_of_torques, _chains(display, names))):
        return outcome.left_open(say(Kind.MEANT_OTHERWISE, name="F"))
    if not outcome.tells(*_OF_LAWS):
        is_printed = any(name.base == "J" for node in outcome.nodes for name in n.names(node))
        is_otherwise = MAPS_BACK in display.meant and is_printed
        return outcome.left_open(say(Kind.MEANT_OTHERWISE, name="J")) if is_otherwise else outcome
    told = next((each for each in reversed(display.meant) if each.startswith(SIZE)), SQUARE)
    chains = [*_chains(display, names)]
    may_not_hold = told != SQUARE and not all(holds_of_size(each, names, told == WIDE) for each in chains)
    is_otherwise = not {*OF_MAPS}.isdisjoint(display.meant) and any(
        is_of_motion_or_load(each, names) for each in chains
    )
    return outcome.left_open(say(Kind.MEANT_OTHERWISE, name="J")) if may_not_hold or is_otherwise else outcome


def _chains(display: Display, names: Names) -> Iterator[n.Chain]:
    """Yield the equations of a display in which a Jacobian or torques stand: a law keeps none of its sides."""
    with suppress(ReadError, RecursionError):
        for each in names.reader.read(display.latex):
            if isinstance(each, n.Chain) and any(name.base in ("J", "tau") for name in n.names(each)):
                yield each


def _is_of_torques(chain: n.Chain) -> bool:
    """Whether torques and a force stand in an equation."""
    bases = {name.base for name in n.names(chain)}
    return "tau" in bases and not bases.isdisjoint(_FORCES)
