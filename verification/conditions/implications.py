"""Which verdict an implication gets: what holds in one reading of its names alone is left open."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from itertools import pairwise

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.implication import (
    WHOLE_NUMBERS,
    Implication,
    is_condition,
    is_rank_condition,
)
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.misreadings import letters_held, sizes_of_convention
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.state import Key
from armproof.verification.verdict import DECIDED, HOLDS, Verdict

Judgement = tuple[Outcome, dict[str, float]] | None  # the verdict of an implication and what refutes it


class Implications:
    """Judges implications in each of the readings that their names allow: rows of J, directions of indices, the tool."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.ring = checker.exact.ring

    def judge(
        self, implication: Implication, steps: list[Outcome], equation: int, links: list[Implication]
    ) -> Judgement:
        """Return what `_judged` does; what holds with other rows of J or another direction of indices is left open."""
        judged = self._judged(implication, steps, equation, links)
        if judged is None:
            return None
        if (left_open := self.checker.angles.of_condition(implication.chains)) is not None:
            return judged[0].left_open(left_open), {}
        sizes = [sizes_of_convention(judged[0], chain, self.names) for chain in implication.chains]
        if judged[0].verdict is Verdict.REFUTED and any(sizes):
            return judged[0].left_open(next(filter(None, sizes))), {}
        if judged[0].verdict is Verdict.REFUTED and not self._is_of_same_letters(implication):
            return judged[0].left_open(say(Kind.NO_ARM_TO_COMPARE)), {}
        if judged[0].verdict is Verdict.REFUTED and (own := self._printed_once()) is not None:
            return judged[0].left_open(say(Kind.RESTS_ON_DOUBT, name=own[0], line=own[1])), {}
        if judged[0].verdict is Verdict.REFUTED and self._may_be_out_of_range(implication, equation):
            return judged[0].left_open(say(Kind.BEYOND_STOPS)), {}
        again = partial(self._judged, implication, steps, equation, links)
        doubt = self.checker.rows.others(implication.chains, [judged[0]], lambda: [(again() or judged)[0]])
        if judged[0].verdict in DECIDED:
            readings, verdict = self.checker.readings, judged[0].verdict
            doubt = doubt or readings.other_direction(
                implication.chains, hold([judged[0]]), lambda: hold([(again() or judged)[0]])
            )
            doubt = doubt or readings.of_either_frame(
                implication.chains, verdict, lambda: (again() or judged)[0].verdict
            )
        if doubt is None and judged[0].verdict is Verdict.PROVED and (name := self._holds_without(implication)):
            doubt = say(Kind.HOLDS_WITHOUT, name=name)
        return (judged[0].left_open(doubt), {}) if doubt is not None else judged

    def _holds_without(self, implication: Implication) -> str:
        """Return the Jacobian of no point that is told, of which all that is concluded holds under no condition: θ_3 = π/2 ⇒ det J = 0, where it always is."""
        if implication.arrow == "⇔" or self.names.arm is None:
            return ""
        asked = implication.premises if implication.arrow == "⇐" else implication.conclusions
        bound = [
            name.text or name.key
            for chain in asked
            for member in chain.members
            for name in n.names(member)
            if name.key not in self.names.quantities and not re.search(r"\d", name.sub + name.pre_sub)
            if _is_jacobian(self.names.quantity(name))
        ]
        return bound[0] if bound and all(map(self._is_identity, asked)) else ""

    def _is_identity(self, chain: n.Chain) -> bool:
        values = [as_scalar(self.checker.member(node).value) for node in chain.members]
        scalars = [value for value in values if isinstance(value, Scalar)]
        return len(scalars) == len(values) and all((a - b).normal().is_zero() for a, b in pairwise(scalars))

    def _is_of_same_letters(self, implication: Implication) -> bool:
        """Whether, without an arm, all that is concluded is of letters that both sides hold, but for those of what is given.

        θ = 0 ⇒ x = l says what x is there.
        """
        if self.names.arm is not None:
            return True
        sides = (implication.premises, implication.conclusions)
        asked = sides[implication.arrow != "⇐"]
        held = [{key for c in side for m in c.members for key in letters_held(m, self.names)} for side in sides]
        return all(
            len({frozenset(letters_held(m, self.names) - given - {*WHOLE_NUMBERS}) for m in chain.members}) == 1
            and any(letters_held(m, self.names) & given for m in chain.members)
            for side, given in zip(sides, reversed(held), strict=True)
            for chain in side
            if side is asked or implication.arrow == "⇔"
        )

    def _may_be_out_of_range(self, implication: Implication, equation: int) -> bool:
        """Whether joints are said to have stops, and one side follows from the other: what it leaves out may lie beyond them."""
        if not self.names.state.limits_joints or implication.kind == "if":
            return False
        with self.ring.budget.paused():
            from armproof.verification.conditions.judgement import check_implication
        ways = (replace(implication, kind=kind) for kind in ("⇒", "⇐"))
        return any(check_implication(self.checker, each, equation)[0].verdict is Verdict.PROVED for each in ways)

    def _printed_once(self) -> Key | None:
        """Return the Jacobian that a document without an arm prints, and of which nothing holds yet: it may hold the slip."""
        state = self.names.state
        doubted = (key for key in state.consulted - state.held if key[0] == "J")
        return None if self.names.arm is not None else min(doubted, default=None)

    def of_the_tool(
        self, implication: Implication, steps: list[Outcome], equation: int, links: list[Implication]
    ) -> Judgement:
        """Return the verdict where an implication holds of the tool's coordinates, as x, y mostly are; else None."""
        if self.names.arm is None:
            return None
        judged = None
        with self.names.state.unchanged() as before:
            self.names.forget(key for outcome in steps for key in outcome.defines if not outcome.is_condition)
            if self.checker.conventions.infer_tool(implication.chains):
                judged = self.judge(implication, [Outcome(Verdict.UNCHECKED)], equation, links)
            before.consulted |= self.names.state.consulted  # what the verdict rests on
        return judged if judged is not None and judged[0].verdict in HOLDS else None

    def beside(self, judged: Judgement, implication: Implication, above: list[Implication], equation: int) -> Judgement:
        """Leave open what does not follow from its own line, where it may from those above: the lines of one system."""
        if judged is None or judged[0].verdict is not Verdict.REFUTED or not above:
            return judged
        chains = [chain for each in above for chain in each.chains]
        with self.ring.budget.paused():
            from armproof.verification.conditions.judgement import check_implication
        wider = replace(implication, before=[[*chains, *each] for each in implication.before])
        again = check_implication(self.checker, wider, equation)[0]
        return judged if again.verdict is Verdict.REFUTED else (judged[0].left_open(say(Kind.UNDER_MORE)), {})

    def _judged(
        self, implication: Implication, steps: list[Outcome], equation: int, links: list[Implication]
    ) -> Judgement:
        """Return the verdict of an implication and its counterexample, or None where its premises are claims themselves."""
        premises, conclusions = implication.premises, implication.conclusions
        holds = not any(
            o.verdict in (Verdict.REFUTED, Verdict.UNCHECKED) or o.is_condition or o.holds_there for o in steps
        )
        holds = holds and not (self.names.arm is None and any(map(is_condition, premises)))  # α = 90° defines no α
        if implication.kind != "if" and holds and not any(is_rank_condition(chain) for chain in premises):
            return None  # what holds everywhere is no premise: what follows is a claim itself
        with self.ring.budget.paused():  # few documents hold one: the import is none of its time
            from armproof.verification.conditions.judgement import check_implication, check_value, states_condition

        if implication.kind == "if":
            has_value = check_value(self.checker, implication, equation)
            if has_value is not None and len(steps) == 1:
                is_wrong = steps[0].verdict is Verdict.REFUTED  # and then so where the divisor is not zero
                return (steps[0] if is_wrong or has_value.verdict is Verdict.PROVED else has_value), {}
            self.names.forget(key for outcome in steps for key in outcome.defines)  # what it means there alone
            return check_implication(self.checker, implication, equation, links)
        if links or any(states_condition(self.checker, chain) for chain in premises):
            return check_implication(self.checker, implication, equation, links)
        values = (self.checker.member(node).value for chain in premises for node in chain.members)
        if not all(is_condition(chain) for chain in conclusions) or any(hasattr(value, "rows") for value in values):
            return None  # a step between matrices
        judged = check_implication(self.checker, implication, equation, links)
        of_arm = any(self.checker.quantity_of(below) for chain in premises for below in n.walk(chain))
        if judged[0].verdict is Verdict.PROVED and of_arm and any(o.verdict is Verdict.REFUTED for o in steps):
            return replace(judged[0], verdict=Verdict.UNCHECKED, findings=(say(Kind.PREMISE_DIFFERS),)), {}
        return judged if judged[0].verdict is not Verdict.UNCHECKED else None


def _is_jacobian(quantity: object) -> bool:
    return isinstance(quantity, Quantity) and quantity.kind == "jacobian"
