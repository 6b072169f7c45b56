"""An arm that the text tells of beside others of which as much holds: what is not decided alike for all of them is left open."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.tables.arms.settling import Inference
from armproof.verification.verdict import HOLDS, DocumentResult, EquationResult, Record, Verdict

Check = Callable[[Inference], DocumentResult]


def unless_rivalled(part: Inference, result: DocumentResult, check: Check) -> DocumentResult:
    """Return the verdicts of a part, those left open that are others for a rival of its arm."""
    if part.arm is None or not part.arm.rivals:
        return result
    doubt = say(Kind.ARM_RIVALLED, source=part.arm.source, line=part.arm.line)
    for front in part.arm.rivals:
        added = {key: value for key, value in front.items() if key in part.arm.front or key == "quantities"}
        arm = replace(part.arm, front=added, rivals=())
        there = check(Inference(replace(part.document, front=dict(front)), arm))
        others = {each.place: each for each in there.equations}
        equations = (_for_both(each, others.get(each.place), doubt) for each in result.equations)
        result = replace(result, equations=tuple(equations))
    return result


def _for_both(record: Record, other: Record | None, doubt: Finding) -> Record:
    """Return a record, left open in what is decided otherwise there."""
    there = other.outcomes if other is not None else ()
    if record.erratum:
        return record
    return record.left_open(
        doubt, lambda one: not any(_is_alike(one, each) for each in there if each.index == one.index)
    )


def _is_alike(one: EquationResult, other: EquationResult) -> bool:
    """Whether two verdicts on an equation are for, or against it, or the first is none."""
    if one.verdict in HOLDS:
        return other.verdict in HOLDS
    return one.verdict is not Verdict.REFUTED or other.verdict is Verdict.REFUTED
