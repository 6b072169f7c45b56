"""The J_i beside the rates of joints, or in a row, one a joint: they are the columns of the Jacobian."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.readings import column_of_jacobian
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names


def columns_beside_rates(names: Names, nodes: Iterable[n.Node]) -> set[str]:
    r"""Take the J_i of J_1 \dot q_1 + … + J_n \dot q_n for the columns of J, and return their names.

    Where not every joint has its term, q_1 may be several joints, and J_1 a block.
    """
    products = (each for node in nodes for each in n.walk(node) if isinstance(each, n.Product))
    columns = {name.key: found for each in products for name, found in _column_beside_rate(names, each)}
    columns |= {name.key: found for node in nodes for name, found in _columns_in_a_row(names, node)}
    if len({found.columns for found in columns.values()}) < len(names.joints):
        columns = {}
    columns |= {name.key: found for node in nodes for name, found in _columns_by_name(names, node)}
    for key, found in columns.items():
        names.state.infer_usual(key, found)
    return set(columns)


def _columns_by_name(names: Names, node: n.Node) -> Iterator[tuple[n.Name, Quantity]]:
    """Yield the open J_i in a tree that the document says to be columns of J, with the columns that they are."""
    said = names.reader.spelling.columns
    for name in (each for each in n.names(node) if said and each.key in said and names.is_open(each)):
        if (found := column_of_jacobian(name, names)) is not None:
            yield name, found


def _columns_in_a_row(names: Names, node: n.Node) -> Iterator[tuple[n.Name, Quantity]]:
    r"""Yield the open J_i of [J_1 \dots J_n], one a joint, with the columns that they are."""
    for below in n.walk(node):
        cells = below.rows[0] if isinstance(below, n.Matrix) and len(below.rows) == 1 else ()
        written = [name for name in map(n.plain_name, cells) if name is not None and name.base == "J"]
        own = [(name, column_of_jacobian(name, names)) for name in written if names.is_open(name)]
        if len(own) == len(cells) == len(names.joints):
            yield from ((name, column) for name, column in own if column is not None)


def _column_beside_rate(names: Names, product: n.Product) -> Iterator[tuple[n.Name, Quantity]]:
    """Yield the open J_i that stands beside the rate of joint i, and no other, with the column that it is."""
    factors = [n.unapplied(bare(factor)) for factor in product.factors]
    written = [factor for factor in factors if isinstance(factor, n.Name)]
    rates = {names.known_symbol(each.undotted.key) for each in written if each.dots == 1}
    for name in (each for each in written if each.base == "J" and names.is_open(each)):
        found = column_of_jacobian(name, names)
        if found is not None and rates == {_joint_of(names, found)}:
            yield name, found


def _joint_of(names: Names, column: Quantity) -> str:
    assert names.arm is not None and column.columns is not None
    return names.arm.joints[column.columns[0] - 1].symbol
