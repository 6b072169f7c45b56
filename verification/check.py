"""From a document to its verdicts: one record a display, one a DH table."""

from __future__ import annotations

import re
import time
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from models.arm import Arm
from models.catalogue import load_arm
from models.configurations import FAMILIES, sample
from models.errors import ArmproofError
from verification.algebras import ExactAlgebra, SampledAlgebra
from verification.conditions import check_implication, check_relation, is_condition
from verification.diagnose import Diagnostician
from verification.document import Display, Document, Table, read_document
from verification.equation import ChainChecker, Outcome
from verification.errors import DocumentError, ReadError, TooComplex
from verification.general import GeneralStatements
from verification.latex import nodes as n
from verification.latex.statements import PREVIOUS
from verification.latex.tokens import normalise_unicode, original_offset
from verification.names import read_names
from verification.tables import check_array_table, check_table
from verification.trig import AngleFraction, Ring, Scalar
from verification.verdict import DocumentResult, Record, Verdict, worst

SECONDS_TO_DECIDE = 1.3  # a display is bounded by two seconds in all: so long to decide it,
SECONDS_TO_EXPLAIN = 0.5  # and so long to say what is wrong in it
SAMPLES = 1000
SEED = 2019


def verify(path: Path, *, confirm: bool = True) -> DocumentResult:
    """Return the verdicts of a document file; raises DocumentError where the document as a whole cannot be checked."""
    return check_document(read_document(path), confirm=confirm)


def check_document(document: Document, *, confirm: bool = True) -> DocumentResult:
    """Return the verdicts of a document; `confirm` also evaluates each proved equation on the double plant."""
    arm = _load(document)
    denominators: dict[str, int] = {}
    for _ in range(8):
        try:
            return DocumentChecker(document, arm, denominators, confirm).run()
        except AngleFraction as fraction:  # θ/2 was met: begin again with it as the ring's generator
            denominators[fraction.symbol] = fraction.denominator
    raise DocumentError(f"{document.path}: fractions of angles with too many denominators")


def _load(document: Document) -> Arm | None:
    spec = document.front.get("arm")
    if spec is None:
        return None
    try:
        return load_arm(spec, document.path.parent)
    except ArmproofError as error:
        raise DocumentError(f"{document.at('arm')}: {error}") from None


@lru_cache(maxsize=32)
def _configurations(arm: Arm) -> tuple[np.ndarray, np.ndarray]:
    """The configurations, and which of them are drawn at random."""
    q, family = sample(arm, SAMPLES, np.random.default_rng(SEED))
    return q, np.isin(family, [FAMILIES.index("generic"), FAMILIES.index("wide")])


