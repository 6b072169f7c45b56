"""Displays that give a name both signs: σ = ±1, σ ∈ {−1, 1}."""

from __future__ import annotations

from armproof.verification.latex import nodes as n
from armproof.verification.naming.trees import bare, bare_key


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
