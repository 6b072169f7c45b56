"""From a document without an arm to one that names it: what it was taken from, and the reading under which most holds."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from armproof.models.errors import ArmproofError
from armproof.verification.document import Display, Document, Table
from armproof.verification.errors import EvaluationError, ReadError, TooComplex
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.moving import rates_in
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import cells_in_units, read_names, spelling_of
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.beyond import with_point_beyond
from armproof.verification.tables.arms.candidate import Candidate
from armproof.verification.tables.arms.closed_forms import candidates_of_closed_form
from armproof.verification.tables.arms.code_letters import in_letters_of
from armproof.verification.tables.arms.descriptions import described_arms
from armproof.verification.tables.arms.ends import with_ends
from armproof.verification.tables.arms.figures import figure_arms
from armproof.verification.tables.arms.general_link import shown_convention
from armproof.verification.tables.arms.last_turn import with_last_turn
from armproof.verification.tables.arms.laws import candidate_of_law, with_point_of_law
from armproof.verification.tables.arms.matrices import (
    candidate_of_rotations,
    candidates_of_matrices,
    poses_that_are_links,
)
from armproof.verification.tables.arms.other_case import in_other_case
from armproof.verification.tables.arms.robots import candidate_of_robot
from armproof.verification.tables.arms.rows import candidates
from armproof.verification.tables.arms.screws import candidate_of_screws
from armproof.verification.tables.arms.settling import Inference
from armproof.verification.tables.arms.variables import in_variables, told_variables
from armproof.verification.tables.arms.witnesses import Reading, weigh
from armproof.verification.tables.check import read_array, turned
from armproof.verification.tables.columns import CONVENTIONS, read_columns
from armproof.verification.tables.row import SCALES
from armproof.verification.verdict import TakenArm

_MOST_RIVALS = 2
_FEWEST = 2  # equations that hold for an arm that is told in words
_NUMBER = regex(r"(?<![\d._{])[1-9]\d*(?:\.\d+)?(?![\d.])")
_AT_REST = regex(r"\\dot\s*\{?\s*\\?(?:theta|q)\s*_\s*\{?\d+[\s}]*=\s*0(?![\d.])")  # of what does not move
_INDEXED = regex(r"(?:theta(?:\s*_)?|(?<![A-Za-z])[qcsCS]\s*_)\s*\{?\s*(\d+)(?!\d|\s*\\times)")


def infer_arm(document: Document) -> Inference:
    """Return a document with the arm that its DH table gives, else its link matrices or a closed form, in the reading under which most of its equations hold.

    A document that names its arm stays as it is, and so does one in which nothing tells one reading from another.
    """
    if "arm" in document.front:
        return Inference(document)
    try:
        return _inferred(document)
    except TooComplex as error:
        return Inference(document, None, finding_of(error))


def _inferred(document: Document) -> Inference:
    of_table = _of_tables(document)
    if of_table.arm is not None or of_table.is_disputed:  # the matrices are the equations that may be wrong
        return of_table
    if (of_figure := _of_figure(document)) is not None:
        return of_figure
    if (of_screws := candidate_of_screws(document, plain_names(document))) is not None:
        return _settle(document, [of_screws])
    try:
        found = candidates_of_matrices(document, plain_names(document))
    except EvaluationError as error:
        problem = finding_of(error)
        return (
            of_table if of_table.problem is not None else Inference(document, None, problem, problem.terms.get("line"))
        )
    found = [_with_rows_beyond(each, document) for each in found]
    if not found or all(
        each.lengths & rates_in(document.displays) for each in found
    ):  # a slide along x is no row of DH
        forms = _of_formulas(document, plain_names(document))
        if not found and of_table.problem is None:
            told = _of_words(document, forms) or _of_code(document, forms)
            if told is not None:
                return told
        found = forms or found
    found = found or (candidate_of_rotations(document, plain_names(document)) if of_table.problem is None else [])
    settled = _settle(document, found) if found else of_table
    if settled.arm is None and found and found[0].source == "matrices" and (own := _of_words(document, ())) is not None:
        return own
    return settled if settled.arm is not None else of_table


def _with_rows_beyond(found: Candidate, document: Document) -> Candidate:
    """Return the arm of link matrices with the rows of the table beyond them, where one entry alone of the others differs."""
    count = len(found.rows)
    table = next((each for each in map(partial(arms_of, document), dh_tables(document)) if isinstance(each, list)), [])
    for other in table:
        fits = found.conventions[0] in other.conventions and found.joints == other.joints[:count]
        if found.frames or other.frames or not fits or len(other.rows) <= count:
            continue
        apart = [
            1 for own, row in zip(found.rows, other.rows, strict=False) for column in own if own[column] != row[column]
        ]
        if len(apart) == 1:
            rows, joints = (*found.rows, *other.rows[count:]), (*found.joints, *other.joints[count:])
            return replace(found, rows=rows, joints=joints, symbols={**other.symbols, **found.symbols})
    return found


def _of_code(document: Document, of_formulas: Sequence[Candidate]) -> Inference | None:
    """Return the document with the arm of the tables or the URDF in its code that another display shows to be meant, where they are of one arm; None where the formulas pin one of which more holds."""
    made = [arms_of(document, in_letters_of(document, table)) for table in document.in_code]
    found = [each for each in made if not isinstance(each, Finding)]
    built = candidate_of_robot(document) if not found else None
    found = [[built]] if built is not None else found
    if not found or any(each[0].is_other_than(found[0][0]) for each in found):
        return None
    if of_formulas and not _holds_as_much(document, found[0], of_formulas):
        return None
    settled = _settle(document, [replace(each, is_alone=True) for each in found[0]])
    return settled if settled.arm is not None else None


def _holds_as_much(document: Document, told: Sequence[Candidate], others: Sequence[Candidate]) -> bool:
    """Whether of a document's equations two hold for an arm that it tells of, and no fewer than for others."""
    fronts = [[front for each in arms for front in _fronts(document, each)] for arms in (told, others)]
    try:
        readings = weigh(document, [*fronts[0], *fronts[1]], to_the_end=True)
    except ArmproofError:
        return False
    best = [max((each.held for each in readings if each.front in own), default=0) for own in fronts]
    return best[0] >= max(best[1], _FEWEST)


