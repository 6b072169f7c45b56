"""Solve a million targets of every arm of the course, and mark those on edges, degenerate and out of reach.

    python -m tests.sweeps.inverse [--count 1000000] [--special 100000] [ARM...]

Exit code 1 if a branch misses a target by more than 1e-10, a configuration is on no branch, or a mark is wrong.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator

import numpy as np

from armproof.course.inverse import inverse_of
from armproof.verification.inverse import InverseKinematics, Mark
from tests.sweeps.inverse_targets import KINDS, equal_lengths, generic, out_of_reach, targets_of

MISS = 1e-10
SAME = 1e-6
CHUNK = 100_000


def main() -> int:
    """Print what each sweep finds; return 1 if something is wrong."""
    parser = argparse.ArgumentParser(prog="python -m tests.sweeps.inverse", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("arms", nargs="*", default=sorted(KINDS), help="arms of the course (default: all)")
    parser.add_argument("--count", type=int, default=1_000_000, help="targets within reach, an arm")
    parser.add_argument("--special", type=int, default=100_000, help="targets of each other kind, an arm")
    options = parser.parse_args()
    passed = True
    for name in options.arms:
        started = time.perf_counter()
        inverse = inverse_of(name)
        found = [sweep_reachable(inverse, options.count), *sweep_special(inverse, options.special)]
        passed &= all(good for good, _ in found)
        print(f"{name}: {inverse.proof.verdict.value} on {len(inverse.branches)} branches")
        for good, line in found:
            print(f"    {'ok   ' if good else 'WRONG'} {line}")
        print(f"    {time.perf_counter() - started:.1f} s")
    return 0 if passed else 1


def sweep_reachable(inverse: InverseKinematics, count: int) -> tuple[bool, str]:
    """Return whether every branch reaches its target and some branch returns the configuration, and the figures."""
    generator = np.random.default_rng(3)
    revolute = np.array([joint.kind == "revolute" for joint in inverse.arm.joints])
    worst, lost, unmarked, edges, branches = 0.0, 0, 0, 0, 0
    for size in _chunks(count):
        q = generic(inverse.arm, generator, size)
        targets = targets_of(inverse, q)
        found = inverse.solve(targets)
        for branch in range(found.q.shape[1]):
            valid = found.valid[:, branch]
            worst = max(worst, miss(inverse, found.q[valid, branch], targets[valid]))
            branches += int(valid.sum())
        difference = found.q - q[:, None]
        difference = np.abs(np.where(revolute, np.sin(difference / 2), difference)).max(axis=-1)
        lost += int((~(np.where(found.valid, difference, np.inf).min(axis=1) < SAME)).sum())
        unmarked += int((~np.isin(found.mark, [Mark.REACHABLE, Mark.EDGE])).sum())
        edges += int((found.mark == Mark.EDGE).sum())
    good = worst <= MISS and not lost and not unmarked
    return good, (
        f"{count:,} targets, {branches:,} solutions: largest |FK(IK(x)) - x| {worst:.1e}, {lost} configurations on no branch, "
        f"{unmarked} not marked reachable, {edges} within rounding of an edge"
    )


def sweep_special(inverse: InverseKinematics, count: int) -> Iterator[tuple[bool, str]]:
    """Yield whether the targets of each other kind are all marked as what they are, and the figures."""
    kinds, name = KINDS[inverse.arm.name], inverse.arm.name
    generator = np.random.default_rng(4)
    if kinds.edge is not None:
        yield _marked(
            inverse, "on the edge", targets_of(inverse, kinds.edge(generator, count, inverse.arm.lengths)), Mark.EDGE
        )
    if kinds.degenerate is not None:
        lengths = equal_lengths(name)
        q = kinds.degenerate(generator, count, {**inverse.arm.lengths, **(lengths or {})})
        yield _marked(inverse, "degenerate", targets_of(inverse, q, lengths), Mark.DEGENERATE, lengths)
    if (targets := out_of_reach(inverse, generator, count)) is not None:
        yield _marked(inverse, "out of reach", targets, Mark.UNREACHABLE)


def _marked(
    inverse: InverseKinematics, kind: str, targets: np.ndarray, mark: Mark, lengths: dict[str, float] | None = None
) -> tuple[bool, str]:
    wrong = 0
    for start in range(0, len(targets), CHUNK):
        found = inverse.solve(targets[start : start + CHUNK], lengths)
        wrong += int((found.mark != mark).sum())
        wrong += int((np.isnan(found.q).any(axis=-1) == found.valid).sum())
    return not wrong, f"{len(targets):,} targets {kind}: {len(targets) - wrong:,} marked so"


def miss(inverse: InverseKinematics, q: np.ndarray, targets: np.ndarray) -> float:
    """Return how far configurations miss their targets at most, angles up to whole turns."""
    error = targets_of(inverse, q) - targets
    angles = np.array(inverse.compiled().angles)
    return float(np.abs(np.where(angles, np.sin(error), error)).max(initial=0.0))


def _chunks(count: int) -> Iterator[int]:
    for start in range(0, count, CHUNK):
        yield min(CHUNK, count - start)


if __name__ == "__main__":
    sys.exit(main())
