"""What is wrong with a solution: the branch that misses its target, the first step that gives no joint back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial, reduce

import numpy as np

from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.solutions import judge

SAMPLES = 1000
SEED = 2019
TOLERANCE = 1e-6  # of joints and targets, scaled by their size; solutions come out near 1e-15
DRAWN = ("generic", "wide")
ForLengths = Callable[[Mapping[str, float] | None], Compiled]
OTHER_LENGTHS = 4  # choices of lengths that are tried where the proof is not exact


@dataclass(frozen=True)
class Trial:
    """What became of targets of the plant.

    Attributes:
        q: (N, n), the configurations that the targets are of.
        error: (N, B), how far each branch misses its target; NaN where it has no value.
        slot: (N, B), the slot of the target that is missed most.
        step: (N,), the number of leading steps that some branch gives back: all of them where q is found.
    """

    q: np.ndarray
    error: np.ndarray
    slot: np.ndarray
    step: np.ndarray


def try_branches(compiled: Compiled, *, by_plant: bool = True) -> Trial:
    """Return what becomes of the targets of a thousand configurations.

    Args:
        by_plant: whether the plant gives the targets; the arm's exact trace does for other lengths than the plant has.
    """
    arm, derivation = compiled.arm, compiled.derivation
    q, family = sample(arm, SAMPLES * len(FAMILIES) // len(DRAWN), np.random.default_rng(SEED), near_singular=False)
    q = q[np.isin(family, [FAMILIES.index(name) for name in DRAWN])]
    targets_of = partial(plant_targets, compiled) if by_plant else compiled.forward
    targets = targets_of(q)
    solved, valid, _ = judge(compiled, targets)
    count, branches, joints = solved.shape
    reached = targets_of(np.nan_to_num(solved).reshape(-1, joints)).reshape(count, branches, -1)
    errors = np.abs(reached - targets[:, None])
    errors = np.where(compiled.angles, 2.0 * np.abs(np.sin(errors / 2.0)), errors) / (1.0 + np.abs(targets[:, None]))
    errors[~valid] = np.nan
    slot = np.argmax(np.nan_to_num(errors), axis=-1)
    error = np.take_along_axis(errors, slot[..., None], axis=-1)[..., 0]
    order = [arm.joint(step.joint).index - 1 for step in derivation.steps]
    return Trial(q, error, slot, _leading(compiled, solved, q)[..., order].cumprod(axis=-1).sum(axis=-1).max(axis=1))


def _leading(compiled: Compiled, solved: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return which joints of which branches are those of q, (N, B, n), as 0 and 1."""
    difference = solved - q[:, None]
    revolute = np.array([joint.kind == "revolute" for joint in compiled.arm.joints])
    difference = np.where(revolute, 2.0 * np.sin(difference / 2.0), difference / (1.0 + np.abs(q[:, None])))
    return (np.abs(difference) <= TOLERANCE).astype(int)


def plant_targets(compiled: Compiled, q: np.ndarray) -> np.ndarray:
    """Return the targets, (N, m), as the plant of doubles gives them; names that displays define by their formulas."""
    target = compiled.derivation.target
    values = compiled.forward(q).copy()
    numeric = NumericKinematics(compiled.arm, q)
    for pair in target.pairs:
        X = numeric.pose(*pair)
        for (row, column), index in target.cells(pair).items():
            values[:, index] = X[:, row, column]
    return values


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
    arm = derivation.arm
    return tuple(found), {joint.symbol: float(value) for joint, value in zip(arm.joints, trial.q[row], strict=True)}


def refute_for_other_lengths(
    derivation: Derivation, compiled: ForLengths
) -> tuple[tuple[Finding, ...], dict[str, float]] | None:
    """Return what is wrong for other lengths than the model's, and where, or None."""
    arm = derivation.arm
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
