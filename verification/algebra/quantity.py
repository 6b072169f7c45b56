"""A quantity of an arm, as data: which matrix of which frames, and which of its rows and columns."""

from __future__ import annotations

from dataclasses import dataclass

COMPONENTS = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True)
class Quantity:
    """A matrix of an arm: `kind` (quantity_kinds.py) of `frame` in `reference`, then the rows and columns that are meant (from 1).

    Attributes:
        frame: of which it is; of a joint its symbol, of a link matrix the convention.
        reference: the frame in which it is expressed.
        along: which axis of the frame an axis is.
        start: the frame from which a difference leads, or from which the velocity of a solid is seen.
        point: the frame whose origin a velocity of a solid is of; "" for that of the solid.
        scalar: whether one entry is meant.
        homogeneous: whether a column has a fourth row.
    """

    kind: str
    frame: str
    reference: str = "0"
    rows: tuple[int, ...] | None = None
    columns: tuple[int, ...] | None = None
    along: str = "z"
    start: str = "0"
    scalar: bool = False
    homogeneous: bool = False
    point: str = ""
