"""In which rows a Jacobian is read that only convention binds: decided once a section, by the matrix printed for it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, equal_matrices, square_rows
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.equations.rates import OMEGA_ABOVE, rows_told
from armproof.verification.equations.sides import Members
from armproof.verification.equations.told_rows import rows_of_task
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.quantities import numbered_frames, tells_frame
from armproof.verification.naming.state import JacobianRows
from armproof.verification.verdict import DECIDED, Verdict

WHOLE = (1, 2, 3, 4, 5, 6)
LINEAR_ROWS = (1, 2, 3)
PLANE = (1, 2)
MOST_JOINTS = 3  # of an arm whose determinants are taken only to see which frame is meant


class RowsOfJacobians:
    """Decides the rows of J, and remembers them: those of its matrix, else those that make it square."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names

    def take_task(self, meant: Sequence[str]) -> None:
        """Read J in the rows of the task that the text tells from here on, and no more as before where that is another."""
        told = rows_of_task(meant, self.names)
        if told != self.names.state.task_rows:
            self.names.state.task_rows = told
            self.names.state.shown.clear()

    def choose(self, chain: n.Chain) -> n.Chain:
        """Return a chain in which J of det J and J^{-1} is square; a matrix printed for J decides its rows anew."""
        shown = self.names.state.shown
        for key in {printed.key for printed in self._printed(chain)}:  # J = J = […] prints it once
            before = shown[key]
            is_told = before.rows == OMEGA_ABOVE and before.section == self.names.state.section  # by a twist [ω; v]
            if is_told and any(_prints_whole(chain, each) for each in self._printed(chain)):
                continue
            if not before.printed or before.columns or before.section != self.names.state.section:
                del shown[key]
        rows = rows_told(chain, self.names) or _rows_of_plane(chain)
        for below in n.walk(chain):
            if not isinstance(below, n.Name) or not self._is_open(below):
                continue
            is_told = rows is None and self.names.state.omega_is_first and _prints_whole(chain, below)
            if told := OMEGA_ABOVE if is_told else rows or self.names.state.task_rows:
                shown[replace(below, dots=0).key] = JacobianRows(told, self.names.state.section, printed=False)
        for below in [*n.walk(chain)]:
            inverted = isinstance(below, n.Postfix) and below.operator == "-1"
            if not inverted and not n.is_call(below, "det", "adj", "com", "abs"):
                continue
            inner = below.base if isinstance(below, n.Postfix) else below.arguments[0]  # type: ignore[attr-defined]
            name = self.members.jacobian_name(inner, True)
            is_open = name is not None and name.key not in shown
            if name is not None and is_open:
                self._take_tool(name)
            is_printed = name is not None and not is_open and shown[name.key].rows in (WHOLE, OMEGA_ABOVE, LINEAR_ROWS)
            rows = self._square(name) if name is not None and (is_open or is_printed) else None
            if name is None or rows is None:
                continue
            if is_open and self.members.jacobian_name(name) is not None:
                shown[name.key] = JacobianRows(rows, self.names.state.section, printed=False)
            else:  # J_v has three rows elsewhere, one of zeros, and J six
                chain = n.substitute(chain, below, n.substitute(below, inner, self._part(name, rows)))  # type: ignore[assignment]
        return chain

    def kept(self, outcome: Outcome) -> Outcome:
        """Remember the rows in which J is printed, not where most of it is wrong; what prints others than before is left open."""
        pair, true, printed = outcome.pair, outcome.true, outcome.printed
        name = self.members.jacobian_name(true.node, True) if true is not None else None
        if outcome.verdict not in DECIDED or pair is None or name is None or printed is None:
            return outcome
        if outcome.verdict is Verdict.REFUTED and name.key not in self.names.quantities and _is_turned(pair):
            return outcome.left_open(say(Kind.OMEGA_IS_FIRST))
        if outcome.verdict is Verdict.PROVED and pair.true_rows is None and self._is_told_only(name):
            self.names.state.shown[name.key] = replace(self.names.state.shown[name.key], printed=True)
            return outcome
        columns = tuple(column + 1 for column in pair.true_columns) if pair.true_columns is not None else None
        quantity = self.names.quantity(replace(name, dots=0))
        own = quantity.rows if quantity is not None and quantity.rows else WHOLE
        is_mostly_wrong = len(outcome.wrong) > len(pair.true.cells) / 2
        if self.members.jacobian_name(name) is None:
            if self._is_of_the_plane(name) or (columns is not None and not is_mostly_wrong):
                rows = own[: len(pair.true.rows)]  # with the plane's row of zeros, or without
                shown = JacobianRows(rows, self.names.state.section, columns=columns)
                self.names.state.shown.setdefault(name.key, shown)
            return outcome
        if pair.true_rows is None and columns is None and len(pair.true.rows) != len(WHOLE):
            return outcome
        rows = tuple(row + 1 for row in pair.true_rows) if pair.true_rows is not None else own
        before = self.names.rows_of(name.key)
        if before not in (None, rows) and not (before == WHOLE and self._are_zero_beyond(name, rows)):
            return outcome.left_open(say(Kind.ROWS_TOLD_OTHERWISE, name=name.text, rows=list(before or ())))
        if before is None and len(rows) == 1 < pair.true.shape[1]:  # a row is missing, or one alone is meant
            return outcome.left_open(say(Kind.ONE_ROW, name=name.text))
        if is_mostly_wrong or _is_beside_zeros(outcome):
            return outcome
        is_matrix = isinstance(bare(printed.node), n.Matrix)
        self.names.state.shown.setdefault(name.key, JacobianRows(rows, self.names.state.section, is_matrix, columns))
        return outcome

    def heed_column(self, outcome: Outcome) -> None:
        """A column J_2 that is right in some rows tells those of J, and of its other columns, until J is printed."""
        pair, state = outcome.pair, self.names.state
        name = bare(outcome.true.node) if outcome.true is not None else None
        column = state.inferred.get(name.key) if isinstance(name, n.Name) else None
        if outcome.verdict is not Verdict.PROVED or pair is None or pair.true_rows is None or column is None:
            return
        if column.kind == "jacobian" and column.columns and column.rows is None:
            rows = tuple(row + 1 for row in pair.true_rows)
            state.shown.setdefault("J", JacobianRows(rows, state.section, printed=False))
            whole = {k: q for k, q in state.inferred.items() if q.kind == "jacobian" and q.columns and q.rows is None}
            state.inferred |= {key: replace(each, rows=rows) for key, each in whole.items()}

    def _are_zero_beyond(self, name: n.Name, rows: tuple[int, ...]) -> bool:
        """Whether the rows of J that are not printed again hold zeros alone."""
        whole = self.members.evaluate(name).value
        others = [row for k, row in enumerate(whole.rows, 1) if k not in rows] if isinstance(whole, Matrix) else []
        return bool(others) and all(isinstance(cell, Scalar) and cell.is_zero() for row in others for cell in row)

    def with_fewer(
        self, chain: n.Chain, outcomes: list[Outcome], check: Callable[[n.Chain], list[Outcome]]
    ) -> list[Outcome]:
        """A product with J, whose rows nothing has told, that only fits with fewer of them is read so; J Jᵀ with square ones."""
        whole = [below for below in n.names(chain) if self._is_open(below)]
        whole = whole or self._planar_factors(chain)
        if not whole or any(member is below for member in chain.members for below in whole):
            return outcomes
        fitting, defined = None, self.names.state.definitions
        possible: Iterable[tuple[int, ...]] = ()
        if self._is_of_the_plane(whole[0]):
            possible = [PLANE]
        elif any(outcome.is_mismatch or outcome.is_overloaded for outcome in outcomes):
            possible = _likely_rows(self.members.evaluate(whole[0]).value)
        elif any(map(_is_gram, n.walk(chain))):
            possible = [self._square(whole[0]) or ()]
        for rows in filter(None, possible):
            read = chain
            for below in whole:
                read = n.substitute(read, below, self._part(below, rows))  # type: ignore[assignment]
            tried = check(read)
            if not any(outcome.is_mismatch or outcome.is_overloaded for outcome in tried):
                for outcome in tried:
                    outcome.findings = outcome.findings or (say(Kind.READ_AS_ROWS, rows=list(rows)),)
                if all(outcome.verdict is not Verdict.REFUTED for outcome in tried):
                    return tried
                if fitting is None:
                    fitting, defined = tried, self.names.state.definitions
        if fitting is None:
            return outcomes
        self.names.state.definitions = defined  # those of the rows that fit, and not of the last ones that were tried
        return fitting

    def others(
        self, chains: Iterable[n.Chain], outcomes: list[Outcome], again: Callable[[], list[Outcome]]
    ) -> Finding | None:
        """Say with which rows of J alone an equation holds, where nothing tells them, or where J is printed again."""
        if not any(outcome.verdict in DECIDED for outcome in outcomes):
            return None
        if hold(outcomes) and not any("=" in chain.relations for chain in chains):
            return None  # J ∈ ℝ^{6×4} tells them itself
        for name in self._open(chains):
            rows = self.names.rows_of(name.key)
            if rows is None and any(_prints_whole(chain, name) for chain in chains):
                continue  # six rows beside it tell them
            is_planar = self._is_of_the_plane(name)
            with self._read_in(
                name.key, None if rows is not None else PLANE if is_planar else self._square(name)
            ) as other:
                if other == rows:
                    continue
                tried = again()
                decided = not is_planar or any(each.verdict in DECIDED for each in tried)
                holding = [hold(outcomes), hold(tried) and decided]
            if holding[0] != holding[1] and rows is None:
                return say(Kind.ROWS_NOT_TOLD, name=name.text, rows=list(WHOLE if holding[0] else other or ()))
            if holding == [False, True]:
                return say(Kind.ROWS_TOLD_OTHERWISE, name=name.text, rows=list(rows or ()))
        return None

    def _open(self, chains: Iterable[n.Chain]) -> Iterator[n.Name]:
        """Yield the names of Jacobians whose rows are not told, or told by another matrix than the one beside them."""
        for chain in chains:
            again = [name.key for name in self._printed(chain)]
            for below in n.walk(chain):
                name = self.members.jacobian_name(below, True)
                is_told = name is not None and (name.key in again or self._is_told_only(name))
                if name is below and name is not None and (self._is_open(name) or is_told):
                    yield name
            yield from self._planar_factors(chain)

    def _planar_factors(self, chain: n.Chain) -> list[n.Name]:
        """Return the J_v of each J_v J_v^T and J_v^+ in a chain that may lack its row of zeros: with it the product is singular."""
        walked = [*n.walk(chain)]
        factors = [n.ungrouped(below.factors[0]) for below in walked if _is_gram(below)]  # type: ignore[attr-defined]
        factors += [
            n.ungrouped(below.base) for below in walked if isinstance(below, n.Postfix) and below.operator == "+"
        ]
        planar = {each for each in factors if isinstance(each, n.Name) and self._is_of_the_plane(each)}
        return [below for below in walked if below in planar]  # type: ignore[misc]

    def _is_of_the_plane(self, node: n.Node) -> bool:
        """Whether a node is a J_v that notation implies and that nothing has shown, of an arm that moves in the plane x, y."""
        name = self.members.jacobian_name(node, True)
        quantity = (
            self.names.quantity(replace(name, dots=0))
            if name is not None and name.key not in self.names.state.shown
            else None
        )
        if name is None or quantity is None or quantity.rows != (1, 2, 3):
            return False
        value = self.members.evaluate(replace(name, dots=0)).value
        return isinstance(value, Matrix) and len(value.rows[0]) > 1 and all(cell.is_zero() for cell in value.rows[2])

    def _is_told_only(self, name: n.Name) -> bool:
        """Whether a J has the rows of a task that the text tells, and no matrix that holds has shown them."""
        shown, told = self.names.state.shown.get(name.key), self.names.state.task_rows
        return bool(told) and shown is not None and shown.rows == told and not shown.printed

    def _is_open(self, node: n.Node) -> bool:
        name = self.members.jacobian_name(node)
        return name is not None and name.key not in self.names.state.shown

    @contextmanager
    def _read_in(self, key: str, rows: tuple[int, ...] | None) -> Iterator[tuple[int, ...] | None]:
        shown, before, told = self.names.state.shown, self.names.state.shown.copy(), self.names.state.task_rows
        shown.pop(key, None)
        self.names.state.task_rows = None
        if rows is not None:
            shown[key] = JacobianRows(rows, self.names.state.section, printed=False)
        try:
            yield rows
        finally:
            shown.clear()
            shown.update(before)
            self.names.state.task_rows = told

    def _printed(self, chain: n.Chain) -> Iterator[n.Name]:
        """Yield the names of Jacobians for which a chain prints a matrix."""
        if any(isinstance(bare(member), n.Matrix) for member in chain.members):
            for member in chain.members:
                name = self.members.jacobian_name(member, True)
                if name is not None and name.key in self.names.state.shown:
                    yield name

    def _take_tool(self, name: n.Name) -> None:
        """Let J be the tool's where the last frame stands still while a joint moves: there det J is zero at every configuration."""
        plain, arm = replace(name, dots=0), self.names.arm
        quantity = self.names.quantity(plain)
        if arm is None or quantity is None or not self.names.has_tool or len(arm.joints) > MOST_JOINTS:
            return
        if (
            quantity.frame != numbered_frames(arm)[-1]
            or plain.key in self.names.quantities
            or tells_frame(plain, quantity)
        ):
            return
        still, moving = (self._measure(replace(quantity, frame=each)) for each in (quantity.frame, arm.frames[-1]))
        if still is not None and moving is not None and still.is_zero() and not moving.is_zero():
            self.names.state.inferred[plain.key] = replace(quantity, frame=arm.frames[-1])

    def _measure(self, quantity: Quantity) -> Scalar | None:
        """Return the determinant of the square rows of a Jacobian; None where it has none."""
        whole = self.members.exact.quantity(quantity)
        if not isinstance(whole, Matrix):
            return None
        rows = tuple(range(whole.shape[0])) if whole.shape[0] == whole.shape[1] else square_rows(whole)
        if rows is None:
            return None
        determinant = whole.block(rows, range(whole.shape[1])).determinant()
        return determinant if isinstance(determinant, Scalar) else None

    def _square(self, name: n.Name) -> tuple[int, ...] | None:
        is_turned = self.names.rows_of(name.key) == OMEGA_ABOVE
        with self._read_in(name.key, None) if is_turned else nullcontext():
            value = self.members.evaluate(replace(name, dots=0)).value
        quantity = self.names.quantity(replace(name, dots=0))
        is_column = quantity is not None and quantity.columns is not None
        if not isinstance(value, Matrix) or value.shape[0] == value.shape[1] or is_column:
            return None
        rows = square_rows(value)
        return tuple(row + 1 for row in rows) if rows is not None else None

    def _part(self, name: n.Name, rows: tuple[int, ...]) -> n.Name:
        """Return the name of some rows of a Jacobian, which stands for it in a tree."""
        quantity = self.names.quantity(replace(name, dots=0))
        assert quantity is not None
        part = replace(name, sub=f"{name.sub}rows {rows}")
        self.names.state.inferred[replace(part, dots=0).key] = replace(quantity, rows=rows)
        return part


