"""Where a display can be changed: the cells of its printed matrices, and its formulas."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.diagnosis.slips import Letters
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.verdict import Verdict
from tests.mutation.place import Place

_WRITTEN: dict[Path, dict[str, n.Name]] = {}  # how each document writes the symbols of its arm


@dataclass(frozen=True)
class Site:
    """A cell of a matrix, or a whole formula: its tree and where it stands.

    statement, member: the number of its chain and of its side in the display; row, column: of the cell, from 1, None
    in a formula; matrix: the matrix it is a cell of; whole: whether that matrix is the side itself.
    """

    node: n.Node
    side: n.Node
    statement: int
    member: int
    row: int | None = None
    column: int | None = None
    matrix: n.Matrix | None = None
    whole: bool = True
    printed: bool = True


def find_sites(place: Place, statements: list[n.Statement]) -> list[Site]:
    """Return the sites of the equations of a display that are proved; conditions joined by ⇔ give their sides."""
    with place.altered():
        outcomes = place.outcomes(statements)
    proved = [outcome for outcome in outcomes if outcome.verdict is Verdict.PROVED]
    printed = {id(node) for outcome in proved for node in _nodes(outcome, printed=True)}
    true = {id(node) for outcome in proved for node in _nodes(outcome, printed=False)}
    without_sides = any(outcome.printed is None for outcome in proved)
    sites: list[Site] = []
    for s, statement in enumerate(statements):
        if not isinstance(statement, n.Chain) or any(relation != "=" for relation in statement.relations):
            continue
        for m, side in enumerate(statement.members):
            cases = {id(value) for value, _ in side.branches} if isinstance(side, n.Cases) else set()
            if without_sides or cases & printed or id(side) in printed | true:
                sites.extend(_sites_of(side, s, m, id(side) in printed))
    return sites


def are_conditions(statements: list[n.Statement]) -> bool:
    """Whether a display says where something holds, by ⇔, "if", or ⇒ before a rank: a sign or a factor is no other condition."""
    kinds = {statement.kind for statement in statements if isinstance(statement, n.Connective)}
    has_rank = any(n.is_rank(m) for s in statements if isinstance(s, n.Chain) for m in s.members)
    return not kinds.isdisjoint(("⇔", "if")) or (has_rank and "⇒" in kinds)


def _nodes(outcome: Outcome, printed: bool) -> Iterator[n.Node]:
    member = outcome.printed if printed else outcome.true
    if member is not None:
        yield member.node
        if isinstance(member.node, n.At):  # a case under its condition
            yield member.node.inner


def _sites_of(side: n.Node, statement: int, member: int, printed: bool) -> Iterator[Site]:
    plain = side
    while isinstance(plain, n.Group | n.Labelled):
        plain = plain.inner
    if isinstance(plain, n.Cases):
        yield from (Site(value, side, statement, member, printed=printed) for value, _ in plain.branches)
    if isinstance(plain, n.Name | n.Cases | n.Layout):
        return
    matrices = [below for below in n.walk(side) if isinstance(below, n.Matrix) and below.environment != "zeros"]
    nested = {id(below) for matrix in matrices for row in matrix.rows for cell in row for below in n.walk(cell)}
    for matrix in matrices:
        whole = matrix is plain and not any(id(other) in nested for other in matrices)
        for r, row in enumerate(matrix.rows, 1):
            for c, cell in enumerate(row, 1):
                if not any(isinstance(below, n.Matrix) for below in n.walk(cell)):
                    yield Site(cell, side, statement, member, r, c, matrix, whole, printed)
    if not isinstance(plain, n.Matrix):
        yield Site(plain, side, statement, member, None, None, None, True, printed)


def letters_of(place: Place) -> Letters:
    """Return what a slip may confuse, in the letters of the document: angles' indices, angles, lengths."""
    arm = place.checker.names.arm
    if arm is None:
        return _letters_of_display(place)
    path = place.document.path
    if path not in _WRITTEN:
        _WRITTEN[path] = _written_symbols(place)
    written = _WRITTEN[path]

    def names_of(symbols: list[str]) -> tuple[n.Name, ...]:
        return tuple(written[symbol] for symbol in symbols if symbol in written)

    revolute = [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
    slides = [joint.symbol for joint in arm.joints if joint.kind == "prismatic"]
    indices = tuple(k for k in range(1, 10) if place.checker.names.joint_angle(k) is not None)
    return Letters(indices, names_of(revolute), names_of([*arm.lengths, *slides]))


def _letters_of_display(place: Place) -> Letters:
    names = place.checker.names
    found: dict[str, n.Name] = {}
    indices: set[int] = set()
    for node in _all_nodes(place, place.display.latex):
        if (
            isinstance(node, n.Name)
            and names.is_free(node)
            and node.key not in names.state.definitions
            and not node.dots
            and node.text
        ):
            found.setdefault(node.key, node)
        elif isinstance(node, n.JointAngles):
            indices.update(index for _, index in node.terms)
    angles = tuple(name for name in found.values() if name.base in ("theta", "alpha", "phi", "psi", "beta"))
    return Letters(tuple(sorted(indices)), angles, tuple(name for name in found.values() if name not in angles))


def _written_symbols(place: Place) -> dict[str, n.Name]:
    """Return a name for each joint variable and length: as the document writes it first, else as the arm's card does."""
    names = place.checker.names
    arm = names.arm
    assert arm is not None
    written: dict[str, n.Name] = {}
    for display in place.document.displays:
        for node in _all_nodes(place, display.latex):
            if not isinstance(node, n.Name) or not node.text or node.dots or node.key in names.quantities:
                continue
            if (symbol := names.known_symbol(node.key)) is not None:
                written.setdefault(symbol, node)
    for symbol in (*(joint.symbol for joint in arm.joints), *arm.lengths):
        node = place.checker.names.reader.read_expression(symbol_as_latex(symbol))
        if symbol not in written and isinstance(node, n.Name):
            written[symbol] = node
    return written


def _all_nodes(place: Place, latex: str) -> Iterator[n.Node]:
    for statement in place.read(latex):
        if isinstance(statement, n.Chain):
            for member in statement.members:
                yield from n.walk(member)
