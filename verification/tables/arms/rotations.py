"""Rotations between the frames of a wrist, {}^3R_4, as transforms without lengths."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix, column, pose_of
from armproof.verification.latex import nodes as n

_TRANSFORMS = "TAHM"


def as_transforms(chain: n.Chain) -> n.Chain:
    """Return a chain with {}^3T_4 for {}^3R_4, in which transforms of other letters are none."""
    named = [each for each in n.names(chain) if each.base in ("R", *_TRANSFORMS)]
    found = {id(each): replace(each, base="T" if each.base == "R" and _is_placed(each) else "R") for each in named}
    return n.substitute_each(chain, found)  # type: ignore[return-value]


def _is_placed(name: n.Name) -> bool:
    return bool(name.sub or name.pre_sub) and bool(name.sup or name.pre_sup)


def without_lengths(rotation: Matrix) -> Matrix:
    """Return the pose that turns so about one point."""
    ring = rotation.cells[0].ring
    return pose_of(rotation, column([ring.zero] * 3), ring.zero, ring.one)
