"""The parts of a document that are each about an arm of its own: a second DH table, or a first link matrix that differs, begins one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import groupby, pairwise

from armproof.verification.algebra.calculus import angles_in, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display, Document, Table
from armproof.verification.document.heading import encloses
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.moving import index_of
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import WITH_ITS_ARM
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.closed_forms import (
    candidate_of_closed_form,
    coordinates_of_tool,
    point_given_anew,
)
from armproof.verification.tables.arms.coordinate_slips import are_equal
from armproof.verification.tables.arms.inference import arms_of, dh_tables, is_described, joints_used, plain_names
from armproof.verification.tables.arms.last_turn import with_last_turn
from armproof.verification.tables.arms.laws import candidate_of_law
from armproof.verification.tables.arms.letters import equations_of
from armproof.verification.tables.arms.matrices import (
    Links,
    are_among,
    are_of_other_chain,
    candidates_of_matrices,
    first_links,
    links_before_first,
)
from armproof.verification.tables.arms.poses import pose_of_tool
from armproof.verification.tables.arms.sections import named_sections, without_arms

_FRAMES = regex(
    r"(?<![A-Za-z])[TRAH]\s*_\s*\{?\s*(\d)\s*\}?\s*\^\s*\{?\s*(\d)|(?<![A-Za-z])[TRAH]\s*\^\s*\{?\s*(\d)\s*\}?\s*_\s*\{?\s*(\d)"
)
_POINT = regex(r"(?<![A-Za-z])[xyzpP]\s*_\s*\{?\s*\d")  # x_2: one of the points of a chain
_SOLVED = regex(r"(?:theta|q)_\d")
Place = tuple[int, int]  # cell (0 where there is none) and line


@dataclass(frozen=True)
class _Source:
    """What shows an arm: a table with that arm, or a first link matrix and those behind it."""

    place: Place
    section: str
    arm: Candidate | None = None
    links: Links = field(default_factory=dict)


def scopes(document: Document) -> tuple[Document, ...]:
    """Return the parts of a document in their order, each with its own displays and tables; mostly the document alone.

    A part begins with the section in which its table or its first link matrix stands, or there, where the arm before has
    the same section; else with one to which the front matter gives an arm. Raises DocumentError.
    """
    if "arms" in document.front:
        return tuple(_named(document))
    if "arm" in document.front:
        return (document,)
    starts = list(_starts(document)) or list(_of_figures(document))
    parts = (
        (_between(document, *edges) for edges in pairwise([(-1, 0), *starts, (10**9, 0)])) if starts else (document,)
    )
    return tuple(each for part in parts for each in _up_to_other_joints(part))


def _up_to_other_joints(document: Document) -> Iterator[Document]:
    """Yield a part as it stands, or parted where a later section speaks of joints that its link matrices or closed form lack."""
    names = plain_names(document)
    try:
        tables = any(dh_tables(document))
        found = (
            None
            if tables
            else next(iter(candidates_of_matrices(document, names)), None) or candidate_of_closed_form(document, names)
        )
        found = with_last_turn(found, document, names) if found is not None and found.source == "closed form" else found
    except EvaluationError:
        found = None
    start = None
    with suppress(TooComplex):
        start = _next_start(document, names, found, tables)
    if start is None:
        yield document
        return
    yield _between(document, (-1, 0), start)
    yield from _up_to_other_joints(_between(document, start, (10**9, 0)))


def _next_start(document: Document, names: Names, found: Candidate | None, tables: bool) -> Place | None:
    """Return where the next arm begins in a part, of which the arm that it shows first is known or not."""
    if found is not None:
        start = _of_other_joints(document, found) or _behind_other_joints(document, found)
        start = start or (_of_other_points(document, names) if found.source == "closed form" else None)
    else:
        start = (
            None if tables or is_described(document) else _of_other_law(document) or _of_section_alone(document, names)
        )
    return start or _of_letters_anew(document, names)


def _of_section_alone(document: Document, names: Names) -> Place | None:
    """Return where the section begins, or ends, whose displays alone have a closed form: what other sections call x hides it."""
    runs = [tuple(run) for _, run in groupby(document.displays, key=lambda each: each.section)]
    for place, run in enumerate(runs) if len(runs) > 1 else ():
        if any(_of_closed_form(replace(document, displays=run, tables=()), names)):
            edge = runs[place] if place else runs[1]
            return _place(edge[0])
    return None


def _of_other_joints(document: Document, found: Candidate) -> Place | None:
    """Return where a later section begins that speaks of a joint, or of a frame, that an arm lacks."""
    place = (found.cell or 0, found.line)
    at = next((each.section for each in document.displays if _place(each) == place), "")
    beside = [each for each in document.displays if each.section == at and _place(each) > place]
    known = joints_used(beside) if found.source == "closed form" else set()  # of a SCARA's x and y, θ_4
    for display in document.displays:
        if _place(display) > place and display.section != at and _is_beyond(found, display, known):
            return min(
                _place(each) for each in document.displays if each.section == display.section and _place(each) > place
            )
    return None


def _behind_other_joints(document: Document, found: Candidate) -> Place | None:
    """Return where the section begins behind the last one that speaks of joints which a closed form below it lacks."""
    place = (found.cell or 0, found.line)
    before = [each for each in document.displays if _place(each) < place]
    last = next((k for k, each in reversed([*enumerate(before)]) if found.lacks(joints_used([each]))), None)
    if found.source != "closed form" or last is None:
        return None
    behind = (each for each in document.displays if _place(each) > _place(before[last]))
    return next(
        (_place(each) for each in behind if each.section != before[last].section and _place(each) <= place), None
    )


def _of_other_points(document: Document, names: Names) -> Place | None:
    """Return where the points of another chain begin, p_1 and p_2 for joints that move otherwise, as in the next of several examples."""
    display = point_given_anew(document, names)
    if display is None:
        return None
    start = _place(display)
    parts = (_between(document, (-1, 0), start), _between(document, start, (10**9, 0)))
    one, other = (candidate_of_closed_form(part, names) for part in parts)
    if one is None or other is None:
        return None
    return start if (_moves(one), one.twists) != (_moves(other), other.twists) else None


def _of_letters_anew(document: Document, names: Names) -> Place | None:
    """Return where a section begins that gives its tool other coordinates, with letters of which its text tells what they mean there.

    Its angles may be such as no table has, absolute ones: it is about an arm of its own nevertheless.
    """
    first = next(iter(document.displays), None)
    begun = first.section if first is not None else ""
    before: dict[str, list[Scalar]] = {}
    told = _letters_told(first, names) if first is not None else set()
    given = [*coordinates_of_tool(document, names)]
    for section, run in groupby(given, key=lambda each: each[0].section):
        shown = [*run]
        values = {axis: value for _, each in shown for axis, value in each.items()}
        angles = {angle for value in values.values() for angle in angles_in(value)}
        letters = (
            symbols_in(values.values()) if before else angles
        )  # behind a table, which gives no point, its angles mean something else
        met = any(are_equal(value, each) for axis, value in values.items() for each in before.get(axis, ()))
        if section != begun and not met and len(values) > 1 and (_letters_told(shown[0][0], names) - told) & letters:
            return min(_place(each) for each in document.displays if each.section == section)
        for axis, value in values.items():
            before.setdefault(axis, []).append(value)
    return None


def _letters_told(display: Display, names: Names) -> set[str]:
    """Return the letters of which the text of a section tells what they mean."""
    told = (each.split("\t")[1] for each in display.meant if each.startswith("told\t"))
    anew = (each.removeprefix("anew ") for each in display.meant if each.startswith("anew "))
    return {names.reader.key_of(each) for each in (*told, *anew)}


def _of_other_law(document: Document) -> Place | None:
    """Return where a heading begins under which a joint is solved for once more, by a law of cosines of another joint or of other links."""
    names, before = plain_names(document), None
    solved: dict[str, set[str]] = {}
    start: Place = (-1, 0)
    for display in document.displays:
        start = start if before is not None and display.section == before.section else _place(display)
        before = display
        for chain in equations_of(display, names) if "=" in display.latex else ():
            key, formula = bare_key(chain.members[0]) or "", display.latex.strip()
            if not _SOLVED.fullmatch(key):
                continue
            if solved.get(key, {formula}) != {formula} and _are_of_other_laws(document, start):
                return start
            solved.setdefault(key, {formula})
    return None


def _are_of_other_laws(document: Document, start: Place) -> bool:
    parts = (_between(document, (-1, 0), start), _between(document, start, (10**9, 0)))
    arms = [candidate_of_law(part, plain_names(part)) for part in parts]
    return None not in arms and (arms[0].rows, arms[0].joints) != (arms[1].rows, arms[1].joints)  # type: ignore[union-attr]


def _is_beyond(found: Candidate, display: Display, known: Set[int] = frozenset()) -> bool:
    """Whether a display speaks of a joint that an arm lacks, and that is not known beside it, or of a frame behind its last: that of a fixed row is one of its frames."""
    frames = {int(digit) for pair in _FRAMES.findall(display.latex) for digit in pair if digit}
    return bool(found.lacks(joints_used([display]) - known)) or max(frames, default=0) > found.last


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
    left: _Source | None = None  # a table behind which link matrices are of another arm
    for source in sorted(_sources(document), key=lambda one: one.place):
        if source.arm is not None:
            last = left if table is None and source.arm.source == "table" else table
            is_new = last is not None and last.arm is not None and _is_other(source.arm, last.arm)
            is_new = is_new and not _is_given_to(table, source)
            is_new = is_new or (link is not None and table is None and _is_of_other_joints(document, link, source))
            table, link = source, None if is_new else link
        else:
            is_new = link is not None and source.section != link.section and _is_of_other_links(source, link)
            if table is not None and _turn_otherwise(document, table, source):
                is_new, left = True, table
            table, link = None if is_new else table, source if is_new or link is None else link
        if is_new and before is not None:
            yield _start(document, before, source)
        before = source


def _is_of_other_links(source: _Source, before: _Source) -> bool:
    """Whether link matrices are of another arm than those before them: of one that is shown from its first link on, or of one that has another matrix."""
    if 1 not in before.links:
        return are_of_other_chain(source.links, before.links)
    return not are_among(source.links, before.links)


def _turn_otherwise(document: Document, table: _Source, source: _Source) -> bool:
    """Whether a joint turns in the link matrices of a later section that slides in a table, which has a matrix of its own below: they are of another arm."""
    if table.arm is None or source.section == table.section or encloses(table.section, source.section):
        return False
    own = [each.latex for each in document.displays if each.section == table.section and _place(each) > table.place]
    if not any("matrix}" in each for each in own):
        return False
    sliding = {number for number, kind in zip(table.arm.indices, table.arm.kinds, strict=False) if kind == "P"}
    return any(
        number in sliding and number in map(index_of, angles_in(cell))
        for number, matrix in source.links.items()
        for cell in matrix.cells
    )


def _is_given_to(table: _Source | None, source: _Source) -> bool:
    """Whether a table stands above all exercises, of which one has a closed form in its letters: it is given to them all."""
    if table is None or table.arm is None or source.arm is None or source.arm.source != "closed form":
        return False
    is_above = (
        table.arm.source == "table" and encloses(table.section, source.section) and table.section != source.section
    )
    return is_above and _letters(source.arm) - {"pi"} <= _letters(table.arm)


def _is_other(arm: Candidate, before: Candidate) -> bool:
    """Whether an arm is another than one before it; a closed form is that of the table behind it, if it has as many joints, or more that slide."""
    if arm.source == before.source == "closed form":  # of two exercises
        return (arm.rows, arm.joints) != (before.rows, before.joints)
    if before.source == "closed form":
        return sum(map(bool, arm.joints)) != sum(map(bool, before.joints)) and not _adds_slides(arm, before)
    return arm.is_other_than(before)


def _adds_slides(arm: Candidate, before: Candidate) -> bool:
    """Whether a level arm has the joints of one before it, and others that slide: the x and y of a SCARA have none of these."""
    kinds = dict(zip(filter(None, arm.joints), arm.kinds, strict=False))
    added = {kind for joint, kind in kinds.items() if joint not in before.joints}
    reach, own = ({row["a"] for row in each.rows} - {"0"} for each in (before, arm))
    is_level = set(arm.twists) <= {"0", "pi", "-pi"} and reach == own
    return is_level and {*filter(None, before.joints)} < kinds.keys() and added == {"P"}


def _is_of_other_joints(document: Document, link: _Source, source: _Source) -> bool:
    """Whether an arm is none of the link matrices before it: a closed form with other joints, q_1, q_2 behind θ_1, d_2, d_3, a table with other lengths."""
    if source.arm is None:
        return False
    part = _between(document, link.place, source.place)
    try:
        before = next(iter(candidates_of_matrices(part, plain_names(document))), None)
    except EvaluationError:
        return False
    if before is None or source.arm.source == "table":
        lengths = [_letters(each) - {*each.joints} for each in (before, source.arm) if each is not None]
        return (
            all(lengths) and len(lengths) == 2 and lengths[0].isdisjoint(lengths[1]) and source.section != link.section
        )
    return before.kinds != source.arm.kinds and not set(source.arm.joints) <= set(before.joints)


def _sources(document: Document) -> Iterator[_Source]:
    first, names = next(dh_tables(document), None), plain_names(document)
    if first is not None:
        above = _between(document, (-1, 0), _place(first))
        above = replace(above, displays=tuple(each for each in above.displays if each.section != first.section))
        yield from _of_closed_form(above, names)
    yield from _of_exercises(document)
    links = first_links(document, names)
    if first is None and not links:
        yield from _of_sections(document)
    tables = [(table, found[0]) for table in dh_tables(document) if isinstance(found := arms_of(document, table), list)]
    for table, arm in tables:
        yield _Source(_place(table), table.section, arm)
    yield from _behind_tables(document, tables, names) if tables else ()
    if links and (before := links_before_first(document, names)) is not None:
        yield _Source(_place(before[0]), before[0].section, links=before[1])
    for display, found_links in links:
        yield _Source(_place(display), display.section, links=found_links)


def _of_exercises(document: Document) -> Iterator[_Source]:
    """Yield the closed forms of exercises that show neither a table nor a link matrix: each may be about an arm of its own."""
    begins, names = [*_exercises(document)], plain_names(document)
    for begin, end in pairwise([*begins, (10**9, 0)]) if len(begins) > 1 else ():
        part = _between(document, begin, end)
        if not any(dh_tables(part)) and not first_links(part, names):
            yield from _of_closed_form(part, names)


def _of_sections(document: Document) -> Iterator[_Source]:
    """Yield the closed forms of sections of which one has other joints than another, as chapters have that show several arms but no table."""
    names, before = plain_names(document), None
    runs = [tuple(run) for _, run in groupby(document.displays, key=lambda each: each.section)]
    for run in runs if len(runs) > 1 else ():
        part = replace(document, displays=run, tables=())
        found = [*_of_closed_form(part, names)]
        if not found and before is not None and (pose := pose_of_tool(part, names)) is not None:
            at, letters = pose
            if letters - _letters(before):  # of another arm, which is not known
                before = Candidate("closed form", at.line, at.cell, (), ())
                yield _Source(_place(at), at.section, before)
        for source in found:
            shown = next(each.latex for each in run if _place(each) == source.place)
            is_plain = _POINT.search(shown) is None or (source.arm is not None and source.arm.quantities)
            if is_plain and (before is None or _moves(source.arm) != _moves(before)):
                before = source.arm
                yield source


def _behind_tables(document: Document, tables: Sequence[tuple[Table, Candidate]], names: Names) -> Iterator[_Source]:
    """Yield the closed forms of sections behind tables that are of another arm, as chapters have that go on with a next one.

    They are of other lengths than any table's; or it is the first that is of another chain than the last table.
    """
    arms = [arm for _, arm in tables]
    begin = min((arm.cell or 0, arm.line) for arm in arms)
    behind = [each for each in document.displays if _place(each) > begin]
    runs = (tuple(run) for _, run in groupby(behind, key=lambda each: each.section))
    forms = [each for run in runs for each in _of_closed_form(replace(document, displays=run, tables=()), names)]
    taken = {each.section for each in dh_tables(document)} | {each.section for each, _ in first_links(document, names)}
    known = [_lengths(arm) for arm in arms]
    others = [each for each in forms if all(known) and each.section not in taken and _has_own_lengths(each, known)]
    yield from others
    last = tables[-1][0]
    if _place(last) == _place([*dh_tables(document)][-1]):
        ahead = (each for each in forms if each.place > _place(last) and each.section != last.section)
        found = next((each for each in ahead if each.arm is not None and _is_of_other_chain(each.arm, arms[-1])), None)
        yield from [found] if found is not None and found not in others else []


def _has_own_lengths(form: _Source, known: Iterable[frozenset[str]]) -> bool:
    own = _lengths(form.arm) if form.arm is not None else frozenset()
    return bool(own) and own.isdisjoint(frozenset[str]().union(*known))


def _lengths(arm: Candidate) -> frozenset[str]:
    return _letters(arm) - {*arm.joints, "pi"}


def _is_of_other_chain(form: Candidate, arm: Candidate) -> bool:
    """Whether a joint of a closed form slides that turns in a table, or the table has none of its number; or one alone of the two is planar."""
    kinds, own = (dict(zip(each.indices, each.kinds, strict=False)) for each in (form, arm))
    if len(kinds) != len(form.kinds) or len(own) != len(arm.kinds) or not _lengths(arm).isdisjoint(form.joints):
        return False  # d_3 of Khalil's table is a length, and slides where nothing else is known of it
    if any(own.get(number) != kind for number, kind in kinds.items()):
        return True
    return kinds == own and len(own) > 2 and _is_level(form) is not _is_level(arm)


def _is_level(arm: Candidate) -> bool:
    return set(arm.twists) <= {"0"}


def _of_closed_form(part: Document, names: Names) -> Iterator[_Source]:
    """Yield the arm that the closed form in a part shows, if one does; none that takes more than a display may."""
    form = None
    with suppress(TooComplex):
        form = candidate_of_closed_form(part, names)
    if form is not None:
        at = next(each for each in part.displays if _place(each) == (form.cell or 0, form.line))
        yield _Source(_place(at), at.section, form)


def _letters(form: Candidate) -> frozenset[str]:
    """Return the letters of an arm's entries."""
    return frozenset(re.findall(r"[A-Za-z]\w*", " ".join(entry for row in form.rows for entry in row.values())))


