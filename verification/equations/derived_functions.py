r"""The functions that a Jacobian differentiates, ∂f_x/∂θ_1: f_x is how the coordinate x depends on the joints, and no force there."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.names import Names


def with_coordinates_derived(chain: n.Chain, names: Names) -> n.Chain:
    """Return a chain with x for each open f_x of which it takes derivatives alone."""
    below = [each for member in chain.members for each in n.walk(member)]
    derived = [n.plain_name(each.operand) for each in below if isinstance(each, n.Derivative)]
    found = {id(each): each for each in derived if each is not None and _is_function(each, names)}
    keys = {each.key for each in found.values()}
    if any(isinstance(each, n.Name) and each.key in keys and id(each) not in found for each in below):
        return chain
    coordinates: dict[int, n.Node] = {key: replace(each, base=each.sub, sub="") for key, each in found.items()}
    return replace(chain, members=tuple(n.substitute_each(member, coordinates) for member in chain.members))


def _is_function(name: n.Name, names: Names) -> bool:
    return name == n.Name("f", name.sub) and name.sub in tuple(AXES) and names.is_open(name)
