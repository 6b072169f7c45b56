"""Names that only convention binds: which of their usual meanings fits what they are equated to, and how sure that is.

Such a name is a claim where a usual meaning is exactly what it is equated to, or a slip away from it. Otherwise nobody can
tell whether the author is wrong or means something else: the equation is not decided, and the name keeps its own meaning.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property
from operator import is_

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.accelerations import LETTERS as ACCELERATIONS
from armproof.verification.equations.accelerations import with_accelerations
from armproof.verification.equations.alignment import (
    Pair,
    agree_exactly,
    is_constant,
    is_near,
)
from armproof.verification.equations.at_stated_values import MANY, is_led_to, is_mostly_right
from armproof.verification.equations.by_size import BySize
from armproof.verification.equations.coordinates import coordinates_among, height_among
from armproof.verification.equations.derived_functions import with_coordinates_derived
from armproof.verification.equations.doubts import Doubts
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.jacobian_columns import columns_beside_rates
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.placed_axes import with_axes_placed
from armproof.verification.equations.rates import SPEAKS_OF_RATES, seen_from_frame, stand_for_scalars, with_joint_rates
from armproof.verification.equations.sides import Member
from armproof.verification.equations.spellings import POINTS, Spellings
from armproof.verification.equations.usual_judge import UsualJudge
from armproof.verification.equations.usual_meanings import UsualMeanings
from armproof.verification.errors import EvaluationError, ShapeError, TooComplex, UnboundName
from armproof.verification.evaluation.blocks import partition, rows_of_letters, written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, has_branches, is_number
from armproof.verification.naming.conventions import (
    ENTRIES,
    LINEAR_VELOCITIES,
    is_usual,
)
from armproof.verification.verdict import Verdict

_MEASURES = ("manipulability", "determinant")


class Conventions:
    """Binds what notation and front matter leave open, one chain at a time."""

    def __init__(self, equality: Equality) -> None:
        self.equality = equality
        self.members = equality.members
        self.names = equality.names
        self.doubts = Doubts(self.names)
        self.before: dict[str, Quantity] = {}  # what names that stand alone in the chain meant

    @cached_property
    def meanings(self) -> UsualMeanings:
        """Tells what names that only convention binds may mean; made where one is met."""
        return UsualMeanings(self.members)

    @cached_property
    def _judge(self) -> UsualJudge:
        return UsualJudge(self.equality)

    @cached_property
    def spellings(self) -> Spellings:
        """Reads names that are spelt otherwise; made where one is met."""
        return Spellings(self.members)

    def read(self, chain: n.Chain) -> n.Chain:
        """Return a chain whose sides are names where they are spelt otherwise: O_0O_2, p_e(θ), p^1_2."""
        if self.names.arm is None:
            return chain
        self.doubts = Doubts(self.names)
        keys = set(map(_plain_key, chain.members))
        known = keys & self.names.state.conventional
        self.before = {key: self.names.state.inferred[key] for key in known if key in self.names.state.inferred}
        self.names.state.forget_usual(known)  # a name that stands alone is asked anew
        for key in filter(self.meanings.usual, keys) if self.names.state.usual else ():
            self.names.state.definitions.pop(key, None)
        self.take_coordinates(chain.members)
        if (height := height_among(self.names, chain.members)) is not None:
            self.names.state.infer_usual(*height)
        members = (self.spellings.read(each) if _is_spelt(each) else each for each in chain.members)
        read = with_axes_placed(replace(chain, members=tuple(members)), self.names)
        read = with_accelerations(read, self.names, self.members.exact) if n.letters(read) & ACCELERATIONS else read
        read = with_coordinates_derived(read, self.names) if "f" in n.letters(read) else read
        return with_joint_rates(seen_from_frame(read), self.names) if n.letters(read) & SPEAKS_OF_RATES else read

    def take_coordinates(self, nodes: Iterable[n.Node], *, beside: bool = True) -> bool:
        """Take names for coordinates that were vectors before, where one may be, and say whether there are such."""
        found = coordinates_among(self.names, nodes, beside=beside) if self.names.state.conventional else {}
        for key, quantity in found.items():
            self.names.state.infer_usual(key, quantity)
        return bool(found)

    def bind(self, members: list[Member]) -> list[Member]:
        """Return the members with those bound whose names have a usual meaning that fits."""
        if self.names.arm is None:
            return members
        members = self._all_bound_inside(members)
        known = [member for member in members if member.known]
        if not _fit_together(members):
            members = BySize(self.members, self.doubts).read(members)
            known = [member for member in members if member.known]
        if not known:
            members, known = self._as_shown(members)
        if not known:
            members, known = self._of_letters(members)
        if not known:
            known = [member for member in members if isinstance(member.problem, OutsideAlgebra)]
        return [self._bound(member, known) for member in members]

    def _as_shown(self, members: list[Member]) -> tuple[list[Member], list[Member]]:
        """h = WC: a name alone beside nothing that is known is what an equation under this heading has shown it to be.

        Or what equations under others have, if that is always the same and what convention says first: B = p_z in a summary.
        """
        for place, member in enumerate(members):
            name = n.plain_name(member.node)
            usual = (
                self.meanings.shown(member.node, name)
                if name is not None and isinstance(member.problem, UnboundName)
                else None
            )
            if name is not None and usual is not None and self.names.is_open(name):
                shown = self._tried(member.node, name, usual)
                others = [each if each is member else self.members.evaluate(each.node) for each in members]
                others[place] = shown
                return others, [each for each in others if each.known]
        return members, []

    def _of_letters(self, members: list[Member]) -> tuple[list[Member], list[Member]]:
        """p = (X, Y, 0)^T: a usual name beside nothing but letters and numbers, of its size, is what it usually is."""
        sizes = [(len(rows), len(rows[0])) for each in members if (rows := rows_of_letters(each.node))]
        for place, member in enumerate(members):
            name = n.plain_name(member.node)
            for quantity in (
                self.meanings.candidates(member.node, name) if sizes and name is not None and is_usual(name) else ()
            ):
                tried = self._tried(member.node, name, quantity)  # type: ignore[arg-type]
                if isinstance(tried.value, Matrix) and tried.value.shape in sizes:
                    return [*members[:place], tried, *members[place + 1 :]], [tried]
                self.names.state.forget_usual({name.key})  # type: ignore[union-attr]
        return members, []

    def _all_bound_inside(self, members: list[Member]) -> list[Member]:
        """Return the sides with their coordinates and columns bound; what one shows of a name, [J_1 J_2] beside J_1 q̇_1 + J_2 q̇_2, all know."""
        bound = [self._bound_inside(member) for member in members]
        if all(map(is_, bound, members)):
            return bound
        return [self.members.evaluate(each.node) if _is_open_formula(each) else each for each in bound]

    def _bound_inside(self, member: Member) -> Member:
        """A formula's coordinates and points are those of the tool, where they can hardly be anything else."""
        if not isinstance(member.problem, UnboundName) or n.plain_name(member.node) is not None:
            return member
        between = [each for each in n.names(member.node) if "to" in each.sub]  # O_2O_3
        of_names = any(isinstance(bare(cell), n.Name) for row in written_rows(member.node) for cell in row)
        if of_names and not between:
            return member
        added = self.infer_tool(between if of_names else [member.node])
        bound = self.members.evaluate(member.node) if added else member
        if not added or not (bound.known or isinstance(bound.problem, OutsideAlgebra)):
            self.names.state.forget_usual(added)
            return member
        inferred = self.names.state.inferred
        open_ = {key for key in added if inferred[key].frame != self.names.base}  # {}^0v_0 = 0
        shown = {key: {each for (name, _), each in self.names.state.usual.items() if name == key} for key in open_}
        self.doubts.weak |= {key for key in open_ if shown[key] != {inferred[key]}}
        return bound

    def infer_tool(self, nodes: Iterable[n.Node]) -> set[str]:
        """Take the coordinates and points in formulas that nothing gives a meaning for those of the tool, and return their names."""
        added = columns_beside_rates(self.names, nodes := [*nodes])
        for below in (each for node in nodes for each in n.walk(node)):
            name = n.plain_name(below)
            if name is None or not is_usual(name) or not self.names.is_open(name):
                continue
            quantities = self.meanings.candidates(below, name)
            if quantities and (quantities[0].frame != self.names.base or quantities[0].kind == "velocity"):
                self.names.state.infer_usual(name.key, quantities[0])
                added.add(name.key)
        return added

    def _bound(self, member: Member, known: list[Member]) -> Member:
        """Return a side with its open name in the usual meaning that fits what is known, or in the one that it is a slip away from."""
        name = n.plain_name(member.node)
        if not isinstance(member.problem, UnboundName):
            return member
        if name is None:
            return self._with_entries(member, known)
        if name.key in self.names.state.inferred and _is_rate(member.node):  # of the other side: ṗ = ∂p/∂q q̇
            return self.members.evaluate(member.node)
        near: Quantity | None = None
        for quantity in self._in_turn(member.node, name):
            tried = self._tried(member.node, name, quantity)
            if quantity.kind in _MEASURES and tried.known and is_zero(tried.value):
                continue  # w of a frame that moves in no direction
            for other in known if tried.known else ():
                if name.base in LINEAR_VELOCITIES and _has_rows(tried) != _has_rows(other) == 3:
                    continue  # v is the whole velocity beside six rows alone
                pair = self.meanings.closest(tried, other)
                if pair is None and not isinstance(other.problem, OutsideAlgebra):
                    continue
                if self._agree(tried, other, pair):
                    return self._shown_by(tried, name, quantity)
                if pair is None or self._means_otherwise(name, quantity, other):
                    continue
                if self.names.state.configuration and self._holds_there(name, quantity, tried, other, pair):
                    return tried
                close = self._slip_away(member.node, name, quantity, tried, pair)
                near = near or close
        for quantity in self.meanings.that_values_tell(member.node, name) if near is None else ():
            tried = self._tried(member.node, name, quantity)
            if any(self._agree(tried, other, self.meanings.closest(tried, other)) for other in known if tried.known):
                return self._shown_by(tried, name, quantity)
        self.names.state.forget_usual({name.key})
        usual = self.meanings.usual(name.key)
        if near is None or (near != usual and self.meanings.is_of_another(known)):
            return member
        return self._tried(member.node, name, usual or near)  # what is wrong of all shows none anew

    def _in_turn(self, node: n.Node, name: n.Name) -> list[Quantity]:
        """Return the usual meanings of a name in the order in which they are tried."""
        candidates = sorted(
            self.meanings.candidates(node, name), key=lambda each: not self.meanings.is_beside_shown(name, each)
        )
        if _is_at_numbers(node):  # at one configuration many points agree, and more nearly
            usual = self.meanings.usual(name.key)
            return [usual] if usual is not None else candidates[:1]
        return candidates

    def _shown_by(self, tried: Member, name: n.Name, quantity: Quantity) -> Member:
        """Return a side whose name an equation shows to be what it is taken for."""
        self.names.state.usual[name.key, self.names.state.section] = quantity
        return tried

    def _means_otherwise(self, name: n.Name, quantity: Quantity, other: Member) -> bool:
        """Whether the other side tells that a name is something else: z = P_z - d_1 is no P_z, and then z_w is no height of the wrist."""
        if quantity == self.meanings.usual(name.key):
            return False
        return self.meanings.is_named_in(other, quantity, name.key) or self.meanings.is_of_own_letter(name)

    def _holds_there(self, name: n.Name, quantity: Quantity, tried: Member, other: Member, pair: Pair) -> bool:
        """Whether an equation holds at the values that are stated, or mostly does in a meaning that has been shown."""
        there = self.equality.compare(tried, other, 1, False)
        if there.verdict is Verdict.CONFIRMED:
            return True
        is_shown = quantity in self.meanings.meant(name.key) or self.meanings.is_beside_shown(name, quantity)
        is_claimed = is_shown and bool(there.there) and is_led_to(self.names)
        if is_claimed or (quantity in self.meanings.meant(name.key) and is_mostly_right(there, MANY)):
            return True
        if there.verdict is Verdict.REFUTED and self.meanings.is_usual(name) and is_constant(pair.printed):
            self.doubts.open.setdefault(name.key, quantity)
        return False

    def _slip_away(self, node: n.Node, name: n.Name, quantity: Quantity, tried: Member, pair: Pair) -> Quantity | None:
        """Return a usual meaning from which an equation is a slip away; one that may be meant is in doubt."""
        if self.meanings.measures_otherwise(quantity, pair.printed):
            return None
        is_usual_here = quantity == self.meanings.usual(name.key)
        is_shown = is_usual_here and _is_rate(node)  # y has no other rate than its own
        is_beside = self.meanings.is_beside_shown(name, quantity)  # d_y behind d_x
        if not (self.meanings.is_usual(name) or is_shown or is_beside) or is_constant(pair.printed):
            return None
        if self.doubts.open.setdefault(name.key, quantity) == quantity:
            self.doubts.tried[name.key] = tried
        may_be_near = is_usual_here or not (_is_at_numbers(node) or quantity.kind == "angle")
        return quantity if is_shown or (may_be_near and is_near(pair)) else None

    def _with_entries(self, member: Member, known: list[Member]) -> Member:
        """[x; y] = …: each entry that is a name by itself, by the entry that stands in its place."""
        value, rows = known[0].value if known else None, written_rows(member.node)
        blocks = partition(rows, value.shape) if rows and isinstance(value, Matrix) else None
        if blocks is None or not isinstance(value, Matrix) or stand_for_scalars(blocks, self.names):
            return member
        open_: list[n.Name] = []
        for block in blocks:
            cell = self.members.evaluate(block.cell)
            name = n.plain_name(block.cell)
            if name is not None and not cell.known and name.base not in ENTRIES:
                same = (each for each in known if isinstance(each.value, Matrix) and each.value.shape == value.shape)
                bound = self._bound(cell, [Member(each.node, block.of(each.value)) for each in same])  # type: ignore[arg-type]
                open_ += [name] * (not bound.known)
                if bound.known and known[0].rank > 1:  # its place in a matrix of the arm tells it, not convention
                    self.names.state.conventional.discard(name.key)
        if len(open_) == 1 and (left := self.meanings.left_of_point(open_[0], [b.cell for b in blocks], value)):
            self.names.state.infer_usual(open_[0].key, left)
        return self.members.evaluate(member.node)

    def _tried(self, node: n.Node, name: n.Name, quantity: Quantity) -> Member:
        self.names.state.infer_usual(name.key, quantity)
        try:
            return self.members.evaluate(node)
        except TooComplex:
            return Member(node)

    def _agree(self, tried: Member, other: Member, pair: Pair | None) -> bool:
        if pair is not None and agree_exactly(pair):
            return True
        if pair is not None and not has_branches(other.node) and not self.members.exact.ring.signs_chosen:
            return False
        if isinstance(tried.value, Matrix):
            return False
        problem = EvaluationError(say(Kind.ABSOLUTE_VALUE))
        return self.equality.route.confirm_only(tried.node, other.node, 1, False, problem).verdict is Verdict.CONFIRMED

    def judge(self, outcome: Outcome) -> Outcome:
        """Leave undecided what rests on a usual meaning that does not fit."""
        may_rest = outcome.verdict is Verdict.REFUTED or outcome.gives_numbers or (outcome.defines and self.doubts.open)
        return self._judge.judge(outcome, self.doubts) if may_rest else outcome

    def restore(self, outcomes: Iterable[Outcome]) -> None:
        """Let a slip show nothing: where it looks like the point of another frame, the name keeps what it meant.

        One that meant nothing yet may be asked anew, unless the slip looks like the tool's.
        """
        state = self.names.state
        shown = {quantity.frame for (_, section), quantity in state.usual.items() if section == state.section}
        for outcome in outcomes:
            name = n.plain_name(outcome.true.node) if outcome.verdict is Verdict.REFUTED and outcome.true else None
            now = state.inferred.get(name.key) if name is not None and name.key in state.conventional else None
            if name is None or now is None or self.names.arm is None or now.frame in shown:
                continue
            usual = next(iter(self.names.usual(name)), now)
            if (before := self.before.get(name.key)) is not None:
                state.infer_usual(name.key, before)
            elif now != usual:
                state.forget_usual({name.key})


