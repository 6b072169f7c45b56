"""What a refuted equation says at its counterexample, beside what is so: in numbers, and on the arm where it can be drawn."""

from __future__ import annotations

from dataclasses import dataclass

Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Drawn:
    """A true and a printed pose or vector of the arm, in frame 0.

    Attributes:
        kind: "pose" (4×4: both sides), or "axis", "difference", "velocity" and "angular velocity" (3×1: at the frame).
        frame: the frame whose pose it is, or from whose origin the vector is drawn.
    """

    kind: str
    frame: str
    true: Rows
    printed: Rows


@dataclass(frozen=True)
class Discrepancy:
    """The printed and the true value of each wrong entry of one equation at the counterexample, (printed, true)."""

    equation: int
    values: tuple[tuple[float, float], ...] = ()
    drawn: Drawn | None = None
