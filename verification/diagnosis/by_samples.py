"""What samples tell of a refuted equation, beside what is decided exactly; loaded where samples may be taken."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product

import numpy as np

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.diagnosis.causes.case import Explanation
from armproof.verification.diagnosis.causes.display import display_case
from armproof.verification.diagnosis.causes.find import find_other, find_slip
from armproof.verification.diagnosis.counterexample import SAMPLED, Probe, count_terms
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding
from armproof.verification.verdict import Discrepancy, Drawn, as_rows

_TOLERANCE = 1e-9  # of two poses that are the same at every probe


def discrepancy_of(checker: ChainChecker, probe: Probe, outcome: Outcome, sample: int) -> Discrepancy | None:
    """Return what an equation says at its counterexample, a sample of the probe; None where that is not known, or too long."""
    pair, samples = outcome.pair, probe.samples
    if pair is None or outcome.sampled_only or not outcome.wrong or _is_long(pair):
        return None
    try:
        with np.errstate(all="ignore"):  # what has no value there is found below
            true, printed = (samples.stacked(samples.from_exact(side)) for side in (pair.true, pair.printed))
    except EvaluationError:
        return None
    values = tuple((float(printed[sample, r, c]), float(true[sample, r, c])) for r, c in outcome.wrong)
    if not np.isfinite(values).all():
        return None
    drawn = _Drawing(checker, probe, sample).draw(outcome, true, printed[sample])
    return Discrepancy(outcome.equation, values, drawn)


def _is_long(pair: Pair) -> bool:
    """Whether evaluating both sides would take its time: nobody reads such a matrix."""
    return sum(map(count_terms, (*pair.true.cells, *pair.printed.cells))) > 2 * SAMPLED


class _Drawing:
    """Finds what of the arm an equation speaks of, and brings both its sides into frame 0."""

    def __init__(self, checker: ChainChecker, probe: Probe, sample: int) -> None:
        self.checker = checker
        self.arm = checker.names.arm
        self.sample = sample
        self.kinematics = probe.samples.kinematics

    def draw(self, outcome: Outcome, true: np.ndarray, printed: np.ndarray) -> Drawn | None:
        if self.arm is None or outcome.true is None or outcome.pair is None or not self.arm.joints:
            return None
        quantity = self.checker.quantity_of(outcome.true.node) or self._recognised(true)
        if quantity is None or not {quantity.frame, quantity.reference} <= set(self.arm.frames):
            return None
        if quantity.kind == "jacobian":
            return self._velocity(quantity, outcome, printed)
        if quantity.kind in ("axis", "difference"):
            return self._vector(quantity, true[self.sample], printed)
        return self._pose(quantity, outcome, printed)

    def _pose(self, quantity: Quantity, outcome: Outcome, printed: np.ndarray) -> Drawn | None:
        X_RF = self._at(quantity.frame, quantity.reference)
        claimed = X_RF.copy()
        if quantity.columns is not None:
            return None
        if printed.shape in ((4, 4), (3, 4)) and quantity.kind == "pose":
            claimed[: len(printed)] = printed
        elif printed.shape == (3, 3):
            claimed[:3, :3] = printed
        elif quantity.kind == "origin" and (rows := self._rows(quantity, printed)) is not None:
            claimed[rows, 3] = printed[: len(rows), 0]
        else:
            return None
        X_0R = self._at(quantity.reference)
        return Drawn("pose", quantity.frame, as_rows(X_0R @ X_RF), as_rows(X_0R @ claimed))

    def _vector(self, quantity: Quantity, true: np.ndarray, printed: np.ndarray) -> Drawn | None:
        rows = self._rows(quantity, printed)
        if rows is None or (len(rows) < 3 and quantity.kind == "difference"):
            return None
        whole = self._at(quantity.frame, quantity.reference)[:3, ["x", "y", "z"].index(quantity.along)]
        if quantity.kind == "difference":
            whole = true[:3, 0]
        claimed = whole.copy()
        claimed[rows] = printed[: len(rows), 0]
        R_0R = self._at(quantity.reference)[:3, :3]
        frame = quantity.start if quantity.kind == "difference" else quantity.frame
        return Drawn(quantity.kind, frame, as_rows((R_0R @ whole)[:, None]), as_rows((R_0R @ claimed)[:, None]))

    def _velocity(self, quantity: Quantity, outcome: Outcome, printed: np.ndarray) -> Drawn | None:
        """The velocity that the joint of the first wrong column gives, linear or angular as its first wrong row is."""
        assert self.arm is not None and self.kinematics is not None and outcome.pair is not None
        rows = [r - 1 for r in quantity.rows] if quantity.rows else list(outcome.pair.true_rows or range(6))
        columns = [c - 1 for c in quantity.columns] if quantity.columns else list(range(len(self.arm.joints)))
        if printed.shape != (len(rows), len(columns)):
            return None
        first, column = min(outcome.wrong, key=lambda place: (place[1], place[0]))
        part = range(3) if rows[first] < 3 else range(3, 6)
        base = self.arm.frames[0]
        whole = self.kinematics.jacobian(quantity.frame, quantity.reference, base)[self.sample][:, columns[column]]
        claimed = whole.copy()
        claimed[rows] = printed[:, column]
        R_0R = self._at(quantity.reference)[:3, :3]
        kind = "velocity" if rows[first] < 3 else "angular velocity"
        true, given = (as_rows((R_0R @ side[list(part)])[:, None]) for side in (whole, claimed))
        return Drawn(kind, quantity.frame, true, given, joint=columns[column] + 1)

    def _rows(self, quantity: Quantity, printed: np.ndarray) -> list[int] | None:
        """Return the coordinates (from 0) that the printed column or scalar stands for."""
        rows = [r - 1 for r in quantity.rows] if quantity.rows else [0, 1, 2]
        rows = [row for row in rows if row < 3]
        fits = printed.shape[1] == 1 and printed.shape[0] in (len(rows), len(rows) + 1)
        return rows if fits else None

    def _recognised(self, true: np.ndarray) -> Quantity | None:
        """Return the pose, rotation, origin or axis of the arm that a matrix is at every probe, whatever it is called."""
        for quantity, values in self._candidates(true.shape[1:]):
            if values.shape == true.shape and np.allclose(values, true, rtol=0, atol=_TOLERANCE):
                return quantity
        return None

    def _candidates(self, shape: tuple[int, ...]) -> Iterator[tuple[Quantity, np.ndarray]]:
        assert self.arm is not None and self.kinematics is not None
        for reference, frame in product(self.arm.frames, reversed(self.arm.frames)):
            if frame != reference and shape in ((4, 4), (3, 3), (3, 1), (1, 1)):
                yield from _parts_of(self.kinematics.pose(frame, reference), shape, frame, reference)

    def _at(self, frame: str, reference: str | None = None) -> np.ndarray:
        assert self.kinematics is not None
        return np.array(self.kinematics.pose(frame, reference)[self.sample])


class BySamples:
    """The cause of a whole matrix's failure, a counterexample, and the two sides in numbers there."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.probe = Probe(checker)

    def cause(self, outcome: Outcome, whole: Callable[[Outcome], Finding | None]) -> Explanation | None:
        """Return the mistake in a matrix of the arm, or what it is as a whole; None where it is no such matrix."""
        if (case := display_case(self.checker, outcome)) is None:
            return None
        try:
            with np.errstate(all="ignore"):
                other = find_other(case)
                if other.is_whole:
                    return other
                found = whole(outcome)
                return Explanation(found) if found is not None else find_slip(case, other)
        except ArmproofError:
            return Explanation()

    def counterexample(self, outcome: Outcome) -> tuple[dict[str, float], Discrepancy | None]:
        """Return a configuration at which an equation is wrong, and by how much."""
        sample = self.probe.worst_sample(outcome)
        discrepancy = discrepancy_of(self.checker, self.probe, outcome, sample)
        return self.probe.counterexample(outcome, sample), discrepancy


def _parts_of(
    pose: np.ndarray, shape: tuple[int, ...], frame: str, reference: str
) -> Iterator[tuple[Quantity, np.ndarray]]:
    """Yield the parts of a pose that have a shape: itself, its rotation, origin and axes, the coordinates that move."""
    if shape == (4, 4):
        yield Quantity("pose", frame, reference), pose
    elif shape == (3, 3):
        yield Quantity("rotation", frame, reference), pose[:, :3, :3]
    elif shape == (3, 1):
        yield Quantity("origin", frame, reference), pose[:, :3, 3:]
        for k, along in enumerate("xyz"):
            yield Quantity("axis", frame, reference, along=along), pose[:, :3, k : k + 1]
    else:
        for k in range(3):
            if np.ptp(pose[:, k, 3]) > _TOLERANCE:  # a constant may be anything
                yield Quantity("origin", frame, reference, rows=(k + 1,)), pose[:, k : k + 1, 3:]
