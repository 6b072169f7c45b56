"""What an equation claims, with the definitions that it rests on: a doubtful one decides nothing."""

from __future__ import annotations

from collections.abc import Set
from functools import partial

from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.display.chain_readings import ChainReadings
from armproof.verification.display.decision import Decision
from armproof.verification.display.taken_arm import names_in
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.doubts import is_of_arm
from armproof.verification.equations.elementary import axis_of_another_frame
from armproof.verification.equations.given_targets import asked_of_the_tool
from armproof.verification.equations.named_signs import unless_of_a_sign
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.state import Key
from armproof.verification.verdict import DECIDED, HOLDS, Verdict


class Claims:
    """What equations claim, each in the readings that it allows, and what leaves open what one of them decides."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.decision = Decision(checker)
        self.readings = ChainReadings(self.decision)

    @property
    def circumstances(self) -> Circumstances:
        """Heeds what the text between displays says."""
        return self.decision.circumstances

    def chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain, each with the definitions that it rests on."""
        self.begin()
        outcomes = self.readings.outcomes(chain, equation, line, define)
        again = partial(self.readings.outcomes, chain, equation, line, False)
        if self.names.state.signs.read:
            outcomes = unless_of_a_sign(self.names, outcomes, again)
        if self.names.state.given():
            outcomes = asked_of_the_tool(self.names, outcomes, again)
        if self.names.offset_joints:
            outcomes = self.checker.angles.settled(chain, outcomes, define, again)
        of_jacobian = self.checker.members.speaks_of_jacobian(chain)
        if of_jacobian and (doubt := self.checker.rows.others((chain,), outcomes, again)) is not None:
            outcomes = [outcome.left_open(doubt) for outcome in outcomes]
        if not chain.relations and not outcomes:
            return [] if _is_label(chain) else [Outcome(Verdict.DEFINED, (say(Kind.NO_EQUATION),), equation)]
        outcomes = [self._of_own_sums(outcome, chain) for outcome in outcomes]
        if any(isinstance(below, n.Dots) for below in n.walk(chain)):
            unwritten = say(Kind.TERMS_UNWRITTEN, text="…")
            outcomes = [each.unless_refuted(unwritten) for each in outcomes]
        if not n.letters(chain).isdisjoint(AXES) and (doubt := axis_of_another_frame(chain)) is not None:
            outcomes = [each.left_open(doubt) if each.verdict in HOLDS else each for each in outcomes]
        foreign = self.names.state.foreign()
        for outcome in outcomes if foreign else ():
            if outcome.verdict is Verdict.REFUTED:
                other = say(Kind.OTHER_EXERCISE, name=foreign[0][0], line=foreign[0][1])
                outcome.verdict, outcome.findings = Verdict.UNCHECKED, (other,)
        own = {key for outcome in outcomes for key in outcome.defines}
        outcomes = [self.unless_doubted(outcome, _defined_beside(outcome, own, line)) for outcome in outcomes]
        if by_table := self.names.state.from_table():
            doubt = say(Kind.ENTRY_BY_INDEX, name=by_table[0])
            outcomes = [each.unless_slip(doubt) for each in outcomes]
        if (
            text := self.names.state.from_text()
        ):  # it may speak of one case: only a slip in what follows from it is refuted
            outcomes = [each.unless_slip(say(Kind.AS_TEXT_SAYS, name=text[0])) for each in outcomes]
        defined = {(key, line) for outcome in outcomes for key in outcome.defines}
        for outcome in outcomes:  # c_3 = … := D names what is decided beside it
            met = {key for key in self.consulted() if key[0] not in outcome.defines and key != outcome.repeats}
            outcome.uses = frozenset(met | defined if outcome.verdict in DECIDED else met)
            if define and outcome.verdict in HOLDS:
                self.names.state.held |= outcome.uses
        return outcomes

    def unless_doubted(self, outcome: Outcome, beside: Set[Key] = frozenset()) -> Outcome:
        """Leave open what a definition that may be a mistake decides: it proves nothing, and may be the mistake itself.

        What is only defined beside it, R of R = R_z(φ) R_y(θ) = […], is none of its sides. The last of two meanings is no mistake where a joint or a quantity of the arm is what it then says.
        """
        if outcome.verdict not in DECIDED or self.decision.is_closed:
            return outcome
        doubted = [key for key in self.names.state.doubted() if key not in beside]
        of_two = self.names.state.with_two_meanings()
        if of_two and (outcome.verdict is Verdict.REFUTED or not is_of_arm(outcome, self.names)):
            doubted = doubted or of_two
        if not doubted:
            return outcome
        kind = Kind.RESTS_ON_DOUBT if outcome.verdict is Verdict.REFUTED else Kind.FOLLOWS_FROM_DOUBT
        return outcome.left_open(say(kind, name=doubted[0][0], line=doubted[0][1]))

    def begin(self) -> None:
        """Forget what was consulted: what follows is another equation."""
        self.names.state.forget_consulted()

    def consulted(self) -> frozenset[tuple[str, int]]:
        """Return the definitions and the named signs that were met since the last beginning."""
        signs = self.names.state.signs
        return frozenset(self.names.state.consulted) | {(key, signs.lines.get(key, 0)) for key in signs.read}

    def _of_own_sums(self, outcome: Outcome, chain: n.Chain) -> Outcome:
        """A θ_{34} that the document says to be θ_3 - θ_4 is what it says: that is no claim, and what then fails is left open."""
        digits = next(filter(None, map(self.names.own_sum, n.walk(chain))), "")
        alone = [each.arguments[0] if isinstance(each, n.Call) else each for each in map(bare, chain.members)]
        says_so = any(self.names.own_sum(each) for each in alone)
        if not digits or not (outcome.verdict is Verdict.REFUTED or (says_so and outcome.verdict is Verdict.PROVED)):
            return outcome
        return outcome.left_open(say(Kind.OWN_SUM, digits=digits))


def _defined_beside(outcome: Outcome, own: Set[str], line: int) -> Set[Key]:
    """Return what a chain defines that is on no side of one of its equations."""
    return {(key, line) for key in own - {name.key for name in names_in(outcome)}} if own else frozenset()


def _is_label(chain: n.Chain) -> bool:
    """Whether a number in brackets stands alone, as equations are numbered: (3)."""
    (member,) = chain.members
    return isinstance(member, n.Group) and isinstance(member.inner, n.Number)
