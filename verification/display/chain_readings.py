"""The ways in which an equation may be read: a/2b, two equations side by side, a relation, numbers of a value; and what only states something."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from math import remainder, tau

from armproof.verification.algebra.ring import Scalar
from armproof.verification.display.decision import Decision
from armproof.verification.equations.case_conditions import check_cases
from armproof.verification.equations.differentials import of_small_ones
from armproof.verification.equations.general_links import is_sum_of_indices
from armproof.verification.equations.given_values import named_sign
from armproof.verification.equations.inequalities import check_relation, parts_of
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.equations.readings import counted, side_by_side, without_count
from armproof.verification.equations.vectors import crossed_letters, of_vectors
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, is_number
from armproof.verification.verdict import DECIDED, HOLDS, Role, Verdict

CLOSE = 1e-9  # so near are angles that are the same


class ChainReadings:
    """Decides chains in each way that they may be read."""

    def __init__(self, decision: Decision) -> None:
        self.decision = decision
        self.checker, self.names, self.given = decision.checker, decision.names, decision.given

    def outcomes(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain in the reading in which it holds."""
        unclear = [below for below in n.walk(chain) if isinstance(below, n.Ambiguous)]
        if unclear:
            return self._either_reading(chain, unclear, equation, line, define)
        if self.names.arm is None and (letters := crossed_letters(self.names, chain)):
            check = partial(self._clear_chain, chain, equation, line)
            return of_vectors(self.names, chain, letters, line, define, check)
        if parts := side_by_side(chain):
            return self._side_by_side(chain, parts, equation, line, define)
        return self._clear_chain(chain, equation, line, define)

    def _side_by_side(
        self, chain: n.Chain, parts: Sequence[n.Chain], equation: int, line: int, define: bool
    ) -> list[Outcome]:
        """A = […] B = […] is two equations, unless it holds as one: what is wrong in one reading alone is left open."""
        as_one = self._clear_chain(chain, equation, line, False)
        if hold(as_one):
            return self._clear_chain(chain, equation, line, define)
        apart = [o for k, part in enumerate(parts) for o in self._clear_chain(part, equation + k, line, define)]
        if any(outcome.verdict is Verdict.REFUTED for outcome in as_one):
            return apart
        doubt = say(Kind.SIDE_BY_SIDE, name=parts[1].members[0].text)  # type: ignore[attr-defined]
        return [outcome.unless_refuted(doubt) for outcome in apart]

    def _either_reading(
        self, chain: n.Chain, unclear: list[n.Ambiguous], equation: int, line: int, define: bool
    ) -> list[Outcome]:
        """Take the reading of a/2b under which the equation holds; the message names the choice."""
        chains = []
        for k in (0, 1):
            read = chain
            for below in unclear:
                read = n.substitute(read, below, below.readings[k])  # type: ignore[assignment]
            chains.append(read)
        tried = [self._clear_chain(read, equation, line, False) for read in chains]
        good = [all(o.verdict not in (Verdict.REFUTED, Verdict.UNCHECKED) for o in outcomes) for outcomes in tried]
        chosen = 1 if good[1] and not good[0] else 0
        outcomes = self._clear_chain(chains[chosen], equation, line, define)
        whole = isinstance(unclear[0].readings[chosen], n.Quotient)
        choice = Kind.SLASH_OVER_ALL if whole else Kind.SLASH_OVER_NEXT
        for outcome in outcomes:
            outcome.also(say(choice if any(good) else Kind.SLASH_UNCLEAR, text=unclear[0].text))
        return outcomes

    def _clear_chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if (plain := without_count(chain, self.names)) is not None:
            outcomes = self._clear_chain(plain, equation, line, False)
            if outcomes and all(outcome.verdict in HOLDS for outcome in outcomes):
                outcomes[0].also(say(Kind.COUNTS_SOLUTIONS))
                self.decision.of(chain, equation, line, define)  # what is said of that solution from here on
                return outcomes
        if (said := self._stated(chain, equation, line, define)) is not None:
            return [said, *self._numbers_behind(chain, said, equation, line)]
        if any(relation != "=" for relation in chain.relations):
            parts = [(equation + at, part) for at, part in parts_of(chain)]
            return [outcome for number, part in parts for outcome in self._related(part, number, line, define)]
        if any(isinstance(member, n.Cases) for member in chain.members):
            return check_cases(self.checker, chain, equation, line, define)
        return self.decision.of(chain, equation, line, define)

    def _stated(self, chain: n.Chain, equation: int, line: int, define: bool) -> Outcome | None:
        """Return what becomes of a chain that claims nothing: a sign, a configuration, a condition, a doubt; else None."""
        sign = named_sign(chain)
        if sign is not None and self.names.defines_sign(sign):
            if define:
                self.names.state.signs.name(sign, line)
            return Outcome(Verdict.DEFINED, (say(Kind.SIGN, name=sign),), equation, defines=(sign,))
        if any(relation != "=" for relation in chain.relations):
            return None
        if isinstance(bare(chain.members[-1]), n.Call) and is_sum_of_indices(chain):
            return Outcome(Verdict.PROVED, (), equation, role=Role.LAW)
        if (doubt := counted(chain, self.names)) is not None:
            return Outcome(Verdict.UNCHECKED, (doubt,), equation)
        if (given := self.given.read(chain, line, define)) is not None:
            return Outcome(Verdict.DEFINED, (say(Kind.CONFIGURATION),), equation, defines=given)
        if not self.given.is_condition(chain):
            return None
        if (known := self._holds_there(chain, equation, line)) is not None:
            return known
        if define:
            self._relate(chain, line)
        return Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)

    def _holds_there(self, chain: n.Chain, equation: int, line: int) -> Outcome | None:
        """Return θ_1 + θ_2 = π/2 as a claim behind values of θ_1 and θ_2 with which it holds: it ends no configuration."""
        symbols = {
            self.names.known_symbol(each.key) for m in chain.members for each in n.walk(m) if isinstance(each, n.Name)
        }
        if len(chain.members) != 2 or not symbols & set(self.given.joints) <= self.names.state.configuration.keys():
            return None
        outcomes = self.checker.check(chain, equation, line, define=False)
        return outcomes[0] if [each.verdict for each in outcomes] == [Verdict.CONFIRMED] else None

    def _relate(self, chain: n.Chain, line: int) -> None:
        """Keep what joints, or lengths, are said to be: l_1 = l_2, of which l may be the letter."""
        related = self.given.related(chain)
        if not related:
            return
        self.decision.circumstances.text.of_display(
            replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1))
        )
        for letter in (bare_key(each) for each in chain.members if each not in related):
            self.names.define(str(letter), self.checker.members.meaning(related[0]), line, node=related[0])

    def _numbers_behind(self, chain: n.Chain, said: Outcome, equation: int, line: int) -> list[Outcome]:
        """θ_1 = atan2(1, 0) = 90°: the numbers of a value that is given are to be equal."""
        if len(chain.members) < 3 or said.role is not Role.CLAIM or not all(map(is_number, chain.members[1:])):
            return []
        found = self.unequal(chain, 1, equation, line)
        return [each for each in found if not (self.given.places_joints(chain) and self._are_turns_apart(each))]

    def unequal(self, chain: n.Chain, first: int, equation: int, line: int) -> list[Outcome]:
        """Return what is refuted among the numbers from a member on."""
        rest = replace(chain, members=chain.members[first:], relations=chain.relations[first:])
        found = self.decision.of(rest, equation + first, line, False)
        return [each for each in found if each.verdict is Verdict.REFUTED]

    def _are_turns_apart(self, outcome: Outcome) -> bool:
        """Whether two numbers are the same angle: -90° = 270°."""
        pair = outcome.pair
        return pair is not None and pair.is_scalar and self._is_turn(pair.true.rows[0][0] - pair.printed.rows[0][0])

    def _is_turn(self, apart: Scalar) -> bool:
        return abs(remainder(self.checker.members.number(apart), tau)) < CLOSE

    def _related(self, part: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if part.relations[0] == "=":
            return self._clear_chain(part, equation, line, define)
        if (small := of_small_ones(part, self.names)) is not None:
            near = self.decision.of(small, equation, line, False)
            if all(each.verdict in DECIDED for each in near):
                near[0].also(say(Kind.FIRST_ORDER))
                return near
        return [check_relation(self.checker, part, equation)]
