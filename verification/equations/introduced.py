"""What a display introduces and does not claim: values of joints and lengths, where the tool is to be, new letters, named signs."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.decimals import is_number
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import UnboundName
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

AUXILIARY = r"[A-HK-NQ-SU-Wa-hkmnr-w]|alpha|beta|gamma|delta|lambda|mu|rho"  # letters of a figure, not of the arm


class GivenValues:
    """Recognises displays that give data, and keeps the values that they give."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names

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
        member = self.members.evaluate(value)
        if member.known:
            self.names.state.configuration[symbol] = float(self.members.sampled().from_exact(member.value)[0])

    def _vanishes(self, node: n.Node) -> bool:
        member = self.members.evaluate(node)
        constant = isinstance(member.value, Scalar) and member.value.as_fraction() is not None
        return member.problem is not None or constant or bool(getattr(member.value, "is_zero", bool)())


def new_name(names: Names, chain: n.Chain) -> str | None:
    """In a document of general statements, the first letter that stands alone and is new is being defined."""
    if len(chain.members) < 2:
        return None
    for place, member in enumerate(map(bare, chain.members)):
        if isinstance(member, n.Name) and place and member.dots:
            continue  # a rate on the right side is that of a variable, not a new name
        if isinstance(member, n.Name) and names.is_new(member) and member.key not in keys_beside(chain, member):
            return member.key
    return None


def new_letters(names: Names, chain: n.Chain) -> frozenset[str]:
    """The letters of the first matrix that holds nothing but new letters and numbers: a formula's value defines them."""
    for member in chain.members if not any(bare_key(node) for node in chain.members) else ():
        letters = names_alone(member)
        if (
            letters
            and all(names.is_new(letter) for letter in letters)
            and not keys_alone(member) & keys_beside(chain, member)
        ):
            return keys_alone(member)
    return frozenset()


def renew_letter(equality: Equality, chain: n.Chain) -> None:
    """A scalar letter that an earlier section defined may be defined anew: K, A, β mean something else there."""
    names = equality.names
    key = bare_key(chain.members[0])
    definition = names.state.definitions.get(key) if key is not None and names.arm is not None else None
    name = chain.members[0]
    if not isinstance(name, n.Name) or not re.fullmatch(AUXILIARY, name.base):
        return
    if definition is None or len(chain.members) < 2 or definition.by_place or definition.section == names.state.section:
        return
    if any(isinstance(below, n.Name) and below.key == key for below in n.walk(chain.members[1])):
        return
    before, now = equality.members.evaluate(chain.members[0]), equality.members.evaluate(chain.members[1])
    if not (before.known and now.known and isinstance(before.value, Scalar) and isinstance(now.value, Scalar)):
        return
    if equality.compare(before, now, 0, has_branches(chain)).verdict is Verdict.REFUTED:
        del names.state.definitions[str(key)]


def adopts_letters(sides: Members, members: list[Member]) -> bool:
    """The letters of the transform to a frame that the document adds (a tool of length L_3) become free symbols."""
    names = sides.names
    if not any(isinstance(m.node, n.Name) and names.adds_frame(m.node) for m in members):
        return False
    new: set[str] = set()
    for member in members:
        if isinstance(member.node, n.Matrix) and isinstance(member.problem, UnboundName):
            for below in n.walk(member.node):
                if (
                    isinstance(below, n.Name)
                    and not sides.evaluate(below).known
                    and below.base[:1] in "aldhLDrRkGge"
                    and not below.dots
                ):
                    new.add(below.key)
    new -= names.state.adopted
    names.state.adopted |= new
    return bool(new)


def names_alone(node: n.Node) -> list[n.Name]:
    """Return the names that a matrix of nothing but names and numbers holds."""
    node = bare(node)
    cells = [cell for row in node.rows for cell in row] if isinstance(node, n.Matrix) else []
    return [c for c in cells if isinstance(c, n.Name)] if all(isinstance(c, n.Name | n.Number) for c in cells) else []


def keys_alone(node: n.Node) -> frozenset[str]:
    """Return the keys of the names that a matrix of nothing but names and numbers holds."""
    return frozenset(name.key for name in names_alone(node))


def keys_beside(chain: n.Chain, member: n.Node) -> set[str]:
    """The names that the other members of a chain hold."""
    return {
        b.key
        for other in chain.members
        if member not in (other, bare(other))
        for b in n.walk(other)
        if isinstance(b, n.Name)
    }


def named_sign(chain: n.Chain) -> str | None:
    """Return the name to which a display gives both signs, σ = ±1 or σ ∈ {−1, 1}, or None."""
    if len(chain.members) != 2:
        return None
    left, right = chain.members
    key = bare_key(left)
    if chain.relations == ("=",) and _sign(right) == 0:
        return key
    right = bare(right)
    if chain.relations == ("∈",) and isinstance(right, n.Sequence) and sorted(map(_value, right.items)) == [-1, 1]:
        return key
    return None


def _value(node: n.Node) -> int:
    sign = _sign(node)
    return 2 if sign is None else sign


def _sign(node: n.Node) -> int | None:
    """Return 1 or −1 for that number, 0 for ±1, None for anything else."""
    node, sign = bare(node), 1
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        mark, node = node.terms[0]
        sign = {"+": 1, "-": -1}.get(mark, 0)
    node = bare(node)
    return sign if isinstance(node, n.Number) and node.value == 1 else None
