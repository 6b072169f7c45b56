"""A family of singular configurations, as a value: its conditions, its rank, what is lost there, where it lies."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np

from armproof.models.arm import Arm
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.singularities.directions import Directions, directions
from armproof.verification.singularities.factors import Factor
from armproof.verification.singularities.jacobians import ChosenJacobian
from armproof.verification.singularities.linear import Rows
from armproof.verification.singularities.points import Sampler
from armproof.verification.singularities.variety import Variety

Place = Literal["boundary", "inside", "boundary in part", "not decided"]


@dataclass(frozen=True)
class Position:
    """Where the image of a family lies in the set that the tool reaches without joint limits.

    Attributes:
        kind: boundary: on its boundary; inside: among its interior points; boundary in part: some points on it, some inside.
        evidence: proved: from exact algebra alone; confirmed: found at sampled configurations of the arm's own lengths.
        statement: the reason, in words.
    """

    kind: Place
    evidence: Literal["proved", "confirmed"]
    statement: str


@dataclass(frozen=True, eq=False)
class Family:
    """Configurations at which J loses rank: an irreducible set given by conditions that all hold.

    Attributes:
        chosen, rows: the Jacobian of which it is a family: as scalars, and as polynomials of the plainest equal one.
        conditions: LaTeX of each condition, such as `\\theta_5 = 0`; all hold.
        lengths: LaTeX of the conditions on the lengths under which the family is meant, such as `a_1 = a_2`; mostly none.
        solved: LaTeX of each condition solved for a joint variable.
        existence: LaTeX of what the lengths must satisfy for it to have configurations, "" if always, None if not known.
        exists: whether it has configurations at the arm's own lengths (False where `lengths` do not hold of them).
        vanishing: a scalar a condition that is zero exactly where it holds.
        rank: of J at a generic configuration of the family, for generic lengths, by exact elimination.
        position: boundary or inside; None for an intersection.
        special: the position under a condition on the lengths, such as a_1 = a_2, that changes it.
    """

    arm: Arm
    variety: Variety = field(repr=False)
    sampler: Sampler = field(repr=False)
    chosen: ChosenJacobian = field(repr=False)
    rows: Rows = field(repr=False)
    conditions: tuple[str, ...]
    lengths: tuple[str, ...]
    solved: tuple[str, ...]
    existence: str | None
    exists: bool
    vanishing: tuple[Scalar, ...]
    rank: int
    position: Position | None = None
    special: Mapping[str, Position] = field(default_factory=dict)

    @cached_property
    def _directions(self) -> Directions:
        return directions(self.variety, self.rows, self.chosen)

    @property
    def lost(self) -> tuple[Matrix, ...]:
        """Wrenches w (columns, in the rows of J) with wᵀJ = 0 on the family and not everywhere: no twist along them is left."""
        return self._directions.lost

    @property
    def lost_nearby(self) -> tuple[Matrix, ...]:
        """The same in the axes `analysis.axes` and about the point `analysis.point`, where they are plainer."""
        return self._directions.lost_nearby

    @property
    def kept(self) -> tuple[Matrix, ...]:
        """Independent columns of J on the family: they span the twists that are left."""
        return self._directions.kept

    @property
    def kept_columns(self) -> tuple[int, ...]:
        """Which columns of J these are, from 1."""
        return self._directions.kept_columns

    @property
    def null_motions(self) -> tuple[Matrix, ...]:
        """Joint rates n (columns) with J n = 0 on the family."""
        return self._directions.null_motions

    @property
    def latex(self) -> str:
        """All conditions as one formula."""
        return r" \text{ and } ".join((*self.conditions, *self.lengths))

    @property
    def codimension(self) -> int:
        """The number of independent conditions on the joint variables."""
        return len(self.conditions)

    @property
    def factors(self) -> tuple[Factor, ...]:
        """The conditions as irreducible polynomials."""
        return self.variety.conditions

    def sample(self, rng: np.random.Generator, count: int) -> np.ndarray:
        """Return configurations of the family at random, angles within half a turn, (count, n); fewer where it has none.

        The lengths are the arm's own, or those of the sampler where the family asks for special ones.
        """
        return self.sampler.sample([factor.polynomial for factor in self.factors], rng, count)

    def distance(self, q: np.ndarray) -> np.ndarray:
        """Return to first order how far configurations (N, n) are from the family (rad, m), (N,)."""
        return self.sampler.distance([factor.polynomial for factor in self.factors], np.asarray(q, dtype=float))

    def contains(self, q: np.ndarray, tolerance: float = 1e-9) -> np.ndarray:
        """Return which configurations (N, n) lie on the family within a tolerance (rad, m), (N,) bools."""
        return np.asarray(self.distance(q) <= tolerance)


@dataclass(frozen=True, eq=False)
class SingularityAnalysis:
    """The singular configurations of a choice of rows and columns of the Jacobian of a frame.

    Attributes:
        arm, frame, expressed_in, rows, columns: what J is; rows of [v; ω] and columns from 1.
        jacobian: J.
        axes, point: the frame in whose axes, and the frame at whose origin, the Jacobian is plainest; what the families call nearby.
        generic_rank: its rank at a generic configuration.
        determinant: det J where J is square, else None.
        factored: LaTeX of det J as a product; "" where J is not square or no product was found.
        families: where the rank drops, none inside another.
        sampler: draws and evaluates configurations at the arm's lengths.
        descend: finds the intersections, with what was left out.
        complete: whether the families are all; otherwise `message` says what was beyond exact reach.
    """

    arm: Arm
    frame: str
    expressed_in: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    jacobian: Matrix
    axes: str
    point: str
    generic_rank: int
    determinant: Scalar | None
    factored: str
    families: tuple[Family, ...]
    complete: bool
    sampler: Sampler = field(repr=False)
    descend: Callable[[], tuple[tuple[Family, ...], str]] = field(repr=False)
    message: str = ""
    seconds: float = 0.0

    @cached_property
    def _descended(self) -> tuple[tuple[Family, ...], str]:
        return self.descend()

    @property
    def intersections(self) -> tuple[Family, ...]:
        """Sets inside the families on which the rank is lower still; sought when first asked for, some seconds on a 6R arm."""
        return self._descended[0]

    @property
    def left_out(self) -> str:
        """What of the intersections was beyond exact reach."""
        return self._descended[1]

    @property
    def always_regular(self) -> bool:
        """Whether no configuration is singular."""
        return self.complete and not self.families

    def contains(self, q: np.ndarray, tolerance: float = 1e-9) -> np.ndarray:
        """Return which configurations (N, n) lie on one of the families within a tolerance (rad, m), (N,) bools."""
        found = np.zeros(len(q), dtype=bool)
        for family in self.families:
            found |= family.contains(q, tolerance)
        return found
