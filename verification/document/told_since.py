"""What sentences say of the displays behind them, up to the end of their section: a task, a joint that is locked or turned round, a second robot."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import inf

from armproof.verification.document.hearing import MOST_CHARACTERS, formulas_of, with_axes, words_of
from armproof.verification.document.locked_joints import LOCKED, MAY_LOCK, locks
from armproof.verification.document.model import Display
from armproof.verification.document.told_branches import MAY_TELL_BRANCH, ToldBranch, told_branches
from armproof.verification.document.told_builds import (
    MAY_TELL_BUILD,
    OTHER_BUILD,
    is_of_other_machine,
    next_table,
    told_build,
    turned_round,
)
from armproof.verification.document.told_jacobians import (
    MAPS_OTHERWISE,
    MAY_TELL_JACOBIAN,
    maps_otherwise,
    told_jacobians,
)
from armproof.verification.document.told_notation import REACTION
from armproof.verification.document.told_quantities import MAY_TELL_QUANTITY, TOLD_QUANTITY, tells_quantity
from armproof.verification.document.told_relative import MAY_TELL_RELATIVE, relative_angles
from armproof.verification.document.told_statics import MAY_TELL_BALANCE, acts_on_tool, force_of_balance, holds_arm
from armproof.verification.document.told_tasks import MAY_TELL_TASK, told_tasks

MAY_SAY_SINCE = re.compile(  # what no text lacks that says so, in small letters
    f"{MAY_TELL_BUILD.pattern}|{MAY_LOCK.pattern}|{MAY_TELL_TASK.pattern}|{MAY_TELL_BRANCH.pattern}|{MAY_TELL_JACOBIAN.pattern}|{MAY_TELL_BALANCE.pattern}"
    f"|{MAY_TELL_QUANTITY.pattern}|{MAY_TELL_RELATIVE.pattern}"
)
_BESIDE = 12  # lines behind a sentence that may be said of what is near alone

Reach = Callable[[int], tuple[int, float]]


@dataclass(frozen=True)
class Since:
    """What is said of the displays from one line to another."""

    said: str
    begins: float
    ends: float


def told_since(
    text: str, displays: Sequence[Display], sentences: Sequence[tuple[int, str]], reach: Reach
) -> Iterator[Since]:
    """Yield what the sentences of a text say of displays behind them, each with its place."""
    branches: list[tuple[int, float, ToldBranch]] = []
    sizes: list[tuple[int, float, str]] = []
    acting: list[tuple[int, int, float, str]] = []
    holding = set[int]()  # sections
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
        joints, since = turned_round(words, formulas)
        if joints and any(each < line for each in lines):  # what is said before all is of the arm as it is
            ends = {"from here": inf, "now": end}.get(since, min(end, line + _BESIDE))
            yield from (Since(each, line, ends) for each in joints)
        if is_of_other_machine(words) and any(begin <= each < line for each in lines):
            table = next_table(text, place)
            yield Since(OTHER_BUILD, line, end if table is None else min(end, text.count("\n", 0, table) + 1))
        yield from (Since(each, begin, inf) for each in told_build(words, formulas))
        yield from (Since(each, line, end) for each in told_tasks(words, formulas))
        yield from (Since(each, begin, end) for each in relative_angles(words, formulas))
        for told in told_jacobians(words, formulas):
            if told == MAPS_OTHERWISE:
                yield Since(told, begin, end)
            else:
                sizes.append((line, end, told))
        behind = begins[at + 1] if at + 1 < len(begins) else inf
        if tells_quantity(words):
            yield Since(TOLD_QUANTITY, line, min(end, behind))
        acting += ((line, begin, end, letter) for letter in acts_on_tool(words, formulas))
        holding |= {begin} if holds_arm(words) else set()
        found = told_branches(words, formulas)
        branches += ((line, min(end, behind) if each.is_brief else end, each) for each in found)
        if locks(words, formulas):
            yield Since(LOCKED, line, end)
    yield from _of_branches(branches)
    for (line, end, told), (later, *_) in pairwise([*sizes, (inf,)]):
        yield Since(told, line, min(end, later))
    yield from _of_maps(displays, reach)
    yield from (Since(f"{REACTION} {letter}", line, end) for line, begin, end, letter in acting if begin in holding)
    for display in displays:
        if (letter := force_of_balance(display.latex)) is not None:
            yield Since(f"{REACTION} {letter}", display.line, reach(display.line)[1])


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


def _of_branches(told: Sequence[tuple[int, float, ToldBranch]]) -> Iterator[Since]:
    """Yield which branches are told, each up to where its letter is told anew; what words alone tell up to where any is."""
    for at, (line, end, branch) in enumerate(told):
        later = (begin for begin, _, each in told[at + 1 :] if begin > line and branch.letter in ("", each.letter))
        if branch.bound or not branch.letter:  # of both signs nothing holds
            yield Since(branch.as_meant(), line, min(end, next(later, inf)))