def _of_formulas(document: Document, names: Names) -> list[Candidate]:
    """Return the arms that a document's formulas pin: its tool's coordinates, else a law of cosines."""
    has_table = any(True for _ in dh_tables(document))
    found = [with_point_of_law(each, document, names) for each in candidates_of_closed_form(document, names, has_table)]
    by_law = candidate_of_law(document, names) if not found else None
    return [with_last_turn(each, document, names) for each in found or filter(None, [by_law])]


def is_described(document: Document) -> bool:
    """Whether a document's text tells of an arm of which its equations hold."""
    return _of_words(document, ()) is not None


def _of_figure(document: Document) -> Inference | None:
    """Return the document with the arm of its figure's vectors, where two of its equations hold for that, and more than do not."""
    if not (document.figures or any("\\vec" in each.latex or "arrow" in each.latex for each in document.displays)):
        return None
    found, elsewhere = figure_arms(document, plain_names(document))
    fronts = [front for each in (*found, *elsewhere) for front in _fronts(document, each)]
    own = [front for each in found for front in _fronts(document, each)]
    try:
        readings = weigh(document, fronts, source=found[0].source, to_the_end=True) if found else []
    except ArmproofError:
        return None
    best = next((each for each in readings if each.front in own), None)
    others = [each for each in readings if best is not None and each.front["arm"] != best.front["arm"]]
    if best is None or best.held < max(_FEWEST, best.failed) or any(each.held >= best.held for each in others):
        return None
    return _taken(document, found, best, False)


