"""The statements of a display, one after the other: equations, relations, cases and implications."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

from armproof.models.errors import together
from armproof.verification.conditions.implication import (
    Implication,
    connectives_among,
    find_implication,
    goes_on,
    is_condition,
    is_under_words,
    with_rank_first,
)
from armproof.verification.conditions.implications import Implications, Judgement
from armproof.verification.conditions.tied_signs import with_signed
from armproof.verification.conditions.wording import is_alternative, is_concluded, tell_words_that_change
from armproof.verification.display.claims import Claims
from armproof.verification.display.other_solutions import as_other_solution
from armproof.verification.display.prepared import (
    asked,
    beside_arcs,
    of_all_joints,
    prepared,
    with_bare_letters,
    without_its_letters,
)
from armproof.verification.document.told_singularities import (
    SINGULAR_ALONE,
    SINGULAR_AMONG,
    VANISHES,
    singularities_told,
)
from armproof.verification.equations.cells_left_out import with_cells
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.given_values import named_sign
from armproof.verification.equations.named_signs import unless_signs_clash
from armproof.verification.equations.outcome import Outcome, with_role
from armproof.verification.equations.polar import gives_meanings, polar_pair
from armproof.verification.equations.series import unless_added, written_out
from armproof.verification.equations.shorthands import digits_of, is_among
from armproof.verification.equations.worked_numbers import DEGREES
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.statements import PREVIOUS
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.shown import letters_of_point
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, HOLDS, Role, Verdict

SCRIPTED = regex(r"\\?[A-Za-z.…⋯]+(?:\s*[_^]\s*(?:\{[^{}]*\}|[^\\{]))*")  # \sum_{i=1}^{2}
_OF_LETTERS = regex(
    r"\((?:q|t|\\?[tT]heta|\\\w+\s*\{q\})\).*matrix|matrix.*\((?:q|t|\\?[tT]heta|\\\w+\s*\{q\})\)|^\s*\\(?:mathbf|boldsymbol|bm|vec|overrightarrow|underline|textbf)\b.*matrix",
    re.DOTALL,
)
_ARC = regex(
    r"arc|tan|acos|asin|\^\s*\{?\s*-|(?:cos|sin)[\s{(]*(?:\\left)?[\s({]*-?\d\d", re.IGNORECASE
)  # where an inverse function may stand, however spelled, or a number of degrees in a cosine
_ASIDE = regex(r"\s*\([^()]*\)\s*")
_OF_OTHER = regex(r"'|\\prime|\^\s*\{\s*\(")  # a name with primes, or with a number in parentheses


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
        return [asked(statement) for statement in self.statements]

    @cached_property
    def is_connected(self) -> bool:
        """Whether a connective stands among the statements."""
        return any(isinstance(statement, n.Connective) for statement in self.statements)


class Statements:
    """Checks the statements of displays; one that begins with a relation goes on about the subject of the one before."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.ring = checker.exact.ring
        self.claims = Claims(checker)

    @cached_property
    def implications(self) -> Implications:
        """Judges implications; made where there is one."""
        return Implications(self.checker)

    def check(
        self, statements: list[n.Statement], line: int, *, define: bool = True, latex: str = ""
    ) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes of a display's statements and, for a refuted condition, its counterexample.

        `latex` is the display in which the nodes have their places, to quote what is left out.
        """
        if "\\sum" in latex or "\\prod" in latex:
            statements = [written_out(statement, latex, self.names) for statement in statements]
        printed = statements
        if "dots" in latex:
            statements = [with_cells(statement, self.names) for statement in statements]
        is_of_any = statements != printed  # with cells left out: it may number axes otherwise than this arm
        statements = [self._with_subject(statement) for statement in statements]
        if _ARC.search(latex):
            statements = [beside_arcs(statement) for statement in statements]
        if self.names.arm is None:
            statements = [of_all_joints(statement) for statement in statements]
        if _OF_LETTERS.search(latex):
            statements = [without_its_letters(with_bare_letters(statement)) for statement in statements]
        if len(statements) > 1 or any(isinstance(each, n.Chain) and len(each.members) > 2 for each in statements):
            statements = prepared(statements, self.names)
        if any(map(n.is_rank, (member for each in statements if isinstance(each, n.Chain) for member in each.members))):
            statements = [with_rank_first(statement) for statement in statements]
        told = self.names.state.told
        if told.singular and told.line == line:
            statements = _without_asides(statements)
        of_singularities = bool(told.singular) and self._are_conditions(statements)
        if (
            of_singularities
            and told.line == line
            and (found := self._of_singularities(statements, told.singular, line))
        ):
            return found
        if found := self._of_labelled_singularities(statements, line):
            return found
        display = _Display(statements, line, define, latex)
        if define and len(statements) > 1:
            self._name_ahead(statements, line)
        while display.index < len(statements):
            self.ring.budget.check()
            self._take_next(display)
        self._heed_behind(display)
        if _OF_OTHER.search(latex):
            display.outcomes = as_other_solution(statements, display.outcomes, self.checker)
        if sum(n.has_branches(each) for each in statements) > 1:
            display.outcomes = unless_signs_clash(display.outcomes, self.checker.route.holds_everywhere)
        if display.is_connected:
            tell_words_that_change(statements, display.outcomes)
        if is_of_any:
            unwritten = say(Kind.TERMS_UNWRITTEN, text="\\dots")
            display.outcomes = [outcome.unless_refuted(unwritten) for outcome in display.outcomes]
        is_refuted = any(each.verdict is Verdict.REFUTED for each in display.outcomes)
        if is_refuted and (number := _angle_without_unit(statements)):
            degrees = say(Kind.DEGREES_UNMARKED, number=number)
            display.outcomes = [outcome.unless_refuted(degrees) for outcome in display.outcomes]
        if own := self._own_shorthand(statements):
            display.outcomes = [each.left_open(own) if each.verdict in DECIDED else each for each in display.outcomes]
        undecided = [each for each in display.outcomes if each.verdict is Verdict.UNCHECKED] if define else []
        for key in (key for outcome in undecided for key in outcome.defines):
            self.names.doubt(key)  # what follows from it is not decided either
        if of_singularities:  # one that leaves others out, or is too large to tell
            self.names.state.told = told  # the next display may be another one
            display.outcomes = [each.unless_refuted(say(Kind.POSTURE_IN_WORDS)) for each in display.outcomes]
        first_chain = next((s for s in statements if isinstance(s, n.Chain)), None)
        if first_chain is not None and define:
            self.names.state.subject = first_chain.members[0]
            if n.is_call(bare(first_chain.members[0]), "det"):
                self.names.state.has_open_determinant = any(each.verdict not in DECIDED for each in display.outcomes)
        return display.outcomes, display.counterexample

    def tried(self, latex: str) -> list[Outcome]:
        """Return the outcomes of a display that is tried: it defines nothing."""
        return self.check(self.names.reader.read(latex), 0, define=False, latex=normalise_unicode(latex))[0]

    def _name_ahead(self, statements: list[n.Statement], line: int) -> None:
        """Y = -2 B_1 d_3, B_1 = …, or s_2 = ε √(1 - c_2²), ε = ±1: what a display says of a letter holds for all of it."""
        spoken: set[str] = set()
        chains = [each for each in statements if isinstance(each, n.Chain)]
        for each in chains if len(chains) == len(statements) else ():
            name = bare(each.members[0])
            sign = named_sign(each)
            if sign is not None and self.names.defines_sign(sign):
                self.names.state.signs.name(sign, line)
            elif isinstance(name, n.Name) and name.key in spoken and self.names.is_open(name) and not is_usual(name):
                self.claims.chain(each, 1, line, define=True)
            spoken |= {below.key for below in n.names(each)}

    def _own_shorthand(self, statements: list[n.Statement]) -> Finding | None:
        """Return the doubt where a c_{12} is written that the text says to be something else than it usually is."""
        if not (own := self.names.state.own_shorthands):
            return None
        found = next(
            (b for each in statements for b in n.walk(each) if isinstance(b, n.Call) and is_among(b, own)), None
        )
        return None if found is None else say(Kind.OWN_SHORTHAND, name=f"{found.head}_{{{digits_of(found)}}}")

    def _with_subject(self, statement: n.Statement) -> n.Statement:
        """A display that begins with a relation goes on about the subject of the one before."""
        subject = self.names.state.subject
        if isinstance(statement, n.Chain) and statement.members[0] is PREVIOUS and subject is not None:
            return replace(statement, members=(subject, *statement.members[1:]))
        return statement

    def _of_labelled_singularities(
        self, statements: list[n.Statement], line: int
    ) -> tuple[list[Outcome], dict[str, float]] | None:
        """Decide a display of conditions that begins with words: "Singularities: θ_2 = 0 or θ_2 = π"."""
        if not statements or not isinstance(statements[0], n.Connective):
            return None
        told, conditions = [*singularities_told(statements[0].text)], statements[1:]
        arrow = next((at for at, each in enumerate(conditions) if _is_arrow(each)), len(conditions))
        if not told or not self._are_conditions(conditions[:arrow]):
            return None
        found = self._of_singularities(conditions[:arrow], told[-1], line)
        is_whole = arrow == len(conditions) or (found is not None and found[0][0].verdict is Verdict.REFUTED)
        return found if is_whole else None

    def _of_singularities(
        self, statements: list[n.Statement], told: str, line: int
    ) -> tuple[list[Outcome], dict[str, float]] | None:
        """ "The singularities are θ_2 = 0 or θ_2 = π": det J = 0 there and nowhere else. What leaves some out is open, unless the text says that it does not, or tells of one kind."""
        statements = _as_alternatives(statements)
        of_arm = n.Call("det", (n.Name("J"),), "\\det")
        determinant = self.names.state.subject if told == VANISHES else of_arm
        if not n.is_call(determinant, "det") or self.names.state.has_open_determinant:
            return None
        vanishes = n.Chain((determinant, n.Number(Fraction(0))), ("=",))
        wrong = [(kind, (Verdict.REFUTED,)) for kind in ("⇐", "⇒")[: 1 + (told == SINGULAR_ALONE)]]
        for kind, decided in (("⇐" if told == SINGULAR_AMONG else "⇔", HOLDS), *wrong):
            implied = [vanishes, n.Connective(kind, kind), *statements]
            implication = find_implication(implied, 0)
            if implication is None or implication.after < len(implied):
                return None
            display = _Display(implied, line, False, "")
            with self.names.state.unchanged():
                self._take_implication(display, implication)
            is_decided = [each.verdict in decided for each in display.outcomes] == [True]
            if is_decided and not self.claims.circumstances.is_beyond_bounds(display.counterexample):
                display.outcomes[0].also(say(Kind.OF_SINGULARITIES if kind == "⇔" else Kind.OF_SOME_SINGULARITIES))
                return display.outcomes, display.counterexample
        return None

    def _are_conditions(self, statements: list[n.Statement]) -> bool:
        chains = [each for each in statements if isinstance(each, n.Chain)]
        equal = [each for each in chains if each.relations]  # and the π of θ_2 = 0 or π
        return self.names.arm is not None and all(is_condition(each) and each.relations == ("=",) for each in equal)

    def _take_next(self, display: _Display) -> None:
        statement = display.statements[display.index]
        implication = find_implication(display.asked, display.index) if display.is_connected else None
        if implication is not None:
            self._take_implication(display, implication)
        elif isinstance(statement, n.Chain):
            if not self._take_pair(display):
                self._take_chain(display, statement)
        else:
            display.index += 1

    def _take_pair(self, display: _Display) -> bool:
        """Take p_x = r cos φ, p_y = r sin φ, which give r and φ their meaning; False where no such pair stands next."""
        both = display.statements[display.index : display.index + 2]
        pair = polar_pair(*both) if display.define and len(both) == 2 else None
        found = gives_meanings(self.checker, pair, display.equation, display.line) if pair is not None else None
        if not found:
            return False
        display.outcomes.extend(found)
        display.equation += len(found)
        display.index += len(found)
        return True

    def _take_chain(self, display: _Display, chain: n.Chain) -> None:
        statements, index = display.statements, display.index
        given = dict(self.names.state.configuration)
        is_connected = display.is_connected
        alternative = is_connected and is_alternative(statements, index)
        found = self.claims.claim(chain, display.equation, display.line, display.define and not alternative)
        found = [outcome.unless_refuted(say(Kind.ONE_OF_TWO)) for outcome in found] if alternative else found
        under_words = is_connected and is_under_words(statements, index)
        if under_words or any(map(self.claims.given.places_joints, (each for _, each in display.stated))):
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
        asked = with_signed(chain, under.premises if under.kind == "if" else under.conclusions)
        wider = replace(under, before=[asked]) if under.kind == "if" else replace(under, behind=[asked])
        judged = self.implications.of_the_tool(wider, found, display.equation, display.links)
        self.names.forget(key for outcome in found for key in outcome.defines)  # what a name means there alone
        judged = judged or self.implications.judge(wider, [Outcome(Verdict.UNCHECKED)], display.equation, [])
        if judged is not None and judged[0].verdict in HOLDS:
            return [replace(self.claims.unless_doubted(judged[0]), role=Role.CONDITION)]
        is_wrong = judged is not None and judged[0].verdict is Verdict.REFUTED and not self.names.has_tool
        return found if is_wrong else [outcome.unless_refuted(say(Kind.UNDER_MORE)) for outcome in found]

    def _take_implication(self, display: _Display, implication: Implication) -> None:
        given, told = dict(self.names.state.configuration), self.names.state.told
        compared = [*self.names.state.comparisons]
        implication = implication.with_each(self.checker.rows.choose)
        self.checker.conventions.take_coordinates(implication.chains)
        premises = implication.premises
        self.checker.redefinitions.enabled = False
        steps = [self.claims.chain(chain, display.equation, display.line, display.define) for chain in premises]
        self.checker.redefinitions.enabled = True
        if self.names.arm is None:  # θ_1 = θ_2 = 0 gives no letter a meaning: it is a condition
            given_here = zip(premises, steps, strict=True)
            self.names.forget(
                key for chain, found in given_here if is_condition(chain) for o in found for key in o.defines
            )
        moved, self.names.state.told = self.names.state.told, told
        self.claims.begin()
        premised = [outcome for found in steps for outcome in found]
        judged = self._judged(display, implication, premised)
        display.above.append(implication)
        if judged is None:  # a step of a derivation: it is a claim of its own, and so is what follows
            self.names.state.told = moved
            self._take_steps(display, premises, steps)
            return
        display.under = implication if implication.kind in ("⇒", "if") else None
        self.names.state.comparisons = compared
        self.names.state.configuration = given  # a premise holds in its implication alone, and so does what it defines
        self.names.forget(key for found in steps for o in found for key in o.defines if not o.is_condition)
        self._conclude(display, implication, *judged)

    def _judged(self, display: _Display, implication: Implication, premised: list[Outcome]) -> Judgement:
        """Return what becomes of an implication with its counterexample; None where it is a step of a derivation."""
        judged = self.implications.judge(implication, premised, display.equation, display.links)
        judged = self.implications.beside(judged, implication, display.above, display.equation)
        if judged is None or judged[0].verdict is Verdict.UNCHECKED:
            of_the_tool = self.implications.of_the_tool(implication, premised, display.equation, display.links)
            judged = of_the_tool or judged
        circumstances = self.claims.circumstances
        if judged is None or judged[0].verdict not in HOLDS:
            there = circumstances.at_premised(implication, display.equation)
            judged = (there, {}) if there is not None else judged
        if judged is None:
            return None
        judged = circumstances.of_implication(self.claims.unless_doubted(judged[0]), implication), judged[1]
        if any(outcome.holds_there for outcome in premised):
            return self._unless_meant_there(display, implication, judged)
        return judged

    def _take_steps(self, display: _Display, premises: list[n.Chain], steps: list[list[Outcome]]) -> None:
        steps = [*map(self._without_numbers, steps)]
        display.assumed = all(outcome.is_condition for found in steps for outcome in found)
        for chain, found in zip(premises, steps, strict=True):
            display.outcomes.extend(with_role(outcome, chain, self.names) for outcome in found)
        display.equation += sum(len(chain.relations) for chain in premises)
        display.links = []
        display.index += len(premises) + connectives_among(display.statements, display.index, len(premises))

    def _of_two_points(self, sides: Iterable[n.Node]) -> n.Name | None:
        """Return a coordinate that is read as that of another point than one beside it, x of the last frame and y of the tool; or None."""
        points: dict[str, set[tuple[str, str]]] = {}
        for name in (below for side in sides for below in n.names(side)):
            quantity = self.checker.members.quantity_of(name)
            if quantity is not None and quantity.kind == "origin" and quantity.scalar:
                of_letters = points.setdefault(letters_of_point(name.key), set())
                of_letters.add((quantity.frame, quantity.reference))
                if len(of_letters) > 1:
                    return name
        return None

    def _conclude(
        self, display: _Display, implication: Implication, outcome: Outcome, counterexample: dict[str, float]
    ) -> None:
        read_as = together(dict.fromkeys(filter(None, map(self.checker.members.read_as, implication.chains))))
        sides = tuple(member for chain in implication.chains for member in chain.members)
        if (name := self._of_two_points(sides)) is not None and outcome.verdict in DECIDED:
            outcome = outcome.left_open(say(Kind.NOT_BOUND, name=name.text))
        of_all = replace(outcome, role=Role.CONDITION, uses=self.claims.consulted(), read_as=read_as, conditions=sides)
        display.outcomes.append(of_all)
        display.counterexample.update(counterexample)
        leads_on = goes_on(display.statements, implication)
        display.links = [*display.links, implication] if leads_on else []
        chains = implication.premises if leads_on else implication.chains
        display.equation += sum(len(chain.relations) for chain in chains)
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
            o
            for chain in implication.conclusions
            for o in self.claims.chain(chain, display.equation, display.line, False)
        ]
        refuted = any(outcome.verdict is Verdict.REFUTED for outcome in claims)
        return judged if refuted else (judged[0].left_open(say(Kind.HOLDS_THERE_ALONE)), {})

    def _heed_behind(self, display: _Display) -> None:
        """R = R_z(θ_1), θ_2 = 0: what is refuted may be meant where the values behind it say."""
        for place, outcome in enumerate(display.outcomes):
            behind = [chain for at, chain in display.stated if at > place]
            if outcome.verdict is Verdict.REFUTED and behind:
                display.outcomes[place] = self.claims.circumstances.judge_before(outcome, behind)

    def _tell_what_is_left_out(
        self, statement: n.Statement, statements: list[n.Statement], outcomes: list[Outcome], latex: str
    ) -> None:
        """An expression beside an equation is part of no claim, and what was meant by it is not known."""
        dots = [below for below in n.walk(statement) if isinstance(below, n.Dots)]
        for outcome in outcomes if dots and latex else ():
            if outcome.tells(Kind.PATTERN):
                sign = SCRIPTED.match(latex, dots[0].span[0])
                outcome.findings = (say(Kind.TERMS_UNWRITTEN, text=sign.group() if sign else "…"),)
        if any(isinstance(each, n.Chain) and each.relations for each in statements):
            for outcome in outcomes:
                if outcome.tells(Kind.NO_EQUATION):
                    text = latex[statement.span[0] : statement.span[1]].strip()
                    outcome.role, outcome.findings = Role.CLAIM, (say(Kind.LEFT_OUT, text=text),)


def _as_alternatives(statements: list[n.Statement]) -> list[n.Statement]:
    """Return conditions that only commas stand between as alternatives: s_3 = 0, a_2 c_2 + a_3 c_23 = 0."""
    if not all(isinstance(each, n.Chain) for each in statements):
        return statements
    between = [(n.Connective("or", "or"), each) for each in statements[1:]]
    return [*statements[:1], *(each for pair in between for each in pair)]


def _is_arrow(statement: n.Statement) -> bool:
    return isinstance(statement, n.Connective) and statement.kind not in ("or", "and")


def _without_asides(statements: list[n.Statement]) -> list[n.Statement]:
    """Return conditions without what stands beside them in parentheses: θ_2 = 0 (arm stretched) or θ_2 = π."""
    kept = [each for each in statements if not (isinstance(each, n.Connective) and _ASIDE.fullmatch(each.text))]
    return kept if sum(isinstance(each, n.Chain) for each in kept) else statements


def _angle_without_unit(nodes: list[n.Statement]) -> str:
    """Return the whole number that a sine, cosine or tangent is taken of, as of an angle in degrees: 30 of cos 30; "" without."""
    calls = (b for node in nodes for b in n.walk(node) if n.is_call(b, "cos", "sin", "tan"))
    numbers = (n.ungrouped(argument) for call in calls for argument in call.arguments)
    found = (each for each in numbers if isinstance(each, n.Number) and not each.decimals and each.value >= DEGREES)
    return next((str(each.value) for each in found), "")
