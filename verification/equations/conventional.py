"""Names that only convention binds: which of their usual meanings fits what they are equated to, and how sure that is.

Such a name is a claim where a usual meaning is exactly what it is equated to, or a slip away from it. Otherwise nobody can
tell whether the author is wrong or means something else: the equation is not decided, and the name keeps its own meaning.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import as_line, kind_of
from armproof.verification.equations.alignment import (
    Pair,
    agree_exactly,
    align,
    different_entries,
    exactly_equal,
    is_constant,
    is_near,
    square_rows,
)
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import SecondRoute
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import EvaluationError, TooComplex, UnboundName
from armproof.verification.evaluation.blocks import partition
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, has_branches
from armproof.verification.naming.conventions import LETTERS, applied, conventional, is_usual
from armproof.verification.verdict import Verdict

ENTRIES = frozenset("rnoa")  # letters of a rotation's entries: in a matrix they mean what stands in their place
MOST_ROWS = 3  # of a Jacobian whose determinant is only looked for
POINTS, INDEXED = frozenset("OPAEC"), frozenset("pPoOdRJvz")


class Conventions:
    """Binds what notation and front matter leave open, one chain at a time.

    Attributes:
        weak: the names that stand inside formulas of the chain and were bound.
        open: the names that have a usual meaning, and were equated to something else.
    """

    def __init__(self, members: Members, route: SecondRoute) -> None:
        self.members = members
        self.names = members.names
        self.route = route
        self.weak: set[str] = set()
        self.open: dict[str, Quantity] = {}

    def read(self, chain: n.Chain) -> n.Chain:
        """Return a chain whose sides are names where they are spelt otherwise: O_0O_2, p_e(θ), p^1_2."""
        if self.names.arm is None:
            return chain
        self.weak, self.open = set(), {}
        keys = {_plain_key(member) for member in chain.members}
        self._forget(keys & self.names.state.conventional)
        for key in filter(self._usual, keys):
            self.names.state.definitions.pop(key, None)
        members = (self._as_name(self._with_arrows(member)) for member in chain.members)
        return replace(chain, members=tuple(members)) if len(chain.members) > 1 else chain

    def _with_arrows(self, node: n.Node) -> n.Node:
        """Two points in braces are what stands under an arrow."""
        for below in [*n.walk(node)]:
            if (
                isinstance(below, n.Group)
                and below.brackets == "{}"
                and (name := self._between(below.inner)) is not None
            ):
                node = n.substitute(node, below, name)
        return node

    def _between(self, node: n.Node) -> n.Name | None:
        if not isinstance(node, n.Product) or len(node.factors) != 2 or node.operators != ("",):
            return None
        first, second = node.factors
        if not (isinstance(first, n.Name) and isinstance(second, n.Name)):
            return None
        if not (self._is_point(first) and self._is_point(replace(second, pre_sup=""))):
            return None
        start, end = (first.sub or (first.base if first.base != "O" else self._base)), second.sub or second.base
        between = n.Name("O", f"{start}to{end}", pre_sup=second.pre_sup, span=node.span)
        assert self.names.arm is not None
        return between if conventional(between, self.names.arm, self.names.transforms) else None

    def _is_point(self, name: n.Name) -> bool:
        """Whether a letter may be a point of a figure: it is no matrix A_1, and the document gives it no value."""
        placed = name.sup or name.pre_sub or name.pre_sup or name.primes or name.dots
        if name.base not in POINTS or placed or name.key in self.names.state.definitions:
            return False
        quantity = self.names.quantity(name)
        return self.names.known_symbol(name.key) is None and (quantity is None or quantity.kind == "origin")

    def _as_name(self, node: n.Node) -> n.Node:
        inner = bare(node)
        if (
            isinstance(inner, n.Name)
            and len(inner.key) == 2
            and set(inner.key) <= POINTS
            and self._is_open(inner, inner)
        ):
            points = tuple(n.Name(letter, span=node.span) for letter in inner.base)
            return self._between(n.Product(points, ("",), span=node.span)) or node
        if isinstance(inner, n.Power) and isinstance(inner.base, n.Name) and isinstance(inner.exponent, n.Number):
            name, index = inner.base, str(inner.exponent.value)
            assert self.names.arm is not None
            placed = name.base in INDEXED and name.sub and not name.pre_sup and index in self.names.arm.frames
            return replace(name, sup=index) if placed else node
        if (between := self._between(inner)) is not None:
            return between
        if not isinstance(inner, n.Product) or len(inner.factors) != 2 or inner.operators != ("",):
            return node
        first, second = inner.factors
        if not isinstance(first, n.Name):
            return node
        if isinstance(second, n.Group | n.Sequence) and not self.members.evaluate(first).known:
            arguments = second.items if isinstance(second, n.Sequence) else (second.inner,)
            if all(self._is_configuration(argument) for argument in arguments):
                return first
        return node

    @property
    def _base(self) -> str:
        assert self.names.arm is not None
        return self.names.arm.frames[0]

    def _is_configuration(self, node: n.Node) -> bool:
        return isinstance(node, n.Name) and (node.key in ("q", "theta", "Theta") or self.members.is_symbol(node))

    def bind(self, members: list[Member]) -> list[Member]:
        """Return the members with those bound whose names have a usual meaning that fits."""
        if self.names.arm is None:
            return members
        members = [self._bound_inside(member) for member in members]
        known = [member for member in members if member.known]
        if len(known) > 1:
            members = [self._height(member, [m for m in known if m is not member]) for member in members]
        if not known:
            known = [member for member in members if isinstance(member.problem, OutsideAlgebra)]
        return [self._bound(member, known) for member in members]

    def _height(self, member: Member, others: list[Member]) -> Member:
        """z_4 beside a scalar is no axis where it is the coordinate of the frame's origin."""
        name = member.node
        if not isinstance(name, n.Name) or name.base not in "zZ" or name.dots or not isinstance(member.value, Matrix):
            return member
        axis = self.names.quantity(name)
        if axis is None or name.key in (*self.names.quantities, *self.names.state.definitions):
            return member
        tried = self._tried(name, name, replace(axis, kind="origin", rows=(3,), scalar=True))
        pairs = [self._closest(tried, other) for other in others]
        if any(pair is not None and not is_constant(pair.printed) and self._agree(tried, other, pair)
               for pair, other in zip(pairs, others, strict=True)):  # fmt: skip
            return tried
        self._forget({name.key})
        return member

    def _bound_inside(self, member: Member) -> Member:
        """A formula's coordinates and points are those of the tool, where they can hardly be anything else."""
        if not isinstance(member.problem, UnboundName) or _plain(member.node) is not None:
            return member
        if isinstance(bare(member.node), n.Matrix):
            return member
        added: set[str] = set()
        for below in n.walk(member.node):
            name = _plain(below)
            if name is None or not is_usual(name) or not self._is_open(below, name):
                continue
            quantities = self._candidates(below, name)
            if quantities and quantities[0].frame != self._base:
                self._infer(name.key, quantities[0])
                added.add(name.key)
        bound = self.members.evaluate(member.node) if added else member
        if not added or not (bound.known or isinstance(bound.problem, OutsideAlgebra)):
            self._forget(added)
            return member
        self.weak |= added
        return bound

    def _bound(self, member: Member, known: list[Member]) -> Member:
        name = _plain(member.node)
        if not isinstance(member.problem, UnboundName):
            return member
        if name is None:
            return self._with_entries(member, known)
        near, usual = None, self._usual(name.key)
        for quantity in self._candidates(member.node, name):
            tried = self._tried(member.node, name, quantity)
            for other in known if tried.known else ():
                pair = self._closest(tried, other)
                if pair is None and not isinstance(other.problem, OutsideAlgebra):
                    continue
                if self._agree(tried, other, pair):
                    self.names.state.usual[name.key, self.names.state.section] = quantity
                    return tried
                if pair is not None and is_usual(name) and not is_constant(pair.printed):
                    self.open.setdefault(name.key, quantity)
                    may_be_near = quantity == usual or quantity.kind != "angle"
                    near = near or (quantity if may_be_near and is_near(pair) else None)
        self._forget({name.key})
        if near is None or (near != usual and self._is_of_another(known)):
            return member
        self.open.pop(name.key, None)
        return self._tried(member.node, name, near)

    def _with_entries(self, member: Member, known: list[Member]) -> Member:
        """[x; y] = …: each entry that is a name by itself, by the entry that stands in its place."""
        node = bare(member.node)
        value = known[0].value if known else None
        blocks = partition(node.rows, value.shape) if isinstance(node, n.Matrix) and isinstance(value, Matrix) else None
        if blocks is None or not isinstance(value, Matrix):
            return member
        for block in blocks:
            cell = self.members.evaluate(block.cell)
            name = _plain(block.cell)
            if name is not None and not cell.known and name.base not in ENTRIES:
                bound = self._bound(cell, [Member(known[0].node, block.of(value))])
                if bound.known and known[0].rank > 1:  # its place in a matrix of the arm tells it, not convention
                    self.names.state.conventional.discard(name.key)
        return self.members.evaluate(member.node)

    def _tried(self, node: n.Node, name: n.Name, quantity: Quantity) -> Member:
        self._infer(name.key, quantity)
        try:
            return self.members.evaluate(node)
        except TooComplex:
            return Member(node)

    def _infer(self, key: str, quantity: Quantity) -> None:
        self.names.state.inferred[key] = quantity
        self.names.state.conventional.add(key)

    def _forget(self, keys: set[str]) -> None:
        for key in keys:
            self.names.state.inferred.pop(key, None)
            self.names.state.conventional.discard(key)

    def _usual(self, key: str) -> Quantity | None:
        """Return what an equation under this heading has shown a name to be, as convention says."""
        return self.names.state.usual.get((key, self.names.state.section))

    def _is_open(self, node: n.Node, name: n.Name) -> bool:
        state = self.names.state
        taken = name.key in self.names.quantities or name.key in state.definitions or name.key in state.inferred
        return not taken and self.names.known_symbol(name.key) is None and self.names.quantity(name) is None

    def _candidates(self, node: n.Node, name: n.Name) -> tuple[Quantity, ...]:
        arm = self.names.arm
        if arm is None or name.base not in LETTERS or not self._is_open(node, name):
            return ()
        found = conventional(name, arm, self.names.transforms)
        if isinstance(bare(node), n.Call):
            found = tuple(dict.fromkeys((*found, *applied(name, arm))))
        return tuple(each for quantity in found if (each := self._with_rows(quantity)) is not None)

    def _with_rows(self, quantity: Quantity) -> Quantity | None:
        """A determinant and a manipulability are those of the rows in which J is printed, or that make it square."""
        if quantity.kind not in ("determinant", "manipulability"):
            return quantity
        whole = self.members.exact.jacobian(quantity.frame, quantity.reference)
        square = square_rows(whole)
        rows = self.names.rows_of("J") or (tuple(row + 1 for row in square) if square is not None else None)
        return replace(quantity, rows=rows) if rows is not None and len(rows) <= MOST_ROWS else None

    def _closest(self, tried: Member, other: Member) -> Pair | None:
        """Return the readings of both in one shape that differ in the fewest entries, or None."""
        if not other.known:
            return None
        try:
            pairs = list(align(tried.value, other.value, self.members.exact))
        except TooComplex:
            raise
        except EvaluationError:
            return None
        return min(pairs, key=lambda pair: len(different_entries(pair, exactly_equal)), default=None)

    def _agree(self, tried: Member, other: Member, pair: Pair | None) -> bool:
        if pair is not None and agree_exactly(pair):
            return True
        if pair is not None and not has_branches(other.node) and not self.members.exact.ring.signs_chosen:
            return False
        if isinstance(tried.value, Matrix):
            return False
        problem = EvaluationError(say(Kind.ABSOLUTE_VALUE))
        return self.route.confirm_only(tried.node, other.node, 1, False, problem).verdict is Verdict.CONFIRMED

    def _is_of_another(self, known: list[Member]) -> bool:
        """Whether the value is exactly that of another frame: a wrist, an elbow under a name that the tool's has elsewhere."""
        values = [member.value for member in known if isinstance(member.value, Matrix)]
        return any(self._equals(quantity, value) for value in values for quantity in self._others())

    def _others(self) -> Iterator[Quantity]:
        assert self.names.arm is not None
        for kind in ("origin", "rotation", "pose"):
            for frame in self.names.arm.frames[1:]:
                yield Quantity(kind, frame, self._base)

    def _equals(self, quantity: Quantity, value: Matrix) -> bool:
        whole = self.members.exact.quantity(quantity)
        same = isinstance(whole, Matrix) and whole.shape == value.shape
        return same and agree_exactly(Pair(whole, value))

    def judge(self, outcome: Outcome) -> Outcome:
        """Leave undecided what rests on a usual meaning that does not fit."""
        if outcome.verdict is Verdict.DEFINED and (named := set(outcome.defines) & set(self.open)):
            key = min(named)
            return replace(outcome, verdict=Verdict.UNCHECKED, findings=(self._finding(key, self.open[key]),))
        if outcome.verdict is not Verdict.REFUTED:
            return outcome
        if (meant := self._defined_otherwise(outcome)) is not None:
            return outcome.left_open(meant)
        if outcome.pair is not None and is_near(outcome.pair):
            return outcome
        if self._holds_numbers_for_lengths(outcome):
            return outcome.left_open(say(Kind.NUMBERS_FOR_LENGTHS))
        if outcome.true is not None and _is_placed_above(outcome.true.node):  # p_0^2 may place frame 2 in frame 0
            return outcome.left_open(say(Kind.WHICH_INDEX))
        if not self.weak:
            return outcome
        key = min(self.weak)
        quantity = self.names.state.inferred.get(key)
        self._forget(self.weak)
        finding = self._finding(key, quantity) if quantity is not None else say(Kind.NOT_BOUND, name=key)
        return outcome.left_open(finding)

    def _defined_otherwise(self, outcome: Outcome) -> Finding | None:
        """A name that the document gave another meaning is exactly what it usually is: nobody can tell which is meant."""
        name = _plain(outcome.true.node) if outcome.true is not None else None
        definition = self.names.state.definitions.get(name.key) if name is not None else None
        arm = self.names.arm
        if name is None or definition is None or arm is None or outcome.printed is None:
            return None
        for quantity in filter(None, map(self._with_rows, conventional(name, arm, self.names.transforms))):
            usual = Member(name, self.members.exact.quantity(quantity))
            if (pair := self._closest(usual, outcome.printed)) is not None and agree_exactly(pair):
                return say(Kind.SECOND_MEANING, name=name.key, line=definition.line)
        return None

    def _holds_numbers_for_lengths(self, outcome: Outcome) -> bool:
        """Whether decimals stand where the arm has lengths to which the document gives no values: det J_v = 0.15 s_2."""
        if outcome.true is None or outcome.printed is None or outcome.true.rank < 3:
            return False
        lengths = set(self.names.arm.lengths) if self.names.arm is not None else set()
        printed = [*n.walk(outcome.printed.node)]
        if not any(isinstance(each, n.Number) and each.decimals for each in printed):
            return False
        symbols = {self.names.known_symbol(each.key) for each in printed if isinstance(each, n.Name)}
        return not symbols & lengths and not lengths & self.names.state.configuration.keys()

    def _finding(self, key: str, quantity: Quantity) -> Finding:
        reading, line = kind_of(quantity).tell(quantity), as_line(key, quantity)
        return say(Kind.NOT_AS_USUAL_BOUND, name=key, reading=reading, line=line)


def _plain(node: n.Node) -> n.Name | None:
    """Return the name that a node is, without its dots and arguments, or None."""
    node = bare(node)
    if isinstance(node, n.Call) and node.function == "name" and isinstance(node.arguments[0], n.Name):
        node = node.arguments[0]
    return replace(node, dots=0) if isinstance(node, n.Name) and node.base not in ("words", "=") else None


def _plain_key(node: n.Node) -> str:
    name = _plain(node)
    return name.key if name is not None else ""


def _is_placed_above(node: n.Node) -> bool:
    return isinstance(node, n.Name) and node.base in "pPoOd" and node.sup.isdigit() and node.sub.isdigit()
