"""Slips in a product of link matrices: an order, a link left out, one wrong link, the other Denavit–Hartenberg convention."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.diagnosis.causes.case import TOLERANCE, Candidate, Case
from armproof.verification.diagnosis.causes.frames import inverse

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
    if quantity.kind not in ("pose", "rotation", "origin", "axis") or {quantity.frame, quantity.reference} - set(
        frames
    ):
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
    """Yield products of the right link matrices in a wrong order, or with one left out or repeated."""
    matrices, count = links(case), len(case.q)
    if len(matrices) < 2:
        return
    first = case.frames.index(case.quantity.reference)
    names = [f"^{case.frames[first + k]}T_{case.frames[first + k + 1]}" for k in range(len(matrices))]
    yield (
        "the link matrices are multiplied in the wrong order, from the last to the first",
        case.selected(product(matrices[::-1], count)),
    )
    for k in range(len(matrices) - 1):
        order = [*matrices[:k], matrices[k + 1], matrices[k], *matrices[k + 2 :]]
        words = f"the link matrices {names[k]} and {names[k + 1]} are multiplied in the wrong order"
        yield words, case.selected(product(order, count))
    for k in range(len(matrices)):
        yield (
            f"the link matrix {names[k]} is missing from the product",
            case.selected(product([*matrices[:k], *matrices[k + 1 :]], count)),
        )
        yield (
            f"the link matrix {names[k]} stands in the product twice",
            case.selected(product([*matrices[: k + 1], *matrices[k:]], count)),
        )
    for convention in convention_of(matrices):
        other = CONVENTIONS[1 - CONVENTIONS.index(convention)]
        rebuilt = [build(other, p) for L in matrices if (p := parameters(convention, L)) is not None]
        words = f"the link matrices are those of the {other} Denavit–Hartenberg convention, the arm's frames are {convention}"
        yield words, case.selected(product(rebuilt, count))


def wrong_link(case: Case) -> str:
    """Find the one link matrix that is wrong, the others being right, and say what is wrong in it.

    With P the pose obtained, the link that it implies is L_k = X_{0,k-1}^{-1} P X_{k,n}^{-1}. The right k is where L_k
    depends on no joint variable but its own: it is the same at two configurations that share that variable alone.
    """
    matrices = links(case)
    if case.quantity.kind != "pose" or not case.fits or case.quantity.rows or len(matrices) < 2:
        return ""
    if case.partners is None or case.obtained_there is None:
        return ""
    first, found = case.frames.index(case.quantity.reference), ""
    there, obtained_there = links(case, case.partners), case.obtained_there()
    for k, true in enumerate(matrices):
        implied = _implied(matrices, case.obtained, k)
        other = _implied(there, obtained_there, k)
        joint = first + k
        if joint >= len(other) or np.abs(implied[0] - other[joint]).max() > 1e-9:
            continue
        slip = slip_in_link(implied, true, convention_of(matrices))
        words = f"the link matrix ^{case.frames[joint]}T_{case.frames[joint + 1]} is wrong: {slip or _places(implied, true)}"
        words += f"; frame {case.frames[joint + 1]} is the first that departs from the arm's"
        if slip:
            return words
        found = found or words
    return found


def _implied(matrices: list[np.ndarray], obtained: np.ndarray, k: int) -> np.ndarray:
    """Return the k-th link matrix that a pose implies where the others are right."""
    count = len(obtained)
    return inverse(product(matrices[:k], count)) @ obtained @ inverse(product(matrices[k + 1 :], count))


def slip_in_link(implied: np.ndarray, true: np.ndarray, conventions: list[str]) -> str:
    """Return in words the usual slip that is in one link matrix, or an empty text."""
    for words, candidate in link_slips(true, conventions):
        if np.abs(candidate - implied).max() < TOLERANCE:
            return words
    off = np.argwhere(np.abs(implied - true).max(axis=0) > TOLERANCE)
    if len(off) == 1:
        r, c = off[0]
        if np.abs(implied[:, r, c] + true[:, r, c]).max() < TOLERANCE:
            return f"the sign of its entry ({r + 1}, {c + 1})"
        return f"its entry ({r + 1}, {c + 1})"
    return ""


def _places(implied: np.ndarray, true: np.ndarray) -> str:
    off = np.argwhere(np.abs(implied - true).max(axis=0) > TOLERANCE)
    return f"its entries {', '.join(f'({r + 1}, {c + 1})' for r, c in off)}" if len(off) <= 6 else "most of its entries"


def link_slips(true: np.ndarray, conventions: list[str]) -> Iterator[Candidate]:
    """Yield a link matrix with the usual slips in it."""
    yield "it is inverted", inverse(true)
    turned = true.copy()
    turned[:, :3, :3] = true[:, :3, :3].transpose(0, 2, 1)
    yield "its rotation is transposed, the sign of its sines is wrong", turned
    for convention in conventions:
        p = parameters(convention, true)
        if p is None:
            continue
        a, alpha, d, theta, none = p.a, p.alpha, p.d, p.theta, 0 * p.a
        other = CONVENTIONS[1 - CONVENTIONS.index(convention)]
        yield (
            f"it is that of the {other} Denavit–Hartenberg convention, the arm's frames are {convention}",
            build(other, p),
        )
        for words, changed in (
            ("the sign of its twist α", Parameters(a, -alpha, d, theta)),
            ("its twist α is missing", Parameters(a, none, d, theta)),
            ("the sign of its angle θ", Parameters(a, alpha, d, -theta)),
            ("the sign of its length a", Parameters(-a, alpha, d, theta)),
            ("its length a is missing", Parameters(none, alpha, d, theta)),
            ("the sign of its offset d", Parameters(a, alpha, -d, theta)),
            ("its offset d is missing", Parameters(a, alpha, none, theta)),
            ("its a and d are swapped", Parameters(d, alpha, a, theta)),
            ("its angles α and θ are swapped", Parameters(a, theta, d, alpha)),
            ("its angle θ is off by π/2", Parameters(a, alpha, d, theta + np.pi / 2)),
            ("its angle θ is off by -π/2", Parameters(a, alpha, d, theta - np.pi / 2)),
            ("its angle θ is off by π", Parameters(a, alpha, d, theta + np.pi)),
            ("sine and cosine of its angle θ are exchanged", Parameters(a, alpha, d, np.pi / 2 - theta)),
        ):
            yield words, build(convention, changed)
        moved = true.copy()
        moved[:, :3, 3] = np.array([a, none, d]).T
        yield "its translation is not turned: Trans and Rot stand in the wrong order", moved
