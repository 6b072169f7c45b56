"""Torques that a force at the tool asks of the joints: what a τ_i is said to be, τ = J^T F tells as well."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from armproof.verification.algebra.calculus import derivative, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, agree_exactly, different_entries, exactly_equal, is_near
from armproof.verification.equations.forces import TORQUES, joint_of_effort
from armproof.verification.equations.jacobian_rows import PLANE
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.verdict import Role, Verdict

COMPONENTS = ("x", "y", "z")
MOMENT = "M"
ABOUT_Z = 5  # the row of J that turns about z


@dataclass(frozen=True)
class Torques:
    """Compares what is said of torques with J^T F, where the components of one force at the tool stand in it."""

    members: Members

    def judge(self, outcome: Outcome) -> Outcome:
        """Return a claim where torques get the value that the force gives them; what is a slip away is not decided."""
        pairs = [Pair(Matrix(((true,),)), Matrix(((value,),))) for value, true in self._compared(outcome)]
        if not pairs or len(pairs) != self._asked(outcome):
            return outcome
        if all(map(agree_exactly, pairs)):
            if lacking := self._lacking(outcome):
                return outcome.left_open(say(Kind.FORCE_LEFT_OUT, names=lacking))
            self._heed(outcome)
            return replace(outcome, verdict=Verdict.PROVED, findings=(), role=Role.CLAIM)
        turned = [replace(pair, true=pair.true.map(lambda cell: -cell)) for pair in pairs]
        said = self._is_said_to_be(outcome)
        if said and all(agree_exactly(pair) or self._moves_alike(pair) for pair in pairs):
            return self._refuted(outcome, pairs)
        if all(map(agree_exactly, turned)) and not said:
            return outcome  # the torques that the force makes, and not those that hold it
        if not any(all(agree_exactly(each) or is_near(each) for each in read) for read in (pairs, turned)):
            return outcome
        if said:
            return self._refuted(outcome, pairs)
        finding = say(Kind.NEAR_TORQUE, names=sorted(outcome.defines))
        for name in outcome.defines:
            self.members.names.leave_open(name, finding)
        return replace(outcome, verdict=Verdict.UNCHECKED, findings=(finding,), role=Role.DEFINITION)

    def _moves_alike(self, pair: Pair) -> bool:
        """Whether the same joints and loads stand in both: what lacks one may be said of a configuration."""
        moving = {*self.members.names.joints, *self.members.names.state.adopted}
        true, printed = (symbols_in(matrix.cells) & moving for matrix in (pair.true, pair.printed))
        return true == printed != set()

    def _heed(self, outcome: Outcome) -> None:
        """One torque that is what J^T F makes of the force shows what the others of its letter are."""
        state = self.members.names.state
        for letter in self._letters(outcome):
            state.balanced.setdefault((letter, state.exercise))

    @staticmethod
    def _letters(outcome: Outcome) -> set[str]:
        named = [*(cells_of(outcome.printed.node) or (outcome.printed.node,))] if outcome.printed is not None else []
        return {each.base for each in map(bare, named) if isinstance(each, n.Name)}

    def _is_said_to_be(self, outcome: Outcome) -> bool:
        """Whether the exercise says, or shows, that these torques are J^T F."""
        letters, state = self._letters(outcome), self.members.names.state
        return len(letters) == 1 and any((*letters, exercise) in state.balanced for exercise in (state.exercise, ""))

    def _written(self, outcome: Outcome) -> tuple[Scalar, ...]:
        """Return the torques that J^T F gives where the exercise writes that product and F has a value; else none."""
        state = self.members.names.state
        for letter in self._letters(outcome):
            product = state.balanced.get((letter, state.exercise)) or state.balanced.get((letter, ""))
            value = self._product(product) if isinstance(product, n.Product) else None
            if isinstance(value, Matrix) and value.shape == (len(self.members.names.joints), 1):
                return tuple(value.cells)
        return ()

    def _product(self, product: n.Product) -> Value:
        """Return J^T F; a force of two components acts in the plane, where nothing else tells which rows J has."""
        value, arm = self.members.evaluate(product).value, self.members.names.arm
        force = self.members.evaluate(product.factors[1]).value if value is None else None
        if arm is None or not isinstance(force, Matrix) or force.shape != (len(PLANE), 1):
            return value
        jacobian = self.members.exact.quantity(Quantity("jacobian", arm.frames[-1], arm.frames[0], rows=PLANE))
        return jacobian.transpose @ force if isinstance(jacobian, Matrix) else None

    def _refuted(self, outcome: Outcome, pairs: list[Pair]) -> Outcome:
        """Return a claim of torques that are not those of J^T F; they are no more than that."""
        assert outcome.true is not None
        alone = len(pairs) == 1 and not isinstance(outcome.true.value, Matrix)
        pair = Pair(_column(each.true for each in pairs), _column(each.printed for each in pairs), is_scalar=alone)
        self.members.names.forget(outcome.defines)  # they are not what is printed, and are asked anew
        return outcome.as_wrong_claim(pair, different_entries(pair, exactly_equal))

    @staticmethod
    def _asked(outcome: Outcome) -> int:
        """Return how many torques an outcome gives a meaning."""
        value = outcome.true.value if outcome.true is not None else None
        return as_matrix(value).shape[0] if isinstance(value, Matrix | Scalar) else 0

    def _lacking(self, outcome: Outcome) -> list[str]:
        """Return the components of forces that the document writes elsewhere, where with them the torques would be others."""
        names = self.members.names
        loads = {key for key in names.reader.spelling.loads if names.is_open(n.Name(*key.partition("_")[::2]))}
        with names.state.unchanged():
            names.state.adopted |= loads
            pairs = [*self._compared(outcome)]
        is_same = bool(pairs) and all((value - true).is_zero() for value, true in pairs)
        return [] if is_same else sorted(loads - names.state.adopted)

    def _compared(self, outcome: Outcome) -> Iterator[tuple[Scalar, Scalar]]:
        """Yield the value of each torque that an outcome gives a meaning, and what the force in it makes of it."""
        arm, true, printed = self.members.names.arm, outcome.true, outcome.printed
        if arm is None or true is None or printed is None or not outcome.defines or self._is_of_jacobian(true.node):
            return  # τ = J^T F by itself says what τ is
        values = [*as_matrix(true.value).cells] if isinstance(true.value, Matrix | Scalar) else []
        places = self._joints(printed.node, len(values))
        if len(places) != len(values):
            return
        if torques := self._written(outcome):
            yield from ((value, torques[place]) for value, place in zip(values, places, strict=True))
            return
        rows = self._rows_of_force(values) if all(isinstance(each, Scalar) for each in values) else {}
        if not rows:
            return
        jacobian = self.members.exact.quantity(Quantity("jacobian", arm.frames[-1], arm.frames[0]))
        for value, place in zip(values, places, strict=True):
            loads = [(self.members.exact.symbol(load), row) for load, row in rows.items()]
            rest = value
            for load, _ in loads:
                rest = rest - derivative(value, load) * load
            if not rest.is_zero():
                return  # gravity, friction, or another force
            first, *others = [load * jacobian.rows[row][place] for load, row in loads]  # type: ignore[union-attr]
            yield value, sum(others, first)

    def _rows_of_force(self, values: list[Scalar]) -> dict[str, int]:
        """Return the components of the one force that stands in values, and those beside them, each with its row of J.

        A moment that the document introduces acts as well: values without it are not decided.
        """
        adopted = self.members.names.state.adopted
        about = self._told_moments()
        held = {base for base, row in map(_component, symbols_in(values) & adopted) if row is not None}
        rows = {load: row for load in sorted(adopted - about) for base, row in [_component(load)] if base in held}
        rows |= dict.fromkeys(about, ABOUT_Z)
        acts = any(_component(load)[0] == MOMENT for load in adopted - about)
        is_of_one = len(held - {MOMENT}) == 1 and acts is (MOMENT in held)
        return {load: row for load, row in rows.items() if row is not None} if is_of_one else {}

    def _told_moments(self) -> set[str]:
        """Return the letters that the text calls a moment, of an arm that turns about z alone: there they can be about nothing else."""
        names = self.members.names
        told = {*names.reader.spelling.moments} & names.state.adopted
        if not told or names.arm is None:
            return set()
        whole = self.members.exact.quantity(Quantity("jacobian", names.arm.frames[-1], names.arm.frames[0]))
        is_planar = all(cell.is_zero() for row in whole.rows[2:ABOUT_Z] for cell in row)  # type: ignore[union-attr]
        return told if is_planar else set()

    def _is_of_jacobian(self, node: n.Node) -> bool:
        """Whether a formula holds a matrix of the arm: what is made of its lengths, angles and coordinates, x F_y - y F_x, holds none."""
        found = (self.members.quantity_of(below) for below in n.walk(node))
        return any(quantity is not None and not quantity.scalar for quantity in found)

    def _joints(self, node: n.Node, count: int) -> list[int]:
        """Return the joints (from 0) whose torques a side names: τ_2, a column of such, τ as a whole."""
        letters = [*self.members.names.joints]
        joints = len(letters)
        effort = bare(node)
        if isinstance(effort, n.Name) and (own := joint_of_effort(effort, self.members.names)) is not None:
            return [letters.index(own)] if count == 1 else []
        if bare_key(node) in TORQUES:
            return [*range(joints)] if count == joints else []
        named = [bare(cell) for cell in cells_of(node) or (node,)]
        numbers = [each.sub for each in named if isinstance(each, n.Name) and each.base in TORQUES and not each.dots]
        known = all(number.isdigit() and 1 <= int(number) <= joints for number in numbers)
        return [int(number) - 1 for number in numbers] if known and len(numbers) == len(named) else []


def _column(parts: Iterable[Matrix]) -> Matrix:
    return Matrix(tuple((cell,) for part in parts for cell in part.cells))


def _component(load: str) -> tuple[str, int | None]:
    """F_x → F and the first row, M_z → M and the last one; a load without a direction has no row."""
    base, _, direction = load.partition("_")
    if base not in ("F", "f", MOMENT) or direction not in COMPONENTS:
        return base, None
    return base, COMPONENTS.index(direction) + (len(COMPONENTS) if base == MOMENT else 0)
