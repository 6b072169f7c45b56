"""What is left open because the text tells a task, locks a joint, or builds the arm otherwise than above."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.amended_tables import AMENDED
from armproof.verification.document.locked_joints import LOCKED
from armproof.verification.document.told_builds import (
    COUNTED_FROM_ONE,
    FROM_TOOL,
    JOINTS_FROM_ZERO,
    OTHER_BUILD,
    TURNED_ROUND,
)
from armproof.verification.document.told_tasks import TASK_BY_RATES
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import DECIDED, Verdict

_OF_FRAMES = (*"pPoOTAHRzZxyXYvVJ", "omega")  # what bears the number of a frame


def is_of_other_build(meant: Sequence[str]) -> bool:
    """Whether a display is of an arm that the text builds otherwise, or whose table it amends."""
    return OTHER_BUILD in meant or FROM_TOOL in meant or any(each.startswith((AMENDED, TURNED_ROUND)) for each in meant)


class ToldOtherwise:
    """Leaves open what rests on an arm, rows or rates that the text tells otherwise."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names

    def judge(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is decided of what the text tells otherwise."""
        if outcome.verdict not in DECIDED or self.names.arm is None:
            return outcome
        if OTHER_BUILD in meant or FROM_TOOL in meant:
            return outcome.left_open(say(Kind.OF_OTHER_ARM))
        if (amended := next((each for each in meant if each.startswith(AMENDED)), None)) is not None:
            return outcome.left_open(say(Kind.TABLE_AMENDED, text=amended.removeprefix(AMENDED).strip()))
        if COUNTED_FROM_ONE in meant and (counted := next(self._of_frames(outcome), None)) is not None:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=counted))
        if JOINTS_FROM_ZERO in meant and (counted := next(self._of_joints(outcome), None)) is not None:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=counted))
        if (turned := self._turned_in(outcome, meant)) is not None:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=turned))
        is_refuted = outcome.verdict is Verdict.REFUTED
        if self._locks(meant) and (self._rests_on_rates(outcome) or (is_refuted and self._may_hold_locked(outcome))):
            return outcome.left_open(say(Kind.IS_SUPPOSED))
        return self._in_rows_of_task(outcome, any(each.startswith(f"{TASK_BY_RATES} ") for each in meant))

    def _of_frames(self, outcome: Outcome) -> Iterator[str]:
        for node in (*outcome.nodes, *outcome.conditions):
            for name in n.names(node):
                scripts = f"{name.sub}{name.sup}{name.pre_sup}{name.pre_sub}"
                if name.base in _OF_FRAMES and re.search(r"\d", scripts):
                    yield name.key

    def _of_joints(self, outcome: Outcome) -> Iterator[str]:
        """Yield what stands in an equation and bears the number of a joint."""
        for below in (each for node in (*outcome.nodes, *outcome.conditions) for each in n.walk(node)):
            if isinstance(below, n.JointAngles):
                yield from (f"theta_{index}" for _, index in below.terms)
            elif isinstance(below, n.Name) and re.search(r"\d", below.sub):
                yield below.key

    def _turned_in(self, outcome: Outcome, meant: Sequence[str]) -> str | None:
        """Return a joint that is turned round, and that what is decided rests on; None without one."""
        told = [each.removeprefix(TURNED_ROUND).strip() for each in meant if each.startswith(TURNED_ROUND)]
        turned = {joint for each in told for joint in self._joints(each)}
        if not turned:
            return None
        written = {below.undotted.key for node in (*outcome.nodes, *outcome.conditions) for below in n.names(node)}
        written |= {each.rpartition(" ")[2] for each in _symbols(outcome.pair)}
        known = {self.names.known_symbol(each) or each for each in written}
        rests = turned & known
        if not rests and outcome.pair is None and any(self.names.quantity(n.Name(each)) for each in written):
            rests = turned  # det J = 0 ⇔ …
        return min(rests, default=None)

    def _joints(self, told: str) -> set[str]:
        arm = self.names.arm
        assert arm is not None
        symbols = [joint.symbol for joint in arm.joints]
        if told.isdecimal():
            return {symbols[int(told) - 1]} if int(told) <= len(symbols) else {*symbols}
        symbol = self.names.known_symbol(self.names.reader.key_of(told))
        return {symbol} if symbol in symbols else {*symbols}

    def _locks(self, meant: Sequence[str]) -> bool:
        """Whether the text holds a joint still: a length of the arm, "$d_2$ is constant", is none."""
        arm, key_of = self.names.arm, self.names.reader.key_of
        lengths = {*arm.lengths} if arm is not None and not self.names.is_of_formulas else set()
        told = (each for each in meant if each.startswith(LOCKED))
        return any(key_of(each.removeprefix(LOCKED).strip()) not in lengths for each in told)

    def _rests_on_rates(self, outcome: Outcome) -> bool:
        """Whether a rate in numbers is worked out with the rates that the text gave before, of which none is zero."""
        before = self.names.state.told
        told = [*before.velocities, *(each for each in before.standing if any(map(n.has_rates, each.members)))]
        if not told or not any(map(n.has_rates, outcome.nodes)) or not any(map(n.is_number, outcome.nodes)):
            return False
        return not any(isinstance(each, n.Number) and not each.value for chain in told for each in chain.members)

    def _may_hold_locked(self, outcome: Outcome) -> bool:
        """Whether a refuted equation holds where some joints stand still: one, or all but one."""
        pair = outcome.pair
        if pair is None:
            return any(map(n.has_rates, outcome.nodes))
        apart = [each.normal() for each in pair.differences()]
        rates = {each for each in symbols_in(apart) if " " in each}
        if not rates or pair.true.shape != pair.printed.shape:
            return bool(rates)
        nought = self.checker.exact.ring.rational(0)
        joints = {*self.names.joints}
        sets = [each for joint in joints for each in ({joint}, joints - {joint})]
        still = [{rate: nought for rate in rates if rate.rpartition(" ")[2] in held} for held in sets if held]
        return any(all(substitute(each, held).normal().is_zero() for each in apart) for held in still)

    def _in_rows_of_task(self, outcome: Outcome, are_listed: bool) -> Outcome:
        """Leave open what is said of J where the rows of a task are not known, or stand in another order than the text has its coordinates.

        Where it lists the rows by their rates, they stand in that order.
        """
        rows = self.names.state.task_rows
        members = self.checker.members
        below = [each for node in (*outcome.nodes, *outcome.conditions) for each in n.walk(node)]
        name = next((each for each in below if isinstance(each, n.Name) and members.jacobian_name(each, True)), None)
        if rows is None or name is None:
            return outcome
        if rows == () or (outcome.verdict is Verdict.REFUTED and not are_listed and _are_permuted(outcome.pair)):
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=name.key))
        return outcome


def _symbols(pair: Pair | None) -> set[str]:
    sides = (pair.true, pair.printed) if pair is not None else ()
    return {*symbols_in(cell for side in sides for cell in side.cells if isinstance(cell, Scalar))}


def _are_permuted(pair: Pair | None) -> bool:
    """Whether what is printed has the rows of what is true in another order, one for one."""
    if pair is None or pair.true.shape != pair.printed.shape:
        return False
    rows = [[as_one(cell) for cell in row] for row in pair.true.rows]
    for row in pair.printed.rows:
        found = next((each for each in rows if _are_equal(each, [as_one(cell) for cell in row])), None)
        if found is None:
            return False
        rows.remove(found)
    return len(pair.true.rows) > 1


def as_one(cell: object) -> Scalar | None:
    """Return a cell where it is a scalar."""
    return cell if isinstance(cell, Scalar) else None


def _are_equal(one: Sequence[Scalar | None], other: Sequence[Scalar | None]) -> bool:
    return all(a is not None and b is not None and (a - b).normal().is_zero() for a, b in zip(one, other, strict=True))
