"""Where an arm's base stands and what tool it holds: transforms in which nothing moves, {}^BT_0 and {}^2T_G, printed beside its links."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import transform_pair
from armproof.verification.tables.angles import angle_as_scalar
from armproof.verification.tables.arms.candidate import entry_text
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters
from armproof.verification.tables.arms.rows import joint_of
from armproof.verification.tables.arms.witnesses import Reading, weigh
from armproof.verification.tables.row import PARAMETERS, right_row

Place = tuple[int | None, int]
_FRAME = re.compile(r"[A-Za-z][A-Za-z0-9]{0,2}")
SECONDS = 0.3


def with_ends(document: Document, names: Names, best: Reading) -> tuple[Reading, tuple[Place, ...]]:
    """Return a reading with the base and the tool that its document prints, and where, where more of the document holds with them."""
    arm = best.front["arm"]
    steps = _steps(document, names, best) if not {"base", "tool"} & arm.keys() else {}
    if not steps:
        return best, ()
    with_them = {**best.front, "arm": _extended(arm, steps)}
    places = tuple(place for *_, place in steps.values())
    try:
        readings = weigh(document, [best.front, with_them], places)
    except ArmproofError:
        return best, ()
    [plain], [whole] = ([each for each in readings if (each.front is with_them) is wanted] for wanted in (False, True))
    held, failed, near = whole.held - plain.held, whole.failed - plain.failed, whole.near - plain.near
    is_slip = (
        failed == 1 and held >= 0 and held + near >= 1
    )  # in one display, beside one that holds or in one entry alone
    return (whole, places) if held > failed or is_slip else (best, ())


def _extended(arm: Mapping[str, Any], steps: Mapping[str, tuple[str, dict[str, str], Place]]) -> dict[str, Any]:
    """Return an arm with the rows of its base and its tool, and all its frames by name."""
    rows, frames = list(arm["rows"]), list(_frames(arm))
    if "base" in steps:
        name, row, _ = steps["base"]
        rows, frames = [row, *rows], [name, *frames]
    if "tool" in steps:
        name, row, _ = steps["tool"]
        rows, frames = [*rows, row], [*frames, name]
    return {**{key: value for key, value in arm.items() if key != "first"}, "rows": rows, "frames": frames}


def _frames(arm: Mapping[str, Any]) -> tuple[str, ...]:
    first = int(arm.get("first", 0))
    return tuple(arm.get("frames") or map(str, range(first, first + len(arm["rows"]) + 1)))


def _steps(document: Document, names: Names, best: Reading) -> dict[str, tuple[str, dict[str, str], Place]]:
    """Return the steps to the arm's first frame ("base") and from its last ("tool"): the other frame, its row, and where it is printed."""
    frames, algebra = _frames(best.front["arm"]), ExactAlgebra(Ring(), None)
    try:
        arm = load_arm(best.front["arm"], document.path.parent)
    except ArmproofError:
        return {}
    found: dict[str, tuple[str, dict[str, str], Place]] = {}
    with algebra.budget.of(SECONDS):
        for name, printed, place in _printed(document, names):
            pair = transform_pair(name, arm, best.transforms)
            end = _end(pair, frames)
            row = _row(printed, names, algebra, best) if end else None
            if pair is not None and row is not None:
                found.setdefault(end, (pair[end == "tool"], row, place))
    return found


def _printed(document: Document, names: Names) -> Iterator[tuple[n.Name, n.Matrix, Place]]:
    """Yield the transforms of which a display prints the matrix, and nothing else."""
    for display in document.displays:
        for chain in equations_of(display, names) if "matri" in display.latex or "array" in display.latex else ():
            name, printed = unapplied(chain.members[0]), n.bare(chain.members[-1])
            are_two = len(chain.members) == 2 and isinstance(name, n.Name) and isinstance(printed, n.Matrix)
            if are_two and name.base in ("T", "A", "H") and not (name.primes or name.dots):
                yield name, printed, display.place


def _end(pair: tuple[str, str] | None, frames: tuple[str, ...]) -> str:
    """Return which end of an arm a transform adds, "base" or "tool"; "" where it leads neither to its first frame nor from its last."""
    if pair is None:
        return ""
    if pair[1] == frames[0] and pair[0] not in frames and _FRAME.fullmatch(pair[0]):
        return "base"
    return "tool" if pair[0] == frames[-1] and pair[1] not in frames and _FRAME.fullmatch(pair[1]) else ""


def _row(printed: n.Matrix, names: Names, algebra: ExactAlgebra, best: Reading) -> dict[str, str] | None:
    """Return the row of a matrix in which nothing moves, in the convention of the arm's table; None where it has none."""
    evaluated = value_in_letters(printed, names, algebra)
    value = evaluated[0] if evaluated is not None else None
    if not isinstance(value, Matrix) or value.shape != (4, 4):
        return None
    found = right_row(value, best.convention, ())
    if found is None:
        return None
    theta, alpha = (angle_as_scalar(value.cells[0].ring, angle, ()) for angle in (found.theta, found.alpha))
    try:
        if theta is None or alpha is None:
            return None
        values = dict(zip(PARAMETERS, (found.a, alpha, found.d, theta), strict=True))
        row = {column: entry_text(each) for column, each in values.items()}
        return row if joint_of(values, 0) == ("", "") else None
    except EvaluationError:
        return None
