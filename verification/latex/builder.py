"""From Lark's parse to the expression tree: one method a rule of the grammar."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from lark import Token, Transformer

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import Differential, Item
from armproof.verification.latex.runs import (
    RunReader,
    argument_end,
    node_item,
    partial_derivative,
    product,
    scripts_before,
    slashed_derivative,
    total_derivative,
)
from armproof.verification.latex.statements import Cell, build_statements, environment_node
from armproof.verification.latex.tokens import Spelling, canonical_script, span_of_token
from armproof.verification.patterns import regex

_DOUBLE_BAR = regex(r"(?:\\left\s*)?(?:\\\||\|\||‖|\\[lr]?Vert(?![A-Za-z]))")


class TreeBuilder(Transformer):
    """Callbacks of the grammar's rules; `is_bound(key)` tells the names that the front matter gives a meaning."""

    def __init__(
        self, text: str, is_bound: Callable[[str], bool], parse: Callable[[str, int], n.Node], spelling: Spelling
    ) -> None:
        super().__init__(visit_tokens=False)
        self.text = text
        self.runs = RunReader(text, is_bound, parse, spelling)

    # -- layout ----------------------------------------------------------------------------------------------------

    def start(self, children: list) -> list:
        return build_statements(children[0])

    def rows(self, children: list) -> list:
        return [child for child in children if not isinstance(child, Token)]

    row = rows

    def cell_empty(self, _children: list) -> Cell:
        return []

    def cell_first(self, children: list) -> Cell:
        return list(children)

    def cell_more(self, children: list) -> Cell:
        return [*children[0], *children[1:]]

    def mark(self, children: list) -> Token:
        return children[0]

    def environment(self, children: list) -> Item:
        begin, rows, end = children
        matching = {begin.value, "array" if begin.value.endswith("matrix") else begin.value}
        if end.value not in matching:
            raise ReadError(say(Kind.WRONG_END, begin=str(begin), end=str(end)), end.start_pos)
        span = (begin.start_pos, end.end_pos)
        return node_item(environment_node(begin.value, rows, span, self.text))

    # -- sums and products -----------------------------------------------------------------------------------------

    def expr(self, children: list) -> n.Node:
        if len(children) == 1:
            return children[0]
        terms: list[tuple[str, n.Node]] = []
        sign = "+"
        for child in children:
            if isinstance(child, Token):
                sign = {"PLUS": "+", "MINUS": "-"}.get(child.type, "∓" if child.value == "mp" else "±")
            else:
                terms.append((sign, child))
        first = children[0]
        start = span_of_token(first)[0] if isinstance(first, Token) else first.span[0]
        return n.Sum(tuple(terms), span=(start, terms[-1][1].span[1]))

    def term(self, children: list) -> n.Node:
        result, rest = product(children[0]), iter(children[1:])
        for operator in rest:
            run = next(rest)
            if isinstance(run, Token):  # a sign
                run = next(rest)
                right: n.Node = n.Sum((("-", product(run)),), span=product(run).span)
            else:
                right = product(run)
            result = self._join(result, operator, right, run)
        return result

    def _join(self, left: n.Node, operator: Token, right: n.Node, run: list[n.Node]) -> n.Node:
        span = (left.span[0], right.span[1])
        if operator.type == "SLASH":
            if isinstance(left, Differential) and isinstance(right, Differential):
                return partial_derivative(left, right, span)
            if (rate := slashed_derivative(left, run, span)) is not None:
                return rate
            below = n.Quotient(left, right, "slash", span=span)
            if right == n.Number(Fraction(2)) and (halved := _with_half_angle(left, right)) is not None:
                return n.Ambiguous((below, halved), self.text[span[0] : span[1]], "half", span=span)
            if len(run) == 1:  # a b / c is (a b)/c
                return below
            first = n.Quotient(left, run[0], "slash", span=(left.span[0], run[0].span[1]))
            beside = n.Product((first, *run[1:]), ("",) * (len(run) - 1), span=span)
            if isinstance(left, n.Number) and isinstance(run[0], n.Number):
                return beside
            matrix = next((k for k, factor in enumerate(run) if isinstance(n.bare(factor), n.Matrix)), 0)
            if matrix > 1:  # 1/l_1 l_2 s_2 [matrix]: nothing is divided by a matrix
                scale = n.Quotient(left, product(run[:matrix]), "slash", span=(left.span[0], run[matrix - 1].span[1]))
                scaled = n.Product((scale, *run[matrix:]), ("",) * (len(run) - matrix), span=span)
                return n.Ambiguous((scaled, beside), self.text[span[0] : run[matrix - 1].span[1]], "scale", span=span)
            readings = (below, beside) if isinstance(run[0], n.Number) else (beside, below)
            return n.Ambiguous(readings, self.text[span[0] : span[1]], span=span)
        if operator.type == "TIMES":  # the cross product binds like any product, but must keep its two sides whole
            return n.Product((left, right), ("×",), span=span)
        factors, operators = (left.factors, left.operators) if isinstance(left, n.Product) else ((left,), ())
        if isinstance(right, n.Product) and "×" not in right.operators:
            return n.Product((*factors, *right.factors), (*operators, "⋅", *right.operators), span=span)
        return n.Product((*factors, right), (*operators, "⋅"), span=span)

    # -- atoms -----------------------------------------------------------------------------------------------------

    def item(self, children: list) -> Item:
        item = children[0]
        if not isinstance(item, Item):
            raise ReadError(say(Kind.OPERAND_MISSING), children[0].start_pos)
        for script in children[1:]:
            item.scripts.append((script.type, script.value, span_of_token(script)))
            item.end = script.end_pos
        return item

    def prescripted(self, children: list) -> Item:
        item = children[-1]
        scripts = [child for child in children[:-1] if child.type != "PRE"]
        item.pre = [(script.type, script.value, span_of_token(script)) for script in scripts]
        item.start = children[0].start_pos
        return item

    fresh = prescripted

    def trailing(self, children: list) -> Item:
        """`R{}^T`: scripts set off by an empty group belong to what stands before."""
        scripts = [(child.type, child.value, span_of_token(child)) for child in children if child.type != "PRE"]
        return Item("trailing", None, children[0].start_pos, children[-1].end_pos, scripts=scripts)

    def number(self, children: list) -> Item:
        token = children[0]
        if len(token.value) > 40:
            raise ReadError(say(Kind.LONG_NUMBER), token.start_pos)
        if "," in token.value.replace("{,}", ""):  # 0,5: one number or two, by a document that does not say
            words = n.Name("words", text=token.value, span=span_of_token(token))
            return Item("node", words, token.start_pos, token.end_pos)
        node = n.Number(Fraction(token.value.replace("{,}", ".")), token.value, span=span_of_token(token))
        return Item("number", node, token.start_pos, token.end_pos)

    def letter(self, children: list) -> Item:
        token = children[0]
        return Item("letter", None, token.start_pos, token.end_pos, base=token.value)

    def function(self, children: list) -> Item:
        token = children[0]
        return Item("function", None, token.start_pos, token.end_pos, base=token.value)

    def partial(self, children: list) -> Item:
        return Item("partial", None, children[0].start_pos, children[0].end_pos)

    def dots(self, children: list) -> Item:
        token = children[0]
        return node_item(n.Dots(span=span_of_token(token)))

    def braces(self, children: list) -> Item:
        opened, inner, closed = children
        span = (opened.start_pos, closed.end_pos)
        if isinstance(inner, n.Name | n.Number | n.Matrix | n.Call | n.Layout | Differential):
            item = node_item(replace(inner, span=span))
            if isinstance(inner, n.Name) and not (inner.sub or inner.sup or inner.primes):
                # {C}_1 and {T}^0_1: braces around a bare name are style
                item.kind, item.base = "letter", inner.base
                item.pre = scripts_before(inner, span)
                item.scripts = [("DOT", "", span)] * inner.dots
            return item
        return Item("braces", n.Group(inner, "{}", span=span), *span)

    def parentheses(self, children: list) -> Item:
        opened, items, closed = children
        span = (opened.start_pos, closed.end_pos)
        brackets = "[]" if "[" in opened.value or "lbrack" in opened.value else "()"
        if len(items) == 1 and isinstance(items[0], n.Matrix | n.Layout | n.Cases):
            if isinstance(items[0], n.Matrix):
                return node_item(n.Group(items[0], brackets, span=span))
            return node_item(items[0])
        if len(items) > 1:
            return Item("list", n.Sequence(tuple(items), brackets, span=span), *span)
        return Item("list", n.Group(items[0], brackets, span=span), *span)

    def fence(self, children: list) -> Item:
        opened, items, closed = children
        span = (opened.start_pos, closed.end_pos)
        if len(items) == 1:
            inner = items[0]
            if closed.value == "|":
                return Item("evaluated", inner, *span)
            return node_item(
                inner if isinstance(inner, n.Layout | n.Cases | n.Matrix) else n.Group(inner, "{}", span=span)
            )
        return node_item(n.Sequence(tuple(items), "{}", span=span))

    def braced_set(self, children: list) -> Item:
        opened, items, closed = children
        return node_item(n.Sequence(tuple(items), "{}", span=(opened.start_pos, closed.end_pos)))

    def items(self, children: list) -> list[n.Node]:
        return [child for child in children if isinstance(child, n.Node)]

    def bars(self, children: list) -> Item:
        opened, inner, closed = children
        span = (opened.start_pos, closed.end_pos)
        is_norm = _DOUBLE_BAR.match(self.text, opened.start_pos) is not None
        function = "norm" if is_norm else "det" if isinstance(inner, n.Matrix) else "abs"
        return node_item(n.Call(function, (inner,), "|", "bars", span=span))

    def argument(self, children: list) -> n.Node:
        token = children[0]
        if len(children) == 1:
            span = span_of_token(token)
            if token.type == "NUMBER":
                return n.Number(Fraction(token.value), token.value, span=span)
            if token.type == "PARTIAL":
                return Differential(None, span=span)
            return self.runs.name(Item("letter", None, *span, base=token.value))
        cell = children[1]
        if len(cell) == 1 and isinstance(cell[0], n.Node):
            return cell[0]
        span = (token.start_pos, children[-1].end_pos)
        if not cell:
            raise ReadError(say(Kind.ARGUMENT_EMPTY), token.start_pos)
        return n.Layout(tuple(build_statements([[cell]])), span=span)

    def fraction(self, children: list) -> Item:
        token, above, below = children
        span = (token.start_pos, argument_end(self.text, below.span[1]))
        if isinstance(above, Differential) and isinstance(below, Differential):
            return node_item(partial_derivative(above, below, span))
        total = total_derivative(above, below, span)
        return node_item(total or n.Quotient(above, below, "frac", span=span))

    def root(self, children: list) -> Item:
        token, argument = children[0], children[-1]
        span = (token.start_pos, argument_end(self.text, argument.span[1]))
        if len(children) > 2 and children[2].value != "2":
            raise ReadError(say(Kind.NO_SQUARE_ROOT), token.start_pos)
        return node_item(n.Call("sqrt", (argument,), "\\sqrt", "braces", span=span))

    def accent(self, children: list) -> Item:
        token, argument = children
        dots = len(token.value) - 2  # dot, ddot, dddot
        span = (token.start_pos, argument_end(self.text, argument.span[1]))
        if isinstance(argument, n.Group) and argument.brackets == "{}":
            argument = argument.inner
        if isinstance(argument, n.Name):
            named = replace(argument, dots=argument.dots + dots, text=self.text[span[0] : span[1]], span=span)
            if argument.sub or argument.sup:
                return node_item(named)
            return Item("letter", None, *span, base=named.base, scripts=[("DOT", "", span)] * named.dots)
        time = n.Name("t", span=span)
        node = argument
        for _ in range(dots):
            node = n.Derivative(node, time, span=span)
        return node_item(node)

    def labelled(self, children: list) -> Item:
        token, argument = children
        span = (token.start_pos, argument_end(self.text, argument.span[1]))
        return Item("labelled", argument, *span)

    def overset(self, children: list) -> Item:
        token, above, below = children
        if token.value != "underset" and not isinstance(above, n.Layout):  # an arrow leaves a name what it is
            raise ReadError(say(Kind.MARK_ABOVE, text=self.text[slice(*above.span)]), token.start_pos)
        span = (token.start_pos, argument_end(self.text, below.span[1]))
        noted = self.text[slice(*above.span)]
        if not isinstance(below, n.Name) and (isinstance(above, n.Number) or "\\text" in noted):
            return Item("labelled", below, *span, scripts=[("SUB", noted, above.span)])
        index = token.value == "underset" and isinstance(above, n.Name | n.Number)
        if isinstance(below, n.Name) and index:  # p with a 2 under it is p_2
            if below.sub not in ("", "x", "y", "z"):
                raise ReadError(say(Kind.MARK_ABOVE, text=self.text[slice(*above.span)]), token.start_pos)
            index_below = canonical_script(self.text[slice(*above.span)])
            below = replace(below, sub=f"{index_below},{below.sub}".rstrip(","))
        return node_item(replace(below, span=span) if isinstance(below, n.Name) else below)

    # -- runs ------------------------------------------------------------------------------------------------------

    def run(self, items: list[Item]) -> list[n.Node]:
        return self.runs.read(items)


def _with_half_angle(node: n.Node, two: n.Node) -> n.Node | None:
    r"""Return \tan\theta_2 with the slash behind it, \tan\theta_2/2, within the function; None of what ends otherwise."""
    if isinstance(node, n.Product):
        last = _with_half_angle(node.factors[-1], two)
        return replace(node, factors=(*node.factors[:-1], last)) if last is not None else None
    if isinstance(node, n.Power):
        base = _with_half_angle(node.base, two)
        return replace(node, base=base) if base is not None else None
    if not (n.is_call(node, "cos", "sin", "tan") and node.style == "macro"):
        return None
    half = n.Quotient(node.arguments[0], two, "slash", span=(node.arguments[0].span[0], two.span[1]))
    return replace(node, arguments=(half,))
