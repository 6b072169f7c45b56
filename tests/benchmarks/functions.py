"""Functions checked: a 6R's forward kinematics and Jacobian in one function, right and wrong; the catalogue of mistakes."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.catalogue import arm_names, load_arm
from armproof.verification.functions import FunctionVerdict, check_function
from tests.verification.functions.right import by_products, last_frame
from tests.verification.functions.test_mistakes import changing, is_named

ROUNDS = 9
QUANTITIES = ({"pose": 6}, {"jacobian": 6})


@dataclass(frozen=True)
class Times:
    """Median seconds of one check of FK + J of the RX-90 after the first, by the name of the function."""

    right: float
    wrong: dict[str, float]


@dataclass(frozen=True)
class Counts:
    """The catalogue of classic mistakes on all arms."""

    mistakes: int
    refuted: int
    named: int
    seconds: float  # median of a check


def _wrong_functions() -> Iterator[tuple[str, Callable[[Any], Any]]]:
    fk, jacobian = by_products(load_arm("rx90"))
    signs = np.array([1.0, -1.0, 1.0, 1.0, 1.0, 1.0])

    def in_tool_frame(q):
        T, J = fk(q), jacobian(q)
        R = T[:3, :3].T
        return T, np.vstack((R @ J[:3], R @ J[3:]))

    yield "degrees", lambda q: (fk(np.deg2rad(q)), jacobian(np.deg2rad(q)))
    yield "sign of theta_2", lambda q: (fk(signs * q), jacobian(signs * q))
    yield "J transposed", lambda q: (fk(q), jacobian(q).T)
    yield "blocks swapped", lambda q: (fk(q), jacobian(q)[[3, 4, 5, 0, 1, 2]])
    yield "tool-frame J", in_tool_frame
    yield "T inverted", lambda q: (np.linalg.inv(fk(q)), jacobian(q))


def time_checks() -> Times:
    """Return the median time of a check, right and wrong."""
    fk, jacobian = by_products(load_arm("rx90"))
    right = _median(lambda q: (fk(q), jacobian(q)), FunctionVerdict.PROVED)
    return Times(right, {name: _median(wrong, FunctionVerdict.REFUTED) for name, wrong in _wrong_functions()})


def _median(function: Callable[[Any], Any], verdict: FunctionVerdict) -> float:
    seconds = []
    for _ in range(ROUNDS):
        started = time.perf_counter()
        found = check_function("rx90", function, QUANTITIES)
        seconds.append(time.perf_counter() - started)
        if found.verdict is not verdict:
            raise SystemExit(f"a function of the RX-90 is {found.verdict.value}: {found.message}")
    return statistics.median(seconds[1:])


def count_mistakes() -> Counts:
    """Check the whole catalogue."""
    mistakes = refuted = named = 0
    seconds = []
    for name in arm_names():
        arm = load_arm(name)
        for mistake in changing(arm):
            found = check_function(arm, mistake.function, {mistake.quantity: last_frame(arm)})
            seconds.append(found.seconds)
            mistakes += 1
            refuted += found.verdict is FunctionVerdict.REFUTED
            named += is_named(mistake, found.message)
    return Counts(mistakes, refuted, named, statistics.median(seconds))


def rows() -> list[tuple[str, str, str]]:
    """Return what the benchmark prints of functions: what, value, target."""
    times, counts = time_checks(), count_mistakes()
    wrong = [(f"wrong: {name}", f"{1000 * seconds:.1f} ms", "<= 50 ms") for name, seconds in times.wrong.items()]
    return [
        ("RX-90, FK + J, right: proved", f"{1000 * times.right:.1f} ms", "<= 50 ms"),
        *wrong,
        (f"catalogue: {counts.mistakes} mistakes refuted", f"{counts.refuted / counts.mistakes:.1%}", "100 %"),
        ("catalogue: named in words", f"{counts.named / counts.mistakes:.1%}", ">= 90 %"),
        ("catalogue: one check (median)", f"{1000 * counts.seconds:.1f} ms", ""),
    ]