def _is_beside_zeros(outcome: Outcome) -> bool:
    """Whether a wrong entry stands in a row of zeros: the row may be another one that has a slip."""
    rows = outcome.pair.true.rows if outcome.pair is not None and outcome.verdict is Verdict.REFUTED else ()
    return any(all(isinstance(cell, Scalar) and cell.is_zero() for cell in rows[row]) for row, _ in outcome.wrong)


def _is_turned(pair: Pair) -> bool:
    """Whether a Jacobian is printed with the rows of ω above those of v, or the other way round, and is right so."""
    printed, rows = pair.printed, pair.true_rows or tuple(range(len(pair.true.rows)))
    if printed.shape != pair.true.shape or len(rows) != len(printed.rows):
        return False
    angular = sum(row >= len(LINEAR_ROWS) for row in rows)
    if not 0 < angular < len(rows) or (pair.true_rows is None and len(rows) != len(WHOLE)):
        return False
    order = [*range(angular, len(rows)), *range(angular)]
    return equal_matrices(pair.true, printed.block(order, range(printed.shape[1])))


def _rows_of_plane(chain: n.Chain) -> tuple[int, ...] | None:
    """Return the two rows of the plane where J = ∂p/∂q is printed in them: p has no third one there."""
    sides = [bare(member) for member in chain.members]
    is_derivative = any(isinstance(side, n.Derivative) for side in sides)
    is_in_plane = any(isinstance(side, n.Matrix) and len(side.rows) == len(PLANE) for side in sides)
    return PLANE if is_derivative and is_in_plane else None


def _prints_whole(chain: n.Chain, name: n.Name) -> bool:
    """Whether a chain prints a matrix of six rows for a name that stands alone."""
    sides = [bare(member) for member in chain.members]
    return name in sides and any(isinstance(side, n.Matrix) and len(side.rows) == len(WHOLE) for side in sides)


def _likely_rows(value: Value) -> Iterator[tuple[int, ...]]:
    """Yield the rows (from 1) that a shorter Jacobian is likely to hold: v, the plane's, all that move, ω."""
    if not isinstance(value, Matrix):
        return
    moving = tuple(i for i, row in enumerate(value.rows, 1) if not all(cell.is_zero() for cell in row))
    yield from dict.fromkeys(rows for rows in ((1, 2, 3), (1, 2), moving, (4, 5, 6)) if rows)


def _is_gram(node: n.Node) -> bool:
    """Whether a tree is J J^T, which has no inverse for a Jacobian of six rows with fewer columns."""
    if not isinstance(node, n.Product) or len(node.factors) != 2:
        return False
    first, second = (n.ungrouped(factor) for factor in node.factors)
    return isinstance(second, n.Postfix) and second.operator == "T" and n.ungrouped(second.base) == first
