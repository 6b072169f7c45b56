"""Indexed names: which scripts are part of a name, and which act on it."""

from __future__ import annotations

import re

from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import OPERATORS, Item, Script
from armproof.verification.latex.scripts import ScriptReader
from armproof.verification.latex.tokens import canonical_script

TRANSFORM_LETTERS = frozenset("TAHR")
VECTOR_LETTERS = frozenset(
    ["p", "P", "z", "Z", "O", "o", "x", "y", "X", "Y", "J", "v", "V", "omega", "Omega", "W", "w"]
)
_SIZE = re.compile(r"\(?\dx[1-9n]\)?")
_SIZED = frozenset(["I", "Id", "E", "O", "J"])  # whose size is part of the name, or a claim


class NameReader(ScriptReader):
    """Reads an item with its scripts as a name."""

    def name(self, item: Item) -> n.Node:
        """An indexed name with its scripts; what is an operator or a power above it is applied to it."""
        pre_sub = pre_sup = ""
        for kind, text, _ in item.pre:
            if kind == "SUB":
                pre_sub = canonical_script(text)
            else:
                pre_sup = canonical_script(text)
        sub = sup = ""
        primes = dots = 0
        end = self._end_of_base(item)
        above: list[Script] = []
        has_sub = any(kind == "SUB" for kind, _, _ in item.scripts)
        for kind, text, span in item.scripts:
            canonical = canonical_script(text)
            if kind == "PRIME":
                primes += len(text)
            elif kind == "DOT":
                dots += 1
            elif kind == "AT":
                above.append((kind, text, span))
                continue
            elif kind == "SUB" and _SIZE.fullmatch(canonical) and item.base not in _SIZED:
                pass  # R_{3×3}: how large it is
            elif kind == "SUB":
                sub = f"{sub},{canonical}" if sub else canonical
            elif self._is_index(item.base, canonical, sub, has_sub, bool(item.pre)):
                sup = f"{sup},{canonical}" if sup else canonical
            elif canonical == "":
                pass
            else:
                above.append((kind, text, span))
                continue
            end = max(end, span[1])
        end = max(end, item.end if not above else end)
        text = self.text[item.start : end]
        name: n.Node = n.Name(item.base, sub, sup, pre_sub, pre_sup, primes, dots, text, span=(item.start, end))
        return self.scripted(name, above, item.start)

    def _end_of_base(self, item: Item) -> int:
        """Return where an item's letter ends: before the mark of its first script, as \\lambda does in \\lambda^{2}."""
        if not item.scripts:
            return item.end
        head = self.text[item.start : item.scripts[0][2][0]]
        letter = re.sub(r"\s*(?:\{\s*\})?\s*[_^]?\s*\{?\s*$", "", head)
        return item.start + max(1, len(letter))

    def _is_index(self, base: str, canonical: str, sub: str, has_sub: bool, prescripted: bool) -> bool:
        """Whether what stands above a name is part of the name (T^0_1, P^0_{1,G}) and not a power or an operator."""
        if not canonical:
            return False
        key = f"{base}_{sub}^{canonical}" if sub else f"{base}^{canonical}"
        if self.is_bound(key):
            return True
        if canonical in OPERATORS:
            return False
        if not re.fullmatch(r"[A-Za-z0-9_,]+(?:[-+]\d)?", canonical):
            return False
        if canonical == "0":
            return True
        digits = canonical.isdigit()
        if base in TRANSFORM_LETTERS and has_sub and not prescripted:
            return True
        if base in VECTOR_LETTERS and has_sub and not prescripted:
            of_frame = sub[:1].isdigit() or bool(re.match(r"[a-zA-Z]-\d", sub))
            return not digits or (of_frame and not re.search(r"[xyzXYZ]$", sub))
        return not digits and has_sub and len(canonical) <= 3 and canonical not in ("n", "k", "m")
