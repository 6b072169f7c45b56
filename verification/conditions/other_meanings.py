"""A letter that the text gives another meaning than the arm has for it: what is written with it is left open."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.other_meanings import ALL, BEHIND, JACOBIAN
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key


class OtherMeanings:
    """Leaves open what is written with a letter that is meant otherwise."""

    def __init__(self, checker: ChainChecker, given: GivenValues) -> None:
        self.checker = checker
        self.given = given
        self.names = checker.names

    def judge(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is written with a letter that the text gives another meaning than the arm has for it."""
        written = {below.key for node in outcome.nodes for below in n.walk(node) if isinstance(below, n.Name)}
        if JACOBIAN in meant and JACOBIAN in written:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=JACOBIAN))
        sides = (outcome.pair.true, outcome.pair.printed) if outcome.pair is not None else ()
        written |= symbols_in(cell for side in sides for cell in side.cells if isinstance(cell, Scalar))
        for each in meant:
            letters = self._meant_by(each)
            if not written.isdisjoint(letters):
                return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=min(written & letters)))
        return outcome

    def _meant_by(self, meant: str) -> set[str]:
        r"""Return the joints and lengths that a letter, or the word for all angles, names: of `BEHIND` those that are measured from a joint before them."""
        which, _, latex = meant.partition(" ")
        if which not in (ALL, BEHIND):
            return set()
        of_arm = {*self.given.lengths} | self._turned(which == BEHIND)
        if not latex:
            return self._turned(which == BEHIND)
        try:
            return {bare_key(self.names.reader.read_expression(latex)) or ""} & of_arm
        except ReadError:
            return set()

    def _turned(self, only_behind: bool) -> set[str]:
        """Return the joints that turn; or those alone that a joint before them turns about the same direction."""
        if self.names.arm is None:
            return {*self.given.joints}
        turning = [joint for joint in self.names.arm.joints if joint.kind == "revolute"]
        if not only_behind:
            return {joint.symbol for joint in turning}
        whole = self.checker.exact.jacobian(self.names.arm.frames[-1], self.names.arm.frames[0])
        axes = {joint: [row[joint.index - 1] for row in whole.rows[3:]] for joint in turning}
        found = set()
        for before, joint in combinations(turning, 2):
            pairs = [*zip(axes[joint], axes[before], strict=True)]
            if all((a - b).is_zero() for a, b in pairs) or all((a + b).is_zero() for a, b in pairs):
                found.add(joint.symbol)
        return found
