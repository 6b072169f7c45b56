"""Lengths that a printed pose has otherwise than the arm in all of its entries: a slip in one entry does not explain that, another link would."""

from __future__ import annotations

from itertools import pairwise

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.sides import Members

FEWEST = 2  # entries in which a length stands


def lengths_against(pair: Pair, members: Members) -> frozenset[int]:
    """Return the links, counted from 1, that alone have such a length: nobody knows whether it is wrong in them, or in what is printed."""
    arm = members.names.arm
    if arm is None or pair.true.shape not in ((4, 4), (3, 1), (4, 1)):
        return frozenset()
    lengths = {*arm.lengths}
    entries = [
        (_symbols(a), _symbols(a - b)) for _, a, b in pair.entries() if isinstance(a, Scalar) and isinstance(b, Scalar)
    ]
    holding = {each: [apart for true, apart in entries if each in true] for each in lengths}
    wrong = {each for each, found in holding.items() if len(found) >= FEWEST and all(each in apart for apart in found)}
    links = enumerate((members.exact.pose(*ends) for ends in pairwise(arm.frames)), start=1) if wrong else ()
    own = {k: _of_matrix(link) & lengths for k, link in links}
    return frozenset(k for k in own for each in own[k] & wrong if sum(each in others for others in own.values()) == 1)


def _symbols(value: Scalar) -> set[str]:
    return symbols_in([value.normal()])


def _of_matrix(value: Matrix) -> set[str]:
    return set().union(*map(_symbols, value.cells))
