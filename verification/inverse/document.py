"""The inverse kinematics that a document states: read from its front matter and displays, and its record."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Document, read_document
from armproof.verification.errors import DocumentError, EvaluationError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.inverse.branch_graph import BranchGraph
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.formulas import read_formulas
from armproof.verification.inverse.kinematics import InverseKinematics
from armproof.verification.inverse.numeric_algebra import NumericAlgebra
from armproof.verification.inverse.planning import NoDerivation, plan
from armproof.verification.inverse.resolution import forward_values
from armproof.verification.inverse.symbolic_algebra import free_algebra
from armproof.verification.inverse.target import read_claim
from armproof.verification.naming.names import Names, read_names
from armproof.verification.verdict import Record, Verdict

LATEX = r"\mathrm{FK}(\mathrm{IK}(x)) = x"


def read_inverse(source: Path | str | Document) -> InverseKinematics:
    """Return the closed-form inverse of a document whose front matter has `inverse`.

    Raises:
        DocumentError: the document has none, or its displays do not solve for every joint.
    """
    document = source if isinstance(source, Document) else read_document(Path(source))
    if "inverse" not in document.front:
        raise DocumentError(say(Kind.NO_INVERSE), path=document.path)
    try:
        spec = document.front.get("arm")
        arm = load_arm(spec, document.path.parent) if spec is not None else None
        return InverseKinematics(read_derivation(document, read_names(arm, document.front)))
    except DocumentError as error:
        raise document.fault(error.key or "inverse", error) from None
    except ArmproofError as error:
        raise document.fault("arm", error) from None


def read_derivation(document: Document, names: Names) -> Derivation:
    """Return the steps of a document's solution; raises DocumentError where a joint is not solved for."""
    target, order = read_claim(document.front["inverse"], names)
    start = Derivation(names, target, read_formulas(document, names))
    _check_target(start)
    values = {**start.arm.lengths, **start.arm.angles}
    return plan(start, order, NumericAlgebra(start.arm, target, BranchGraph(), values))


def _check_target(derivation: Derivation) -> None:
    """Raise DocumentError for a name of the target without a meaning on the arm."""
    arm = derivation.arm
    try:
        forward_values(derivation, free_algebra(Ring(), arm))
    except EvaluationError as error:
        raise DocumentError(say(Kind.OF_INVERSE, problem=finding_of(error)), "inverse") from None


def check_inverse(document: Document, arm: Arm | None) -> Record:
    """Return the verdict of the solution that a document's front matter announces.

    Raises:
        DocumentError: the front matter's `inverse` cannot be read.
    """
    record = Record(document.lines.get("inverse", 1), LATEX, Verdict.UNCHECKED, section="Inverse kinematics")
    try:
        inverse = InverseKinematics(read_derivation(document, read_names(arm, document.front)))
    except NoDerivation as error:
        return replace(record, findings=(finding_of(error),))
    except DocumentError as error:
        raise document.fault(error.key or "inverse", error) from None
    try:
        proof = inverse.proof
    except EvaluationError as error:
        return replace(record, findings=(finding_of(error),))
    except Exception as error:  # a fault of ours must not cost the displays their verdicts
        fault = say(Kind.INTERNAL_ERROR, type=type(error).__name__, reason=str(error))
        return replace(record, verdict=Verdict.UNREADABLE, findings=(fault,))
    return replace(
        record,
        verdict=proof.verdict,
        findings=proof.findings,
        counterexample=proof.counterexample,
        samples=proof.samples,
        max_error=proof.max_error,
    )
