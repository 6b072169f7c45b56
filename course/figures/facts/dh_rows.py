"""The Denavit–Hartenberg parameters of an arm's frames, read off its kinematics, whichever of the two conventions they keep."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import Literal

import numpy as np

from armproof.course.links import classic_link, modified_link
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import BulkKinematics, bulk_of
from armproof.models.dh.entry import LinearForm
from armproof.models.exact.trace import trace_of

_TOLERANCE = 1e-9
_TRIED = 4  # configurations at which a convention must hold
_SEED = 2019
Parameters = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class LinkRow:
    """A row of a DH table, from one frame to the next; a and d in metres, alpha and theta in radians.

    Attributes:
        frame, previous: the names of the frames.
        joint: the joint variable.
    """

    frame: str
    previous: str
    joint: str
    a: LinearForm
    alpha: LinearForm
    d: LinearForm
    theta: LinearForm


@dataclass(frozen=True)
class LinkRows:
    """The DH table of an arm: its convention, and a row for each joint."""

    convention: Literal["classic", "modified"]
    rows: tuple[LinkRow, ...]


@lru_cache(maxsize=64)
def chain_frames(arm: Arm) -> tuple[str, ...]:
    """Return the frame of the base and the first frame that each joint carries, n + 1 names."""
    depths = {frame: max(trace_of(arm).depth(frame), 0) for frame in arm.frames}
    firsts = {depth: frame for frame, depth in reversed(depths.items())}
    return tuple(firsts[k] for k in range(len(arm.joints) + 1) if k in firsts)


@lru_cache(maxsize=64)
def link_rows(arm: Arm) -> LinkRows | None:
    """Return the DH table that the frames of an arm keep, None if they keep neither convention."""
    frames = chain_frames(arm)
    if len(frames) != len(arm.joints) + 1:
        return None
    if arm.dh is not None and not arm.dh.has_fixed:
        rows = zip(frames, frames[1:], arm.dh.rows, strict=False)
        own = (LinkRow(frame, before, row.joint, row.a, row.alpha, row.d, row.theta) for before, frame, row in rows)
        return LinkRows(arm.dh.convention, tuple(own))
    for convention in ("classic", "modified"):
        if all(_fits(arm, frame, previous, convention) for previous, frame in pairwise(frames)):
            found = (_row(arm, k, frames[k], frames[k - 1], convention) for k in range(1, len(frames)))
            return LinkRows(convention, tuple(found))
    return None


def _parameters(X: np.ndarray, convention: str) -> np.ndarray:
    """Return a, α, d, θ of link matrices (N, 4, 4) if they are such matrices, (N, 4)."""
    if convention == "classic":
        theta = np.arctan2(X[:, 1, 0], X[:, 0, 0])
        alpha = np.arctan2(X[:, 2, 1], X[:, 2, 2])
        a = X[:, 0, 3] * np.cos(theta) + X[:, 1, 3] * np.sin(theta)
        d = X[:, 2, 3]
    else:
        theta = np.arctan2(-X[:, 0, 1], X[:, 0, 0])
        alpha = np.arctan2(-X[:, 1, 2], X[:, 2, 2])
        a = X[:, 0, 3]
        d = -X[:, 1, 3] * np.sin(alpha) + X[:, 2, 3] * np.cos(alpha)
    return np.stack([a, alpha, d, theta], axis=1)


def link_matrices(parameters: np.ndarray, convention: str) -> np.ndarray:
    """Return the link matrices of parameters (N, 4) of a, α, d, θ: Rz Tz Tx Rx, or modified Rx Tx Rz Tz; (N, 4, 4)."""
    link = classic_link if convention == "classic" else modified_link
    return np.array([link(*row) for row in parameters])


def _fits(arm: Arm, frame: str, previous: str, convention: str) -> bool:
    """Whether the poses of a frame in the one before are link matrices, of one joint and with constant a and α."""
    q = np.random.default_rng(_SEED).uniform(-1.0, 1.0, (_TRIED, len(arm.joints)))
    X = bulk_of(arm).pose(q, frame, previous)
    found = _parameters(X, convention)
    constant = np.ptp(found[:, 0]) < _TOLERANCE and np.ptp(np.cos(found[:, 1])) < _TOLERANCE
    moving = np.ptp(found[:, 2]) > _TOLERANCE, np.ptp(found[:, 3]) > _TOLERANCE
    return bool(constant and sum(moving) <= 1 and np.allclose(link_matrices(found, convention), X, atol=_TOLERANCE))


def _row(arm: Arm, k: int, frame: str, previous: str, convention: str) -> LinkRow:
    """Return a row, each parameter a sum of lengths, of the joint variable and of a number."""

    def parameters(bulk: BulkKinematics, moved: float = 0.0) -> np.ndarray:
        q = np.zeros((1, len(arm.joints)))
        q[0, k - 1] = moved
        return np.asarray(_parameters(bulk.pose(q, frame, previous), convention)[0])

    at_zero = parameters(bulk_of(arm))
    joint = arm.joints[k - 1]
    by_joint = parameters(bulk_of(arm), 1.0) - at_zero
    by_joint[[1, 3]] = (by_joint[[1, 3]] + np.pi) % (2 * np.pi) - np.pi
    slopes = {joint.symbol: by_joint}
    for symbol, value in arm.lengths.items():
        slopes[symbol] = parameters(bulk_of(arm).with_values({symbol: value + 1.0})) - at_zero
    a, alpha, d, theta = (
        linear_form(at_zero[p], {s: v[p] for s, v in slopes.items()}, arm, angle=p in (1, 3)) for p in range(4)
    )
    return LinkRow(frame, previous, joint.symbol, a, alpha, d, theta)


def linear_form(value: float, slopes: dict[str, float], arm: Arm, *, angle: bool = False) -> LinearForm:
    """Return the sum that has a value at the arm's lengths and q = 0, and slopes in some symbols.

    Args:
        angle: whether it is one, of which multiples of π are told.
    """
    terms = tuple(
        (symbol, Fraction(slope).limit_denominator(12)) for symbol, slope in slopes.items() if abs(slope) > 1e-7
    )
    rest = value - sum(float(factor) * arm.lengths.get(symbol, 0.0) for symbol, factor in terms)
    turns = Fraction(rest / np.pi).limit_denominator(360) if angle else Fraction(0)
    if angle and abs(rest - float(turns) * np.pi) < 1e-7:
        return LinearForm(terms, turns)
    return LinearForm(terms, Fraction(0), Fraction(0) if abs(rest) < 1e-9 else Fraction(rest).limit_denominator(10**6))
