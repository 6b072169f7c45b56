"""Marks in a formula: which parts are wrong, and which were corrected; by outline, sign and label, never by colour alone."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from armproof.models.language import look_up, noted
from armproof.verification.latex import nodes as n
from armproof.verification.latex.mathml.box import Box


@dataclass(frozen=True, slots=True)
class Mark:
    """How a part is marked: the class of its outline, its sign, and what a screen reader says."""

    kind: str
    sign: str
    label: str

    @property
    def attributes(self) -> str:
        """The attributes of a marked element."""
        return f' class="{self.kind}" aria-label="{look_up(self.label)}"'

    def inside(self, part: Box) -> Box:
        """Return a part with its sign, for an element that carries the attributes."""
        return Box(f'{part.markup}<mtext class="sign">{self.sign}</mtext>', part.width + 1.2)

    def around(self, part: Box) -> Box:
        """Return a part with its outline and sign."""
        inner = self.inside(part)
        return Box(f"<mrow{self.attributes}>{inner.markup}</mrow>", inner.width + 0.5)


_SLACK = 2  # characters by which a node's place may differ from a span: a blank, a brace

WRONG = Mark("wrong", "✗", noted("wrong entry"))
RIGHT = Mark("right", "✓", noted("corrected entry"))


def find_marks(statements: Sequence[n.Statement], spans: Iterable[tuple[int, int]], mark: Mark) -> Mapping[int, Mark]:
    """Return the marks of spans by the identity of their nodes.

    A span's node is the outermost whose place it is; where it is that of several, such as the cells of a new row, each of
    them; where it is that of none, such as a label's, the one around it.
    """
    nodes = [node for statement in statements for node in n.walk(statement) if node.span[1] > node.span[0]]
    marks: dict[int, Mark] = {}
    for span in spans:
        marks.update((id(node), mark) for node in _nodes_at(nodes, span))
    return marks


def _nodes_at(nodes: Sequence[n.Node], span: tuple[int, int]) -> list[n.Node]:
    start, end = span
    touching = [node for node in nodes if node.span[0] < max(end, start + 1) and node.span[1] > start]
    if not touching:
        return []
    nearest = min(touching, key=lambda node: _distance(node, span))  # the first, and so the outermost, of equals
    if _distance(nearest, span) <= _SLACK:
        return [nearest]
    inside = [node for node in touching if start <= node.span[0] and node.span[1] <= end]
    below = {id(child) for node in inside for child in n.walk(node) if child is not node}
    return [node for node in inside if id(node) not in below] or [nearest]


def _distance(node: n.Node, span: tuple[int, int]) -> int:
    return abs(node.span[0] - span[0]) + abs(node.span[1] - span[1])
