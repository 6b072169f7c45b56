"""The hand behind the point of a closed form: a last joint that turns it, where a document says its direction, θ_3 = φ − θ_1 − θ_2."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Document
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.letters import equations_of, value_in_letters

_JOINT = regex(r"(theta|q)_(\d+)")
_DIRECTION = regex(r"(?:phi|varphi|psi|alpha|beta|gamma|theta)(?:_[A-Za-z]\w*)?")
_HAND = {"a": "0", "alpha": "0", "d": "0"}
_ALONG = ("0", "pi")  # a slide downwards lies between two half turns
SECONDS = 0.3


def with_last_turn(found: Candidate, document: Document, names: Names) -> Candidate:
    """Return an arm with the joint behind its last one, where an equation says the direction of the hand that it turns.

    Behind a slide downwards it may turn either way: the first equation that says which is what the arm is taken from.
    """
    turning = [joint for row, joint in zip(found.rows, found.joints, strict=True) if joint and joint in row["theta"]]
    match = _JOINT.fullmatch(turning[-1]) if turning else None
    if any("origin" in meant for meant in found.quantities.values()):  # x_w: the tool is another point
        return found
    if match is None or "" in found.joints or found.frames or found.last != found.indices[-1]:
        return found
    last = f"{match[1]}_{found.last + 1}"
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        told = [
            (*direction, place)
            for value, place in _differences(document, names, algebra)
            for direction in _directions(value, found, last)
        ]
    if len({each[:2] for each in told}) != 1:
        return found
    [letter, sign, place] = told[0]
    return replace(
        found,
        rows=(*found.rows, {**_HAND, "theta": last if sign > 0 else f"-{last}"}),
        joints=(*found.joints, last),
        more_lines=(*found.more_lines, place) if _leads_down(found) else found.more_lines,
        quantities={letter: {"angle": found.last + 1}, **found.quantities},
    )


def _leads_down(found: Candidate) -> bool:
    """Whether an arm slides downwards, between two half turns."""
    return any(row["alpha"] == "pi" for row in found.rows)


def _differences(
    document: Document, names: Names, algebra: ExactAlgebra
) -> Iterator[tuple[Scalar, tuple[int | None, int]]]:
    """Yield the differences of two sides of equations, in their letters, each with its place."""
    for display in document.displays:
        for chain in equations_of(display, names):
            sides = [value_in_letters(member, names, algebra) for member in chain.members]
            values = [side[0].normal() for side in sides if side is not None and isinstance(side[0], Scalar)]
            yield from (((one - other).normal(), display.place) for one, other in combinations(values, 2))


def _directions(difference: Scalar, found: Candidate, last: str) -> Iterator[tuple[str, int]]:
    """Yield the letter that an equation says to be the sum of the joints in the plane of the last one, or to have its cosine, and the sign of that."""
    turned = max((k for k, row in enumerate(found.rows, 1) if row["alpha"] not in _ALONG), default=0)
    behind = zip(found.rows[turned:], found.joints[turned:], strict=True)
    joints = [joint for row, joint in behind if joint in row["theta"]]
    others = symbols_in([difference]) - {*joints, last}
    if len(others) != 1 or not _DIRECTION.fullmatch(min(others)):
        return
    ring = difference.ring
    letter, before = ring.symbol(min(others)), sum(map(ring.symbol, joints), ring.zero)
    for sign in (1, -1) if _leads_down(found) else (1,):
        total = before + ring.symbol(last) * sign
        apart = [total - letter, *(a - b for a, b in zip(cos_sin(total), cos_sin(letter), strict=True))]
        if any((difference - each).is_zero() or (difference + each).is_zero() for each in apart):
            yield min(others), sign
