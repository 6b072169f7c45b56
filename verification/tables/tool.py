"""Where the last frame of a DH table stands on the arm: the product of the printed link matrices against its frames."""

from __future__ import annotations

from dataclasses import dataclass

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.tables.frames import last_frames
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.row import equal


@dataclass(frozen=True)
class Tool:
    """Where a table's last frame stands: `turn` is the constant rotation to the arm's `frame`."""

    frame: str
    origin: str
    turn: Matrix


def same_tool(found: TableReading) -> str | None:
    """Return the arm's last frame whose pose the product of the printed link matrices is, or None."""
    if (product := found.product) is None:
        return None
    return next((frame for frame in last_frames(found.arm) if equal(product, _pose(found, frame))), None)


def turned_tool(found: TableReading) -> Tool | None:
    """Return how the table's last frame stands in the arm's: still, with its origin at that of one of the arm's frames."""
    if (product := found.product) is None:
        return None
    last, *extra = last_frames(found.arm)
    at = product.block(range(3), [3])
    origins = (*extra, *reversed(numbered_frames(found.arm)))
    origin = next((frame for frame in origins if equal(at, _pose(found, frame).block(range(3), [3]))), None)
    if origin is None:
        return None
    for frame in sorted([last, *extra], key=lambda one: one != origin):
        turn = product.block(range(3), range(3)).transpose @ _pose(found, frame).block(range(3), range(3))
        if all(cell.as_fraction() is not None for cell in turn.cells):
            return Tool(frame, origin, turn)
    return None


def _pose(found: TableReading, frame: str) -> Matrix:
    return found.claim.pose(frame, numbered_frames(found.arm)[0])
