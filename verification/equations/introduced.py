"""What a display introduces and does not claim: new letters, named signs."""

from __future__ import annotations

import re

from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import UnboundName
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

AUXILIARY = r"[A-HK-NQ-SU-Wa-hkmnr-w]|alpha|beta|gamma|delta|lambda|mu|rho"  # letters of a figure, not of the arm


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
