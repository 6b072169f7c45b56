"""Where the last frame of a DH table stands on the arm: the product of the printed link matrices against its frames."""

from __future__ import annotations

from dataclasses import dataclass

from verification.matrix import Matrix
from verification.quantities import numbered_frames
from verification.tables.reading import TableReading


@dataclass(frozen=True)
class Tool:
    """Where a table's last frame stands: `turn` is the constant rotation to the arm's `frame`."""

    frame: str
    origin: str
    turn: Matrix


def same_tool(found: TableReading) -> str | None:
    """Return the arm's last frame whose pose the product of the printed link matrices is, or None."""
    frames = numbered_frames(found.arm)
    for frame in [frames[-1], *(other for other in found.arm.frames if other not in frames)]:
        if found.product is not None and equal(found.product, found.claim.pose(frame, frames[0])):
            return frame
    return None


def turned_tool(found: TableReading) -> Tool | None:
    """Return how the table's last frame stands in the arm's: still, with its origin at that of one of the arm's frames."""
    frames = numbered_frames(found.arm)
    if (product := found.product) is None:
        return None
    extra = [frame for frame in found.arm.frames if frame not in frames]
    origins = [*extra, *reversed(frames)]
    origin = next(
        (
            f
            for f in origins
            if equal(product.block(range(3), [3]), found.claim.pose(f, frames[0]).block(range(3), [3]))
        ),
        None,
    )
    for frame in sorted([frames[-1], *extra], key=lambda one: one != origin) if origin is not None else []:
        rotation = found.claim.pose(frame, frames[0]).block(range(3), range(3))
        turn = product.block(range(3), range(3)).transpose @ rotation
        if origin is not None and all(cell.as_fraction() is not None for row in turn.rows for cell in row):
            return Tool(frame, origin, turn)
    return None


def equal(one: Matrix, other: Matrix) -> bool:
    """Decide whether two matrices of one shape are equal."""
    cells = ((x, y) for a, b in zip(one.rows, other.rows, strict=True) for x, y in zip(a, b, strict=True))
    return all((x - y).is_zero() for x, y in cells)
