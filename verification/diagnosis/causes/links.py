"""Slips in a product of link matrices: an order, a link left out, one wrong link, the other Denavit–Hartenberg convention."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from armproof.models.exact.trace import trace_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import TOLERANCE, Candidate, Case
from armproof.verification.findings import Finding, Kind, say

CONVENTIONS = ("classic", "modified")


@dataclass(frozen=True)
class Parameters:
    """The Denavit–Hartenberg parameters of a link at N configurations, (N,) each."""

    a: np.ndarray
    alpha: np.ndarray
    d: np.ndarray
    theta: np.ndarray


def build(convention: str, p: Parameters) -> np.ndarray:
    """Return the link matrix ^{i-1}T_i of a convention, (N, 4, 4)."""
    c, s, ca, sa = np.cos(p.theta), np.sin(p.theta), np.cos(p.alpha), np.sin(p.alpha)
    zero, one = 0 * c, 1 + 0 * c
    if convention == "classic":
        rows = ((c, -s * ca, s * sa, p.a * c), (s, c * ca, -c * sa, p.a * s), (zero, sa, ca, p.d))
    else:
        rows = ((c, -s, zero, p.a), (s * ca, c * ca, -sa, -p.d * sa), (s * sa, c * sa, ca, p.d * ca))
    return np.moveaxis(np.array([*rows, (zero, zero, zero, one)]), -1, 0)


def parameters(convention: str, L: np.ndarray) -> Parameters | None:
    """Return the parameters of a link matrix, or None where it is none of the convention's."""
    if convention == "classic":
        theta, alpha = np.arctan2(L[:, 1, 0], L[:, 0, 0]), np.arctan2(L[:, 2, 1], L[:, 2, 2])
        a, d = L[:, 0, 3] * np.cos(theta) + L[:, 1, 3] * np.sin(theta), L[:, 2, 3]
    else:
        theta, alpha = np.arctan2(-L[:, 0, 1], L[:, 0, 0]), np.arctan2(-L[:, 1, 2], L[:, 2, 2])
        a, d = L[:, 0, 3], L[:, 2, 3] * np.cos(alpha) - L[:, 1, 3] * np.sin(alpha)
    found = Parameters(a, alpha, d, theta)
    return found if np.abs(build(convention, found) - L).max() < 1e-9 else None


def links(case: Case, at: NumericKinematics | None = None) -> list[np.ndarray]:
    """Return the link matrices between the two frames of a pose, (N, 4, 4) each; none where the frames are not numbered."""
    frames, quantity, plant = case.frames, case.quantity, at or case.kinematics
    if kind_of(quantity).matrix != "pose" or {quantity.frame, quantity.reference} - set(frames):
        return []
    first, last = frames.index(quantity.reference), frames.index(quantity.frame)
    return [plant.pose(frames[k], frames[k - 1]) for k in range(first + 1, last + 1)]


def product(matrices: list[np.ndarray], count: int) -> np.ndarray:
    """Return the product of (N, 4, 4) matrices."""
    total = np.broadcast_to(np.eye(4), (count, 4, 4))
    for matrix in matrices:
        total = total @ matrix
    return np.asarray(total)


def convention_of(matrices: list[np.ndarray]) -> list[str]:
    """Return the conventions in which all of the link matrices can be written."""
    return [c for c in CONVENTIONS if all(parameters(c, L) is not None for L in matrices)]


def product_candidates(case: Case) -> Iterator[Candidate]:
    """Yield products of the right link matrices in a wrong order, with one left out or repeated, or in the other convention."""
    matrices, count = links(case), len(case.q)
    if not matrices:
        return
    if len(matrices) > 1:
        yield say(Kind.LINKS_ENTRY_BY_ENTRY), case.selected(np.prod(matrices, axis=0))
        yield say(Kind.LINKS_ADDED), case.selected(np.sum(matrices, axis=0))
        for finding, changed in _rearranged(case, matrices):
            yield finding, case.selected(product(changed, count))
    kind = Kind.LINKS_OF_OTHER_CONVENTION if len(matrices) > 1 else Kind.OTHER_CONVENTION
    for convention in convention_of(matrices):
        other = other_convention(convention)
        rows = [p for L in matrices if (p := parameters(convention, L)) is not None]
        rebuilt = [build(other, p) for p in rows]
        yield say(kind, other=other, convention=convention), case.selected(product(rebuilt, count))
        for finding, shifted in _shifted(convention, rows):
            yield finding, case.selected(product([build(convention, p) for p in shifted], count))


