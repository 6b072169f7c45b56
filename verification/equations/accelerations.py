r"""Accelerations of points of solids: \Gamma_{B,2/0} is the rate of V_{B,2/0} where B moves with solid 2."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Algebra
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

LETTERS = frozenset(["Gamma", "a"])


def with_accelerations(chain: n.Chain, names: Names, exact: Algebra) -> n.Chain:
    """Return a chain with accelerations as rates of velocities seen from the base."""
    found: dict[int, n.Node] = {}
    for each in {id(name): name for member in chain.members for name in n.names(member)}.values():
        velocity = replace(each, base="V")
        if each.base in LETTERS and "/" in each.sub and _moves_with_it(names.quantity(velocity), names.base, exact):
            time = n.Name("t", text="t", span=each.span)
            found[id(each)] = n.Derivative(velocity, time, 1, span=each.span)
    if not found:
        return chain
    return replace(chain, members=tuple(n.substitute_each(member, found) for member in chain.members))


def _moves_with_it(velocity: Quantity | None, base: str, exact: Algebra) -> bool:
    """Whether a velocity of a solid is that of the point itself, seen from the base: a point of another solid has another path."""
    if velocity is None or velocity.kind != "solid_velocity" or velocity.start != base:
        return False
    own = exact.quantity(Quantity("velocity", velocity.point or velocity.frame, base, rows=(1, 2, 3)))
    whole = exact.quantity(velocity)
    if not (isinstance(own, Matrix) and isinstance(whole, Matrix) and own.shape == whole.shape):
        return False
    return all((one - other).is_zero() for one, other in zip(own.cells, whole.cells, strict=True))
