"""The expression tree: what a display says, with every node's place in the LaTeX.

The tree keeps the notation (which spelling of a cosine, which brackets), so that a term can be written back in the
document's own hand; what the names mean is decided later, against an arm.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from functools import cache
from itertools import chain
from typing import Any, TypeGuard


class _Walked:
    """Keeps the nodes below one that was walked, the names and letters in them, which stands above which, and a name's key: a tree never changes."""

    __slots__ = ("_key", "_letters", "_names", "_parents", "_walked")
    _key: str
    _letters: frozenset[str]
    _names: tuple[Name, ...]
    _parents: dict[int, Node | None]
    _walked: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Node(_Walked):
    """One node; `span` is its place in the display and does not count in comparisons."""

    span: tuple[int, int] = field(default=(0, 0), compare=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A non-negative rational number as written: 2, 0.75, 1/2 is a Quotient."""

    value: Fraction
    text: str = field(default="", compare=False)

    @property
    def decimals(self) -> int:
        """How many digits stand behind its point or comma."""
        return len(self.text.replace("{,}", ".").partition(".")[2])


@dataclass(frozen=True, slots=True)
class Name(Node):
    """An indexed name: `{}^{pre_sup}_{pre_sub} base' _{sub}^{sup}`, all in canonical text; dots are time derivatives."""

    base: str
    sub: str = ""
    sup: str = ""
    pre_sub: str = ""
    pre_sup: str = ""
    primes: int = 0
    dots: int = 0
    text: str = field(default="", compare=False)

    @property
    def key(self) -> str:
        """The name as front matter spells it: `J'_P`, `theta_1`, `{}^0T_1`, `T^0_1`."""
        try:
            return self._key
        except AttributeError:
            object.__setattr__(self, "_key", self._spelt())
            return self._key

    @property
    def undotted(self) -> Name:
        """The name whose rate it may be: x of x-dot."""
        return replace(self, dots=0) if self.dots else self

    @property
    def scripts(self) -> tuple[str, str, str, str]:
        """Its indices: below, above, and those before it, below and above."""
        return self.sub, self.sup, self.pre_sub, self.pre_sup

    def _spelt(self) -> str:
        front = ""
        if self.pre_sup or self.pre_sub:
            front = "{}" + (f"^{self.pre_sup}" if self.pre_sup else "") + (f"_{self.pre_sub}" if self.pre_sub else "")
        dots = "dot" * self.dots + " " if self.dots else ""
        return (
            f"{front}{dots}{self.base}{chr(39) * self.primes}"
            + (f"_{self.sub}" if self.sub else "")
            + (f"^{self.sup}" if self.sup else "")
        )


@dataclass(frozen=True, slots=True)
class JointAngles(Node):
    """The angle named by the digits of c_{12}: the signed sum of those joints' angles."""

    terms: tuple[tuple[int, int], ...]  # (sign, joint index)


@dataclass(frozen=True, slots=True)
class Call(Node):
    """A known function of arguments; `style` says how it is written.

    style: "macro" (\\cos\\theta_1), "macro()" (\\cos(…)), "index" (c_{12}), "letter" (C\\theta_1), "letter()" (C(…)),
    "script" (c_{\\theta_1}); `head` is the LaTeX of the function itself.
    """

    function: str
    arguments: tuple[Node, ...]
    head: str = field(default="", compare=False)
    style: str = field(default="macro()", compare=False)


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Signed terms; a sign is "+", "-", "±" or "∓"."""

    terms: tuple[tuple[str, Node], ...]


@dataclass(frozen=True, slots=True)
class Product(Node):
    """Factors and the operator before each but the first: "" (juxtaposed), "⋅", "×" (product or cross product)."""

    factors: tuple[Node, ...]
    operators: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Quotient(Node):
    """A fraction; style "frac" or "slash"."""

    numerator: Node
    denominator: Node
    style: str = field(default="frac", compare=False)


@dataclass(frozen=True, slots=True)
class Ambiguous(Node):
    """a/2b: both readings, the likelier first; which of them is meant is decided against the arm.

    The sort is what is unclear: a "slash", a "label" that numbers the equation or is a factor, a "mixed" number or a product,
    or whether \\tan\\theta/2 is of "half" the angle.
    """

    readings: tuple[Node, Node]
    text: str = field(default="", compare=False)
    sort: str = field(default="slash", compare=False)


@dataclass(frozen=True, slots=True)
class Power(Node):
    """base^exponent, the exponent a number or a scalar expression."""

    base: Node
    exponent: Node


@dataclass(frozen=True, slots=True)
class Postfix(Node):
    """operator "T" (transpose), "-1" (inverse), "-T", "+" (pseudo-inverse) or a unit: "deg", "cm", "mm"."""

    base: Node
    operator: str


@dataclass(frozen=True, slots=True)
class Group(Node):
    """Brackets around an expression: "()", "[]" or "{}" (braces, which do not print)."""

    inner: Node
    brackets: str = "()"


@dataclass(frozen=True, slots=True)
class Sequence(Node):
    """A bracketed list (a, b, c): arguments, a row of a vector, a set or an interval."""

    items: tuple[Node, ...]
    brackets: str = "()"


@dataclass(frozen=True, slots=True)
class Matrix(Node):
    """Rows of cells; `environment` as written. Cells may themselves be matrices (blocks)."""

    rows: tuple[tuple[Node, ...], ...]
    environment: str = "bmatrix"

    @property
    def cells(self) -> tuple[Node, ...]:
        """Its cells, row by row."""
        return tuple(chain.from_iterable(self.rows))


@dataclass(frozen=True, slots=True)
class Derivative(Node):
    """∂(operand)/∂(variable), or d/dt where the variable is t."""

    operand: Node
    variable: Node
    order: int = 1


@dataclass(frozen=True, slots=True)
class Labelled(Node):
    """An under- or overbrace: the expression and its label, where that reads as a formula or as a size such as 6×n."""

    inner: Node
    label: Node | None
    size: tuple[int, int] | None = None
    unread: str = ""


@dataclass(frozen=True, slots=True)
class At(Node):
    """An expression at a configuration: J|_{θ_2 = 0}."""

    inner: Node
    values: tuple[tuple[Node, Node], ...]


@dataclass(frozen=True, slots=True)
class Cases(Node):
    """A brace of alternatives; each branch is a value and the words or relations of its condition."""

    branches: tuple[tuple[Node, str], ...]


@dataclass(frozen=True, slots=True)
class Dots(Node):
    """An ellipsis: the expression goes on in a way the reader is left to see."""


@dataclass(frozen=True, slots=True)
class Layout(Node):
    """Lines of relations inside an environment: `aligned`, or an array that holds equations."""

    statements: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Chain(Node):
    """members[0] relations[0] members[1] …: one equation a relation."""

    members: tuple[Node, ...]
    relations: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Connective(Node):
    """What stands between statements: "⇒", "⇔", "⇐", "or", "and", or words."""

    kind: str
    text: str = ""


Statement = Chain | Connective


def children(node: Node) -> list[Node]:
    """Return the nodes directly below."""
    below: list[Node] = []
    for name in _branching(type(node)):  # type: ignore[arg-type]
        value = getattr(node, name)
        if isinstance(value, Node):
            below.append(value)
        elif isinstance(value, tuple):
            _collect(value, below)
    return below


@cache
def _branching(kind: Any) -> tuple[str, ...]:
    """The fields of a class that may hold nodes."""
    plain = (
        "str", "int", "Fraction", "tuple[int, int]", "tuple[int, int] | None", "tuple[tuple[int, int], ...]", "tuple[str, ...]",
    )  # fmt: skip
    return tuple(spec.name for spec in fields(kind) if spec.type not in plain)


def _collect(values: tuple[object, ...], found: list[Node]) -> None:
    for item in values:
        if isinstance(item, Node):
            found.append(item)
        elif isinstance(item, tuple):
            _collect(item, found)


def walk(node: Node) -> Iterator[Node]:
    """Yield the node and all below it, depth first."""
    try:
        return iter(node._walked)
    except AttributeError:
        object.__setattr__(node, "_walked", tuple(_below(node)))
        return iter(node._walked)


def names(node: Node) -> tuple[Name, ...]:
    """Return the names in a tree, depth first."""
    try:
        return node._names
    except AttributeError:
        object.__setattr__(node, "_names", tuple(below for below in walk(node) if isinstance(below, Name)))
        return node._names


def letters(node: Node) -> frozenset[str]:
    """Return the letters of the names in a tree, without indices and accents: what a rule never speaks of, it is not asked about."""
    try:
        return node._letters
    except AttributeError:
        object.__setattr__(node, "_letters", frozenset(each.base for each in names(node)))
        return node._letters


def _below(node: Node) -> Iterator[Node]:
    stack = [node]
    while stack:
        top = stack.pop()
        yield top
        stack.extend(reversed(children(top)))


def ungrouped(node: Node) -> Node:
    """Return a tree without the brackets around it."""
    while isinstance(node, Group):
        node = node.inner
    return node


def bare(node: Node) -> Node:
    """Return a tree without the brackets and braces around it."""
    while isinstance(node, Group | Labelled):
        node = node.inner
    return node


def unapplied(node: Node) -> Node:
    """Return what a name applied to arguments is without them: q of q(t)."""
    return node.arguments[0] if isinstance(node, Call) and node.function == "name" else node


def plain_name(node: Node) -> Name | None:
    """Return the name that a node is, without its dots and arguments, or None."""
    node = unapplied(bare(node))
    return node.undotted if isinstance(node, Name) and node.base not in ("words", "=") else None


def bare_key(node: Node) -> str | None:
    """Return the key of a node that is one name, whatever brackets stand around it."""
    node = bare(node)
    if isinstance(node, Name):
        return node.key if node.base not in ("words", "=") else None
    if isinstance(node, Call) and node.function == "name":
        _, *arguments = node.arguments
        return call_key(node) if is_nought(arguments) or all(isinstance(a, Name) for a in arguments) else None
    return None


def is_nought(arguments: tuple[Node, ...] | list[Node]) -> bool:
    """Whether a name is applied to 0 alone: g_{st}(0), the reference configuration."""
    return len(arguments) == 1 and isinstance(arguments[0], Number) and arguments[0].value == 0


def is_number(node: Node) -> bool:
    """Whether a tree is made of numbers, π and functions of them."""
    return not any(
        isinstance(below, JointAngles | Matrix | Sequence) or (isinstance(below, Name) and below.key != "pi")
        for below in walk(node)
    )


def has_rates(node: Node) -> bool:
    """Whether the derivative of a name by time stands in a tree: \\dot q_1."""
    return any(isinstance(below, Name) and below.dots > 0 for below in walk(node))


def interval_of(relation: str, node: Node) -> Sequence | None:
    """Return the interval that stands behind ∈, (0, π) or [0, π]; a set in braces is none."""
    is_list = relation == "∈" and isinstance(node, Sequence) and len(node.items) == 2
    return node if is_list and isinstance(node, Sequence) and node.brackets != "{}" else None


def call_key(node: Call) -> str:
    """Return the key of a name with arguments: J(q)."""
    name, *arguments = node.arguments
    head = name.key if isinstance(name, Name) else "?"
    return f"{head}({'0' if is_nought(arguments) else ','.join(a.key for a in arguments if isinstance(a, Name))})"


ARCS = ("acos", "asin", "atan", "atan2")


def is_call(node: Node | None, *functions: str) -> TypeGuard[Call]:
    """Whether a node is a call of one of these functions."""
    return isinstance(node, Call) and node.function in functions


def is_rank(node: Node) -> TypeGuard[Call]:
    """Whether a node is the rank of something."""
    return is_call(node, "rank")


def has_arcs(node: Node) -> bool:
    """Whether an arc function stands in a tree."""
    return any(is_call(below, *ARCS) for below in walk(node))


def has_branches(node: Node) -> bool:
    """Whether ± or ∓ stands in a tree."""
    return any(sign in "±∓" for below in walk(node) if isinstance(below, Sum) for sign, _ in below.terms)


def substitute(node: Node, old: Node, new: Node) -> Node:
    """Return the tree with the very node `old` (by identity) replaced."""
    parents = _parents(node)
    while old is not node:
        parent = parents.get(id(old), old)
        if parent is old:
            return node
        if parent is None:  # one node in several places
            return substitute_each(node, {id(old): new})
        changes: dict[str, Any] = {name: _put(getattr(parent, name), old, new) for name in _branching(type(parent))}  # type: ignore[arg-type]
        old, new = parent, replace(parent, **changes)
    return new


def _parents(root: Node) -> dict[int, Node | None]:
    """Return the node right above each one below, by its identity; None above one that stands in several places."""
    try:
        return root._parents
    except AttributeError:
        parents: dict[int, Node | None] = {}
        for above in walk(root):
            for below in children(above):
                parents[id(below)] = None if id(below) in parents else above
        object.__setattr__(root, "_parents", parents)
        return parents


def _put(value: object, old: Node, new: Node) -> object:
    """Return what a field holds with a node replaced, not below those that it holds."""
    if value is old:
        return new
    return tuple(_put(item, old, new) for item in value) if isinstance(value, tuple) else value


def substitute_each(node: Node, new: Mapping[int, Node]) -> Node:
    """Return the tree with very nodes replaced, which are named by their identity, in one pass."""
    if (found := new.get(id(node))) is not None:
        return found
    changes: dict[str, Any] = {}
    for name in _branching(type(node)):  # type: ignore[arg-type]
        before = getattr(node, name)
        after = _substitute_in(before, new)
        if after is not before:
            changes[name] = after
    return replace(node, **changes) if changes else node


def placed(node: Node, span: tuple[int, int]) -> Node:
    """Return a tree all of whose nodes have one place: what they stand for is written there."""
    changes = {name: _placed_in(getattr(node, name), span) for name in _branching(type(node))}  # type: ignore[arg-type]
    return replace(node, span=span, **changes)


def _placed_in(value: Any, span: tuple[int, int]) -> Any:
    if isinstance(value, Node):
        return placed(value, span)
    return tuple(_placed_in(item, span) for item in value) if isinstance(value, tuple) else value


def _substitute_in(value: object, new: Mapping[int, Node]) -> object:
    if isinstance(value, Node):
        return substitute_each(value, new)
    if isinstance(value, tuple):
        items = tuple(_substitute_in(item, new) for item in value)
        return items if any(a is not b for a, b in zip(items, value, strict=True)) else value
    return value
