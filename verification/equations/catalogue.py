"""Values that bind a name: which quantity of the arm the value of a new name is, exactly or but for a slip."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import as_line, kind_of
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import (
    Pair,
    agree_exactly,
    different_entries,
    exactly_equal,
    is_constant,
    is_near,
)
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import Role, Verdict

KINDS = {(4, 4): "pose", (3, 3): "rotation", (3, 1): "origin", (2, 1): "origin"}
PARTS = (None, (1, 2, 3), (4, 5, 6), (1, 2), (1, 2, 6))  # of the rows of a Jacobian
MOST_WRONG = 2  # entries of what is meant to be a quantity


@dataclass(frozen=True)
class Catalogue:
    """Compares matrices that define a name, and are written out, with the quantities of the arm."""

    members: Members

    def judge(self, outcome: Outcome) -> Outcome:
        """Say what a matrix that is given a name is on the arm; one that is nearly a quantity, or is several, is not decided."""
        value = outcome.true.value if outcome.true is not None else None
        value = as_matrix(value) if isinstance(value, Scalar) else value
        if self.members.names.arm is None or not isinstance(value, Matrix) or is_constant(value):
            return outcome
        (name,) = outcome.defines
        pairs = [(quantity, Pair(true, value)) for quantity, true in self._alike(value)]
        exact = [quantity for quantity, pair in pairs if agree_exactly(pair)]
        if len(exact) == 1 or (exact and exact[0].scalar):
            outcome.read_as = kind_of(exact[0]).tell(exact[0])
            return outcome
        if exact:
            several = say(Kind.SEVERAL_QUANTITIES, name=name, readings=[kind_of(each).tell(each) for each in exact])
            return replace(outcome, verdict=Verdict.UNCHECKED, findings=(several,), role=Role.DEFINITION)
        return self._unless_near(outcome, name, pairs)

    def _unless_near(self, outcome: Outcome, name: str, pairs: list[tuple[Quantity, Pair]]) -> Outcome:
        near = [
            (different_entries(pair, exactly_equal), quantity, pair)
            for quantity, pair in pairs
            if is_near(pair) and (not quantity.scalar or (_has_as_many_terms(pair) and self._is_of_the_arm(pair)))
        ]
        wrong, quantity, pair = min(near, key=lambda each: len(each[0]), default=([], None, None))
        if quantity is None or pair is None or len(wrong) > MOST_WRONG:
            return outcome
        row, column = (index + 1 for index in wrong[0])
        terms = {"name": name, "reading": kind_of(quantity).tell(quantity), "line": as_line(name, quantity)}
        finding = say(Kind.NEAR_QUANTITY, row=row, column=column, **terms)
        finding = say(Kind.NEAR_COORDINATE, **terms) if quantity.scalar else finding
        self.members.names.leave_open(name, finding)
        if self._is_jacobian(outcome, quantity, pair, wrong):
            return self._refuted(outcome, quantity, pair, wrong)
        return replace(outcome, verdict=Verdict.UNCHECKED, findings=(finding,), role=Role.DEFINITION)

    def _is_jacobian(self, outcome: Outcome, quantity: Quantity, pair: Pair, wrong: list[tuple[int, int]]) -> bool:
        """Whether a J with an index of the document's own, J_r, has all rows of a Jacobian but one entry, in the arm's letters."""
        name = bare(outcome.printed.node) if outcome.printed is not None else None
        letters = self._is_of_the_arm(pair) and isinstance(name, n.Name) and name.base == "J" and not name.dots
        agreeing = sum(1 for _, a, b in pair.entries() if symbols_in([a]) and exactly_equal(a, b))
        return letters and quantity.kind == "jacobian" and len(wrong) == 1 and agreeing > len(wrong) + 1

    @staticmethod
    def _refuted(outcome: Outcome, quantity: Quantity, pair: Pair, wrong: list[tuple[int, int]]) -> Outcome:
        """Return a claim of a Jacobian with a wrong entry."""
        return replace(outcome.as_wrong_claim(pair, wrong), read_as=kind_of(quantity).tell(quantity))

    def _is_of_the_arm(self, pair: Pair) -> bool:
        """Whether a scalar holds the arm's letters alone: d_1 - Z - d_4 is a joint solved for, and no slip in z."""
        arm = self.members.names.arm
        assert arm is not None
        return symbols_in(pair.printed.cells) <= {*arm.lengths, *(joint.symbol for joint in arm.joints)}

    def _alike(self, value: Matrix) -> Iterator[tuple[Quantity, Matrix]]:
        """Yield the quantities of a size, each with its value; of two frames that are one, the first."""
        seen: list[Matrix] = []
        for quantity in self._quantities(value.shape):
            true = self.members.exact.quantity(quantity)
            true = as_matrix(true) if isinstance(true, Scalar) else true
            if isinstance(true, Matrix) and not is_constant(true) and true.shape == value.shape and true not in seen:
                seen.append(true)
                yield quantity, true

    def _quantities(self, shape: tuple[int, int]) -> Iterator[Quantity]:
        arm = self.members.names.arm
        assert arm is not None
        rows = (1, 2) if shape == (2, 1) else None
        for index, frame in enumerate(arm.frames[1:]):
            for reference in dict.fromkeys((arm.frames[0], arm.frames[index])):
                if shape == (1, 1) and reference == arm.frames[0]:
                    yield from (Quantity("origin", frame, reference, rows=(row,), scalar=True) for row in (1, 2, 3))
                if shape in KINDS:
                    yield Quantity(KINDS[shape], frame, reference, rows=rows)
        if shape[1] == len(arm.joints):
            whole = Quantity("jacobian", arm.frames[-1], arm.frames[0])
            yield from (replace(whole, rows=part) for part in dict.fromkeys((*PARTS, self._moving(whole))))

    def _moving(self, jacobian: Quantity) -> tuple[int, ...]:
        """Return the rows of a Jacobian in which some joint moves the tool: four of a SCARA."""
        rows = self.members.exact.quantity(jacobian).rows
        return tuple(number for number, row in enumerate(rows, 1) if not all(cell.is_zero() for cell in row))


def _has_as_many_terms(pair: Pair) -> bool:
    """Whether two scalars are sums of as many terms: l_2 c_{12} is a part of p_x, and no slip in it."""
    sides = (side.rows[0][0] for side in (pair.true, pair.printed))
    return len({len([*side.ring.terms(side.numerator)]) for side in sides}) == 1
