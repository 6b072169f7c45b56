"""Soundness: the solution substituted into the forward kinematics gives the target back, on one branch.

Each step gives a joint in terms of the target and of joints solved before. These stay symbols; the forward kinematics minus
the target is a polynomial in them, and the joints are eliminated from it in the reverse order of the steps. Where it comes
out as zero, FK(IK(x)) = x for every target at which the formulas have a value.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from armproof.models.arm import Arm
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.ring import Scalar
from armproof.verification.inverse.derivation import Derivation, Signs
from armproof.verification.inverse.forward import forward_values
from armproof.verification.inverse.resolution import solve_branch
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.symbolic_algebra import SymbolicAlgebra, free_algebra, is_angle
from armproof.verification.inverse.target_values import TargetValues


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
    arm = derivation.names.arm
    assert arm is not None
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
