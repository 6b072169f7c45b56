"""The formulas of a document by the name that each gives a value: what a derivation may be made of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.document import Display, Document
from armproof.verification.equations.given_values import named_sign
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.blocks import partition
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches, is_number
from armproof.verification.latex.statements import PREVIOUS
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.names import Names

_CONDITIONAL = ("⇔", "⇐", "⇒", "if", "or")


@dataclass(frozen=True, eq=False)
class Formula:
    """An equation `key = node` of a display; with a place, the key is that cell of the printed rows.

    Attributes:
        key: the name, or "sin theta_3" for the sine of a joint.
        node: the other side.
        line: where its display begins.
        rows: the printed matrix in which the key stands, for one that is defined by its place.
        place: (row, column) in it.
        name: the key as a name, where it is one.
        latex: the display, normalised, into which the spans of the nodes point.
    """

    key: str
    node: n.Node
    line: int
    rows: tuple[tuple[n.Node, ...], ...] = ()
    place: tuple[int, int] | None = None
    name: n.Name | None = None
    latex: str = ""

    def text(self, node: n.Node) -> str:
        """Return a part of the formula as it is printed."""
        return self.latex[slice(*node.span)].strip()

    @property
    def branching(self) -> bool:
        """Whether a ± stands in it: it has two values, and its key is the name of the sign."""
        return has_branches(self.node)

    def value(self, evaluator: Evaluator) -> object:
        """Return its value; raises EvaluationError."""
        value = evaluator.evaluate(self.node)
        if self.place is None:
            return value
        blocks = partition(self.rows, value.shape) if isinstance(value, Matrix) else None
        found = next((b for b in blocks or () if (b.row, b.column) == self.place), None)
        if found is None:
            raise EvaluationError(say(Kind.MATRIX_OF_OTHER_SIZE, name=self.key))
        return found.of(value)


def read_formulas(document: Document, names: Names) -> dict[str, list[Formula]]:
    """Return the formulas of all displays but the errata, in their order, by what they give a value."""
    formulas: dict[str, list[Formula]] = {}
    for display in document.displays:
        if not display.erratum and display.closed:
            for formula in _display_formulas(display, names):
                formulas.setdefault(formula.key, []).append(formula)
    return formulas


def _display_formulas(display: Display, names: Names) -> Iterator[Formula]:
    try:
        statements = names.reader.read(display.latex)
    except ReadError:  # the display has its own record, which says so
        return
    conditional = any(isinstance(s, n.Connective) and s.kind in _CONDITIONAL for s in statements)
    for statement in statements:
        if isinstance(statement, n.Chain) and PREVIOUS not in statement.members:
            for formula in _chain_formulas(statement, display.line, names):
                if not (conditional and is_number(formula.node)):  # "… ⇔ θ_2 = 0" is a condition
                    yield replace(formula, latex=normalise_unicode(display.latex))


def _chain_formulas(chain: n.Chain, line: int, names: Names) -> Iterator[Formula]:
    if set(chain.relations) == {"="}:
        for left in chain.members:
            for right in chain.members:
                if left is not right:
                    yield from _equation_formulas(left, right, line, names)
    elif (key := named_sign(chain)) is not None:
        yield Formula(key, n.Sum((("±", n.Number(Fraction(1), text="1")),)), line)
    for member in chain.members:
        for below in n.walk(member):
            if isinstance(below, n.Labelled) and below.label is not None and (key := bare_key(below.label)):
                yield Formula(key, below.inner, line)


def _equation_formulas(left: n.Node, right: n.Node, line: int, names: Names) -> Iterator[Formula]:
    key = bare_key(left) or joint_function_key(left, names)
    if key is not None:
        yield Formula(_symbol(key, names), right, line, name=_name(left))
        return
    left, right = bare(left), bare(right)
    if not isinstance(left, n.Matrix):
        return
    aligned = isinstance(right, n.Matrix) and [len(r) for r in left.rows] == [len(r) for r in right.rows]
    for r, row in enumerate(left.rows):
        for c, cell in enumerate(row):
            if (key := bare_key(cell)) is None:
                continue
            if aligned and isinstance(right, n.Matrix):
                yield Formula(_symbol(key, names), right.rows[r][c], line, name=_name(cell))
            else:
                yield Formula(_symbol(key, names), right, line, left.rows, (r, c), _name(cell))


def joint_function_key(node: n.Node, names: Names) -> str | None:
    """Return "cos theta_2" for the cosine of one joint, "sin theta_2" for its sine, None for anything else."""
    node = bare(node)
    if not n.is_call(node, "cos", "sin") or len(node.arguments) != 1:
        return None
    argument = bare(node.arguments[0])
    symbol: str | None = None
    if isinstance(argument, n.JointAngles) and len(argument.terms) == 1 and argument.terms[0][0] > 0:
        symbol = names.joint_angle(argument.terms[0][1])
    elif isinstance(argument, n.Name):
        symbol = names.known_symbol(argument.key)
        if symbol is not None and names.table_row(symbol, argument.key) is not names.table_row(symbol):
            return None  # an angle of the table beside the variable: s_2 may be the sine of either
    return f"{node.function} {symbol}" if symbol in names.joints else None


def _name(node: n.Node) -> n.Name | None:
    node = bare(node)
    return node if isinstance(node, n.Name) else None


def _symbol(key: str, names: Names) -> str:
    """Return the arm's symbol where the document writes a joint with a letter of its own."""
    return names.known_symbol(key) or key
