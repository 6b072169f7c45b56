"""What rests in a chain on usual meanings alone: where they do not fit, nobody can tell what its author means."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import as_line, kind_of
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


@dataclass
class Doubts:
    """Keeps which names of a chain convention binds, and how sure that is.

    Attributes:
        weak: the names that stand inside formulas of the chain and were bound.
        open: the names that have a usual meaning, and were equated to something else.
        tried: these names alone, with the values that they would have.
    """

    names: Names
    weak: set[str] = field(default_factory=set)
    open: dict[str, Quantity] = field(default_factory=dict)
    tried: dict[str, Member] = field(default_factory=dict)

    def judge(self, outcome: Outcome) -> Outcome:
        """Leave undecided what rests on a usual meaning that does not fit: a weak one where it is refuted, else an open one."""
        if outcome.verdict is not Verdict.REFUTED:
            plain = {key.rpartition(" ")[2] for key in outcome.defines}  # of a rate, the name
            key = min(plain & set(self.open), default="")
            if not key:
                return outcome
            doubt = _unusual(key, self.open[key])
            if self.open[key].kind == "difference":  # no equation gives two points another vector
                self.names.leave_open(key, doubt)
            for defined in outcome.defines:
                self.names.doubt(defined)
            return replace(outcome, verdict=Verdict.UNCHECKED, findings=(doubt,))
        key = min(self.weak)
        inferred = self.names.state.inferred
        meanings = {name: inferred[name] for name in self.weak if name in inferred}
        quantity = meanings.get(key)
        self.names.state.forget_usual(self.weak)
        if quantity is None:
            return outcome.left_open(say(Kind.NOT_BOUND, name=key))
        return replace(outcome.left_open(_unusual(key, quantity)), as_usual=AsUsual(outcome, meanings))


def is_of_arm(outcome: Outcome, names: Names) -> bool:
    """Whether one side of an equation is a joint or a quantity of the arm, alone."""
    alone = [each for node in outcome.nodes if isinstance(each := bare(node), n.Name)]
    return any(
        names.known_symbol(name.key) in names.joints or names.quantity(name.undotted) is not None for name in alone
    )


def _unusual(key: str, quantity: Quantity) -> Finding:
    reading, line = kind_of(quantity).tell(quantity), as_line(key, quantity)
    return say(Kind.NOT_AS_USUAL_BOUND, name=key, reading=reading, line=line)
