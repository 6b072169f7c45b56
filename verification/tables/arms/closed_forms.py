"""The arm of a closed form that pins it: the coordinates of a planar chain, or of an arm that a first joint turns about z."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Display, Document
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.tables.arms.candidate import Candidate, renamed, symbol_of
from armproof.verification.tables.arms.letters import equations_of, value_in_letters

_COORDINATE = re.compile(r"([xyzXYZ])(?:_(?:e|E|ee|EE|tool|n|\d))?|[pP]_(?:e|E|ee|EE)?,?([xyz])")
_ANGLES = re.compile(r"(?:theta|q)_?\d+")
_INDEX = re.compile(r"\d+")
SECONDS = 0.3

Found = dict[str, tuple[Scalar, Display]]


def candidate_of_closed_form(document: Document, names: Names) -> Candidate | None:
    """Return the arm whose tool has the coordinates that a document gives first, or None."""
    algebra = ExactAlgebra(Ring(), None)
    letters: dict[str, n.Name] = {}
    with algebra.budget.of(SECONDS):
        found: Found = {}
        for display in document.displays:
            for axis, value in _coordinates(display, names, algebra, letters) if "=" in display.latex else ():
                if axis == "z" or _letters_of(value)[1]:  # x = f(θ) and x = 1.5 tell nothing
                    found.setdefault(axis, (value, display))
        rows = _planar(found, algebra) or _turned(found, algebra) if {"x", "y"} <= found.keys() else None
    if rows is None:
        return None
    places = [(display.cell, display.line) for _, display in found.values()]
    cell, line = min(places, key=lambda place: (place[0] or 0, place[1]))
    joints = tuple(symbol_of(row["theta"]) for row in rows)
    entries = tuple(
        {key: symbol_of(value) if value not in ("0", "pi/2") else value for key, value in row.items()} for row in rows
    )
    return Candidate("closed form", line, cell, entries, joints, renamed(letters.values()), ("classic",), tuple(places))


def _coordinates(
    display: Display, names: Names, algebra: ExactAlgebra, letters: dict[str, n.Name]
) -> Iterator[tuple[str, Scalar]]:
    """Yield the coordinates that a display gives alone: x = …."""
    for chain in equations_of(display, names):
        match = _COORDINATE.fullmatch(bare_key(chain.members[0]) or "") if len(chain.members) == 2 else None
        evaluated = value_in_letters(bare(chain.members[1]), names, algebra) if match is not None else None
        if match is not None and evaluated is not None and isinstance(evaluated[0], Scalar):
            letters.update({name.key: name for name in evaluated[1]})
            yield (match[1] or match[2]).lower(), evaluated[0]


def _planar(found: Found, algebra: ExactAlgebra) -> list[Mapping[str, str]] | None:
    """Return the rows of a planar chain: x and y are sums of l_i cos(θ_1 + … + θ_i) and of the sines."""
    lengths, angles = _letters_of(found["x"][0])
    if not 2 <= len(angles) == len(lengths):
        return None
    x = y = algebra.ring.zero
    for k, length in enumerate(lengths, 1):
        cosine, sine = _of_sum(algebra, angles[:k])
        x, y = x + algebra.symbol(length) * cosine, y + algebra.symbol(length) * sine
    if not (_equal(x, found["x"][0]) and _equal(y, found["y"][0])):
        return None
    return [{"a": a, "alpha": "0", "d": "0", "theta": q} for a, q in zip(lengths, angles, strict=True)]


def _turned(found: Found, algebra: ExactAlgebra) -> list[Mapping[str, str]] | None:
    """Return the rows of two links in a plane that a first joint turns: x = cos θ_1 (l_2 c_2 + l_3 c_23), z = l_1 + …."""
    if "z" not in found:
        return None
    (lengths, angles), (heights, _) = _letters_of(found["x"][0]), _letters_of(found["z"][0])
    above = [length for length in heights if length not in lengths]
    if len(angles) != 3 or len(lengths) != 2 or len(above) > 1:
        return None
    reach, z = algebra.ring.zero, algebra.symbol(above[0]) if above else algebra.ring.zero
    for k, length in enumerate(lengths, 2):
        cosine, sine = _of_sum(algebra, angles[1:k])
        reach, z = reach + algebra.symbol(length) * cosine, z + algebra.symbol(length) * sine
    cosine, sine = _of_sum(algebra, angles[:1])
    if not all(_equal(value, found[axis][0]) for axis, value in (("x", reach * cosine), ("y", reach * sine), ("z", z))):
        return None
    first = {"a": "0", "alpha": "pi/2", "d": above[0] if above else "0", "theta": angles[0]}
    return [first, *({"a": a, "alpha": "0", "d": "0", "theta": q} for a, q in zip(lengths, angles[1:], strict=True))]


def _letters_of(value: Scalar) -> tuple[list[str], list[str]]:
    """Return the lengths and the angles of a coordinate, each in the order of their numbers."""
    found = sorted(
        symbols_in([value.normal()]), key=lambda name: (int(m[0]) if (m := _INDEX.search(name)) else 0, name)
    )
    angles = [name for name in found if _ANGLES.fullmatch(name)]
    return [name for name in found if name not in angles], angles


def _of_sum(algebra: ExactAlgebra, angles: list[str]) -> tuple[Scalar, Scalar]:
    total = algebra.ring.zero
    for angle in angles:
        total = total + algebra.symbol(angle)
    return algebra.cos_sin(total)


def _equal(one: Scalar, other: Scalar) -> bool:
    return (one - other).normal().is_zero()
