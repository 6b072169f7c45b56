"""Names that get a meaning from the display they stand in: alone, entry by entry, under a brace; once more, or another one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from itertools import permutations
from typing import Any

from armproof.verification.algebra.calculus import angles_in, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_scalar, stacked
from armproof.verification.algebra.protocol import OutsideAlgebra, Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, is_constant, is_near
from armproof.verification.equations.given_values import keys_alone
from armproof.verification.equations.letter_matrices import FEWEST_LETTERS
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.equations.printed_factors import letters_of_factor
from armproof.verification.equations.rates import stand_for_scalars
from armproof.verification.equations.readings import Readings
from armproof.verification.equations.rigid import mends_of, misses_group
from armproof.verification.equations.said_without_value import heed_formula, said_otherwise
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import EvaluationError, NoValue, UnboundName
from armproof.verification.evaluation.blocks import Block, cells_of, partition, written_rows
from armproof.verification.evaluation.calls import problem_of_arguments
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.latex import greek
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches
from armproof.verification.latex.vocabulary import UNWRITTEN
from armproof.verification.naming.conventions import AXES, is_usual
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.patterns import regex
from armproof.verification.verdict import HOLDS, Role, Verdict

Check = Callable[[n.Chain], list[Outcome]]
_PLACE = regex(r"(\d),?([1-6]),?([1-6])")  # of an entry: its matrix, row and column
MOST_WRONG = 2  # entries of a pose that is a slip away, where it holds letters without a value too


@dataclass
class _Entries:
    """What is found of the entries of a matrix: what a name is where it stands first, what is wrong, why one is not known."""

    first: dict[str, Value] = field(default_factory=dict)
    wrong: list[tuple[int, int]] = field(default_factory=list)
    unknown: EvaluationError | None = None


@dataclass(frozen=True)
class Definitions:
    """Gives unbound names their meaning in one chain.

    Attributes:
        readings: how else a member may be read.
        line: where the display stands.
        defines: whether the names are to keep their meaning after the display.
        fresh: the new letters of a matrix that the chain defines.
    """

    readings: Readings
    line: int
    defines: bool
    fresh: frozenset[str]

    @property
    def members(self) -> Members:
        """The sides of its equations."""
        return self.readings.members

    @property
    def names(self) -> Names:
        """The names of the document."""
        return self.readings.names

    def define(self, true: Member, member: Member, equation: int) -> Outcome:
        """Give the unbound names of a member their meaning by what is known, or say what is not bound."""
        if isinstance(member.problem, OutsideAlgebra):
            branches = has_branches(true.node) or has_branches(member.node)
            return self.readings.equality.route.confirm_only(true.node, member.node, equation, branches, member.problem)
        if isinstance(member.problem, NoValue):
            located = self.define_entries(true, member, equation, False)
            if located is not None and located.verdict is Verdict.REFUTED:
                return replace(located, findings=(finding_of(member.problem),))
            return Outcome(Verdict.REFUTED, (finding_of(member.problem),), equation, true, member)
        if _has_dots(member.node):
            return Outcome(Verdict.DEFINED, (say(Kind.PATTERN),), equation, true, member)
        if (
            isinstance(member.problem, UnboundName)
            and (found := self._define_unbound(true, member, equation)) is not None
        ):
            return found
        assert member.problem is not None
        return Outcome(Verdict.UNCHECKED, (finding_of(member.problem),), equation, true, member)

    def _define_unbound(self, true: Member, member: Member, equation: int) -> Outcome | None:
        """A name alone, its square, a matrix of names."""
        if (key := bare_key(member.node)) is not None:
            if any(isinstance(below, n.Name) and below.key == key for below in n.walk(true.node)):
                return Outcome(Verdict.UNCHECKED, (say(Kind.ON_BOTH_SIDES, name=key),), equation, true, member)
            if self.members.decimals(true.node, least=1) is None and (group := misses_group(member.node, true.value)):
                other = (say(Kind.NOT_IN_GROUP, group=group),)
                return _with_slip(Outcome(Verdict.UNCHECKED, other, equation, true, member, role=Role.DEFINITION))
            applied = bare(member.node)
            if n.is_call(applied, "name") and (other_joint := problem_of_arguments(true.value, applied, self.names)):
                return Outcome(Verdict.UNCHECKED, (other_joint,), equation, true, member)
            if self.defines and (second := said_otherwise(self.names, key, self.line)):
                return Outcome(Verdict.UNCHECKED, (second,), equation, true, member, role=Role.DEFINITION)
            if self.defines:
                self.names.define(key, self.members.meaning(true.node), self.line, node=true.node)
                if (decimals := self.members.decimals(true.node)) is not None:
                    self.names.state.rounded[key] = decimals
                if isinstance(member.node, n.Name):
                    self.names.add_frame(member.node)
            if self._is_entry_of_its_matrix(bare(member.node), true.value):
                return Outcome(Verdict.PROVED, (), equation, true, member)
            return Outcome(Verdict.DEFINED, (say(Kind.DEFINES, name=key),), equation, true, member, defines=(key,))
        if (factor := letters_of_factor(true.node, member.node, self.members)) is not None:
            named, letters = map(self.members.evaluate, factor)
            found = self.define_entries(named, letters, equation, self.defines)
            return found and replace(found, true=true, printed=member)
        if (solved := _solved(member, true.node)) is not None:
            root, formula = solved
            if self.defines:
                self.names.define(root, self.members.meaning(formula), self.line, root=formula)
            return Outcome(Verdict.DEFINED, (say(Kind.DEFINES, name=root),), equation, true, member, defines=(root,))
        return self.define_entries(true, member, equation, self.defines)

    def of_sine(self, outcome: Outcome) -> Outcome:
        """sin γ = k_2/r behind cos γ = k_1/r, of which the squares make 1, gives γ the sign that its cosine leaves open."""
        has_other_sign = outcome.verdict is Verdict.REFUTED or outcome.tells(Kind.SIGNED_DISTANCE)
        for side, other in permutations(outcome.sides if has_other_sign else (), 2):
            sine = bare(side.node)
            key = bare_key(sine.arguments[0]) if n.is_call(sine, "sin") else None
            definition = self.names.state.definitions.get(key or "")
            angle = definition.formula if definition is not None else None
            if key is None or definition is None or not n.is_call(angle, "acos"):
                continue
            values = other.value, self.members.evaluate(angle.arguments[0]).value
            sine_of, cosine_of = map(as_scalar, values)
            if not (isinstance(sine_of, Scalar) and isinstance(cosine_of, Scalar)):
                continue
            if not (sine_of * sine_of + cosine_of * cosine_of - sine_of.ring.one).is_zero():
                continue
            if self.defines:
                by_both = n.placed(n.Call("atan2", (other.node, *angle.arguments), "atan2"), other.node.span)
                meaning = partial(_by_both, self.names, (key, self.line), self.members.meaning(by_both))
                self.names.state.definitions[key] = replace(definition, evaluate=meaning, root=by_both)
            defines = (say(Kind.DEFINES, name=key),)
            return Outcome(Verdict.DEFINED, defines, outcome.equation, other, side, defines=(key,))
        return outcome

    def _is_entry_of_its_matrix(self, name: n.Node, value: Value) -> bool:
        """Whether a value is that of row 1 and column 4 of U_2, which has the name U_{214}."""
        places = (
            _PLACE.fullmatch(name.sub) if isinstance(name, n.Name) and name == n.Name(name.base, name.sub) else None
        )
        whole = (
            self.members.evaluate(n.Name(name.base, places[1])).value if places and isinstance(name, n.Name) else None
        )
        if places is None or not isinstance(whole, Matrix) or not isinstance(value, Scalar):
            return False
        row, column = int(places[2]) - 1, int(places[3]) - 1
        inside = row < whole.shape[0] > 1 and column < whole.shape[1] > 1
        return inside and self.readings.equality.equals_block(whole.rows[row][column], value)

    def define_entries(self, true: Member, member: Member, equation: int, defines: bool) -> Outcome | None:
        """A matrix whose unknown entries are bare names: each is defined by its place, the known ones are checked."""
        value, rows = stacked(true.value), written_rows(member.node)
        if isinstance(value, Matrix) and value.shape[0] == 1 and isinstance(bare(member.node), n.Sequence):
            rows = (tuple(cell for row in rows for cell in row),)  # a tuple may be a row
        alone = bare(rows[0][0]) if rows and len(rows) == 1 == len(rows[0]) else None
        is_one = isinstance(alone, n.Name) and not alone.base.isupper()  # [τ_1] is no column of torques
        blocks = partition(rows, value.shape) if rows and isinstance(value, Matrix) and not is_one else None
        if not isinstance(value, Matrix) or blocks is None:
            return None
        if (unclear := self._rows_unclear(true, blocks)) is not None:
            return Outcome(Verdict.UNCHECKED, (unclear,), equation, true, member)
        found = _Entries()
        written = [block for block in blocks if not _is_unwritten(block.cell)]
        for block in written:
            self._compare(found, block, blocks, true, value, defines)
        first, wrong, unknown = found.first, found.wrong, found.unknown
        if (other := self._of_series(blocks, wrong, first)) is not None:
            self.names.forget(first if defines else ())
            return Outcome(Verdict.UNCHECKED, (other,), equation, true, member)
        of_other_arm = unknown is not None and value.shape == (4, 4) and len(wrong) > MOST_WRONG
        if unknown is not None and of_other_arm:  # it has letters that this arm has not
            return Outcome(Verdict.UNCHECKED, (finding_of(unknown),), equation, true, member)
        if wrong:
            pair = Pair(value, value) if len(blocks) == len(value.cells) else None
            findings = () if pair else (say(Kind.WRONG_BLOCK),)
            return Outcome(Verdict.REFUTED, findings, equation, true, member, pair, wrong)
        if unknown is not None:
            return Outcome(Verdict.UNCHECKED, (finding_of(unknown),), equation, true, member)
        if written and not first:  # what is written holds
            return Outcome(Verdict.PROVED, (), equation, true, member)
        said = say(Kind.DEFINES_ENTRIES, names=list(first))
        return Outcome(Verdict.DEFINED, (said,), equation, true, member, defines=tuple(first))

    def _compare(
        self, found: _Entries, block: Block, blocks: Iterable[Block], true: Member, value: Matrix, defines: bool
    ) -> None:
        """Compare what is known of an entry with what stands in its place; a bare name is defined by that."""
        cell, key = self.members.evaluate(block.cell), bare_key(block.cell)
        if key in self.fresh or self._is_letter_of_block(cell, block, value):
            cell = Member(block.cell, None, UnboundName(str(key)))
        if cell.known or isinstance(cell.problem, NoValue):
            if not (cell.known and self.readings.equality.equals_block(block.of(value), cell.value)):
                found.wrong.append((block.row, block.column))
        elif key is None or not isinstance(cell.problem, UnboundName) or self._is_nothing(block, blocks, value):
            found.unknown = cell.problem
        elif key in found.first or _holds(
            block.of(value), key
        ):  # J = [γ_1 …] once more: it is what it is, and no entry of J
            itself = found.first[key] if key in found.first else self.members.exact.symbol(key)
            if not self.readings.equality.equals_block(itself, block.of(value)):
                found.wrong.append((block.row, block.column))
        else:
            found.first[key] = block.of(value)
            if defines:
                meaning = self.members.meaning(true.node, block)
                of_section = block.is_larger and not self.members.is_of_tool(true.node)
                self.names.define(key, meaning, self.line, by_place=True, of_section=of_section, whole=true.node)
                self._define_components(block)

    def _is_letter_of_block(self, cell: Member, block: Block, value: Matrix) -> bool:
        """Whether a letter that would be a number, in a document without an arm, stands for a block of more: the p of [R, p; 0, 1].

        A matrix of letters alone, r_11 … p_z, is a pattern, and its rotation obeys more than they do.
        """
        key = bare_key(block.cell)
        if self.names.arm is not None or key is None or not block.is_larger or key in self.names.state.definitions:
            return False
        is_letter = isinstance(cell.value, Scalar) and symbols_in([cell.value]) == {key}
        return is_letter and any(map(angles_in, value.cells))

    def _is_nothing(self, block: Block, blocks: Iterable[Block], value: Matrix) -> bool:
        """Whether a letter without a usual meaning stands beside formulas where a value has a zero: nobody writes a length that is none."""
        name, zero = bare(block.cell), as_scalar(block.of(value))
        if not (isinstance(zero, Scalar) and zero.is_zero() and isinstance(name, n.Name)):
            return False
        if is_usual(name) or name.sub in {*AXES}:
            return False
        formulas = (each.cell for each in blocks if bare_key(each.cell) is None)
        cells = (as_scalar(self.members.evaluate(cell).value) for cell in formulas)
        return any(isinstance(cell, Scalar) and symbols_in([cell]) for cell in cells)

    def _of_series(self, blocks: list[Block], wrong: list[tuple[int, int]], new: Iterable[str]) -> Finding | None:
        """Say that the x_1 of a column x_0, x_1, x_2 of new letters is one of these, and not what had that name before."""
        letters = [(block, name) for block in blocks if isinstance(name := bare(block.cell), n.Name) and name.sub]
        bases = {name.base for _, name in letters if name.key in new}
        for block, name in letters:
            if (block.row, block.column) in wrong and name.base in bases:
                before = self.names.state.definitions.get(name.key)
                return say(Kind.SECOND_MEANING, name=name.key, line=before.line if before else self.line)
        return None

    def _define_components(self, block: Block) -> None:
        """s, n, a of [s n a P]: the components of a column that a letter stands for have its letter, s_x, s_y, s_z."""
        letter = bare(block.cell)
        is_column = (len(block.rows), len(block.columns)) == (3, 1)
        if not is_column or not isinstance(letter, n.Name) or letter != n.Name(letter.base):
            return
        for row, axis in enumerate(AXES):
            component = partial(self._component, letter.base, row)
            self.names.define(n.Name(letter.base, axis).key, component, self.line, by_place=True)

    def _component(self, letter: str, row: int, algebra: Any) -> Value:
        """Return an entry of the column that a letter stands for, which is met so."""
        if letter not in self.names.state.definitions:
            raise UnboundName(letter)
        return self.names.defined_value(letter, algebra).rows[row][0]

    def _rows_unclear(self, true: Member, blocks: list[Block]) -> Finding | None:
        """Say that a Jacobian of six rows stands beside two or three components: nothing tells which rows it is to have."""
        named = n.names(true.node)
        jacobian = next((name for name in named if self.members.jacobian_name(name) is not None), None)
        if jacobian is None or not stand_for_scalars(blocks, self.names):
            return None
        return say(Kind.ROWS_BY_COMPONENTS, name=jacobian.text, count=len(blocks))

    def label(self, brace: n.Labelled, equation: int, check: Callable[[n.Chain], list[Outcome]]) -> Iterator[Outcome]:
        """A brace's label that is an unbound name gets the braced expression as its meaning; a bound one is a claim, and so is a usual one."""
        if brace.unread:
            yield Outcome(Verdict.UNCHECKED, (say(Kind.LEFT_OUT, text=brace.unread),), equation)
        if brace.label is None:
            return
        label, inner = self.members.evaluate(brace.label), self.members.evaluate(brace.inner)
        key = bare_key(brace.label)
        if label.known and inner.known:
            yield self.readings.equality.compare(label, inner, equation, False)
        elif key is not None and isinstance(label.problem, UnboundName) and inner.known and self.defines:
            is_jacobian = any(isinstance(each, n.Name) and each.base == "J" for each in n.walk(brace.label))
            name = bare(brace.label)
            is_told = is_jacobian or (isinstance(name, n.Name) and is_usual(name))
            found = check(n.Chain((brace.label, brace.inner), ("=",), span=brace.span)) if is_told else []
            if found and all(each.verdict in HOLDS or each.is_slip or _is_otherwise(each) for each in found):
                yield from (each for each in found if each.verdict is not Verdict.DEFINED)
            else:
                self.names.define(key, self.members.meaning(brace.inner), self.line)
        elif key is None and label.problem is not None:
            yield Outcome(Verdict.UNCHECKED, (finding_of(label.problem),), equation)

    def nothing_known(self, members: list[Member], equation: int) -> list[Outcome]:
        """Nothing has a value: a bare new name on one side is a definition in words or symbols, else unchecked."""
        if any(_has_dots(m.node) for m in members):
            return [Outcome(Verdict.DEFINED, (say(Kind.PATTERN),), equation)]
        outside = [m for m in members if isinstance(m.problem, OutsideAlgebra)]
        if len(outside) >= 2 and len(outside) == len(members):
            first, *others = outside
            return [
                self.readings.equality.route.confirm_only(
                    first.node, m.node, equation + k, has_branches(m.node), m.problem
                )
                for k, m in enumerate(others)
                if m.problem is not None
            ]
        shape = next((m.problem for m in members if isinstance(m.problem, NoValue)), None)
        if shape is not None:
            return [Outcome(Verdict.REFUTED, (finding_of(shape),), equation)]
        if len(members) == 1:
            return [Outcome(Verdict.DEFINED, (say(Kind.NO_EQUATION),), equation)]
        bare = next(
            (key for m in members if (key := bare_key(m.node)) is not None and isinstance(m.problem, UnboundName)), None
        )
        unbound = next(
            (m.problem for m in members if isinstance(m.problem, UnboundName) and m.problem.name != bare), None
        )
        other = next(
            (m.problem for m in members if m.problem is not None and not isinstance(m.problem, UnboundName)), None
        )
        if bare is not None and other is None:
            if self.defines and bare.startswith("R("):  # it may turn the other way than R(θ) usually does
                self.names.leave_unknown([bare], self.line)
            if self.defines:
                heed_formula(self.names, [m.node for m in members], self.line)
            given = (say(Kind.DEFINES_WITHOUT_VALUE, name=bare),)
            return [Outcome(Verdict.DEFINED, given, equation + k) for k in range(len(members) - 1)]
        problem = other or unbound
        findings = (finding_of(problem),) if problem is not None else ()
        return [Outcome(Verdict.UNCHECKED, findings, equation)]


