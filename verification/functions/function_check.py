"""What became of a function that was checked: a value, from which a lesson writes its feedback."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from typing import Any

from armproof.verification.findings import Finding
from armproof.verification.findings.finding import write_all
from armproof.verification.functions.guarded_call import CallError
from armproof.verification.verdict import WrongEntry


class FunctionVerdict(StrEnum):
    """What became of a function, from best to worst; where a display can have the verdict too, it has the same name."""

    PROVED = "proved"
    CONFIRMED = "confirmed"
    NOT_ATTEMPTED = "not attempted"
    REFUTED = "refuted"
    ERROR = "error"


@dataclass(frozen=True)
class TableRow:
    """One wrong entry at the most telling configuration; `quantity` counts from 1, a scalar has no row and column."""

    quantity: int
    row: int | None
    column: int | None
    expected: float
    obtained: float
    unit: str

    def as_json(self) -> dict[str, Any]:
        """Return the row as JSON writes it; NaN and infinity as texts."""
        obtained = self.obtained if abs(self.obtained) < float("inf") else str(self.obtained)
        place = {} if self.row is None else {"row": self.row, "column": self.column}
        return {
            "quantity": self.quantity, **place, "expected": self.expected, "obtained": obtained, "unit": self.unit
        }  # fmt: skip


@dataclass(frozen=True)
class FunctionCheck:
    """The verdict on a function, with all that can be said of what is wrong in it.

    Attributes:
        arm: the name of the arm.
        quantities: what the function was to compute, as it was asked for.
        verdict: the worst of its quantities'.
        findings: for which values it is proved, or the likely mistake.
        verdicts: one a quantity.
        entries: each wrong entry as a formula, printed and correct, where the function could be traced; `equation` is
            the number of the quantity.
        counterexample: the most telling configuration (rad, m), by joint variable.
        table: the wrong entries there, expected and obtained.
        samples: at how many configurations the function was called and agreed with Drake's plant of doubles.
        max_error: the largest difference there, scaled by 1 + size.
        error: what it raised, and in which line of the user's.
        printed: what it printed, the first 10,000 characters.
        notes: what is no mistake, but worth knowing: a changed argument, a result of another shape.
        exact: whether it was traced, so that the verdict rests on its formula.
        seconds: how long the check took.
    """

    arm: str
    quantities: tuple[str, ...]
    verdict: FunctionVerdict
    findings: tuple[Finding, ...] = ()
    verdicts: tuple[FunctionVerdict, ...] = ()
    entries: tuple[WrongEntry, ...] = ()
    counterexample: Mapping[str, float] = field(default_factory=dict)
    table: tuple[TableRow, ...] = ()
    samples: int = 0
    max_error: float | None = None
    error: CallError | None = None
    printed: str = ""
    notes: tuple[str, ...] = ()
    exact: bool = False
    seconds: float = 0.0

    @property
    def message(self) -> str:
        """The findings in words."""
        return write_all(self.findings)

    @property
    def is_right(self) -> bool:
        """Whether every quantity is proved or confirmed."""
        return self.verdict in (FunctionVerdict.PROVED, FunctionVerdict.CONFIRMED)

    def as_json(self) -> dict[str, Any]:
        """Return the check as JSON writes it."""
        return {
            "arm": self.arm,
            "quantities": list(self.quantities),
            "verdict": self.verdict.value,
            "message": self.message,
            "findings": [finding.as_json() for finding in self.findings],
            "verdicts": [verdict.value for verdict in self.verdicts],
            "entries": [entry.as_json() for entry in self.entries],
            "counterexample": dict(self.counterexample),
            "table": [row.as_json() for row in self.table],
            "samples": self.samples,
            "max_error": self.max_error,
            "error": None if self.error is None else asdict(self.error),
            "printed": self.printed,
            "notes": list(self.notes),
            "exact": self.exact,
            "seconds": self.seconds,
        }
