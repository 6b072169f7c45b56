"""The second route: what is proved must also hold on samples of the double plant, on every branch or on one."""

from __future__ import annotations

import numpy as np

from armproof.verification.equations.alignment import align, angle_places, entry_errors
from armproof.verification.equations.branches import holds_on
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.trees import bare, is_arc
from armproof.verification.verdict import Verdict

TOLERANCE = 1e-6  # of the sampled values, scaled by their size; polynomials come out near 1e-15
SINGULAR = 1e7  # samples beyond this size lie at a singularity of the formula and are left out


class SecondRoute:
    """Evaluates equations on the double plant; `enabled` tells whether a proof is confirmed there that needs no samples."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names
        self.exact = members.exact
        self.sampled = members.sampled
        self.enabled = True

    def confirm(self, outcome: Outcome, branches: bool) -> Outcome:
        """Evaluate a proved equation on the double plant as well: the second route must agree."""
        ring = self.exact.ring
        if not (self.enabled or ring.signs_chosen or ring.arcs):  # signs and branches are decided by the samples alone
            return outcome
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        outcome.samples = int(finite.sum())
        outcome.max_error = float(scaled[..., finite].max()) if outcome.samples else None
        if outcome.max_error is not None and outcome.max_error > TOLERANCE:
            if self.on_a_branch(outcome, scaled, finite):
                return outcome
            wrong = np.argwhere((scaled[..., finite] > TOLERANCE).any(axis=-1))
            outcome.verdict = Verdict.REFUTED
            outcome.wrong = [(int(r), int(c)) for r, c in wrong]
            outcome.findings = (say(Kind.UP_TO_A_SIGN),)
            outcome.sampled_only = True
        elif self._rests_on_lengths(outcome, branches):
            outcome.verdict = Verdict.REFUTED
            outcome.wrong = [(r, c) for r, row in enumerate(scaled) for c in range(len(row))]
            outcome.findings = (say(Kind.FOR_THESE_LENGTHS),)
            outcome.sampled_only = True
        return outcome

    def doubt(self, outcome: Outcome, branches: bool) -> Outcome:
        """Where square roots or arc functions leave the normal form open, equal samples still confirm."""
        pair, ring = outcome.pair, self.exact.ring
        assert pair is not None and outcome.true is not None and outcome.printed is not None
        signs = ring.signs_chosen and any(self._has_roots(m.node) for m in (outcome.true, outcome.printed))
        if not (branches or signs) and not all(
            ring.leaves_open(pair.true.rows[r][c] - pair.printed.rows[r][c]) for r, c in outcome.wrong
        ):
            return outcome
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        if (
            finite.sum() >= 10
            and float(scaled[..., finite].max()) <= TOLERANCE
            and not self._rests_on_lengths(outcome, branches)
        ):
            outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
            outcome.samples, outcome.max_error = int(finite.sum()), float(scaled[..., finite].max())
        elif not self.on_a_branch(outcome, scaled, finite) and signs:
            outcome.sampled_only = True
            outcome.findings = (say(Kind.ROOTS_POSITIVE),)
        return outcome

    def confirm_only(
        self, true: n.Node, printed: n.Node, equation: int, branches: bool, problem: EvaluationError
    ) -> Outcome:
        """Compare on samples alone what the exact algebra does not hold."""
        reason = say(Kind.NOT_EXACT, what=finding_of(problem))
        outcome = Outcome(Verdict.UNCHECKED, (reason,), equation, Member(true), Member(printed))
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        scaled, finite = errors
        if finite.sum() < 10:
            outcome.also(say(Kind.FEW_VALUES))
            return outcome
        outcome.samples, outcome.max_error = int(finite.sum()), float(scaled[..., finite].max())
        if outcome.max_error <= TOLERANCE:
            outcome.verdict = Verdict.CONFIRMED
        elif not self.on_a_branch(outcome, scaled, finite):
            outcome.verdict, outcome.sampled_only = Verdict.REFUTED, True
            outcome.wrong = [(int(r), int(c)) for r, c in np.argwhere((scaled[..., finite] > TOLERANCE).any(axis=-1))]
        return outcome

    def on_a_branch(self, outcome: Outcome, scaled: np.ndarray, finite: np.ndarray) -> bool:
        """Confirm what holds on one branch of its square roots and arc functions, and say at how many configurations."""
        assert outcome.true is not None and outcome.printed is not None
        left = min(outcome.true.node, outcome.printed.node, key=lambda node: node.span)
        counts = holds_on(scaled, finite & self.sampled().random, TOLERANCE) if self.is_solved_for(left) else None
        if counts is None:
            return False
        holding = (scaled <= TOLERANCE).all(axis=(0, 1)) & finite
        outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
        outcome.samples, outcome.max_error = int(holding.sum()), float(scaled[..., holding].max())
        outcome.findings = (say(Kind.ON_A_BRANCH, holding=int(counts[0]), configurations=int(counts[1])),)
        return True

    def is_solved_for(self, node: n.Node) -> bool:
        """Whether a left side is what inverse kinematics solves for: a joint variable, a sum of such, or cos, sin, tan of it.

        Only there a sign or a half-turn is left to the reader; √(sin² θ) = sin θ and |x| = x are identities, and false.
        """
        node = bare(node)
        if isinstance(node, n.Call) and node.function in ("cos", "sin", "tan"):
            node = node.arguments[0]
        plain = n.Name | n.JointAngles | n.Number | n.Sum | n.Product | n.Quotient | n.Group
        return all(
            isinstance(b, plain) and (not isinstance(b, n.Name) or self.members.is_symbol(b)) for b in n.walk(node)
        )

    def _has_roots(self, node: n.Node) -> bool:
        """Whether a square root stands in a tree, or may stand behind one of its names."""
        return any(
            (isinstance(b, n.Call) and b.function == "sqrt") or (isinstance(b, n.Power) and not isinstance(b.exponent, n.Number))
            or (isinstance(b, n.Name) and b.key in self.names.state.definitions)
            for b in n.walk(node)
        )  # fmt: skip

    def _rests_on_lengths(self, outcome: Outcome, branches: bool) -> bool:
        """Whether the sign of a root is right for the arm's own lengths only, as √((l_1 − l_2)²) = l_1 − l_2 may be."""
        arm, ring = self.names.arm, self.exact.ring
        assert outcome.true is not None and outcome.printed is not None
        if arm is None or not (
            ring.signs_chosen and any(self._has_roots(m.node) for m in (outcome.true, outcome.printed))
        ):
            return False
        generator = np.random.default_rng(len(arm.lengths))
        sampled = self.sampled()
        others = sampled.at({name: generator.uniform(0.2, 1.2, sampled.samples) for name in arm.lengths})
        errors = self.sampled_errors(outcome, branches, others)
        return errors is not None and bool((errors[0][..., errors[1]] > TOLERANCE).any())

    def sampled_errors(
        self, outcome: Outcome, branches: bool, sampled: SampledAlgebra | None = None
    ) -> tuple[np.ndarray, np.ndarray] | None:
        """Return the errors (rows, columns, samples), scaled by 1 + size, and the samples at which they count."""
        assert outcome.true is not None and outcome.printed is not None
        sampled = self.sampled() if sampled is None else sampled
        places = angle_places(outcome.pair) if outcome.pair is not None else set()
        # without exact values the trees tell: a side that is an arc function is an angle
        loose = outcome.pair is None and any(is_arc(m.node) for m in (outcome.true, outcome.printed))

        def angles(r: int, c: int) -> bool:
            return loose or (r, c) in places

        best: np.ndarray | None = None
        sizes: np.ndarray | None = None
        with np.errstate(all="ignore"):
            sampled.regular[:] = True
            for branch in self.names.state.signs.branches(branches):
                try:
                    one = Evaluator(self.names, sampled, branch)
                    true, printed = one.evaluate(outcome.true.node), one.evaluate(outcome.printed.node)
                    pairs = list(align(true, printed, sampled))
                    pair = next((p for p in pairs if outcome.pair is None or p.note == outcome.pair.note), pairs[0])
                except EvaluationError:
                    return None
                errors = entry_errors(pair, angles)
                errors = np.broadcast_to(errors, (*errors.shape[:2], sampled.samples))
                size = np.abs(
                    np.array([[np.broadcast_to(c, (sampled.samples,)) for c in row] for row in pair.true.rows])
                )
                best = errors if best is None else np.minimum(best, errors)
                sizes = size if sizes is None else np.maximum(sizes, size)
            assert best is not None and sizes is not None
            scaled = best / (1.0 + sizes)
            finite = sampled.regular & np.isfinite(scaled).all(axis=(0, 1)) & (sizes < SINGULAR).all(axis=(0, 1))
        return scaled, finite
