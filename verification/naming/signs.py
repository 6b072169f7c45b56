"""Signs that have a name, σ = ±1, σ ∈ {−1, 1}: what holds them holds on one of their branches."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product

from armproof.verification.latex import nodes as n
from armproof.verification.naming.trees import bare, bare_key


@dataclass
class NamedSigns:
    """The named signs of a document, each with the value that it has on the branch at hand."""

    values: dict[str, int] = field(default_factory=dict)
    read: set[str] = field(default_factory=set)  # those that an evaluation has met since this was emptied
    lines: dict[str, int] = field(default_factory=dict)  # of the displays that name them

    def value(self, key: str) -> int | None:
        """Return the value of a sign, or None for another name."""
        if key in self.values:
            self.read.add(key)
        return self.values.get(key)

    def name(self, key: str, line: int) -> None:
        """Take a name for a sign, as a display says."""
        self.values[key] = 1
        self.lines.setdefault(key, line)

    def copy(self) -> NamedSigns:
        """Return the signs as they are now."""
        return NamedSigns(self.values.copy(), self.read.copy(), self.lines.copy())

    def branches(self, several: bool = True) -> Iterator[int]:
        """Yield the sign of ± on every branch, the signs that have been met having their values on it."""
        if not several:
            yield 1
            return
        met = sorted(self.read)
        for signs in product((1, -1), repeat=len(met)):
            self.values.update(zip(met, signs, strict=True))
            yield from (1, -1)
        self.values.update(dict.fromkeys(met, 1))


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