def _shifted(convention: str, rows: list[Parameters]) -> Iterator[tuple[Finding, list[Parameters]]]:
    """Yield the rows with a and α, and with a alone, where the other convention has them: of the row below, or of the one above."""
    none = 0 * rows[0].a
    taken = [(p.a, p.alpha) for p in rows]
    others = [*taken[1:], (none, none)] if convention == "modified" else [(none, none), *taken[:-1]]
    kind = Kind.LINKS_OF_ROW_BELOW if convention == "modified" else Kind.LINKS_OF_ROW_ABOVE
    both = [replace(p, a=a, alpha=alpha) for p, (a, alpha) in zip(rows, others, strict=True)]
    yield say(kind, names=["a", "α"]), both
    yield say(kind, names=["a"]), [replace(p, a=a) for p, (a, _) in zip(rows, others, strict=True)]


def _rearranged(case: Case, matrices: list[np.ndarray]) -> Iterator[tuple[Finding, list[np.ndarray]]]:
    first = case.frames.index(case.quantity.reference)
    names = [link_name(case.frames, first + k) for k in range(len(matrices))]
    yield say(Kind.LINKS_REVERSED), matrices[::-1]
    for k in range(len(matrices) - 1):
        order = [*matrices[:k], matrices[k + 1], matrices[k], *matrices[k + 2 :]]
        yield say(Kind.LINKS_SWAPPED, one=names[k], other=names[k + 1]), order
    for k in range(len(matrices)):
        yield say(Kind.LINK_LEFT_OUT, link=names[k]), [*matrices[:k], *matrices[k + 1 :]]
        yield say(Kind.LINK_TWICE, link=names[k]), [*matrices[: k + 1], *matrices[k:]]


def link_name(frames: list[str], k: int) -> str:
    """Return the name of the k-th link matrix of a chain of frames."""
    return f"^{frames[k]}T_{frames[k + 1]}"


def other_convention(convention: str) -> str:
    """Return the other of the two Denavit–Hartenberg conventions."""
    return CONVENTIONS[1 - CONVENTIONS.index(convention)]


def wrong_link(case: Case) -> Finding | None:
    """Find the one link matrix that is wrong, the others being right, and say what is wrong in it.

    With P the pose obtained, the link that it implies is L_k = X_{0,k-1}^{-1} P X_{k,n}^{-1}. The right k is where L_k
    depends on no joint variable but its own: it is the same at two configurations that share that variable alone.
    """
    matrices = links(case)
    if case.quantity.kind != "pose" or not case.fits or case.quantity.rows or len(matrices) < 2:
        return None
    if case.partners is None or case.obtained_there is None:
        return None
    first, found = case.frames.index(case.quantity.reference), None
    there, obtained_there = links(case, case.partners), case.obtained_there()
    for k, true in enumerate(matrices):
        implied = _implied(matrices, case.obtained, k)
        other = _implied(there, obtained_there, k)
        near, far = case.frames[first + k : first + k + 2]
        joint = trace_of(case.arm).depth(near)
        is_fixed = trace_of(case.arm).depth(far) == joint
        if is_fixed or joint >= len(other) or np.abs(implied[0] - other[joint]).max() > 1e-9:
            continue
        slip = slip_in_link(implied, true, convention_of(matrices))
        place = {"link": link_name(case.frames, first + k), "frame": far}
        finding = say(Kind.FIRST_WRONG_LINK, **place, slip=slip or _places(implied, true))
        if slip is not None:
            return finding
        found = found or finding
    return found


