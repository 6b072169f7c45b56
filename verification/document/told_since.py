"""What sentences say of the displays behind them, up to the end of their section: a task, a joint that is locked or turned round, a second robot."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import inf

from armproof.verification.document.amended_tables import AMENDED, MAY_AMEND, Cells, amends_table, has_same_table
from armproof.verification.document.changed_arms import MAY_CHANGE_ARM, changes_arm
from armproof.verification.document.first_order import FIRST_ORDER, MAY_BE_FIRST_ORDER, is_to_first_order
from armproof.verification.document.hearing import MOST_CHARACTERS, formulas_of, with_axes, words_of
from armproof.verification.document.joint_limits import (
    LIMITED,
    MAY_LIMIT,
    bounds_joint,
    columns_of_limits,
    limits_joints,
)
from armproof.verification.document.locked_joints import LOCKED, MAY_LOCK, held_letters, locks
from armproof.verification.document.model import Display
from armproof.verification.document.told_branches import MAY_TELL_BRANCH, ToldBranch, called_branches, told_branches
from armproof.verification.document.told_builds import (
    MAY_TELL_BUILD,
    OTHER_BUILD,
    is_of_other_machine,
    next_table,
    told_build,
    turned_round,
)
from armproof.verification.document.told_constraints import (
    CONSTRAINED,
    MAY_CONSTRAIN,
    NEGATIVE,
    constrains_tool,
    is_negative,
)
from armproof.verification.document.told_jacobians import (
    MAPS_BACK,
    MAPS_OTHERWISE,
    MAY_TELL_JACOBIAN,
    OF_MAPS,
    answers_back,
    maps_otherwise,
    told_jacobians,
)
from armproof.verification.document.told_motions import MAY_TELL_MOTION, SINCE, told_motion
from armproof.verification.document.told_notation import REACTION
from armproof.verification.document.told_numbers import (
    MAY_TELL_NUMBERS,
    as_told,
    in_two_units,
    may_be_grouped,
    rates_without_unit,
    reads_scaled,
    units_told,
)
from armproof.verification.document.told_operations import MAY_TELL_OPERATION, OPERATION, told_operation
from armproof.verification.document.told_quantities import (
    MAY_TELL_QUANTITY,
    TOLD_QUANTITY,
    TOLD_THING,
    names_thing,
    tells_quantity,
)
from armproof.verification.document.told_relative import MAY_TELL_RELATIVE, relative_angles
from armproof.verification.document.told_sides import goes_on_with_side
from armproof.verification.document.told_statics import (
    FORCE_ELSEWHERE,
    MAY_TELL_BALANCE,
    acts_on_tool,
    force_of_balance,
    holds_arm,
    is_force_elsewhere,
)
from armproof.verification.document.told_tasks import MAY_TELL_TASK, told_tasks
from armproof.verification.patterns import regex

MAY_SAY_SINCE = regex(  # what no text lacks that says so, in small letters
    f"{MAY_TELL_BUILD.pattern}|{MAY_LOCK.pattern}|{MAY_TELL_TASK.pattern}|{MAY_TELL_BRANCH.pattern}|{MAY_TELL_JACOBIAN.pattern}|{MAY_TELL_BALANCE.pattern}"
    f"|{MAY_TELL_QUANTITY.pattern}|{MAY_TELL_RELATIVE.pattern}|{MAY_TELL_NUMBERS.pattern}"
    f"|{MAY_AMEND.pattern}|{MAY_TELL_OPERATION.pattern}|{MAY_TELL_MOTION.pattern}|{MAY_CHANGE_ARM.pattern}|{MAY_LIMIT.pattern}|{MAY_BE_FIRST_ORDER.pattern}|{MAY_CONSTRAIN.pattern}"
)
_BESIDE = 12  # lines behind a sentence that may be said of what is near alone
_PLAIN = regex(
    r"\\(?:begin|end)\s*\{\w+\*?\}(?:\{[lcr|\s]*\})?|[{}\s]|\\(?:left|right|quad|qquad|begin|end|operatorname|mathrm|text)(?![A-Za-z])"
)
_LETTER = regex(r"(?P<base>\\[A-Za-z]+|[A-Za-z])(?:_\w+)?")

Reach = Callable[[int], tuple[int, float]]


@dataclass(frozen=True)
class Since:
    """What is said of the displays from one line to another."""

    said: str
    begins: float
    ends: float


def told_since(
    text: str,
    displays: Sequence[Display],
    sentences: Sequence[tuple[int, str]],
    reach: Reach,
    tables: Sequence[Cells] = (),
) -> Iterator[Since]:
    """Yield what the sentences of a text say of displays behind them, each with its place, or of all that rests on a table."""
    yield from (Since(LIMITED, text.count("\n", 0, place) + 1, inf) for place in columns_of_limits(text))
    bounding = (display.line for display in displays if bounds_joint(display.latex))
    yield from (Since(LIMITED, line, reach(line)[1]) for line in bounding)
    heard: list[_Heard] = []
    said = [(place, sentence) for place, sentence in sentences if sentence]
    begins = _lines(text, [place for place, _ in said])
    lines = [display.line for display in displays]
    for at, (place, sentence) in enumerate(said):
        if len(sentence) > MOST_CHARACTERS or not MAY_SAY_SINCE.search(sentence.lower()):
            continue
        plain = with_axes(" ".join(sentence.split()))
        words, formulas = words_of(plain), formulas_of(plain)
        line = begins[at]
        begin, end = reach(line)
        heard.append(_Heard(words, formulas, line, begins[at + 1] if at + 1 < len(begins) else inf, begin, end))
        joints, since = turned_round(words, formulas)
        if joints and any(each < line for each in lines):  # what is said before all is of the arm as it is
            ends = {"from here": inf, "now": end}.get(since, min(end, line + _BESIDE))
            yield from (Since(each, line, ends) for each in joints)
        if is_of_other_machine(words) and any(begin <= each < line for each in lines):
            yield Since(OTHER_BUILD, line, min(end, _before_table(text, place)))
        may_change = MAY_CHANGE_ARM.search(words.lower()) and not sentence.startswith("(")  # aside it changes nothing
        if tables and MAY_AMEND.search(words.lower()):
            if not has_same_table(words):
                yield from _of_tables(words, formulas, line, tables)
            elif tables[0].line < line:
                yield Since(OTHER_BUILD, line, min(end, _before_table(text, place)))
        above = _letters_above(displays, tables, line) if may_change else set()
        if above and changes_arm(words, formulas, above):
            yield Since(OTHER_BUILD, line, min(end, _before_table(text, place)))
        yield from (Since(each, begin, inf) for each in told_build(words, formulas))
        yield from (Since(each, line, end) for each in told_tasks(words, formulas))
        yield from (Since(each, begin, end) for each in relative_angles(words, formulas))
        if limits_joints(words, formulas):
            yield Since(LIMITED, line, end if any(map(bounds_joint, formulas)) else inf)
        if is_to_first_order(words):
            yield Since(FIRST_ORDER, line, end)
        if constrains_tool(words, formulas):
            yield Since(CONSTRAINED, line, end)
        if is_negative(words, formulas):
            yield Since(NEGATIVE, line, end)
        if motion := told_motion(words):
            yield Since(SINCE + motion, line, end)
        if is_force_elsewhere(words, formulas):
            yield Since(FORCE_ELSEWHERE, line, end)
        if locks(words, formulas):
            letters = held_letters(words, formulas)
            yield from (Since(f"{LOCKED} {each}" if each else LOCKED, line, end) for each in letters or ("",))
        if MAY_TELL_OPERATION.search(words.lower()) and (operation := told_operation(words)):
            yield Since(f"{OPERATION} {operation}", line, heard[-1].until)
        behind = said[at + 1][1] if at + 1 < len(said) else ""
        above_it = said[at - 1][1] if at else ""
        is_of_units = (
            units_told(words, formulas)
            or rates_without_unit(words, [*formulas, *formulas_of(behind)])
            or in_two_units(sentence, above_it)
        )
        if is_of_units or reads_scaled(sentence, words, behind) or may_be_grouped(formulas, text):
            yield Since(as_told(sentence), line, end)
        if tells_quantity(words):
            yield Since(TOLD_QUANTITY, line, heard[-1].until)
        elif names_thing(words):
            yield Since(TOLD_THING, line, heard[-1].until)
    yield from _of_branches(heard)
    yield from _of_jacobians(heard)
    yield from _of_maps(displays, reach)
    yield from _of_statics(heard, displays, reach)


def _of_tables(words: str, formulas: Sequence[str], line: int, tables: Sequence[Cells]) -> Iterator[Since]:
    """Yield that a sentence amends the table above it, or the first one, for all that rests on that: up to the next one."""
    above = [place for place, each in enumerate(tables) if each.line <= line]
    at = above[-1] if above else 0
    if amends_table(words, formulas, tables[at], line):
        ends = tables[at + 1].line if at + 1 < len(tables) else inf
        yield Since(f"{AMENDED} {' '.join(words.split())}", tables[at].line if at else 0, ends)


@dataclass(frozen=True)
class _Heard:
    """A sentence: its words and formulas, its line and that of the next one, and the lines of its section."""

    words: str
    formulas: Sequence[str]
    line: int
    next_line: float
    begin: int
    end: float

    @property
    def until(self) -> float:
        """Up to where it is said of what it leads to alone."""
        return min(self.end, self.next_line)


def _lines(text: str, places: Sequence[int]) -> list[int]:
    """Return the lines of places in a text, which are in order: each is counted from the one before."""
    steps = (text.count("\n", start, stop) for start, stop in pairwise((0, *places)))
    return [1 + count for count in accumulate(steps)]


def _of_maps(displays: Sequence[Display], reach: Reach) -> Iterator[Since]:
    """Yield that J maps otherwise where the first display of a section that says what it maps says so."""
    heard = set[int]()
    for display in displays:
        begin, end = reach(display.line)
        says = None if begin in heard else maps_otherwise(display.latex)
        heard |= set() if says is None else {begin}
        if says:
            yield Since(MAPS_OTHERWISE, begin, end)


def _of_branches(heard: Sequence[_Heard]) -> Iterator[Since]:
    """Yield which branches are told, each up to where its letter is told anew; what words alone tell up to where any is."""
    told = [*_branches(heard)]
    for at, (sentence, branch) in enumerate(told):
        later = (
            each.line
            for each, other in told[at + 1 :]
            if each.line > sentence.line and branch.letter in ("", other.letter)
        )
        if branch.bound or not branch.letter:  # of both signs nothing holds
            ends = sentence.until if branch.is_brief else sentence.end
            yield Since(branch.as_meant(), sentence.line, min(ends, next(later, inf)))


def _branches(heard: Sequence[_Heard]) -> Iterator[tuple[_Heard, ToldBranch]]:
    """Yield which branches sentences tell; one that a sentence before has named is told by its name."""
    names: dict[str, ToldBranch] = {}
    begun, before = 0, ""
    for each in heard:
        names, before = (names, before) if each.begin == begun else ({}, "")
        begun = each.begin
        called = [
            branch
            for name, branch in names.items()
            if re.search(rf"(?<!\S){re.escape(name)}(?!\S)", each.words.lower())
        ]
        yield from ((each, branch) for branch in called if len(called) == 1)
        yield from ((each, branch) for branch in told_branches(each.words, each.formulas) if not called)
        if goes_on_with_side(each.words, before):
            yield each, ToldBranch()
        names = called_branches(each.words, each.formulas) or names
        before = each.words


def _of_jacobians(heard: Sequence[_Heard]) -> Iterator[Since]:
    """Yield that J maps otherwise, in all of a section, and which size it has, up to where another is told."""
    told = [(each, said) for each in heard for said in told_jacobians(each.words, each.formulas)]
    yield from (Since(said, each.begin, each.end) for each, said in told if said in OF_MAPS)
    for before, each in pairwise(heard):
        if answers_back(before.words, each.words, each.formulas):
            yield Since(MAPS_BACK, each.line, each.end)
    sizes = [(each, said) for each, said in told if said not in OF_MAPS]
    until = [*(each.line for each, _ in sizes[1:]), inf]
    for (each, said), later in zip(sizes, until, strict=False):
        yield Since(said, each.line, min(each.end, later))


def _of_statics(heard: Sequence[_Heard], displays: Sequence[Display], reach: Reach) -> Iterator[Since]:
    """Yield that a force acts on the tool where a section tells of what holds it, and behind a printed sum of both works."""
    holding = {each.begin for each in heard if holds_arm(each.words)}
    for each in (one for one in heard if one.begin in holding):
        for letter in acts_on_tool(each.words, each.formulas):
            yield Since(f"{REACTION} {letter}", each.line, each.end)
    for display in displays:
        if (force := force_of_balance(display.latex)) is not None:
            yield Since(f"{REACTION} {force}", display.line, reach(display.line)[1])


def _before_table(text: str, place: int) -> float:
    """Return the line of the next table of an arm, which is another one's."""
    table = next_table(text, place)
    return inf if table is None else text.count("\n", 0, table) + 1


def _letters_above(displays: Sequence[Display], tables: Sequence[Cells], line: int) -> set[str]:
    """Return the letters, each with its index and its base, of the displays and tables above a line."""
    shown = (*((each.line, each.latex) for each in displays), *((each.line, each.text) for each in tables))
    above = (_PLAIN.sub("", latex) for place, latex in shown if place < line)
    return {name for latex in above for found in _LETTER.finditer(latex) for name in (found[0], found["base"])}
