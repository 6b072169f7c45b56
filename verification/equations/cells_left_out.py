r"""Rows and columns whose middle is left to the reader: [z_0 × (p_n - p_0) ⋯ z_{n-1} × (p_n - p_{n-1})], [\dot q_1; ⋮; \dot q_n].

What stands between the first cell and the last is written out where these differ in their indices alone, as joint 1 and
joint n of the arm do, and where each cell before the dots is what the first makes of its index; else the dots stay.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace

from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex

MOST_JOINTS = 8
_SCRIPTS = ("sub", "sup", "pre_sub", "pre_sup")
_FIRST = regex(r"(.*?)(\d+)")
_LAST = regex(r"(.*?)(\d+|[nN](?:-1)?)")


def with_cells(statement: n.Statement, names: Names) -> n.Statement:
    """Return a statement with the rows and columns of its matrices written out, one cell a joint."""
    count = len(names.arm.joints) if names.arm is not None else 0
    if not isinstance(statement, n.Chain) or not 1 < count <= MOST_JOINTS:
        return statement
    return replace(statement, members=tuple(_written(member, count) for member in statement.members))


def _written(node: n.Node, count: int) -> n.Node:
    node = n.substitute_each(node, {id(below): _written(below, count) for below in n.children(node)})
    if not isinstance(node, n.Matrix) or not any(isinstance(bare(cell), n.Dots) for cell in node.cells):
        return node
    if all(len(row) == 1 for row in node.rows):
        column = _whole([row[0] for row in node.rows], count)
        return replace(node, rows=tuple((cell,) for cell in column)) if column else node
    rows = [_whole(row, count) for row in node.rows]
    return replace(node, rows=tuple(map(tuple, rows))) if all(rows) else node


def _whole(cells: Sequence[n.Node], count: int) -> list[n.Node]:
    """Return the cells of all joints; nothing where they do not tell what the dots stand for."""
    at = [place for place, cell in enumerate(cells) if isinstance(bare(cell), n.Dots)]
    if len(at) != 1 or at[0] not in range(1, len(cells) - 1) or at[0] != len(cells) - 2 or len(cells) > count + 2:
        return []
    found = [_between(cells[0], cells[-1], number, count) for number in range(count)]
    shown = [*cells[: at[0]]]
    if None in found or len(shown) >= count or shown != found[: len(shown)]:
        return []
    return [each for each in found if each is not None]


def _form(value: object) -> object:
    """Return all that a tree says but the scripts of its names, and where it stands."""
    if isinstance(value, n.Name):
        return (value.base, value.dots, value.primes)
    if isinstance(value, n.Node):
        said = (getattr(value, each.name) for each in fields(value) if each.compare)
        return (type(value).__name__, *map(_form, said))
    return tuple(map(_form, value)) if isinstance(value, tuple) else value


def _between(first: n.Node, last: n.Node, number: int, count: int) -> n.Node | None:
    """Return the cell of a joint, counted from 0, between the first and the last one; None where these differ in more."""
    if _form(first) != _form(last):
        return None
    changed: dict[int, n.Node] = {}
    names = [[*n.names(tree)] for tree in (first, last)]
    for one, other in zip(*names, strict=True):
        scripts = {script: _script(getattr(one, script), getattr(other, script), number, count) for script in _SCRIPTS}
        if None in scripts.values():
            return None
        changed[id(one)] = replace(one, **scripts)  # type: ignore[arg-type]
    return n.substitute_each(first, changed)


def _script(first: str, last: str, number: int, count: int) -> str | None:
    """Return the script of a joint between those of the first and the last one, which are as far apart as these, or the same."""
    if first == last:
        return first
    one, other = _FIRST.fullmatch(first), _LAST.fullmatch(last)
    if one is None or other is None or one[1] != other[1]:
        return None
    end = {"n": count, "N": count, "n-1": count - 1, "N-1": count - 1}
    apart = end.get(other[2], int(other[2]) if other[2].isdigit() else -1) - int(one[2])
    return f"{one[1]}{int(one[2]) + number}" if apart == count - 1 else None
