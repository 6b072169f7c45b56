"""x beside y is a coordinate, though an equation before has shown x to be a vector: $\\dot{\\mathbf x} = J \\dot q$ and $x^2 + y^2$."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.names import Names

VECTORS = ("origin", "task")


def height_among(names: Names, members: Sequence[n.Node]) -> tuple[str, Quantity] | None:
    """Return the one z_i that stands alone in a chain of scalars, by notation the axis of a frame, whose x_i or y_i was shown to be a coordinate, with what it is then."""
    alone = [plain for each in members if (plain := n.plain_name(each)) is not None and plain.base in ("z", "Z")]
    if len(alone) != 1 or any(isinstance(below, n.Matrix) for each in members for below in n.walk(each)):
        return None
    (name,) = alone
    axis = names.quantity(name) if name.key not in names.quantities else None
    if axis is None or axis.kind != "axis":
        return None
    beside = ("x", "y") if name.base == "z" else ("X", "Y")
    shown = [names.state.inferred.get(replace(name, base=each).key) for each in beside]
    is_point = any(each is not None and each.kind == "origin" and each.frame == axis.frame for each in shown)
    height = _coordinate(names, name) if is_point else None
    return (name.key, height) if height is not None else None


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
