"""What rests in a chain on usual meanings alone: where they do not fit, nobody can tell what its author means."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import as_line, kind_of
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


@dataclass
class Doubts:
    """Keeps which names of a chain convention binds, and how sure that is.

    Attributes:
        weak: the names that stand inside formulas of the chain and were bound.
        open: the names that have a usual meaning, and were equated to something else.
    """

    names: Names
    weak: set[str] = field(default_factory=set)
    open: dict[str, Quantity] = field(default_factory=dict)

    def infer(self, key: str, quantity: Quantity) -> None:
        """Give a name a usual meaning."""
        self.names.state.inferred[key] = quantity
        self.names.state.conventional.add(key)

    def forget(self, keys: Iterable[str]) -> None:
        """Take usual meanings back."""
        for key in keys:
            self.names.state.inferred.pop(key, None)
            self.names.state.conventional.discard(key)

    def judge(self, outcome: Outcome) -> Outcome:
        """Leave undecided what rests on a usual meaning that does not fit."""
        if outcome.verdict is not Verdict.REFUTED:
            plain = {key.rpartition(" ")[2] for key in outcome.defines}  # of a rate, the name
            key = min(plain & set(self.open), default="")
            if not key:
                return outcome
            doubt = _unusual(key, self.open[key])
            if self.open[key].kind == "difference":  # no equation gives two points another vector
                self.names.leave_open(key, doubt)
            return replace(outcome, verdict=Verdict.UNCHECKED, findings=(doubt,))
        if outcome.true is not None and _is_placed_above(outcome.true.node):  # p_0^2 may place frame 2 in frame 0
            return outcome.left_open(say(Kind.WHICH_INDEX))
        if not self.weak:
            return outcome
        key = min(self.weak)
        quantity = self.names.state.inferred.get(key)
        self.forget(self.weak)
        return outcome.left_open(_unusual(key, quantity) if quantity is not None else say(Kind.NOT_BOUND, name=key))


def _unusual(key: str, quantity: Quantity) -> Finding:
    reading, line = kind_of(quantity).tell(quantity), as_line(key, quantity)
    return say(Kind.NOT_AS_USUAL_BOUND, name=key, reading=reading, line=line)


def _is_placed_above(node: n.Node) -> bool:
    return isinstance(node, n.Name) and node.base in "pPoOd" and node.sup.isdigit() and node.sub.isdigit()
