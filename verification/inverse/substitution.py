"""Soundness: the solution substituted into the forward kinematics gives the target back, on one branch.

Each step gives a joint in terms of the target and of joints solved before. These stay symbols; the forward kinematics minus
the target is a polynomial in them, and the joints are eliminated from it in the reverse order of the steps. Where it comes
out as zero, FK(IK(x)) = x for every target at which the formulas have a value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from armproof.models.arm import Arm
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import elementary
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.inverse.derivation import Derivation, Signs
from armproof.verification.inverse.resolution import forward_values, solve_branch
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.symbolic_algebra import SymbolicAlgebra, free_algebra, is_angle
from armproof.verification.inverse.target import Pair, Slot

TargetValues = Callable[[SubstitutionRoots, Derivation], list[Scalar]]


def any_target(turned_by: str | None = None) -> TargetValues:
    """Return targets whose numbers are free symbols, and whose rotations are any: Rot(z, φ) Rot(y, ϑ) Rot(z, ψ).

    Args:
        turned_by: a frame k. The rotation is then written {}^0R_k Q with any Q, which is any rotation as well: after the
            first k joints are solved, the steps see Q alone.
    """

    def values(roots: SubstitutionRoots, derivation: Derivation) -> list[Scalar]:
        rotations = {pair: _any_rotation(roots, derivation, pair, turned_by) for pair in derivation.target.rotations}
        return [_free(roots.ring, index, slot, rotations) for index, slot in enumerate(derivation.target.slots)]

    return values


def _any_rotation(roots: SubstitutionRoots, derivation: Derivation, pair: Pair, turned_by: str | None) -> Matrix:
    arm = derivation.arm
    algebra = free_algebra(roots.ring, arm, roots)
    angles = [roots.ring.symbol(f"angle {k} of frame {pair[0]}") for k in (1, 2, 3)]
    R = elementary(algebra, "Rot", "z", angles[0])
    R = R @ elementary(algebra, "Rot", "y", angles[1]) @ elementary(algebra, "Rot", "z", angles[2])
    R = R.block(range(3), range(3))
    if turned_by is not None:
        R = algebra.pose(turned_by, pair[1]).block(range(3), range(3)) @ R
    return R


def _free(ring: Ring, index: int, slot: Slot, rotations: dict[Pair, Matrix]) -> Scalar:
    if slot.is_constant:
        return ring.rational(1 if slot.column == 3 else 0)
    if not slot.is_name and slot.column < 3 and (slot.frame, slot.reference) in rotations:
        return rotations[slot.frame, slot.reference].rows[slot.row][slot.column]
    return ring.symbol(f"target {index}")


def target_of_a_configuration(roots: SubstitutionRoots, derivation: Derivation) -> list[Scalar]:
    """Return the target of any configuration, its joint variables being other symbols than those that are solved for."""
    arm = derivation.arm
    others = {joint.symbol: roots.ring.symbol(f"{joint.symbol} given") for joint in arm.joints}
    return [substitute(value, others) for value in forward_values(derivation, free_algebra(roots.ring, arm, roots))]


def returns_target(
    derivation: Derivation, values: TargetValues, signs: Signs, roots: SubstitutionRoots, eager: Iterable[str] = ()
) -> list[int]:
    """Return the slots of the target that the solution misses on a branch; none if FK(IK(x)) = x is proved.

    Args:
        eager: joints that do not stay symbols; those after them then see their values.

    Raises:
        TooComplex: the polynomials grow beyond the bounds.
        EvaluationError: a step that has no exact value.
    """
    arm = derivation.arm
    given = values(roots, derivation)
    algebra = SymbolicAlgebra(roots.ring, arm, derivation.target, given, roots=roots, names_stay=True, eager=eager)
    solve_branch(derivation, algebra, signs)
    forward = forward_values(derivation, free_algebra(roots.ring, arm, roots))
    missed = []
    for index, (reached, wanted) in enumerate(zip(forward, given, strict=True)):
        if not _vanishes(reached, wanted, algebra.trail, arm):
            missed.append(index)
    return missed


def _vanishes(reached: Scalar, wanted: Scalar, trail: Sequence[tuple[str, Scalar]], arm: Arm) -> bool:
    difference = reached - wanted
    for symbol, value in reversed(trail):
        if difference.is_zero():
            return True
        difference = substitute(difference, {symbol: value})
    if not difference.is_zero() and is_angle(reached, arm):
        return bool((cos_sin(difference)[0] - 1).is_zero())
    return difference.is_zero()
