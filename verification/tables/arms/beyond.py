"""The point of a tool behind the last frame of a modified DH table, whose last link has no row: a_2 of a planar arm of two rows."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from armproof.verification.document import Document
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.tables.arms.witnesses import Reading, weigh

_LENGTH = re.compile(r"([A-Za-z]+)_(\d+)")


def with_point_beyond(document: Document, best: Reading) -> Reading:
    """Return a reading with the point in which the last link ends, where more of the document holds with it than fails.

    What fails by one slip counts half.
    """
    arm = best.front["arm"]
    letter = _next_length(arm, document) if best.convention == "modified" and "tool" not in arm else ""
    if not letter:
        return best
    with_tool = {**best.front, "arm": {**arm, "tool": {"xyz": [letter, 0, 0]}}}
    first, *others = weigh(document, [best.front, with_tool])
    is_better = all(_weight(first) > _weight(each) for each in others)
    return first if first.front is with_tool and is_better else best


def _weight(reading: Reading) -> int:
    return 2 * (reading.held - reading.failed) + reading.near


def _next_length(arm: Mapping[str, Any], document: Document) -> str:
    """Return the letter behind those of the column a, a_1 and a_2 before a_3, where displays have it and the table has not."""
    found = [_LENGTH.fullmatch(str(row.get("a", ""))) for row in arm["rows"]]
    letters = [(each[1], int(each[2])) for each in found if each is not None]
    if not letters or len({base for base, _ in letters}) > 1:
        return ""
    base, index = letters[-1]
    following = f"{base}_{index + 1}"
    cells = {str(cell) for row in arm["rows"] for cell in row.values()}
    written = re.compile(rf"(?<![A-Za-z\\]){base}\s*_\s*\{{?\s*{index + 1}(?!\d)")
    is_used = any(written.search(normalise_unicode(display.latex)) for display in document.displays)
    return following if is_used and following not in cells else ""
