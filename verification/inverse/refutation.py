"""What is wrong with a solution: the branch that misses its target, the first step that gives no joint back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.trial import TOLERANCE, Trial, try_branches

if TYPE_CHECKING:
    from armproof.verification.inverse.kinematics import InverseKinematics

OTHER_LENGTHS = 4  # choices of lengths that are tried where the proof is not exact


def refute(derivation: Derivation, trial: Trial) -> tuple[str, dict[str, float]] | None:
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
        names = " and ".join(describe_branch(derivation.branches[k]) for k in failing)
        names = "on any branch" if len(failing) == len(derivation.branches) > 1 else names
        found.append(
            f"FK(IK(x)) is not x {names}: {slot} is off by {trial.error[row, branch]:.3g} at the first example"
        )
    if len(lost):
        step = steps[int(trial.step[lost[0]])]
        share = f"{len(lost)} of {len(trial.q)}"
        found.append(
            f"no branch gives back {step.joint} (line {step.formula.line}) at {share} random configurations, though the "
            f"joints before it are right"
        )
        if not len(missed):
            row = int(lost[0])
    arm = derivation.names.arm
    assert arm is not None
    return "; ".join(found), {joint.symbol: float(value) for joint, value in zip(arm.joints, trial.q[row], strict=True)}


def refute_for_other_lengths(inverse: InverseKinematics) -> tuple[str, dict[str, float]] | None:
    """Return what is wrong for other lengths than the model's, and where, or None."""
    generator = np.random.default_rng(len(inverse.arm.lengths))
    for _ in range(OTHER_LENGTHS if inverse.arm.lengths else 0):
        lengths = {name: float(generator.uniform(0.2, 1.2)) for name in inverse.arm.lengths}
        wrong = refute(inverse.derivation, try_branches(inverse.compiled(lengths), by_plant=False))
        if wrong is not None:
            return f"right for the lengths of this arm only; for others {wrong[0]}", {**wrong[1], **lengths}
    return None


def describe_branch(signs: Mapping[str, int]) -> str:
    """Return "on the branch theta_2 +, rho −", or "" where there is one branch."""
    return (
        "on the branch " + ", ".join(f"{name} {'+' if sign > 0 else '−'}" for name, sign in signs.items())
        if signs
        else ""
    )
