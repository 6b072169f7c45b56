r"""Axes without a frame beside one that says in which it is expressed: {}^1x_2 = c_2 x_1 + s_2 z_1 is of vectors, and all are seen from there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.names import Names


def with_axes_placed(chain: n.Chain, names: Names) -> n.Chain:
    """Return a chain with the axes that name no frame in the one frame in which its sides that are axes are expressed."""
    frames = {frame for member in chain.members if (frame := _frame_told(member, names)) is not None}
    if len(frames) != 1:
        return chain
    (frame,) = frames
    return replace(chain, members=tuple(_placed(member, frame, names) for member in chain.members))


def _frame_told(member: n.Node, names: Names) -> str | None:
    """Return the frame in which a side that is an axis is said to be expressed."""
    name = n.plain_name(member)
    if name is None or name.base not in AXES or not name.sub or not (name.pre_sup or name.sup) or name.dots:
        return None
    quantity = names.quantity(name)
    return quantity.reference if quantity is not None and quantity.kind == "axis" else None


def _placed(member: n.Node, frame: str, names: Names) -> n.Node:
    """Return a sum of axes, each with its factor, as they are expressed in a frame; a term without one makes them coordinates."""
    axes = [_axes_of(term, names) for term in _terms(member)]
    if not all(len(found) == 1 for found in axes):
        return member
    placed: dict[int, n.Node] = {
        id(name): replace(name, pre_sup=frame) for (name,) in axes if not (name.pre_sup or name.sup)
    }
    return n.substitute_each(member, placed)


def _terms(node: n.Node) -> Iterator[n.Node]:
    inner = bare(node)
    for term in [term for _, term in inner.terms] if isinstance(inner, n.Sum) else ():
        yield from _terms(term)
    if not isinstance(inner, n.Sum):
        yield inner


def _axes_of(term: n.Node, names: Names) -> list[n.Name]:
    """Return the names of a term that are axes of frames, and that neither the document nor its front matter gives a meaning of its own."""
    factors = [bare(factor) for factor in term.factors] if isinstance(term, n.Product) else [term]
    found = [
        factor for factor in factors if isinstance(factor, n.Name) and factor.base in AXES and factor.sub.isdigit()
    ]
    if not all(factor in found or _is_of_numbers(factor, names) for factor in factors):
        return []  # R_1 x_2 is seen from another frame than x_2
    return [each for each in found if not (each.dots or each.primes or _has_meaning(each, names))]


def _is_of_numbers(factor: n.Node, names: Names) -> bool:
    quantities = [names.quantity(name) for name in n.names(factor)]
    has_matrix = any(isinstance(below, n.Matrix) for below in n.walk(factor))
    return not has_matrix and all(each is None or each.scalar for each in quantities)


def _has_meaning(name: n.Name, names: Names) -> bool:
    state = names.state
    told = name.key in state.inferred and name.key not in state.conventional
    return told or name.key in names.quantities or name.key in state.definitions
