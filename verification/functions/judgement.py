"""The verdict on each quantity of a function: by the probes, the proof, and the plant of doubles at more configurations."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from armproof.models.numeric.configurations import FAMILIES
from armproof.verification.diagnosis.causes.probes import Configurations, samples
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.functions.arguments import constants_of
from armproof.verification.functions.asked import Part, read_part, scaled_errors, wrong_entries
from armproof.verification.functions.caller import FunctionCaller, Stopped
from armproof.verification.functions.function_check import FunctionCheck, FunctionVerdict
from armproof.verification.functions.proof import Proof

FEW = 12  # configurations at which a function that is proved is called as well
SECONDS_FOR_FEW = 0.02
_WEIGHT = list(FunctionVerdict)


def judge(
    caller: FunctionCaller, parts: list[Part], proof: Proof | None, blank: FunctionCheck, sampling: tuple[int, int]
) -> FunctionCheck:
    """Give each part its verdict, and the check the worst of them.

    Args:
        sampling: at how many configurations a function is called that is not proved, and their seed.
    """
    count, largest = _sample(caller, parts, proof, sampling)
    for part in parts:
        if part.mismatch or part.wrong:
            continue
        if proof is not None and proof.different[part.number - 1]:
            part.verdict, part.findings = FunctionVerdict.REFUTED, (say(Kind.RIGHT_AT_LENGTHS_ONLY),)
            continue
        proved = proof is not None and proof.proved[part.number - 1]
        if not proved and _fails_for_lengths(caller, part, sampling[1]):
            part.verdict, part.findings = FunctionVerdict.REFUTED, (say(Kind.RIGHT_AT_LENGTHS_ONLY),)
            continue
        part.verdict = FunctionVerdict.PROVED if proved else FunctionVerdict.CONFIRMED
        part.findings = (_claim(caller, part, proof),) if proved else _confirmed(count, proof)
    verdicts = tuple(part.verdict for part in parts)
    worst = max(verdicts, key=_WEIGHT.index)
    findings = tuple(finding for part in parts if part.verdict is worst for finding in part.findings)
    return replace(blank, verdict=worst, findings=findings, verdicts=verdicts, samples=count, max_error=largest)


def _fails_for_lengths(caller: FunctionCaller, part: Part, seed: int) -> bool:
    """Whether a part that is right at the arm's own lengths is wrong at others, of those that the function takes."""
    own = caller.arm.lengths
    taken = [name for name in caller.layout.lengths if name in own]
    if not taken or caller.guard.left <= 0:
        return False
    lengths = {name: round((1.2 + 0.3 * k) * own[name] + 0.01, 3) for k, name in enumerate(taken)}
    at = samples(caller.arm, len(FAMILIES), seed)
    try:
        results = caller.with_lengths_of_the_arm(lengths).many(at.q)
    except Stopped:
        return False  # it may refuse them
    obtained = results[part.number - 1]
    again = read_part(part.number, part.asked, at.true_for(part.asked.quantity, lengths)[: len(obtained)], obtained)
    return bool(again.mismatch or wrong_entries(again.obtained, again.true))


def _confirmed(count: int, proof: Proof | None) -> tuple[Finding, ...]:
    """Say at how many configurations a part is right, and why it is not proved although its formula is known."""
    equal = say(Kind.EQUAL_AT, count=count)
    return (equal,) if proof is None else (equal, say(Kind.NOT_THE_FORMULA))


def _claim(caller: FunctionCaller, part: Part, proof: Proof | None) -> Finding:
    """Say for which values a part is proved."""
    assert proof is not None
    symbols = proof.bench.lengths_in(part.asked.quantity)
    if not symbols:
        return say(Kind.PROVED_FOR_JOINTS)
    if set(symbols) <= set(caller.layout.lengths) and proof.for_all_lengths[part.number - 1]:
        return say(Kind.PROVED_FOR_LENGTHS)
    values = [say(Kind.VALUE, name=symbol, value=constants_of(caller.arm)[symbol]) for symbol in symbols]
    return say(Kind.PROVED_AT_LENGTHS, values=values)


def _sample(
    caller: FunctionCaller, parts: list[Part], proof: Proof | None, sampling: tuple[int, int]
) -> tuple[int, float | None]:
    """Call the function at configurations of the six families; return at how many, and the largest error of what is right.

    What is wrong there is added to the parts; a function that is proved is called at a few only.
    """
    right = [part for part in parts if not (part.mismatch or part.wrong)]
    if not right:
        return 0, None
    proved = proof is not None and all(proof.proved[part.number - 1] for part in right)
    at = samples(caller.arm, min(FEW, sampling[0]) if proved else sampling[0], sampling[1])
    results = _call(caller, at, SECONDS_FOR_FEW if proved else np.inf)
    largest = max(float(scaled_errors(part.obtained, part.true).max()) for part in right)
    for part in right if results else ():
        largest = max(largest, _compare(part, at, [result[part.number - 1] for result in results]))
    return len(results) or len(parts[0].obtained), largest


def _call(caller: FunctionCaller, at: Configurations, seconds: float) -> list[list[np.ndarray]]:
    """Return the results at the configurations, or at the first of them where the time is up; at one of each family at least."""
    started = time.monotonic()
    results: list[list[np.ndarray]] = []
    for q in at.q:
        if caller.guard.left <= 0 or (len(results) >= len(FAMILIES) and time.monotonic() - started > seconds):
            break
        try:
            results.append(caller.at(q))
        except Stopped as stop:
            if not stop.is_exhausted:
                raise
            break
    return results


def _compare(part: Part, at: Configurations, results: list[np.ndarray]) -> float:
    """Compare the results with the plant's; return the largest error."""
    true = at.true(part.asked.quantity)[: len(results)]
    if len({result.shape for result in results}) > 1:
        part.mismatch = say(Kind.ANOTHER_SHAPE)
        return 0.0
    again = read_part(part.number, part.asked, true, np.array(results))
    if again.mismatch:
        part.mismatch = again.mismatch
        return 0.0
    part.wrong = wrong_entries(again.obtained, again.true)
    if part.wrong:
        again.q, part.elsewhere = at.q[: len(results)], again
    return float(scaled_errors(again.obtained, again.true).max())
