"""Parts of the geometric Jacobian that a document names by their place: J_1 a column, J_{12} an entry, J its printed rows."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import ANGULAR, LINEAR, numbered_frames

_PART = re.compile(r"(?P<part>[A-Za-z]*?)_?,?(?P<digits>\d|\d,?\d)")


def part_of_jacobian(name: n.Name, value: Value, names: Names) -> Quantity | None:
    """Return what an unbound J_k, J_{vk}, J_{ωk} or J_{ik} stands for, told by the size of what it is equated to.

    J_k is the k-th column where a 6×1 or shorter column stands on the other side, J_{ik} an entry where a scalar does
    (of the rows in which the document has shown J); a name with any other value is the document's own.
    """
    found = _PART.fullmatch(name.sub)
    arm = names.arm
    if arm is None or name.base != "J" or found is None or name.sup or name.pre_sub or name.primes or name.dots:
        return None
    part, digits = found.group("part"), found.group("digits").replace(",", "")
    whole = _whole(names, name.pre_sup)
    if whole is None or (part and part not in (*LINEAR, *ANGULAR)):
        return None
    column = int(digits[-1])
    count = len(whole.columns or arm.joints)
    if not 1 <= column <= count:
        return None
    columns = (whole.columns[column - 1],) if whole.columns else (column,)
    if len(digits) == 1 and isinstance(value, Matrix) and value.shape[1] == 1:
        if part and value.shape[0] == 3:
            return replace(whole, rows=(1, 2, 3) if part in LINEAR else (4, 5, 6), columns=columns)
        return replace(whole, columns=columns) if not part and value.shape[0] in (2, 3, 4, 6) else None  # 4: [z; 0]
    if len(digits) == 2 and not part and not isinstance(value, Matrix | list):
        rows = whole.rows or names.state.shown.get("J") or (1, 2, 3, 4, 5, 6)
        row = int(digits[0])
        return replace(whole, rows=(rows[row - 1],), columns=columns, scalar=True) if 1 <= row <= len(rows) else None
    return None


def jacobian_rows(value: Value, printed: tuple[int, ...] | None) -> Iterator[tuple[int, ...]]:
    """Yield the rows (from 1) that a shorter Jacobian is likely to hold: as printed before, v, the plane's, all that move."""
    if not isinstance(value, Matrix):
        return
    moving = tuple(i for i, row in enumerate(value.rows, 1) if not all(cell.is_zero() for cell in row))
    yield from dict.fromkeys(rows for rows in (printed, (1, 2, 3), (1, 2), moving, (4, 5, 6)) if rows)


def _whole(names: Names, reference: str) -> Quantity | None:
    """The Jacobian of which the parts are: the one the front matter binds, else that of the last frame."""
    for key in ("J", "J(q)", "J(theta)"):
        if not reference and key in names.quantities:
            quantity = names.quantities[key]
            return quantity if quantity.kind == "jacobian" else None
    assert names.arm is not None
    if reference and reference not in names.arm.frames:
        return None
    frames = numbered_frames(names.arm)
    return Quantity("jacobian", frames[-1], reference or frames[0])


def jacobian_name(node: n.Node, names: Names, parts: bool = False) -> n.Name | None:
    """Return the name of a Jacobian that notation implies (the front matter lists no rows for it), or None.

    It is that of all six rows, or with `parts` that of some, J_v.
    """
    node = n.ungrouped(node)
    if isinstance(node, n.Call) and node.function == "name" and isinstance(node.arguments[0], n.Name):
        node = node.arguments[0]
    if not isinstance(node, n.Name) or node.base != "J" or node.key in names.quantities:
        return None
    quantity = names.quantity(replace(node, dots=0))
    return node if quantity is not None and quantity.kind == "jacobian" and (parts or quantity.rows is None) else None
