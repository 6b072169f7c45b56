"""The singular configurations of an arm: families, ranks, directions, boundary or inside, exactly."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import written
from armproof.models.exact.trace import trace_of
from armproof.models.language import noted
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.singularities.decomposition import Decomposer, Lengths
from armproof.verification.singularities.existence import existence
from armproof.verification.singularities.families import Family, SingularityAnalysis
from armproof.verification.singularities.half_angles import HalfAngles
from armproof.verification.singularities.intersections import Descent
from armproof.verification.singularities.jacobians import ChosenJacobian, choose_jacobian
from armproof.verification.singularities.linear import Rows, eliminate, maximal_minors, polynomial_rows
from armproof.verification.singularities.points import Sampler, joint_unknowns
from armproof.verification.singularities.position import Placement
from armproof.verification.singularities.variety import Variety
from armproof.verification.singularities.writing import (
    condition_scalar,
    trigonometric_factors,
    write_condition,
    write_product,
)

SECONDS = 20.0
SECONDS_BELOW = 8.0  # for the intersections
SEED = 2019
TRIED = 8  # configurations by which a family is found to have real points


def analyse_singularities(
    arm: Arm,
    frame: str | int | None = None,
    rows: Sequence[int] | None = None,
    columns: Sequence[int] | None = None,
    expressed_in: str | int | None = None,
    *,
    seconds: float = SECONDS,
    rng: np.random.Generator | None = None,
) -> SingularityAnalysis:
    """Return where rows and columns of the geometric Jacobian lose rank, [v; ω] = J(q) q̇.

    The determinant (or every minor of the size of the generic rank) is factored in half-angle coordinates, where factors are
    unique; each irreducible factor that can vanish for positive lengths is a family.

    Args:
        frame: the frame whose velocity J gives, the tool's if not given.
        rows: rows of [v; ω], from 1. Without them, those that are not always zero; of an arm with fewer joints than that, the
            rows of v, or of ω where those of v have not the rank of J.
        columns: columns, from 1, base to tool; all if not given.
        expressed_in: the frame in whose axes, the base frame if not given.
        seconds: how long exact work may take; what is not done by then is said in `message`.
        rng: for what is confirmed at sampled configurations; without one, a new generator of a fixed seed.

    Raises:
        ModelError: the arm has no such frame, row or column.
    """
    generator = np.random.default_rng(SEED) if rng is None else rng
    started, algebra = time.thread_time(), ExactAlgebra(Ring(), arm)
    frame, expressed_in = (None if name is None else str(name) for name in (frame, expressed_in))
    with algebra.budget.of(seconds):
        result = Analyst(algebra, arm, choose_jacobian(algebra, frame, rows, columns, expressed_in), generator).run()
    return replace(result, seconds=time.thread_time() - started)


class Analyst:
    """Carries one analysis from the Jacobian to its families."""

    def __init__(self, algebra: ExactAlgebra, arm: Arm, chosen: ChosenJacobian, rng: np.random.Generator) -> None:
        self.arm, self.chosen, self.rng = arm, chosen, rng
        self.positive = frozenset(arm.lengths)
        self.half = HalfAngles(algebra.ring, chosen.simple.cells)
        self.rows: Rows = polynomial_rows(self.half, chosen.simple)
        constants = {**trace_of(arm).constants, **arm.lengths}
        self.sampler = Sampler(self.half, joint_unknowns(arm), constants, tuple(c - 1 for c in chosen.columns))
        self.decomposer = Decomposer(self.half, self.positive, budget=algebra.budget)

    def run(self) -> SingularityAnalysis:
        """Return the analysis; what cannot be done exactly is a message in it."""
        chosen = self.chosen
        result = SingularityAnalysis(
            self.arm, chosen.frame, chosen.expressed_in, chosen.rows, chosen.columns, chosen.matrix, chosen.axes, chosen.point,
            0, None, "", (), False, self.sampler, lambda: ((), ""),
        )  # fmt: skip
        steps = {
            self._with_determinant: noted("determinant beyond exact reach: {problem}"),
            self._with_families: noted("families beyond exact reach: {problem}"),
            self._with_positions: noted("positions beyond exact reach: {problem}"),
            self._with_descent: noted("descent beyond exact reach: {problem}"),
        }
        for step, beyond in steps.items():
            try:
                result = step(result)
            except EvaluationError as problem:
                said = written(beyond, problem=problem)
                result = replace(result, message=f"{result.message}; {said}" if result.message else said)
                if not result.complete:
                    break
        return result

    def _with_determinant(self, result: SingularityAnalysis) -> SingularityAnalysis:
        simple = self.chosen.simple
        rank = eliminate(Variety(self.half), self.rows).rank
        if simple.shape != (rank, rank):
            return replace(result, generic_rank=rank)
        determinant = simple.determinant()
        factors = trigonometric_factors(self.half, self.half.polynomial(determinant), self.positive)
        factored = write_product(determinant, factors) or ""
        return replace(result, generic_rank=rank, determinant=determinant, factored=factored)

    def _with_families(self, result: SingularityAnalysis) -> SingularityAnalysis:
        determinant = result.determinant
        minors = maximal_minors(self.chosen.simple, result.generic_rank) if determinant is None else [determinant]
        varieties = self.decomposer.decompose([self.half.polynomial(minor) for minor in minors])
        return replace(result, families=tuple(self._family(variety) for variety in varieties), complete=True)

    def _family(self, variety: Variety) -> Family:
        solved = [existence(factor, self.arm.joints) for factor in variety.conditions]
        conditions = [solution.condition for solution in solved]
        polynomials = [factor.polynomial for factor in variety.conditions]
        return Family(
            self.arm,
            variety,
            self.sampler,
            self.chosen,
            self.rows,
            tuple(write_condition(factor) for factor in variety.conditions),
            tuple(write_condition(factor) for factor in variety.lengths),
            tuple(solution.solved for solution in solved),
            None if None in conditions else r" \text{ and } ".join(text for text in conditions if text),
            not variety.lengths and len(self.sampler.sample(polynomials, self.rng, TRIED)) > 0,
            tuple(condition_scalar(factor) for factor in variety.conditions),
            eliminate(variety, self.rows).rank,
        )

    def _with_positions(self, result: SingularityAnalysis) -> SingularityAnalysis:
        placement = Placement(self.chosen, self.rows, result.generic_rank, self.sampler, self.positive)
        placed = tuple(
            replace(
                family,
                position=placement.place(family.variety, self.rng),
                special=MappingProxyType(placement.special(family.variety)),
            )
            for family in result.families
        )
        return replace(result, families=placed)

    def _with_descent(self, result: SingularityAnalysis) -> SingularityAnalysis:
        return replace(result, descend=lambda: self._intersections(result))

    def _intersections(self, result: SingularityAnalysis) -> tuple[tuple[Family, ...], str]:
        decomposer = Decomposer(self.half, self.positive, lengths=Lengths.LINEAR, budget=Budget(SECONDS_BELOW))
        families = [family.variety for family in result.families]
        square = result.determinant is not None
        descent = Descent(families, self.rows, self.chosen.simple, square, self.sampler, decomposer)
        found = tuple(self._family(variety) for variety in descent.run())
        return found, written(
            "not all intersections were followed: {reason}", reason=descent.given_up[0]
        ) if descent.given_up else ""
