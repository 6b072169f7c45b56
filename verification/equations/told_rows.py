r"""The rows of J of a task that the text tells: $(y, \varphi)$ are rows 2 and 6 of the arm's Jacobian."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import COMPONENTS
from armproof.verification.document.told_tasks import TASK, TASK_UNORDERED, coordinates_of
from armproof.verification.equations.rates import row_of
from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names

_USUAL = {(1, 2, 6), (1, 2, 3, 4, 5, 6)}  # as J is read anyway
_ROWS = {each: row for row, each in enumerate(COMPONENTS, start=1)} | dict.fromkeys(("phi", "psi", "theta", "alpha"), 6)


def rows_of_task(meant: Sequence[str], names: Names) -> tuple[int, ...] | None:
    """Return the rows of J of the last task that a text tells: none where it is not known which, None where it tells none but the usual ones."""
    told = [each for each in meant if each.startswith((f"{TASK} ", f"{TASK_UNORDERED} "))]
    if not told or names.arm is None:
        return None
    coordinates, is_ordered = coordinates_of(told[-1])
    read = [_name(each, names) for each in coordinates]
    if any(name is not None and names.known_symbol(name.key) is not None for name in read):
        return None  # of joints and lengths
    if _are_usual([_row_by_letter(name) for name in read]):
        return None  # whatever the document says that x and y are
    rows = [None if name is None else _row(name, names) for name in read]
    if None in rows or len({*rows}) < len(rows):
        return ()
    if _are_usual(rows):
        return None
    found = tuple(row for row in rows if row is not None)
    return found if is_ordered or found == tuple(sorted(found)) else ()


def _row(name: n.Name, names: Names) -> int | None:
    """Return the row of J that gives the rate of a coordinate, or a component of ω."""
    if name.base == "omega":
        return row_of(name, names)
    own = row_of(replace(name, dots=1), names) if name.base in "pP" else None
    return own or row_of(n.Name(name.base, dots=1), names)


def _are_usual(rows: Sequence[int | None]) -> bool:
    """Whether rows are those in which J is read anyway: of x, y, z in their order, or of x, y and the angle in the plane."""
    found = tuple(row for row in rows if row is not None)
    is_of_point = found == tuple(sorted({*found})) and all(row <= len(COMPONENTS) for row in found)
    return bool(rows) and len(found) == len(rows) and (found in _USUAL or is_of_point)


def _row_by_letter(name: n.Name | None) -> int | None:
    if name is None:
        return None
    letter = name.sub.lower() if name.base in "pP" else name.base.lower()
    return _ROWS.get(letter)


def _name(latex: str, names: Names) -> n.Name | None:
    try:
        node = bare(names.reader.read_expression(latex))
    except ReadError:
        return None
    return node if isinstance(node, n.Name) else None
