"""Whether a family bounds what the tool can reach, or lies inside it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

import numpy as np

from armproof.models.bulk.bulk import BulkKinematics, bulk_of
from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.singularities.decomposition import Decomposer, Lengths
from armproof.verification.singularities.factors import Factor, Kind
from armproof.verification.singularities.families import Position
from armproof.verification.singularities.jacobians import ChosenJacobian
from armproof.verification.singularities.linear import Rows, eliminate
from armproof.verification.singularities.points import Sampler
from armproof.verification.singularities.reach import Reach, typical_size
from armproof.verification.singularities.second_order import image_dimension, image_rows, lost_and_signs
from armproof.verification.singularities.variety import Variety
from armproof.verification.singularities.writing import write_condition

TRIED = 16
MOST_TERMS = 2_000


@dataclass(frozen=True, eq=False)
class Placement:
    """Decides for each family where its image lies in the set of what the tool reaches without joint limits.

    Attributes:
        chosen: the Jacobian. rows: its polynomial form. rank: its generic rank.
        sampler: evaluates conditions at the arm's lengths. positive: the symbols of the lengths.
    """

    chosen: ChosenJacobian
    rows: Rows
    rank: int
    sampler: Sampler
    positive: frozenset[str]

    def place(self, variety: Variety, rng: np.random.Generator) -> Position:
        """Return where the image of a family lies."""
        if self.rank < len(self.rows):
            return Position(
                "not decided", "proved", look_up("J has more rows than its rank: ask for as many rows as that")
            )
        if not self._is_task():
            return Position("not decided", "proved", look_up("rows in axes that move are not the motion of anything"))
        codimension = self.rank - image_dimension(variety, self.rows, self.sampler)
        if codimension >= 2:
            reason = written("the image of the family has {count} dimensions fewer than the task, so it bounds nothing",
                             count=codimension)  # fmt: skip
            return Position("inside", "proved", reason)
        if eliminate(variety, self.rows).rank < self.rank - 1:
            return Position(
                "not decided", "proved", look_up("more than one direction is lost on an image that could bound")
            )
        return self._by_sampling(variety, rng)

    def _is_task(self) -> bool:
        """Whether the rows are the derivative of some coordinates of the pose: in the base's axes, or all of v or of ω."""
        whole = self.chosen.rows in ((1, 2, 3), (4, 5, 6), (1, 2, 3, 4, 5, 6))
        return whole or self.chosen.expressed_in == self.chosen.arm.frames[0]

    def special(self, variety: Variety) -> dict[str, Position]:
        """Return the position under conditions on the lengths, such as a_1 = a_2, under which the image is smaller."""
        if self.rank < len(self.rows) or variety.chain:
            return {}
        found: dict[str, Position] = {}
        usual = image_dimension(variety, self.rows, self.sampler)
        for factor in self._length_factors(variety, usual):
            decomposer = Decomposer(variety.half, self.positive, lengths=Lengths.LINEAR)
            for narrowed in decomposer.decompose([factor.polynomial], variety):
                dimension = image_dimension(narrowed, self.rows, self.sampler)
                if dimension < usual and self.rank - dimension >= 2:
                    reason = written("the image of the family then has {count} dimensions fewer than the task, so it bounds nothing",
                                     count=self.rank - dimension)  # fmt: skip
                    found[write_condition(factor)] = Position("inside", "proved", reason)
        return found

    def _length_factors(self, variety: Variety, size: int) -> list[Factor]:
        """Return the relations between lengths that divide every minor of the family's image."""
        half = variety.half
        moved = Matrix(image_rows(variety, self.rows, self.sampler)).map(variety.substituted)
        if size == 0 or moved.shape[0] != size or sum(map(len, moved.cells)) > MOST_TERMS:
            return []
        minors = [m for m in moved.minors(tuple(range(size))).values() if not m.is_zero()]
        common = reduce(lambda a, b: a.gcd(b), minors)
        factors = [Factor(half, f, self.positive) for f, _ in half.factors(common)]
        return [factor for factor in factors if factor.kind is Kind.LENGTHS]

    def _by_sampling(self, variety: Variety, rng: np.random.Generator) -> Position:
        """Return where an image of one dimension fewer than the task lies, from the form of second order and a search."""
        arm = self.chosen.arm
        q = self.sampler.sample([factor.polynomial for factor in variety.conditions], rng, TRIED)
        if not len(q):
            return Position(
                "not decided", "confirmed", look_up("no configuration of the family at the arm's own lengths")
            )
        kinematics = bulk_of(arm)
        J = np.array(kinematics.jacobian(q, self.chosen.frame))
        w, signs = lost_and_signs(J, self.chosen.rows, self.chosen.columns, self.rank - 1)
        if np.isnan(signs).any():
            return Position(
                "not decided", "confirmed", look_up("the motion of second order is not clear at some configurations")
            )
        if (signs == 0).all():
            reason = written("the form of second order takes both signs: null motions leave to either side, at {count} configurations",
                             count=len(q))  # fmt: skip
            return Position("inside", "confirmed", reason)
        return self._searched(kinematics, q, w, signs, rng)

    def _searched(
        self, kinematics: BulkKinematics, q: np.ndarray, w: np.ndarray, signs: np.ndarray, rng: np.random.Generator
    ) -> Position:
        size = typical_size(kinematics, self.chosen.frame, self.sampler.draw(rng, 64))
        reach = Reach(self.chosen.arm, kinematics, self.chosen.frame, self.chosen.rows, self.chosen.columns, size)
        inside = signs == 0
        one_sided = ~inside
        inside[one_sided] = reach.beyond(q[one_sided], -signs[one_sided, None] * w[one_sided], rng)
        if not inside.any():
            template = noted(
                "in this posture the tool stays on one side, and no other posture reaches beyond, at {count} configurations"
            )
            return Position("boundary", "confirmed", written(template, count=len(q)))
        if inside.all():
            template = noted(
                "in this posture the tool stays on one side, but others reach beyond, at {count} configurations"
            )
            return Position("inside", "confirmed", written(template, count=len(q)))
        template = noted(
            "in this posture the tool stays on one side; others reach beyond at {part} of {count} configurations"
        )
        return Position("boundary in part", "confirmed", written(template, part=int(inside.sum()), count=len(q)))
