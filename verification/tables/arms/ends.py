"""Where an arm's base stands and what tool it holds: transforms in which nothing moves, {}^BT_0 and {}^2T_G, printed beside its links."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import angles_in
from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Document
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import transform_pair
from armproof.verification.patterns import regex
from armproof.verification.tables.angles import TWELFTHS, angle_as_scalar, roll_pitch_yaw
from armproof.verification.tables.arms.candidate import Candidate, entry_text
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters
from armproof.verification.tables.arms.rows import joint_of
from armproof.verification.tables.arms.witnesses import Reading, weigh
from armproof.verification.tables.row import PARAMETERS, right_row

Place = tuple[int | None, int]
_FRAME = regex(r"[A-Za-z][A-Za-z0-9]{0,2}")
_TOLD_TOOL = "E"  # the frame of a tool that a sentence places
SECONDS = 0.3


@dataclass(frozen=True)
class _Step:
    """A fixed step: the frame that it adds, its entries as a row or a pose, and where it is printed."""

    frame: str
    entries: dict[str, Any]
    place: Place


def with_ends(
    document: Document, names: Names, best: Reading, found: Sequence[Candidate]
) -> tuple[Reading, list[Candidate]]:
    """Return a reading with the base and the tool that its document prints, and its candidate, where more of the document holds with them."""
    arm = best.front["arm"]
    steps = _steps(document, names, best) if not {"base", "tool"} & arm.keys() else {}
    if not steps:
        return best, [*found]
    with_them = {**best.front, "arm": _extended(arm, steps)}
    places = tuple(step.place for step in steps.values())
    try:
        readings = weigh(document, [best.front, with_them], places)
    except ArmproofError:
        return best, [*found]
    [plain], [whole] = ([each for each in readings if (each.front is with_them) is wanted] for wanted in (False, True))
    held, failed, near = whole.held - plain.held, whole.failed - plain.failed, whole.near - plain.near
    is_slip = (
        failed == 1 and held >= 0 and held + near >= 1
    )  # in one display, beside one that holds or in one entry alone
    if not (held > failed or is_slip):
        return best, [*found]
    own = next((each for each in found if each.front(best.convention)["arm"] == arm), found[0])
    mended = frozenset(link + ("base" in steps) for link in own.mended)
    return whole, [replace(own, more_lines=(*own.more_lines, *places), mended=mended)]


def _extended(arm: Mapping[str, Any], steps: Mapping[str, _Step]) -> dict[str, Any]:
    """Return an arm with its base and its tool, as rows of its table where they are such, and all its frames by name."""
    rows, frames = list(arm["rows"]), list(_frames(arm))
    poses: dict[str, Any] = {}
    for end, step in steps.items():
        at = 0 if end == "base" else len(frames)
        frames.insert(at, step.frame)
        if "xyz" in step.entries:
            poses[end] = step.entries
        else:
            rows.insert(0 if end == "base" else len(rows), step.entries)
    return {**{key: value for key, value in arm.items() if key != "first"}, "rows": rows, "frames": frames, **poses}


def _frames(arm: Mapping[str, Any]) -> tuple[str, ...]:
    first = int(arm.get("first", 0))
    return tuple(arm.get("frames") or map(str, range(first, first + len(arm["rows"]) + 1)))


def _steps(document: Document, names: Names, best: Reading) -> dict[str, _Step]:
    """Return the steps to the arm's first frame ("base") and from its last ("tool")."""
    frames, algebra = _frames(best.front["arm"]), ExactAlgebra(Ring(), None)
    try:
        arm = load_arm(best.front["arm"], document.path.parent)
    except ArmproofError:
        return {}
    found: dict[str, _Step] = {}
    with algebra.budget.of(SECONDS):
        for name, printed, place in _printed(document, names):
            pair = transform_pair(name, arm, best.transforms)
            end = _end(pair, frames)
            entries = _entries(printed, names, algebra, best) if end else None
            if pair is not None and entries is not None:
                found.setdefault(end, _Step(pair[end == "tool"], entries, place))
        if "tool" not in found and (told := _told(document, names, algebra, frames)) is not None:
            found["tool"] = told
    return found


