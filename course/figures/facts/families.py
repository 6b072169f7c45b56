"""The singular configurations that figures show: analysed once an arm, shared by all kinds."""

from __future__ import annotations

from functools import lru_cache

from armproof.course.figures.facts.task import task_of
from armproof.models.arm import Arm
from armproof.verification.errors import EvaluationError
from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.families import Family, SingularityAnalysis


@lru_cache(maxsize=64)
def singularities_of(arm: Arm) -> SingularityAnalysis:
    """Return the families of singular configurations of an arm's tool, whose intersections are not computed."""
    task = task_of(arm)
    return analyse_singularities(arm, task.frame, task.rows)


def families_of(arm: Arm) -> tuple[Family, ...]:
    """Return the families that an arm has at its own lengths; none where they are beyond exact reach."""
    try:
        return tuple(family for family in singularities_of(arm).families if family.exists)
    except EvaluationError:
        return ()


def determinant_of(arm: Arm) -> str:
    """Return det J as a product in LaTeX; "" where J is not square, or it is beyond exact reach."""
    try:
        return singularities_of(arm).factored
    except EvaluationError:
        return ""
