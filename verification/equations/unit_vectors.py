"""Letters of a document without an arm that are the components of a unit vector, or of a unit quaternion: K² = k kᵀ − I."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say

COMPONENTS = ("xy", "xyz", "wxyz", "12", "123", "0123", "1234")


def holds_for_unit_vector(outcome: Outcome) -> Finding | None:
    """Return the doubt about a refuted equation that holds where one vector in it has the length 1, as its text may say."""
    pair = outcome.pair
    for letters in _vectors(pair) if pair is not None else ():
        if all(_vanishes(true - printed, letters) for _, true, printed in pair.entries()):  # type: ignore[union-attr]
            return say(Kind.FOR_UNIT_VECTOR, letters=letters)
    return None


def _vectors(pair: Pair) -> Iterator[list[str]]:
    """Yield the letters of each vector whose components stand in a pair, the whole of it: k_x, k_y, k_z."""
    letters = symbols_in((*pair.true.cells, *pair.printed.cells))
    for base in sorted({letter[:-2] for letter in letters if letter[-2:-1] == "_"}):
        held = "".join(sorted(letter[-1] for letter in letters if letter[:-1] == f"{base}_"))
        if held in COMPONENTS:
            yield [f"{base}_{each}" for each in held]
    for pair_of_angle in (["c", "s"], ["C", "S"]):
        if letters >= {*pair_of_angle}:
            yield pair_of_angle


def _vanishes(difference: Scalar, letters: Sequence[str]) -> bool:
    """Whether a difference is zero on the unit sphere: x = cos φ, y = sin φ cos ψ, z = sin φ sin ψ."""
    ring = difference.ring
    values, radius = {}, ring.one
    for letter in letters[:-1]:
        cosine, sine = cos_sin(ring.symbol(f"angle of {letter}"))
        values[letter], radius = radius * cosine, radius * sine
    try:
        return substitute(difference, {**values, letters[-1]: radius}).is_zero()
    except EvaluationError:
        return False
