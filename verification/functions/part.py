"""One quantity of a check: what it is, and what the function returned for it at the probes."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.functions.asked import Asked
from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.returned import fit, shape_words

TOLERANCE = 1e-6  # of the entries, scaled by 1 + size


@dataclass
class Part:
    """A quantity with its true and its obtained values, (N, rows, columns), at the probes.

    `mismatch` says what is wrong with the shape; `obtained` then has the shape that was returned. `elsewhere` holds the
    values at more configurations, where the probes alone did not decide.
    """

    number: int
    asked: Asked
    true: np.ndarray
    obtained: np.ndarray
    note: str = ""
    mismatch: Finding | None = None
    verdict: FunctionVerdict = FunctionVerdict.REFUTED
    findings: tuple[Finding, ...] = ()
    wrong: list[tuple[int, int]] = field(default_factory=list)
    elsewhere: Part | None = None
    q: np.ndarray | None = None

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the quantity."""
        return self.true.shape[1], self.true.shape[2]

    @property
    def is_scalar(self) -> bool:
        """Whether the quantity is one number."""
        return self.asked.quantity.scalar


def read_part(number: int, asked: Asked, true: np.ndarray, returned: np.ndarray) -> Part:
    """Return the part of what was returned at N configurations, (N, …), each brought into the quantity's shape."""
    shape = true.shape[1:]
    fitted = [fit(values, shape) for values in returned]
    if any(one is None for one in fitted):
        wanted = "a number" if shape == (1, 1) else "×".join(map(str, shape))
        mismatch = say(Kind.RESULT_SIZE, printed=shape_words(returned[0]), correct=wanted)
        return Part(number, asked, true, returned, mismatch=mismatch)
    first = fitted[0]
    assert first is not None
    part = Part(number, asked, true, np.array([one.values for one in fitted if one is not None]), first.note)
    part.wrong = wrong_entries(part.obtained, true)
    return part


def scaled_errors(obtained: np.ndarray, true: np.ndarray) -> np.ndarray:
    """Return |obtained − true|/(1 + |true|), infinite where the function has no value."""
    with np.errstate(all="ignore"):
        errors = np.abs(obtained - true) / (1 + np.abs(true))
    return np.where(np.isfinite(errors), errors, np.inf)


def wrong_entries(obtained: np.ndarray, true: np.ndarray) -> list[tuple[int, int]]:
    """Return the places (from 0) of the entries that differ at any of N configurations."""
    places = np.argwhere((scaled_errors(obtained, true) > TOLERANCE).any(axis=0))
    return [(int(r), int(c)) for r, c in places]
