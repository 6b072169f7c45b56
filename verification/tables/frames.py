"""Which frames of the arm a row of a DH table is about: by its label, or else by its place in the table."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise

from armproof.models.arm import Arm
from armproof.models.exact.trace import trace_of
from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.patterns import regex
from armproof.verification.tables.columns import plain

_TOOL = regex(
    r"\b(?:grip\w*|tool\w*|tcp|end|effect\w*|hand|flange|pince|outil|organe|preneur|greifer|e|ee|g|p|t)\b",
    re.IGNORECASE,
)
_RANGE = regex(r"\D*(\d+)\s*(?:-|–|→|\\(?:right)?arrow|\\to|/|,|to|à)\s*(\d+)\D*")


@dataclass(frozen=True)
class Frames:
    """The frames of one row: {}^{reference}T_{frame}; `joint` is the joint between them, from 1, or None."""

    frame: str
    reference: str
    joint: int | None = None


def last_frames(arm: Arm) -> list[str]:
    """Return frame n and the frames beyond it, such as that of a gripper."""
    numbered = numbered_frames(arm)
    behind = arm.frames[arm.frames.index(numbered[0]) :]
    return [numbered[-1], *(frame for frame in behind if frame not in numbered)]


def row_frames(names: Names, arm: Arm, labels: list[str], count: int) -> tuple[list[Frames | None], bool]:
    """Return the frames of each row, and whether there are labels (else []) that were passed over."""
    numbered = numbered_frames(arm)
    before, depth = arm.frames[: arm.frames.index(numbered[0])], trace_of(arm).depth
    every = [
        Frames(frame, reference, depth(frame) if depth(frame) > depth(reference) else None)
        for reference, frame in pairwise([*before, *numbered, *last_frames(arm)[1:]])
    ]
    steps = every if count == len(every) else every[len(before) :]
    found = [_labelled(names, arm, every, label) for label in labels]
    if count == len(numbered) and found and not found[0] and re.findall(r"\d+", labels[0]) == numbered[:1]:
        found[0] = Frames(numbered[0], numbered[0])  # a row for the base
    known = [row.frame for row in found if row is not None]
    if known and len(set(known)) == len(known) and not any(found[len(known) :]):
        return found, False
    return [*steps, *[None] * count][:count], any(labels)


def _labelled(names: Names, arm: Arm, steps: list[Frames], label: str) -> Frames | None:
    spelt = plain(label)
    if re.search("[TAH]", spelt):
        try:
            node = names.reader.read_expression(spelt)
        except ReadError:
            node = None
        if isinstance(node, n.Name) and (quantity := names.quantity(node)) is not None and quantity.kind == "pose":
            return _between(arm, steps, quantity.reference, quantity.frame)
    if (pair := _RANGE.fullmatch(spelt)) and pair.group(1) != pair.group(2):
        return _between(arm, steps, *sorted(pair.groups(), key=int))
    by_name = {step.frame: step for step in steps}
    tool = steps[-1] if steps[-1].joint is None else None
    numbers = [int(number) for number in re.findall(r"\d+", spelt)]
    if len(numbers) == 1:
        is_next = tool is not None and tool.reference == str(numbers[0] - 1)
        return tool if is_next else by_name.get(str(numbers[0]))
    bare = re.sub(r"[{}\\\s]", "", spelt)
    return by_name.get(bare) or (tool if _TOOL.search(spelt) else None)


def _between(arm: Arm, steps: list[Frames], reference: str, frame: str) -> Frames | None:
    if not {reference, frame} <= set(arm.frames):
        return None
    return next((s for s in steps if (s.reference, s.frame) == (reference, frame)), Frames(frame, reference))