def _moves(form: Candidate | None) -> list[tuple[str, str]]:
    """Return the joints of a closed form, each with what it moves."""
    return [] if form is None else [(joint, column) for row, joint in zip(form.rows, form.joints, strict=True) for column in row
            if joint and joint in row[column]]  # fmt: skip


def _exercises(document: Document) -> Iterator[Place]:
    """Yield where each exercise of its own begins, by the headings above its displays and tables."""
    name = ""
    parts: list[Display | Table] = [*document.displays, *document.tables]
    for part in sorted(parts, key=_place):
        head = WITH_ITS_ARM.match(part.section)
        if head is not None and head[0] != name:
            name = head[0]
            yield _place(part)


def _of_figures(document: Document) -> Iterator[Place]:
    """Yield where each exercise but the first begins, where one tells its figure by vectors: that is of no other's arm."""
    begins = [*_exercises(document)]
    yield from begins[1:] if document.figures else ()


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
    in_code = tuple(table for table in document.in_code if begin <= _place(table) < end)
    robots = tuple(each for each in document.robots if begin <= (each.cell or 0, each.line) < end)
    told = tuple(each for each in document.told if begin <= each.before < end)
    places = [*map(_place, document.displays), (10**9, 0)]
    behind = (
        (min(at for at in places if at >= (cell or 0, line)), (cell, line, latex))
        for cell, line, latex in document.figures
    )
    figures = tuple(each for at, each in behind if begin <= at < end)
    return replace(
        document, displays=displays, tables=tables, in_code=in_code, robots=robots, told=told, figures=figures
    )
