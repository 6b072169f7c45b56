"""What is wrong with a solution: the branch that misses its target, the first step that gives no joint back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce

import numpy as np

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.trial import TOLERANCE, Trial, try_branches

ForLengths = Callable[[Mapping[str, float] | None], Compiled]
OTHER_LENGTHS = 4  # choices of lengths that are tried where the proof is not exact


def refute(derivation: Derivation, trial: Trial) -> tuple[tuple[Finding, ...], dict[str, float]] | None:
    """Return what is wrong, and a configuration that shows it, or None."""
    steps = derivation.steps
    lost = np.flatnonzero(trial.step < len(steps))
    missed = np.argwhere(trial.error > TOLERANCE)
    if not len(lost) and not len(missed):
        return None
    row, branch = (int(k) for k in missed[0]) if len(missed) else (int(lost[0]), 0)
    found = []
    if len(missed):
        failing = sorted({int(k) for k in missed[:, 1]})
        slot = derivation.target.slots[int(trial.slot[row, branch])].label
        if len(failing) == len(derivation.branches) > 1:
            where = say(Kind.ON_ANY_BRANCH)
        else:
            branches = [describe_branch(derivation.branches[k]) for k in failing]
            where = reduce(lambda one, other: say(Kind.BOTH, one=one, other=other), branches)
        error = float(trial.error[row, branch])
        found.append(say(Kind.MISSES_TARGET, where=where, slot=slot, error=error))
    if len(lost):
        step = steps[int(trial.step[lost[0]])]
        share = {"lost": len(lost), "configurations": len(trial.q)}
        found.append(say(Kind.LOSES_JOINT, joint=step.joint, line=step.formula.line, **share))
        if not len(missed):
            row = int(lost[0])
    arm = derivation.names.arm
    assert arm is not None
    return tuple(found), {joint.symbol: float(value) for joint, value in zip(arm.joints, trial.q[row], strict=True)}


def refute_for_other_lengths(
    derivation: Derivation, compiled: ForLengths
) -> tuple[tuple[Finding, ...], dict[str, float]] | None:
    """Return what is wrong for other lengths than the model's, and where, or None."""
    arm = derivation.names.arm
    assert arm is not None
    generator = np.random.default_rng(len(arm.lengths))
    for _ in range(OTHER_LENGTHS if arm.lengths else 0):
        lengths = {name: float(generator.uniform(0.2, 1.2)) for name in arm.lengths}
        wrong = refute(derivation, try_branches(compiled(lengths), by_plant=False))
        if wrong is not None:
            first, *others = wrong[0]
            return (say(Kind.INVERSE_FOR_THESE_LENGTHS, others=first), *others), {**wrong[1], **lengths}
    return None


def describe_branch(signs: Mapping[str, int]) -> Finding:
    """Return "on the branch theta_2 +, rho −", or a finding without words where there is one branch."""
    named = [say(Kind.SIGNED, name=name, sign="+" if sign > 0 else "−") for name, sign in signs.items()]
    return say(Kind.ON_THE_BRANCH, signs=named) if signs else say(Kind.ON_ITS_BRANCH)