def _is_otherwise(outcome: Outcome) -> bool:
    """Whether an equation is open, since its name usually is another quantity of the arm."""
    return outcome.verdict is Verdict.UNCHECKED and outcome.tells(Kind.NOT_AS_USUAL_BOUND)


def _with_slip(outcome: Outcome) -> Outcome:
    """Refute what is to be a rotation or a pose, and would be one with another entry in one place; which one, several may tell."""
    value = outcome.true.value if outcome.true is not None else None
    mends = [*mends_of(value)] if isinstance(value, Matrix) else []
    if not isinstance(value, Matrix) or not mends:
        return outcome
    if len(mends) > 1:
        return replace(
            outcome, verdict=Verdict.REFUTED, role=Role.CLAIM, true=outcome.printed, printed=outcome.true, defines=()
        )
    mended, place = mends[0]
    return outcome.as_wrong_claim(Pair(mended, value), [place])


def _by_both(names: Names, second: tuple[str, int], meaning: Callable[[Any], Value], algebra: Any) -> Value:
    """Return the value of an angle by its cosine and its sine, and remember that the second of them was asked for."""
    names.state.consulted.add(second)
    return meaning(algebra)


def _solved(member: Member, true: n.Node) -> tuple[str, n.Node] | None:
    """Return a name with what an equation says that it is: r of r² = x² + y², an angle by its tangent, one of a triangle by its cosine."""
    if (turned := angle_of_tangent(member.node, true)) is not None and _is_angle(turned[0]):
        return turned[0].key, turned[1]
    if (root := squared_name(member.node)) is not None:
        return root, n.Call("sqrt", (true,), "\\sqrt", span=true.span)
    key = member.problem.name if isinstance(member.problem, UnboundName) else ""
    spoken = [below for below in n.names(member.node) if below.key == key]
    cosines = [b for b in n.walk(member.node) if n.is_call(b, "cos") and b.arguments == (*spoken,)]
    is_matrix = any(isinstance(below, n.Matrix) for side in (member.node, true) for below in n.walk(side))
    if is_matrix or len(spoken) != 1 or len(cosines) != 1 or not _is_angle(spoken[0]):
        return None
    at_right_angle, at_none = (n.substitute(member.node, cosines[0], n.Number(Fraction(k))) for k in (0, 1))
    above, below = (n.Sum((("+", one), ("-", n.Group(at_right_angle)))) for one in (true, at_none))
    return key, n.placed(n.Call("acos", (n.Quotient(above, below, "frac"),), "arccos"), true.span)


