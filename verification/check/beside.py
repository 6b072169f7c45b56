"""A coordinate that a display defines beside the two others of its point, which are what they usually are: it is to be that, too."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.algebra.quantity_kinds import as_line, kind_of
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.naming.settled import Key
from armproof.verification.naming.shown import letters_of_point, point_of
from armproof.verification.verdict import HOLDS, EquationResult, Record, Role, Verdict

OTHERS = 2  # coordinates of a point


def unless_beside_others(records: Sequence[Record]) -> tuple[Record, ...]:
    """Return the records of a document, z_E = … left open where x_E and y_E beside it hold of a point and it does not, and what follows from it."""
    found: dict[Key, Finding] = {key: doubt for each in records if not each.erratum for key, doubt in _doubtful(each)}
    if not found:
        return tuple(records)
    return tuple(each if each.erratum else _without(each, found) for each in records)


def _doubtful(record: Record) -> Iterator[tuple[Key, Finding]]:
    """Yield the coordinates that a display defines otherwise than the point of the others is, each with what it usually is."""
    held = [one.usual.items() for one in record.outcomes if one.verdict in HOLDS]
    beside = {
        (letters_of_point(key), point, quantity)
        for each in held
        for key, quantity in each
        if (point := point_of(quantity))
    }
    for key, line in (each for one in record.outcomes if _defines(one) for each in one.defines):
        points = [point for letters, point, _ in beside if letters == letters_of_point(key)]
        row = next((k for k, axis in enumerate(COMPONENTS, 1) if axis in _axis_of(key)), 0)
        if row and len(points) == OTHERS and points[0] == points[1]:
            quantity = replace(points[0], rows=(row,), scalar=True)
            yield (key, line), _unusual(key, quantity)


def _defines(result: EquationResult) -> bool:
    return result.role is Role.DEFINITION and result.verdict is Verdict.DEFINED and len(result.defines) == 1


def _axis_of(key: str) -> str:
    """Return the axis of a coordinate, by the letter for which its point has a mark: z of z_E, x of p_x."""
    marked = letters_of_point(key).replace("**", "*")
    return key[marked.index("*")].lower() if "*" in marked else ""


def _unusual(key: str, quantity: Quantity) -> Finding:
    reading, line = kind_of(quantity).tell(quantity), as_line(key, quantity)
    return say(Kind.NOT_AS_USUAL_BOUND, name=key, reading=reading, line=line)


def _without(record: Record, found: dict[Key, Finding]) -> Record:
    """Return a record with what is doubtful left open, and what rests on that."""
    for key, doubt in found.items():
        record = record.left_open(doubt, lambda one, key=key: key in one.defines and _defines(one))  # type: ignore[misc]
        follows = say(Kind.FOLLOWS_FROM_DOUBT, name=key[0], line=key[1])
        record = record.left_open(follows, lambda one, key=key: one.verdict in HOLDS and key in one.uses)  # type: ignore[misc]
    return record