def _of_words(document: Document, of_formulas: Sequence[Candidate]) -> Inference | None:
    """Return the document with the arm that its text tells of, where two of its equations hold for that, and more than do not, or they do with one direction turned round.

    What as much holds of, an arm of its formulas or the same with a direction turned round, is its rival; None where the formulas pin one of which more holds.
    """
    names = plain_names(document)
    told, turned = described_arms(document, names) if document.told else ([], [])
    told, turned = ([with_point_of_law(each, document, names) for each in arms] for arms in (told, turned))
    used, moving = joints_used(document.displays), rates_in(document.displays)
    found = [each for each in told if not each.lacks(used) and each.lengths.isdisjoint(moving)]
    if not found:
        return None
    fronts = [front for each in (*found, *turned, *of_formulas) for front in _fronts(document, each)]
    own = [front for each in found for front in _fronts(document, each)]
    try:
        readings = weigh(document, fronts, source=found[0].source, to_the_end=True)
    except ArmproofError:
        return None
    best = next((each for each in readings if each.front in own), None)
    if best is None or best.held < _FEWEST:
        return None
    if _is_pinned_with_more(
        document, best, [each for each in found if best.front in _fronts(document, each)], of_formulas, readings
    ):
        return None
    turned_fronts = [front for each in turned for front in _fronts(document, each)]
    is_turned = any(
        each.front in turned_fronts and each.held > each.failed for each in readings if _is_rival(each, best)
    )
    if best.held <= best.failed and not is_turned:
        return None
    others = {repr(each.front["arm"]): each for each in readings if _is_rival(each, best)}
    taken = _taken(document, found, best, False)
    assert taken.arm is not None
    return replace(taken, arm=replace(taken.arm, rivals=tuple(each.front for each in others.values())[:_MOST_RIVALS]))


def _is_pinned_with_more(
    document: Document,
    best: Reading,
    told: Sequence[Candidate],
    of_formulas: Sequence[Candidate],
    readings: Sequence[Reading],
) -> bool:
    """Whether the formulas pin the arm that the text tells of with lengths of which it tells nothing, such as where its base stands, and more holds so than in any way that the text may be meant."""
    more = [each for each in of_formulas if any(map(each.holds_more_than, told))]
    fronts = [front for each in more for front in _fronts(document, each)]
    held = [each.held for each in readings if each.front in fronts]
    others = [each.held for each in readings if each.front not in fronts]
    return bool(held) and max(held) > max(best.held, *others)


def _is_rival(one: Reading, best: Reading) -> bool:
    """Whether as much holds under another reading, or more, and not all there is under both."""
    return one.counts <= best.counts and one.front["arm"] != best.front["arm"] and (one.failed > 0 or best.failed > 0)


def _of_tables(document: Document) -> Inference:
    """Return the document with the arm of its first table that gives one."""
    problem: tuple[Finding | None, int | None] = (None, None)
    for table in dh_tables(document):
        found = arms_of(document, table)
        if not isinstance(found, Finding):
            return _settle(document, _with_links(found, document))
        problem = problem if problem[0] is not None else (found, table.line)
    return Inference(document, None, *problem)


def _with_links(found: list[Candidate], document: Document) -> list[Candidate]:
    """Return the arms of a table, in which T_2 is the link that its matrix shows it to be."""
    named = poses_that_are_links(document, plain_names(document))
    own = [{key: each for key, each in named.items() if int(each["pose"]) <= len(arm.joints)} for arm in found]
    return [
        arm if arm.frames or arm.first else replace(arm, quantities={**links, **arm.quantities})
        for arm, links in zip(found, own, strict=True)
    ]


def arms_of(document: Document, table: Table) -> list[Candidate] | Finding:
    """Return the arms that a DH table can mean, or why it gives none."""
    try:
        columns = read_columns(table.header)
        return list(candidates(table, columns, plain_names(document), in_metres(document, table)))  # type: ignore[arg-type]
    except (EvaluationError, ReadError, RecursionError) as error:
        return finding_of(error)


def in_metres(document: Document, table: Table) -> bool:
    """Whether a document calculates in metres, whatever the unit of its table: else a number of it stands in a display, or one that no such arm reaches."""
    numbers = {number for row in table.rows for cell in row for number in _NUMBER.findall(cell) if len(number) > 1}
    numbers -= {"90", "180", "45", "60", "30", "120", "135", "270", "360"}
    printed = [set(_NUMBER.findall(display.latex)) for display in document.displays]
    return not any(numbers & each for each in printed) and not _is_beyond_reach(document, table)


def _is_beyond_reach(document: Document, table: Table) -> bool:
    """Whether a matrix prints a number that an arm of a table's lengths reaches in their unit, and not in metres."""
    lengths = [(unit, float(number)) for cell, unit in cells_in_units(table) for number in _NUMBER.findall(cell)]
    in_unit, metres = sum(each for _, each in lengths), sum(each * SCALES[unit] for unit, each in lengths)
    matrices = (display.latex for display in document.displays if "matrix" in display.latex)
    decimals = [float(number) for latex in matrices for number in _NUMBER.findall(latex) if "." in number]
    return metres < max(decimals, default=0.0) <= in_unit


