"""Names of several letters that are typed as in a program, VT1 = A_1^{-1} T and pos_{ee} = […]: whole sides, and no products."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex

_NUMBERED = regex(r"[A-Z]{2,4}\d")
_WORD = regex(r"(?=.*[aeiouy])(?=.*[^aeiouy])[a-z]{3,10}")


def with_spelt_names(chain: n.Chain, names: Names) -> n.Chain:
    """Return a chain in which a side of letters that touch is the name they spell: its first one if that is new, the others once it is defined."""
    members = [_spelt(node, names, is_first=not place) or node for place, node in enumerate(chain.members)]
    return replace(chain, members=tuple(members)) if tuple(members) != chain.members else chain


def _spelt(node: n.Node, names: Names, *, is_first: bool) -> n.Name | None:
    letters = node.factors if isinstance(node, n.Product) and not any(node.operators) else ()
    word = _word([each for each in letters if isinstance(each, n.Name)]) if _touch(letters) else None
    if word is None:
        return None
    is_new = is_first and any(_is_new(each, names) for each in letters if isinstance(each, n.Name))
    return replace(word, span=node.span) if is_new or word.key in names.state.definitions else None


def _is_new(letter: n.Name, names: Names) -> bool:
    return names.is_open(letter) and letter.key not in names.used


def _touch(letters: Sequence[n.Node]) -> bool:
    """Whether names stand one at the other, without a blank: VT1, and not V T_1."""
    are_names = len(letters) > 1 and all(isinstance(each, n.Name) and len(each.base) == 1 for each in letters)
    return are_names and all(one.span[1] == other.span[0] for one, other in pairwise(letters))


def _word(letters: Sequence[n.Name]) -> n.Name | None:
    """Return the name that letters spell, of which the first has what stands before it, and the last what stands behind."""
    first, last = letters[0], letters[-1]
    if any(each.sub or each.sup or each.primes or each.dots for each in letters[:-1]) or last.dots:
        return None
    if any(each.pre_sup or each.pre_sub for each in letters[1:]):
        return None
    base = "".join(each.base for each in letters)
    is_numbered = last.text == f"{last.base}{last.sub}" and _NUMBERED.fullmatch(f"{base}{last.sub}") is not None
    if not (is_numbered or _WORD.fullmatch(base)):
        return None
    return replace(last, base=base, pre_sup=first.pre_sup, pre_sub=first.pre_sub, text=f"\\mathrm{{{base}}}")
