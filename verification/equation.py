"""The verdict of one chain of equations: which member is true, which names are defined, which entries are wrong."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from verification.algebras import ExactAlgebra, OutsideAlgebra, SampledAlgebra, Value
from verification.blocks import Block, partition
from verification.branches import holds_on
from verification.compare import (
    HOMOGENEOUS,
    ROTATION,
    Pair,
    ShapeMismatch,
    align,
    angle_places,
    different_entries,
    entry_errors,
    exactly_equal,
    square_rows,
)
from verification.errors import EvaluationError, NoValue, TooComplex, UnboundName
from verification.evaluate import Evaluator, Identity
from verification.jacobian_parts import jacobian_name, jacobian_rows, part_of_jacobian
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.names import Names, call_key
from verification.numbers import FEW, coarsest_decimals, compare_numbers, depends_on_joints, finest_decimals, is_numeric
from verification.quantities import Quantity
from verification.trig import AngleFraction, Scalar
from verification.verdict import Verdict

AUXILIARY = r"[A-HK-NQ-SU-Wa-hkmnr-w]|alpha|beta|gamma|delta|lambda|mu|rho"  # letters of a figure, not of the arm
TOLERANCE = 1e-6  # of the sampled values, scaled by their size; polynomials come out near 1e-15
SINGULAR = 1e7  # samples beyond this size lie at a singularity of the formula and are left out


@dataclass(frozen=True)
class Member:
    """One side of a chain: its tree, and its exact value or why it has none."""

    node: n.Node
    value: Value = None
    problem: EvaluationError | None = None
    rank: int = 0  # how far it may be trusted: 3 a quantity of the arm, 2 made of such, 1 a formula, 0 none

    @property
    def known(self) -> bool:
        """Whether it has a value."""
        return self.problem is None


@dataclass
class Outcome:
    """What became of one equation of a display."""

    verdict: Verdict
    message: str = ""
    equation: int = 1
    true: Member | None = None
    printed: Member | None = None
    pair: Pair | None = None
    wrong: list[tuple[int, int]] = field(default_factory=list)
    samples: int = 0
    max_error: float | None = None
    sampled_only: bool = False
    defines: tuple[str, ...] = ()


class ChainChecker:
    """Checks chains of `=` under the bindings of a document."""

    def __init__(self, names: Names, exact: ExactAlgebra, sampled: Callable[[], SampledAlgebra]) -> None:
        self.names = names
        self.exact = exact
        self.sampled = sampled
        self.confirm = True
        self._fresh: frozenset[str] = frozenset()  # the new letters of a matrix that the chain at hand defines

    def check(self, chain: n.Chain, first_equation: int, line: int, define: bool = True) -> list[Outcome]:
        """Return one outcome an equation, numbered from `first_equation`."""
        branches = has_branches(chain)
        if define:
            self._renew_letter(chain)
        self._choose_square_rows(chain)
        new = self._new_name(chain)
        self._fresh = self._new_letters(chain)
        members = [
            Member(node, None, UnboundName(new)) if new is not None and bare_key(node) == new else self.member(node)
            for node in chain.members
        ]
        if self._fresh and len(members) > 1 and all(member.known for member in members):
            letters = self._fresh
            members = [Member(m.node, None, UnboundName(min(letters))) if letters & _keys_alone(m.node) else m for m in members]
        else:
            self._fresh = frozenset()
        known = [member for member in members if member.known]
        if not known:
            if define and self._adopts_letters(members):
                return self.check(chain, first_equation, line, define)
            return self._nothing_known(members, first_equation, line)
        members = [self._part(member, known) for member in members]
        if define:
            members = [self._own_angle(member, members) for member in members]
        known = [member for member in members if member.known]
        true = max(known, key=lambda member: member.rank)  # the first of the highest
        outcomes: list[Outcome] = []
        for index, member in enumerate(members):
            if member is true:
                continue
            equation = first_equation + max(0, index - 1)
            if member.known:
                outcomes.append(self._compare(true, member, equation, branches))
            else:
                outcomes.append(self._define(true, member, equation, line, define))
        if any(_is_mismatch(outcome) or _is_overloaded(outcome) for outcome in outcomes):
            outcomes = self._with_fewer_rows(chain, first_equation, line, define) or outcomes
            outcomes = [self._other_meaning(outcome, line, define) for outcome in outcomes]
        outcomes.extend(self._labels(chain, first_equation, line, define))
        return outcomes

    def _other_meaning(self, outcome: Outcome, line: int, define: bool) -> Outcome:
        """A letter that stands for something of another size here: x-dot = J q-dot for a component x, a height z_1."""
        if not _is_mismatch(outcome) or outcome.true is None or outcome.printed is None:
            return outcome
        sides = (outcome.true, outcome.printed)
        implied, other = outcome.true, outcome.printed
        vector = isinstance(implied.node, n.Name) and implied.node.base in "zZ" and implied.node.sub != "0"
        number = isinstance(other.value, Scalar) and other.value.as_fraction() is None  # a height, not the constant 1
        if define and vector and number and isinstance(implied.value, Matrix) and (key := bare_key(implied.node)) not in self.names.quantities:
            self.names.define(str(key), _getter(self, other.node), line)
            return replace(outcome, verdict=Verdict.DEFINED, message=f"{key} is a number here, not the arm's vector")
        rate = next((side.node for side in sides if isinstance(side.node, n.Name) and side.node.dots), None)
        matrices = [side for side in sides if isinstance(side.value, Matrix)]
        if rate is None or len(matrices) != 1 or any(isinstance(b, n.Matrix) for side in sides for b in n.walk(side.node)):
            return outcome
        return replace(outcome, verdict=Verdict.DEFINED, message=f"{rate.key} is a vector here, a component elsewhere")

    def _with_fewer_rows(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome] | None:
        """A product with the implied Jacobian that only fits with its rows of v, or those printed before, is read so."""
        whole = [(below, name) for below in n.walk(chain) if (name := jacobian_name(below, self.names)) is below]
        if not whole or any(member is name for member in chain.members for name, _ in whole):
            return None
        fitting: list[Outcome] | None = None
        for rows in jacobian_rows(self.member(whole[0][0]).value, self.names.shown.get("J")):
            read = chain
            for below, name in whole:
                quantity = self.names.quantity(replace(name, dots=0))
                assert quantity is not None
                part = replace(name, sub=f"rows {rows}")
                self.names.inferred[replace(part, dots=0).key] = replace(quantity, rows=rows)
                read = n.substitute(read, below, part)  # type: ignore[assignment]
            outcomes = self.check(read, equation, line, define)
            if not any(_is_mismatch(outcome) for outcome in outcomes):
                for outcome in outcomes:
                    outcome.message = outcome.message or f"J is read as its rows {', '.join(map(str, rows))}"
                if all(outcome.verdict is not Verdict.REFUTED for outcome in outcomes):
                    return outcomes
                fitting = fitting or outcomes
        return fitting

    def _renew_letter(self, chain: n.Chain) -> None:
        """A scalar letter that an earlier section defined may be defined anew: K, A, β mean something else there."""
        key = bare_key(chain.members[0])
        definition = self.names.definitions.get(key) if key is not None and self.names.arm is not None else None
        name = chain.members[0]
        if not isinstance(name, n.Name) or not re.fullmatch(AUXILIARY, name.base):
            return
        if definition is None or len(chain.members) < 2 or definition.by_place or definition.section == self.names.section:
            return
        if any(isinstance(below, n.Name) and below.key == key for below in n.walk(chain.members[1])):
            return
        before, now = self.member(chain.members[0]), self.member(chain.members[1])
        if not (before.known and now.known and isinstance(before.value, Scalar) and isinstance(now.value, Scalar)):
            return
        if self._compare(before, now, 0, has_branches(chain)).verdict is Verdict.REFUTED:
            del self.names.definitions[str(key)]

    def _adopts_letters(self, members: list[Member]) -> bool:
        """The letters of the transform to a frame that the document adds (a tool of length L_3) become free symbols."""
        if not any(isinstance(m.node, n.Name) and self.names.adds_frame(m.node) for m in members):
            return False
        new: set[str] = set()
        for member in members:
            if isinstance(member.node, n.Matrix) and isinstance(member.problem, UnboundName):
                for below in n.walk(member.node):
                    if isinstance(below, n.Name) and not self.member(below).known and below.base[:1] in "aldhLDrRkGge" and not below.dots:
                        new.add(below.key)
        new -= self.names.adopted
        self.names.adopted |= new
        return bool(new)

    def _part(self, member: Member, known: list[Member]) -> Member:
        """An unbound J_1 or J_{12} that is equated to a column or a scalar is that part of the Jacobian."""
        if not isinstance(member.problem, UnboundName) or not isinstance(member.node, n.Name):
            return member
        quantity = part_of_jacobian(member.node, known[0].value, self.names)
        if quantity is None:
            return member
        self.names.inferred[member.node.key] = quantity
        return self.member(member.node)

    def _own_angle(self, member: Member, members: list[Member]) -> Member:
        """θ_{12} is θ_1 + θ_2, unless the display gives it another value: then it is the document's own name."""
        if not isinstance(member.node, n.Name) or not member.known or len(member.node.sub) > 2:
            return member
        if member.node.key in self.names.definitions or self.names.known_symbol(member.node.key) is not None:
            return member
        if self.names.angle_sum(member.node) is None or member.node.key in self.names.quantities:
            return member
        other = next((m for m in members if m is not member and m.known), None)
        if other is None or self._compare(member, other, 0, has_branches(other.node)).verdict is not Verdict.REFUTED:
            return member
        return Member(member.node, None, UnboundName(member.node.key))

    def _choose_square_rows(self, chain: n.Chain) -> None:
        """Before det J or J^{-1} of a Jacobian that only notation implies: the rows that make it square, if not printed yet."""
        for below in n.walk(chain):
            inverted = isinstance(below, n.Postfix) and below.operator == "-1"
            if not inverted and not (isinstance(below, n.Call) and below.function in ("det", "adj", "com", "abs")):
                continue
            name = jacobian_name(below.base if isinstance(below, n.Postfix) else below.arguments[0], self.names)  # type: ignore[attr-defined]
            if name is None:
                continue
            value = self.member(name).value
            if isinstance(value, Matrix) and len(self.names.shown.get(name.key, ())) == value.shape[1]:
                continue
            if isinstance(value, Matrix) and value.shape[0] != value.shape[1] and (rows := square_rows(value)) is not None:
                self.names.shown[name.key] = tuple(row + 1 for row in rows)

    def _new_name(self, chain: n.Chain) -> str | None:
        """In a document of general statements, the first letter that stands alone and is new is being defined."""
        if len(chain.members) < 2:
            return None
        for member in chain.members:
            while isinstance(member, n.Group | n.Labelled):
                member = member.inner
            if isinstance(member, n.Name) and self.names.is_new(member) and member.key not in _keys_beside(chain, member):
                return member.key
        return None

    def _new_letters(self, chain: n.Chain) -> frozenset[str]:
        """The letters of the first matrix that holds nothing but new letters and numbers: a formula's value defines them."""
        for member in chain.members if not any(bare_key(node) for node in chain.members) else ():
            names = _names_alone(member)
            if names and all(self.names.is_new(name) for name in names) and not _keys_alone(member) & _keys_beside(chain, member):
                return _keys_alone(member)
        return frozenset()

    def member(self, node: n.Node) -> Member:
        """Evaluate one side exactly."""
        try:
            value = Evaluator(self.names, self.exact).evaluate(node)
            return Member(node, value, None, self._rank(node))
        except AngleFraction:
            raise
        except OutsideAlgebra as problem:
            return Member(node, None, problem, self._rank(node))
        except TooComplex:
            raise
        except EvaluationError as problem:
            return Member(node, None, problem)

    def _rank(self, node: n.Node) -> int:
        if isinstance(node, n.Group | n.Labelled):
            return self._rank(node.inner)
        quantity = self.quantity_of(node)
        if quantity is not None or (isinstance(node, n.Name) and node.dots and self.names.quantity(replace(node, dots=0)) is not None):
            return 4
        if isinstance(node, n.Name) and self.names.arm is not None and (symbol := self.names.known_symbol(node.key)) is not None:
            return 3 if any(joint.symbol == symbol for joint in self.names.arm.joints) else 1
        names = [below for below in n.walk(node) if isinstance(below, n.Name | n.Call)]
        if any(isinstance(below, n.Matrix) for below in n.walk(node)):
            return 2 if any(self.quantity_of(below) is not None for below in names) else 1
        if any(self.quantity_of(below) is not None for below in names):
            return 3
        if any(isinstance(below, n.Name) and below.key in self.names.definitions for below in names):
            return 3 if isinstance(node, n.Name) else 2
        return 1

    def quantity_of(self, node: n.Node) -> Quantity | None:
        """Return the arm's quantity that a name, with or without arguments, stands for."""
        if isinstance(node, n.Call) and node.function == "name" and all(isinstance(a, n.Name) for a in node.arguments):
            found = self.names.quantities.get(call_key(node))
            return found or self.quantity_of(node.arguments[0])
        return self.names.quantity(node) if isinstance(node, n.Name) else None

    # -- equations that hold or do not --------------------------------------------------------------------------------

    def _compare(self, true: Member, printed: Member, equation: int, branches: bool) -> Outcome:
        outcome = Outcome(Verdict.REFUTED, "", equation, true, printed)
        if (numbers := self._at_a_configuration(true, printed, outcome)) is not None:
            return numbers
        try:
            pairs = list(align(true.value, printed.value, self.exact))
        except ShapeMismatch as mismatch:
            outcome.message = str(mismatch)
            return self._compare_blocks(true, printed, outcome)
        except EvaluationError as problem:
            return replace(outcome, verdict=Verdict.UNCHECKED, message=str(problem))
        pairs = [self._with_last_coordinate(true.node, pair) for pair in pairs]
        best: tuple[Pair, list[tuple[int, int]]] | None = None
        if true.rank < 4:  # only a quantity of the arm may be met in another shape
            rotations = _is_made_of_rotations(true.node)
            pairs = [pair for pair in pairs if not pair.note or (rotations and pair.note == ROTATION)]
            if not pairs:
                sizes = [v.size if isinstance(v, Matrix) else "a scalar" for v in (printed.value, true.value)]
                outcome.message = f"the printed matrix is {sizes[0]}, it should be {sizes[1]}"
                return outcome
        for pair in pairs:
            if branches:
                wrong = self._wrong_in_branches(true.node, printed.node, pair)
            else:
                wrong = different_entries(pair, exactly_equal)
            if not wrong:
                outcome.verdict, outcome.pair, outcome.message = Verdict.PROVED, pair, pair.note
                if pair.true_rows is not None and (name := jacobian_name(true.node, self.names)) is not None:
                    self.names.shown[name.key] = tuple(row + 1 for row in pair.true_rows)
                return self._confirm(outcome, branches)
            if best is None or len(wrong) < len(best[1]):
                best = (pair, wrong)
        assert best is not None
        outcome.pair, outcome.wrong = best
        outcome.message = best[0].note
        if self._holds_of_table_angles(outcome):
            outcome.verdict, outcome.wrong = Verdict.PROVED, []
            outcome.message = "with the joint angles read as those of the DH table, offsets included"
            return outcome
        if self._holds_to_its_decimals(outcome, branches):
            return outcome
        return self._doubt(outcome, branches)

    def _holds_to_its_decimals(self, outcome: Outcome, branches: bool) -> bool:
        """Confirm an equation whose numbers are rounded (1.501 for √(1.5² + 0.054²)) to the decimals they are printed with."""
        assert outcome.true is not None and outcome.printed is not None
        decimals = coarsest_decimals((outcome.true.node, outcome.printed.node), self.names.rounded)
        if decimals is None or not self._leaves_rounding(outcome, decimals):
            return False
        errors = self._sampled_errors(outcome, branches)
        if errors is None:
            return False
        scaled, finite = errors
        tolerance = 0.45 * 10.0**-decimals  # of errors scaled by 1 + size: less than one unit of the last
        holding = (scaled <= tolerance).all(axis=(0, 1)) & finite
        left = min(outcome.true.node, outcome.printed.node, key=lambda node: node.span)
        everywhere = holding.sum() == finite.sum() >= 10
        if not everywhere and not (self._is_solved_for(left) and holds_on(scaled, finite & self.sampled().random, tolerance)):
            return False
        outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
        outcome.samples, outcome.max_error = int(holding.sum()), float(scaled[..., holding].max())
        outcome.message = f"to the {decimals} decimals printed" + ("" if everywhere else ", on one branch of its arc functions")
        return True

    def _leaves_rounding(self, outcome: Outcome, decimals: int) -> bool:
        """Whether a wrong entry may be wrong by rounding: 0.334 for 0.333 is not, the decimals printed hold 0.333 exactly."""
        assert outcome.true is not None and outcome.printed is not None
        if outcome.pair is None:
            return True
        decimals = max(decimals, finest_decimals((outcome.true.node, outcome.printed.node)))
        true, printed = outcome.pair.true.rows, outcome.pair.printed.rows
        for difference in (true[r][c] - printed[r][c] for r, c in outcome.wrong):
            roots = any(kind == "sqrt" for powers, _ in difference.ring.terms(difference.numerator) for kind, _ in powers)
            if roots or not difference.denominator.is_one() or difference.ring.leaves_open(difference):
                continue
            if all((k * 10**decimals).denominator == 1 for _, k in difference.ring.terms(difference.numerator)):
                return False
        return True

    def _compare_blocks(self, true: Member, printed: Member, outcome: Outcome) -> Outcome:
        """A printed matrix of blocks in which a 0 stands for a block of zeros: [z_2; 0] is 6×1."""
        node = printed.node
        blocks = partition(node.rows, true.value.shape) if isinstance(node, n.Matrix) and isinstance(true.value, Matrix) else None
        if blocks is None or len(blocks) < 2:
            return outcome
        cells = [(block, self.member(block.cell)) for block in blocks]
        if not all(cell.known and (isinstance(cell.value, Matrix | Identity) or _is_zero(cell.value)) for _, cell in cells):
            return outcome
        outcome.wrong = [(block.row, block.column) for block, cell in cells if not self._equals_block(block.of(true.value), cell.value)]
        outcome.message = "a block differs" if outcome.wrong else ""
        outcome.verdict = Verdict.REFUTED if outcome.wrong else Verdict.PROVED
        return outcome

    def _with_last_coordinate(self, node: n.Node, pair: Pair) -> Pair:
        """The fourth coordinate is 1 of a point, 0 of a direction or a difference of points."""
        quantity = self.quantity_of(node)
        if pair.note != HOMOGENEOUS or quantity is None or quantity.kind not in ("origin", "axis", "difference"):
            return pair
        last = self.exact.ring.one if quantity.kind == "origin" else self.exact.ring.zero
        return replace(pair, true=Matrix((*pair.true.rows[:3], (last,))))

    def _holds_of_table_angles(self, outcome: Outcome) -> bool:
        """Whether the equation holds where θ_i means the table's angle and not the variable it is offset from."""
        arm = self.names.arm
        assert outcome.pair is not None and outcome.true is not None
        if arm is None or arm.dh is None or outcome.true.rank < 3 or self._is_symbol(outcome.true.node):
            return False
        pi, rational = self.exact.pi(), self.exact.rational
        shifts = {
            row.joint: (self.exact.symbol(row.joint) - pi * rational(row.theta.pi) - rational(row.theta.number)) * row.sign
            for row in arm.dh.rows
            if row.kind == "revolute" and (row.theta.pi or row.theta.number)
        }
        if not shifts:
            return False
        shifted = self.exact.substitute(outcome.pair.true, shifts)
        return not different_entries(replace(outcome.pair, true=shifted), exactly_equal)

    def _is_symbol(self, node: n.Node) -> bool:
        return isinstance(node, n.Name) and self.names.known_symbol(node.key) is not None

    def _at_a_configuration(self, true: Member, printed: Member, outcome: Outcome) -> Outcome | None:
        """A numeric matrix equated to a pose that moves is that pose at the configuration the document gave last."""
        arm = self.names.arm
        if arm is None or true.rank != 4 or not is_numeric(printed.node) or not isinstance(true.value, Matrix):
            return None
        if not isinstance(printed.value, Matrix) or true.value.shape != printed.value.shape:
            return None
        if not depends_on_joints(true.value, {joint.symbol for joint in arm.joints}):
            return None
        found = compare_numbers(true.value, printed.value, printed.node, self.sampled(), self.names.configuration)
        outcome.pair = Pair(true.value, printed.value)
        if found.wrong and len(found.wrong) <= FEW:
            outcome.wrong, outcome.message, outcome.sampled_only = found.wrong, "at the configuration given before", True
        elif found.wrong or found.open:
            outcome.verdict = Verdict.UNCHECKED
            outcome.message = "numbers at a configuration, or for lengths, that no display before states"
        else:
            outcome.verdict, outcome.samples, outcome.max_error = Verdict.CONFIRMED, 1, found.largest
            outcome.message = "to the decimals printed, at the configuration given before"
        return outcome

    def _wrong_in_branches(self, true: n.Node, printed: n.Node, pair: Pair) -> list[tuple[int, int]]:
        """With ±, an entry is right when the product of its differences over the branches vanishes."""
        differences = []
        for branch in (1, -1):
            one = Evaluator(self.names, self.exact, branch)
            differences.append(next(align(one.evaluate(true), one.evaluate(printed), self.exact)))
        wrong = []
        for r, row in enumerate(pair.true.rows):
            for c in range(len(row)):
                factors = [_distance(p.true.rows[r][c], p.printed.rows[r][c]) for p in differences]
                if not (factors[0] * factors[1]).is_zero():
                    wrong.append((r, c))
        return wrong

    def _confirm(self, outcome: Outcome, branches: bool) -> Outcome:
        """Evaluate a proved equation on the double plant as well: the second route must agree."""
        if not self.confirm:
            return outcome
        errors = self._sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        outcome.samples = int(finite.sum())
        outcome.max_error = float(scaled[..., finite].max()) if outcome.samples else None
        if outcome.max_error is not None and outcome.max_error > TOLERANCE:
            if self._on_a_branch(outcome, scaled, finite):
                return outcome
            wrong = np.argwhere((scaled[..., finite] > TOLERANCE).any(axis=-1))
            outcome.verdict = Verdict.REFUTED
            outcome.wrong = [(int(r), int(c)) for r, c in wrong]
            outcome.message = "holds up to the sign of a square root or the branch of an arc function only"
            outcome.sampled_only = True
        elif self._rests_on_lengths(outcome, branches):
            outcome.verdict, outcome.wrong = Verdict.REFUTED, [(r, c) for r, row in enumerate(scaled) for c in range(len(row))]
            outcome.message, outcome.sampled_only = "the sign of a square root is right for the lengths of this arm only", True
        return outcome

    def _doubt(self, outcome: Outcome, branches: bool) -> Outcome:
        """Where square roots or arc functions leave the normal form open, equal samples still confirm."""
        pair, ring = outcome.pair, self.exact.ring
        assert pair is not None and outcome.true is not None and outcome.printed is not None
        signs = ring.signs_chosen and any(self._has_roots(m.node) for m in (outcome.true, outcome.printed))
        if not (branches or signs) and not all(ring.leaves_open(pair.true.rows[r][c] - pair.printed.rows[r][c]) for r, c in outcome.wrong):
            return outcome
        errors = self._sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        if finite.sum() >= 10 and float(scaled[..., finite].max()) <= TOLERANCE and not self._rests_on_lengths(outcome, branches):
            outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
            outcome.samples, outcome.max_error = int(finite.sum()), float(scaled[..., finite].max())
        elif not self._on_a_branch(outcome, scaled, finite) and signs:
            outcome.sampled_only = True
            outcome.message = "the two sides differ, square roots being taken as positive"
        return outcome

    def _on_a_branch(self, outcome: Outcome, scaled: np.ndarray, finite: np.ndarray) -> bool:
        """Confirm what holds on one branch of its square roots and arc functions, and say at how many configurations."""
        assert outcome.true is not None and outcome.printed is not None
        left = min(outcome.true.node, outcome.printed.node, key=lambda node: node.span)
        counts = holds_on(scaled, finite & self.sampled().random, TOLERANCE) if self._is_solved_for(left) else None
        if counts is None:
            return False
        holding = (scaled <= TOLERANCE).all(axis=(0, 1)) & finite
        outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
        outcome.samples, outcome.max_error = int(holding.sum()), float(scaled[..., holding].max())
        outcome.message = (
            f"on one branch of its square roots and arc functions: at {counts[0]} of {counts[1]} random configurations; "
            "at the others another sign or half-turn is meant"
        )
        return True

    def _has_roots(self, node: n.Node) -> bool:
        """Whether a square root stands in a tree, or may stand behind one of its names."""
        return any(
            (isinstance(b, n.Call) and b.function == "sqrt") or (isinstance(b, n.Power) and not isinstance(b.exponent, n.Number))
            or (isinstance(b, n.Name) and b.key in self.names.definitions)
            for b in n.walk(node)
        )  # fmt: skip

    def _is_solved_for(self, node: n.Node) -> bool:
        """Whether a left side is what inverse kinematics solves for: a joint variable, a sum of such, or cos, sin, tan of it.

        Only there a sign or a half-turn is left to the reader; √(sin² θ) = sin θ and |x| = x are identities, and false.
        """
        node = bare(node)
        if isinstance(node, n.Call) and node.function in ("cos", "sin", "tan"):
            node = node.arguments[0]
        plain = n.Name | n.JointAngles | n.Number | n.Sum | n.Product | n.Quotient | n.Group
        return all(isinstance(b, plain) and (not isinstance(b, n.Name) or self._is_symbol(b)) for b in n.walk(node))

    def sampled_value(self, node: n.Node, branch: int = 1) -> Value:
        """Return a tree's value on the samples of the double plant."""
        return Evaluator(self.names, self.sampled(), branch).evaluate(node)

    def _rests_on_lengths(self, outcome: Outcome, branches: bool) -> bool:
        """Whether the sign of a root is right for the arm's own lengths only, as √((l_1 − l_2)²) = l_1 − l_2 may be."""
        arm, ring = self.names.arm, self.exact.ring
        assert outcome.true is not None and outcome.printed is not None
        if arm is None or not (ring.signs_chosen and any(self._has_roots(m.node) for m in (outcome.true, outcome.printed))):
            return False
        generator = np.random.default_rng(len(arm.lengths))
        sampled = self.sampled()
        others = sampled.at({name: generator.uniform(0.2, 1.2, sampled.samples) for name in arm.lengths})
        errors = self._sampled_errors(outcome, branches, others)
        return errors is not None and bool((errors[0][..., errors[1]] > TOLERANCE).any())

    def _sampled_errors(
        self, outcome: Outcome, branches: bool, sampled: SampledAlgebra | None = None
    ) -> tuple[np.ndarray, np.ndarray] | None:
        assert outcome.true is not None and outcome.printed is not None
        sampled = self.sampled() if sampled is None else sampled
        places = angle_places(outcome.pair) if outcome.pair is not None else set()
        # without exact values the trees tell: a side that is an arc function is an angle
        loose = outcome.pair is None and any(_is_arc(m.node) for m in (outcome.true, outcome.printed))

        def angles(r: int, c: int) -> bool:
            return loose or (r, c) in places

        best: np.ndarray | None = None
        sizes: np.ndarray | None = None
        with np.errstate(all="ignore"):
            sampled.regular[:] = True
            for branch in (1, -1) if branches else (1,):
                try:
                    one = Evaluator(self.names, sampled, branch)
                    true, printed = one.evaluate(outcome.true.node), one.evaluate(outcome.printed.node)
                    pairs = list(align(true, printed, sampled))
                    pair = next((p for p in pairs if outcome.pair is None or p.note == outcome.pair.note), pairs[0])
                except EvaluationError:
                    return None
                errors = entry_errors(pair, angles)
                errors = np.broadcast_to(errors, (*errors.shape[:2], sampled.samples))
                size = np.abs(np.array([[np.broadcast_to(c, (sampled.samples,)) for c in row] for row in pair.true.rows]))
                best = errors if best is None else np.minimum(best, errors)
                sizes = size if sizes is None else np.maximum(sizes, size)
            assert best is not None and sizes is not None
            scaled = best / (1.0 + sizes)
            finite = sampled.regular & np.isfinite(scaled).all(axis=(0, 1)) & (sizes < SINGULAR).all(axis=(0, 1))
        return scaled, finite

    def confirm_only(self, true: n.Node, printed: n.Node, equation: int, branches: bool, reason: str) -> Outcome:
        """Compare on samples alone what the exact algebra does not hold."""
        outcome = Outcome(Verdict.UNCHECKED, reason, equation, Member(true), Member(printed))
        errors = self._sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        if finite.sum() < 10:
            outcome.message = f"{reason}; fewer than 10 configurations have a value"
            return outcome
        outcome.samples, outcome.max_error = int(finite.sum()), float(scaled[..., finite].max())
        outcome.message = reason
        if outcome.max_error <= TOLERANCE:
            outcome.verdict = Verdict.CONFIRMED
        elif not self._on_a_branch(outcome, scaled, finite):
            outcome.verdict, outcome.sampled_only = Verdict.REFUTED, True
            outcome.wrong = [(int(r), int(c)) for r, c in np.argwhere((scaled[..., finite] > TOLERANCE).any(axis=-1))]
        return outcome

    # -- names that get a meaning -------------------------------------------------------------------------------------

    def _define(self, true: Member, member: Member, equation: int, line: int, define: bool) -> Outcome:
        """Give the unbound names of a member their meaning by what is known, or say what is not bound."""
        if isinstance(member.problem, OutsideAlgebra):
            return self.confirm_only(true.node, member.node, equation, has_branches(member.node), f"{member.problem} is not exact")
        if isinstance(member.problem, NoValue):
            located = self._define_entries(true, member, equation, line, False)
            if located is not None and located.verdict is Verdict.REFUTED:
                return replace(located, message=str(member.problem))
            return Outcome(Verdict.REFUTED, str(member.problem), equation, true, member)
        if _has_dots(member.node):
            return Outcome(Verdict.DEFINED, "an ellipsis stands for terms: a pattern, not a claim", equation, true, member)
        if isinstance(member.problem, UnboundName):
            key = bare_key(member.node)
            if key is not None:
                if define:
                    self.names.define(key, _getter(self, true.node), line)
                    if (decimals := coarsest_decimals((true.node,), self.names.rounded)) is not None:
                        self.names.rounded[key] = decimals
                    if isinstance(member.node, n.Name):
                        self.names.add_frame(member.node)
                return Outcome(Verdict.DEFINED, f"gives {key} its meaning", equation, true, member, defines=(key,))
            if (root := _squared_name(member.node)) is not None:
                if define:
                    self.names.define(root, _getter(self, n.Call("sqrt", (true.node,), "\\sqrt", span=true.node.span)), line)
                return Outcome(Verdict.DEFINED, f"gives {root} its meaning", equation, true, member, defines=(root,))
            pattern = self._define_entries(true, member, equation, line, define)
            if pattern is not None and pattern.verdict is not Verdict.UNCHECKED:
                return pattern
            slip = self._slipped_index(true, member, equation)
            if slip is not None or pattern is not None:
                return slip or pattern  # type: ignore[return-value]
        return Outcome(Verdict.UNCHECKED, str(member.problem), equation, true, member)

    def _slipped_index(self, true: Member, member: Member, equation: int) -> Outcome | None:
        """A length that the arm does not have (a_3 of a 2R arm) is a slip where one of its lengths makes the equation hold."""
        unknown = {b.key: b for b in n.walk(member.node) if isinstance(b, n.Name) and not self.member(b).known}
        if self.names.arm is None or len(unknown) != 1:
            return None
        (name,) = unknown.values()
        family = [length for length in self.names.arm.lengths if length.partition("_")[0] == name.base and name.sub.isdigit()]
        for length in family:
            read = member.node
            for below in n.walk(member.node):
                if isinstance(below, n.Name) and below.key == name.key:
                    read = n.substitute(read, below, replace(below, sub=length.partition("_")[2]))
            mended = self.member(read)
            if mended.known and self._compare(true, mended, equation, False).verdict is Verdict.PROVED:
                message = f"the arm has no {name.key}; with {length} the equation holds"
                return Outcome(Verdict.REFUTED, message, equation, true, member)
        return None

    def _define_entries(self, true: Member, member: Member, equation: int, line: int, define: bool) -> Outcome | None:
        """A matrix whose unknown entries are bare names: each is defined by its place, the known ones are checked."""
        node = member.node
        while isinstance(node, n.Group):
            node = node.inner
        transposed = isinstance(node, n.Postfix) and node.operator == "T"
        if isinstance(node, n.Postfix) and transposed:
            node = node.base
        if isinstance(node, n.Sequence):
            node = n.Matrix((node.items,), span=node.span) if transposed else n.Matrix(tuple((i,) for i in node.items), span=node.span)
        if not isinstance(node, n.Matrix):
            return None
        rows = tuple(zip(*node.rows, strict=False)) if transposed else node.rows
        value = true.value
        blocks = partition(rows, value.shape) if isinstance(value, Matrix) else None
        if not isinstance(value, Matrix) or blocks is None:
            return None
        first: dict[str, Value] = {}  # what a name is where it stands first
        wrong: list[tuple[int, int]] = []
        unknown: EvaluationError | None = None
        for block in blocks:
            cell, key = self.member(block.cell), bare_key(block.cell)
            if key in self._fresh:
                cell = Member(block.cell, None, UnboundName(str(key)))
            if cell.known:
                if not self._equals_block(block.of(value), cell.value):
                    wrong.append((block.row, block.column))
            elif isinstance(cell.problem, NoValue):
                wrong.append((block.row, block.column))
            elif key is None or not isinstance(cell.problem, UnboundName):
                unknown = cell.problem
            elif key in first:
                if not self._equals_block(first[key], block.of(value)):
                    wrong.append((block.row, block.column))
            else:
                first[key] = block.of(value)
                if define:
                    self.names.define(key, _getter(self, true.node, block), line, by_place=True)
        if wrong:
            pair = Pair(value, value) if len(blocks) == len(value.rows) * len(value.rows[0]) else None
            return Outcome(Verdict.REFUTED, "" if pair else "a block differs", equation, true, member, pair, wrong)
        if unknown is not None:
            return Outcome(Verdict.UNCHECKED, str(unknown), equation, true, member)
        return Outcome(Verdict.DEFINED, f"gives {', '.join(first)} their meaning", equation, true, member, defines=tuple(first))

    def _equals_block(self, true: Value, printed: Value) -> bool:
        try:
            return any(not pair.note and not different_entries(pair, exactly_equal) for pair in align(true, printed, self.exact))
        except EvaluationError:
            return False

    def _labels(self, chain: n.Chain, first_equation: int, line: int, define: bool) -> list[Outcome]:
        """A brace's label that is an unbound name gets the braced expression as its meaning; a bound one is a claim."""
        outcomes: list[Outcome] = []
        for index, member in enumerate(chain.members):
            for below in n.walk(member):
                if not isinstance(below, n.Labelled) or below.label is None:
                    continue
                label, inner = self.member(below.label), self.member(below.inner)
                key = bare_key(below.label)
                if label.known and inner.known:
                    outcomes.append(self._compare(label, inner, first_equation + max(0, index - 1), False))
                elif key is not None and isinstance(label.problem, UnboundName) and inner.known and define:
                    self.names.define(key, _getter(self, below.inner), line)
        return outcomes

    def _nothing_known(self, members: list[Member], equation: int, line: int) -> list[Outcome]:
        """Nothing has a value: a bare new name on one side is a definition in words or symbols, else unchecked."""
        if any(_has_dots(m.node) for m in members):
            return [Outcome(Verdict.DEFINED, "an ellipsis stands for terms: a pattern, not a claim", equation)]
        outside = [m for m in members if isinstance(m.problem, OutsideAlgebra)]
        if len(outside) >= 2 and len(outside) == len(members):
            first, *others = outside
            return [
                self.confirm_only(first.node, m.node, equation + k, has_branches(m.node), f"{m.problem} is not exact")
                for k, m in enumerate(others)
            ]
        shape = next((m.problem for m in members if isinstance(m.problem, NoValue)), None)
        if shape is not None:
            return [Outcome(Verdict.REFUTED, str(shape), equation)]
        if len(members) == 1:
            return [Outcome(Verdict.DEFINED, "states no equation", equation)]
        bare = next((key for m in members if (key := bare_key(m.node)) is not None and isinstance(m.problem, UnboundName)), None)
        unbound = next((m.problem for m in members if isinstance(m.problem, UnboundName) and m.problem.name != bare), None)
        other = next((m.problem for m in members if m.problem is not None and not isinstance(m.problem, UnboundName)), None)
        if bare is not None and other is None:
            return [Outcome(Verdict.DEFINED, f"gives {bare} its meaning in terms of names without a value", equation + k)
                    for k in range(len(members) - 1)]  # fmt: skip
        return [Outcome(Verdict.UNCHECKED, str(other or unbound), equation)]


