"""The statements of a display, one after the other: equations, relations, cases and implications."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

from armproof.models.errors import together
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.conditions.implication import (
    Implication,
    connectives_among,
    find_implication,
    goes_on,
    is_condition,
    is_under_words,
)
from armproof.verification.conditions.implications import Implications, Judgement
from armproof.verification.conditions.wording import is_alternative, is_concluded, tell_words_that_change
from armproof.verification.equations.any_jacobian import holds_of_any_jacobian
from armproof.verification.equations.at_stated_values import is_mostly_right
from armproof.verification.equations.case_conditions import check_cases
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.compositions import is_composition
from armproof.verification.equations.decimals import is_number
from armproof.verification.equations.differentials import is_of_rates, with_rates
from armproof.verification.equations.doubts import is_of_arm
from armproof.verification.equations.each_joint import holds_for_each_joint
from armproof.verification.equations.elementary import is_elementary_rotation
from armproof.verification.equations.general_links import GeneralStatements, is_sum_of_indices
from armproof.verification.equations.given_targets import asked_of_the_tool
from armproof.verification.equations.given_values import GivenValues, named_sign
from armproof.verification.equations.index_ranges import without_index_range
from armproof.verification.equations.inequalities import check_relation, is_numbers, parts_of
from armproof.verification.equations.misreadings import without_misreading
from armproof.verification.equations.named_signs import unless_of_a_sign
from armproof.verification.equations.outcome import HOLDS, Outcome, hold, with_role
from armproof.verification.equations.readings import counted, side_by_side, without_count
from armproof.verification.equations.series import unless_added, written_out
from armproof.verification.equations.vectors import crossed_letters, of_vectors
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.latex.statements import PREVIOUS
from armproof.verification.latex.vocabulary import ASKED
from armproof.verification.naming.quantities import is_inverse_link
from armproof.verification.naming.state import Told
from armproof.verification.verdict import DECIDED, Role, Verdict

SCRIPTED = re.compile(r"\\?[A-Za-z.…⋯]+(?:\s*[_^]\s*(?:\{[^{}]*\}|[^\\{]))*")  # \sum_{i=1}^{2}
WHOLE = ("Z", "N")  # the sets of k in θ = kπ
FOR_ALL = ("forall", "for all", "for every", "for any", "pour tout", "pour tous")


@dataclass
class _Display:
    """A display whose statements are taken one after the other.

    Attributes:
        latex: in which the nodes have their places.
        equation, index: the number of the next equation, the place of the next statement.
        links: of a chain of arrows: what stands before the arrow at hand has been concluded.
        above: the implications of the lines before.
        under: the implication whose conclusion stands before: what follows it on its line may be one more.
        stated: configurations and conditions, each with the count of the outcomes before it.
        assumed: whether nothing is decided of the conditions before the arrow at hand.
    """

    statements: list[n.Statement]
    line: int
    define: bool
    latex: str
    outcomes: list[Outcome] = field(default_factory=list)
    counterexample: dict[str, float] = field(default_factory=dict)
    equation: int = 1
    index: int = 0
    links: list[Implication] = field(default_factory=list)
    above: list[Implication] = field(default_factory=list)
    under: Implication | None = None
    stated: list[tuple[int, n.Chain]] = field(default_factory=list)
    assumed: bool = False

    @cached_property
    def asked(self) -> list[n.Statement]:
        """The statements, with what is asked for as an equation."""
        return [_asked(statement) for statement in self.statements]

    @cached_property
    def is_connected(self) -> bool:
        """Whether a connective stands among the statements."""
        return any(isinstance(statement, n.Connective) for statement in self.statements)


class Statements:
    """Checks the statements of displays; one that begins with a relation goes on about the subject of the one before.

    Where `is_closed`, all letters have one meaning that is known, as in the answer to a task: none may be meant otherwise.
    """

    is_closed: bool = False

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.ring = checker.exact.ring
        self.given = GivenValues(checker.equality)
        self.implications = Implications(checker)

    @cached_property
    def circumstances(self) -> Circumstances:
        """Heeds what the text between displays says; made where it says something."""
        return Circumstances(self.checker, self.given)

    @cached_property
    def general(self) -> GeneralStatements:
        """Checks what is said of any link; made where something is."""
        return GeneralStatements(self.checker)

    def check(
        self, statements: list[n.Statement], line: int, *, define: bool = True, latex: str = ""
    ) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes of a display's statements and, for a refuted condition, its counterexample.

        `latex` is the display in which the nodes have their places, to quote what is left out.
        """
        if "\\sum" in latex or "\\prod" in latex:
            statements = [written_out(statement, latex, self.names) for statement in statements]
        statements = [
            part
            for statement in self._without_for_all(without_index_range(statements))
            for part in _without_vanishing_end(self._resolve_subject(statement))
        ]
        display = _Display(statements, line, define, latex)
        while display.index < len(statements):
            self.ring.budget.check()
            self._take_next(display)
        self._heed_behind(display)
        if display.is_connected:
            tell_words_that_change(statements, display.outcomes)
        undecided = [each for each in display.outcomes if each.verdict is Verdict.UNCHECKED] if define else []
        for key in (key for outcome in undecided for key in outcome.defines):
            self.names.doubt(key)  # what follows from it is not decided either
        first_chain = next((s for s in statements if isinstance(s, n.Chain)), None)
        if first_chain is not None and define:
            self.names.state.subject = first_chain.members[0]
        return display.outcomes, display.counterexample

    def _take_next(self, display: _Display) -> None:
        statement = display.statements[display.index]
        implication = find_implication(display.asked, display.index) if display.is_connected else None
        if implication is not None:
            self._take_implication(display, implication)
        elif isinstance(statement, n.Chain):
            self._take_chain(display, statement)
        else:
            display.index += 1

    def _take_chain(self, display: _Display, chain: n.Chain) -> None:
        statements, index = display.statements, display.index
        given = dict(self.names.state.configuration)
        is_connected = display.is_connected
        alternative = is_connected and is_alternative(statements, index)
        found = self._claim(chain, display.equation, display.line, display.define and not alternative)
        found = [outcome.unless_refuted(say(Kind.ONE_OF_TWO)) for outcome in found] if alternative else found
        under_words = is_connected and is_under_words(statements, index)
        if under_words or any(map(self.given.places_joints, (each for _, each in display.stated))):
            found = self._without_numbers(found)  # for θ_2 = π/2, w = 0
        if is_connected and is_concluded(statements, index):
            self.names.state.configuration = given  # what is concluded is no data
            found = [each.unless_refuted(say(Kind.UNDER_MORE)) for each in found] if display.assumed else found
        if "\\sum" in display.latex[slice(*chain.span)]:
            found = [unless_added(outcome, self.checker.quantity_of) for outcome in found]
        found = self._concluded_too(display, chain, found)
        if any(outcome.is_condition for outcome in found):
            display.stated.append((len(display.outcomes), chain))
        display.outcomes.extend(with_role(outcome, chain, self.names) for outcome in found)
        self._tell_what_is_left_out(chain, statements, found, display.latex)
        display.equation += len(chain.relations)
        display.index += 1

    def _concluded_too(self, display: _Display, chain: n.Chain, found: list[Outcome]) -> list[Outcome]:
        """θ_2 = 0 ⇒ P_x = (l_1 + l_2) c_1, P_y = (l_1 + l_2) s_1: what does not hold everywhere may be a second conclusion."""
        statements, index, under = display.statements, display.index, display.under
        follows = index and isinstance(before := statements[index - 1], n.Chain) and chain.relations
        if under is None or not follows or "\\\\" in display.latex[before.span[1] : chain.span[0]]:
            display.under = None
            return found
        if all(outcome.verdict in HOLDS for outcome in found):
            return found
        wider = replace(under, before=[[chain]]) if under.kind == "if" else replace(under, behind=[[chain]])
        judged = self.implications.of_the_tool(wider, found, display.equation, display.links)
        self.names.forget(key for outcome in found for key in outcome.defines)  # what a name means there alone
        judged = judged or self.implications.judge(wider, [Outcome(Verdict.UNCHECKED)], display.equation, [])
        if judged is not None and judged[0].verdict in HOLDS:
            return [replace(self._unless_doubted(judged[0]), role=Role.CONDITION)]
        is_wrong = judged is not None and judged[0].verdict is Verdict.REFUTED and not self.names.has_tool
        return found if is_wrong else [outcome.unless_refuted(say(Kind.UNDER_MORE)) for outcome in found]

    def _take_implication(self, display: _Display, implication: Implication) -> None:
        given, told = dict(self.names.state.configuration), self.names.state.told
        compared = [*self.names.state.comparisons]
        implication = implication.with_each(self.checker.rows.choose)
        self.checker.conventions.take_coordinates(implication.chains)
        premises = implication.premises
        self.checker.redefinitions.enabled = False
        steps = [self._chain(chain, display.equation, display.line, display.define) for chain in premises]
        self.checker.redefinitions.enabled = True
        if self.names.arm is None:  # θ_1 = θ_2 = 0 gives no letter a meaning: it is a condition
            given_here = zip(premises, steps, strict=True)
            self.names.forget(
                key for chain, found in given_here if is_condition(chain) for o in found for key in o.defines
            )
        moved, self.names.state.told = self.names.state.told, told
        self._begin()
        premised = [outcome for found in steps for outcome in found]
        judged = self.implications.judge(implication, premised, display.equation, display.links)
        judged = self.implications.beside(judged, implication, display.above, display.equation)
        if judged is None or judged[0].verdict is Verdict.UNCHECKED:
            of_the_tool = self.implications.of_the_tool(implication, premised, display.equation, display.links)
            judged = of_the_tool or judged
        if judged is None or judged[0].verdict not in HOLDS:
            there = self.circumstances.at_premised(implication, display.equation)
            judged = (there, {}) if there is not None else judged
        if judged is not None:
            judged = self.circumstances.of_implication(self._unless_doubted(judged[0]), implication), judged[1]
        if judged is not None and any(outcome.holds_there for outcome in premised):
            judged = self._unless_meant_there(display, implication, judged)
        display.above.append(implication)
        if judged is None:  # a step of a derivation: it is a claim of its own, and so is what follows
            self.names.state.told = moved
            steps = [*map(self._without_numbers, steps)]
            display.assumed = all(outcome.is_condition for found in steps for outcome in found)
            for chain, found in zip(premises, steps, strict=True):
                display.outcomes.extend(with_role(outcome, chain, self.names) for outcome in found)
            display.equation += sum(len(chain.relations) for chain in premises)
            display.links = []
            display.index += len(premises) + connectives_among(display.statements, display.index, len(premises))
            return
        display.under = implication if implication.kind in ("⇒", "if") else None
        self.names.state.comparisons = compared
        self.names.state.configuration = given  # a premise holds in its implication alone, and so does what it defines
        self.names.forget(key for found in steps for o in found for key in o.defines if not o.is_condition)
        outcome, counterexample = judged
        read_as = together(dict.fromkeys(filter(None, map(self.checker.members.read_as, implication.chains))))
        sides = tuple(member for chain in implication.chains for member in chain.members)
        of_all = replace(outcome, role=Role.CONDITION, uses=self._consulted(), read_as=read_as, conditions=sides)
        display.outcomes.append(of_all)
        display.counterexample.update(counterexample)
        leads_on = goes_on(display.statements, implication)
        display.links = [*display.links, implication] if leads_on else []
        display.equation += sum(len(chain.relations) for chain in (premises if leads_on else implication.chains))
        display.index = implication.behind_at if leads_on else implication.after

    def _without_numbers(self, step: list[Outcome]) -> list[Outcome]:
        """φ = 0 ⇒ …: a number is no meaning that a name has from there on; the equation is a condition."""
        self.names.forget(key for outcome in step if outcome.gives_numbers for key in outcome.defines)
        condition = Outcome(Verdict.DEFINED, (say(Kind.CONDITION),))
        return [replace(condition, equation=o.equation) if o.gives_numbers else o for o in step]

    def _unless_meant_there(
        self, display: _Display, implication: Implication, judged: tuple[Outcome, dict[str, float]]
    ) -> Judgement:
        """Leave open what does not follow, where both sides may be claims at the values stated before: x = 0.5 ⇒ y = 1."""
        if judged[0].verdict is not Verdict.REFUTED:
            return judged
        claims = [
            o for chain in implication.conclusions for o in self._chain(chain, display.equation, display.line, False)
        ]
        refuted = any(outcome.verdict is Verdict.REFUTED for outcome in claims)
        return judged if refuted else (judged[0].left_open(say(Kind.HOLDS_THERE_ALONE)), {})

    def _heed_behind(self, display: _Display) -> None:
        """R = R_z(θ_1), θ_2 = 0: what is refuted may be meant where the values behind it say."""
        for place, outcome in enumerate(display.outcomes):
            behind = [chain for at, chain in display.stated if at > place]
            if outcome.verdict is Verdict.REFUTED and behind:
                display.outcomes[place] = self.circumstances.judge_before(outcome, behind)

    def _tell_what_is_left_out(
        self, statement: n.Statement, statements: list[n.Statement], outcomes: list[Outcome], latex: str
    ) -> None:
        """An expression beside an equation is part of no claim, and what was meant by it is not known."""
        dots = [below for below in n.walk(statement) if isinstance(below, n.Dots)]
        for outcome in outcomes if dots and latex else ():
            if any(finding.kind is Kind.PATTERN for finding in outcome.findings):
                sign = SCRIPTED.match(latex, dots[0].span[0])
                outcome.findings = (say(Kind.TERMS_UNWRITTEN, text=sign.group() if sign else "…"),)
        if any(isinstance(each, n.Chain) and each.relations for each in statements):
            for outcome in outcomes:
                if any(finding.kind is Kind.NO_EQUATION for finding in outcome.findings):
                    text = latex[statement.span[0] : statement.span[1]].strip()
                    outcome.role, outcome.findings = Role.CLAIM, (say(Kind.LEFT_OUT, text=text),)

    def _without_for_all(self, statements: list[n.Statement]) -> list[n.Statement]:
        """Leave out "for all θ_1, θ_2", which every equation says without it."""
        kept: list[n.Statement] = []
        index = 0
        while index < len(statements):
            after = index + 1
            statement = statements[index]
            if len(statements) > 1 and self._is_whole_number(statement):
                if (
                    kept
                    and isinstance(quantifier := kept[-1], n.Connective)
                    and quantifier.text in ("exists", "forall")
                ):
                    kept.pop()
                index = after
                continue
            if isinstance(statement, n.Connective) and statement.text.strip(" .,;:").lower() in FOR_ALL:
                while after < len(statements) and self._is_any_configuration(statements[after]):
                    after += 1
            if after == index + 1:
                kept.append(statement)
            index = after
        return kept

    def _is_whole_number(self, statement: n.Statement) -> bool:
        """k ∈ ℤ: so it is read in θ = kπ without being said."""
        if not isinstance(statement, n.Chain) or statement.relations != ("∈",):
            return False
        k, numbers = (member.key if isinstance(member, n.Name) else "" for member in statement.members)
        return k in ("k", "n", "m") and numbers in WHOLE and self.names.known_symbol(k) is None

    def _is_any_configuration(self, statement: n.Statement) -> bool:
        node = statement.members[0] if isinstance(statement, n.Chain) and not statement.relations else None
        if self.names.arm is None or not isinstance(node, n.Name):
            return False
        joints = {joint.symbol for joint in self.names.arm.joints}
        return node.key in ("q", "theta") or self.names.known_symbol(node.key) in joints

    def _resolve_subject(self, statement: n.Statement) -> n.Statement:
        """A display that begins with a relation goes on about the subject of the one before."""
        subject = self.names.state.subject
        if isinstance(statement, n.Chain) and statement.members[0] is PREVIOUS and subject is not None:
            return replace(statement, members=(subject, *statement.members[1:]))
        return statement

    def _claim(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain that is no condition: numbers may be those of given values, and of rates in a column."""
        if rates := self.given.rates_of_column(chain):
            stated = self.names.state.configuration
            self.names.state.configuration = {**self.given.stated(rates), **stated}
            outcomes = self._at_values(chain, equation, line, define)
            self.names.state.configuration = stated
            return outcomes
        return self._at_values(chain, equation, line, define)

    def _at_values(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        self._begin()
        if _is_of_rank(chain):
            return self.circumstances.of_ranks(chain, self._chain(chain, equation, line, define), line)
        there = self._at_told_values(chain, equation, line)
        if any(outcome.verdict in DECIDED for outcome in there):
            return [replace(self._unless_doubted(outcome), uses=self._consulted()) for outcome in there]
        outcomes = self._chain(chain, equation, line, define)
        for outcome in outcomes if there else ():
            if any(finding.kind is Kind.NUMBERS_OF_NOWHERE for finding in outcome.findings):
                outcome.findings = there[0].findings
        return outcomes

    def _chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain, each with the definitions that it rests on."""
        self._begin()
        outcomes = self._read_chain(chain, equation, line, define)
        again = partial(self._read_chain, chain, equation, line, False)
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
        foreign = self.names.state.foreign()
        for outcome in outcomes if foreign else ():
            if outcome.verdict is Verdict.REFUTED:
                other = say(Kind.OTHER_EXERCISE, name=foreign[0][0], line=foreign[0][1])
                outcome.verdict, outcome.findings = Verdict.UNCHECKED, (other,)
        outcomes = [self._unless_doubted(outcome) for outcome in outcomes]
        if by_table := self.names.state.from_table():
            doubt = say(Kind.ENTRY_BY_INDEX, name=by_table[0])
            outcomes = [each.unless_refuted(doubt) for each in outcomes]
        if (
            text := self.names.state.from_text()
        ):  # it may speak of one case: only a slip in what follows from it is refuted
            outcomes = [each.unless_near(say(Kind.AS_TEXT_SAYS, name=text[0])) for each in outcomes]
        defined = {(key, line) for outcome in outcomes for key in outcome.defines}
        for outcome in outcomes:  # c_3 = … := D names what is decided beside it
            met = {key for key in self._consulted() if key[0] not in outcome.defines and key != outcome.repeats}
            outcome.uses = frozenset(met | defined if outcome.verdict in DECIDED else met)
        return outcomes

    def _at_told_values(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return what becomes of numbers at the values that the text before gives; [] where there are none.

        What is not decided there leaves no trace. Only numbers right behind the text are refuted there, and few of many.
        """
        state = self.names.state
        speaks = state.told.conditions or state.told_lengths
        if not speaks or len(chain.members) < 2 or not any(map(is_numbers, chain.members)):
            return []
        before = state.copy()
        state.configuration = self.circumstances.told_values() | state.configuration
        outcomes = self._read_chain(chain, equation, line, False)
        wrong = [each for each in outcomes if each.verdict not in HOLDS]
        if not wrong or (state.told.line == line and all(map(is_mostly_right, wrong))):
            state.configuration = before.configuration
            return outcomes
        state.become(before)
        return [each.left_open(say(Kind.OTHER_AS_TOLD)) for each in wrong if each.verdict is Verdict.REFUTED]

    def _unless_doubted(self, outcome: Outcome) -> Outcome:
        """Leave open what a definition that may be a mistake decides: it proves nothing, and may be the mistake itself.

        The last of two meanings is no mistake where a joint or a quantity of the arm is what it then says.
        """
        if outcome.verdict not in DECIDED or self.is_closed:
            return outcome
        doubted, of_two = self.names.state.doubted(), self.names.state.with_two_meanings()
        if of_two and (outcome.verdict is Verdict.REFUTED or not is_of_arm(outcome, self.names)):
            doubted = doubted or of_two
        if not doubted:
            return outcome
        kind = Kind.RESTS_ON_DOUBT if outcome.verdict is Verdict.REFUTED else Kind.FOLLOWS_FROM_DOUBT
        return outcome.left_open(say(kind, name=doubted[0][0], line=doubted[0][1]))

    def _of_own_sums(self, outcome: Outcome, chain: n.Chain) -> Outcome:
        """A θ_{34} that the document says to be θ_3 - θ_4 is what it says: that is no claim, and what then fails is left open."""
        digits = next(filter(None, map(self.names.own_sum, n.walk(chain))), "")
        alone = [each.arguments[0] if isinstance(each, n.Call) else each for each in map(bare, chain.members)]
        says_so = any(self.names.own_sum(each) for each in alone)
        if not digits or not (outcome.verdict is Verdict.REFUTED or (says_so and outcome.verdict is Verdict.PROVED)):
            return outcome
        return outcome.left_open(say(Kind.OWN_SUM, digits=digits))

    def _begin(self) -> None:
        self.names.state.consulted.clear()
        self.names.state.signs.read.clear()

    def _consulted(self) -> frozenset[tuple[str, int]]:
        """Return the definitions and the named signs that were met since the last beginning."""
        signs = self.names.state.signs
        return frozenset(self.names.state.consulted) | {(key, signs.lines.get(key, 0)) for key in signs.read}

    def _read_chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        unclear = [below for below in n.walk(chain) if isinstance(below, n.Ambiguous)]
        if unclear:
            return self._either_reading(chain, unclear, equation, line, define)
        if letters := crossed_letters(self.names, chain):
            check = partial(self._clear_chain, chain, equation, line)
            return of_vectors(self.names, chain, letters, line, check)
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
                self._claimed(chain, equation, line, define)  # what is said of that solution from here on
                return outcomes
        if (said := self._stated(chain, equation, line, define)) is not None:
            return [said, *self._numbers_behind(chain, said, equation, line)]
        if any(relation != "=" for relation in chain.relations):
            parts = [(equation + at, part) for at, part in parts_of(chain)]
            return [outcome for number, part in parts for outcome in self._related(part, number, line, define)]
        if any(isinstance(member, n.Cases) for member in chain.members):
            return check_cases(self.checker, chain, equation, line, define)
        return self._claimed(chain, equation, line, define)

    def _stated(self, chain: n.Chain, equation: int, line: int, define: bool) -> Outcome | None:
        """Return what becomes of a chain that claims nothing: a sign, a configuration, a condition, a doubt; else None."""
        sign = named_sign(chain)
        if sign is not None and self.names.defines_sign(sign):
            if define:
                self.names.state.signs.name(sign, line)
            return Outcome(Verdict.DEFINED, (say(Kind.SIGN, name=sign),), equation, defines=(sign,))
        if any(relation != "=" for relation in chain.relations):
            return None
        if is_sum_of_indices(chain):
            return Outcome(Verdict.PROVED, (), equation, role=Role.LAW)
        if (doubt := counted(chain, self.names)) is not None:
            return Outcome(Verdict.UNCHECKED, (doubt,), equation)
        if (given := self.given.read(chain, line, define)) is not None:
            return Outcome(Verdict.DEFINED, (say(Kind.CONFIGURATION),), equation, defines=given)
        if not self.given.is_condition(chain):
            return None
        if define:
            self._relate(chain, line)
        return Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)

    def _relate(self, chain: n.Chain, line: int) -> None:
        """Keep what joints, or lengths, are said to be: l_1 = l_2, of which l may be the letter."""
        related = self.given.related(chain)
        if not related:
            return
        self.circumstances.of_display(replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1)))
        for letter in (bare_key(each) for each in chain.members if each not in related):
            self.names.define(str(letter), self.checker.members.meaning(related[0]), line, node=related[0])

    def _numbers_behind(self, chain: n.Chain, said: Outcome, equation: int, line: int) -> list[Outcome]:
        """θ_1 = atan2(1, 0) = 90°: the numbers of a value that is given are to be equal."""
        if len(chain.members) < 3 or said.role is not Role.CLAIM or not all(map(is_number, chain.members[1:])):
            return []
        rest = replace(chain, members=chain.members[1:], relations=chain.relations[1:])
        return [each for each in self._claimed(rest, equation + 1, line, False) if each.verdict is Verdict.REFUTED]

    def _related(self, part: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if part.relations[0] == "=":
            return self._clear_chain(part, equation, line, define)
        return [check_relation(self.checker, part, equation)]

    def _claimed(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        is_general = any(is_inverse_link(m, self.names.transforms) is not None for m in chain.members)
        found = self.general.check(chain, equation, line, define) if is_general else None
        for outcome in found or ():
            outcome.role = Role.LAW
        outcomes = found or self._decided(chain, equation, line, define)
        for outcome in outcomes if define else ():
            self.given.remember(outcome.gives, line)
        if define and any(finding.kind is Kind.NUMBERS_OF_NOWHERE for o in outcomes for finding in o.findings):
            self.circumstances.of_display(chain)
        outcomes = [self._understood(o, chain, define) if o.verdict is Verdict.REFUTED else o for o in outcomes]
        is_open = bool(outcomes) and all(o.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for o in outcomes)
        if is_open and holds_of_any_jacobian(chain, self.names):
            known = (say(Kind.OF_ANY_JACOBIAN),)
            return [replace(each, verdict=Verdict.PROVED, findings=known, role=Role.LAW) for each in outcomes]
        return outcomes

    def _understood(self, outcome: Outcome, chain: n.Chain, define: bool) -> Outcome:
        """Return a refuted outcome, left open where the chain or what the text says may be meant otherwise."""
        outcome = without_misreading(outcome, chain, self.names, not define, self.is_closed)
        if self.names.arm is None and self.names.state.compares_lengths and self.ring.signs_chosen:
            outcome = outcome.unless_refuted(say(Kind.ROOTS_POSITIVE))  # a > b says which sign √((a − b)²) has
        speaks = self.names.state.told != Told() and outcome.verdict is Verdict.REFUTED
        return self.circumstances.judge(outcome) if speaks else outcome

    def _decided(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        outcomes = self.checker.check(chain, equation, line, define)
        undecided = all(outcome.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for outcome in outcomes)
        frames = self.names.arm.frames if self.names.arm is not None else ()
        if not (undecided and outcomes):
            return outcomes
        if is_composition(chain, frames) or is_elementary_rotation(self.general, chain, equation, line):
            return [replace(each, verdict=Verdict.PROVED, findings=(), role=Role.LAW) for each in outcomes]
        if (rates := with_rates(chain, self.names)) is not None:
            tried = self.checker.check(rates, equation, line, False)
            if all(
                outcome.verdict in HOLDS or (outcome.is_slip and is_of_rates(rates, self.names)) for outcome in tried
            ):
                return tried
        kinds = ("", kind) if (kind := self.names.state.told.kind) else ("",)
        if any(holds_for_each_joint(self.checker, chain, equation, line, kind) for kind in kinds):
            by_joint = (say(Kind.EACH_JOINT),)
            return [
                replace(each, verdict=Verdict.PROVED, findings=by_joint, role=Role.LAW, defines=()) for each in outcomes
            ]
        if self.names.arm is not None and (found := self.general.product(chain, equation, line)):
            return found
        open_alone = all(outcome.verdict is Verdict.UNCHECKED and not outcome.defines for outcome in outcomes)
        if self.names.arm is not None and open_alone:
            return self.general.identity(chain, equation, line) or outcomes
        return outcomes


def _without_vanishing_end(statement: n.Statement) -> list[n.Statement]:
    """det J = l_1 l_2 s_2 = 0 is an equation and a condition, and so is a derivative that is to vanish."""
    if not isinstance(statement, n.Chain) or len(statement.members) < 3 or set(statement.relations) != {"="}:
        return [statement]
    *first, last = statement.members
    if (
        not isinstance(last, n.Number)
        or last.value != 0
        or any(isinstance(member, n.Number | n.Matrix) for member in first)
    ):
        return [statement]
    determinant = isinstance(first[0], n.Call) and first[0].function in ("det", "abs")
    if not determinant and not isinstance(first[0], n.Derivative):
        return [statement]
    claim = replace(statement, members=tuple(first), relations=statement.relations[:-1])
    return [claim, replace(statement, members=(first[0], last), relations=("=",))]


def _asked(statement: n.Statement) -> n.Statement:
    """What is asked for, by an = with a mark above it, is a condition beside an arrow."""
    if not isinstance(statement, n.Chain):
        return statement
    return replace(statement, relations=tuple("=" if r == ASKED else r for r in statement.relations))


def _is_of_rank(chain: n.Chain) -> bool:
    """Whether a rank stands in a chain that does not say itself at which values."""
    below = [*n.walk(chain)]
    ranks = any(isinstance(each, n.Call) and each.function == "rank" for each in below)
    return ranks and not any(isinstance(each, n.At) for each in below)


def _is_label(chain: n.Chain) -> bool:
    """Whether a number in brackets stands alone, as equations are numbered: (3)."""
    (member,) = chain.members
    return isinstance(member, n.Group) and isinstance(member.inner, n.Number)
