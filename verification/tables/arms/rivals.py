"""An arm that the text tells of beside others of which as much holds: what is not decided alike for all of them is left open."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from armproof.verification.findings import Kind, say
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

        def differs(record: Record, one: EquationResult, others: dict[tuple[int, int], Record] = others) -> bool:
            other = others[record.place].outcomes if record.place in others else ()
            return not any(_is_alike(one, each) for each in other if each.index == one.index)

        equations = tuple(
            each if each.erratum else each.left_open(doubt, lambda one, each=each: differs(each, one))  # type: ignore[misc]
            for each in result.equations
        )
        result = replace(result, equations=equations)
    return result


def _is_alike(one: EquationResult, other: EquationResult) -> bool:
    """Whether two verdicts on an equation are for, or against it, or the first is none."""
    if one.verdict in HOLDS:
        return other.verdict in HOLDS
    return one.verdict is not Verdict.REFUTED or other.verdict is Verdict.REFUTED
