"""A name that the document has defined and that stands alone before "=" again: said again, or given another meaning."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from armproof.verification.algebra.protocol import Value
from armproof.verification.equations.alignment import is_constant, is_near
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import Role, Verdict

Check = Callable[[n.Chain], list[Outcome]]


class Redefinitions:
    """Judges chains `K = …` about a name K that has been defined by an equation of its own.

    A formula a slip away from the definition is wrong. Another one is a new meaning: in another section K gets it, in the
    same one it is not decided, and neither is what is said of K from there on. What repeats the definition decides nothing.
    """

    def __init__(self, names: Names) -> None:
        self.names = names
        self.enabled = True  # but in the premises of an arrow

    def before(self, chain: n.Chain) -> Definition | None:
        """Return the definition of the name that a chain is about; one with two meanings ends with its section."""
        state = self.names.state
        key = bare_key(chain.members[0]) if len(chain.members) > 1 and self.enabled else None
        definition = state.definitions.get(key) if key is not None else None
        others = (below for member in chain.members[1:] for below in n.walk(member) if isinstance(below, n.Name))
        if key is None or definition is None or definition.by_place or any(other.key == key for other in others):
            return None
        if definition.has_two_meanings and definition.section != state.section:
            del state.definitions[key]
            return None
        return definition

    def judge(self, chain: n.Chain, outcomes: list[Outcome], definition: Definition, check: Check) -> list[Outcome]:
        """Return the outcomes of a chain about a name with a definition; `check` checks another reading of the chain."""
        name = chain.members[0]
        key = str(bare_key(name))
        about = [o for o in outcomes if name in (o.true and o.true.node, o.printed and o.printed.node)]
        if about and all(_is_another_meaning(outcome) for outcome in about):
            return self._with_another_meaning(chain, key, definition, outcomes[0], check)
        for outcome in about:
            sides = [bare(side.node) for side in (outcome.true, outcome.printed) if side is not None]
            if outcome.verdict is Verdict.PROVED and definition.node is not None and bare(definition.node) in sides:
                outcome.verdict, outcome.findings = Verdict.DEFINED, (say(Kind.DEFINES, name=key),)
                outcome.repeats = (key, definition.line)
        return outcomes

    def _with_another_meaning(
        self, chain: n.Chain, key: str, definition: Definition, first: Outcome, check: Check
    ) -> list[Outcome]:
        definitions = self.names.state.definitions
        if definition.section != self.names.state.section:
            del definitions[key]
            return check(chain)
        second = say(Kind.SECOND_MEANING, name=key, line=definition.line)
        definitions[key] = replace(definition, evaluate=_undecided(second), has_two_meanings=True)
        rest = (
            check(replace(chain, members=chain.members[1:], relations=chain.relations[1:]))
            if len(chain.members) > 2
            else []
        )
        for outcome in rest:
            outcome.equation += 1
        return [
            Outcome(Verdict.UNCHECKED, (second,), first.equation, first.true, first.printed, role=Role.DEFINITION),
            *rest,
        ]


def _is_another_meaning(outcome: Outcome) -> bool:
    """Whether two formulas have little in common; a number is a condition or a value, and no meaning."""
    pair = outcome.pair
    numbers = [is_constant(value) for value in (pair.true, pair.printed)] if pair is not None else []
    near = pair is not None and is_near(pair)
    return outcome.verdict is Verdict.REFUTED and not near and not any(numbers)


def _undecided(finding: Finding) -> Callable[[Any], Value]:
    def evaluate(_: Any) -> Value:
        raise EvaluationError(finding)

    return evaluate