def plain_names(document: Document) -> Names:
    """Return the names of a document that is about no arm, read as it spells."""
    names = read_names(None, {})
    names.reader.spelling = spelling_of(document, names.reader.words)
    return names


def dh_tables(document: Document) -> Iterator[Table]:
    """Yield the DH tables of a document, upright, in their order."""
    arrays = (array.table for display in document.displays if (array := read_array(display)) is not None)
    for table in sorted((*document.tables, *arrays), key=lambda one: (one.cell or 0, one.line)):
        upright = next((each for each in (table, turned(table)) if each and read_columns(each.header)), None)
        if upright is not None and not table.erratum:
            yield upright


def _settle(document: Document, found: list[Candidate]) -> Inference:
    """Return the document with the arm of the candidates' best reading, or the reason why none is."""
    told = told_variables(document, plain_names(document))
    found = [in_variables(candidate, told) for candidate in found] if told else found
    line = found[0].line
    moving = rates_in(document.displays)
    if moved := next((letter for each in found for letter in sorted(each.lengths & moving)), None):
        found = [each for each in found if each.lengths.isdisjoint(moving)]
        if not found:
            return Inference(document, None, say(Kind.LENGTH_MOVES, name=moved), line)
    more, count = found[0].lacks(joints_used(document.displays)), sum(map(bool, found[0].joints))
    missing = say(Kind.JOINTS_MISSING, count=count, index=more)
    is_told = bool(found[0].told_by)
    if more and not is_told and (found[0].source != "table" or more <= found[0].last):
        return Inference(document, None, missing, line)
    try:
        apart = found[0].lines if found[0].is_alone else ()
        best, *others = _weighed(document, found, apart)
    except ArmproofError as error:
        return Inference(document, problem=say(Kind.NO_ARM_IN_TABLE, reason=finding_of(error)), line=line)
    if found[0].is_alone and not best.held:
        return Inference(document)
    if is_told:
        return _taken(document, found, best, bool(more)) if found[0].told_by in best.joints else Inference(document)
    named = document.convention if found[0].source == "table" else ""
    if best.failed:
        best, *others = _as_named(named, best, others)
    if _speaks_against(best, others, named, found[0].stated):
        return Inference(document, problem=say(Kind.CONVENTION_DISPUTED, told=named), line=line)
    best, rivals, is_shown = _shown_best(document, named or found[0].stated, best, others)
    best = with_point_beyond(document, best) if best.held and not rivals else best
    if best.held and not rivals:
        best, found = with_ends(document, plain_names(document), best, found)
    if more and (rivals or best.failed >= best.held):  # a part of an arm shows itself in poses of its own frames
        return Inference(document, None, missing, line)
    taken = _taken(document, found, best, bool(more))
    if _stated(document):
        return taken
    is_plain = found[0].source in ("table", "matrices") and len(found) == 1 and not rivals
    unfit = taken if is_plain else None
    is_pinned = found[0].source == "closed form" and not found[0].is_alone  # then one line alone may be what is wrong
    if rivals or not (best.held or is_shown or (is_pinned and best.failed == 1)):
        return Inference(document, problem=say(Kind.CONVENTION_OPEN), line=line, unfit=unfit)
    if best.failed > max(best.held, int(is_pinned)) + found[0].in_words and not best.is_near:  # words hold, too
        problem = say(Kind.ARM_DOES_NOT_FIT, held=best.held, failed=best.failed)
        return Inference(document, problem=problem, line=line, unfit=unfit)
    return taken


def _as_named(convention: str, best: Reading, others: list[Reading]) -> list[Reading]:
    """Return the readings, first those of the convention that the text names where as much holds so, and no more fails by more than a slip."""
    is_as_good = [
        each.convention == convention and (each.held, each.contradicted) == (best.held, best.contradicted)
        for each in others
    ]
    if not any(is_as_good):
        return [best, *others]
    own = [each for each, is_own in zip(others, is_as_good, strict=True) if is_own]
    return [*own, best, *(each for each, is_own in zip(others, is_as_good, strict=True) if not is_own)]


