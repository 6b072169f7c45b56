"""What the letter of a joint means whose angle in the DH table has an offset: decided once, by the first equation that tells."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import DECIDED, HOLDS, Record, Verdict

VARIABLE, TABLE, LOOSE = "variable", "table", "loose"


class TableAngles:
    """Tells whether θ_i is the variable of joint i or the angle in row i of the table."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def settled(
        self, chain: n.Chain, outcomes: list[Outcome], define: bool, again: Callable[[], list[Outcome]]
    ) -> list[Outcome]:
        """Return the outcomes in the reading of the document, which an equation decides that holds in one of the two only."""
        if self._is_loose(chain, outcomes, again):
            return [outcome.left_open(say(Kind.ANGLES_TOLD_OTHERWISE, other=VARIABLE)) for outcome in outcomes]
        told = self.names.state.angles
        if not any(each.verdict in DECIDED for each in outcomes) or (told and hold(outcomes)):
            return outcomes
        by_values = not self._rest_on_offset(chain.members)
        if by_values and self.names.offset_joints.keys().isdisjoint(self.names.state.configuration):
            return outcomes
        state = self.names.state
        bound = state.inferred.copy(), state.conventional.copy()
        with self._read_as(VARIABLE if told == TABLE else TABLE) as other:
            second = again()
        bound_again = state.inferred, state.conventional
        state.inferred, state.conventional = bound
        if hold(outcomes) == hold(second) or not any(each.verdict in DECIDED for each in second):
            return outcomes
        if told:
            return [outcome.left_open(say(Kind.ANGLES_TOLD_OTHERWISE, other=other)) for outcome in outcomes]
        if by_values:  # a number is no evidence of what the letters mean
            return outcomes if hold(outcomes) else [outcome.left_open(say(Kind.ANGLES_UNTOLD)) for outcome in outcomes]
        if define:
            self.names.state.angles = VARIABLE if hold(outcomes) else TABLE
        if hold(outcomes):
            return outcomes
        for outcome in second:
            outcome.also(say(Kind.TABLE_ANGLES))
        state.inferred, state.conventional = bound_again
        return second

    def _is_loose(self, chain: n.Chain, outcomes: list[Outcome], again: Callable[[], list[Outcome]]) -> bool:
        """Whether an equation is wrong of the table's angles, and would be right if θ_i meant q_i: nobody says it does not."""
        keys = {below.key for below in n.names(chain)}
        symbols = {key: symbol for key in keys if (symbol := self.names.known_symbol(key)) is not None}
        angles = [key for key, symbol in symbols.items() if key != symbol and self.names.table_row(symbol, key)]
        refuted = any(each.verdict is Verdict.REFUTED for each in outcomes)
        if not refuted or not angles or self.names.reader.spelling.variables != "both":
            return False
        state = self.names.state
        bound = state.inferred.copy(), state.conventional.copy()
        with self._read_as(LOOSE):
            found = all(each.verdict in HOLDS for each in again())
        state.inferred, state.conventional = bound
        return found

    def of_condition(self, chains: Iterable[n.Chain]) -> Finding | None:
        """Say that a condition on a table's angle is not decided: conditions are solved for the variables.

        A θ_1 where the arm's variable is q_1 may be either, as long as no equation tells.
        """
        chains, told = tuple(chains), self.names.state.angles
        if told == TABLE:
            return say(Kind.CONDITION_ON_TABLE_ANGLE) if self.holds_offset(chains) else None
        untold = not told and any(map(self._is_untold, (below for chain in chains for below in n.names(chain))))
        return say(Kind.CONDITION_ON_TABLE_ANGLE) if untold else None

    def _is_untold(self, name: n.Name) -> bool:
        """Whether a letter of an angle stands for a joint of another letter whose row has an offset, and nothing tells which it means."""
        symbol = self.names.known_symbol(name.key)
        is_other = symbol in self.names.offset_joints and name.key != symbol
        return is_other and symbol is not None and self.names.table_row(symbol, name.key) is None

    def holds_offset(self, chains: Iterable[n.Chain]) -> bool:
        """Whether the letter of a joint with an offset stands in an equation."""
        joints = self.names.offset_joints
        return bool(joints) and any(symbol in joints for chain in chains for symbol in self._letters(chain))

    def _rest_on_offset(self, nodes: Sequence[n.Node]) -> bool:
        """Whether the letter of a joint with an offset stands in formulas, or in what defines their names: x = r c_1."""
        made = self.names.state.definitions
        formulas = [made[name.key].formula for node in nodes for name in n.names(node) if name.key in made]
        return self.holds_offset([n.Chain((each,), ()) for each in (*nodes, *formulas) if each is not None])

    def entries_of_table(self, outcome: Outcome) -> int:
        """Return how many entries of an equation hold with the letter of a joint with an offset read as the angle of its row."""
        is_read_so = self.names.state.angles == TABLE and outcome.verdict in HOLDS
        if not is_read_so or not self._rest_on_offset(outcome.nodes) or outcome.true is None:
            return 0
        value = outcome.true.value
        cells = value.cells if isinstance(value, Matrix) else (value,)
        joints = self.names.offset_joints.keys()
        return sum(isinstance(each, Scalar) and not joints.isdisjoint(symbols_in([each])) for each in cells) or 1

    def _letters(self, chain: n.Chain) -> Iterator[str | None]:
        for below in n.walk(chain):
            if isinstance(below, n.Name):
                yield self.names.known_symbol(below.key)
            elif isinstance(below, n.JointAngles):
                yield from (self.names.joint_angle(index) for _, index in below.terms)

    @contextmanager
    def _read_as(self, meaning: str) -> Iterator[str]:
        before, self.names.state.angles = self.names.state.angles, meaning
        try:
            yield meaning
        finally:
            self.names.state.angles = before


def settle_angles(records: Sequence[Record]) -> tuple[Record, ...]:
    """Return the records of a document; the one entry that holds with the angles of the table, θ_2 for θ_2 + 90°, is left open: it may be a slip."""
    if sum(each.of_table for record in records for each in record.outcomes) != 1:
        return tuple(records)
    doubt = say(Kind.TABLE_ANGLES_ONCE)
    return tuple(record.left_open(doubt, lambda one: one.of_table > 0) for record in records)
