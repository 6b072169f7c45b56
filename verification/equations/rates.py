r"""Which rows of a Jacobian a column of rates tells: \dot x and \dot y are the first two, \dot\phi or \omega of a planar arm the last."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.evaluation.blocks import Block, cells_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import ANGULAR_VELOCITIES, LINEAR_VELOCITIES, conventional
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames

WHOLE = (1, 2, 3, 4, 5, 6)


def rows_told(chain: n.Chain, names: Names) -> tuple[int, ...] | None:
    """Return the rows that the columns of rates in a chain tell, in the order of a Jacobian; None without any or with several."""
    columns = [cells_of(below) for member in chain.members for below in n.walk(member) if isinstance(below, n.Matrix)]
    told = {rows for cells in columns if (rows := _rows_of(cells, names))}
    rows = told.pop() if len(told) == 1 else ()
    return rows if rows and rows == tuple(sorted(set(rows))) else None


def stand_for_scalars(blocks: Sequence[Block], names: Names) -> bool:
    """Whether components stand where blocks of several rows do: [ẋ; ẏ] is not [v; ω]."""
    cells = [block.cell for block in blocks]
    return any(block.is_larger for block in blocks) and len(cells) > 1 and all(row_of(each, names) for each in cells)


def _rows_of(cells: Sequence[n.Node], names: Names) -> tuple[int, ...]:
    if len(cells) == 2 and _is_velocity(cells[0], LINEAR_VELOCITIES) and _is_velocity(cells[1], ANGULAR_VELOCITIES):
        return WHOLE
    rows = [row_of(cell, names) for cell in cells]
    return () if None in rows else tuple(row for row in rows if row is not None)


def _is_velocity(node: n.Node, letters: frozenset[str]) -> bool:
    """Whether a node is a whole v, ω, v_2 or ω_n, and no component."""
    name = bare(node)
    return isinstance(name, n.Name) and name.base in letters and not name.dots and name.sub[-1:] not in tuple("xyz")


def row_of(node: n.Node, names: Names) -> int | None:
    """Return the row of J whose product with the rates a name is, by the front matter or by convention."""
    name = bare(node)
    if names.arm is None or not isinstance(name, n.Name) or names.known_symbol(replace(name, dots=0).key) is not None:
        return None
    plain = replace(name, dots=0)
    if plain.key in names.state.definitions:
        return None
    bound = names.quantities.get(plain.key)
    candidates = (bound,) if bound is not None else conventional(plain, names.arm, names.transforms)
    found = next((each for each in candidates if each.scalar and _is_of_tool(each, names)), None)
    if found is None or (found.kind != "velocity") != (name.dots > 0):
        return None
    return (
        6 if found.kind == "angle" else found.rows[0] if found.rows and found.kind in ("origin", "velocity") else None
    )


def _is_of_tool(quantity: Quantity, names: Names) -> bool:
    arm = names.arm
    assert arm is not None
    return quantity.frame in (arm.frames[-1], numbered_frames(arm)[-1]) and quantity.reference == arm.frames[0]
