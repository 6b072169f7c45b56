"""Where the rank drops further on a family: on intersections with others, and where a family is itself singular."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.singularities.decomposition import Decomposer
from armproof.verification.singularities.elimination import BeyondReach
from armproof.verification.singularities.half_angles import Polynomial
from armproof.verification.singularities.linear import Rows, eliminate, maximal_minors
from armproof.verification.singularities.points import Sampler
from armproof.verification.singularities.variety import Variety

MOST_SETS = 60
SECONDS_A_SET = 1.0


@dataclass(frozen=True, eq=False)
class Descent:
    """Follows the rank of J down from its families.

    Attributes:
        families: where the rank is below its generic value. rows, simple: J, as polynomials and as scalars.
        square: whether J is square and of full rank at a generic configuration.
        sampler, decomposer: for derivatives, and for systems of equations on a family.
        known: the minors of J by size, as they are computed. given_up: what could not be followed exactly.
    """

    families: Sequence[Variety]
    rows: Rows
    simple: Matrix
    square: bool
    sampler: Sampler
    decomposer: Decomposer
    known: dict[int, list[Polynomial]] = field(default_factory=dict)
    given_up: list[str] = field(default_factory=list)

    def run(self) -> list[Variety]:
        """Return sets inside the families on which the rank is lower than on the family, those of special lengths last.

        Where J is square, every derivative of det J vanishes where two ranks are lost: on the intersection of two families,
        or where the gradient of a family's own condition vanishes. On each of these the rank decides, or the minors do.
        """
        found: list[tuple[int, Variety]] = []
        level = list(self.families)
        while level and len(found) < MOST_SETS:
            deeper = [(self._rank(lower), lower) for variety in level for lower in self._followed(variety)]
            deeper.sort(key=lambda item: (len(item[1].lengths), item[1].codimension))
            level = []
            for rank, variety in deeper:
                if not any(rank >= other_rank and variety.is_within(other) for other_rank, other in found):
                    found.append((rank, variety))
                    level += [] if variety.lengths else [variety]
        return [variety for _, variety in sorted(found, key=lambda item: (len(item[1].lengths), -item[0]))]

    def _followed(self, variety: Variety) -> list[Variety]:
        """Return the sets of lower rank on a set, as far as they are found before something is beyond reach."""
        found: list[Variety] = []
        try:
            for lower in self._lower(variety):
                found.append(lower)
        except BeyondReach as problem:
            self.given_up.append(str(problem))
        return found

    def _rank(self, variety: Variety) -> int:
        return eliminate(variety, self.rows).rank

    def _lower(self, variety: Variety) -> Iterator[Variety]:
        rank = self._rank(variety)
        if rank == 0:
            return
        if not self.square:
            yield from self._by_minors(variety, rank)
            return
        for candidate in self._candidates(variety):
            if self._rank(candidate) < rank:
                yield candidate
            elif not candidate.lengths:
                yield from self._by_minors(candidate, rank)

    def _by_minors(self, variety: Variety, rank: int) -> list[Variety]:
        try:
            return self.decomposer.decompose(self._minors(rank), variety, SECONDS_A_SET)
        except BeyondReach as problem:
            self.given_up.append(str(problem))
            return []

    def _minors(self, size: int) -> list[Polynomial]:
        if size not in self.known:
            polynomial = self.decomposer.half.polynomial
            self.known[size] = [polynomial(minor) for minor in maximal_minors(self.simple, size)]
        return self.known[size]

    def _candidates(self, variety: Variety) -> Iterator[Variety]:
        for other in self.families:
            if not variety.is_within(other):
                equations = [factor.polynomial for factor in other.conditions]
                yield from self.decomposer.decompose(equations, variety)
        yield from self.decomposer.decompose(self._gradients(variety), variety)

    def _gradients(self, variety: Variety) -> list[Polynomial]:
        """Return the derivatives of the relations of a set: where all vanish it is not smooth."""
        found = [d for relation in variety.chain for d in self.sampler.derivatives(relation.polynomial).values()]
        return found or [self.decomposer.half.one]
