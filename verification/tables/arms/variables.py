"""θ_i = ±q_i + offset: where a document tells the joint variable q_i from the angle of its table, the arm's joints are the q_i."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Display, Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.angles import symbols_of
from armproof.verification.tables.arms.candidate import Candidate, entry_text
from armproof.verification.tables.arms.letters import equations_of, value_in_letters

_ANGLE = regex(r"theta_(\d+)")
SECONDS = 0.3


@dataclass(frozen=True)
class Told:
    """What a document says of an angle: its variable, the angle by that, and the display that says so, if one does."""

    variable: str
    angle: str
    place: tuple[int | None, int] | None = field(compare=False)


def in_variables(found: Candidate, told: Mapping[str, Told]) -> Candidate:
    """Return an arm with its angles written by the variables that a document tells apart from some of them.

    One whose table has variables with offsets already stays as it is.
    """
    if any(joint in told and row["theta"] != joint for row, joint in zip(found.rows, found.joints, strict=True)):
        return found
    angles = [_ANGLE.fullmatch(joint) for joint in found.joints]
    plain = {each[0]: Told(f"q_{each[1]}", f"q_{each[1]}", None) for each in angles if each is not None}
    told = {**plain, **told}
    rows = [
        {**row, "theta": re.sub(rf"\b{joint}\b", told[joint].angle, row["theta"])} if joint in told else row
        for row, joint in zip(found.rows, found.joints, strict=True)
    ]
    joints = tuple(told[joint].variable if joint in told else joint for joint in found.joints)
    places = [told[joint].place for joint in found.joints if joint in told]
    lines = (*found.more_lines, *(place for place in places if place is not None))
    return replace(found, rows=tuple(rows), joints=joints, more_lines=lines)


def told_variables(document: Document, names: Names) -> dict[str, Told]:
    """Return what is said of each θ_i in one way, in displays or in the text between."""
    algebra = ExactAlgebra(Ring(), None)
    found: dict[str, set[Told]] = {}
    with algebra.budget.of(SECONDS):
        for display in document.displays:
            for text in (display.latex, *display.said):
                for angle, told in _of_text(replace(display, latex=text), names, algebra) if "theta" in text else ():
                    place = (display.cell, display.line) if text is display.latex else None
                    found.setdefault(angle, set()).add(Told(*told, place))
    once = {angle: each.pop() for angle, each in found.items() if len(each) == 1}
    return once if any(each.angle != each.variable for each in once.values()) else {}


def _of_text(display: Display, names: Names, algebra: ExactAlgebra) -> Iterator[tuple[str, tuple[str, str]]]:
    for chain in equations_of(display, names):
        left = bare_key(chain.members[0]) or ""
        number = re.fullmatch(r"(?:theta|q)_(\d+)", left)
        evaluated = (
            value_in_letters(bare(chain.members[1]), names, algebra) if number and len(chain.members) == 2 else None
        )
        if number is None or evaluated is None or not isinstance(evaluated[0], Scalar):
            continue
        angle, variable = f"theta_{number[1]}", f"q_{number[1]}"
        other = variable if left == angle else angle
        for sign in (1, -1):
            offset = evaluated[0] - algebra.symbol(other) * sign
            if symbols_of(offset.normal()) or symbols_of(evaluated[0].normal()) != {other}:
                continue
            value = evaluated[0] if left == angle else (algebra.symbol(variable) - offset) * sign
            try:
                yield angle, (variable, entry_text(value))
            except EvaluationError:
                continue
