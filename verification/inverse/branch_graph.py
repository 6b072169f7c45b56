"""Graphs of formulas with roots and arc functions: models/bulk/graph.py with the operations that a closed-form inverse needs."""

from __future__ import annotations

from armproof.models.bulk.graph import ONE, ZERO, Graph, Node, Term

MAX_MULTIPLE = 24
ARC = "atan2"


class BranchGraph(Graph):
    """A graph of all branches of a solution, so that they share what they have in common.

    Beside sums and products: "divide", "atan2", "hypot" (of `left` and `right`), "sqrt", "cos", "sin", "absolute" (of
    `left`), and "cosine", "sine": `left` over the hypotenuse `right`, 1 and 0 where that vanishes. Branches differ by
    signs, so that the arc function of one gives those of the others: "opposite" is the angle of (−y, −x), "mirrored" that
    of (y, −x), where `left` is that of (y, x).
    """

    def __init__(self) -> None:
        super().__init__(lambda generator: None)

    def input(self, kind: str, name: str) -> Term:
        """Return an input."""
        return Term(self._node(Node("input", generator=(kind, name))), 1.0)

    def number(self, value: float) -> Term:
        """Return a constant."""
        return Term(0, value) if value else ZERO

    def subtract(self, left: Term, right: Term) -> Term:
        """Return the difference; 1 − u² as (1 − u)(1 + u), which keeps its digits where u is near 1."""
        node = self.nodes[right.node]
        if left == ONE and right.factor > 0 and node.operation == "multiply" and node.left == node.right:
            u = Term(node.left, right.factor**0.5)
            return self.one_minus_square(u)
        return self.add(left, Term(right.node, -right.factor))

    def one_minus_square(self, u: Term) -> Term:
        """Return (1 − u)(1 + u)."""
        return self.multiply(self.add(ONE, Term(u.node, -u.factor)), self.add(ONE, u))

    def divide(self, left: Term, right: Term) -> Term:
        """Return a quotient."""
        if not left.factor:
            return ZERO
        if not right.node:
            return Term(left.node, left.factor / right.factor)
        return Term(self._node(Node("divide", left.node, right.node)), left.factor / right.factor)

    def sqrt(self, term: Term) -> Term:
        """Return the square root that is not negative."""
        return self._unary("sqrt", term)

    def absolute(self, term: Term) -> Term:
        """Return the absolute value."""
        return self._unary("absolute", term)

    def atan2(self, y: Term, x: Term) -> Term:
        """Return atan2(y, x), in [−π, π]."""
        if not (y.factor and x.factor):
            return Term(self._node(Node(ARC, self._plain(y), self._plain(x))), 1.0)
        plain = self._node(Node(ARC, self._plain(_positive(y)), self._plain(_positive(x))))
        if x.factor > 0:
            return Term(plain, 1.0 if y.factor > 0 else -1.0)
        return Term(self._node(Node("mirrored" if y.factor > 0 else "opposite", plain)), 1.0)

    def acos(self, u: Term) -> Term:
        """Return arccos u as atan2(√(1 − u²), u), which keeps its digits."""
        return self.atan2(self.sqrt(self.one_minus_square(u)), u)

    def asin(self, u: Term) -> Term:
        """Return arcsin u as atan2(u, √(1 − u²))."""
        return self.atan2(u, self.sqrt(self.one_minus_square(u)))

    def cos_sin(self, angle: Term) -> tuple[Term, Term]:
        """Return cosine and sine; those of arc functions and of sums of them are algebraic."""
        if not angle.node:
            cosine, sine = self._unary("cos", angle), self._unary("sin", angle)
            return cosine, sine
        times = abs(angle.factor)
        if times == int(times) and times <= MAX_MULTIPLE:
            cosine, sine = self._multiple(self._pair(angle.node), int(times))
            return cosine, _negative(sine) if angle.factor < 0 else sine
        return self._unary("cos", angle), self._unary("sin", angle)

    def wrapped(self, angle: Term) -> Term:
        """Return the angle in [−π, π]."""
        if not angle.node or (
            self.nodes[angle.node].operation in (ARC, "opposite", "mirrored") and abs(angle.factor) == 1
        ):
            return angle
        return self._unary("wrap", angle)

    def _pair(self, place: int) -> tuple[Term, Term]:
        node = self.nodes[place]
        if node.operation == ARC:
            radius = self._node(Node("hypot", node.left, node.right))
            return (
                Term(self._node(Node("cosine", node.right, radius)), 1.0),
                Term(self._node(Node("sine", node.left, radius)), 1.0),
            )
        if node.operation in ("opposite", "mirrored"):
            cosine, sine = self._pair(node.left)
            return _negative(cosine), _negative(sine) if node.operation == "opposite" else sine
        if node.operation in ("add", "subtract"):
            sign = 1.0 if node.operation == "add" else -1.0
            return self._turned(self.cos_sin(Term(node.left, 1.0)), self.cos_sin(Term(node.right, sign)))
        if node.operation == "offset":
            return self._turned(self.cos_sin(Term(node.left, 1.0)), self.cos_sin(Term(0, node.value)))
        if node.operation == "scale" and node.value == int(node.value):
            return self.cos_sin(Term(node.left, node.value))
        return self._unary("cos", Term(place, 1.0)), self._unary("sin", Term(place, 1.0))

    def _turned(self, a: tuple[Term, Term], b: tuple[Term, Term]) -> tuple[Term, Term]:
        """Return cosine and sine of the sum of two angles."""
        return (
            self.subtract(self.multiply(a[0], b[0]), self.multiply(a[1], b[1])),
            self.add(self.multiply(a[1], b[0]), self.multiply(a[0], b[1])),
        )

    def _multiple(self, pair: tuple[Term, Term], times: int) -> tuple[Term, Term]:
        total = pair if times else (ONE, ZERO)
        for _ in range(times - 1):
            total = self._turned(total, pair)
        return total

    def _unary(self, operation: str, term: Term) -> Term:
        return Term(self._node(Node(operation, self._plain(term))), 1.0)

    def _plain(self, term: Term) -> int:
        """Return the node whose value is that of the term, its factor included."""
        if not term.factor:
            return self._node(Node("scale", 0, value=0.0))
        return self._scaled(term.node, term.factor)


def _positive(term: Term) -> Term:
    return Term(term.node, abs(term.factor))


def _negative(term: Term) -> Term:
    return Term(term.node, -term.factor)
