"""A slip in one of a tool's coordinates: the others tell it, since what turns about z has x = ∂y/∂θ_1, and z follows from the reach."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import prod

from armproof.verification.algebra.calculus import angles_in, derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display
from armproof.verification.equations.alignment import Pair, is_near
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.naming.moving import place_of

Found = dict[str, tuple[Scalar, Display]]


def mended_coordinates(found: Found, algebra: ExactAlgebra) -> Iterator[tuple[dict[str, Scalar], Found]]:
    """Yield the coordinates with y by x, and with x by y, where the other is a slip away: what turns about z has x = ∂y/∂θ_1, y = -∂x/∂θ_1."""
    values = {axis: value for axis, (value, _) in found.items()}
    first = min(angles_in(values["x"]) & angles_in(values["y"]), key=place_of, default="")
    for told, axis, sign in (("x", "y", -1), ("y", "x", 1)) if first else ():
        angle = algebra.ring.symbol(first)
        slide = standing(_mean(values[axis], first, algebra))  # what does not turn
        by_other = (derivative(values[told], angle) * sign + slide).normal()
        apart, turned = by_other - values[axis], by_other + values[axis]  # y may point down
        is_mirrored = turned.normal().is_zero() or len(lengths_in(turned)) < len(lengths_in(apart))
        is_of_same = symbols_in([values[axis]]) <= symbols_in([by_other])
        is_slip = is_near(Pair(as_matrix(by_other), as_matrix(values[axis]))) or _lacks_one_link(values[axis], by_other)
        is_slip = is_slip or _has_cosine_for_sine(values[axis], by_other, algebra)
        if is_of_same and not is_mirrored and is_slip:
            yield {**values, axis: by_other}, {each: given for each, given in found.items() if each != axis}
    for height in _heights_of_one_slide(values):
        yield {**values, "z": height}, {each: given for each, given in found.items() if each != "z"}
    for height in _heights_by_reach(values, first, algebra) if first and "z" in values else ():
        yield {**values, "z": height}, {each: given for each, given in found.items() if each != "z"}


def _heights_of_one_slide(values: Mapping[str, Scalar]) -> Iterator[Scalar]:
    """Yield the height without a letter of the reach, where both stand in it and nothing turns: z = h of z = h + r."""
    z = values.get("z")
    if z is None or angles_in(z):
        return
    level = lengths_in(values["x"]) & lengths_in(values["y"]) & lengths_in(z)
    for letter in sorted(level):
        without = substitute(z, {letter: z.ring.zero}).normal()
        if len(level) == 1 and lengths_in(without):
            yield without


def _heights_by_reach(values: Mapping[str, Scalar], first: str, algebra: ExactAlgebra) -> Iterator[Scalar]:
    """Yield the height by the reach in a plane that the first joint turns, where that is printed a slip away: z = z_0 ∓ ∂r/∂θ_2.

    The plane may be seen from below: of two that are as near, the rest of the document tells.
    """
    cosine, sine = algebra.cos_sin(algebra.ring.symbol(first))
    reach = substitute(values["x"], {first: algebra.ring.zero})
    inner = min(angles_in(reach) & angles_in(values["z"]) - {first}, key=place_of, default="")
    if not inner or not (are_equal(values["x"], reach * cosine) and are_equal(values["y"], reach * sine)):
        return
    z, rises = values["z"], derivative(reach, algebra.ring.symbol(inner))
    ways = [(standing(z) + rises * sign).normal() for sign in (-1, 1)]
    apart = [len(lengths_in(way - z)) for way in ways]
    for way in (way for way, count in zip(ways, apart, strict=True) if count == min(apart)):
        is_slip = is_near(Pair(as_matrix(way), as_matrix(z))) or _lacks_one_link(z, way)
        if is_slip and symbols_in([z]) - {first} <= symbols_in(
            [way]
        ):  # the first joint, which turns about z, lifts nothing
            yield way


def _mean(value: Scalar, angle: str, algebra: ExactAlgebra) -> Scalar:
    """Return the mean of a coordinate over four quarter turns of an angle: of cos 2θ, which a slip may have made, nothing is left."""
    ring, quarter = algebra.ring, algebra.pi() / 2
    turned = (substitute(value, {angle: ring.symbol(angle) + quarter * turns}) for turns in range(4))
    return (sum(turned, start=ring.zero) / 4).normal()


def standing(value: Scalar) -> Scalar:
    """Return the terms of a coordinate in which nothing turns."""
    ring, total = value.ring, value.ring.zero
    for powers, factor in ring.terms(value.normal().numerator):
        if all(kind == "symbol" for kind, _ in powers):
            total += prod(
                (ring.generator(each) ** power for each, power in powers.items()), start=ring.rational(factor)
            )
    return total


def _has_cosine_for_sine(value: Scalar, meant: Scalar, algebra: ExactAlgebra) -> bool:
    """Whether a coordinate is another with the cosine of one angle for its sine in all terms: y = cos θ_1 (l_2 c_2 + l_3 c_23)."""
    for angle in angles_in(value) & angles_in(meant):
        symbol = algebra.ring.symbol(angle)
        others = zip(algebra.cos_sin(symbol), algebra.cos_sin(symbol)[::-1], strict=True)
        if any(are_equal(value * other, meant * own) for own, other in others):
            return True
    return False


def _lacks_one_link(value: Scalar, whole: Scalar) -> bool:
    """Whether a coordinate is another without the term of one link: y = l_1 s_1 of l_1 s_1 + l_2 s_12."""
    lacking = whole - value
    return not value.is_zero() and goes_on_from(whole, value) and len(lengths_in(lacking)) == 1


def goes_on_from(value: Scalar, before: Scalar) -> bool:
    """Whether a coordinate is one before it and more: that of the next point of a chain, and not of the middle of a link."""
    if are_equal(value, before):
        return False
    counts = [len(tuple(each.ring.terms(each.normal().numerator))) for each in (value, before, value - before)]
    return counts[2] == counts[0] - counts[1]


def lengths_in(value: Scalar) -> set[str]:
    """Return the letters of a coordinate that are no angles."""
    return symbols_in([value.normal()]) - angles_in(value)


def are_equal(one: Scalar, other: Scalar) -> bool:
    """Decide whether two coordinates are equal."""
    return (one - other).normal().is_zero()
