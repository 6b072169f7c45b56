"""What is lost, what is kept and what does nothing on a family, as exact vectors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.ring import Scalar
from armproof.verification.singularities.half_angles import Polynomial
from armproof.verification.singularities.jacobians import ChosenJacobian, lost_from_simple
from armproof.verification.singularities.linear import Rows, as_scalars, eliminate
from armproof.verification.singularities.variety import Variety


@dataclass(frozen=True, eq=False)
class Directions:
    """Directions on a family; columns of scalars, up to a factor."""

    lost: tuple[Matrix, ...]
    lost_nearby: tuple[Matrix, ...]
    kept: tuple[Matrix, ...]
    kept_columns: tuple[int, ...]
    null_motions: tuple[Matrix, ...]


def directions(variety: Variety, rows: Rows, chosen: ChosenJacobian) -> Directions:
    """Return the wrenches that do no work there, independent columns of J, and the null motions.

    `lost_nearby` are the wrenches in the axes and at the point of the simple Jacobian, `lost` those of the Jacobian asked for.
    """
    half = variety.half
    forward = eliminate(variety, rows)
    lost = [column(as_scalars(half, w)) for w in _newly_lost(variety, rows)]
    at = partial(_on_family, _fixed_angles(variety))
    return Directions(
        tuple(at(lost_from_simple(chosen, at(w))) for w in lost),
        tuple(lost),
        tuple(at(chosen.matrix.block(range(chosen.matrix.shape[0]), [c])) for c in forward.pivots),
        tuple(chosen.columns[c] for c in forward.pivots),
        tuple(column(as_scalars(half, n)) for n in forward.null_vectors),
    )


def _newly_lost(variety: Variety, rows: Rows) -> list[tuple[Polynomial, ...]]:
    """Return left null vectors on the family that, with those of every configuration, span all of them."""
    transposed = tuple(zip(*rows, strict=True))
    here = eliminate(variety, transposed).null_vectors
    always = eliminate(Variety(variety.half), transposed).null_vectors
    if not always:
        return list(here)
    spanned: list[tuple[Polynomial, ...]] = list(always)
    found: list[tuple[Polynomial, ...]] = []
    for vector in here:
        if eliminate(variety, (*spanned, vector)).rank > eliminate(variety, tuple(spanned)).rank:
            spanned.append(vector)
            found.append(vector)
    return found


def _fixed_angles(variety: Variety) -> dict[str, Scalar]:
    """Return the angles that a family fixes, in terms of the others."""
    ring, values = variety.half.ring, dict[str, Scalar]()
    for factor in variety.factors:
        found = factor.angle_sum
        assert found is not None
        *rest, (angle, sign) = found.signs
        turned = ring.generator(("pi", "")) * ring.rational(found.turns) / 2
        values[angle] = (turned - sum((ring.symbol(other) * weight for other, weight in rest), ring.zero)) * sign
    return values


def _on_family(values: dict[str, Scalar], matrix: Matrix) -> Matrix:
    """Return a matrix with the angles that a family fixes substituted, one after the other."""
    for angle, value in values.items():
        matrix = matrix.map(partial(substitute, values={angle: value}))
    return matrix
