"""From a document without an arm to one that names it: what it was taken from, and the reading under which most holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from armproof.models.errors import ArmproofError
from armproof.verification.document import Document, Table
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.naming.names import Names, read_names, spelling_of
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.rows import candidates
from armproof.verification.tables.arms.support import Inference
from armproof.verification.tables.arms.witnesses import Reading, weigh
from armproof.verification.tables.check import read_array, turned
from armproof.verification.tables.columns import CONVENTIONS, read_columns
from armproof.verification.verdict import TakenArm


def infer_arm(document: Document) -> Inference:
    """Return a document with the arm that its DH table gives, in the reading under which most of its equations hold.

    A document that names its arm stays as it is, and so does one in which nothing tells one reading from another.
    """
    if "arm" in document.front:
        return Inference(document)
    problem: Finding | None = None
    line: int | None = None
    for table in _tables(document):
        try:
            found = list(candidates(table, read_columns(table.header), _names(document)))  # type: ignore[arg-type]
        except (EvaluationError, ReadError) as error:
            problem, line = problem or finding_of(error), line or table.line
            continue
        return _settle(document, found)
    return Inference(document, problem=problem, line=line)


def _names(document: Document) -> Names:
    names = read_names(None, {})
    names.reader.spelling = spelling_of(document, names.reader.words)
    return names


def _tables(document: Document) -> Iterator[Table]:
    """Yield the DH tables of a document, upright, in their order."""
    arrays = (array.table for display in document.displays if (array := read_array(display)) is not None)
    for table in sorted((*document.tables, *arrays), key=lambda one: (one.cell or 0, one.line)):
        upright = next((each for each in (table, turned(table)) if each and read_columns(each.header)), None)
        if upright is not None and not table.erratum:
            yield upright


def _settle(document: Document, found: list[Candidate]) -> Inference:
    """Return the document with the arm of the candidates' best reading, or the reason why none is."""
    line = found[0].line
    try:
        best, *others = weigh(document, [front for candidate in found for front in _fronts(document, candidate)])
    except ArmproofError as error:
        return Inference(document, problem=say(Kind.NO_ARM_IN_TABLE, reason=finding_of(error)), line=line)
    rivals = [one for one in others if one.counts == best.counts and one.front["arm"] != best.front["arm"]]
    alike = any(one.counts == best.counts and one.front["arm"] == best.front["arm"] for one in others)
    if alike and "transforms" not in document.front:  # nothing tells which index is the reference
        best = replace(best, front={key: value for key, value in best.front.items() if key != "transforms"})
    if _stated(document):
        return _taken(document, found[0], best)
    if rivals or not best.held:
        return Inference(document, problem=say(Kind.CONVENTION_OPEN), line=line)
    if best.failed > best.held:
        return Inference(document, problem=say(Kind.ARM_DOES_NOT_FIT, held=best.held, failed=best.failed), line=line)
    return _taken(document, found[0], best)


def _stated(document: Document) -> tuple[str, ...]:
    """Return the convention that the author states, alone, or nothing."""
    return tuple(convention for convention in CONVENTIONS if document.front.get("convention") == convention)


def _fronts(document: Document, candidate: Candidate) -> Iterator[Mapping[str, Any]]:
    directions = (document.front["transforms"],) if "transforms" in document.front else ("upper", "lower")
    for convention in _stated(document) or candidate.conventions:
        for transforms in directions:
            found = candidate.front(convention)
            symbols = {**found.get("symbols", {}), **(document.front.get("symbols") or {})}
            more = {"symbols": symbols} if symbols else {}
            yield {**document.front, **found, **more, "transforms": transforms}


def _taken(document: Document, candidate: Candidate, reading: Reading) -> Inference:
    added = {key: value for key, value in reading.front.items() if document.front.get(key) != value}
    arm = TakenArm(
        reading.name,
        candidate.line,
        candidate.source,
        reading.convention,
        reading.transforms,
        added,
        candidate.cell,
        candidate.lines,
    )
    return Inference(replace(document, front=dict(reading.front)), arm)
