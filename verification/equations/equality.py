"""Whether two members of a chain are equal, and in which entries they differ."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from math import prod
from typing import Any

from armproof.verification.algebra.angles import cos_sin, has_arcs
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Identity, Matrix, is_zero
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import (
    HOMOGENEOUS,
    ROTATION,
    Pair,
    ShapeMismatch,
    agree_exactly,
    align,
    different_entries,
    exactly_equal,
)
from armproof.verification.equations.at_stated_values import StatedValues
from armproof.verification.equations.decimals import holds_to_its_decimals, may_be_rounded
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import SecondRoute
from armproof.verification.equations.sides import Member, Members, beyond_size
from armproof.verification.equations.worked_numbers import holds_as_worked
from armproof.verification.errors import EvaluationError, TooComplex, WhereDefined
from armproof.verification.evaluation.blocks import is_twist_of_plane, partition
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import Verdict


class Equality:
    """Compares a member with the true one: exactly, then by what decimals, table angles and samples allow."""

    def __init__(self, members: Members, route: SecondRoute) -> None:
        self.members = members
        self.route = route
        self.names = members.names
        self.exact = members.exact
        self.stated = StatedValues(members)

    def compare(self, true: Member, printed: Member, equation: int, branches: bool) -> Outcome:
        """Return whether a printed member equals the true one, and where it does not; what is too large is sampled."""
        try:
            outcome = self._compare(true, printed, equation, branches)
        except TooComplex as problem:
            outcome = self.route.confirm_only(true.node, printed.node, equation, branches, beyond_size(problem))
        holds = branches and outcome.verdict in (Verdict.PROVED, Verdict.CONFIRMED)
        return outcome.left_open(say(Kind.ONE_SIGN_ONLY)) if holds and self.route.has_idle_sign(outcome) else outcome

    def _compare(self, true: Member, printed: Member, equation: int, branches: bool) -> Outcome:
        outcome = Outcome(Verdict.REFUTED, (), equation, true, printed)
        try:
            pairs = list(align(true.value, printed.value, self.exact))
        except ShapeMismatch as mismatch:
            if (determinant := self._jacobi_determinant(true)) is not None and isinstance(printed.value, Scalar):
                return self._compare(determinant, printed, equation, branches)
            outcome.findings = (finding_of(mismatch),)
            return self._compare_blocks(true, printed, outcome)
        except EvaluationError as problem:
            return replace(outcome, verdict=Verdict.UNCHECKED, findings=(finding_of(problem),))
        pairs = [self._with_last_coordinate(true.node, pair) for pair in pairs]
        if true.rank < 4:  # only a quantity of the arm may be met in another shape
            rotations, reshaped = _is_made_of_rotations(true.node), pairs
            notes = [ROTATION] if rotations else [HOMOGENEOUS] if _is_of_point(true.node) else []
            notes += [say(Kind.PLANAR_VECTOR)] if is_twist_of_plane(true.node) else []
            pairs = [pair for pair in pairs if not pair.note or (pair.note in notes and not _is_direction(pair))]
            if not pairs:
                return self._of_wrong_size(outcome, true, printed, reshaped)
        distances: list[dict[tuple[int, int], Any]] = []
        if branches:
            try:
                distances = self._on_branches(true.node, printed.node)
            except ShapeMismatch as mismatch:  # -R is 3×3 where R was a rotation beside 4×4 ones
                return outcome.left_open(finding_of(mismatch))
            chosen = self.route.chooses_branches(true.node) or self.route.chooses_branches(printed.node)
            if not chosen and not all(distances) and any(distances):
                return outcome.left_open(say(Kind.ONE_SIGN_ONLY))
        best: tuple[Pair, list[tuple[int, int]]] | None = None
        for pair in pairs:
            wrong = self._wrong_in_branches(distances, pair) if branches else different_entries(pair, exactly_equal)
            if not wrong:
                outcome.verdict, outcome.pair, outcome.findings = Verdict.PROVED, pair, _noted(pair)
                return self.route.confirm(outcome, branches)
            if best is None or len(wrong) < len(best[1]):
                best = (pair, wrong)
        assert best is not None
        return self._unequal(outcome, pairs, *best, branches)

    def _of_wrong_size(self, outcome: Outcome, true: Member, printed: Member, reshaped: Sequence[Pair]) -> Outcome:
        """Return what becomes of sides of two sizes; a vector of the arm may be written as another shape."""
        sizes = [v.size if isinstance(v, Matrix) else "a scalar" for v in (printed.value, true.value)]
        outcome.findings = (say(Kind.WRONG_SIZE, printed=sizes[0], correct=sizes[1]),)
        sides = (true.node, printed.node)
        of_arm = any(self.members.quantity_of(below) for side in sides for below in n.walk(side))
        vectors = (pair for pair in reshaped if of_arm and 1 in pair.printed.shape)  # else its size is the document's
        return outcome.left_open(*outcome.findings) if any(map(agree_exactly, vectors)) else outcome

    def _unequal(
        self, outcome: Outcome, pairs: Sequence[Pair], best: Pair, wrong: list[tuple[int, int]], branches: bool
    ) -> Outcome:
        """Return what becomes of sides that differ: they may be numbers of stated values, or rounded ones."""
        assert outcome.true is not None and outcome.printed is not None
        rounded = self.members.decimals(outcome.true.node, outcome.printed.node, least=1) is not None
        may_be_at_values = not branches and (self.stated.enabled or rounded)
        if may_be_at_values and (there := self.stated.read(outcome, pairs)) is not None:
            return there
        outcome.pair, outcome.wrong = best, wrong
        outcome.findings = _noted(best)
        if rounded and not branches and holds_as_worked(self.members, outcome):
            return outcome
        if rounded and holds_to_its_decimals(self.route, outcome, branches):
            return outcome
        if rounded and not branches and may_be_rounded(self.members, outcome):
            return outcome.left_open(say(Kind.MADE_OF_ROUNDED))
        if branches and self.stated.enabled and self._is_number_beside_joints(best):
            return outcome.left_open(say(Kind.NUMBERS_OF_NOWHERE))
        return self.route.unless_negative(self.route.doubt(outcome, branches), branches)

    def _is_number_beside_joints(self, pair: Pair) -> bool:
        """Whether numbers alone stand beside what moves, sin θ_2 = ±√(1 − 0.375²): at a configuration, or to be solved."""
        one, other = (symbols_in(side.cells) for side in (pair.true, pair.printed))
        cells = (pair.printed if one else pair.true).cells
        moves = bool(self.names.joints.keys() & (one | other))
        return bool(one) is not bool(other) and moves and not all(cell.is_zero() for cell in cells)

    def equals_block(self, true: Value, printed: Value) -> bool:
        """Whether a block of a matrix has the value printed for it."""
        try:
            return any(not pair.note and agree_exactly(pair) for pair in align(true, printed, self.exact))
        except EvaluationError:
            return False

    def _jacobi_determinant(self, member: Member) -> Member | None:
        """Return det J for ∂(x, y)/∂(θ_1, θ_2), which mostly means that beside a scalar."""
        node = bare(member.node)
        if not isinstance(node, n.Derivative) or not isinstance(bare(node.variable), n.Sequence):
            return None
        determinant = self.members.evaluate(n.Call("det", (node,), span=node.span))
        return determinant if determinant.known else None

    def _compare_blocks(self, true: Member, printed: Member, outcome: Outcome) -> Outcome:
        """A printed matrix of blocks in which a 0 stands for a block of zeros: [z_2; 0] is 6×1."""
        node = printed.node
        if not isinstance(node, n.Matrix) or not isinstance(true.value, Matrix):
            return outcome
        blocks = partition(node.rows, true.value.shape)
        if blocks is None or len(blocks) < 2:
            return outcome
        cells = [(block, self.members.evaluate(block.cell)) for block in blocks]
        if not all(
            cell.known and (isinstance(cell.value, Matrix | Identity) or _is_zero(cell.value)) for _, cell in cells
        ):
            return outcome
        outcome.wrong = [
            (block.row, block.column)
            for block, cell in cells
            if not self.equals_block(block.of(true.value), cell.value)
        ]
        outcome.findings = (say(Kind.WRONG_BLOCK),) if outcome.wrong else ()
        outcome.verdict = Verdict.REFUTED if outcome.wrong else Verdict.PROVED
        return outcome

    def _with_last_coordinate(self, node: n.Node, pair: Pair) -> Pair:
        """The fourth coordinate is 1 of a point, 0 of a direction, a rate or a difference of points."""
        quantity = self.members.quantity_of(bare(node))
        is_rate = n.has_rates(node) or isinstance(bare(node), n.Derivative)
        if pair.note != HOMOGENEOUS or not (is_rate or quantity):
            return pair
        is_point = quantity is not None and (quantity.kind == "origin" or quantity.columns == (4,)) and not is_rate
        last = self.exact.ring.one if is_point else self.exact.ring.zero
        return replace(pair, true=Matrix((*pair.true.rows[:3], (last,))))

    def _on_branches(self, true: n.Node, printed: n.Node) -> list[dict[tuple[int, int], Any]]:
        """Return for each choice of the signs ± how far the entries are apart that differ with it somewhere."""
        found = []
        for branch in self.names.state.signs.branches():
            one = Evaluator(self.names, self.exact, branch)
            pair = next(align(one.evaluate(true), one.evaluate(printed), self.exact))
            found.append({place: d for place, a, b in pair.entries() if not (d := _distance(a, b)).is_zero()})
        return found

    def _wrong_in_branches(self, distances: list[dict[tuple[int, int], Any]], pair: Pair) -> list[tuple[int, int]]:
        """With ±, an equation is right as a whole where on every configuration all its entries are on one branch."""
        wrong = [place for place in pair.true.places if all(place in of for of in distances)]
        alone = [place for place in wrong if not prod(of[place] for of in distances).is_zero()]
        return alone or self._on_different_branches(distances)

    def _on_different_branches(self, distances: list[dict[tuple[int, int], Any]]) -> list[tuple[int, int]]:
        """Return the entries of the nearest branch where each holds on one of them, and not all on one."""
        for choice in itertools.product(*distances):
            self.exact.budget.check()
            if not prod(of[place] for of, place in zip(distances, choice, strict=True)).is_zero():
                nearest: dict[tuple[int, int], Any] = min(distances, key=len)
                return sorted(nearest)
        return []


def _noted(pair: Pair) -> tuple[Finding, ...]:
    return (pair.note,) if pair.note is not None else ()


def _distance(a: Any, b: Any) -> Any:
    """A scalar that vanishes where two agree: the difference, or 1 − cos of it for angles."""
    difference = a - b
    if has_arcs(a) or has_arcs(b):
        with WhereDefined():  # a product with an arc function, a sum of one and a length are no angles
            return 1 - cos_sin(difference)[0]
    return difference


def _is_made_of_rotations(node: n.Node) -> bool:
    """Whether a tree is an elementary rotation or a product of such: 3×3 or 4×4, as the document prints it."""
    calls = [below for below in n.walk(node) if n.is_call(below, "Rot", "Rot3")]
    factors = node.factors if isinstance(node, n.Product) else (node,)
    return bool(calls) and all(factor in calls for factor in factors)


def _is_zero(value: Value) -> bool:
    return isinstance(value, Scalar) and value.is_zero()


def _is_of_point(node: n.Node) -> bool:
    """Whether a tree is a point, or one that transforms take to another frame: {}^AP = {}^A_BT {}^BP, of which the 1 below is left to the reader."""
    node = bare(node)
    name = bare(node.factors[-1]) if isinstance(node, n.Product) else node
    return isinstance(name, n.Name) and name.base in ("p", "P") and not name.dots


def _is_direction(pair: Pair) -> bool:
    """Whether a column of homogeneous coordinates has no 1 below."""
    return pair.note == HOMOGENEOUS and is_zero(pair.printed.rows[3][0])
