"""A link matrix or a row of a table against the rest of its document: where several displays hold with one other entry, either may be wrong."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.ring import Ring
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.naming.reading import read_names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.own_letters import is_index_slip
from armproof.verification.tables.arms.settling import Inference
from armproof.verification.tables.arms.values import entries_by_place
from armproof.verification.tables.arms.witnesses import weigh
from armproof.verification.verdict import HOLDS, DocumentResult, Record, Role, Verdict

FEWEST = 2  # displays that hold with another length, where one alone may hold the slip itself, unless the arm lacks that length
MOST = 100  # other arms that are weighed
TELLING = 2  # displays that hold, which may tell which index of a transform is the reference
_NAME = regex(r"[A-Za-z]\w*")

Check = Callable[[Inference], DocumentResult]


@dataclass(frozen=True)
class _Other:
    """An arm with another entry in the row of one link, counted from 1."""

    link: int
    column: str
    printed: str
    correct: str
    front: Mapping[str, Any]


def unless_disputed(part: Inference, result: DocumentResult, check: Check) -> DocumentResult:
    """Leave open what holds with one other entry in what the arm was taken from, and that: nobody knows which of the two is wrong.

    What holds of the arm as it is printed, and not with the other entry, speaks for that.
    """
    if part.unfit is not None:
        printed = check(part.unfit)
        found = unless_disputed(part.unfit, printed, check)
        return result if found is printed else _without_refuted(found, part.problem)
    if part.arm is None or part.arm.source not in ("matrices", "table") or part.arm.mended:
        return result
    lost = [each for each in result.equations if _is_lost(each, part)]
    own, letters = _own_letters(part), _letters(part, lost)
    is_foreign = letters != own
    if len(lost) < FEWEST - is_foreign or not (is_foreign or any(map(_differs, lost))):
        return result
    if (other := _best(part, lost, result, sorted(letters))) is None:
        return result
    tables = part.document.tables if _numbers(part) else ()  # which say what a_2 is
    there = check(replace(part, document=replace(part.document, front=dict(other.front), tables=tables)))
    verdicts = {each.place: each.verdict for each in there.equations}
    gained = [each for each in lost if verdicts[each.place] in HOLDS]
    held = [verdicts[each.place] for each in result.equations if each.verdict in HOLDS and not _is_data(each, part)]
    is_against = Verdict.REFUTED in held or (len(gained) < FEWEST and not set(held) <= {*HOLDS})
    if len(gained) < _fewest(other, own) or is_against:
        return result
    if len(gained) >= FEWEST and _has_index_slip(part, other):
        of_table = part.arm.source == "table"
        mended, data = (
            tuple(_with_slip(each, other, part) if of_table else each for each in records)
            for records in (there.equations, result.tables)
        )
        return replace(there, front=result.front, arms=result.arms, equations=mended, tables=data)
    return replace(
        result,
        equations=tuple(_doubted(each, other, gained, part) for each in result.equations),
        tables=tuple(_doubted(each, other, gained, part) for each in result.tables),
    )


def _has_index_slip(part: Inference, other: _Other) -> bool:
    """Whether the length of a row is that of another, by the index that its author gave the others."""
    arm = part.document.front["arm"]
    row = other.link - _first(arm) + 1
    is_whole = "base" not in arm and "first" not in arm and "frames" not in arm
    return is_whole and is_index_slip(arm["rows"], row, other.column, (other.printed, other.correct), str(arm["dh"]))


def _with_slip(record: Record, other: _Other, part: Inference) -> Record:
    """Return the record of the table that the arm was taken from, refuted where it has a slip."""
    if not _is_data(record, part) or record.erratum:
        return record
    change = {"row": other.link, "parameter": other.column, "printed": other.printed, "correct": other.correct}
    found = (say(Kind.TABLE_ENTRY, **change),)
    outcomes = tuple(replace(each, verdict=Verdict.REFUTED, findings=found) for each in record.outcomes)
    return replace(record, verdict=Verdict.REFUTED, outcomes=outcomes, findings=found, corrections=None)


def _without_refuted(result: DocumentResult, problem: Finding | None) -> DocumentResult:
    """Leave open what is refuted for an arm that does not fit its document."""
    if problem is None:
        return result
    opened = (each.left_open(problem, lambda one: one.verdict is Verdict.REFUTED) for each in result.equations)
    return replace(result, equations=tuple(opened))


def _is_data(record: Record, part: Inference) -> bool:
    return part.arm is not None and record.place in part.arm.lines


def _is_lost(record: Record, part: Inference) -> bool:
    """Whether a display does not hold of the arm as its link matrices are printed."""
    is_open = record.verdict is Verdict.UNCHECKED and not record.is_remark
    return (is_open or record.verdict is Verdict.REFUTED) and not (record.erratum or _is_data(record, part))


def _differs(record: Record) -> bool:
    """Whether a display is refuted, or would be if anything else told that the arm's source is right."""
    return record.verdict is Verdict.REFUTED or record.says(Kind.OTHER_THAN_SOURCE)


