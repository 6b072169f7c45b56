"""The algebra in which a derivation is proved: solved joints stay symbols, and the target has any exact values."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from armproof.models.arm import Arm
from armproof.models.exact.polynomial import Rows
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.inverse.derivation import UnsolvedJoint
from armproof.verification.inverse.given_target import GivenTarget
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.target import Target

LONG = 6  # terms: a name with so many is a symbol until it has to be substituted


class SymbolicAlgebra(GivenTarget, ExactAlgebra):
    """Scalars of a ring in which a solved joint is a symbol of its own name; its value is substituted afterwards.

    `solved` holds the value of each joint, in terms of the target and of joints solved before; so does `trail`, with the names
    that have a symbol of their own.

    Args:
        roots: how square roots are taken, where it matters.
        names_stay: whether long values of names are symbols as well.
        eager: joints that are no symbols: their values stand wherever they occur.
    """

    def __init__(
        self,
        ring: Ring,
        arm: Arm,
        target: Target,
        values: Sequence[Scalar],
        *,
        roots: SubstitutionRoots | None = None,
        names_stay: bool = False,
        eager: Iterable[str] = (),
    ) -> None:
        ExactAlgebra.__init__(self, ring, arm)
        self.give(target, values)
        self.solved: dict[str, Scalar] = {}
        self.roots = roots
        self.names_stay = names_stay
        self.eager = frozenset(eager)
        self.trail: list[tuple[str, Scalar]] = []  # joints and long names with their values, in order
        self._joints = frozenset(joint.symbol for joint in arm.joints)

    def symbol(self, name: str) -> Scalar:
        """Return a symbol; raises UnsolvedJoint for a joint without a value."""
        if name in self._joints and name not in self.solved:
            raise UnsolvedJoint(name)
        return self.solved[name] if name in self.eager else self.ring.symbol(name)

    def solve(self, joint: str, value: Scalar) -> None:
        """Give a joint its value."""
        self.solved[joint] = value
        self.trail.append((joint, value))

    def named(self, key: str, value: Value) -> Value:
        """Return a symbol for a long value made of coordinates alone, which is substituted afterwards as that of a joint is."""
        if not self.names_stay or not isinstance(value, Scalar) or len(value.numerator) < LONG:
            return value
        if any(kind in ("cos", "sin", "arc") for kind, _ in value.generators):
            return value
        self.trail.append((f"name {key}", value))
        return self.ring.symbol(f"name {key}")

    def sign(self, name: str) -> Scalar:
        """Return one of the independent signs, +1 or −1: what is proved holds for both."""
        return self.ring.generator(("sign", name))

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root, by the rule for this proof."""
        return super().sqrt(value) if self.roots is None else self.roots.sqrt(value)

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """Return the angle of the point (x, y), by the rule for this proof."""
        return super().atan2(y, x) if self.roots is None else self.roots.atan2(y, x)

    def _from_entries(self, rows: Rows) -> Matrix:
        """Return a matrix of the arm's trace; raises UnsolvedJoint where it depends on a joint without a value."""
        for row in rows:
            for entry in row:
                for monomial in entry:
                    for (_, name), _ in monomial:
                        self.symbol(name)
        values = {joint: value for joint, value in self.solved.items() if joint in self.eager}
        matrix = super()._from_entries(rows)
        return matrix.map(lambda cell: substitute(cell, values)) if values else matrix


def free_algebra(ring: Ring, arm: Arm, roots: SubstitutionRoots | None = None) -> SymbolicAlgebra:
    """Return the algebra in which no target is given and every joint is a symbol: that of the forward kinematics."""
    algebra = SymbolicAlgebra(ring, arm, Target((), (0,), ()), (), roots=roots)
    algebra.solved = {joint.symbol: ring.symbol(joint.symbol) for joint in arm.joints}
    return algebra


def is_angle(value: Scalar, arm: Arm) -> bool:
    """Whether a value is a sum of joint angles, so that it counts up to whole turns."""
    angles = {("symbol", joint.symbol) for joint in arm.joints if joint.kind == "revolute"} | {("pi", "")}
    terms = [powers for powers, _ in value.ring.terms(value.numerator)]
    return (
        value.denominator.is_constant()
        and any(powers for powers in terms)
        and all(not powers or (len(powers) == 1 and set(powers) <= angles) for powers in terms)
    )
