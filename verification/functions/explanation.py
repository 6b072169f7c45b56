"""What is wrong with a function: the likely mistake in one sentence, the wrong entries, the most telling configuration."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from armproof.models.arm import Arm
from armproof.verification.diagnosis.causes import find_cause
from armproof.verification.diagnosis.causes.case import Case, Explanation
from armproof.verification.diagnosis.causes.probes import partners, probes
from armproof.verification.functions.arguments import constants_of
from armproof.verification.functions.caller import FunctionCaller, Stopped
from armproof.verification.functions.function_check import FunctionCheck
from armproof.verification.functions.part import Part, read_part, scaled_errors
from armproof.verification.functions.proof import Proof
from armproof.verification.functions.telling import most_telling
from armproof.verification.functions.wrong_entries import MENDED, describe_entries, summary
from armproof.verification.verdict import WrongEntry

FEW = 2  # wrong entries that do not change with q: any mistake with exceptions might explain those


def explain(
    arm: Arm, caller: FunctionCaller, parts: list[Part], proof: Proof | None, found: FunctionCheck
) -> FunctionCheck:
    """Return a refuted check with its message, its wrong entries and its table."""
    words: list[str] = []
    entries: list[WrongEntry] = []
    for part in parts:
        if part.wrong or part.mismatch:
            said, found_entries = _explain_part(arm, caller, part, proof)
            words.append(f"{part.asked.label}: {said}" if len(parts) > 1 else said)
            entries.extend(found_entries)
    telling = most_telling(arm, caller, parts)
    outside = [
        joint.symbol for joint in arm.joints if not joint.lower <= telling.configuration[joint.symbol] <= joint.upper
    ]
    if outside:
        caller.notes[f"at the configuration shown, {', '.join(outside)} lies outside its limits"] = None
    return replace(
        found,
        message="; ".join(dict.fromkeys(words)),
        entries=tuple(entries),
        counterexample=telling.configuration,
        table=telling.table,
    )


def _explain_part(arm: Arm, caller: FunctionCaller, part: Part, proof: Proof | None) -> tuple[str, list[WrongEntry]]:
    """Return what is wrong with a part in words: its cause as a whole, or what mends its entries one by one."""
    cause = _whole(arm, caller, part, proof)
    unsettled = not cause.words or (not cause.is_whole and len(part.wrong) <= MENDED)
    seek = unsettled and part.elsewhere is None
    entries = _entries(part, proof, seek)
    mended = seek and all(entry.change for entry in entries)
    doubtful = not cause.is_whole and 0 < len(entries) <= FEW and _is_constant(part)
    if cause.words and not (mended or doubtful):
        return cause.words, entries
    return "; ".join(dict.fromkeys(summary(entries))), entries


def _is_constant(part: Part) -> bool:
    """Whether the wrong entries are the same numbers at every configuration."""
    return all(np.ptp(part.obtained[:, r, c]) < 1e-9 for r, c in part.wrong)


def _entries(part: Part, proof: Proof | None, mend: bool) -> list[WrongEntry]:
    if proof is not None and not part.mismatch:
        return describe_entries(part, proof, mend=mend)
    places = [(None, None) if part.is_scalar else (r + 1, c + 1) for r, c in part.wrong]
    return [WrongEntry(part.number, row, column, "", "") for row, column in places]


def _whole(arm: Arm, caller: FunctionCaller, part: Part, proof: Proof | None) -> Explanation:
    """Say what the result as a whole is instead; without words where nothing is found."""
    if not np.isfinite(part.obtained).all():
        return Explanation("the result holds entries that are not finite (NaN or infinity)")
    if part.elsewhere is not None:
        return Explanation(_only_elsewhere(part))
    if words := (_whole_numbers(part) if proof is None else "") or _wrong_default(arm, caller, part):
        return Explanation(words)
    if len(part.obtained) < len(probes(arm).q):  # a slow function
        return Explanation(part.mismatch or _nearly(part))
    try:
        cause = find_cause(_case(arm, caller, part))
    except Stopped:  # where more is asked of the function than was, it raises
        cause = Explanation()
    if part.mismatch:
        return Explanation(f"{part.mismatch}: {cause.words}" if cause.words else part.mismatch)
    return cause if cause.words else Explanation(_nearly(part))


def _case(arm: Arm, caller: FunctionCaller, part: Part) -> Case:
    at, there, index = probes(arm), partners(arm), part.number - 1
    return Case(
        arm, part.asked.quantity, at.numeric, part.true, part.obtained, there.numeric, lambda: caller.many(there.q)[index]
    )  # fmt: skip


def _only_elsewhere(part: Part) -> str:
    other = part.elsewhere
    assert other is not None and other.q is not None
    errors = scaled_errors(other.obtained, other.true).max(axis=(1, 2))
    wrong = int(np.sum(errors > 1e-6))
    kind = "not finite" if not np.isfinite(other.obtained).all() else "wrong"
    return (
        f"the result is {kind} at {wrong} of {len(errors)} configurations, such as the one given, and right elsewhere"
    )


def _whole_numbers(part: Part) -> str:
    """Entries cut to whole numbers: an array of integers does that to what is assigned to it."""
    if (
        part.mismatch
        or not (part.obtained == np.trunc(part.obtained)).all()
        or (part.true == np.trunc(part.true)).all()
    ):
        return ""
    if np.abs(part.obtained - np.trunc(part.true)).max() > 0:
        return ""
    return (
        "every entry is cut to a whole number: an array made of integers cuts what is assigned to it; make it of floats"
    )


def _wrong_default(arm: Arm, caller: FunctionCaller, part: Part) -> str:
    """The formula may be right, and the default value of a length another than the arm's."""
    if part.mismatch or not caller.layout.defaults:
        return ""
    try:
        values = caller.with_lengths_of_the_arm().many(probes(arm).q)[part.number - 1]
    except Stopped:
        return ""
    again = read_part(part.number, part.asked, part.true, values)
    if again.mismatch or again.wrong:
        return ""
    other = [
        f"{symbol} is {caller.layout.defaults[symbol]}, the arm's is {value:g}"
        for symbol, value in constants_of(arm).items()
        if symbol in caller.layout.defaults and caller.layout.defaults[symbol] != value
    ]
    return f"the formula is right, but the default value of {'; that of '.join(other)}"


def _nearly(part: Part) -> str:
    """Say so where all entries are right to a few digits."""
    error = float(scaled_errors(part.obtained, part.true).max())
    if error > 5e-3:
        return ""
    for digits in range(1, 6):
        if np.abs(np.round(part.true, digits) - part.obtained).max() < 1e-12:
            return f"the entries are rounded to {digits} decimals"
    return (
        f"right to about {-int(np.floor(np.log10(error))) - 1} decimals only: a rounded constant (3.14 for π), "
        "or a difference quotient with too large a step"
    )
