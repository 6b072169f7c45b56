"""x beside y is a coordinate, though an equation before has shown x to be a vector: $\\dot{\\mathbf x} = J \\dot q$ and $x^2 + y^2$."""

from __future__ import annotations

from collections.abc import Iterable

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.names import Names

VECTORS = ("origin", "task")


def coordinates_among(names: Names, nodes: Iterable[n.Node], *, beside: bool) -> dict[str, Quantity]:
    """Return the names among trees that convention binds as vectors and that may be coordinates, each with that one.

    With `beside`, only those beside which another coordinate stands.
    """
    found = {
        plain.key: plain
        for node in nodes
        for below in n.names(node)
        if below.base in AXES and (plain := below.undotted).key
    }
    if beside and len({name.base for name in found.values()}) < 2:
        return {}
    whole = {key: name for key, name in found.items() if _is_vector(names, key)}
    read = ((key, _coordinate(names, name)) for key, name in whole.items())
    return {key: quantity for key, quantity in read if quantity is not None}


def _is_vector(names: Names, key: str) -> bool:
    quantity = names.state.inferred.get(key) if key in names.state.conventional else None
    return quantity is not None and quantity.kind in VECTORS and not quantity.scalar


def _coordinate(names: Names, name: n.Name) -> Quantity | None:
    return next((each for each in names.usual(name) if each.kind == "origin" and each.scalar), None)
