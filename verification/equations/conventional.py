"""Names that only convention binds: which of their usual meanings fits what they are equated to, and how sure that is.

Such a name is a claim where a usual meaning is exactly what it is equated to, or a slip away from it. Otherwise nobody can
tell whether the author is wrong or means something else: the equation is not decided, and the name keeps its own meaning.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property

from armproof.verification.algebra.calculus import degree_in
from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.heading import sections_around
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
from armproof.verification.equations.at_stated_values import MANY, is_mostly_right
from armproof.verification.equations.by_size import BySize
from armproof.verification.equations.coordinates import coordinates_among
from armproof.verification.equations.doubts import Doubts
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.equations.rates import SPEAKS_OF_RATES, seen_from_frame, stand_for_scalars, with_joint_rates
from armproof.verification.equations.readings import column_of_jacobian
from armproof.verification.equations.sides import Member
from armproof.verification.equations.spellings import POINTS, Spellings
from armproof.verification.errors import EvaluationError, ShapeError, TooComplex, UnboundName, WhereDefined
from armproof.verification.evaluation.blocks import partition, rows_of_letters, written_rows
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, has_branches, is_number
from armproof.verification.naming.conventions import (
    AXES,
    ENTRIES,
    LETTERS,
    LINEAR_VELOCITIES,
    applied,
    is_usual,
    seen_from_wrist,
)
from armproof.verification.naming.shown import letters_of_point, point_of
from armproof.verification.verdict import Verdict

MOST_ROWS = 3  # of a Jacobian whose determinant is only looked for
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
    def spellings(self) -> Spellings:
        """Reads names that are spelt otherwise; made where one is met."""
        return Spellings(self.members)

    def read(self, chain: n.Chain) -> n.Chain:
        """Return a chain whose sides are names where they are spelt otherwise: O_0O_2, p_e(θ), p^1_2."""
        if self.names.arm is None:
            return chain
        self.doubts = Doubts(self.names)
        keys = set(map(_plain_key, chain.members))
        self.names.state.forget_text(_plain_key(chain.members[0]))
        known = keys & self.names.state.conventional
        self.before = {key: self.names.state.inferred[key] for key in known if key in self.names.state.inferred}
        self.names.state.forget_usual(known)  # a name that stands alone is asked anew
        for key in filter(self._usual, keys):
            self.names.state.definitions.pop(key, None)
        self.take_coordinates(chain.members)
        members = (self.spellings.read(each) if _is_spelt(each) else each for each in chain.members)
        read = replace(chain, members=tuple(members))
        return with_joint_rates(seen_from_frame(read), self.names) if n.letters(read) & SPEAKS_OF_RATES else read

    def take_coordinates(self, nodes: Iterable[n.Node], *, beside: bool = True) -> bool:
        """Take names for coordinates that were vectors before, where one may be, and say whether there are such."""
        found = coordinates_among(self.names, nodes, beside=beside) if self.names.state.conventional else {}
        for key, quantity in found.items():
            self.names.state.infer_usual(key, quantity)
        return bool(found)

    @property
    def _base(self) -> str:
        assert self.names.arm is not None
        return self.names.arm.frames[0]

    def bind(self, members: list[Member]) -> list[Member]:
        """Return the members with those bound whose names have a usual meaning that fits."""
        if self.names.arm is None:
            return members
        members = [self._bound_inside(member) for member in members]
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
            name = _plain(member.node)
            usual = (
                self._shown(member.node, name) if name is not None and isinstance(member.problem, UnboundName) else None
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
            name = _plain(member.node)
            for quantity in (
                self._candidates(member.node, name) if sizes and name is not None and is_usual(name) else ()
            ):
                tried = self._tried(member.node, name, quantity)  # type: ignore[arg-type]
                if isinstance(tried.value, Matrix) and tried.value.shape in sizes:
                    return [*members[:place], tried, *members[place + 1 :]], [tried]
                self.names.state.forget_usual({name.key})  # type: ignore[union-attr]
        return members, []

    def _bound_inside(self, member: Member) -> Member:
        """A formula's coordinates and points are those of the tool, where they can hardly be anything else."""
        if not isinstance(member.problem, UnboundName) or _plain(member.node) is not None:
            return member
        between = [each for each in n.walk(member.node) if isinstance(each, n.Name) and "to" in each.sub]  # O_2O_3
        of_names = any(isinstance(bare(cell), n.Name) for row in written_rows(member.node) for cell in row)
        if of_names and not between:
            return member
        added = self.infer_tool(between if of_names else [member.node])
        bound = self.members.evaluate(member.node) if added else member
        if not added or not (bound.known or isinstance(bound.problem, OutsideAlgebra)):
            self.names.state.forget_usual(added)
            return member
        inferred = self.names.state.inferred
        open_ = {key for key in added if inferred[key].frame != self._base}  # {}^0v_0 = 0
        shown = {key: {each for (name, _), each in self.names.state.usual.items() if name == key} for key in open_}
        self.doubts.weak |= {key for key in open_ if shown[key] != {inferred[key]}}
        return bound

    def infer_tool(self, nodes: Iterable[n.Node]) -> set[str]:
        """Take the coordinates and points in formulas that nothing gives a meaning for those of the tool, and return their names."""
        added = self._columns_beside_rates(nodes := [*nodes])
        for below in (each for node in nodes for each in n.walk(node)):
            name = _plain(below)
            if name is None or not is_usual(name) or not self.names.is_open(name):
                continue
            quantities = self._candidates(below, name)
            if quantities and (quantities[0].frame != self._base or quantities[0].kind == "velocity"):
                self.names.state.infer_usual(name.key, quantities[0])
                added.add(name.key)
        return added

    def _columns_beside_rates(self, nodes: Iterable[n.Node]) -> set[str]:
        r"""Take the J_i of J_1 \dot q_1 + … + J_n \dot q_n for the columns of J, and return their names.

        Where not every joint has its term, q_1 may be several joints, and J_1 a block.
        """
        products = (each for node in nodes for each in n.walk(node) if isinstance(each, n.Product))
        columns = {name.key: found for each in products for name, found in self._column_beside_rate(each)}
        columns |= {name.key: found for node in nodes for name, found in self._columns_in_a_row(node)}
        if len({found.columns for found in columns.values()}) < len(self.names.joints):
            return set()
        for key, found in columns.items():
            self.names.state.infer_usual(key, found)
        return set(columns)

    def _columns_in_a_row(self, node: n.Node) -> Iterator[tuple[n.Name, Quantity]]:
        r"""Yield the open J_i of [J_1 \dots J_n], one a joint, with the columns that they are."""
        for below in n.walk(node):
            cells = below.rows[0] if isinstance(below, n.Matrix) and len(below.rows) == 1 else ()
            names = [name for name in map(_plain, cells) if name is not None and name.base == "J"]
            own = [(name, column_of_jacobian(name, self.names)) for name in names if self.names.is_open(name)]
            if len(own) == len(cells) == len(self.names.joints):
                yield from ((name, column) for name, column in own if column is not None)

    def _column_beside_rate(self, product: n.Product) -> Iterator[tuple[n.Name, Quantity]]:
        """Yield the open J_i that stands beside the rate of joint i, and no other, with the column that it is."""
        factors = [
            f.arguments[0] if isinstance(f, n.Call) and f.function == "name" else f for f in map(bare, product.factors)
        ]
        names = [factor for factor in factors if isinstance(factor, n.Name)]
        rates = {self.names.known_symbol(each.undotted.key) for each in names if each.dots == 1}
        for name in (each for each in names if each.base == "J" and self.names.is_open(each)):
            found = column_of_jacobian(name, self.names)
            if found is not None and rates == {self._joint_of(found)}:
                yield name, found

    def _joint_of(self, column: Quantity) -> str:
        assert self.names.arm is not None and column.columns is not None
        return self.names.arm.joints[column.columns[0] - 1].symbol

    def _bound(self, member: Member, known: list[Member]) -> Member:
        name = _plain(member.node)
        if not isinstance(member.problem, UnboundName):
            return member
        if name is None:
            return self._with_entries(member, known)
        if name.key in self.names.state.inferred and _is_rate(member.node):  # of the other side: ṗ = ∂p/∂q q̇
            return self.members.evaluate(member.node)
        near, usual, candidates = None, self._usual(name.key), self._candidates(member.node, name)
        candidates = tuple(sorted(candidates, key=lambda each: not self._is_beside_shown(name, each)))
        if at_numbers := _is_at_numbers(member.node):  # at one configuration many points agree, and more nearly
            candidates = (usual,) if usual is not None else candidates[:1]
        for quantity in candidates:
            tried = self._tried(member.node, name, quantity)
            if quantity.kind in _MEASURES and tried.known and is_zero(tried.value):
                continue  # w of a frame that moves in no direction
            for other in known if tried.known else ():
                if name.base in LINEAR_VELOCITIES and _has_rows(tried) != _has_rows(other) == 3:
                    continue  # v is the whole velocity beside six rows alone
                pair = self._closest(tried, other)
                if pair is None and not isinstance(other.problem, OutsideAlgebra):
                    continue
                if self._agree(tried, other, pair):
                    self.names.state.usual[name.key, self.names.state.section] = quantity
                    return tried
                if quantity != usual and (self._is_named_in(other, quantity, name.key) or self._is_of_own_letter(name)):
                    continue  # z = P_z - d_1 is no P_z, and then z_w is no height of the wrist
                if pair is not None and self.names.state.configuration:
                    there = self.equality.compare(tried, other, 1, False)
                    if there.verdict is Verdict.CONFIRMED or (
                        quantity in self._meant(name.key) and is_mostly_right(there, MANY)
                    ):
                        return tried
                    if there.verdict is Verdict.REFUTED and self._is_usual(name) and is_constant(pair.printed):
                        self.doubts.open.setdefault(name.key, quantity)
                is_shown = quantity == usual and _is_rate(member.node)  # y has no other rate than its own
                if pair is not None and self._measures_otherwise(quantity, pair.printed):
                    continue
                is_told = self._is_usual(name) or is_shown or self._is_beside_shown(name, quantity)  # d_y behind d_x
                if pair is not None and is_told and not is_constant(pair.printed):
                    if self.doubts.open.setdefault(name.key, quantity) == quantity:
                        self.doubts.tried[name.key] = tried
                    may_be_near = quantity == usual or not (at_numbers or quantity.kind == "angle")
                    near = near or (quantity if is_shown or (may_be_near and is_near(pair)) else None)
        for quantity in self._that_values_tell(member.node, name) if near is None else ():
            tried = self._tried(member.node, name, quantity)
            if any(self._agree(tried, other, self._closest(tried, other)) for other in known if tried.known):
                self.names.state.usual[name.key, self.names.state.section] = quantity
                return tried
        self.names.state.forget_usual({name.key})
        if near is None or (near != usual and self._is_of_another(known)):
            return member
        return self._tried(member.node, name, usual or near)  # what is wrong of all shows none anew

    def _is_usual(self, name: n.Name) -> bool:
        """Whether a name is so common, its index the letter of a frame of the arm or not: y_G where the arm has a G."""
        assert self.names.arm is not None
        is_of_frame = name.sub in self.names.arm.frames and not name.sub.isdigit()
        return is_usual(name) or (is_of_frame and is_usual(replace(name, sub="")))

    def _is_beside_shown(self, name: n.Name, quantity: Quantity) -> bool:
        """Whether the other coordinates of a point have been shown under the names beside this one: x_G and z_G beside y_G."""
        shown = self.names.state.usual.items() if (point := point_of(quantity)) is not None else ()
        letters = letters_of_point(name.key)
        return any(point_of(other) == point and letters_of_point(key) == letters for (key, _), other in shown)

    def _is_named_in(self, member: Member, quantity: Quantity, key: str) -> bool:
        """Whether a side holds another name of a quantity: then an author who has both means something else by this one."""
        names = (below for below in n.walk(member.node) if isinstance(below, n.Name) and below.key != key)
        return any(self.names.quantity(each) == quantity for each in names)

    def _is_of_own_letter(self, name: n.Name) -> bool:
        """Whether the letter of a name with an index means something of the document's own without it."""
        return bool(name.sub) and name.base in AXES and name.base in self.names.state.definitions

    def _with_entries(self, member: Member, known: list[Member]) -> Member:
        """[x; y] = …: each entry that is a name by itself, by the entry that stands in its place."""
        value, rows = known[0].value if known else None, written_rows(member.node)
        blocks = partition(rows, value.shape) if rows and isinstance(value, Matrix) else None
        if blocks is None or not isinstance(value, Matrix) or stand_for_scalars(blocks, self.names):
            return member
        for block in blocks:
            cell = self.members.evaluate(block.cell)
            name = _plain(block.cell)
            if name is not None and not cell.known and name.base not in ENTRIES:
                same = (each for each in known if isinstance(each.value, Matrix) and each.value.shape == value.shape)
                bound = self._bound(cell, [Member(each.node, block.of(each.value)) for each in same])  # type: ignore[arg-type]
                if bound.known and known[0].rank > 1:  # its place in a matrix of the arm tells it, not convention
                    self.names.state.conventional.discard(name.key)
        return self.members.evaluate(member.node)

    def _tried(self, node: n.Node, name: n.Name, quantity: Quantity) -> Member:
        self.names.state.infer_usual(name.key, quantity)
        try:
            return self.members.evaluate(node)
        except TooComplex:
            return Member(node)

    def _usual(self, key: str) -> Quantity | None:
        """Return what an equation under this heading has shown a name to be, as convention says."""
        section, usual = self.names.state.section, self.names.state.usual
        if not usual:
            return None
        return next((usual[key, each] for each in (section, *sections_around(section)) if (key, each) in usual), None)

    def _meant(self, key: str) -> set[Quantity]:
        """Return what equations have shown a name to be, under whatever heading."""
        return {quantity for (each, _), quantity in self.names.state.usual.items() if each == key}

    def _shown(self, node: n.Node, name: n.Name) -> Quantity | None:
        shown = self._meant(name.key)
        first = self._candidates(node, name)[:1] if len(shown) == 1 and is_usual(name) else ()
        return self._usual(name.key) or next((quantity for quantity in first if quantity in shown), None)

    def _candidates(self, node: n.Node, name: n.Name) -> tuple[Quantity, ...]:
        arm = self.names.arm
        if arm is None or name.base not in LETTERS or not self.names.is_open(name):
            return ()
        found = self.names.usual(name)
        if isinstance(bare(node), n.Call):
            found = tuple(dict.fromkeys((*found, *applied(name, arm))))
        found = tuple(quantity for quantity in found if self.names.may_be(name, quantity))
        return tuple(each for quantity in found if (each := self._with_rows(quantity)) is not None)

    def _measures_otherwise(self, quantity: Quantity, printed: Matrix) -> bool:
        """Whether a coordinate is beside what is no length: X = -2 P_z D_3, a coefficient of X s_2 + Y c_2 = Z."""
        if quantity.kind != "origin" or not quantity.scalar or printed.shape != (1, 1):
            return False
        arm = self.names.arm
        assert arm is not None
        slides = [symbol for symbol, joint in self.names.joints.items() if joint.kind == "prismatic"]
        degree = degree_in(printed.rows[0][0].normal(), {*arm.lengths, *slides})
        return degree is not None and degree > 1

    def _that_values_tell(self, node: n.Node, name: n.Name) -> tuple[Quantity, ...]:
        """Return the quantities that a name may be where one has exactly the value of the other side; it is no slip in any."""
        arm = self.names.arm
        if arm is None or not self.names.is_open(name) or isinstance(bare(node), n.Call):
            return ()
        return seen_from_wrist(name, arm, self.names.transforms)

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
        if not (tried.known and other.known):
            return None
        with WhereDefined():
            pairs = list(align(tried.value, other.value, self.members.exact))
            return min(pairs, key=lambda pair: len(different_entries(pair, exactly_equal)), default=None)
        return None

    def _agree(self, tried: Member, other: Member, pair: Pair | None) -> bool:
        if pair is not None and agree_exactly(pair):
            return True
        if pair is not None and not has_branches(other.node) and not self.members.exact.ring.signs_chosen:
            return False
        if isinstance(tried.value, Matrix):
            return False
        problem = EvaluationError(say(Kind.ABSOLUTE_VALUE))
        return self.equality.route.confirm_only(tried.node, other.node, 1, False, problem).verdict is Verdict.CONFIRMED

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
        if outcome.gives_numbers and outcome.printed is not None:
            self._give(_plain(outcome.printed.node))
        if outcome.verdict is Verdict.REFUTED and (meant := self._defined_otherwise(outcome)) is not None:
            return outcome.left_open(meant)
        near = outcome.pair is not None and is_near(outcome.pair)
        refuted = outcome.verdict is Verdict.REFUTED
        if refuted and not near and outcome.true is not None and _is_placed_above(outcome.true.node):
            return outcome.left_open(say(Kind.WHICH_INDEX))  # p_0^2 may place frame 2 in frame 0
        if refuted and (key := self._seen_from_elsewhere(outcome)):
            return outcome.left_open(say(Kind.NOT_BOUND, name=key))
        near = near and not self._is_of_triangle(outcome)
        doubtful = (self.doubts.weak and not near) if refuted else (outcome.defines and self.doubts.open)
        if not doubtful:
            return outcome
        judged = self.doubts.judge(outcome)
        return judged if refuted else replace(judged, as_usual=self._as_usual(outcome))

    def _as_usual(self, outcome: Outcome) -> AsUsual | None:
        """Return what an equation that gives a name another value would be, if the name meant what it usually does."""
        name = _plain(outcome.printed.node) if outcome.printed is not None else None
        tried = self.doubts.tried.get(name.key) if name is not None else None
        if name is None or tried is None or outcome.true is None:
            return None
        of_other = self._is_of_other(outcome.true)
        if of_other and (name.base not in "xyzXYZ" or name.sub or name.sup):
            return None
        meanings = {name.key: self.doubts.open[name.key]}
        self.names.state.inferred |= meanings
        try:
            found = self.equality.compare(tried, outcome.true, outcome.equation, has_branches(outcome.true.node))
        finally:
            self.names.state.forget_usual(meanings)
        return AsUsual(found, meanings, of_other) if found.verdict is Verdict.REFUTED else None

    def _is_of_other(self, member: Member) -> bool:
        """Whether a value is a point, a rotation or a pose of the arm, or a coordinate of one of its points."""
        if not isinstance(value := member.value, Scalar):
            return self._is_of_another([member])
        points = [self.members.exact.quantity(each) for each in self._others() if each.kind == "origin"]
        return any(exactly_equal(cell, value) for point in points for cell in point.cells)

    def _is_of_triangle(self, outcome: Outcome) -> bool:
        """Whether the usual letter of the tool's direction stands alone in a cosine: h² = l_1² + l_2² - 2 l_1 l_2 cos φ."""
        spoken = [
            b for node in outcome.nodes for b in n.walk(node) if isinstance(b, n.Name) and b.key in self.doubts.weak
        ]
        cosines = [b for node in outcome.nodes for b in n.walk(node) if isinstance(b, n.Call) and b.function == "cos"]
        quantity = self.names.quantity(spoken[0]) if len(spoken) == 1 else None
        in_sum = any(isinstance(bare(node), n.Sum) for node in outcome.nodes)
        return (
            in_sum
            and quantity is not None
            and quantity.kind == "angle"
            and [c.arguments for c in cosines] == [(*spoken,)]
        )

    def restore(self, outcomes: Iterable[Outcome]) -> None:
        """Let a slip show nothing: where it looks like the point of another frame, the name keeps what it meant.

        One that meant nothing yet may be asked anew, unless the slip looks like the tool's.
        """
        state = self.names.state
        shown = {quantity.frame for (_, section), quantity in state.usual.items() if section == state.section}
        for outcome in outcomes:
            name = _plain(outcome.true.node) if outcome.verdict is Verdict.REFUTED and outcome.true else None
            now = state.inferred.get(name.key) if name is not None and name.key in state.conventional else None
            if name is None or now is None or self.names.arm is None or now.frame in shown:
                continue
            usual = next(iter(self.names.usual(name)), now)
            if (before := self.before.get(name.key)) is not None:
                state.infer_usual(name.key, before)
            elif now != usual:
                state.forget_usual({name.key})

    def _give(self, name: n.Name | None) -> None:
        """x = 0: where the tool is to be, and not what x is."""
        if name is not None and is_usual(name) and self.names.usual(name):
            self.names.keep_as_given(name.key)

    def _seen_from_elsewhere(self, outcome: Outcome) -> str:
        """Return a block of a pose seen from another frame than the base, T_2^1 = [R, p_2; 0, 1], that names no frame to be seen from."""
        name = _plain(outcome.true.node) if outcome.true is not None else None
        quantity = self.names.quantity(name) if name is not None else None
        if (
            quantity is None
            or quantity.kind not in ("pose", "rotation")
            or quantity.reference == self._base
            or outcome.printed is None
        ):
            return ""
        blocks = (_plain(cell) for row in written_rows(outcome.printed.node) for cell in row)
        return next((each.key for each in blocks if each is not None and self._is_unseen(each)), "")

    def _is_unseen(self, name: n.Name) -> bool:
        """Whether a name is taken as seen from the base, and no index and no front matter says so."""
        quantity = None if name.sup or name.pre_sup or name.key in self.names.quantities else self.names.quantity(name)
        return quantity is not None and quantity.reference == self._base

    def _defined_otherwise(self, outcome: Outcome) -> Finding | None:
        """A name that the document gave another meaning is exactly what it usually is: nobody can tell which is meant."""
        name = _plain(outcome.true.node) if outcome.true is not None else None
        definition = self.names.state.definitions.get(name.key) if name is not None else None
        arm = self.names.arm
        if name is None or name.base not in LETTERS or definition is None or arm is None or outcome.printed is None:
            return None
        for quantity in filter(None, map(self._with_rows, self.names.usual(name))):
            usual = Member(name, self.members.exact.quantity(quantity))
            if (pair := self._closest(usual, outcome.printed)) is not None and agree_exactly(pair):
                return say(Kind.SECOND_MEANING, name=name.key, line=definition.line)
        return None


