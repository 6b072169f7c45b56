"""The expression tree in MathML: what a page shows is what was checked.

Every type of node has its method; a tree that was read from LaTeX is shown with the brackets, fractions and spellings
of that LaTeX, which the tree keeps. Wrong or corrected parts are outlined, carry a sign and a label for screen readers.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import DerivativeOperator, Differential
from armproof.verification.latex.mathml import box
from armproof.verification.latex.mathml.box import EMPTY, Box
from armproof.verification.latex.mathml.breaking import narrowed
from armproof.verification.latex.mathml.calls import CallWriter
from armproof.verification.latex.mathml.marks import Mark
from armproof.verification.latex.mathml.names import name_box
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.units import size_of
from armproof.verification.patterns import regex

Read = Callable[[str], list[n.Statement]]
FENCES = {"bmatrix": ("[", "]"), "bsmallmatrix": ("[", "]"), "pmatrix": ("(", ")"), "psmallmatrix": ("(", ")"),
          "vmatrix": ("|", "|"), "Vmatrix": ("‖", "‖"), "Bmatrix": ("{", "}")}  # fmt: skip
WIDEST = 46.0  # em that a line may take: more than that is broken where it can be
_ELLIPSES = {"vdots": "⋮", "ddots": "⋱", "cdots": "⋯", "dotsb": "⋯", "dotsm": "⋯", "prod": "∏", "sum": "∑", "int": "∫"}
_LIMIT = regex(r"\s*(?:\\limits)?\s*([_^])\s*(\{[^{}]*\}|\\[A-Za-z]+|[^\s\\])")
_SEPARATOR = regex(r"(?<!\\)[,;]")
_NO_FENCE = regex(r"\\left\s*\.")


class MathWriter:
    """Writes trees that were read from `text`; `marks` are the parts to outline, by the identity of their nodes."""

    def __init__(self, text: str, read: Read, marks: Mapping[int, Mark] | None = None, widest: float = WIDEST) -> None:
        self.text = text
        self.read = read
        self.widest = widest
        self.marks = marks or {}
        self.calls = CallWriter(text, self.write)
        self.methods: dict[type, Callable[..., Box]] = {
            n.Number: self._number,
            n.Name: self._name,
            n.JointAngles: self.calls.joint_angles,
            n.Call: self.calls.call,
            n.Sum: self._sum,
            n.Product: self._product,
            n.Quotient: self._quotient,
            n.Ambiguous: self._ambiguous,
            n.Power: self._power,
            n.Postfix: self._postfix,
            n.Group: self._group,
            n.Sequence: self._sequence,
            n.Matrix: self._matrix,
            n.Derivative: self._derivative,
            n.Labelled: self._labelled,
            n.At: self._at,
            n.Cases: self._cases,
            n.Dots: self._dots,
            n.Layout: self._layout,
            n.Chain: self._chain,
            n.Connective: self.connective,
            Differential: self._differential,
            DerivativeOperator: self._derivative_operator,
        }

    def write(self, node: n.Node) -> Box:
        """Return the MathML of a tree, as one element."""
        mark = self.marks.get(id(node))
        written = self._unmarked(node)
        return mark.around(written) if mark is not None else written

    def _unmarked(self, node: n.Node) -> Box:
        return self.methods[type(node)](node)

    def relation(self, sign: str) -> Box:
        """Return the sign between two members of a chain."""
        return box.operator(sign)

    def connective(self, node: n.Connective) -> Box:
        """Return what stands between two statements."""
        if node.kind in "⇒⇔⇐":
            return box.operator(node.kind)
        word = {"lor": "or", "vee": "or", "land": "and", "forall": "∀", "exists": "∃", "because": "because"}.get(
            node.text
        )
        return box.words(word or plain_text(node.text))

    # -- sums and products -----------------------------------------------------------------------------------------

    def _name(self, node: n.Name, above: Box = EMPTY) -> Box:
        return name_box(node, above, self.text[max(0, node.span[0] - 20) : node.span[0]])

    def _number(self, node: n.Number) -> Box:
        return box.number(node.text.replace("{,}", ",") or str(node.value))

    def terms(self, node: n.Sum) -> list[Box]:
        """Return the terms of a sum, each with its sign."""
        return [box.joined([_sign(node, index), self.write(term)]) for index, (_, term) in enumerate(node.terms)]

    def _sum(self, node: n.Sum) -> Box:
        return _element(box.joined(self.terms(node)))

    def factors(self, node: n.Product) -> list[Box]:
        """Return the factors of a product, each with the operator before it."""
        parts = [self.write(node.factors[0])]
        for operator, before, factor in zip(node.operators, node.factors, node.factors[1:], strict=False):
            if operator == "×" and "\\wedge" in self.text[before.span[1] : factor.span[0]]:
                operator = "∧"
            sign = box.operator(operator) if operator else box.thin_space() if _apart(before, factor) else EMPTY
            parts.append(box.joined([sign, self.write(factor)]))
        return parts

    def _product(self, node: n.Product) -> Box:
        return _element(box.joined(self.factors(node)))

    def _quotient(self, node: n.Quotient) -> Box:
        above, below = self.write(node.numerator), self.write(node.denominator)
        return box.row(above, _SLASH, below) if node.style == "slash" else box.fraction(above, below)

    def _ambiguous(self, node: n.Ambiguous) -> Box:
        return self.write(node.readings[0])  # both are printed alike

    def _power(self, node: n.Power) -> Box:
        return self._raised(node.base, self.write(node.exponent))

    def _postfix(self, node: n.Postfix) -> Box:
        if node.operator != "deg" and size_of(node.operator):
            return box.row(self.write(node.base), box.words(node.operator))
        minus = box.mark("−")
        above = {"T": box.letter("T", upright=True), "-1": box.row(minus, box.number("1")), "+": box.mark("+"), "-": minus,
                 "-T": box.row(minus, box.letter("T", upright=True)), "deg": box.mark("°")}[node.operator]  # fmt: skip
        return self._raised(node.base, above)

    def _raised(self, base: n.Node, above: Box) -> Box:
        if id(base) not in self.marks:
            if isinstance(base, n.Name):
                return self._name(base, above)
            if isinstance(base, n.Call):
                return self.calls.call(base, above)
        return box.scripted(self.write(base), sup=above)

    # -- brackets, lists and matrices ------------------------------------------------------------------------------

    def _group(self, node: n.Group) -> Box:
        if node.brackets == "{}":
            return self.write(node.inner)
        return box.fenced(node.brackets[0], self.write(node.inner), node.brackets[1])

    def _sequence(self, node: n.Sequence) -> Box:
        parts: list[Box] = []
        for index, item in enumerate(node.items):
            if index:
                found = _SEPARATOR.search(self.text, node.items[index - 1].span[1], item.span[0])
                parts.append(box.mark(found.group()) if found else _BLANK)
            parts.append(self.write(item))
        if node.brackets == "{}" and _NO_FENCE.match(self.text, node.span[0]):
            return _element(box.joined(parts))
        return box.fenced(node.brackets[0], box.joined(parts), node.brackets[1])

    def _matrix(self, node: n.Matrix) -> Box:
        if node.environment == "zeros":
            size = (box.number(str(len(node.rows))), box.mark("×"), box.number(str(len(node.rows[0]))))
            return box.scripted(box.number("0"), box.row(*size))
        boxes = [[self._unmarked(cell) for cell in cells] for cells in node.rows]
        cells = narrowed(node.rows, boxes, self._terms_of, self.widest)
        marks = [[self.marks.get(id(cell)) for cell in row] for row in node.rows]
        opening, closing = FENCES.get(node.environment, ("", ""))
        return box.fenced(
            opening,
            box.table(
                [
                    [
                        (mark.inside(cell), mark.attributes) if mark else (cell, "")
                        for cell, mark in zip(*row, strict=True)
                    ]
                    for row in zip(cells, marks, strict=True)
                ]
            ),
            closing,
        )

    def _terms_of(self, node: n.Node) -> list[Box]:
        """Return the parts of a long cell between which a line may end: terms, and factors in brackets."""
        if isinstance(node, n.Product):
            bracketed = any(isinstance(factor, n.Group) for factor in node.factors)
            return self.factors(node) if bracketed else [self.write(node)]
        if not isinstance(node, n.Sum):
            return [self.write(node)]
        parts: list[Box] = []
        for index, (_, term) in enumerate(node.terms):
            factors = self._terms_of(term) if isinstance(term, n.Product) else [self.write(term)]
            parts += [box.joined([_sign(node, index), factors[0]]), *factors[1:]]
        return parts

    # -- derivatives, labels, configurations -----------------------------------------------------------------------

    def _derivative(self, node: n.Derivative) -> Box:
        if re.match(r"\\d+ot", self.text[node.span[0] :]):
            return box.over(self.write(node.operand), "˙")
        sign = self._differential_sign(node)
        simple = isinstance(node.operand, n.Name | n.Call | n.Number)
        above = [sign, self.write(node.operand)] if simple else [sign]
        quotient = box.fraction(box.row(*above), box.row(self._first_sign(node), self._variable(node)))
        if simple:
            return quotient
        operand = self.write(node.operand)
        return box.row(quotient, box.fenced("(", operand, ")") if isinstance(node.operand, n.Sum) else operand)

    def _derivative_operator(self, node: DerivativeOperator) -> Box:
        return box.fraction(self._differential_sign(node), box.row(self._first_sign(node), self._variable(node)))

    def _differential(self, node: Differential) -> Box:
        sign = box.scripted(box.mark("∂"), sup=box.number(str(node.order)) if node.order > 1 else EMPTY)
        return box.row(sign, self.write(node.operand) if node.operand is not None else EMPTY)

    def _first_sign(self, node: n.Derivative | DerivativeOperator) -> Box:
        text = self.text[node.span[0] : node.span[1]]
        return box.mark("∂") if "\\partial" in text or "\\delta" in text else box.letter("d", upright=True)

    def _differential_sign(self, node: n.Derivative | DerivativeOperator) -> Box:
        order = box.number(str(node.order)) if node.order > 1 else EMPTY
        return box.scripted(self._first_sign(node), sup=order)

    def _variable(self, node: n.Derivative | DerivativeOperator) -> Box:
        order = box.number(str(node.order)) if node.order > 1 else EMPTY
        return box.scripted(self.write(node.variable), sup=order)

    def _labelled(self, node: n.Labelled) -> Box:
        label = self.write(node.label) if node.label is not None else EMPTY
        if node.size is not None:
            label = box.row(box.number(str(node.size[0])), box.mark("×"), box.number(str(node.size[1])))
        above = self.text.startswith("\\overbrace", node.span[0])
        sign = Box(f'<mo stretchy="true">{"⏞" if above else "⏟"}</mo>', 0.5)
        inner = self.write(node.inner)
        braced = box.limits(inner, EMPTY, sign) if above else box.limits(inner, sign, EMPTY)
        return box.limits(braced, EMPTY, label) if above else box.limits(braced, label, EMPTY)

    def _at(self, node: n.At) -> Box:
        parts: list[Box] = []
        for index, (left, right) in enumerate(node.values):
            parts += [box.mark(",")] * bool(index) + [self.write(left), box.operator("="), self.write(right)]
        return box.scripted(box.fenced("", self.write(node.inner), "|"), box.row(*parts))

    def _dots(self, node: n.Dots) -> Box:
        command = self.text[node.span[0] : node.span[1]].strip("\\ ")
        sign = box.mark(_ELLIPSES.get(command, "…"))
        if command not in ("prod", "sum", "int"):
            return sign
        below = above = EMPTY
        position = node.span[1]
        while (limit := _LIMIT.match(self.text, position)) is not None:  # the tree leaves them to the reader
            shown = box.words(plain_text(limit.group(2)))
            below, above = (shown, above) if limit.group(1) == "_" else (below, shown)
            position = limit.end()
        return box.limits(sign, below, above)

    # -- statements ------------------------------------------------------------------------------------------------

    def _cases(self, node: n.Cases) -> Box:
        rows = [[(self.write(value), ""), (self._condition(condition), "")] for value, condition in node.branches]
        return box.fenced("{", box.table(rows, "left"), "")

    def _condition(self, latex: str) -> Box:
        """A case's condition, which the tree keeps as LaTeX."""
        try:
            statements = self.read(latex) if latex else []
        except ReadError:
            return box.words(plain_text(latex))
        writer = MathWriter(latex, self.read)
        return box.row(*(writer.write(statement) for statement in statements)) if statements else EMPTY

    def _layout(self, node: n.Layout) -> Box:
        return box.table([[(self.write(statement), "")] for statement in node.statements], "left")

    def _chain(self, node: n.Chain) -> Box:
        parts = [self.write(node.members[0])]
        for relation, member in zip(node.relations, node.members[1:], strict=False):
            parts += [self.relation(relation), self.write(member)]
        return _element(box.joined(parts))


_SLASH = Box('<mo lspace="0" rspace="0">/</mo>', 0.5)
_BLANK = Box('<mspace width="0.6em"/>', 0.6)


def _sign(node: n.Sum, index: int) -> Box:
    """Return the sign before a term; a plus before the first is not printed."""
    sign = node.terms[index][0]
    return EMPTY if sign == "+" and not index else box.operator("−" if sign == "-" else sign)


def _element(inner: Box) -> Box:
    return Box(f"<mrow>{inner.markup}</mrow>", inner.width)


def _apart(before: n.Node, after: n.Node) -> bool:
    """Whether two juxtaposed factors need a little space: before and after a function's name, between numbers."""
    named = isinstance(before, n.Call) and before.style == "macro"
    while isinstance(after, n.Power | n.Postfix):
        after = after.base
    follows = isinstance(after, n.Call) and after.style in ("macro", "macro()")
    return named or follows or (isinstance(after, n.Number) and isinstance(before, n.Number))
