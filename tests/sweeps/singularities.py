"""A search for singular configurations that no family states: `python -m tests.sweeps.singularities [COUNT]`.

Random configurations of every arm are led to where the smallest singular value of J vanishes (Newton's method on σ, with
∂σ/∂q = uᵀ(∂J/∂q)v), with no knowledge of the families. Each singular configuration found must lie on a family of
`analyse_singularities`, and each family's points must be singular.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass

import numpy as np

from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import arm_names, load_arm
from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.families import SingularityAnalysis
from armproof.verification.singularities.points import Sampler
from armproof.verification.singularities.second_order import jacobian_derivatives

COUNT = 1_000_000
BLOCK = 20_000
STEPS = 60
LONGEST_STEP = 0.5  # rad or m
SINGULAR = 1e-9  # σ of a singular configuration
POLISHED = 1e-14  # σ at which refining stops
ON_FAMILY = 1e-6  # rad or m
FAMILY_POINTS = 500


@dataclass(frozen=True)
class Outcome:
    """What a sweep found of one Jacobian.

    Attributes:
        started, singular: configurations drawn, and those that ended where σ < 1e-9.
        stray: singular configurations on no family. farthest: the greatest distance from the nearest family.
        hits: how many lie on each family.
        largest_sigma: the greatest σ at points of the families; wrong_ranks: points at which the rank is not the one stated.
    """

    name: str
    started: int
    singular: int
    stray: int
    farthest: float
    hits: tuple[int, ...]
    largest_sigma: float
    wrong_ranks: int
    seconds: float

    @property
    def passed(self) -> bool:
        """Whether the families are all, and are singular; where none is stated none may be found."""
        return not self.stray and not self.wrong_ranks and self.largest_sigma < SINGULAR and all(self.hits)


def task_jacobian(analysis: SingularityAnalysis, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return J of the task, (N, rows, columns), and ∂J/∂q_k, (N, rows, columns, columns)."""
    rows, columns = [r - 1 for r in analysis.rows], [c - 1 for c in analysis.columns]
    J = np.array(bulk_of(analysis.arm).jacobian(q, analysis.frame))
    derivatives = jacobian_derivatives(J)[:, rows][:, :, columns][:, :, :, columns]
    return J[:, rows][:, :, columns], derivatives


def refine(analysis: SingularityAnalysis, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lead configurations to where the last singular value of the generic rank is zero; return them with that value."""
    q = q.copy()
    columns = [c - 1 for c in analysis.columns]
    last = analysis.generic_rank - 1
    sigma = np.full(len(q), np.inf)
    active = np.arange(len(q))
    for _ in range(STEPS):
        J, derivatives = task_jacobian(analysis, q[active])
        left, values, right = np.linalg.svd(J, full_matrices=False)
        sigma[active] = values[:, last]
        going = values[:, last] > POLISHED
        active, u, v = active[going], left[going, :, last], right[going, last]
        if not len(active):
            break
        gradient = np.einsum("ni,nijk,nj->nk", u, derivatives[going], v)
        step = gradient * (sigma[active] / np.maximum((gradient**2).sum(axis=1), 1e-300))[:, None]
        length = np.linalg.norm(step, axis=1, keepdims=True)
        q[np.ix_(active, columns)] -= step * np.minimum(1.0, LONGEST_STEP / np.maximum(length, 1e-300))
    return q, sigma


def sweep(name: str, analysis: SingularityAnalysis, count: int, rng: np.random.Generator) -> Outcome:
    """Search for singular configurations of one Jacobian, and check the families' own points."""
    started = time.perf_counter()
    assert analysis.complete, analysis.message
    sampler: Sampler = analysis.sampler
    singular, stray, farthest = 0, 0, 0.0
    hits = np.zeros(len(analysis.families), dtype=int)
    for begin in range(0, count, BLOCK):
        q, sigma = refine(analysis, sampler.draw(rng, min(BLOCK, count - begin)))
        q, sigma = q[sigma < SINGULAR], sigma[sigma < SINGULAR]
        singular += len(q)
        if not analysis.families or not len(q):
            stray += len(q)
            continue
        distances = np.stack([family.distance(q) for family in analysis.families], axis=1)
        tolerance = np.maximum(
            ON_FAMILY, 10 * np.sqrt(sigma)
        )  # where two families meet σ is a product of two distances
        hits += (distances <= tolerance[:, None]).sum(axis=0)
        nearest = distances.min(axis=1)
        stray += int((nearest > tolerance).sum())
        farthest = max(farthest, float(nearest.max()))
    largest, wrong = _family_points(analysis, rng)
    seconds = time.perf_counter() - started
    return Outcome(name, count, singular, stray, farthest, tuple(hits.tolist()), largest, wrong, seconds)


def _family_points(analysis: SingularityAnalysis, rng: np.random.Generator) -> tuple[float, int]:
    """Return the greatest σ at points of the families, and how many generic ones have another rank than stated."""
    largest, wrong = 0.0, 0
    for family in analysis.families:
        q = family.sample(rng, FAMILY_POINTS)
        J, _ = task_jacobian(analysis, q)
        values = np.linalg.svd(J, compute_uv=False)
        largest = max(largest, float(values[:, analysis.generic_rank - 1].max()))
        clear = np.median(values[:, family.rank - 1]) > 1e-6 if family.rank else True
        above = values[:, family.rank] if family.rank < values.shape[1] else np.zeros(1)
        wrong += int((above > SINGULAR).sum()) + (0 if clear else len(q))
    return largest, wrong


def main(count: int) -> int:
    """Sweep all arms, and print a line for each; return 0 if all passed."""
    rng = np.random.default_rng(2026)
    analyses = {name: analyse_singularities(load_arm(name)) for name in arm_names()}
    analyses["planar_3r, rows 1 2"] = analyse_singularities(load_arm("planar_3r"), rows=[1, 2])
    share = -(-count // len(analyses))
    passed = True
    for name, analysis in analyses.items():
        found = sweep(name, analysis, share, rng)
        passed &= found.passed
        print(
            f"{name:20} {found.started:8,} drawn {found.singular:8,} singular, on families {found.hits}, stray {found.stray}, "
            f"farthest {found.farthest:.1e}; families: σ ≤ {found.largest_sigma:.1e}, wrong ranks {found.wrong_ranks}  "
            f"{found.seconds:.1f} s",
            flush=True,
        )
    print("passed" if passed else "FAILED")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1].replace(",", "").replace("_", "")) if len(sys.argv) > 1 else COUNT))