def _plain(node: n.Node) -> n.Name | None:
    """Return the name that a node is, without its dots and arguments, or None."""
    node = bare(node)
    if isinstance(node, n.Call) and node.function == "name" and isinstance(node.arguments[0], n.Name):
        node = node.arguments[0]
    return node.undotted if isinstance(node, n.Name) and node.base not in ("words", "=") else None


def _is_rate(node: n.Node) -> bool:
    """Whether a side is a name with dots."""
    name = bare(node)
    return isinstance(name, n.Name) and bool(name.dots)


def _is_placed_above(node: n.Node) -> bool:
    return isinstance(node, n.Name) and node.base in "pPoOd" and node.sup.isdigit() and node.sub.isdigit()


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
    points = (below for below in n.walk(node) if isinstance(below, n.Name) and set(below.base) <= POINTS)
    applied = isinstance(inner, n.Product) and isinstance(inner.factors[1], n.Group | n.Sequence)
    dotted = isinstance(inner, n.Product) and any(isinstance(factor, n.Dots) for factor in inner.factors)
    return applied or dotted or isinstance(inner, n.Power) or next(points, None) is not None


def _has_rows(member: Member) -> int:
    return member.value.shape[0] if isinstance(member.value, Matrix) else 0


def _plain_key(node: n.Node) -> str:
    name = _plain(node)
    return name.key if name is not None else ""
