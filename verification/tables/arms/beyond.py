"""The point of a tool behind the last frame of a modified DH table, whose last link has no row: a_2 of a planar arm of two rows, R_4 of an elbow of three."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from armproof.verification.document import Document
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.witnesses import Reading, weigh

_LENGTHS = ("a", "d", "l", "r", "D", "L", "R")
_PLAIN = ("l", "L", "h", "e")  # of the tool's point, where its author numbers it as no link
_LENGTH = regex(r"([A-Za-z]+)_(\d+)")


def with_point_beyond(document: Document, best: Reading) -> Reading:
    """Return a reading with the point in which the last link ends, where more of the document holds with it than fails.

    What fails by one slip counts half.
    """
    arm = best.front["arm"]
    letters = [*_next_lengths(arm, document)] if best.convention == "modified" and "tool" not in arm else []
    points = [point for letter in letters for point in ([letter, 0, 0], [0, 0, letter])]
    if not points:
        return best
    with_tool = [{**best.front, "arm": {**arm, "tool": {"xyz": point}}} for point in points]
    first, *others = weigh(document, [best.front, *with_tool])
    is_better = all(_weight(first) > _weight(each) for each in others)
    return first if first.front is not best.front and is_better else best


def _weight(reading: Reading) -> int:
    return 2 * (reading.held - reading.failed) + reading.near


def _next_lengths(arm: Mapping[str, Any], document: Document) -> Iterator[str]:
    """Yield the letters that displays have and the table has not: the one behind those of the column a, a_1 and a_2 before a_3, those numbered as the frame behind the last, and l."""
    rows = arm["rows"]
    found = [_LENGTH.fullmatch(str(row.get("a", ""))) for row in rows]
    letters = [(each[1], int(each[2])) for each in found if each is not None]
    bases = {base for base, _ in letters}
    following = [f"{letters[-1][0]}_{letters[-1][1] + 1}"] if len(bases) == 1 else []
    last = int(arm.get("first", 0)) + len(rows)
    behind = [f"{base}_{last + 1}" for base in _LENGTHS] if "frames" not in arm else []
    cells = {str(cell) for row in rows for cell in row.values()}
    for letter in dict.fromkeys((*following, *behind, *_PLAIN)):
        base, _, index = letter.partition("_")
        script = rf"\s*_\s*\{{?\s*{index}(?!\d)" if index else r"(?![A-Za-z]|\s*[_(])"
        written = re.compile(rf"(?<![A-Za-z\\]){base}{script}")
        if letter not in cells and any(written.search(normalise_unicode(each.latex)) for each in document.displays):
            yield letter
