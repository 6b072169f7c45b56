"""The letters that a document has for a and d in the matrix of any link: r_i or l_i for a_i, Khalil's d_j and r_j."""

from __future__ import annotations

from itertools import permutations

from armproof.verification.latex import nodes as n

LENGTHS = frozenset("adlLrRhbeg")
USUAL = ("a", "d")
_INDEX = ("i", "i-1")


def letterings(chain: n.Chain, is_modified: bool = False) -> tuple[dict[str, str], ...]:
    """Return what the letters of a link matrix may stand for, by key; only the usual letters are no choice, and more than two none.

    Where `is_modified`, the document's table is of the modified convention: its row i may have a_{i-1} and α_{i-1} as a_i and α_i.
    """
    names = [below for member in chain.members for below in n.names(member)]
    of_lengths = [
        name for name in names if name.base in LENGTHS and name == n.Name(name.base, name.sub) and name.sub in _INDEX
    ]
    bases = tuple(sorted({name.base for name in of_lengths}))
    if set(bases) <= set(USUAL) or len(bases) > len(USUAL):
        return ({}, *_of_rows(names)) if is_modified else ({},)
    found = [
        {name.key: f"{meant[name.base]}_{name.sub}" for name in of_lengths}
        for usual in permutations(USUAL, len(bases))
        if (meant := dict(zip(bases, usual, strict=True))) and not ("a" in bases and meant["a"] == "d")
    ]
    return (*found, *_of_khalil(names, bases))


def _of_rows(names: list[n.Name]) -> tuple[dict[str, str], ...]:
    """Return the a_i and α_i of row i as what they are of the modified convention, where no letter has the index before."""
    meant = {"a_i": "a_i-1", "alpha_i": "alpha_i-1"}
    own = {name.key for name in names if name.base in ("a", "alpha")}
    return (meant,) if own == {*meant} else ()


def _of_khalil(names: list[n.Name], bases: tuple[str, ...]) -> tuple[dict[str, str], ...]:
    """Return Khalil's letters, d_j and α_j of the link before and r_j, as those of the modified convention."""
    if bases != ("d", "r") or any(name.base == "alpha" and name.sub != "i" for name in names):
        return ()
    meant = {"d_i": "a_i-1", "r_i": "d_i", "alpha_i": "alpha_i-1"}
    return ({name.key: meant[name.key] for name in names if name.key in meant},)