def _implied(matrices: list[np.ndarray], obtained: np.ndarray, k: int) -> np.ndarray:
    """Return the k-th link matrix that a pose implies where the others are right."""
    count = len(obtained)
    return np.linalg.inv(product(matrices[:k], count)) @ obtained @ np.linalg.inv(product(matrices[k + 1 :], count))


def slip_in_link(implied: np.ndarray, true: np.ndarray, conventions: list[str]) -> Finding | None:
    """Return the usual slip that is in one link matrix, or None."""
    for finding, candidate in link_slips(true, conventions):
        if np.abs(candidate - implied).max() < TOLERANCE:
            return finding
    off = np.argwhere(np.abs(implied - true).max(axis=0) > TOLERANCE)
    if len(off) != 1:
        return None
    r, c = (int(k) for k in off[0])
    is_negative = np.abs(implied[:, r, c] + true[:, r, c]).max() < TOLERANCE
    return say(Kind.LINK_SIGN_OF_ENTRY if is_negative else Kind.LINK_ENTRY, row=r + 1, column=c + 1)


def _places(implied: np.ndarray, true: np.ndarray) -> Finding:
    off = np.argwhere(np.abs(implied - true).max(axis=0) > TOLERANCE)
    places = [say(Kind.PLACE, row=int(r) + 1, column=int(c) + 1) for r, c in off]
    return say(Kind.LINK_ENTRIES, places=places) if len(off) <= 6 else say(Kind.LINK_MOST_ENTRIES)


def link_slips(true: np.ndarray, conventions: list[str]) -> Iterator[Candidate]:
    """Yield a link matrix with the usual slips in it."""
    yield say(Kind.LINK_INVERTED), np.linalg.inv(true)
    turned = true.copy()
    turned[:, :3, :3] = true[:, :3, :3].transpose(0, 2, 1)
    yield say(Kind.LINK_TRANSPOSED), turned
    for convention in conventions:
        p = parameters(convention, true)
        if p is None:
            continue
        a, alpha, d, theta, none = p.a, p.alpha, p.d, p.theta, 0 * p.a
        other = other_convention(convention)
        yield say(Kind.LINK_CONVENTION, other=other, convention=convention), build(other, p)
        for finding, changed in (
            (say(Kind.LINK_SIGN_OF_TWIST), Parameters(a, -alpha, d, theta)),
            (say(Kind.LINK_TWIST), Parameters(a, none, d, theta)),
            (say(Kind.LINK_SIGN_OF_ANGLE), Parameters(a, alpha, d, -theta)),
            (say(Kind.LINK_SIGN_OF_LENGTH), Parameters(-a, alpha, d, theta)),
            (say(Kind.LINK_LENGTH), Parameters(none, alpha, d, theta)),
            (say(Kind.LINK_SIGN_OF_OFFSET), Parameters(a, alpha, -d, theta)),
            (say(Kind.LINK_OFFSET), Parameters(a, alpha, none, theta)),
            (say(Kind.LINK_A_AND_D), Parameters(d, alpha, a, theta)),
            (say(Kind.LINK_ALPHA_AND_THETA), Parameters(a, theta, d, alpha)),
            (say(Kind.LINK_ANGLE_OFF, turn="π/2"), Parameters(a, alpha, d, theta + np.pi / 2)),
            (say(Kind.LINK_ANGLE_OFF, turn="-π/2"), Parameters(a, alpha, d, theta - np.pi / 2)),
            (say(Kind.LINK_ANGLE_OFF, turn="π"), Parameters(a, alpha, d, theta + np.pi)),
            (say(Kind.LINK_SINE_COSINE), Parameters(a, alpha, d, np.pi / 2 - theta)),
        ):
            yield finding, build(convention, changed)
        moved = true.copy()
        moved[:, :3, 3] = np.array([a, none, d]).T
        yield say(Kind.LINK_NOT_TURNED), moved
