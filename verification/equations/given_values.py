"""What a display gives and does not claim: a configuration, a length's value, where the tool is to be."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.numeric_matrices import is_number
from armproof.verification.latex import nodes as n


class Given:
    """Recognises displays that give data, and keeps the values that they give."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names

    def is_configuration(self, chain: n.Chain) -> bool:
        """A joint variable set to a constant, or a determinant set to zero, states a condition and claims nothing."""
        left, right, *more = chain.members if len(chain.members) > 1 else (chain.members[0], chain.members[0])
        if more and not all(is_number(node) for node in (right, *more)):
            return False
        if isinstance(left, n.Sequence) and isinstance(right, n.Sequence) and len(left.items) == len(right.items):
            pairs = [n.Chain(pair, ("=",), span=chain.span) for pair in zip(left.items, right.items, strict=True)]
            return all(self.is_configuration(pair) for pair in pairs)
        if isinstance(left, n.Call) and left.function == "det" and isinstance(right, n.Number) and right.value == 0:
            at_values = any(isinstance(below, n.At) for below in n.walk(left))  # det J|_{θ_3 = 0} = 0 is a claim
            return not at_values and not self._vanishes(left)
        if self.names.arm is None or not isinstance(left, n.Name):
            return False
        symbol = self.names.known_symbol(left.key)
        if left.dots and self.names.known_symbol(replace(left, dots=0).key) is not None:
            return is_number(right)
        if left.dots or symbol is None:
            return not left.dots and self._is_given_coordinate(left, right)
        if symbol not in {joint.symbol for joint in self.names.arm.joints}:
            return self._is_given_length(symbol, right)
        names = [below.key for below in n.walk(right) if isinstance(below, n.Name)]
        calls = any(isinstance(below, n.Call | n.JointAngles | n.Matrix) for below in n.walk(right))
        if (calls and not is_number(right)) or not all(key in ("pi", "k", "n") for key in names):
            return False
        self._remember(symbol, right)
        return True

    def _is_given_coordinate(self, name: n.Name, value: n.Node) -> bool:
        """P_x = 0.5 is where the tool is asked to be, when P_x depends on the joints; P_x = 0 would be a claim."""
        quantity = self.names.quantity(name)
        if quantity is None or not quantity.scalar or not is_number(value):
            return False
        numbers = [below for below in n.walk(value) if isinstance(below, n.Number)]
        return any("." in number.text or number.value >= 2 for number in numbers)

    def _is_given_length(self, symbol: str, value: n.Node) -> bool:
        """A length set to a number is data: its symbol stands for any."""
        arm = self.names.arm
        if arm is None or symbol not in arm.lengths:
            return False
        if any(isinstance(below, n.Name | n.Call | n.Matrix) for below in n.walk(value)):
            return False
        self._remember(symbol, value)
        return True

    def _remember(self, symbol: str, value: n.Node) -> None:
        """Keep the value that a display gives a joint or a length, for the numeric matrices that follow."""
        member = self.checker.member(value)
        if member.known:
            self.names.state.configuration[symbol] = float(self.checker.sampled().from_exact(member.value)[0])

    def _vanishes(self, node: n.Node) -> bool:
        member = self.checker.member(node)
        constant = isinstance(member.value, Scalar) and member.value.as_fraction() is not None
        return member.problem is not None or constant or bool(getattr(member.value, "is_zero", bool)())