def _is_open_formula(member: Member) -> bool:
    """Whether a side is no name alone, and has a name in it that nothing gives a meaning."""
    return isinstance(member.problem, UnboundName) and n.plain_name(member.node) is None


def _is_rate(node: n.Node) -> bool:
    """Whether a side is a name with dots."""
    name = bare(node)
    return isinstance(name, n.Name) and bool(name.dots)


def _is_at_numbers(node: n.Node) -> bool:
    """Whether a side is a name at given joint values: P(0, π/2)."""
    call = bare(node)
    return isinstance(call, n.Call) and all(map(is_number, call.arguments[1:]))


def _fit_together(members: list[Member]) -> bool:
    """Whether no two members have values of different sizes, and none has sizes that do not fit."""
    sizes = {getattr(member.value, "shape", None) for member in members if member.known}
    return len(sizes) < 2 and not any(isinstance(member.problem, ShapeError) for member in members)


def _is_spelt(node: n.Node) -> bool:
    """Whether a side may be a name, or hold one, that is spelt otherwise."""
    inner = bare(node)
    points = (below for below in n.names(node) if set(below.base) <= POINTS)
    applied = isinstance(inner, n.Product) and isinstance(inner.factors[1], n.Group | n.Sequence)
    dotted = isinstance(inner, n.Product) and any(isinstance(factor, n.Dots) for factor in inner.factors)
    return applied or dotted or isinstance(inner, n.Power) or next(points, None) is not None


def _has_rows(member: Member) -> int:
    return member.value.shape[0] if isinstance(member.value, Matrix) else 0


def _plain_key(node: n.Node) -> str:
    name = n.plain_name(node)
    return name.key if name is not None else ""
