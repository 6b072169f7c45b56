"""Of which rows of a table a quantity tells, and of which how they turn.

It tells of lengths that stand in it: how the tool moves tells nothing of the height of the base. Where a point is tells how a row turns behind which
something lies off the axis of the turn.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members

TURNS = -100  # beside the links that an equation tells of: less k, how the row of link k turns
_OFF_X, _OFF_Z = (1, 2), (0, 1)  # coordinates that a turn about x, and one about z, moves
_MOVES = ("jacobian", "velocity", "determinant", "manipulability")
_VECTORS = ("origin", "axis", "jacobian", "velocity")
_LINEAR = 3  # rows of a Jacobian that tell of places


def link_of(told: int) -> int:
    """Return the link of which something is told, its turn alone or more."""
    return TURNS - told if told < TURNS else told


def rows_told(quantity: Quantity, span: Iterable[int], members: Members) -> Iterator[int]:
    """Yield the links in a span of whose rows a quantity tells, and as TURNS - k those of which it tells how they turn."""
    links, arm = [*span], members.names.arm
    if not links or arm is None:
        return
    shown = _lengths_in(quantity, members)
    for link in links:
        pose = Quantity("pose", arm.frames[link], arm.frames[link - 1])
        if _lengths_in(pose, members) <= shown:
            yield link
    yield from _turns_told(quantity, links, members)


def lengths_alike(pair: Pair, links: Iterable[int], members: Members) -> frozenset[int]:
    """Return those of some links whose lengths stand in both sides of a pair alike: another length in their rows would not make it right."""
    arm = members.names.arm
    apart = [a - b for _, a, b in pair.entries() if isinstance(a, Scalar) and isinstance(b, Scalar)]
    if arm is None or not apart:
        return frozenset()
    found, ends = symbols_in([each.normal() for each in apart]), [*pairwise(arm.frames)]
    own = {k: _lengths_in(Quantity("pose", *ends[k - 1][::-1]), members) for k in links if 0 < k <= len(ends)}
    return frozenset(k for k, lengths in own.items() if lengths and lengths.isdisjoint(found))


def links_of_one_entry(outcome: Outcome, quantity: Quantity | None, members: Members) -> frozenset[int]:
    """Return the links of which another row may be why one entry alone of a vector, or of its columns, is wrong; 0 where nobody can tell.

    What a row changes beyond it turns with the frame before it, and stays in one coordinate only where that is the same for all joint values.
    """
    arm = members.names.arm
    if arm is None or quantity is None or quantity.kind not in _VECTORS or quantity.scalar or len(outcome.wrong) != 1:
        return frozenset({0})
    row = [*(quantity.rows or range(1, 7))][min(outcome.wrong[0][0], len(quantity.rows or range(6)) - 1)]
    joints, last = {*members.names.joints}, arm.frames.index(quantity.frame)
    if quantity.reference != arm.frames[0]:
        return frozenset({0})
    before = {k: Quantity("rotation", arm.frames[k - 1], arm.frames[0]) for k in range(1, last + 1)}
    rows = {k: as_matrix(members.exact.quantity(each)).rows[(row - 1) % _LINEAR] for k, each in before.items()}
    cells = {k: [cell for cell in each if isinstance(cell, Scalar)] for k, each in rows.items()}
    return frozenset(k for k, each in cells.items() if joints.isdisjoint(symbols_in(each)))


def _lengths_in(quantity: Quantity, members: Members) -> set[str]:
    """Return the lengths of the arm that stand in the value of a quantity."""
    value = members.exact.quantity(quantity)
    cells = [cell.normal() for cell in as_matrix(value).cells if isinstance(cell, Scalar)]
    return symbols_in(cells) & {*members.names.lengths}


def _turns_told(quantity: Quantity, links: Sequence[int], members: Members) -> Iterator[int]:
    """Yield of which links in a span a quantity tells how their rows turn."""
    arm = members.names.arm
    assert arm is not None
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
