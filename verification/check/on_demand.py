"""What explains and what corrects, loaded where there is something to explain, to correct."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from armproof.verification.display.statements import Statements

if TYPE_CHECKING:
    from armproof.verification.correction.corrector import Corrector
    from armproof.verification.diagnosis.diagnosis import Diagnostician


class OnDemand:
    """The diagnostician and the corrector of one document's displays; `samples`: whether samples may be taken."""

    def __init__(self, statements: Statements, samples: bool) -> None:
        self.statements = statements
        self.checker = statements.checker
        self.samples = samples

    @cached_property
    def diagnostician(self) -> Diagnostician:
        """Says what is wrong with a refuted display."""
        with self.checker.exact.budget.paused():
            from armproof.verification.diagnosis.diagnosis import Diagnostician

            if not self.samples:
                return Diagnostician(self.checker)
            from armproof.verification.diagnosis.by_samples import BySamples

            return Diagnostician(self.checker, BySamples(self.checker))

    @cached_property
    def corrector(self) -> Corrector:
        """Seeks what mends a refuted display."""
        with self.checker.exact.budget.paused():
            from armproof.verification.correction.corrector import Corrector

            return Corrector(self.checker, self.diagnostician, self.statements.tried)
