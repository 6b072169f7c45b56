"""What rests on a usual meaning that does not fit: it is left undecided, and told what it would be as usual."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import (
    agree_exactly,
    exactly_equal,
    is_near,
)
from armproof.verification.equations.doubts import Doubts
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.equations.usual_meanings import UsualMeanings
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, has_branches
from armproof.verification.naming.conventions import (
    LETTERS,
    is_usual,
)
from armproof.verification.verdict import Verdict


class UsualJudge:
    """Judges what is decided by names that only convention binds."""

    def __init__(self, equality: Equality) -> None:
        self.equality = equality
        self.members, self.names = equality.members, equality.names

    @cached_property
    def meanings(self) -> UsualMeanings:
        """Tells what names that only convention binds may mean; made where one is met."""
        return UsualMeanings(self.members)

    def judge(self, outcome: Outcome, doubts: Doubts) -> Outcome:
        """Leave undecided what rests on a usual meaning that does not fit."""
        if outcome.gives_numbers and outcome.printed is not None:
            self._give(n.plain_name(outcome.printed.node))
        if outcome.verdict is Verdict.REFUTED and (meant := self._defined_otherwise(outcome)) is not None:
            return outcome.left_open(meant)
        near = outcome.pair is not None and is_near(outcome.pair)
        refuted = outcome.verdict is Verdict.REFUTED
        if refuted and not near and outcome.true is not None and _is_placed_above(outcome.true.node):
            return outcome.left_open(say(Kind.WHICH_INDEX))  # p_0^2 may place frame 2 in frame 0
        if refuted and (key := self._seen_from_elsewhere(outcome)):
            return outcome.left_open(say(Kind.NOT_BOUND, name=key))
        if refuted and (key := self._from_another_height(outcome)):
            return outcome.left_open(say(Kind.NOT_BOUND, name=key))
        near = near and not self._is_of_triangle(outcome, doubts)
        doubtful = (doubts.weak and not near) if refuted else (outcome.defines and doubts.open)
        if not doubtful:
            return outcome
        judged = doubts.judge(outcome)
        return judged if refuted else replace(judged, as_usual=self._as_usual(outcome, doubts))

    def _as_usual(self, outcome: Outcome, doubts: Doubts) -> AsUsual | None:
        """Return what an equation that gives a name another value would be, if the name meant what it usually does."""
        name = n.plain_name(outcome.printed.node) if outcome.printed is not None else None
        tried = doubts.tried.get(name.key) if name is not None else None
        if name is None or tried is None or outcome.true is None:
            return None
        of_other = self._is_of_other(outcome.true)
        if of_other and (name.base not in "xyzXYZ" or name.sub or name.sup):
            return None
        meanings = {name.key: doubts.open[name.key]}
        self.names.state.inferred |= meanings
        try:
            found = self.equality.compare(tried, outcome.true, outcome.equation, has_branches(outcome.true.node))
        finally:
            self.names.state.forget_usual(meanings)
        return AsUsual(found, meanings, of_other) if found.verdict is Verdict.REFUTED else None

    def _is_of_other(self, member: Member) -> bool:
        """Whether a value is a point, a rotation or a pose of the arm, or a coordinate of one of its points."""
        if not isinstance(value := member.value, Scalar):
            return self.meanings.is_of_another([member])
        points = [self.members.exact.quantity(each) for each in self.meanings.others() if each.kind == "origin"]
        return any(exactly_equal(cell, value) for point in points for cell in point.cells)

    def _is_of_triangle(self, outcome: Outcome, doubts: Doubts) -> bool:
        """Whether the usual letter of the tool's direction stands alone in a cosine: h² = l_1² + l_2² - 2 l_1 l_2 cos φ."""
        spoken = [b for node in outcome.nodes for b in n.names(node) if b.key in doubts.weak]
        cosines = [b for node in outcome.nodes for b in n.walk(node) if n.is_call(b, "cos")]
        quantity = self.names.quantity(spoken[0]) if len(spoken) == 1 else None
        in_sum = any(isinstance(bare(node), n.Sum) for node in outcome.nodes)
        return (
            in_sum
            and quantity is not None
            and quantity.kind == "angle"
            and [c.arguments for c in cosines] == [(*spoken,)]
        )

    def _give(self, name: n.Name | None) -> None:
        """x = 0: where the tool is to be, and not what x is."""
        if name is not None and is_usual(name) and self.names.usual(name):
            self.names.keep_as_given(name.key)

    def _seen_from_elsewhere(self, outcome: Outcome) -> str:
        """Return a block of a pose seen from another frame than the base, T_2^1 = [R, p_2; 0, 1], that names no frame to be seen from."""
        name = n.plain_name(outcome.true.node) if outcome.true is not None else None
        quantity = self.names.quantity(name) if name is not None else None
        if (
            quantity is None
            or quantity.kind not in ("pose", "rotation")
            or quantity.reference == self.names.base
            or outcome.printed is None
        ):
            return ""
        blocks = (n.plain_name(cell) for row in written_rows(outcome.printed.node) for cell in row)
        return next((each.key for each in blocks if each is not None and self._is_unseen(each)), "")

    def _from_another_height(self, outcome: Outcome) -> str:
        """Return the height of a point with an index, z_w, that is counted from that of a joint which stands: z_w = z - d_1 - … from the shoulder."""
        arm, pair = self.names.arm, outcome.pair
        named = [name for node in outcome.nodes if (name := n.plain_name(node)) is not None]
        key = next((each.key for each in named if each.base in "zZ" and each.sub and not self._is_bound(each)), "")
        if arm is None or pair is None or not pair.is_scalar or not key:
            return ""
        ((_, true, printed),) = pair.entries()
        origins = (self.members.exact.quantity(Quantity("origin", each, arm.frames[0])) for each in arm.frames[1:-1])
        heights = [origin.rows[2][0] for origin in origins if isinstance(origin, Matrix)]
        standing = [each for each in heights if symbols_in([each]).isdisjoint(self.names.joints) and not each.is_zero()]
        return key if any(exactly_equal(true - printed, each) for each in standing) else ""

    def _is_bound(self, name: n.Name) -> bool:
        return name.key in self.names.quantities or name.key in self.names.state.definitions

    def _is_unseen(self, name: n.Name) -> bool:
        """Whether a name is taken as seen from the base, and no index and no front matter says so."""
        quantity = None if name.sup or name.pre_sup or name.key in self.names.quantities else self.names.quantity(name)
        return quantity is not None and quantity.reference == self.names.base

    def _defined_otherwise(self, outcome: Outcome) -> Finding | None:
        """A name that the document gave another meaning is exactly what it usually is: nobody can tell which is meant."""
        name = n.plain_name(outcome.true.node) if outcome.true is not None else None
        definition = self.names.state.definitions.get(name.key) if name is not None else None
        arm = self.names.arm
        if name is None or name.base not in LETTERS or definition is None or arm is None or outcome.printed is None:
            return None
        for quantity in filter(None, map(self.meanings.with_rows, self.names.usual(name))):
            usual = Member(name, self.members.exact.quantity(quantity))
            if (pair := self.meanings.closest(usual, outcome.printed)) is not None and agree_exactly(pair):
                return say(Kind.SECOND_MEANING, name=name.key, line=definition.line)
        return None


def _is_placed_above(node: n.Node) -> bool:
    return isinstance(node, n.Name) and node.base in "pPoOd" and node.sup.isdigit() and node.sub.isdigit()
