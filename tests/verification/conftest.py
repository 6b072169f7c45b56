"""Small documents for the tests of verification/: displays under a front matter, checked without a file."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import settings

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.numeric.configurations import sample
from armproof.verification.algebra.ring import Ring
from armproof.verification.check import check_document
from armproof.verification.document import Display, Document
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import DocumentResult, Record
from tests.laws import examples

settings.register_profile("laws", examples(50))
settings.load_profile("laws")


def check_displays(
    *displays: str, arm: Any = "scara", errata: tuple[str, ...] = (), confirm: bool = True, **front: Any
) -> DocumentResult:
    """Return the verdicts of a document whose k-th display stands in line k, the errata last."""
    matter = front if arm is None else {"arm": arm, **front}
    found = [Display(line, latex, line > len(displays)) for line, latex in enumerate((*displays, *errata), 1)]
    return check_document(Document(Path("page.md"), matter, tuple(found), ()), confirm=confirm)


@pytest.fixture(scope="session")
def check() -> Callable[..., DocumentResult]:
    """Return a function: displays and the keys of a front matter → the verdicts of that document."""
    return check_displays


@pytest.fixture(scope="session")
def judge() -> Callable[..., Record]:
    """Return a function: displays and the keys of a front matter → the record of the last display."""

    def last(*displays: str, **front: Any) -> Record:
        return check_displays(*displays, **front).equations[-1]

    return last


class Workbench:
    """An arm's names in both algebras: the exact one, and samples of the double plant."""

    def __init__(self, arm: Arm | None, count: int = 60, **front: Any) -> None:
        self.arm = arm
        self.names: Names = read_names(arm, front)
        self.exact = ExactAlgebra(Ring(), arm)
        q = sample(arm, count, np.random.default_rng(11))[0] if arm is not None else np.zeros((count, 0))
        self.sampled = SampledAlgebra(self.exact, q, 5)

    def value(self, latex: str, *, branch: int = 1) -> Any:
        """Return the exact value of an expression."""
        return Evaluator(self.names, self.exact, branch).evaluate(self.names.reader.read_expression(latex))

    def samples(self, latex: str, *, branch: int = 1) -> np.ndarray:
        """Return the sampled values of an expression, (rows, columns, N) where it is a matrix, else (N,)."""
        return self.stack(
            Evaluator(self.names, self.sampled, branch).evaluate(self.names.reader.read_expression(latex))
        )

    def stack(self, value: Any) -> np.ndarray:
        """Return a sampled value as one array."""
        if not hasattr(value, "rows"):
            return np.broadcast_to(value, (self.sampled.samples,))
        return np.array([[np.broadcast_to(cell, (self.sampled.samples,)) for cell in row] for row in value.rows])


@pytest.fixture(scope="session")
def workbench() -> Callable[..., Workbench]:
    """Return a function: an arm's name (or None) and the keys of a front matter → its names and algebras."""

    def lay_out(arm: Any = "scara", **options: Any) -> Workbench:
        return Workbench(None if arm is None else load_arm(arm), **options)

    return lay_out


@pytest.fixture(scope="session", params=arm_names())
def arm(request: pytest.FixtureRequest) -> Arm:
    """Every arm of the catalogue."""
    return load_arm(request.param)
