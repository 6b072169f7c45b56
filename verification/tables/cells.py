"""The cells of a DH table: which frames a row is about, and what its entries are worth."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from models.arm import Arm
from verification.algebras import Algebra
from verification.errors import EvaluationError, ReadError, UnboundName
from verification.evaluate import Evaluator
from verification.latex import nodes as n
from verification.names import Names
from verification.quantities import numbered_frames
from verification.tables.columns import plain
from verification.trig import Scalar

_BLANK = re.compile(r"(?:-|–|—|−|−−|--|---|/|\\times|×|\.|\\cdot|\\dots|\\ldots)?")
_VARIABLE = re.compile(r"\(?(?:var(?:iable)?\.?|\\?\*|\\ast|\\star)\)?", re.IGNORECASE)
_TOOL = re.compile(
    r"\b(?:grip\w*|tool\w*|tcp|end|effect\w*|hand|flange|pince|outil|organe|preneur|greifer|e|ee|g|p|t)\b",
    re.IGNORECASE,
)
_RANGE = re.compile(r"\D*(\d+)\s*(?:-|–|→|\\(?:right)?arrow|\\to|/|,|to|à)\s*(\d+)\D*")


@dataclass(frozen=True)
class Cell:
    """One entry: its LaTeX and the trees of the values that it states (two in `d_1 = 0.33`).

    `kind` is value, blank (nothing stands there) or variable (a word or star that says: the joint's variable).
    """

    text: str
    trees: tuple[n.Node, ...] = ()
    kind: str = "value"


@dataclass(frozen=True)
class Frames:
    """The frames of one row: {}^{reference}T_{frame}; `joint` is the joint between them, from 1, or None."""

    frame: str
    reference: str
    joint: int | None = None


class UnreadableCell(ReadError):
    """A cell that is not an expression."""


def read_cell(names: Names, text: str) -> Cell:
    """Return a cell with its trees; raises UnreadableCell."""
    if text.strip() == "0":
        return Cell("0", (n.Number(Fraction(0), "0"),))
    spelt = plain(text)
    if _BLANK.fullmatch(spelt):
        return Cell(text.strip(), kind="blank")
    if _VARIABLE.fullmatch(spelt):
        return Cell(text.strip(), kind="variable")
    spelt = re.sub(r"(?<=[\w}])\s*\^?\s*\{?\*+\}?(?=\s*(?:$|[-+=)]))", "", spelt)  # θ_1*: the star of a variable
    spelt = re.sub(r"(?<![\\A-Za-z])(pi|theta|alpha)(?![A-Za-z])", r"\\\1", spelt)
    spelt = re.sub(r"(?<![\\A-Za-z])(\\?(?:theta|alpha)|[A-Za-z])\s?(\d+)(?![\d.])", r"\1_{\2}", spelt)
    spelt = re.sub(r"(?<=\d)\s*deg(?:rees)?\b", r"^\\circ", spelt)
    try:
        trees = tuple(names.reader.read_expression(part) for part in spelt.split("="))
    except ReadError as error:
        raise UnreadableCell(f"'{text.strip()}' cannot be read: {error}") from None
    return Cell(text.strip(), trees)


def cell_values(names: Names, algebra: Algebra, cell: Cell) -> tuple[Scalar, ...]:
    """Return the values of a cell that has some; raises EvaluationError."""
    evaluator = Evaluator(names, algebra)
    return tuple(evaluator.scalar(tree) for tree in cell.trees)


def unbound_name(names: Names, algebra: Algebra, cell: Cell) -> str | None:
    """Return the name that a cell consists of, where it is one that nothing binds."""
    try:
        cell_values(names, algebra, cell)
    except UnboundName as problem:
        node = cell.trees[0]
        return node.key if len(cell.trees) == 1 and isinstance(node, n.Name) and node.key == problem.name else None
    except EvaluationError:
        return None
    return None


def row_frames(names: Names, arm: Arm, labels: list[str] | None, count: int) -> tuple[list[Frames | None], bool]:
    """Return the frames of each row, by its label or else in order, and whether the labels were passed over."""
    frames = numbered_frames(arm)
    extra = [frame for frame in arm.frames if frame not in frames]
    in_order: list[Frames | None] = [Frames(frame, frames[k], k + 1) for k, frame in enumerate(frames[1:])]
    in_order += [Frames(frame, (frames + extra)[len(frames) - 1 + k]) for k, frame in enumerate(extra)]
    in_order += [None] * max(0, count - len(in_order))
    if labels is None:
        return in_order[:count], False
    found = [_labelled(names, arm, frames, extra, label) for label in labels]
    if count == len(frames) and re.findall(r"\d+", labels[0]) == [frames[0]] and found[0] is None:
        found[0] = Frames(frames[0], frames[0])  # a row for the base
    known = [row.frame for row in found if row is not None]
    at_the_end = all(row is None for row in found[len(known) :])
    if not known or not at_the_end or len(set(known)) != len(known):
        return in_order[:count], any(labels)
    return found, False


def _labelled(names: Names, arm: Arm, frames: list[str], extra: list[str], label: str) -> Frames | None:
    spelt = plain(label)
    if "T" in spelt or "A" in spelt or "H" in spelt:
        try:
            node = names.reader.read_expression(spelt)
        except ReadError:
            node = None
        if isinstance(node, n.Name) and (quantity := names.quantity(node)) is not None and quantity.kind == "pose":
            return _between(arm, frames, extra, quantity.reference, quantity.frame)
    if (pair := _RANGE.fullmatch(spelt)) and pair.group(1) != pair.group(2):
        first, second = sorted(pair.groups(), key=int)
        return _between(arm, frames, extra, first, second)
    numbers = re.findall(r"\d+", spelt)
    if len(numbers) == 1:
        frame = str(int(numbers[0]))
        if frame in frames[1:]:
            return _between(arm, frames, extra, frames[frames.index(frame) - 1], frame)
        if extra and frame == str(int(frames[-1]) + 1 if frames[-1].isdigit() else len(frames)):
            return Frames(extra[0], frames[-1])
        return None
    bare = re.sub(r"[{}\\\s]", "", spelt)
    if bare in extra:
        return Frames(bare, (frames + extra)[len(frames) - 1 + extra.index(bare)])
    return Frames(extra[0], frames[-1]) if extra and _TOOL.search(spelt) else None


def _between(arm: Arm, frames: list[str], extra: list[str], reference: str, frame: str) -> Frames | None:
    if reference not in arm.frames or frame not in arm.frames:
        return None
    joint = (
        frames.index(frame)
        if frame in frames and frames.index(frame) > 0 and frames[frames.index(frame) - 1] == reference
        else None
    )
    return Frames(frame, reference, joint)
