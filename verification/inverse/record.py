"""The verdict of a document's closed-form inverse as a whole, beside those of its displays."""

from __future__ import annotations

from dataclasses import replace

from armproof.models.arm import Arm
from armproof.verification.document import Document
from armproof.verification.errors import DocumentError, EvaluationError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.inverse.document import read_derivation
from armproof.verification.inverse.kinematics import InverseKinematics
from armproof.verification.inverse.planning import NoDerivation
from armproof.verification.naming.names import read_names
from armproof.verification.verdict import Record, Verdict

LATEX = r"\mathrm{FK}(\mathrm{IK}(x)) = x"


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