def _names_alone(node: n.Node) -> list[n.Name]:
    """Return the names that a matrix of nothing but names and numbers holds."""
    while isinstance(node, n.Group | n.Labelled):
        node = node.inner
    cells = [cell for row in node.rows for cell in row] if isinstance(node, n.Matrix) else []
    return [c for c in cells if isinstance(c, n.Name)] if all(isinstance(c, n.Name | n.Number) for c in cells) else []


def _keys_alone(node: n.Node) -> frozenset[str]:
    return frozenset(name.key for name in _names_alone(node))


def _keys_beside(chain: n.Chain, member: n.Node) -> set[str]:
    """The names that the other members of a chain hold."""
    return {b.key for other in chain.members if member not in (other, bare(other)) for b in n.walk(other) if isinstance(b, n.Name)}


def bare(node: n.Node) -> n.Node:
    """Return a tree without the brackets and braces around it."""
    while isinstance(node, n.Group | n.Labelled):
        node = node.inner
    return node


def bare_key(node: n.Node) -> str | None:
    """Return the key of a node that is one name, whatever brackets stand around it."""
    while isinstance(node, n.Group | n.Labelled):
        node = node.inner
    if isinstance(node, n.Name):
        return node.key if node.base not in ("words", "=") else None
    if isinstance(node, n.Call) and node.function == "name" and all(isinstance(a, n.Name) for a in node.arguments):
        return call_key(node)
    return None


