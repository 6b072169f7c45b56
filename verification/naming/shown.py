"""What the rest of a document shows of names that convention alone binds: then an equation a slip away from them is refuted."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.findings import OTHER_ANGLES, Kind, say
from armproof.verification.patterns import regex
from armproof.verification.verdict import AXES, DECIDED, HOLDS, EquationResult, Record, Verdict

_COORDINATE = regex(r"(?<![A-Za-z])(?:[xyz]|[XYZ])(?![A-Za-z])")

_ENTRY = regex(r"([A-Za-z]+_)[1-3],?[1-3]")  # of a matrix, r_31


def settle_usual(records: Iterable[Record]) -> tuple[Record, ...]:
    """Return the records of a document; what its other equations show of a name is what it means in one that is left open."""
    records = tuple(records)
    return tuple(_settled(record, [each for each in records if each is not record]) for record in records)


def settle_used_otherwise(records: Iterable[Record], usual: Callable[[str], Sequence[Quantity]]) -> tuple[Record, ...]:
    """Return the records of a document; x_2 is left open where a display behind adds it up to a coordinate, P_x = x_1 + x_2, of which it is a part.

    `usual` tells what a key may stand for by convention.
    """
    records = tuple(records)
    refuted = {key for each in records for one in each.outcomes if one.verdict is Verdict.REFUTED for key in one.usual}
    found = [(at, _parts(record, usual) if refuted else {}) for at, record in enumerate(records)]
    for at, parts in found:
        for key in parts.keys() & refuted:
            doubt = say(Kind.USED_OTHERWISE, name=key, line=records[at].line)
            records = tuple(
                each.left_open(doubt, partial(_is_refuted_with, key)) if k < at and not each.erratum else each
                for k, each in enumerate(records)
            )
    return records


def _is_refuted_with(key: str, outcome: EquationResult) -> bool:
    return outcome.verdict is Verdict.REFUTED and key in outcome.usual


def _parts(record: Record, usual: Callable[[str], Sequence[Quantity]]) -> Mapping[str, object]:
    """Return the coordinates by which a display gives its meaning to the usual name of one along the same axis."""
    found: dict[str, object] = {}
    for outcome in record.outcomes if record.verdict is not Verdict.REFUTED else ():
        named = [each for key, _ in outcome.defines for each in usual(key)]
        rows = {each.rows for each in named if point_of(each) is not None}
        along = {key: each for key, each in outcome.usual.items() if point_of(each) and each.rows in rows}  # type: ignore[attr-defined]
        found |= along if len(along) > 1 and outcome.verdict not in DECIDED else {}
    return found


def _settled(record: Record, others: Iterable[Record]) -> Record:
    if record.if_shown is None:
        return record
    others = tuple(others)
    if record.if_shown.of_another and not _is_alone(record.if_shown.meanings, record, others):
        return replace(record, if_shown=None)
    around = [each for each in others if each.section == record.section or not _of_other_angles(record.if_shown.record)]
    held = [each for one in (record, *around) for each in one.outcomes if each.verdict in HOLDS]
    shown = [each.usual for each in held]
    if all(_is_shown(key, quantity, shown) for key, quantity in record.if_shown.meanings.items()):
        return record.if_shown.record
    return replace(record, if_shown=None)


def _is_alone(meanings: Mapping[str, object], record: Record, others: Iterable[Record]) -> bool:
    """Whether another equation tells of this coordinate of the point, and none beside it is of another one: the elbow's have its x beside its y."""
    here = [each for each in others if each.section == record.section]
    open_ = {point_of(quantity) for each in here if each.if_shown for quantity in each.if_shown.meanings.values()}
    held = [one for each in (record, *here) for one in each.outcomes if one.verdict in HOLDS]
    points = {point_of(quantity) for one in held for quantity in one.usual.values()}
    own = {point_of(quantity) for quantity in meanings.values()}
    rows = {row for quantity in meanings.values() if isinstance(quantity, Quantity) for row in quantity.rows or ()}
    told = {link for each in others for one in each.outcomes if one.verdict in HOLDS for link in one.links}
    is_told = all(AXES + 1 - row in told for row in rows)
    elsewhere = any(f.kind is Kind.OF_OTHER_POINT for each in here for one in each.outcomes for f in one.findings)
    return len(meanings) == 1 and is_told and not elsewhere and open_.isdisjoint(own) and own <= points


def _of_other_angles(record: Record) -> bool:
    """Whether an angle more or less is wrong: absolute ones, of which another section may speak."""
    found = [finding for each in record.outcomes if each.verdict is Verdict.REFUTED for finding in each.findings]
    return any(finding.kind in OTHER_ANGLES for finding in (*found, *record.findings))


def _is_shown(key: str, quantity: object, shown: Iterable[Mapping[str, object]]) -> bool:
    """Whether a name stands for a quantity in what holds, and for no other one; of a coordinate the others of its point tell it, too."""
    found = {usual[key] for usual in shown if key in usual}
    if found or (whole := _whole(quantity)) is None:
        return found == {quantity}
    others = ((name, other) for usual in shown for name, other in usual.items())
    return any(_whole(other) == whole and letters_of_point(name) == letters_of_point(key) for name, other in others)


def _whole(quantity: object) -> Quantity | None:
    """Return the point, or the velocity, of which a quantity is a coordinate, or the rotation of which it is an entry."""
    if isinstance(quantity, Quantity) and quantity.kind == "rotation" and quantity.rows and quantity.columns:
        return replace(quantity, rows=None, columns=None)
    if isinstance(quantity, Quantity) and quantity.kind == "velocity" and quantity.scalar:
        return replace(quantity, rows=None)
    return point_of(quantity)


def point_of(quantity: object) -> Quantity | None:
    """Return the point of which a quantity is a coordinate."""
    if isinstance(quantity, Quantity) and quantity.kind == "origin" and quantity.scalar:
        return replace(quantity, rows=None)
    return None


def letters_of_point(key: str) -> str:
    """Return a name with a mark for its coordinate or its place: p_* of p_x and p_y, * of x, and of X a capital one, r_* of r_31."""
    if (entry := _ENTRY.fullmatch(key)) is not None:
        return f"{entry[1]}*"
    return _COORDINATE.sub(lambda found: "*" if found.group().islower() else "**", key)
