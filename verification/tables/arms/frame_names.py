"""The names of the frames that a table with fixed rows steps through: those of its labels, else numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex
from armproof.verification.tables.columns import plain

_STEP = regex(r"(?:[a-z]+ )?(\w+)\s*(?:-+>?|–|→|\\(?:long)?(?:right)?arrow|\\to|/|,|to|à)\s*(\w+)", re.IGNORECASE)
_BASE = regex(r"b|base|bases?|world|w|socle|monde", re.IGNORECASE)
_TOOL = regex(
    r"e|ee|t|g|h|tcp|(?:end[- ]?)?effect\w*|outil|(?:organe )?terminal|tool.*|grip\w*|hand|flange|pince|end",
    re.IGNORECASE,
)


def is_tool(label: str) -> bool:
    """Whether the label of a row says that it leads to the tool."""
    spelt = _spelt(label)
    step = _STEP.fullmatch(spelt)
    return _TOOL.fullmatch(step[2] if step is not None else spelt) is not None


def end_effectors(labels: Sequence[str], joints: Sequence[str]) -> tuple[int, str] | None:
    """Return the place of the first of several end effectors, from 0, and its frame's name; None where the last rows are none.

    They stand one below the other, 4e1 and 4e2, 6→G and 6→T, tool 1 and tool 2; each follows the same frame, at the same joint.
    """
    ends = [_end(label) for label in labels]
    count = next((k for k in range(len(ends)) if not _are_beside(ends[-1 - k], ends[-1])), len(ends))
    first = len(ends) - count
    if count < 2 or not first or len(set(joints[first:])) > 1 or joints[first] in [*filter(None, joints[:first])]:
        return None
    name = ends[first][1]
    return first, name if re.fullmatch(r"[A-Za-z]\w{0,2}", name) else "E"


def _end(label: str) -> tuple[str, str]:
    """Return from which frame a row's label leads to which end effector; two empty texts where it leads to none."""
    spelt = re.sub(r"\(.*?\)", "", _spelt(label)).strip()
    if (step := _STEP.fullmatch(spelt)) is not None:
        return (step[1], step[2]) if not step[2].isdigit() else ("", "")
    found = re.fullmatch(r"(\d*)[\s_,-]?(.*?)[\s_-]?(\d*)", spelt)
    before, after = (found[1], found[2]) if found is not None else ("", "")
    return (before, after + found[3]) if found is not None and _TOOL.fullmatch(after) else ("", "")


def _are_beside(one: tuple[str, str], other: tuple[str, str]) -> bool:
    """Whether two rows lead to end effectors from the same frame: alike but for the number, or by what they say."""
    same = one[0] == other[0] and (one[0] != "" or re.sub(r"\d", "", one[1]) == re.sub(r"\d", "", other[1]))
    return bool(one[1] and other[1]) and same


def frame_names(labels: Sequence[str], is_fixed: Sequence[bool]) -> Iterator[tuple[str, ...]]:
    """Yield the names of all frames, the first row's reference before them; two where nothing tells them."""
    count = len(is_fixed)
    found = _labelled(labels, is_fixed)
    if found and len(set(found)) == count + 1:
        yield found
        return
    yield tuple(map(str, range(count + 1)))
    if is_fixed[0]:
        yield ("B", *map(str, range(count)))


def _labelled(labels: Sequence[str], is_fixed: Sequence[bool]) -> tuple[str, ...]:
    names: list[str] = []
    for label, fixed in zip(labels, is_fixed, strict=False):
        spelt = _spelt(label)
        step = _STEP.fullmatch(spelt)
        before, after = step.groups() if step is not None else ("", spelt)
        number = re.fullmatch(r"\D*(\d+)", after)
        if fixed and not names and _BASE.fullmatch(after):
            before, after = "B", "0"
        elif number is not None and not (fixed and re.fullmatch(r"\d+[a-z]+\d*", after)):
            after = number[1]
        elif not fixed or not after:
            return ()
        elif not re.fullmatch("[A-Za-z0-9]{1,3}", after):
            after = "E" if _TOOL.fullmatch(after) else ""
        if not names:
            names.append(_before(before, after, fixed))
        names.append(after)
    return tuple(names) if all(names) else ()


def _before(name: str, after: str, fixed: bool) -> str:
    """Return the name of the first frame of all."""
    if name:
        return "B" if _BASE.fullmatch(name) else name
    if after == "0":
        return "B" if fixed else ""
    return str(int(after) - 1) if after.isdigit() else ""


def _spelt(label: str) -> str:
    return re.sub(r"[{}$_^\s]+", " ", plain(label)).strip()