def _best(part: Inference, lost: Sequence[Record], result: DocumentResult, letters: Sequence[str]) -> _Other | None:
    """Return the arm with another entry under which most of the displays that are lost hold, and more than under any second one."""
    assert part.arm is not None
    places = {each.place for each in lost} | {each.place for each in result.equations if _defines(each)}
    told = (each for each in result.equations if each.verdict in HOLDS and any(o.links for o in each.outcomes))
    holds = [each.place for each in told if not _is_data(each, part)]  # with another entry its own matrix fails
    places |= {*holds[:TELLING]}
    others = {str(other.front["arm"]["rows"]): other for other in _others(part, letters)}
    likely = sorted(others.values(), key=lambda other: other.column in ("a", "d"))  # of lengths there are many
    fronts = [other.front for other in likely][:MOST]
    if "transforms" not in part.document.front:  # what is lost may be what would tell
        fronts = fronts[: MOST // 2]
        fronts = [{**front, "transforms": which} for front in fronts for which in ("upper", "lower")]
    try:
        readings = weigh(part.document, fronts, numbers=_numbers(part), only=places) if fronts else []
    except ArmproofError:
        return None
    held = [each for each in readings if each.held == readings[0].held]
    ways = {str(each.front["arm"]["rows"]): each.front for each in held}
    best = [replace(others[rows], front=front) for rows, front in ways.items()]
    is_one = len(best) == 1 and readings[0].held > 0  # a check of all displays tells how many hold
    best = [other for other in best if is_one or readings[0].held >= _fewest(other, _own_letters(part))]
    numbers = [other for other in best if other.printed.isdigit() and other.printed != "0"]  # of lines in parallel
    return next(iter(numbers if len(best) > 1 else best), None)


def _defines(record: Record) -> bool:
    return all(each.role is Role.DEFINITION for each in record.outcomes) and bool(record.outcomes)


def _numbers(part: Inference) -> dict[str, Fraction]:
    """Return the numbers in the rows of a table for which a_2 and d_3 stand."""
    assert part.arm is not None
    names = read_names(None, {})
    return dict(entries_by_place(part.document, part.arm, names, ExactAlgebra(Ring(), None)))


def _fewest(other: _Other, own: Collection[str]) -> int:
    letters = _NAME.findall(other.correct)
    return FEWEST if set(letters) <= {*own, "pi"} else 1


def _others(part: Inference, letters: Sequence[str]) -> Iterator[_Other]:
    """Yield the arms with one other entry: in a table any, in a matrix, which is a rigid motion, a length or a slide."""
    front = part.document.front
    arm = front["arm"]
    is_table = part.arm is not None and part.arm.source == "table"
    for k, row in enumerate(arm["rows"]):
        for column in ("a", "d", "alpha", "theta") if is_table else ("a", "d"):
            printed = str(row[column])
            is_joint = printed.lstrip("-") in arm["joints"]
            for correct in _lengths(printed, letters, is_joint) if column in ("a", "d") else _angles(printed, is_joint):
                rows = [{**each, column: correct} if each is row else each for each in arm["rows"]]
                yield _Other(k + _first(arm), column, printed, correct, {**front, "arm": {**arm, "rows": rows}})
    yield from _turning(part) if is_table else ()


def _turning(part: Inference) -> Iterator[_Other]:
    """Yield the arms in which a row turns that does not in the table, or slides: 0 for θ_1 leaves d_1 as its variable."""
    front = part.document.front
    arm = {key: value for key, value in front["arm"].items() if key != "frames"}
    turning = [joint for row in arm["rows"] for joint in _joints_in(row, arm["joints"], "theta")]
    letter = turning[0].partition("_")[0] if turning and re.fullmatch(r"[a-z]+_\d+", turning[0]) else ""
    for k, row in enumerate(arm["rows"]):
        joint = f"{letter}_{k + 1}"
        if not letter or joint in arm["joints"] or _joints_in(row, arm["joints"], "theta"):
            continue
        rows = [{**each, "theta": joint} if each is row else each for each in arm["rows"]]
        own = [joint, *arm["joints"]]
        joints = [name for each in rows for name in _joints_in(each, own, "theta", "d")[:1]]
        yield _Other(
            k + _first(arm),
            "theta",
            str(row["theta"]),
            joint,
            {**front, "arm": {**arm, "rows": rows, "joints": joints}},
        )


def _first(arm: Mapping[str, Any]) -> int:
    """Return the number of the first row's link: a base of its own is one before it."""
    return 1 + ("base" in arm)


def _joints_in(row: Mapping[str, Any], joints: Sequence[str], *columns: str) -> list[str]:
    return [name for column in columns for name in _NAME.findall(str(row[column])) if name in joints]


def _letters(part: Inference, lost: Sequence[Record]) -> set[str]:
    """Return the lengths of an arm, what its document writes with one of their letters and another digit, and what is not bound."""
    arm, own = part.document.front["arm"], _own_letters(part)
    bases = {name.partition("_")[0] for name in own if "_" in name} | {"a", "d"}
    alike = (f"{base}_{k + 1}" for base in sorted(bases) for k in range(len(arm["rows"])))
    unbound = {str(each.terms["name"]) for record in lost for each in record.findings if each.kind is Kind.NOT_BOUND}
    unbound = {name for name in unbound if _NAME.fullmatch(name)}
    return own | unbound | {name for name in alike if name not in arm["joints"] and part.document.writes(name)}


def _own_letters(part: Inference) -> set[str]:
    arm = part.document.front["arm"]
    texts = (str(row[column]) for row in arm["rows"] for column in ("a", "d"))
    return {name for text in texts for name in _NAME.findall(text)} - set(arm["joints"])


def _turned(printed: str) -> Iterator[str]:
    if printed != "0" and re.fullmatch(r"-?[\w./]+", printed):
        yield printed[1:] if printed.startswith("-") else f"-{printed}"


def _angles(printed: str, is_joint: bool) -> Iterator[str]:
    """Yield the angles of which a slip may have made another one."""
    yield from _turned(printed)
    if not is_joint and re.fullmatch(r"-?[\dpi/]+", printed):
        yield from (other for other in ("0", "pi/2", "-pi/2") if other not in (printed, *_turned(printed)))


def _lengths(printed: str, letters: Sequence[str], is_joint: bool) -> Iterator[str]:
    """Yield the lengths of which a slip may have made another one."""
    yield from _turned(printed)
    if not is_joint:
        yield from (letter for letter in letters if letter != printed)
        yield from () if printed == "0" else ("0",)


def _doubted(record: Record, other: _Other, gained: Sequence[Record], part: Inference) -> Record:
    """Return a record left open where it shows the link, or holds if that has another entry."""
    assert part.arm is not None
    change = {"column": other.column, "printed": other.printed, "correct": other.correct, "link": other.link}
    if record in gained:
        return record.left_open(say(Kind.SLIP_IN_LINK, **change), lambda each: each.verdict not in HOLDS)
    if not _is_data(record, part):
        return record
    doubt = say(Kind.LINK_DISPUTED, lines=[each.line for each in gained], **change)
    is_table = part.arm.source == "table"
    return record.left_open(doubt, lambda each: is_table or each.links == {other.link})
