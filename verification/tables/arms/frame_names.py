"""The names of the frames that a table with fixed rows steps through: those of its labels, else numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.tables.columns import plain

_STEP = re.compile(r"(?:[a-z]+ )?(\w+)\s*(?:-+>?|–|→|\\(?:long)?(?:right)?arrow|\\to|/|,|to|à)\s*(\w+)", re.IGNORECASE)
_BASE = re.compile(r"b|base|bases?|world|w|socle|monde", re.IGNORECASE)
_TOOL = re.compile(
    r"e|ee|t|g|h|tcp|(?:end[- ]?)?effect\w*|outil|(?:organe )?terminal|tool.*|grip\w*|hand|flange|pince|end",
    re.IGNORECASE,
)


def is_tool(label: str) -> bool:
    """Whether the label of a row says that it leads to the tool."""
    spelt = _spelt(label)
    step = _STEP.fullmatch(spelt)
    return _TOOL.fullmatch(step[2] if step is not None else spelt) is not None


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
