"""From Lark's parse to the expression tree: runs of items become products, calls and indexed names."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence as Seq
from dataclasses import dataclass, field, replace
from fractions import Fraction

from lark import Token, Transformer

from verification.errors import ReadError
from verification.latex import nodes as n
from verification.latex.statements import Cell, build_statements, environment_node
from verification.latex.tokens import canonical_script

Script = tuple[str, str, tuple[int, int]]  # ("SUB" | "SUP" | "PRIME", text, span)

TRANSFORM_LETTERS = frozenset("TAHR")
VECTOR_LETTERS = frozenset(["p", "P", "z", "Z", "O", "o", "x", "y", "X", "Y", "J", "v", "V", "omega", "Omega", "W", "w"])
TRIG_LETTERS = {"c": "cos", "C": "cos", "s": "sin", "S": "sin"}
ANGLE_LETTERS = frozenset(["theta", "alpha", "beta", "gamma", "phi", "psi", "q", "delta"])
MATRIX_FUNCTIONS = frozenset(["det", "rank", "adj", "com", "tr"])
_OPERATORS = {"T": "T", "t": "T", "top": "T", "intercal": "T", "-1": "-1", "-T": "-T", "+": "+", "dagger": "+", "#": "+",
              "circ": "deg", "o": "deg"}  # fmt: skip
_SIZE = re.compile(r"\(?\dx[1-9n]\)?")
_SIZED = frozenset(["I", "Id", "E", "O", "J"])  # whose size is part of the name, or a claim
_JOINT_DIGITS = re.compile(r"[+-]?\d(?:,?[+-]?\d)*")
MAX_EXPONENT = 24


@dataclass
class Item:
    """One atom of a run with its scripts, before it is known what it is applied to."""

    kind: str  # letter, function, partial, number, list, braces, operator, node
    node: n.Node | None
    start: int
    end: int
    base: str = ""
    scripts: list[Script] = field(default_factory=list)
    pre: list[Script] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Differential(n.Node):
    """∂x, or ∂ alone, on its way into a Derivative."""

    operand: n.Node | None
    order: int = 1


@dataclass(frozen=True, slots=True)
class _DerivativeOperator(n.Node):
    """∂/∂x, waiting for its operand."""

    variable: n.Node
    order: int = 1


class TreeBuilder(Transformer):
    """Callbacks of the grammar's rules; `is_bound(key)` tells the names that the front matter gives a meaning."""

    def __init__(self, text: str, is_bound: Callable[[str], bool], parse: Callable[[str, int], n.Node]) -> None:
        super().__init__()
        self.text = text
        self.is_bound = is_bound
        self.parse = parse

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
            raise ReadError(f"'\\begin{{{begin}}}' is closed by '\\end{{{end}}}'", end.start_pos)
        span = (begin.start_pos, end.end_pos)
        return _node_item(environment_node(begin.value, rows, span, self.text))

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
        start = first.start_pos if isinstance(first, Token) else first.span[0]
        return n.Sum(tuple(terms), span=(start, terms[-1][1].span[1]))

    def term(self, children: list) -> n.Node:
        result = self._factor(children[0])
        index = 1
        while index < len(children):
            operator = children[index]
            index += 1
            negative = isinstance(children[index], Token)
            index += negative
            run = children[index]
            index += 1
            right = self._factor(run)
            if negative:
                right = n.Sum((("-", right),), span=right.span)
            result = self._join(result, operator, right, run)
        return result

    def _factor(self, run: list[n.Node]) -> n.Node:
        if len(run) == 1:
            return run[0]
        return n.Product(tuple(run), ("",) * (len(run) - 1), span=_span(run))

    def _join(self, left: n.Node, operator: Token, right: n.Node, run: list[n.Node]) -> n.Node:
        span = (left.span[0], right.span[1])
        if operator.type == "SLASH":
            if isinstance(left, _Differential) and isinstance(right, _Differential):
                return self._derivative(left, right, span)
            if len(run) > 1 and not (isinstance(left, n.Number) and isinstance(run[0], n.Number)):
                raise ReadError(
                    f"'{self.text[span[0] : span[1]]}' has two readings: write \\frac{{…}}{{…}}, or parentheses", operator.start_pos
                )
            if len(run) > 1:
                quotient = n.Quotient(left, run[0], "slash", span=(left.span[0], run[0].span[1]))
                return n.Product((quotient, *run[1:]), ("",) * (len(run) - 1), span=span)
            if isinstance(left, n.Product):  # a b / c is (a b)/c
                return n.Quotient(left, right, "slash", span=span)
            return n.Quotient(left, right, "slash", span=span)
        sign = {"CDOT": "⋅", "TIMES": "×"}[operator.type]
        factors: tuple[n.Node, ...] = (left,)
        operators: tuple[str, ...] = ()
        if isinstance(left, n.Product):
            factors, operators = left.factors, left.operators
        if sign == "×":  # the cross product binds like any product, but must keep its two sides whole
            return n.Product((left, right), ("×",), span=span)
        if isinstance(right, n.Product) and "×" not in right.operators:
            return n.Product((*factors, *right.factors), (*operators, sign, *right.operators), span=span)
        return n.Product((*factors, right), (*operators, sign), span=span)

    # -- atoms -----------------------------------------------------------------------------------------------------

    def item(self, children: list) -> Item:
        item = children[0]
        if not isinstance(item, Item):
            raise ReadError("an operand is missing", children[0].start_pos)
        for script in children[1:]:
            item.scripts.append((script.type, script.value, (script.start_pos, script.end_pos)))
            item.end = script.end_pos
        return item

    def prescripted(self, children: list) -> Item:
        item = children[-1]
        scripts = [child for child in children[:-1] if child.type != "PRE"]
        item.pre = [(script.type, script.value, (script.start_pos, script.end_pos)) for script in scripts]
        item.start = children[0].start_pos
        return item

    fresh = prescripted

    def trailing(self, children: list) -> Item:
        """`R{}^T`: scripts set off by an empty group belong to what stands before."""
        scripts = [(child.type, child.value, (child.start_pos, child.end_pos)) for child in children if child.type != "PRE"]
        return Item("trailing", None, children[0].start_pos, children[-1].end_pos, scripts=scripts)

    def number(self, children: list) -> Item:
        token = children[0]
        if len(token.value) > 40:
            raise ReadError("a number of more than 40 digits", token.start_pos)
        node = n.Number(Fraction(token.value.replace("{,}", ".")), token.value, span=(token.start_pos, token.end_pos))
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
        return _node_item(n.Dots(span=(token.start_pos, token.end_pos)))

    def braces(self, children: list) -> Item:
        opened, inner, closed = children
        span = (opened.start_pos, closed.end_pos)
        if isinstance(inner, n.Name | n.Number | n.Matrix | n.Call | n.Layout | _Differential):
            item = _node_item(replace(inner, span=span))
            if isinstance(inner, n.Name) and not (inner.sub or inner.sup or inner.primes):
                # {C}_1 and {T}^0_1: braces around a bare name are style
                item.kind, item.base = "letter", inner.base
                item.pre = _pre_of(inner, span)
                item.scripts = [("DOT", "", span)] * inner.dots
            return item
        return Item("braces", n.Group(inner, "{}", span=span), *span)

    def parentheses(self, children: list) -> Item:
        opened, items, closed = children
        span = (opened.start_pos, closed.end_pos)
        brackets = "[]" if "[" in opened.value or "lbrack" in opened.value else "()"
        if len(items) == 1 and isinstance(items[0], n.Matrix | n.Layout | n.Cases):
            if isinstance(items[0], n.Matrix):
                return _node_item(n.Group(items[0], brackets, span=span))
            return _node_item(items[0])
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
            return _node_item(inner if isinstance(inner, n.Layout | n.Cases | n.Matrix) else n.Group(inner, "{}", span=span))
        return _node_item(n.Sequence(tuple(items), "{}", span=span))

    def set(self, children: list) -> Item:
        opened, items, closed = children
        return _node_item(n.Sequence(tuple(items), "{}", span=(opened.start_pos, closed.end_pos)))

    def list(self, children: list) -> list[n.Node]:
        return [child for child in children if isinstance(child, n.Node)]

    def listmark(self, children: list) -> Token:
        return children[0]

    def bars(self, children: list) -> Item:
        opened, inner, closed = children
        span = (opened.start_pos, closed.end_pos)
        function = "det" if isinstance(inner, n.Matrix) else "abs"
        return _node_item(n.Call(function, (inner,), "|", "bars", span=span))

    def argument(self, children: list) -> n.Node:
        token = children[0]
        if len(children) == 1:
            span = (token.start_pos, token.end_pos)
            if token.type == "NUMBER":
                return n.Number(Fraction(token.value), token.value, span=span)
            if token.type == "PARTIAL":
                return _Differential(None, span=span)
            return self._name(Item("letter", None, *span, base=token.value))
        cell = children[1]
        if len(cell) == 1 and isinstance(cell[0], n.Node):
            return cell[0]
        span = (token.start_pos, children[-1].end_pos)
        if not cell:
            raise ReadError("an argument is empty", token.start_pos)
        return n.Layout(tuple(build_statements([[cell]])), span=span)

    def fraction(self, children: list) -> Item:
        token, above, below = children
        span = (token.start_pos, _argument_end(self.text, below.span[1]))
        if isinstance(above, _Differential) and isinstance(below, _Differential):
            return _node_item(self._derivative(above, below, span))
        total = self._total_derivative(above, below, span)
        return _node_item(total or n.Quotient(above, below, "frac", span=span))

    def _derivative(self, above: _Differential, below: _Differential, span: tuple[int, int]) -> n.Node:
        if below.operand is None:
            raise ReadError("a derivative with respect to nothing", below.span[0])
        variable, order = below.operand, above.order
        if order > 1:
            if not (isinstance(variable, n.Power) and isinstance(variable.exponent, n.Number) and variable.exponent.value == order):
                raise ReadError("a higher derivative is with respect to one variable, such as \\partial t^2", below.span[0])
            variable = variable.base
        if above.operand is None:
            return _DerivativeOperator(variable, order, span=span)
        return n.Derivative(above.operand, variable, order, span=span)

    def _total_derivative(self, above: n.Node, below: n.Node, span: tuple[int, int]) -> n.Node | None:
        """dx/dθ and d/dt(…), written with letters (δ is also met for ∂)."""
        below_run = below.factors if isinstance(below, n.Product) else ()
        if len(below_run) != 2 or not isinstance(below_run[0], n.Name) or below_run[0].key not in ("d", "delta"):
            return None
        mark = below_run[0].key
        if isinstance(above, n.Name) and above.key == mark:
            return _DerivativeOperator(below_run[1], span=span)
        if isinstance(above, n.Product) and isinstance(above.factors[0], n.Name) and above.factors[0].key == mark:
            operand = above.factors[1] if len(above.factors) == 2 else n.Product(above.factors[1:], above.operators[1:], span=above.span)
            return n.Derivative(operand, below_run[1], span=span)
        return None

    def root(self, children: list) -> Item:
        token, argument = children[0], children[-1]
        span = (token.start_pos, _argument_end(self.text, argument.span[1]))
        if len(children) > 2 and children[2].value != "2":
            raise ReadError("only square roots are read", token.start_pos)
        return _node_item(n.Call("sqrt", (argument,), "\\sqrt", "braces", span=span))

    def accent(self, children: list) -> Item:
        token, argument = children
        dots = len(token.value) - 2  # dot, ddot, dddot
        span = (token.start_pos, _argument_end(self.text, argument.span[1]))
        if isinstance(argument, n.Group) and argument.brackets == "{}":
            argument = argument.inner
        if isinstance(argument, n.Name):
            named = replace(argument, dots=argument.dots + dots, text=self.text[span[0] : span[1]], span=span)
            if argument.sub or argument.sup:
                return _node_item(named)
            return Item("letter", None, *span, base=named.base, scripts=[("DOT", "", span)] * named.dots)
        time = n.Name("t", span=span)
        node = argument
        for _ in range(dots):
            node = n.Derivative(node, time, span=span)
        return _node_item(node)

    def labelled(self, children: list) -> Item:
        token, argument = children
        span = (token.start_pos, _argument_end(self.text, argument.span[1]))
        return Item("labelled", argument, *span)

    def overset(self, children: list) -> Item:
        token, _above, below = children
        span = (token.start_pos, _argument_end(self.text, below.span[1]))
        return _node_item(replace(below, span=span) if isinstance(below, n.Name) else below)

    # -- runs ------------------------------------------------------------------------------------------------------

    def run(self, items: list[Item]) -> list[n.Node]:
        items = _reassociate(_attach_trailing(items))
        factors: list[n.Node] = []
        index = 0
        while index < len(items):
            node, index = self._next_factor(items, index)
            factors.append(node)
        return factors

    def _next_factor(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        item = items[index]
        if item.kind == "function":
            return self._call(items, index)
        if item.kind == "partial":
            order = next((int(text) for kind, text, _ in item.scripts if kind == "SUP" and text in ("2", "3")), 1)
            if index + 1 == len(items):
                return _Differential(None, order, span=(item.start, item.end)), index + 1
            operand, after = self._next_factor(items, index + 1)
            rest = [operand]
            while after < len(items):
                more, after = self._next_factor(items, after)
                rest.append(more)
            whole = self._factor(rest)
            return _Differential(whole, order, span=(item.start, whole.span[1])), after
        if item.kind == "letter":
            return self._letter_factor(items, index)
        if item.kind == "labelled":
            return self._labelled(item), index + 1
        if item.kind == "evaluated":
            return self._evaluated(item), index + 1
        assert item.node is not None
        if isinstance(item.node, _DerivativeOperator):
            if index + 1 == len(items):
                raise ReadError("a derivative of nothing", item.start)
            operand, after = self._next_factor(items, index + 1)
            return n.Derivative(operand, item.node.variable, item.node.order, span=(item.start, operand.span[1])), after
        return self._scripted(item.node, item.scripts, item.start), index + 1

    def _scripted(self, node: n.Node, scripts: Seq[Script], start: int) -> n.Node:
        """Apply what stands above an operand that is not a name: a power, a transpose, an inverse."""
        if isinstance(node, n.Dots):  # \\prod_{i=1}^{n}: which terms are meant is left to the reader
            return node
        for kind, text, span in scripts:
            if kind == "PRIME":
                raise ReadError("a prime on an expression", span[0])
            canonical = canonical_script(text)
            if kind == "SUB":
                size = re.fullmatch(r"\(?(\d)x(\d)\)?", canonical)
                if size and isinstance(node, n.Number) and node.value == 0:  # 0_{3×1}
                    node = n.Matrix(((node,) * int(size.group(2)),) * int(size.group(1)), "zeros", span=(start, span[1]))
                    continue
                if isinstance(node, n.Matrix | n.Group | n.Sequence | n.Call | n.Number) or canonical.startswith("("):
                    continue  # a size or frame note under a matrix, such as _{3×1} or _{(0)}
                raise ReadError(f"subscript '{canonical}' on an expression", span[0])
            node = self._raise_to(node, text, canonical, (start, span[1]), span)
        return node

    def _raise_to(self, node: n.Node, text: str, canonical: str, whole: tuple[int, int], span: tuple[int, int]) -> n.Node:
        if canonical == "":  # a star
            return replace(node, span=whole)
        if canonical in _OPERATORS:
            return n.Postfix(node, _OPERATORS[canonical], span=whole)
        exponent = self.parse(text, self.text.find(text, span[0]))
        if isinstance(exponent, n.Number) and exponent.value > MAX_EXPONENT:
            raise ReadError(f"the exponent {exponent.text} is larger than {MAX_EXPONENT}", span[0])
        return n.Power(node, exponent, span=whole)

    def _labelled(self, item: Item) -> n.Node:
        label: n.Node | None = None
        size: tuple[int, int] | None = None
        for kind, text, span in item.scripts:
            if found := re.fullmatch(r"\(?(\d+)x(\d+)\)?", canonical_script(text)):
                size = (int(found.group(1)), int(found.group(2)))
            elif kind in ("SUB", "SUP"):
                try:
                    label = self.parse(text, self.text.find(text, span[0]))
                except ReadError:
                    label = None
                if not isinstance(label, n.Name):
                    label = None
        assert item.node is not None
        return n.Labelled(item.node, label, size, span=(item.start, item.end))

    def _evaluated(self, item: Item) -> n.Node:
        values: list[tuple[n.Node, n.Node]] = []
        for kind, text, span in item.scripts:
            if kind != "SUB":
                continue
            offset = self.text.find(text, span[0])
            for part in re.finditer(r"((?:(?!,|\\[,;]|\\quad|\\\\|=).)+)=((?:(?!,|\\[,;]|\\quad|\\\\).)+)", text, re.DOTALL):
                sides = (self.parse(part.group(k), offset + part.start(k)) for k in (1, 2))
                values.append((next(sides), next(sides)))
        assert item.node is not None
        if not values:
            return n.Call("abs", (item.node,), "|", "bars", span=(item.start, item.end))
        return n.At(item.node, tuple(values), span=(item.start, item.end))

    # -- names -----------------------------------------------------------------------------------------------------

    def _letter_factor(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        item = items[index]
        following = items[index + 1] if index + 1 < len(items) else None
        trig = self._trig_letter(item, following)
        if trig is not None:
            return trig[0], index + trig[1]
        if item.base in ("R", "T", "D", "Tr", "Ro") and following is not None and following.kind == "list" and not item.pre:
            axis = next((canonical_script(text) for kind, text, _ in item.scripts if kind == "SUB"), "")
            if re.fullmatch(r"[xyzXYZ](_.*)?|[xyz],.*", axis) and len(item.scripts) == 1 and isinstance(following.node, n.Group):
                function = "Rot3" if item.base == "R" else "Trans"
                axis_name = n.Name(axis[0].lower(), span=item.scripts[0][2])
                head = self.text[item.start : item.end]
                call = n.Call(function, (axis_name, following.node.inner), head, "script", span=(item.start, following.end))
                return self._scripted(call, following.scripts, item.start), index + 2
        elementary = self._elementary_letter(item)
        if elementary is not None:
            return elementary, index + 1
        name = self._name(item)
        if following is not None and following.kind == "list" and not following.pre:
            applied = self._application(name, following)
            if applied is not None:
                return applied, index + 2
        return name, index + 1

    def _elementary_letter(self, item: Item) -> n.Node | None:
        """R_{z,\\theta} is the elementary rotation, 3×3."""
        subs = [script for script in item.scripts if script[0] == "SUB"]
        if item.base != "R" or item.pre or len(subs) != 1:
            return None
        _, text, span = subs[0]
        amount = self._elementary_amount(text, span)
        if amount is None or not any(isinstance(below, n.Name) and below.base in ANGLE_LETTERS for below in n.walk(amount)):
            return None
        axis = n.Name(canonical_script(text)[0].lower(), span=span)
        call = n.Call("Rot3", (axis, amount), self.text[item.start : span[1]], "script", span=(item.start, span[1]))
        return self._scripted(call, [script for script in item.scripts if script[0] != "SUB"], item.start)

    def _application(self, node: n.Node, following: Item) -> n.Node | None:
        """Read `J(q)` and `A_1(\\theta_1)` as names with arguments; `a_1(…)` stays a product."""
        if not isinstance(node, n.Name):
            return None
        group = following.node
        arguments = group.items if isinstance(group, n.Sequence) else (group.inner,) if isinstance(group, n.Group) else ()
        if arguments and node.base[:1].isupper() and node.base not in TRIG_LETTERS and all(map(_is_constant, arguments)):
            # {}^0T_3(0, 90^\\circ, 0), J(0, 0): the arm at a configuration
            span = (node.span[0], following.end)
            head = self.text[node.span[0] : node.span[1]]
            return self._scripted(n.Call("name", (node, *arguments), head, "name", span=span), following.scripts, node.span[0])
        if not all(isinstance(argument, n.Name) for argument in arguments):
            return None
        inside = ",".join(argument.key for argument in arguments)  # type: ignore[attr-defined]
        key = f"{node.key}({inside})"
        plain = all(a.base in ("q", "t", "theta", "d") or a.base in ANGLE_LETTERS for a in arguments)  # type: ignore[attr-defined]
        letter = node.base
        is_function = (letter in "fgh" and not node.sub) or (letter[:1].isupper() and letter not in "CS") or len(letter) > 1 and letter not in ANGLE_LETTERS
        if self.is_bound(key) or (is_function and (plain or letter[:1].isupper())) or (plain and inside in ("q", "t") and not self.is_bound(node.key)):
            named = n.Call(
                "name", (node, *arguments), self.text[node.span[0] : node.span[1]], "name", span=(node.span[0], following.end)
            )
            return self._scripted(named, following.scripts, node.span[0])
        if letter == "S" and not node.sub and not plain:  # S(v), the skew matrix, unless the argument is an angle
            named = n.Call("name", (node, *arguments), letter, "name", span=(node.span[0], following.end))
            return self._scripted(named, following.scripts, node.span[0])
        return None

    def _trig_letter(self, item: Item, following: Item | None) -> tuple[n.Node, int] | None:
        """c_1, C_{12}, s_{\\theta_1}, C\\theta_1, S(\\theta_1+\\theta_2): unless the document binds that name."""
        function = TRIG_LETTERS.get(item.base)
        if function is None or item.pre or any(kind == "PRIME" or kind == "DOT" for kind, _, _ in item.scripts):
            return None
        subs = [script for script in item.scripts if script[0] == "SUB"]
        sups = [script for script in item.scripts if script[0] == "SUP"]
        if subs:
            raw = subs[0][1]
            if self.is_bound(f"{item.base}_{canonical_script(raw)}"):
                return None
            argument = self._trig_index(raw, subs[0][2])
            if argument is None:
                return None
            style = "index" if isinstance(argument, n.JointAngles) else "script"
            call = n.Call(function, (argument,), item.base, style, span=(item.start, subs[0][2][1]))
            return self._scripted(call, sups, item.start), 1
        if following is None or self.is_bound(item.base):
            return None
        if following.kind == "letter" and following.base in ANGLE_LETTERS and not following.pre:
            angle = self._name(Item("letter", None, following.start, following.end, following.base, following.scripts))
            if isinstance(angle, n.Name):
                call = n.Call(function, (angle,), self.text[item.start : item.end], "letter", span=(item.start, following.end))
                return self._scripted(call, sups, item.start), 2
        group = following.node
        if following.kind in ("list", "braces", "node") and isinstance(group, n.Group) and self._is_angle(group.inner):
            call = n.Call(function, (group.inner,), self.text[item.start : item.end], "letter()", span=(item.start, following.end))
            if sups:
                call = self._scripted(call, sups, item.start)  # type: ignore[assignment]
            return self._scripted(call, following.scripts, item.start), 2
        if following.kind == "node" and isinstance(group, n.Name) and group.base in ANGLE_LETTERS:
            call = n.Call(function, (group,), self.text[item.start : item.end], "letter", span=(item.start, following.end))
            return self._scripted(call, [*sups, *following.scripts], item.start), 2
        return None

    def _trig_index(self, raw: str, span: tuple[int, int]) -> n.Node | None:
        canonical = canonical_script(raw)
        if _JOINT_DIGITS.fullmatch(canonical):
            found = re.findall(r"([+-]?),?(\d)", canonical)
            return n.JointAngles(tuple((-1 if sign == "-" else 1, int(digit)) for sign, digit in found), span=span)
        if canonical in ("i", "j", "k", "n", "i-1", "i+1", "n-1"):
            return n.Name("theta", sub=canonical, text=raw, span=span)
        spaced = re.sub(r"(\\(?:theta|alpha|beta|gamma|phi|psi|varphi))\s*([a-z0-9](?:[-+]1)?)(?![A-Za-z])", r"\1_{\2}", raw)
        if not re.search(r"\\(?:var)?(?:theta|alpha|beta|gamma|phi|psi)|^\s*q", spaced):
            return None
        try:
            angle = self.parse(spaced, span[0])
        except ReadError:
            return None
        return angle if self._is_angle(angle) else None

    def _is_angle(self, node: n.Node) -> bool:
        names = [below for below in n.walk(node) if isinstance(below, n.Name)]
        calls = any(isinstance(below, n.Call | n.Matrix) for below in n.walk(node))
        return bool(names) and not calls and all(name.base in ANGLE_LETTERS or name.base == "pi" for name in names)

    def _name(self, item: Item) -> n.Node:
        """An indexed name with its scripts; what is an operator or a power above it is applied to it."""
        pre_sub = pre_sup = ""
        for kind, text, _ in item.pre:
            if kind == "SUB":
                pre_sub = canonical_script(text)
            else:
                pre_sup = canonical_script(text)
        sub = sup = ""
        primes = dots = 0
        end = item.end if not item.scripts else item.start + max(1, len(item.base))
        above: list[Script] = []
        has_sub = any(kind == "SUB" for kind, _, _ in item.scripts)
        for kind, text, span in item.scripts:
            canonical = canonical_script(text)
            if kind == "PRIME":
                primes += len(text)
            elif kind == "DOT":
                dots += 1
            elif kind == "SUB" and _SIZE.fullmatch(canonical) and item.base not in _SIZED:
                pass  # R_{3×3}: how large it is
            elif kind == "SUB":
                sub = f"{sub},{canonical}" if sub else canonical
            elif self._is_index(item.base, canonical, sub, has_sub, bool(item.pre)):
                sup = f"{sup},{canonical}" if sup else canonical
            elif canonical == "":
                pass
            else:
                above.append((kind, text, span))
                continue
            end = max(end, span[1])
        end = max(end, item.end if not above else end)
        text = self.text[item.start : end]
        name: n.Node = n.Name(item.base, sub, sup, pre_sub, pre_sup, primes, dots, text, span=(item.start, end))
        return self._scripted(name, above, item.start)

    def _is_index(self, base: str, canonical: str, sub: str, has_sub: bool, prescripted: bool) -> bool:
        """Whether what stands above a name is part of the name (T^0_1, P^0_{1,G}) and not a power or an operator."""
        if not canonical:
            return False
        key = f"{base}_{sub}^{canonical}" if sub else f"{base}^{canonical}"
        if self.is_bound(key):
            return True
        if canonical in _OPERATORS:
            return False
        if not re.fullmatch(r"[A-Za-z0-9_,]+(?:[-+]\d)?", canonical):
            return False
        if canonical == "0":
            return True
        digits = canonical.isdigit()
        if base in TRANSFORM_LETTERS and has_sub and not prescripted:
            return True
        if base in VECTOR_LETTERS and has_sub and not prescripted:
            of_frame = sub[:1].isdigit() or bool(re.match(r"[a-zA-Z]-\d", sub))
            return not digits or (of_frame and not re.search(r"[xyzXYZ]$", sub))
        return not digits and has_sub and len(canonical) <= 3 and canonical not in ("n", "k", "m")

    def _call(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        item = items[index]
        function = item.base
        powers: list[Script] = []
        axis: n.Node | None = None
        for kind, text, span in item.scripts:
            canonical = canonical_script(text)
            if kind == "SUP" and canonical == "-1" and function in ("cos", "sin", "tan"):
                function = "a" + function
            elif kind == "SUP":
                powers.append((kind, text, span))
            elif kind == "SUB" and function in ("Rot", "Trans"):
                axis = n.Name(canonical[:1].lower(), span=span)
                amount = self._elementary_amount(text, span)
                if amount is not None:
                    head = self.text[item.start : span[1]]
                    call = n.Call(function, (axis, amount), head, "script", span=(item.start, span[1]))
                    rest = [script for script in item.scripts if script[0] != "SUB"]
                    return self._scripted(call, rest, item.start), index + 1
            elif kind == "SUB" and function in ("cos", "sin"):
                argument = self._trig_index(text, span)
                if argument is None:
                    raise ReadError(f"'{self.text[item.start : item.end]}' has no angle", item.start)
                head = self.text[item.start : span[0]]
                style = "index" if isinstance(argument, n.JointAngles) else "script"
                return self._scripted(n.Call(function, (argument,), head, style, span=(item.start, span[1])), powers, item.start), index + 1
        if index + 1 >= len(items):
            raise ReadError(f"'{self.text[item.start : item.end]}' has no argument", item.start)
        following = items[index + 1]
        head = self.text[item.start : item.end]
        if following.kind == "list" and not following.pre:
            group = following.node
            assert group is not None
            arguments = group.items if isinstance(group, n.Sequence) else (group.inner,)  # type: ignore[attr-defined]
            if function == "atan" and len(arguments) == 2:
                function = "atan2"
            if axis is not None:
                arguments = (axis, *arguments)
            call: n.Node = n.Call(function, tuple(arguments), head, "macro()", span=(item.start, following.end))
            inner_powers = following.scripts
            if inner_powers and function in ("cos", "sin", "tan", "det", "rank", "Rot", "Trans", "adj", "com", "tr"):
                call = self._scripted(call, inner_powers, item.start)
            elif inner_powers:
                call = self._scripted(call, inner_powers, item.start)
            return self._scripted(call, powers, item.start), index + 2
        argument, after = self._bare_argument(items, index + 1, function)
        call = n.Call(function, (argument,), head, "macro", span=(item.start, argument.span[1]))
        return self._scripted(call, powers, item.start), after

    def _elementary_amount(self, subscript: str, span: tuple[int, int]) -> n.Node | None:
        """Return the angle or length of Rot_{z,\\theta_i} and Trans_{x,a_i}, or None where only the axis is given."""
        parts = re.fullmatch(r"\s*[xyzXYZ]\s*(?:,|;|\\[,;: ])\s*(\S.*)", subscript, re.DOTALL)
        return self.parse(parts.group(1), self.text.find(parts.group(1), span[0])) if parts else None

    def _bare_argument(self, items: Seq[Item], index: int, function: str) -> tuple[n.Node, int]:
        """cos θ_1 takes one operand; cos 2θ_1 a number and the operand after it."""
        first = items[index]
        if function in MATRIX_FUNCTIONS:
            return self._next_factor(items, index)
        node, after = self._next_factor(items, index)
        if isinstance(node, n.Number) and after < len(items) and items[after].kind in ("letter", "node"):
            second, after = self._next_factor(items, after)
            return n.Product((node, second), ("",), span=(first.start, second.span[1])), after
        return node, after


def _is_constant(node: n.Node) -> bool:
    """Whether a tree is made of numbers, π and degrees alone."""
    return all(
        isinstance(below, n.Number | n.Sum | n.Product | n.Quotient | n.Group)
        or (isinstance(below, n.Postfix) and below.operator == "deg")
        or (isinstance(below, n.Name) and below.key == "pi")
        for below in n.walk(node)
    )


def _node_item(node: n.Node) -> Item:
    return Item("node", node, *node.span)


def _pre_of(name: n.Name, span: tuple[int, int]) -> list[Script]:
    found: list[Script] = []
    if name.pre_sub:
        found.append(("SUB", name.pre_sub, span))
    if name.pre_sup:
        found.append(("SUP", name.pre_sup, span))
    return found


def _span(items: Seq[n.Node]) -> tuple[int, int]:
    return (items[0].span[0], items[-1].span[1])


def _argument_end(text: str, end: int) -> int:
    """The end of a command whose last argument's content ends at `end`: behind its closing brace."""
    found = re.compile(r"\s*\}").match(text, end)
    return found.end() if found else end


def _attach_trailing(items: list[Item]) -> list[Item]:
    result: list[Item] = []
    for item in items:
        if item.kind == "trailing":
            result[-1].scripts.extend(item.scripts)
            result[-1].end = item.end
        else:
            result.append(item)
    return result


def _reassociate(items: list[Item]) -> list[Item]:
    """Glued pre-scripts: in ^0_1T^1_2T and ^0T_1^1T_2 what follows a T that has its own belongs to the next T."""
    for here, following in zip(items, items[1:], strict=False):
        if not here.pre or here.kind != "letter" or following.kind != "letter" or following.pre:
            continue
        kinds = {kind for kind, _, _ in here.pre}
        keep: list[Script] = []
        move: list[Script] = []
        for script in here.scripts:
            index_like = canonical_script(script[1]) not in _OPERATORS and script[0] in ("SUB", "SUP")
            own = script[0] not in kinds and not any(kept[0] == script[0] for kept in keep) and not (len(kinds) == 2)
            if index_like and (move or not own or (script[0] == "SUP")):
                move.append(script)
            else:
                keep.append(script)
        if move:
            here.scripts, following.pre = keep, move
            here.end = keep[-1][2][1] if keep else move[0][2][0]
            following.start = move[0][2][0]
    return items
