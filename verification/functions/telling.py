"""The configuration that shows best what is wrong, and the table of the wrong entries there."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.probes import probes, simple
from armproof.verification.functions.asked import TOLERANCE, Part, read_part, scaled_errors, wrong_entries
from armproof.verification.functions.caller import FunctionCaller, Stopped
from armproof.verification.functions.function_check import TableRow

SECONDS_TO_TRY = 0.02
VISIBLE = 1e-3  # a difference that one sees in three decimals


@dataclass(frozen=True)
class Telling:
    """A configuration (rad, m) by joint symbol, and the wrong entries there."""

    configuration: dict[str, float]
    table: tuple[TableRow, ...]


Shown = list[tuple[Part, np.ndarray, np.ndarray]]  # parts with what was obtained, and what is true, at a configuration


def most_telling(caller: FunctionCaller, parts: list[Part]) -> Telling:
    """Return the simplest configuration at which all that is wrong can be seen.

    Tried are the zero pose and one joint at a quarter turn, by which one can reckon in one's head; then the probes; then,
    where those are right, the configuration at which the first error was met.
    """
    arm, wrong = caller.arm, [part for part in parts if part.wrong and not part.mismatch]
    wanted = {(part.number, place) for part in wrong for place in part.wrong}
    started = time.monotonic()
    for index, q in enumerate(simple(arm).q):
        if not wrong or time.monotonic() - started > SECONDS_TO_TRY:
            break
        try:
            table, seen = _table(arm, _called(arm, caller.at(q), wrong, index))
        except Stopped:
            continue
        if seen >= wanted:
            return Telling(_named(arm, q), table)
    q, shown = _worst(arm, wrong)
    return Telling(_named(arm, q), _table(arm, shown)[0])


def _called(arm: Arm, results: list[np.ndarray], wrong: list[Part], index: int) -> Shown:
    shown = []
    for part in wrong:
        true = simple(arm).true(part.asked.quantity)[index]
        again = read_part(part.number, part.asked, true[None], results[part.number - 1][None])
        if not again.mismatch:
            shown.append((part, again.obtained[0], true))
    return shown


def _worst(arm: Arm, wrong: list[Part]) -> tuple[np.ndarray, Shown]:
    """Return the probe with the largest error; else the configuration with the largest anywhere."""
    errors = [scaled_errors(part.obtained, part.true).max(axis=(1, 2)) for part in wrong]
    if errors and np.max(errors) > TOLERANCE:
        total = np.max(errors, axis=0)
        index = int(np.argmax(np.where(np.isfinite(total), total, 0.0)))
        return np.asarray(probes(arm).q[index]), [(part, part.obtained[index], part.true[index]) for part in wrong]
    for part in wrong:
        if (other := part.elsewhere) is not None and other.q is not None:
            index = int(np.argmax(scaled_errors(other.obtained, other.true).max(axis=(1, 2))))
            return np.asarray(other.q[index]), [(part, other.obtained[index], other.true[index])]
    return np.asarray(probes(arm).q[0]), []


def _table(arm: Arm, shown: Shown) -> tuple[tuple[TableRow, ...], set[tuple[int, tuple[int, int]]]]:
    """Return the rows of all wrong entries, and which of them one can see."""
    rows, seen = [], set()
    for part, obtained, true in shown:
        for place in wrong_entries(obtained[None], true[None]):
            unit = kind_of(part.asked.quantity).unit(part.asked.quantity, arm, *place)
            rows.append(TableRow(part.number, *part.place(*place), float(true[place]), float(obtained[place]), unit))
            if not abs(true[place] - obtained[place]) <= VISIBLE:
                seen.add((part.number, place))
    return tuple(rows), seen


def _named(arm: Arm, q: np.ndarray) -> dict[str, float]:
    return {joint.symbol: float(value) for joint, value in zip(arm.joints, q, strict=True)}