def _holds(value: Value, key: str) -> bool:
    scalar = as_scalar(value)
    return isinstance(scalar, Scalar) and key in symbols_in([scalar])


def _is_angle(name: n.Name) -> bool:
    return name.base in greek.TURNED and not name.dots and not name.sub.isdigit()


def _is_unwritten(node: n.Node) -> bool:
    """Whether a cell holds but a mark for what is not written."""
    name = bare(node)
    return isinstance(name, n.Name) and name.base == UNWRITTEN


def squared_name(node: n.Node) -> str | None:
    """The r of r² = x² + y², which is a length and positive."""
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value == 2:
        return bare_key(node.base)
    return None


def angle_of_tangent(node: n.Node, value: n.Node) -> tuple[n.Name, n.Node] | None:
    """Return the β of tan β = y/x, and what it is: that of the arctangent, or half a turn beside it."""
    angle = bare(node.arguments[0]) if n.is_call(node, "tan") else None
    if not isinstance(angle, n.Name) or angle.dots or any(isinstance(below, n.Matrix) for below in n.walk(value)):
        return None
    return angle, n.placed(n.Call("atan", (value,), "arctan"), value.span)


def _has_dots(node: n.Node) -> bool:
    """Whether an ellipsis stands in a tree."""
    return any(isinstance(below, n.Dots) for below in n.walk(node))


