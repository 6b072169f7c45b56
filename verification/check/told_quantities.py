r"""Definitions of quantities that the text names, which nothing but their own derivatives uses: \dot\rho follows from whatever \rho is said to be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from armproof.verification.document import Display
from armproof.verification.document.told_quantities import TOLD_QUANTITY
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.settled import Key, settle_used, uses_of
from armproof.verification.verdict import EquationResult, Record, Verdict


def settle_told_quantities(
    records: tuple[Record, ...], displays: Sequence[Display], reader: Reader
) -> tuple[Record, ...]:
    """Return the records of a document; where the text says what a letter is, its derivatives do not show that its formula is right."""
    told = {display.place for display in displays if TOLD_QUANTITY in display.meant}
    defined = {key: record for record in records if (record.cell, record.line) in told for key in _defined(record)}
    idle = {key for key in defined if _is_differentiated_alone(key, records, reader)}
    if not idle:
        return records
    found = tuple(record if record.erratum else _left_open(record, idle) for record in records)
    return settle_used(found)


def _defined(record: Record) -> Iterator[Key]:
    yield from (key for each in record.outcomes if not record.erratum for key in each.defines if key[1] == record.line)


def _is_differentiated_alone(key: Key, records: Sequence[Record], reader: Reader) -> bool:
    """Whether derivatives of a name are decided by what it is defined as, and nothing else is."""
    using = uses_of(key, [each for record in records if not record.erratum for each in record.outcomes])
    decided = [record for record in records if any(each.is_decided for each in record.outcomes if each in using)]
    return bool(decided) and all(_differentiates(record.latex, key[0], reader) for record in decided)


def _differentiates(latex: str, name: str, reader: Reader) -> bool:
    """Whether a display says no more of a name than what its derivatives are."""
    with suppress(ReadError, RecursionError):
        chains = [each for each in reader.read(latex) if isinstance(each, n.Chain)]
        of_it = [each for each in chains if name in {below.undotted.key for below in n.names(each)}]
        return bool(of_it) and all(_is_derivative(each, name) for each in of_it)
    return False


def _is_derivative(chain: n.Chain, name: str) -> bool:
    first, *others = map(bare, chain.members)
    plain = {below.key for each in others for below in n.names(each)}
    if isinstance(first, n.Derivative):
        return name in {below.key for below in n.names(first.operand)} and name not in plain
    return isinstance(first, n.Name) and first.dots > 0 and first.undotted.key == name and name not in plain


def _left_open(record: Record, idle: set[Key]) -> Record:
    if not any(_rests(each, idle) for each in record.outcomes):
        return record
    return record.with_outcomes(tuple(_open(each) if _rests(each, idle) else each for each in record.outcomes))


def _rests(result: EquationResult, idle: set[Key]) -> bool:
    return result.is_decided and not idle.isdisjoint(result.uses)


def _open(result: EquationResult) -> EquationResult:
    (name, line), *_ = sorted(result.uses)
    return replace(
        result,
        verdict=Verdict.UNCHECKED,
        findings=(say(Kind.FOLLOWS_FROM_DOUBT, name=name, line=line).at(result.index),),
    )
