r"""The matrix by which every course says what a Jacobian is: the derivatives of the task, one coordinate a row, one joint a column.

It holds of any arm, however many of its rows and columns are left out: [∂f_1/∂q_1 ⋯ ∂f_1/∂q_n; ⋮ ⋱ ⋮; ∂f_m/∂q_1 ⋯ ∂f_m/∂q_n].
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names

_JOINTS, _TASK = ("q", "theta", "Theta", "phi"), ("x", "X", "p", "P", "r", "f", "h", "k", "F", "y")
_PLACES = "xyz"  # coordinates stand in this order, and before angles
_COUNTED = ("", "n", "N", "m", "M", "k")


def is_matrix_of_derivatives(chain: n.Chain, names: Names) -> bool:
    """Whether a chain says no more than that J holds the derivatives of the task's coordinates by the joints, in their order."""
    members = [*map(bare, chain.members)]
    if len(members) < 2 or set(chain.relations) != {"="} or not _is_jacobian(members[0]):
        return False
    *between, whole = members[1:]
    return isinstance(whole, n.Matrix) and _is_of_derivatives(whole, names) and all(map(_is_whole_derivative, between))


def _is_jacobian(node: n.Node) -> bool:
    name = bare(node.arguments[0]) if n.is_call(node, "name") else node
    return isinstance(name, n.Name) and name == n.Name("J", text=name.text, span=name.span)


def _is_whole_derivative(node: n.Node) -> bool:
    r"""Whether a member is ∂f/∂q, ∂f(q)/∂q or ∂x/∂q^T, of vectors."""
    if not isinstance(node, n.Derivative) or node.order != 1:
        return False
    of, by = bare(node.operand), bare(node.variable)
    of = bare(of.arguments[0]) if n.is_call(of, "name") else of
    by = bare(by.base) if isinstance(by, n.Postfix) and by.operator == "T" else by
    if not (isinstance(of, n.Name) and isinstance(by, n.Name)) or of.sub or of.dots or by.sub or by.dots:
        return False
    return of.base in _TASK and by.base in _JOINTS


def _is_of_derivatives(matrix: n.Matrix, names: Names) -> bool:
    """Whether each cell that is written is the derivative of the coordinate of its row by the joint of its column."""
    rows = [[bare(cell) for cell in row] for row in matrix.rows]
    rows = [row for row in rows if not all(isinstance(cell, n.Dots) for cell in row)]
    if len({len(row) for row in rows}) != 1 or len(rows) < 2:
        return False
    columns = [*zip(*rows, strict=True)]
    columns = [column for column in columns if not all(isinstance(cell, n.Dots) for cell in column)]
    cells = [cell for column in columns for cell in column]
    if len(columns) < 2 or not all(isinstance(cell, n.Derivative) and cell.order == 1 for cell in cells):
        return False
    tasks = [_one([cell.operand for cell in row if isinstance(cell, n.Derivative)]) for row in rows]
    joints = [_one([cell.variable for cell in column]) for column in columns]  # type: ignore[attr-defined]
    if None in tasks or None in joints:
        return False
    has_more = (len(rows) < len(matrix.rows), len(columns) < len(matrix.rows[0]))
    arm = names.arm
    is_whole = arm is None or has_more[1] or len(joints) == len(arm.joints)
    return is_whole and _are_joints(joints, has_more[1]) and _are_coordinates(tasks, has_more[0])  # type: ignore[arg-type]


def _one(nodes: Sequence[n.Node]) -> n.Name | None:
    """Return the name that all nodes are, without what it is a function of."""
    plain = [bare(each.arguments[0]) if n.is_call(each, "name") else each for each in map(bare, nodes)]
    found = {each.key: each for each in plain if isinstance(each, n.Name) and not (each.dots or each.primes)}
    return next(iter(found.values())) if len(found) == 1 and len(plain) == len(nodes) and all(isinstance(each, n.Name) for each in plain) else None  # fmt: skip


def _are_joints(joints: Sequence[n.Name], has_more: bool) -> bool:
    return {each.base for each in joints} <= {joints[0].base} and joints[0].base in _JOINTS and _count(joints, has_more)


def _are_coordinates(tasks: Sequence[n.Name], has_more: bool) -> bool:
    """Whether names are f_1, f_2, …, f_m, or x, y, z, φ with what they are coordinates of."""
    if {each.base for each in tasks} == {tasks[0].base} and tasks[0].base in _TASK and _count(tasks, has_more):
        return True
    axes = [_axis(each) for each in tasks]
    number = len([each for each in axes if each])
    if has_more or number < 2 or axes[:number] != [*_PLACES[:number]] or any(axes[number:]):
        return False
    ends = {each.sub if each.base in _PLACES else each.base for each in tasks[:number]}
    return len(ends) == 1 and len({each.key for each in tasks}) == len(tasks)


def _axis(name: n.Name) -> str:
    """Return the axis along which a name is a coordinate, "" where it is none: x, x_P, p_y."""
    if name.base in _PLACES:
        return name.base
    return name.sub if name.base in ("p", "P", "f", "r") and name.sub in _PLACES else ""


def _count(listed: Sequence[n.Name], has_more: bool) -> bool:
    """Whether the numbers of names go up from one, to a letter where some are left out."""
    subs = [each.sub for each in listed]
    *first, last = subs
    numbers = [*map(int, first)] if all(each.isdigit() for each in first) else []
    if not numbers or numbers[0] != 1 or any(b - a != 1 for a, b in pairwise(numbers)):
        return False
    return (last in _COUNTED[1:] if has_more else False) or (last.isdigit() and (int(last) > numbers[-1] if has_more else int(last) == numbers[-1] + 1))  # fmt: skip
