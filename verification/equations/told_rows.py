r"""The rows of J of a task that the text tells: $(y, \varphi)$ are rows 2 and 6 of the arm's Jacobian."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.told_tasks import TASK, TASK_UNORDERED, coordinates_of
from armproof.verification.equations.rates import row_of
from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names

_USUAL = {(1, 2), (1, 2, 3), (1, 2, 6), (1, 2, 3, 4, 5, 6)}  # as J is read anyway


def rows_of_task(meant: Sequence[str], names: Names) -> tuple[int, ...] | None:
    """Return the rows of J of the last task that a text tells: none where it is not known which, None where it tells none but the usual ones."""
    told = [each for each in meant if each.startswith((f"{TASK} ", f"{TASK_UNORDERED} "))]
    if not told or names.arm is None:
        return None
    coordinates, is_ordered = coordinates_of(told[-1])
    read = [_name(each, names) for each in coordinates]
    if any(name is not None and names.known_symbol(name.key) is not None for name in read):
        return None  # of joints and lengths
    rows = [None if name is None else row_of(n.Name(name.base, dots=1), names) for name in read]
    if None in rows or len({*rows}) < len(rows):
        return ()
    found = tuple(row for row in rows if row is not None)
    if found in _USUAL or (found == tuple(sorted(found)) and max(found) <= len("xyz")):
        return None
    return found if is_ordered or found == tuple(sorted(found)) else ()


def _name(latex: str, names: Names) -> n.Name | None:
    try:
        node = bare(names.reader.read_expression(latex))
    except ReadError:
        return None
    return node if isinstance(node, n.Name) else None
