"""What samples tell of a refuted equation, beside what is decided exactly; loaded where samples may be taken."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from armproof.models.errors import ArmproofError
from armproof.verification.diagnosis.causes.case import Explanation
from armproof.verification.diagnosis.causes.display import display_case
from armproof.verification.diagnosis.causes.find import find_other, find_slip
from armproof.verification.diagnosis.counterexample import Probe
from armproof.verification.diagnosis.discrepancy import discrepancy_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding
from armproof.verification.verdict import Discrepancy


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
