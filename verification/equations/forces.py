"""Forces and moments that a document introduces by their components, F = (F_x, F_y): any numbers, as lengths are."""

from __future__ import annotations

import re
from collections.abc import Sequence

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.equations.outcome import Outcome
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

_LETTERS = frozenset("FfM")  # N_x may be an entry of a rotation, m_x a mass
_COMPONENT = re.compile(r"\w*,?[xyz]")


def heed_forces(names: Names, chain: n.Chain) -> None:
    """Take the components of a column for free symbols, until an equation says what they are: F_x = 10."""
    columns = [_components(cells_of(member)) for member in chain.members]
    alone = [name for member, column in zip(chain.members, columns, strict=True) for name in column or _one(member)]
    introduced = all(column or isinstance(bare(m), n.Name) for m, column in zip(chain.members, columns, strict=True))
    if alone and not (introduced and any(columns)):
        names.state.adopted.difference_update(name.key for name in alone)
        return
    for below in (each for member in chain.members for each in n.walk(member)):
        names.state.adopted |= {name.key for name in _components(cells_of(below)) if names.is_open(name)}


def unless_left_out(outcome: Outcome, names: Names) -> Outcome:
    """Leave open what is refuted, and of which only one side holds a component: the other may hold its value."""
    if outcome.verdict is not Verdict.REFUTED or outcome.pair is None or not names.state.adopted:
        return outcome
    one, other = ({*filter(_is_key, symbols_in(side.cells))} for side in (outcome.pair.true, outcome.pair.printed))
    return outcome.left_open(say(Kind.FORCE_LEFT_OUT, names=sorted(one ^ other))) if one != other else outcome


def _is_key(key: str) -> bool:
    base, _, sub = key.partition("_")
    return base in _LETTERS and _COMPONENT.fullmatch(sub) is not None


def _components(cells: Sequence[n.Node]) -> list[n.Name]:
    """Return the components of a force or of a moment that a column holds, zeros beside them; none of another one."""
    found = [name for cell in cells for name in _one(cell)]
    zeros = sum(isinstance(zero := bare(cell), n.Number) and zero.value == 0 for cell in cells)
    return found if len(found) > 1 and len(found) + zeros == len(cells) else []


def _one(node: n.Node) -> list[n.Name]:
    """Return a component that stands alone, in a list."""
    name = bare(node)
    if not isinstance(name, n.Name) or name.dots or name.primes or name.sup or name.pre_sub or name.pre_sup:
        return []
    return [name] if _is_key(name.key) else []
