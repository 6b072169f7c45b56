"""The check of one function: called at configurations, traced, compared with the arm, explained."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import written
from armproof.verification.diagnosis.causes.probes import probes
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.functions.arguments import ArgumentError, read_layout
from armproof.verification.functions.asked import Asked, Part, QuestionError, read_asked, read_part
from armproof.verification.functions.caller import FunctionCaller, Stopped, at_definition
from armproof.verification.functions.explanation import explain
from armproof.verification.functions.function_check import FunctionCheck, FunctionVerdict
from armproof.verification.functions.guarded_call import Guard
from armproof.verification.functions.judgement import judge
from armproof.verification.functions.proof import Proof, prove

UNSTEADY = say(Kind.UNSTEADY)


def check_function(
    arm: Arm | str,
    function: Callable[..., Any],
    quantity: Any,
    *,
    seconds: float = 2.0,
    samples: int = 1000,
    seed: int = 2019,
) -> FunctionCheck:
    """Check a Python function of the joint values, written by anyone, against an arm.

    The function takes one vector q, or n joint values (rad, m), base to tool, and perhaps lengths (m) in parameters of their
    names; it is written in NumPy, SymPy or plain `math`. Where it can be traced it is proved for all joint values, or
    refuted; where it branches on values it is confirmed or refuted at random configurations.

    Args:
        arm: an arm, or its name.
        function: what is called; with a copy of q each time.
        quantity: {"pose": 4}, {"jacobian": 4, "rows": [1, 2, 3]} (rows [v; ω]), {"origin": 3}, … as in a document's front
            matter, or a name, "T^0_4", "J", "p_4", "z_2"; a tuple of such for a function that returns a tuple.
        seconds: how long the function may run, all its calls together.
        samples: at how many configurations of six families a function is tried that cannot be traced.
        seed: of those configurations.

    Raises:
        QuestionError: no such quantity, or nothing that can be called.
        ModelError: no such arm or frame.
    """
    started = time.perf_counter()
    loaded = arm if isinstance(arm, Arm) else load_arm(arm)
    asked = read_asked(loaded, quantity)
    if not callable(function):
        raise QuestionError("a function of q is expected, not {function}", function=f"{function!r:.60}")
    if not seconds > 0 or samples < 1:
        raise QuestionError("a check takes a positive time and at least one sample, not {seconds} s and {samples}",
            seconds=seconds, samples=samples)  # fmt: skip
    blank = FunctionCheck(loaded.name, tuple(item.label for item in asked), FunctionVerdict.ERROR)
    try:
        layout = read_layout(loaded, function)
    except ArgumentError as problem:
        return replace(blank, findings=(finding_of(problem),), error=at_definition(function, str(problem)))
    with Guard(seconds) as guard:
        caller = FunctionCaller(loaded, function, layout, guard, len(asked))
        try:
            found = _check(caller, asked, blank, (samples, seed))
        except Stopped as stop:
            found = replace(blank, verdict=stop.verdict, findings=(stop.finding,), error=stop.error)
    verdicts = found.verdicts or (found.verdict,) * len(asked)
    notes = (*found.notes, *caller.notes)
    return replace(found, verdicts=verdicts, notes=notes, printed=guard.printed, seconds=time.perf_counter() - started)


def _check(
    caller: FunctionCaller, asked: tuple[Asked, ...], blank: FunctionCheck, sampling: tuple[int, int]
) -> FunctionCheck:
    at = probes(caller.arm)
    returned = caller.many(at.q)
    parts = [
        read_part(number, item, at.true(item.quantity)[: len(values)], values)
        for number, (item, values) in enumerate(zip(asked, returned, strict=True), 1)
    ]
    steady = _is_steady(caller, at.q[0], returned)
    if not steady:
        caller.notes[str(UNSTEADY)] = None
    proof = None
    if steady and not any(part.mismatch for part in parts):
        traced = caller.trace()
        proof = traced if isinstance(traced, str) else prove(caller.arm, parts, traced, caller.layout.lengths)
    if isinstance(proof, str):
        caller.notes[written("not traced: {reason}", reason=proof)] = None
        proof = None
    found = judge(caller, parts, proof, blank, sampling)
    notes = tuple(dict.fromkeys(part.note for part in parts if part.note))
    found = replace(found, notes=notes, exact=proof is not None)
    if found.verdict is not FunctionVerdict.REFUTED:
        return found
    found = _explained(caller, parts, proof, found)
    return found if steady else replace(found, findings=(UNSTEADY,))


def _explained(caller: FunctionCaller, parts: list[Part], proof: Proof | None, found: FunctionCheck) -> FunctionCheck:
    try:
        return explain(caller, parts, proof, found)
    except Exception as fault:  # a fault of ours must not cost the verdict
        caller.notes[str(say(Kind.INTERNAL_ERROR, type=type(fault).__name__, reason=str(fault)))] = None
        return replace(found, findings=(say(Kind.RESULT_DIFFERS),))


def _is_steady(caller: FunctionCaller, q: np.ndarray, returned: list[np.ndarray]) -> bool:
    try:
        again = caller.at(q)
    except Stopped as stop:
        if not stop.is_exhausted:
            raise
        return True
    return all(
        one.shape == before[0].shape and np.array_equal(one, before[0], equal_nan=True)
        for one, before in zip(again, returned, strict=True)
    )