def _speaks_against(best: Reading, others: Sequence[Reading], told: str, stated: str) -> bool:
    """Whether equations hold by another convention than the author tells in words: text or equations are wrong, unless the header of the table sides with these."""
    of_told = [each for each in others if each.convention == told != best.convention]
    if best.failed and any(each.held for each in of_told):
        return True
    return stated in ("", told) and bool(of_told) and all(each.counts != best.counts for each in of_told)


def _shown_best(
    document: Document, stated: str, best: Reading, others: list[Reading]
) -> tuple[Reading, list[Reading], bool]:
    """Return the best reading that the document shows to be meant, its rivals, and whether something shows it but its equations."""
    rivals = _rivals(best, others)
    shown = shown_convention(document, plain_names(document)) or stated if rivals or not best.held else ""
    as_shown = [each for each in (best, *others) if each.convention == shown]
    is_shown = bool(as_shown)
    if is_shown:  # by the link matrix that it prints for any link, else by the headers of its table
        best, *others = as_shown
        rivals = _rivals(best, others)
    if rivals and not best.held and not shown and (near := [one for one in (best, *rivals) if one.is_near]):
        best, *others = near  # a pose that one slip alone parts from it
        rivals, is_shown = _rivals(best, others), True
    alike = any(one.counts == best.counts and one.front["arm"] == best.front["arm"] for one in others)
    if alike and "transforms" not in document.front:  # nothing tells which index is the reference
        best = replace(best, front={key: value for key, value in best.front.items() if key != "transforms"})
    return best, rivals, is_shown


def _weighed(
    document: Document, found: Sequence[Candidate], apart: Collection[tuple[int | None, int]]
) -> list[Reading]:
    """Return the readings that candidates can have, the best first; with L_2 for their l_2 where more holds so."""
    source = found[0].source if found[0].is_alone else ""  # \dot q = J^{-1} \dot x in letters tells of a Jacobian
    fronts = [front for candidate in found for front in _fronts(document, candidate)]
    readings = weigh(document, fronts, apart, source=source)
    cased = [each for candidate in found if (each := in_other_case(candidate, document)) is not None]
    if not cased:
        return readings
    others = weigh(document, [front for candidate in cased for front in _fronts(document, candidate)], apart)
    return others if others[0].held > readings[0].held else readings


def _rivals(best: Reading, others: Sequence[Reading]) -> list[Reading]:
    """Return the readings under which as much holds, of another arm."""
    return [one for one in others if one.counts == best.counts and one.front["arm"] != best.front["arm"]]


def joints_used(displays: Iterable[Display]) -> set[int]:
    """Return the indices of joint variables in displays, as in θ_3 or c_{23}; a rate that is zero is that of none."""
    texts = (_AT_REST.sub("", normalise_unicode(d.latex)) for d in displays if not (d.erratum or d.denied))
    return {int(digit) for text in texts for part in _INDEXED.findall(text) for digit in part}


def _stated(document: Document) -> tuple[str, ...]:
    """Return the convention that the author states, alone, or nothing."""
    return tuple(convention for convention in CONVENTIONS if document.front.get("convention") == convention)


def _fronts(document: Document, candidate: Candidate) -> Iterator[Mapping[str, Any]]:
    directions = (document.front["transforms"],) if "transforms" in document.front else ("upper", "lower")
    for convention in _stated(document) or candidate.conventions:
        for transforms in directions:
            found = candidate.front(convention)
            named = {
                key: {**found.get(key, {}), **(document.front.get(key) or {})} for key in ("symbols", "quantities")
            }
            more = {key: value for key, value in named.items() if value}
            yield {**document.front, **found, **more, "transforms": transforms}


def _taken(document: Document, found: Sequence[Candidate], reading: Reading, is_part: bool) -> Inference:
    own = (each for each in found if each.front(reading.convention)["arm"] == reading.front["arm"])
    candidate = next(own, found[0])
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
        frozenset(candidate.products),
        candidate.several_tools,
        is_part,
        candidate.told_by,
        candidate.mended,
        candidate.in_words,
    )
    return Inference(replace(document, front=dict(reading.front)), arm)
