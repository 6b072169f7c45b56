"""The RX-90: its forward kinematics, Jacobian and determinant, traced and proved from the handout's own LaTeX."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

from armproof.models import catalogue
from armproof.models.exact.trace import trace_of
from armproof.verification.check import DocumentChecker
from armproof.verification.document import Display, Document, read_document
from armproof.verification.latex import nodes as n
from armproof.verification.latex import reader
from armproof.verification.verdict import Verdict

HANDOUT = Path(__file__).resolve().parents[2] / "course" / "handouts" / "rx90-001.md"
COMPONENTS = ("s_x", "s_y", "s_z", "n_x", "n_y", "n_z", "a_x", "a_y", "a_z", "P_x", "P_y", "P_z")


@dataclass(frozen=True)
class Claims:
    """The displays of the handout that state the pose's components, the Jacobian and its determinant."""

    document: Document
    unknowns: Display  # names the components
    pose: tuple[Display, ...]
    jacobian: Display
    determinant: Display


def read_claims() -> Claims:
    """Return the RX-90's claims as the handout states them."""
    document = read_document(HANDOUT)
    stated = [display for display in document.displays if not display.erratum]

    def find(start: str) -> Display:
        return next(display for display in stated if display.latex.strip().startswith(start))

    unknowns = next(display for display in stated if r"s_x & n_x & a_x & P_x" in display.latex)
    pose = tuple(find(f"{component} =") for component in COMPONENTS)
    return Claims(document, unknowns, pose, find(r"J = "), find(r"\det J"))


@dataclass(frozen=True)
class Times:
    """Seconds for each step; `samples` is the second route, 1,000 configurations on the double plant."""

    load: float
    read: float
    trace: float
    pose: float
    jacobian: float
    determinant: float
    samples: float

    @property
    def trace_and_prove(self) -> float:
        """The LaTeX of 12 + 36 entries read, the trace, and the proof."""
        return self.read + self.trace + self.pose + self.jacobian


def measure(claims: Claims) -> Times:
    """Load the arm afresh, read the claims, trace the arm and prove them."""
    catalogue._load_file.cache_clear()
    reader._known_readings.cache_clear()
    clock = _Clock()
    arm = catalogue.load_arm("rx90")
    load = clock.lap()
    checker = DocumentChecker(claims.document, arm, confirm=False)
    groups = ((claims.unknowns, *claims.pose), (claims.jacobian,), (claims.determinant,))
    statements = [[(display, checker.names.reader.read(display.latex)) for display in group] for group in groups]
    read = clock.lap()
    trace_of(arm).pose("6", "0")
    trace_of(arm).jacobian("6", "0", "0")
    trace = clock.lap()
    proofs = []
    for group in statements:
        _prove(checker, group)
        proofs.append(clock.lap())
    confirming = DocumentChecker(claims.document, arm, confirm=True)
    clock.lap()
    _prove(confirming, [*statements[0], *statements[1]])
    pose, jacobian, determinant = proofs
    return Times(load, read, trace, pose, jacobian, determinant, samples=max(0.0, clock.lap() - pose - jacobian))


def _prove(checker: DocumentChecker, claims: list[tuple[Display, list[n.Statement]]]) -> None:
    for display, statements in claims:
        outcomes, _ = checker.statements.check(statements, display.line)
        for outcome in outcomes:
            if outcome.verdict not in (Verdict.PROVED, Verdict.DEFINED):
                raise SystemExit(f"rx90-001.md:{display.line} is {outcome.verdict.value}: {outcome.message}")


def right_sides(claims: Claims) -> tuple[list[n.Node], n.Node, n.Node]:
    """Return the printed formulas: twelve components, the matrix J, its determinant."""
    checker = DocumentChecker(claims.document, catalogue.load_arm("rx90"), confirm=False)

    def side(display: Display) -> n.Node:
        statement = checker.names.reader.read(display.latex)[0]
        assert isinstance(statement, n.Chain)
        return statement.members[-1]

    return [side(display) for display in claims.pose], side(claims.jacobian), side(claims.determinant)


class _Clock:
    def __init__(self) -> None:
        self.last = time.perf_counter()

    def lap(self) -> float:
        """Return the seconds since the last lap."""
        before, self.last = self.last, time.perf_counter()
        return self.last - before
