"""The inverse kinematics of a document: its proof, and its formulas evaluated over as many targets as one likes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.joint_values import read_joint_values
from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.proof import Proof, prove
from armproof.verification.inverse.reading import read_lengths, read_targets
from armproof.verification.inverse.solutions import (
    Mark,
    Solutions,
    judge,
    returns,
    same_configuration,
    sees_every_number,
)

MOST_COMPILED = 16  # choices of lengths that are kept
CHUNK = 4096  # doubtful targets that are evaluated with error bounds at a time


class InverseKinematics:
    """A closed-form solution: a derivation, proved and run.

    Attributes:
        arm: the arm that it is for.
        derivation: its steps, as the document has them.
    """

    def __init__(self, derivation: Derivation) -> None:
        self.arm: Arm = derivation.arm
        self.derivation = derivation
        self._compiled = lru_cache(MOST_COMPILED)(lambda *values: Compiled(derivation, dict(values)))

    @property
    def branches(self) -> tuple[dict[str, int], ...]:
        """The signs of each branch: {"theta_2": 1}, {"theta_2": −1}."""
        return self.derivation.branches

    @property
    def target(self) -> tuple[str, ...]:
        """The names of the target."""
        return self.derivation.target.names

    def solve(self, targets: Any, lengths: Mapping[str, float] | None = None) -> Solutions:
        """Return all branches of N targets.

        Args:
            targets: (N, m), a target a row, its numbers in the order of `target`; a pose as (N, 4, 4), a rotation as
                (N, 3, 3). Metres and radians.
            lengths: lengths of the arm that are to have other values than those of its model.

        Raises:
            InverseError: another shape, something that is not a real number, an unknown length.
        """
        compiled = self.compiled(lengths)
        values, invalid = read_targets(self.derivation.target, targets)
        count, branches, joints = len(values), len(self.branches), len(self.arm.joints)
        flat, doubtful = compiled.solve(values)
        q = flat.reshape(count, branches, joints)
        valid, mark = np.ones((count, branches), dtype=bool), np.full(count, Mark.REACHABLE, dtype=np.int8)
        if not np.isfinite(flat).all():
            valid = np.isfinite(q).all(axis=-1)
            mark[~valid.any(axis=1)] = Mark.UNREACHABLE
        rows = np.flatnonzero(doubtful & ~invalid)
        for start in range(0, len(rows), CHUNK):
            part = rows[start : start + CHUNK]
            q[part], valid[part], mark[part] = judge(compiled, values[part])
        if not self._sees_every_number:
            valid &= returns(compiled, q, values)
            mark[~valid.any(axis=1) & (mark != Mark.DEGENERATE)] = Mark.UNREACHABLE
        valid[invalid], mark[invalid] = False, Mark.INVALID
        if not valid.all():
            q[~valid] = np.nan
        return Solutions(q, valid, mark, self.arm.joints)

    def count(self, targets: Any, lengths: Mapping[str, float] | None = None) -> np.ndarray:
        """Return how many different solutions each target has, (N,) floats: infinity on a degenerate one.

        Raises:
            InverseError: as `solve`.
        """
        found = self.solve(targets, lengths)
        compiled = self.compiled(lengths)
        different = found.valid.astype(float)
        for b in range(1, found.q.shape[1]):
            for a in range(b):
                twice = found.valid[:, a] & found.valid[:, b]
                twice &= same_configuration(compiled, found.q[:, a], found.q[:, b])
                different[twice, b] = 0.0
        total: np.ndarray = different.sum(axis=1)
        total[found.mark == Mark.DEGENERATE] = np.inf
        return total

    def forward(self, q: Any, lengths: Mapping[str, float] | None = None) -> np.ndarray:
        """Return the target of N configurations, (N, m), by the arm's exact trace.

        Args:
            q: (N, n) joint values from base to tool (rad, m).
        """
        return self.compiled(lengths).forward(read_joint_values(self.arm, q))

    def compiled(self, lengths: Mapping[str, float] | None = None) -> Compiled:
        """Return the formulas as numbers, for the lengths of the model or for others."""
        return self._compiled(*sorted(read_lengths(self.arm, lengths).items()))

    @cached_property
    def _sees_every_number(self) -> bool:
        return sees_every_number(self.compiled())

    @cached_property
    def proof(self) -> Proof:
        """What is proved of it, by substitution on every branch."""
        return prove(self.derivation, self.compiled)
