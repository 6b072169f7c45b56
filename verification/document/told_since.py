"""What sentences say of the displays behind them, up to the end of their section: a task, a joint that is locked or turned round, a second robot."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import inf

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
from armproof.verification.document.locked_joints import LOCKED, MAY_LOCK, locks
from armproof.verification.document.model import Display
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
from armproof.verification.document.told_tasks import MAY_TELL_TASK, told_tasks

MAY_SAY_SINCE = re.compile(  # what no text lacks that says so, in small letters
    f"{MAY_TELL_BUILD.pattern}|{MAY_LOCK.pattern}|{MAY_TELL_TASK.pattern}|{MAY_CHANGE_ARM.pattern}|{MAY_LIMIT.pattern}|{MAY_BE_FIRST_ORDER.pattern}|{MAY_CONSTRAIN.pattern}"
)
_BESIDE = 12  # lines behind a sentence that may be said of what is near alone
_PLAIN = re.compile(r"[{}\s]|\\(?:left|right|quad|qquad|begin|end|operatorname|mathrm|text)(?![A-Za-z])")
_LETTER = re.compile(r"(?P<base>\\[A-Za-z]+|[A-Za-z])(?:_\w+)?")

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
    yield from (Since(LIMITED, text.count("\n", 0, place) + 1, inf) for place in columns_of_limits(text))
    bounding = (display.line for display in displays if bounds_joint(display.latex))
    yield from (Since(LIMITED, line, reach(line)[1]) for line in bounding)
    for place, sentence in sentences:
        if len(sentence) > MOST_CHARACTERS or not MAY_SAY_SINCE.search(sentence.lower()):
            continue
        plain = with_axes(" ".join(sentence.split()))
        words, formulas = words_of(plain), formulas_of(plain)
        line = text.count("\n", 0, place) + 1
        begin, end = reach(line)
        lines = [display.line for display in displays]
        joints, since = turned_round(words, formulas)
        if joints and any(each < line for each in lines):  # what is said before all is of the arm as it is
            ends = {"from here": inf, "now": end}.get(since, min(end, line + _BESIDE))
            yield from (Since(each, line, ends) for each in joints)
        if is_of_other_machine(words) and any(begin <= each < line for each in lines):
            yield Since(OTHER_BUILD, line, min(end, _before_table(text, place)))
        above = (
            set() if sentence.startswith("(") else _letters_above(displays, line)
        )  # what is told aside changes nothing
        if above and changes_arm(words, formulas, above):
            yield Since(OTHER_BUILD, line, min(end, _before_table(text, place)))
        yield from (Since(each, begin, inf) for each in told_build(words, formulas))
        yield from (Since(each, line, end) for each in told_tasks(words, formulas))
        if limits_joints(words, formulas):
            yield Since(LIMITED, line, end if any(map(bounds_joint, formulas)) else inf)
        if is_to_first_order(words):
            yield Since(FIRST_ORDER, line, end)
        if constrains_tool(words, formulas):
            yield Since(CONSTRAINED, line, end)
        if is_negative(words, formulas):
            yield Since(NEGATIVE, line, end)
        if locks(words, formulas):
            yield Since(LOCKED, line, end)


def _before_table(text: str, place: int) -> float:
    """Return the line of the next table of an arm, which is another one's."""
    table = next_table(text, place)
    return inf if table is None else text.count("\n", 0, table) + 1


def _letters_above(displays: Sequence[Display], line: int) -> set[str]:
    """Return the letters, each with its index and its base, of the displays above a line."""
    above = (_PLAIN.sub("", each.latex) for each in displays if each.line < line)
    return {name for latex in above for found in _LETTER.finditer(latex) for name in (found[0], found["base"])}