class DocumentChecker:
    """Checks the displays of one document in order, each with the names that those before it defined."""

    def __init__(self, document: Document, arm: Arm | None, denominators: Mapping[str, int], confirm: bool = True) -> None:
        self.document = document
        self.arm = arm
        try:
            self.names = read_names(arm, document.front)
        except DocumentError as error:
            raise DocumentError(f"{document.at(error.key or 'quantities')}: {error}") from None
        self.ring = Ring(denominators)
        self.exact = ExactAlgebra(self.ring, arm)
        self._sampled: SampledAlgebra | None = None
        self.checker = ChainChecker(self.names, self.exact, self.sampled)
        self.checker.confirm = confirm
        self.diagnostician = Diagnostician(self.checker)
        self.general = GeneralStatements(self.checker)
        self.subject: n.Node | None = None

    def sampled(self) -> SampledAlgebra:
        """The double plant at the configurations of the six families."""
        if self._sampled is None:
            everywhere = np.zeros((SAMPLES, 0)), np.ones(SAMPLES, dtype=bool)
            q, at_random = _configurations(self.arm) if self.arm is not None else everywhere
            self._sampled = SampledAlgebra(self.exact, q, SEED)
            self._sampled.random = at_random
        return self._sampled

    def run(self) -> DocumentResult:
        """Return the verdicts of all displays and tables, in the order of the document."""
        started = time.perf_counter()
        equations = tuple(self.check_display(display) for display in self.document.displays)
        tables = tuple(self._table(table) for table in self.document.tables)
        name = self.arm.name if self.arm is not None else ""
        seconds = time.perf_counter() - started
        warnings = self.arm.warnings if self.arm is not None else ()
        return DocumentResult(str(self.document.path), name, equations, tuple(t for t in tables if t is not None), warnings, seconds)

    def _table(self, table: Table) -> Record | None:
        self.ring.deadline = time.monotonic() + SECONDS_TO_DECIDE
        return check_table(self.checker, table)

    # -- displays ---------------------------------------------------------------------------------------------------

    def check_display(self, display: Display) -> Record:
        """Return the record of one display."""
        record = Record(display.line, display.latex, Verdict.UNREADABLE, display.erratum, cell=display.cell, section=display.section)
        if not display.closed:
            return replace(record, message="the display opened by $$ never ends")
        self.ring.deadline = time.monotonic() + SECONDS_TO_DECIDE
        self.names.section = display.section
        try:
            if (table := check_array_table(self.checker, display)) is not None:
                return table
            return self._judge(record, display, self.names.reader.read(display.latex))
        except ReadError as error:
            return replace(record, message=f"{_place(display, original_offset(display.latex, error.offset))}: {error}")
        except TooComplex as error:
            return replace(record, verdict=Verdict.UNCHECKED, message=f"too large to decide: {error}")
        except RecursionError:
            return replace(record, verdict=Verdict.UNCHECKED, message="too large to decide: nested too deeply")
        except AngleFraction:
            raise
        except Exception as error:  # a fault of ours must not cost the other displays their verdicts
            fault = f"internal error, please report it: {type(error).__name__}: {error}"
            return replace(record, message=fault)

    def _judge(self, record: Record, display: Display, statements: list[n.Statement]) -> Record:
        outcomes, extra = self._with_later_definitions(statements, display)
        if not outcomes:
            return replace(record, verdict=Verdict.DEFINED, message="states no equation")
        verdict = worst([outcome.verdict for outcome in outcomes])
        leading = [outcome for outcome in outcomes if outcome.verdict is verdict]
        errors = [outcome.max_error for outcome in outcomes if outcome.max_error is not None]
        record = replace(
            record,
            verdict=verdict,
            message="; ".join(dict.fromkeys(outcome.message for outcome in leading if outcome.message)),
            samples=max((outcome.samples for outcome in outcomes), default=0),
            max_error=max(errors, default=None),
            counterexample=extra,
        )
        if verdict is Verdict.REFUTED:
            self.ring.deadline = time.monotonic() + SECONDS_TO_EXPLAIN
            try:
                record = self.diagnostician.diagnose(record, normalise_unicode(display.latex), [o for o in outcomes if o.verdict is Verdict.REFUTED])
            except TooComplex:
                record = replace(record, message=record.message or "the two sides differ; what is wrong is too large to tell")
        return record

    def _with_later_definitions(self, statements: list[n.Statement], display: Display) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes; a name may be defined after its use in the display ("…, where D = …")."""
        known = len(self.names.definitions)
        outcomes, extra = self.outcomes(statements, display.line, define=not display.erratum)
        if len(self.names.definitions) > known and any(o.verdict is Verdict.UNCHECKED for o in outcomes):
            again, extra = self.outcomes(statements, display.line, define=not display.erratum)
            if len(again) == len(outcomes):
                outcomes = [new if old.verdict is Verdict.UNCHECKED else old for old, new in zip(outcomes, again, strict=True)]
        return outcomes, extra

    def outcomes(self, statements: list[n.Statement], line: int, *, define: bool = True) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes of a display's statements and, for a refuted condition, its counterexample."""
        statements = [part for statement in statements for part in _without_vanishing_end(self._resolve_subject(statement))]
        outcomes: list[Outcome] = []
        extra: dict[str, float] = {}
        equation = 1
        index = 0
        while index < len(statements):
            statement = statements[index]
            self.ring.check_time()
            if isinstance(statement, n.Connective):
                index += 1
                continue
            implication = self._conditional(statements, index)
            if implication is not None:
                kind, premises, conclusions, after = implication
                first = [o for chain in premises for o in self._chain(chain, equation, line, define)]
                holds = all(o.verdict not in (Verdict.REFUTED, Verdict.UNCHECKED) and not _is_condition(o) for o in first)
                arrow = "⇐" if kind == "if" else kind
                outcome: Outcome | None = None
                found: dict[str, float] = {}
                conditional = kind == "if" or any(is_condition(chain) for chain in premises)
                if conditional or all(is_condition(chain) for chain in conclusions):
                    outcome, found = check_implication(self.checker, arrow, premises, conclusions, equation)
                    conditional = conditional or outcome.verdict is not Verdict.UNCHECKED
                if kind != "if" and (holds or not conditional):
                    # a step of a derivation: it is a claim of its own, and so is what follows
                    outcomes.extend(first)
                    equation += sum(len(chain.relations) for chain in premises)
                    index += len(premises) + _words_between(statements, index, len(premises))
                    continue
                assert outcome is not None
                outcomes.append(outcome)
                extra.update(found)
                equation += sum(len(chain.relations) for chain in (*premises, *conclusions))
                index = after
                continue
            outcomes.extend(self._chain(statement, equation, line, define))
            equation += len(statement.relations)
            index += 1
        first_chain = next((s for s in statements if isinstance(s, n.Chain)), None)
        if first_chain is not None and define:
            self.subject = first_chain.members[0]
        return outcomes, extra

    def _resolve_subject(self, statement: n.Statement) -> n.Statement:
        """A display that begins with a relation goes on about the subject of the one before."""
        if isinstance(statement, n.Chain) and statement.members[0] is PREVIOUS and self.subject is not None:
            return replace(statement, members=(self.subject, *statement.members[1:]))
        return statement

    def _conditional(self, statements: list[n.Statement], index: int) -> tuple[str, list[n.Chain], list[n.Chain], int] | None:
        """Return (kind, premises, conclusions, where to go on) if an implication starts here."""
        premises, at = _alternatives(statements, index)
        if at >= len(statements):
            return None
        connective = statements[at]
        if not isinstance(connective, n.Connective) or connective.kind not in ("⇒", "⇔", "⇐", "if"):
            return None
        conclusions, after = _alternatives(statements, at + 1)
        if not conclusions or any(not chain.relations for chain in (*premises, *conclusions)):
            return None
        return connective.kind, premises, conclusions, after

    def _chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        unclear = [below for below in n.walk(chain) if isinstance(below, n.Ambiguous)]
        return self._either_reading(chain, unclear, equation, line, define) if unclear else self._clear_chain(chain, equation, line, define)

    def _either_reading(self, chain: n.Chain, unclear: list[n.Ambiguous], equation: int, line: int, define: bool) -> list[Outcome]:
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
        choice = "all that follows the slash taken as the denominator" if whole else "the slash dividing by the next factor alone"
        note = f"'{unclear[0].text}' read with {choice}" if any(good) else f"neither reading of '{unclear[0].text}' holds"
        for outcome in outcomes:
            outcome.message = f"{outcome.message}; {note}" if outcome.message else note
        return outcomes

    def _clear_chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if any(relation != "=" for relation in chain.relations):
            if all(relation in ("=", "≈") for relation in chain.relations) or len(chain.relations) == 1:
                return [check_relation(self.checker, chain, equation)]
            return [check_relation(self.checker, chain, equation)]
        if self._is_configuration(chain):
            return [Outcome(Verdict.DEFINED, "a configuration, not a claim", equation)]
        if any(isinstance(member, n.Cases) for member in chain.members):
            return self._cases(chain, equation, line, define)
        general = self.general.check(chain, equation, line, define)
        if general is not None:
            return general
        outcomes = self.checker.check(chain, equation, line, define)
        if self.arm is not None and outcomes and all(outcome.verdict is Verdict.UNCHECKED for outcome in outcomes):
            return self.general.identity(chain, equation, line) or outcomes
        return outcomes

    def _cases(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Check each case under its condition where that is an equation (σ_i = 0); words leave it unchecked."""
        cases = next(member for member in chain.members if isinstance(member, n.Cases))
        others = [member for member in chain.members if member is not cases]
        outcomes: list[Outcome] = []
        for value, condition in cases.branches:
            found = re.search(r"([^=]*?)=([^=]*)$", re.sub(r"\\(?:text|mathrm|textrm)\s*\{[^{}]*\}|\\q?quad", " ", condition))
            try:
                if found is None:
                    raise ReadError("words")
                at = tuple(self.names.reader.read_expression(side) for side in found.groups())
            except ReadError:
                return self.checker.check(chain, equation, line, define)
            members = tuple(n.At(member, ((at[0], at[1]),), span=member.span) for member in (*others, value))
            outcomes.extend(self.checker.check(replace(chain, members=members, relations=("=",) * len(others)), equation, line, False))
        return outcomes

    def _is_configuration(self, chain: n.Chain) -> bool:
        """A joint variable set to a constant, or a determinant set to zero, states a condition and claims nothing."""
        left, right, *more = chain.members if len(chain.members) > 1 else (chain.members[0], chain.members[0])
        if more and not all(_is_number(node) for node in (right, *more)):
            return False
        if isinstance(left, n.Sequence) and isinstance(right, n.Sequence) and len(left.items) == len(right.items):
            pairs = [n.Chain(pair, ("=",), span=chain.span) for pair in zip(left.items, right.items, strict=True)]
            return all(self._is_configuration(pair) for pair in pairs)
        if isinstance(left, n.Call) and left.function == "det" and isinstance(right, n.Number) and right.value == 0:
            at_values = any(isinstance(below, n.At) for below in n.walk(left))  # det J|_{θ_3 = 0} = 0 is a claim
            return not at_values and not self._vanishes(left)
        if self.arm is None or not isinstance(left, n.Name):
            return False
        symbol = self.names.known_symbol(left.key)
        if left.dots or symbol is None:
            return not left.dots and self._is_given_coordinate(left, right)
        if symbol not in {joint.symbol for joint in self.arm.joints}:
            return self._is_given_length(symbol, right)
        names = [below.key for below in n.walk(right) if isinstance(below, n.Name)]
        calls = any(isinstance(below, n.Call | n.JointAngles | n.Matrix) for below in n.walk(right)) and not _is_number(right)
        if calls or not all(key in ("pi", "k", "n") for key in names):
            return False
        self._remember(symbol, right)
        return True

    def _is_given_coordinate(self, name: n.Name, value: n.Node) -> bool:
        """P_x = 0.5 is where the tool is asked to be, when P_x depends on the joints; P_x = 0 would be a claim."""
        quantity = self.names.quantity(name)
        if quantity is None or not quantity.scalar or not _is_number(value):
            return False
        numbers = [below for below in n.walk(value) if isinstance(below, n.Number)]
        return any("." in number.text or number.value >= 2 for number in numbers)

    def _is_given_length(self, symbol: str, value: n.Node) -> bool:
        """A length of a DH table set to a number is data: the table gives it none."""
        assert self.arm is not None
        if self.arm.dh is None or symbol not in self.arm.lengths or any(isinstance(b, n.Name | n.Call | n.Matrix) for b in n.walk(value)):
            return False
        self._remember(symbol, value)
        return True

    def _remember(self, symbol: str, value: n.Node) -> None:
        """Keep the value that a display gives a joint or a length, for the numeric matrices that follow."""
        member = self.checker.member(value)
        if member.known:
            self.names.configuration[symbol] = float(self.sampled().from_exact(member.value)[0])

    def _vanishes(self, node: n.Node) -> bool:
        member = self.checker.member(node)
        constant = isinstance(member.value, Scalar) and member.value.as_fraction() is not None
        return member.problem is not None or constant or bool(getattr(member.value, "is_zero", bool)())


def _without_vanishing_end(statement: n.Statement) -> list[n.Statement]:
    """det J = l_1 l_2 s_2 = 0 is an equation and a condition."""
    if not isinstance(statement, n.Chain) or len(statement.members) < 3 or set(statement.relations) != {"="}:
        return [statement]
    *first, last = statement.members
    if not isinstance(last, n.Number) or last.value != 0 or any(isinstance(member, n.Number | n.Matrix) for member in first):
        return [statement]
    determinant = isinstance(first[0], n.Call) and first[0].function in ("det", "abs")
    if not determinant:
        return [statement]
    claim = replace(statement, members=tuple(first), relations=statement.relations[:-1])
    return [claim, replace(statement, members=(first[0], last), relations=("=",))]


def _is_number(node: n.Node) -> bool:
    """Whether a tree is made of numbers, π and functions of them."""
    return not any(
        (isinstance(below, n.JointAngles | n.Matrix | n.Sequence) and below is not node) or (isinstance(below, n.Name) and below.key != "pi")
        for below in n.walk(node)
    ) and not isinstance(node, n.JointAngles | n.Matrix | n.Sequence)


def _is_condition(outcome: Outcome) -> bool:
    return outcome.verdict is Verdict.DEFINED and ("condition" in outcome.message or "configuration" in outcome.message)


def _alternatives(statements: list[n.Statement], index: int) -> tuple[list[n.Chain], int]:
    """Return the chains joined by "or" (or a mere comma between equations of one variable) from here on."""
    chains: list[n.Chain] = []
    while index < len(statements):
        statement = statements[index]
        if isinstance(statement, n.Chain):
            if chains and not (isinstance(statements[index - 1], n.Connective)):
                break
            chains.append(statement)
            index += 1
        elif statement.kind == "or" and chains:
            index += 1
        else:
            break
    return chains, index


def _words_between(statements: list[n.Statement], index: int, chains: int) -> int:
    """How many connectives stand among the next `chains` chains."""
    seen = words = 0
    while seen < chains:
        if isinstance(statements[index + seen + words], n.Chain):
            seen += 1
        else:
            words += 1
    return words


def _place(display: Display, offset: int) -> str:
    before = display.latex[:offset]
    line = display.line + before.count("\n") + (1 if "\n" in display.latex else 0)
    column = offset - (before.rfind("\n") + 1) + 1
    where = f"line {line}" if display.cell is None else f"cell {display.cell}, line {line}"
    return f"{where}, column {column} of the display"
