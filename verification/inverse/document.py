"""The inverse kinematics that a document states: the order in which its displays solve for the joints, and its record."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from pathlib import Path
from typing import Any

from armproof.models.catalogue import arm_of
from armproof.models.errors import ArmproofError, Sentence, together
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Document, read_document
from armproof.verification.equations.table_angles import LOOSE, TABLE, VARIABLE
from armproof.verification.errors import DocumentError, EvaluationError, WhereDefined
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.inverse.branch_graph import BranchGraph
from armproof.verification.inverse.derivation import Derivation, Step
from armproof.verification.inverse.formulas import read_formulas
from armproof.verification.inverse.given_target import GivenTarget
from armproof.verification.inverse.kinematics import InverseKinematics
from armproof.verification.inverse.numeric_algebra import NumericAlgebra
from armproof.verification.inverse.resolution import Resolution, forward_values
from armproof.verification.inverse.symbolic_algebra import free_algebra
from armproof.verification.inverse.target import read_claim
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names, spelling_of
from armproof.verification.naming.state import DocumentState
from armproof.verification.verdict import Record, Verdict

MOST_SIGNS = 6  # independent signs: 64 branches
LATEX = r"\mathrm{FK}(\mathrm{IK}(x)) = x"


class NoDerivation(DocumentError):
    """The displays of a document do not solve for every joint."""

    kind = Kind.NO_DERIVATION


def read_inverse(source: Path | str | Document) -> InverseKinematics:
    """Return the closed-form inverse of a document whose front matter has `inverse`.

    Raises:
        DocumentError: the document has none, or its displays do not solve for every joint.
    """
    document = source if isinstance(source, Document) else read_document(Path(source))
    if "inverse" not in document.front:
        raise DocumentError(say(Kind.NO_INVERSE), path=document.path)
    try:
        arm = arm_of(document.front, document.path.parent)
        names = read_names(arm, document.front)
        names.reader.spelling = spelling_of(document, names.reader.words)
        return _as_meant(document, names)[0]
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
    return _plan(start, order, NumericAlgebra(start.arm, target, BranchGraph(), values))


def _check_target(derivation: Derivation) -> None:
    """Raise DocumentError for a name of the target without a meaning on the arm."""
    try:
        forward_values(derivation, free_algebra(Ring(), derivation.arm))
    except EvaluationError as error:
        raise DocumentError(say(Kind.OF_INVERSE, problem=finding_of(error)), "inverse") from None


def _plan(start: Derivation, order: tuple[str, ...], algebra: GivenTarget) -> Derivation:
    """Return the derivation with its steps: for each joint the first display that can be computed when it is due.

    Args:
        start: names, target and formulas.
        order: the joints in the order in which they are solved; () takes the displays in their order.
        algebra: any, with the target in it.

    Raises:
        NoDerivation: a joint that no display solves for, and what the displays that try lack.
    """
    resolution = Resolution(start, algebra, {})
    steps: list[Step] = []
    left = list(order) or [joint.symbol for joint in start.arm.joints]
    while left:
        found = _next_step(resolution, left[:1] if order else left)
        if found is None:
            raise NoDerivation(_why_not(resolution, left[:1] if order else left), "inverse")
        step, value = found
        algebra.solved[step.joint] = value
        steps.append(step)
        left.remove(step.joint)
    signs = tuple(dict.fromkeys(resolution.branching))
    if len(signs) > MOST_SIGNS:
        raise DocumentError(say(Kind.TOO_MANY_SIGNS, count=len(signs), most=MOST_SIGNS), "inverse")
    return replace(start, steps=tuple(steps), choice=dict(resolution.choice), signs=signs)


def _next_step(resolution: Resolution, joints: list[str]) -> tuple[Step, Any] | None:
    """Return the first display, in the document's order, that solves for one of the joints."""
    formulas = [formula for joint in joints for formula in resolution.derivation.formulas.get(joint, [])]
    for formula in sorted(formulas, key=lambda formula: formula.line):
        known, choice = len(resolution.branching), dict(resolution.choice)
        with WhereDefined():
            return Step(formula.key, formula), resolution.variable(formula)
        del resolution.branching[known:]
        resolution.choice = choice
    return None


def _why_not(resolution: Resolution, joints: list[str]) -> str:
    target = ", ".join(resolution.derivation.target.names)
    reasons = together(_reason(resolution, joint) for joint in joints)
    either = reduce(lambda one, other: Sentence("{one} or {other}", one=one, other=other), joints)
    return Sentence(
        "'inverse': no display solves for {joints} by {target}: {reasons}",
        joints=either,
        target=target,
        reasons=reasons,
    )


def _reason(resolution: Resolution, joint: str) -> str:
    found = []
    for formula in resolution.derivation.formulas.get(joint, []):
        try:
            resolution.scalar(formula)
        except EvaluationError as error:
            found.append(Sentence("line {line}: {reason}", line=formula.line, reason=str(error)))
    return together(found) or Sentence("no display '{joint} = …'", joint=joint)


def check_inverse(document: Document, names: Names) -> Record:
    """Return the verdict of the solution that a document's front matter announces, its names read as its displays show.

    Raises:
        DocumentError: the front matter's `inverse` cannot be read.
    """
    record = Record(document.lines.get("inverse", 1), LATEX, Verdict.UNCHECKED, section="Inverse kinematics")
    try:
        inverse, reading = _as_meant(document, names)
        proof = inverse.proof
    except (NoDerivation, EvaluationError) as error:
        return replace(record, findings=(finding_of(error),))
    except DocumentError as error:
        raise document.fault(error.key or "inverse", error) from None
    except Exception as error:  # a fault of ours must not cost the displays their verdicts
        fault = say(Kind.INTERNAL_ERROR, type=type(error).__name__, reason=str(error))
        return replace(record, verdict=Verdict.UNREADABLE, findings=(fault,))
    if reading is not None and reading.kind is Kind.ANGLES_TOLD_OTHERWISE:
        return replace(record, findings=(reading,))
    return replace(
        record,
        verdict=proof.verdict,
        findings=proof.findings if reading is None else (reading, *proof.findings),
        counterexample=proof.counterexample,
        samples=proof.samples,
        max_error=proof.max_error,
    )


def _as_meant(document: Document, names: Names) -> tuple[InverseKinematics, Finding | None]:
    """Return the solution, and how the letters of joints with an offset are read where only another reading gives the target back."""
    inverse, told = _read(document, names, names.state.angles), names.reader.spelling.variables or names.state.angles
    if not names.offset_joints or inverse.proof.verdict is not Verdict.REFUTED or told == "told":
        return inverse, None
    other = LOOSE if told == "both" else VARIABLE if told == TABLE else TABLE
    second = _read(document, names, other)
    if second.proof.verdict is Verdict.REFUTED:
        return inverse, None
    meant = TABLE if other == TABLE else VARIABLE
    return second, say(Kind.ANGLES_TOLD_OTHERWISE, other=meant) if told else say(Kind.TABLE_ANGLES)


def _read(document: Document, names: Names, angles: str) -> InverseKinematics:
    """Return the solution in one reading, with the usual names of origins that equations have shown to have that meaning."""
    state = DocumentState(transforms=names.state.transforms, angles=angles)
    usual = {place: quantity for place, quantity in names.state.usual.items() if quantity.kind == "origin"}
    meanings = {key: {quantity for (name, _), quantity in usual.items() if name == key} for key, _ in usual}
    shown = {key: found.pop() for key, found in meanings.items() if len(found) == 1}
    return InverseKinematics(
        read_derivation(document, replace(names, quantities={**shown, **names.quantities}, state=state))
    )
