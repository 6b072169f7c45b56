r"""Marks beside displays that say that they are wrong, or one answer of several: 👎, ❌, `- [ ]` beside a `- [x]`, `\choice`, A) and B) with one left side."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from armproof.verification.document.model import CODE, INLINE, Display
from armproof.verification.patterns import regex

MAY_MARK = regex(  # what no text that has such marks lacks
    r"[❌✗✘✖👎🚫⛔☒🙅☐]|:(?:x|-1|thumbsdown|no_entry\w*|negative_squared_cross_mark|heavy_multiplication_x):|\\xmark|\\ding\{5[3-6]\}|\[[ xX]\][ \t]|\\(?:wrong|incorrect)?choice\b|(?:^|(?<=[\s(*]))[A-Da-d1][.)](?=[\s*]|\\\[|\$)",
    re.MULTILINE,
)
WRONG = regex(
    r"[❌✗✘✖👎🚫⛔☒🙅]|:(?:x|-1|thumbsdown|no_entry\w*|negative_squared_cross_mark|heavy_multiplication_x):|\\xmark|\\ding\{5[3-6]\}|\\(?:wrong|incorrect)choice\b"
)
_WRONG_ALONE = regex(rf"[\W_]*(?:(?:{WRONG.pattern})[\W_]*)+")  # with no word beside
_BOX = regex(r"(?:^|\s)(?:[-*+]|\d+[.)])\s+\[(?P<box>[ xX])\]\s|(?P<sign>[☐☑])")
_CHOICE = regex(r"\\choice\b")
_LABEL = regex(r"\W*(?:\\item\s*)?(?:\[?\s*)?\(?(?P<label>[A-Fa-f])\s*[.):]\W*")
_NUMBER = regex(r"\W*(?P<label>[1-9])\s*[.):]\W*")
_ASKS = regex(  # above items that bear numbers: steps do, too
    r"\b(?:(?:only |exactly )?one|which|what) of (?:these|the)|(?:une seule|laquelle|lesquelles) (?:de ces|des)|(?:nur )?(?:eine|welche) (?:dieser|der|von)|(?:sólo |solo )?(?:una|cuál) de (?:estas|las)|(?:solo )?(?:una|quale) di queste|(?:só )?(?:uma|qual) destas",
    re.IGNORECASE,
)
_NEAR = 2  # lines above a display of which all but the one with its mark are empty
_LONGEST = 40  # characters of a mark with its label
_PLAIN = regex(r"\s|\\(?:left|right|,|;|!|quad)(?![A-Za-z])")


@dataclass(frozen=True)
class _Beside:
    """What stands on the line of a display before it, else alone above it, and behind it on its last line."""

    before: str
    behind: str


def marked_wrong(displays: Sequence[Display], texts: Mapping[int | None, str]) -> Iterator[Display]:
    """Yield the displays of a document that a mark calls wrong, or that are one answer of several; its texts by their cell."""
    lines = {cell: text.split("\n") for cell, text in texts.items()}
    own = [
        each
        for each in displays
        if each.opening not in (INLINE, CODE) and not each.file and not each.erratum and each.cell in lines
    ]
    beside = {each.place: _beside(each, lines[each.cell]) for each in own}
    boxes = {each.place: found for each in own if (found := _BOX.search(beside[each.place].before)) is not None}
    for each in own:
        marks = beside[each.place]
        is_wrong = WRONG.search(marks.before) is not None or _WRONG_ALONE.fullmatch(marks.behind) is not None
        is_other = _CHOICE.search(marks.before) is not None
        if is_wrong or is_other or _is_empty(boxes.get(each.place)):
            yield each
    asks = any(_ASKS.search(text) for text in texts.values())
    for label in (_LABEL, _NUMBER) if asks else (_LABEL,):
        yield from _alternatives(own, beside, label)


def _is_empty(box: re.Match[str] | None) -> bool:
    return box is not None and (box["box"] == " " or box["sign"] == "☐")


def _beside(display: Display, lines: Sequence[str]) -> _Beside:
    at = display.line - 1
    first = lines[at] if at < len(lines) else ""
    before = re.split(r"\$\$?|\\\[|\\begin\{", first)[0]
    above = next((each for each in reversed(lines[max(0, at - _NEAR) : at]) if each.strip()), "")
    if not re.search(r"\w|[^\w\s>*_#-]", before) and len(above) <= _LONGEST:
        is_mark = (
            _WRONG_ALONE.fullmatch(above)
            or _BOX.fullmatch(f"{above.rstrip()} ")
            or _LABEL.fullmatch(above)
            or _NUMBER.fullmatch(above)
        )
        before = f"{above} " if is_mark or _CHOICE.fullmatch(above.strip()) else before
    last = lines[min(at + display.latex.count("\n"), len(lines) - 1)] if lines else ""
    behind = re.split(r"\$\$|\\\]|\\end\{\w+\*?\}", last)
    return _Beside(before, behind[-1] if len(behind) > 1 else "")


def _alternatives(
    own: Sequence[Display], beside: Mapping[tuple[int | None, int], _Beside], mark: re.Pattern[str]
) -> Iterator[Display]:
    """Yield the displays that bear letters one after another, in which the same is something else in each: of these one at most holds."""
    for _, run in groupby(own, key=lambda each: (each.cell, each.section)):
        group: list[tuple[str, Display]] = []
        for each in (*run, None):
            found = mark.match(beside[each.place].before) if each is not None else None
            label = found["label"] if found is not None else ""
            if group and not (label and ord(label) - ord(group[-1][0]) == 1):
                yield from _if_apart([one for _, one in group])
                group = []
            if each is not None and label:
                group.append((label, each))


def _if_apart(group: Sequence[Display]) -> Sequence[Display]:
    sides = [_PLAIN.sub("", each.latex).partition("=") for each in group]
    lefts, rights = {left for left, _, _ in sides}, [right for _, _, right in sides]
    is_apart = len(group) > 1 and len(lefts) == 1 and len({*rights}) == len(rights) and all(rights)
    return group if is_apart else ()
