"""What is wrong with a function: the likely mistake in one sentence, the wrong entries, the most telling configuration."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce

import numpy as np

from armproof.models.errors import counted
from armproof.verification.diagnosis.causes import find_cause
from armproof.verification.diagnosis.causes.case import Case, Explanation
from armproof.verification.diagnosis.causes.probes import partners, probes
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.functions.arguments import constants_of
from armproof.verification.functions.asked import Part, read_part, scaled_errors
from armproof.verification.functions.caller import FunctionCaller, Stopped
from armproof.verification.functions.function_check import FunctionCheck, FunctionVerdict
from armproof.verification.functions.proof import Proof
from armproof.verification.functions.telling import most_telling
from armproof.verification.functions.wrong_entries import MENDED, describe_entries, summary
from armproof.verification.verdict import WrongEntry

FEW = 2  # wrong entries that do not change with q: any mistake with exceptions might explain those


def explain(caller: FunctionCaller, parts: list[Part], proof: Proof | None, found: FunctionCheck) -> FunctionCheck:
    """Return a refuted check with its message, its wrong entries and its table."""
    findings: list[Finding] = []
    entries: list[WrongEntry] = []
    for part in parts:
        if part.wrong or part.mismatch:
            said, found_entries = _explain_part(caller, part, proof)
            if len(parts) > 1:
                said[:1] = [say(Kind.OF_QUANTITY, label=part.asked.label, what=said[0])]
            findings.extend(said)
            entries.extend(found_entries)
        elif proof is not None and (different := proof.different[part.number - 1]):
            findings.extend(part.findings)
            entries.extend(describe_entries(replace(part, wrong=list(different)), proof, mend=True))
        elif part.verdict is FunctionVerdict.REFUTED:
            findings.extend(part.findings)
    if not any(part.wrong or part.mismatch for part in parts):  # nothing to see at the arm's own lengths
        return replace(found, findings=tuple(findings), entries=tuple(entries))
    telling = most_telling(caller, parts)
    q = telling.configuration
    outside = [joint.symbol for joint in caller.arm.joints if not joint.lower <= q[joint.symbol] <= joint.upper]
    if outside:
        note = counted(
            "at the configuration shown, {joints} lies outside its limits",
            "at the configuration shown, {joints} lie outside their limits", len(outside), joints=outside,
        )  # fmt: skip
        caller.notes[note] = None
    return replace(found, findings=tuple(findings), entries=tuple(entries), counterexample=q, table=telling.table)


def _explain_part(caller: FunctionCaller, part: Part, proof: Proof | None) -> tuple[list[Finding], list[WrongEntry]]:
    """Return what is wrong with a part: its cause as a whole, or what mends its entries one by one."""
    cause = _whole(caller, part, proof)
    unsettled = cause.finding is None or (not cause.is_whole and len(part.wrong) <= MENDED)
    seek = unsettled and part.elsewhere is None
    entries = _entries(part, proof, seek)
    mended = seek and all(entry.finding for entry in entries)
    doubtful = not cause.is_whole and 0 < len(entries) <= FEW and _is_constant(part)
    if cause.finding is not None and not (mended or doubtful):
        return [cause.finding], entries
    return list(summary(entries)), entries


def _is_constant(part: Part) -> bool:
    """Whether the wrong entries are the same numbers at every configuration."""
    return all(np.ptp(part.obtained[:, r, c]) < 1e-9 for r, c in part.wrong)


def _entries(part: Part, proof: Proof | None, mend: bool) -> list[WrongEntry]:
    if proof is not None and not part.mismatch:
        return describe_entries(part, proof, mend=mend)
    return [WrongEntry(part.number, *part.place(r, c), "", "") for r, c in part.wrong]


def _whole(caller: FunctionCaller, part: Part, proof: Proof | None) -> Explanation:
    """Say what the result as a whole is instead; nothing where none is found."""
    if not np.isfinite(part.obtained).all():
        return Explanation(say(Kind.NOT_FINITE))
    if part.elsewhere is not None:
        return Explanation(_only_elsewhere(part))
    if finding := (_whole_numbers(part) if proof is None else None) or _wrong_default(caller, part):
        return Explanation(finding)
    if len(part.obtained) < len(probes(caller.arm).q):  # a slow function
        return Explanation(part.mismatch or _nearly(part))
    try:
        cause = find_cause(_case(caller, part))
    except Stopped:  # where more is asked of the function than was, it raises
        cause = Explanation()
    if part.mismatch:
        if cause.finding is None:
            return Explanation(part.mismatch)
        return Explanation(say(Kind.RESULT_SIZE_BECAUSE, mismatch=part.mismatch, cause=cause.finding))
    return cause if cause.finding is not None else Explanation(_nearly(part))


def _case(caller: FunctionCaller, part: Part) -> Case:
    at, there = probes(caller.arm), partners(caller.arm)

    def obtained_there() -> np.ndarray:
        return caller.many(there.q)[part.number - 1]

    return Case(caller.arm, part.asked.quantity, at.numeric, part.true, part.obtained, there.numeric, obtained_there)


def _only_elsewhere(part: Part) -> Finding:
    other = part.elsewhere
    assert other is not None and other.q is not None
    errors = scaled_errors(other.obtained, other.true).max(axis=(1, 2))
    wrong = int(np.sum(errors > 1e-6))
    kind = Kind.WRONG_SOMEWHERE if np.isfinite(other.obtained).all() else Kind.NOT_FINITE_SOMEWHERE
    return say(kind, wrong=wrong, configurations=len(errors))


def _whole_numbers(part: Part) -> Finding | None:
    """Entries cut to whole numbers: an array of integers does that to what is assigned to it."""
    if part.mismatch or not (part.obtained == np.trunc(part.true)).all() or (part.true == part.obtained).all():
        return None
    return say(Kind.CUT_TO_INTEGERS)


def _wrong_default(caller: FunctionCaller, part: Part) -> Finding | None:
    """The formula may be right, and the default value of a length another than the arm's."""
    if part.mismatch or not caller.layout.defaults:
        return None
    try:
        values = caller.with_lengths_of_the_arm().many(probes(caller.arm).q)[part.number - 1]
    except Stopped:
        return None
    again = read_part(part.number, part.asked, part.true, values)
    if again.mismatch or again.wrong:
        return None
    other = [
        say(Kind.DEFAULT, length=symbol, printed=str(caller.layout.defaults[symbol]), correct=value)
        for symbol, value in constants_of(caller.arm).items()
        if symbol in caller.layout.defaults and caller.layout.defaults[symbol] != value
    ]
    if not other:
        return None
    return say(Kind.WRONG_DEFAULT, lengths=reduce(lambda a, b: say(Kind.AND_THAT_OF, one=a, other=b), other))


def _nearly(part: Part) -> Finding | None:
    """Say so where all entries are right to a few digits."""
    error = float(scaled_errors(part.obtained, part.true).max())
    if error > 5e-3:
        return None
    for digits in range(1, 6):
        if np.abs(np.round(part.true, digits) - part.obtained).max() < 1e-12:
            return say(Kind.ROUNDED_ENTRIES, digits=digits)
    return say(Kind.RIGHT_TO_DECIMALS, digits=-int(np.floor(np.log10(error))) - 1)
