"""The proof of a closed-form inverse: FK(IK(x)) = x on every branch, and every configuration on a branch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial, reduce

import numpy as np

from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.findings.finding import write_all
from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.completeness import find_lost_step
from armproof.verification.inverse.conditions import Conditions, read_conditions
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.refutation import ForLengths, refute, refute_for_other_lengths, try_branches
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.substitution import (
    TargetValues,
    any_target,
    returns_target,
    target_of_a_configuration,
)
from armproof.verification.verdict import Verdict

SECONDS = 10.0  # for each of the two parts of a proof


@dataclass(frozen=True)
class Proof:
    """What is known of a closed-form inverse.

    Attributes:
        verdict: proved (both parts exactly), confirmed (at least one on samples only) or refuted.
        branches: the signs of each branch.
        sound: whether FK(IK(x)) = x was proved for every target at which the formulas have a value.
        complete: whether every configuration was proved to be on a branch.
        general: whether that holds for every target, and not only for those that the arm reaches (then the solution has to
            be compared with the target where that may be none of the arm's).
        conditions: where the number of solutions changes.
        findings: all that is known, and what stood in the way.
        counterexample: a configuration, with its branch, that shows what is wrong.
        samples, max_error: targets of the plant of doubles, and how far the worst branch misses them.
    """

    verdict: Verdict
    branches: tuple[dict[str, int], ...]
    sound: bool
    complete: bool
    general: bool
    conditions: Conditions
    findings: tuple[Finding, ...]
    counterexample: Mapping[str, float] = field(default_factory=dict)
    samples: int = 0
    max_error: float | None = None

    @property
    def message(self) -> str:
        """The findings in words."""
        return write_all(self.findings)


def prove(derivation: Derivation, compiled: ForLengths) -> Proof:
    """Return the proof of a solution, or what refutes it; `compiled` gives its formulas for a choice of lengths."""
    conditions = read_conditions(compiled(None))
    trial = try_branches(compiled(None))
    error = float(np.nanmax(trial.error)) if np.isfinite(trial.error).any() else None
    refuted = partial(Proof, Verdict.REFUTED, derivation.branches, False, False, False, conditions)
    if (wrong := refute(derivation, trial)) is not None:
        return refuted(*wrong, len(trial.q), error)
    sound, general, unsound = _prove_soundness(derivation, compiled(None))
    complete, incomplete = _prove_completeness(derivation)
    if not (sound and complete) and (wrong := refute_for_other_lengths(derivation, compiled)) is not None:
        return refuted(*wrong, len(trial.q), error)
    problems = (problem for problem in (unsound, incomplete) if problem is not None)
    findings = (*_describe(derivation, conditions, sound, complete), *problems)
    verdict = Verdict.PROVED if sound and complete else Verdict.CONFIRMED
    return Proof(verdict, derivation.branches, sound, complete, general, conditions, findings, {}, len(trial.q), error)


# -- exactly ---------------------------------------------------------------------------------------------------------


def _prove_soundness(derivation: Derivation, compiled: Compiled) -> tuple[bool, bool, Finding | None]:
    """Return whether FK(IK(x)) = x is proved, whether for every target, and what stood in the way."""
    problem: Finding | None = None
    every_sign = dict.fromkeys(derivation.signs, 0)
    budget = Budget(SECONDS)
    for values, eager, general in _attempts(derivation, compiled):
        roots = SubstitutionRoots(Ring(budget.share(SECONDS / 2)), derivation.arm.lengths)
        try:
            missed = returns_target(derivation, values, every_sign, roots, eager)
        except EvaluationError as error:
            problem = say(Kind.NOT_PROVED_EXACTLY, problem=finding_of(error))
            continue
        if not missed:
            return True, general, None
        labels = [derivation.target.slots[index].label for index in missed]
        problem = say(Kind.NOT_PROVED_EXACTLY_FOR, labels=labels)
    return False, False, problem


def _attempts(derivation: Derivation, compiled: Compiled) -> Iterator[tuple[TargetValues, tuple[str, ...], bool]]:
    """Yield the ways to write a target, which joints are no symbols, and whether it is every target; the likeliest first.

    A wrist is solved in coordinates that are turned with the joints before it, and those stay symbols.
    """
    arm = derivation.arm
    joints = tuple(step.joint for step in derivation.steps)
    positioned = compiled.joints_without_rotation()
    wrist = joints[len(positioned) :]
    for frame in reversed(arm.frames if positioned else ()):
        if set(positioned) == {joint.symbol for joint in arm.joints[: trace_of(arm).depth(frame)]}:
            yield any_target(frame), wrist, True
            yield any_target(frame), (), True
            break
    yield any_target(), (), True
    yield any_target(), joints, True
    yield target_of_a_configuration, (), False
    yield target_of_a_configuration, joints, False


def _prove_completeness(derivation: Derivation) -> tuple[bool, Finding | None]:
    try:
        lost = find_lost_step(derivation, Budget(SECONDS))
    except EvaluationError as error:
        return False, say(Kind.MAYBE_INCOMPLETE, problem=finding_of(error))
    return lost is None, None if lost is None else say(Kind.MAYBE_INCOMPLETE, problem=lost)


# -- what is known -----------------------------------------------------------------------------------------------------


def _describe(derivation: Derivation, conditions: Conditions, sound: bool, complete: bool) -> Iterator[Finding]:
    count, how = len(derivation.branches), "proved" if sound else "confirmed"
    if count > 1:
        yield say(Kind.RETURNS_ON_BRANCHES, how=how, count=count, signs=list(derivation.signs))
        yield say(Kind.ALL_ON_BRANCHES if complete else Kind.SAMPLES_ON_BRANCHES)
    else:
        yield say(Kind.RETURNS, how=how)
        yield say(Kind.ALL_ON_IT if complete else Kind.SAMPLES_ON_IT)
    if conditions.edges:
        yield say(Kind.FEWER_WHERE, places=_either(Kind.VANISHES, conditions.edges))
    if conditions.degenerate:
        yield say(Kind.DEGENERATE_WHERE, places=_either(Kind.HOLDS, conditions.degenerate))


def _either(kind: Kind, formulas: tuple[str, ...]) -> Finding:
    places = [say(kind, formula=" ".join(formula.split())) for formula in formulas]
    return reduce(lambda one, other: say(Kind.EITHER, one=one, other=other), places)