def _getter(checker: ChainChecker, node: n.Node, block: Block | None = None) -> Callable[[Any], Value]:
    """Return a definition's meaning: the value of `node`, or a block of it, in whichever algebra asks."""
    names = checker.names

    def evaluate(algebra: Any) -> Value:
        value = Evaluator(names, algebra).evaluate(node)
        if block is None:
            return value
        if not isinstance(value, Matrix):
            raise EvaluationError("an entry of a scalar")
        return block.of(value)

    return evaluate


def _distance(a: Any, b: Any) -> Any:
    """A scalar that vanishes where two agree: the difference, or 1 − cos of it for angles."""
    difference = a - b
    ring = difference.ring
    if ring.has_arcs(a) or ring.has_arcs(b):
        try:
            return 1 - ring.cos_sin(difference)[0]
        except TooComplex:
            raise
        except EvaluationError:  # no angle: a product with an arc function, a sum of one and a length
            return difference
    return difference


def _is_overloaded(outcome: Outcome) -> bool:
    """Whether a formula without a value, for the sizes in it, stands in the equation."""
    return outcome.verdict is Verdict.REFUTED and outcome.printed is not None and isinstance(outcome.printed.problem, NoValue)


def _is_mismatch(outcome: Outcome) -> bool:
    """Whether two values of different sizes were equated."""
    known = outcome.true is not None and outcome.printed is not None and outcome.true.known and outcome.printed.known
    return outcome.verdict is Verdict.REFUTED and known and outcome.pair is None and not outcome.wrong


