"""Signs that have a name, σ_1 = ±1: what holds them holds on one of their branches."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product


@dataclass
class NamedSigns:
    """The named signs of a document, each with the value that it has on the branch at hand."""

    values: dict[str, int] = field(default_factory=dict)
    read: set[str] = field(default_factory=set)  # those that an evaluation has met since this was emptied

    def value(self, key: str) -> int | None:
        """Return the value of a sign, or None for another name."""
        if key in self.values:
            self.read.add(key)
        return self.values.get(key)

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
