r"""Which rows of a Jacobian a column of rates tells: \dot x and \dot y are the first two, \dot\phi or \omega of a planar arm the last."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.evaluation.blocks import Block, cells_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import ANGULAR_VELOCITIES, LINEAR_VELOCITIES
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames

WHOLE = (1, 2, 3, 4, 5, 6)
_VELOCITIES = LINEAR_VELOCITIES | ANGULAR_VELOCITIES
SPEAKS_OF_RATES = LINEAR_VELOCITIES | {
    "J"
}  # one of them stands in what is read with the rates of all joints, or from a frame


def rows_told(chain: n.Chain, names: Names) -> tuple[int, ...] | None:
    """Return the rows that the columns of rates in a chain tell, in the order of a Jacobian; None without any or with several."""
    columns = [cells_of(below) for member in chain.members for below in n.walk(member) if isinstance(below, n.Matrix)]
    told = {rows for cells in columns if (rows := _rows_of(cells, names))}
    rows = told.pop() if len(told) == 1 else ()
    return rows if rows and rows == tuple(sorted(set(rows))) else None


def with_joint_rates(chain: n.Chain, names: Names) -> n.Chain:
    r"""Return a chain about a Jacobian with \dot q for its \dot\theta, where no angle of that name is known: the rates of all joints."""
    below = [each for member in chain.members for each in n.names(member)]
    rates = [each for each in below if each.key in ("dot theta", "dotdot theta")]
    known = names.known_symbol("theta") or names.quantity(n.Name("theta")) or "theta" in names.state.definitions
    if not rates or known or not any(each.base == "J" for each in below):
        return chain
    plain: dict[int, n.Node] = {id(each): replace(each, base="q") for each in rates}
    return replace(chain, members=tuple(n.substitute_each(member, plain) for member in chain.members))


def seen_from_frame(chain: n.Chain) -> n.Chain:
    """Return a chain with the letters of a column beside {}^3v as they are seen from there: v_x is {}^3v_x, ω is {}^3ω."""
    named = [name for name in map(bare, chain.members) if isinstance(name, n.Name)]
    frames = {name.pre_sup for name in named if name.base in LINEAR_VELOCITIES and not (name.dots or name.sup)}
    if len(frames) != 1 or not all(frames):
        return chain
    (frame,) = frames
    return replace(chain, members=tuple(_placed_cells(member, frame) for member in chain.members))


def _placed_cells(node: n.Node, frame: str) -> n.Node:
    names = [cell for cell in map(bare, cells_of(node)) if isinstance(cell, n.Name)]
    if (
        not names
        or len(names) < len(cells_of(node))
        or not all(each.base in _VELOCITIES and not each.dots for each in names)
    ):
        return node
    placed: dict[int, n.Node] = {id(each): replace(each, pre_sup=frame) for each in names if not each.pre_sup}
    return n.substitute_each(node, placed)


def stand_for_scalars(blocks: Sequence[Block], names: Names) -> bool:
    """Whether components stand where blocks of several rows do: [ẋ; ẏ] is not [v; ω]."""
    cells = [block.cell for block in blocks]
    return any(block.is_larger for block in blocks) and len(cells) > 1 and all(row_of(each, names) for each in cells)


def _rows_of(cells: Sequence[n.Node], names: Names) -> tuple[int, ...]:
    if len(cells) == 2 and _is_velocity(cells[0], LINEAR_VELOCITIES) and _is_velocity(cells[1], ANGULAR_VELOCITIES):
        return WHOLE
    rows = [row_of(_unplaced(cell), names) for cell in cells]
    return () if None in rows else tuple(row for row in rows if row is not None)


def _unplaced(node: n.Node) -> n.Node:
    """Return {}^3v_x without the frame that it is seen from: it is in the first row of {}^3J."""
    name = bare(node)
    return replace(name, pre_sup="") if isinstance(name, n.Name) and name.base in _VELOCITIES else node


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
    candidates = (bound,) if bound is not None else names.usual(plain)
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
