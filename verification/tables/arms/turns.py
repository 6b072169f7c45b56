"""Of which rows of a table a quantity tells how they turn: where a point is tells it of a row behind which something lies off the axis of the turn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.sides import Members

TURNS = -100  # beside the links that an equation tells of: less k, how the row of link k turns
_OFF_X, _OFF_Z = (1, 2), (0, 1)  # coordinates that a turn about x, and one about z, moves
_MOVES = ("jacobian", "velocity", "determinant", "manipulability")
_LINEAR = 3  # rows of a Jacobian that tell of places


def link_of(told: int) -> int:
    """Return the link of which something is told, its turn alone or more."""
    return TURNS - told if told < TURNS else told


def turns_told(quantity: Quantity, span: Iterable[int], members: Members) -> Iterator[int]:
    """Yield of which links in a span a quantity tells how their rows turn."""
    links, arm = [*span], members.names.arm
    if not links or arm is None:
        return
    convention = arm.dh.convention if arm.dh is not None else "classic"
    is_of_place = quantity.kind == "origin" or (quantity.kind in _MOVES and max(quantity.rows or (6,)) <= _LINEAR)
    for link in links:
        if is_of_place:
            told = _moves_what_is_beyond(link, max(links), convention, members)
        else:  # the axes of a geometric Jacobian are those before each joint, of which the last row turns none
            told = quantity.kind not in _MOVES or convention != "classic" or link != max(links)
        if told:
            yield TURNS - link


def _moves_what_is_beyond(link: int, last: int, convention: str, members: Members) -> bool:
    """Whether both turns of a row, about x and about z, move the origin of the last frame."""
    frames = members.names.arm.frames  # type: ignore[union-attr]
    before, behind = (
        [not cell.is_zero() for cell in members.exact.quantity(Quantity("origin", frames[last], frames[k])).cells]  # type: ignore[union-attr]
        for k in (link - 1, link)
    )
    about_x, about_z = (behind, before) if convention == "classic" else (before, behind)
    return any(about_x[k] for k in _OFF_X) and any(about_z[k] for k in _OFF_Z)