def _squared_name(node: n.Node) -> str | None:
    """The r of r² = x² + y², which is a length and positive."""
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value == 2:
        return bare_key(node.base)
    return None


def _is_made_of_rotations(node: n.Node) -> bool:
    """Whether a tree is an elementary rotation or a product of such: 3×3 or 4×4, as the document prints it."""
    calls = [below for below in n.walk(node) if isinstance(below, n.Call) and below.function in ("Rot", "Rot3")]
    factors = node.factors if isinstance(node, n.Product) else (node,)
    return bool(calls) and all(factor in calls for factor in factors)


def _is_zero(value: Value) -> bool:
    return isinstance(value, Scalar) and value.is_zero()


def _has_dots(node: n.Node) -> bool:
    return any(isinstance(below, n.Dots) for below in n.walk(node))


def _is_arc(node: n.Node) -> bool:
    """Whether an arc function stands in a tree outside of cosines and other functions."""
    if isinstance(node, n.Call):
        return node.function in ("acos", "asin", "atan", "atan2")
    return any(_is_arc(below) for below in n.children(node))


def has_branches(node: n.Node) -> bool:
    """Whether ± or ∓ stands in a tree."""
    return any(sign in "±∓" for below in n.walk(node) if isinstance(below, n.Sum) for sign, _ in below.terms)
