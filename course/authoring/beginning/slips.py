"""Slips of the pen in a right answer: what students' mistakes look like."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator

from armproof.models.arm import Arm
from armproof.verification.diagnosis.slips import Edit, Letters, single_edits
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.writer import Notation, Writer, symbol_as_latex

EDITS = 60  # of a cell that are looked at


def slips(latex: str, arm: Arm) -> Iterator[str]:
    """Yield a formula with one small mistake in it, each time of another kind and at another entry; none twice."""
    root = Reader().read_expression(latex)
    writer = Writer(latex, root, Notation(style="index", cosine="C"))
    cells = [cell for cell in _cells(root) if any(isinstance(below, n.Name | n.JointAngles) for below in n.walk(cell))]
    letters = _letters(arm)
    by_kind: dict[str, list[tuple[n.Node, Edit]]] = defaultdict(list)
    for edits in _side_by_side([list(_edits(cell, letters)) for cell in cells]):
        for cell, edit in edits:
            if edit.kind != "number":  # another number is no slip of the pen
                by_kind[edit.kind].append((cell, edit))
    seen: set[str] = {latex}
    for turn in range(max(map(len, by_kind.values()), default=0)):
        for of_kind in by_kind.values():
            if turn < len(of_kind):
                cell, edit = of_kind[turn]
                changed = writer.write(n.substitute(root, cell, edit.node))
                if changed not in seen:
                    seen.add(changed)
                    yield changed


def _cells(root: n.Node) -> Iterator[n.Node]:
    plain = n.ungrouped(root)
    yield from plain.cells if isinstance(plain, n.Matrix) else (plain,)


def _edits(cell: n.Node, letters: Letters) -> Iterator[tuple[n.Node, Edit]]:
    for _, edit in zip(range(EDITS), single_edits(cell, letters), strict=False):
        yield cell, edit


def _side_by_side(lists: list[list[tuple[n.Node, Edit]]]) -> Iterator[list[tuple[n.Node, Edit]]]:
    """Yield the first edit of each cell, then the second of each, and so on."""
    for index in range(max(map(len, lists), default=0)):
        yield [edits[index] for edits in lists if index < len(edits)]


def _letters(arm: Arm) -> Letters:
    """Return what a slip may confuse: indices of joints, angles, lengths."""
    revolute = [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
    slides = [joint.symbol for joint in arm.joints if joint.kind == "prismatic"]
    indices = [int(found.group(1)) for symbol in revolute if (found := re.fullmatch(r"theta_(\d)", symbol))]
    return Letters(tuple(indices), _names(revolute), _names([*arm.lengths, *slides]))


def _names(symbols: list[str]) -> tuple[n.Name, ...]:
    nodes = (Reader().read_expression(symbol_as_latex(symbol)) for symbol in symbols)
    return tuple(node for node in nodes if isinstance(node, n.Name))