def _told(document: Document, names: Names, algebra: ExactAlgebra, frames: tuple[str, ...]) -> _Step | None:
    """Return the step to the tool that a sentence puts in the last frame by its coordinates."""
    for line, said in document.ends:
        frame, *coordinates = said.split("\t")
        nodes = read_all(names, coordinates) if frame == frames[-1] else []
        evaluated = value_in_letters(n.Matrix(tuple((each,) for each in nodes)), names, algebra) if nodes else None
        value = evaluated[0] if evaluated is not None else None
        if isinstance(value, Matrix) and not any(map(angles_in, value.cells)):
            return _Step(
                _TOLD_TOOL, {"xyz": [entry_text(each) for each in value.cells], "rpy": ["0"] * 3}, (None, line)
            )
    return None


def read_all(names: Names, coordinates: Sequence[str]) -> list[n.Node]:
    """Return coordinates that a sentence gives as trees; none where one cannot be read."""
    try:
        return [names.reader.read_expression(each) for each in coordinates]
    except ReadError:
        return []


def tells_other_tool(document: Document, names: Names) -> bool:
    """Whether a sentence puts the tool in the last frame at a place of which the arm knows nothing: it is none of its frames."""
    arm = names.arm
    for _, said in document.ends if arm is not None else ():
        frame, *coordinates = said.split("\t")
        letters = (name.key for node in read_all(names, coordinates) for name in n.names(node))
        if arm is not None and frame == arm.frames[-1] and any(names.known_symbol(key) is None for key in letters):
            return True
    return False


def _printed(document: Document, names: Names) -> Iterator[tuple[n.Name, n.Matrix, Place]]:
    """Yield the transforms of which a display prints the matrix, and nothing else."""
    for display in document.displays:
        for chain in equations_of(display, names) if "matri" in display.latex or "array" in display.latex else ():
            name, printed = unapplied(chain.members[0]), n.bare(chain.members[-1])
            if len(chain.members) != 2 or not isinstance(name, n.Name) or not isinstance(printed, n.Matrix):
                continue
            if name.base in ("T", "A", "H") and not (name.primes or name.dots):
                yield name, printed, display.place


def _end(pair: tuple[str, str] | None, frames: tuple[str, ...]) -> str:
    """Return which end of an arm a transform adds, "base" or "tool"; "" where it leads neither to its first frame nor from its last."""
    if pair is None:
        return ""
    if pair[1] == frames[0] and pair[0] not in frames and _FRAME.fullmatch(pair[0]):
        return "base"
    return "tool" if pair[0] == frames[-1] and pair[1] not in frames and _FRAME.fullmatch(pair[1]) else ""


def _entries(printed: n.Matrix, names: Names, algebra: ExactAlgebra, best: Reading) -> dict[str, Any] | None:
    """Return a matrix in which nothing moves as a row of the arm's table, else as a pose; None where it is neither."""
    evaluated = value_in_letters(printed, names, algebra)
    value = evaluated[0] if evaluated is not None else None
    if not isinstance(value, Matrix) or value.shape != (4, 4) or any(map(angles_in, value.cells)):
        return None
    try:
        return _row(value, best.convention) or _pose(value)
    except EvaluationError:
        return None


def _row(value: Matrix, convention: str) -> dict[str, Any] | None:
    found = right_row(value, convention, ())
    if found is None:
        return None
    theta, alpha = (angle_as_scalar(found.a.ring, angle, ()) for angle in (found.theta, found.alpha))
    if theta is None or alpha is None:
        return None
    values = dict(zip(PARAMETERS, (found.a, alpha, found.d, theta), strict=True))
    return {column: entry_text(each) for column, each in values.items()} if joint_of(values, 0) == ("", "") else None


def _pose(value: Matrix) -> dict[str, Any] | None:
    """Return a pose as front matter has it, its turns quarter turns: Trans(x, y, z) Rot(z, yaw) Rot(y, pitch) Rot(x, roll)."""
    rotation = value.block(range(3), range(3))
    turns = [angle for angle in TWELFTHS if angle.denominator <= 2]
    found = next((each for each in product(turns, repeat=3) if is_zero(_rotation(value, each) + -rotation)), None)
    if found is None:
        return None
    pi = value.cells[0].ring.generator(("pi", ""))
    return {"xyz": [entry_text(row[3]) for row in value.rows[:3]], "rpy": [entry_text(pi * each) for each in found]}


def _rotation(value: Matrix, angles: Sequence[Fraction]) -> Matrix:
    """Return the rotation by roll, pitch and yaw in parts of π."""
    ring = value.cells[0].ring
    return roll_pitch_yaw(*(cos_sin(ring.generator(("pi", "")) * ring.rational(each)) for each in angles))
