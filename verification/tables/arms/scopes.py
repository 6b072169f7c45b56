"""The parts of a document that are each about an arm of its own: a second DH table, or a first link matrix that differs, begins one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from armproof.verification.document import Display, Document, Table
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.inference import arms_of, dh_tables, plain_names
from armproof.verification.tables.arms.matrices import first_links
from armproof.verification.tables.arms.sections import named_sections, without_arms

Place = tuple[int, int]  # cell (0 where there is none) and line


@dataclass(frozen=True)
class _Source:
    """What shows an arm: a table with that arm, or a first link matrix with its entries as text."""

    place: Place
    section: str
    arm: Candidate | None = None
    entries: str = ""


def scopes(document: Document) -> tuple[Document, ...]:
    """Return the parts of a document in their order, each with its own displays and tables; mostly the document alone.

    A part begins with the section in which its table or its first link matrix stands, or there, where the arm before has
    the same section; else with one to which the front matter gives an arm. Raises DocumentError.
    """
    if "arms" in document.front:
        return tuple(_named(document))
    if "arm" in document.front:
        return (document,)
    starts = list(_starts(document))
    if not starts:
        return (document,)
    return tuple(_between(document, *edges) for edges in pairwise([(-1, 0), *starts, (10**9, 0)]))


def _named(document: Document) -> Iterator[Document]:
    """Yield the parts that the front matter tells apart, and what stands before them, if there is anything."""
    sections = named_sections(document)
    ends = [*(place for place, _ in sections[1:]), (10**9, 0)]
    before = _between(without_arms(document), (-1, 0), sections[0][0])
    if before.displays or before.tables:
        yield from scopes(before)
    for (place, front), end in zip(sections, ends, strict=True):
        yield replace(_between(document, place, end), front=front)


def _starts(document: Document) -> Iterator[Place]:
    """Yield where the second arm and each one after it begin."""
    table = link = before = None
    for source in sorted(_sources(document), key=lambda one: one.place):
        if source.arm is not None:
            is_new = table is not None and table.arm is not None and source.arm.is_other_than(table.arm)
            table, link = source, None if is_new else link
        else:
            is_new = link is not None and (source.entries != link.entries and source.section != link.section)
            table, link = None if is_new else table, source
        if is_new and before is not None:
            yield _start(document, before, source)
        before = source


def _sources(document: Document) -> Iterator[_Source]:
    for table in dh_tables(document):
        if isinstance(found := arms_of(document, table), list):
            yield _Source(_place(table), table.section, found[0])
    for display, entries in first_links(document, plain_names(document)):
        yield _Source(_place(display), display.section, entries=entries)


def _start(document: Document, before: _Source, source: _Source) -> Place:
    """Return the beginning of the section of a source, or its own place where the source before is in that section too."""
    parts: list[Display | Table] = [*document.displays, *document.tables]
    inside = [_place(part) for part in parts if part.section == source.section]
    since = [place for place in inside if before.place < place <= source.place]
    return min(since) if since and source.section != before.section else source.place


def _place(part: Display | Table) -> Place:
    return (part.cell or 0, part.line)


def _between(document: Document, begin: Place, end: Place) -> Document:
    displays = tuple(display for display in document.displays if begin <= _place(display) < end)
    tables = tuple(table for table in document.tables if begin <= _place(table) < end)
    return replace(document, displays=displays, tables=tables)