@dataclass
class Redefinitions:
    """Judges chains `K = …` about a name K that has been defined by an equation of its own.

    A formula a slip away from the definition is wrong. Another one is a new meaning: in another section K gets it, in the
    same one it is not decided, and neither is what is said of K from there on. What repeats the definition decides nothing.
    """

    names: Names
    enabled: bool = True  # but in the premises of an arrow

    def before(self, chain: n.Chain) -> Definition | None:
        """Return the definition of the name that a chain is about; one with two meanings ends with its section."""
        state = self.names.state
        key = bare_key(chain.members[0]) if len(chain.members) > 1 and self.enabled else None
        definition = state.definitions.get(key) if key is not None else None
        others = (below for member in chain.members[1:] for below in n.names(member))
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
        about = [outcome for outcome in outcomes if name in outcome.nodes]
        is_as_usual = any(outcome.tells(Kind.SECOND_MEANING) for outcome in about)  # and no longer as it was defined
        if about and (is_as_usual or all(_is_another_meaning(outcome) for outcome in about)):
            found = self._with_another_meaning(chain, key, definition, outcomes[0], check)
            is_alone = len(found) == len(about) == 1 and found[0].tells(Kind.SECOND_MEANING)
            if is_alone and self.names.arm is not None and _has_root(definition.node):
                found[0].as_usual = AsUsual(about[0], {}, before=(key, definition))
            return found
        for outcome in about:
            sides = [*map(bare, outcome.nodes)]
            if outcome.verdict is Verdict.PROVED and definition.node is not None and bare(definition.node) in sides:
                outcome.verdict, outcome.findings = Verdict.DEFINED, (say(Kind.DEFINES, name=key),)
                outcome.repeats = (key, definition.line)
        return outcomes

    def unless_said(self, outcome: Outcome, line: int) -> Outcome:
        """Return an equation that says of a letter what a line before says that it is, v = w behind v = w: it decides nothing."""
        if outcome.verdict is not Verdict.PROVED or len(outcome.nodes) != 2:
            return outcome
        for letter, other in (outcome.nodes, outcome.nodes[::-1]):
            key = bare_key(letter)
            before = self.names.state.definitions.get(key) if key is not None else None
            if before is None or before.node is None or before.line == line:
                continue
            if bare(before.node) == bare(other):
                said = say(Kind.DEFINES, name=key)
                return replace(outcome, verdict=Verdict.DEFINED, findings=(said,), repeats=(str(key), before.line))
        return outcome

    def unless_repeated(self, outcome: Outcome, line: int) -> Outcome:
        """Return an equation of a column of letters that says what a line before says that they are: it decides nothing."""
        if outcome.verdict is not Verdict.PROVED or len(outcome.nodes) != 2:
            return outcome
        definitions = self.names.state.definitions
        for letters, other in (outcome.nodes, outcome.nodes[::-1]):
            keys = [str(bare_key(cell)) for cell in cells_of(letters)]
            before = map(definitions.get, keys)
            wholes = [each.whole if each is not None and each.line != line else None for each in before]
            if (
                keys
                and bare_key(other) is None
                and all(each is not None and bare(each) == bare(other) for each in wholes)
            ):
                said = say(Kind.DEFINES_ENTRIES, names=keys)
                repeated = (keys[0], definitions[keys[0]].line)
                return replace(outcome, verdict=Verdict.DEFINED, findings=(said,), repeats=repeated)
        return outcome

    def _with_another_meaning(
        self, chain: n.Chain, key: str, definition: Definition, first: Outcome, check: Check
    ) -> list[Outcome]:
        definitions = self.names.state.definitions
        if definition.section != self.names.state.section:
            del definitions[key]
            self.names.state.consulted.discard((key, definition.line))  # nothing rests on it
            return check(chain)
        second = say(Kind.SECOND_MEANING, name=key, line=definition.line)
        if (anew := self._anew(chain, key, definition, check)) is not None:
            return anew
        self.names.leave_open(key, second)
        definitions[key] = replace(definitions[key], has_two_meanings=True)
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

    def _anew(self, chain: n.Chain, key: str, definition: Definition, check: Check) -> list[Outcome] | None:
        """D = … once more, another formula of the arm: what then holds was meant so, and what fails is left open."""
        definitions = self.names.state.definitions
        if len(chain.members) > 2 or definition.has_two_meanings or definition.node is None:
            return None
        del definitions[key]
        outcomes = check(chain)
        if all(outcome.verdict is Verdict.DEFINED for outcome in outcomes) and key in definitions:
            definitions[key] = replace(definitions[key], has_two_meanings=True, is_last=True)
            outcomes[0].also(say(Kind.SECOND_MEANING, name=key, line=definition.line))
            return outcomes
        definitions[key] = definition
        return None


def _has_root(node: n.Node | None) -> bool:
    """Whether a formula holds a root: whether another one is a slip away from it, only samples tell."""
    return node is not None and any(n.is_call(below, "sqrt") for below in n.walk(node))


def _is_another_meaning(outcome: Outcome) -> bool:
    """Whether two formulas have little in common, or two numbers differ; a formula's number is a condition or a value."""
    pair = outcome.pair
    numbers = [is_constant(value) for value in (pair.true, pair.printed)] if pair is not None else []
    near = pair is not None and is_near(pair)
    return outcome.verdict is Verdict.REFUTED and not near and len(set(numbers)) < 2


def letters_meant_anew(outcomes: Iterable[Outcome]) -> frozenset[str]:
    """Return the letters of a matrix of letters that a name is equated to, where they had another meaning: R_3^6 = [r_ij]."""
    for outcome in outcomes:
        sides = [side for side in outcome.sides if side.known]
        letters = [keys_alone(side.node) for side in sides]
        is_named = any(bare_key(side.node) is not None for side in sides)
        if len(sides) == 2 and outcome.verdict not in HOLDS and is_named and max(map(len, letters)) >= FEWEST_LETTERS:
            return max(letters, key=len)
    return frozenset()
