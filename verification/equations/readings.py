"""The other readings that a display may have: parts of a Jacobian, an angle of its own, a slipped index, an index above."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Set
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.given_values import keys_alone
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.errors import UnboundName
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, has_branches
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import ANGULAR, LINEAR, leads_outwards, numbered_frames
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

Check = Callable[[n.Chain], list[Outcome]]
# not of a step, (k) or (n), nor of another configuration than a solution
_COUNT = regex(
    r"\(?(?:[+-]|pm|mp|[ivIV]+|\d)\)?|\((?![kmnt]\)|(?:ref|des|max|min|old|new|init|start|end|goal|home)\))[A-Za-z]{1,10}\)|[A-D]|up|down|left|right|elbow(?:up|down)"
)
_NUMERAL = regex(r"(\d+),([ivIV]+)")
_PART = regex(r"(?P<part>[A-Za-z]*?)_?,?(?P<digits>\d|\d,?\d)")


class Readings:
    """Reads a chain as its author meant it, where notation alone leaves that open."""

    def __init__(self, equality: Equality) -> None:
        self.equality = equality
        self.members = equality.members
        self.names = equality.names
        self.reads_of_tool = False  # while a chain is read with the tool's Jacobian

    def part(self, member: Member, known: list[Member]) -> Member:
        """An unbound J_1 or J_{12} that is equated to a column or a scalar is that part of the Jacobian."""
        if not isinstance(member.problem, UnboundName) or not isinstance(member.node, n.Name):
            return member
        quantity = _part_of_jacobian(member.node, known[0].value, self.names)
        if quantity is None or self._is_determinant_of_block(quantity, known[0].value):
            return member
        self.names.state.inferred[member.node.key] = quantity
        return self.members.evaluate(member.node)

    def _is_determinant_of_block(self, quantity: Quantity, value: Value) -> bool:
        """Whether what J_{11} or J_{22} is equated to is the determinant of that block of a Jacobian in four: det is left out."""
        rows, columns = quantity.rows or (), quantity.columns or ()
        whole = self.members.exact.jacobian(quantity.frame, quantity.reference)
        if not isinstance(value, Scalar) or rows != columns or rows not in ((1,), (2,)) or 3 * rows[0] > whole.shape[1]:
            return False
        place = range(3 * rows[0] - 3, 3 * rows[0])
        determinant, entry = whole.block(place, place).determinant(), whole.rows[rows[0] - 1][rows[0] - 1]
        is_entry = (value - entry).is_zero()
        return not is_entry and any((value - sign * determinant).is_zero() for sign in (1, -1))

    def printed_rotation(self, chain: n.Chain) -> Quantity | None:
        """Return the rotation of which a chain prints the matrix, or the one in the pose of which it does."""
        sizes = {
            (len(rows), len(rows[0])) for each in chain.members if (rows := written_rows(each)) and not keys_alone(each)
        }
        alone = [each for each in map(bare, chain.members) if isinstance(each, n.Name)]
        quantities = [quantity for each in alone if (quantity := self.names.quantity(each)) is not None]
        found = (each for each in quantities if each.kind in ("rotation", "pose") and each.rows is None)
        quantity = next(found, None) if sizes & {(3, 3), (4, 4)} else None
        return replace(quantity, kind="rotation") if quantity is not None else None

    def as_product_of_links(self, chain: n.Chain, outcomes: list[Outcome], check: Check) -> list[Outcome]:
        """A_{23} beside A_2 and A_3 may be their product: it is where that fits better than the link from frame 2 to 3."""
        inferred = self.names.state.inferred
        spoken = (each for member in chain.members for each in n.names(member))
        found = {each.key: q for each in spoken if (q := _product_of_links(each, self.names)) is not None}
        if not found:
            return outcomes
        inferred.update(found)
        tried = check(chain)
        if _count_wrong(tried) < _count_wrong(outcomes):
            return tried
        for key in found:
            inferred.pop(key, None)
        return outcomes

    def own_angle(self, member: Member, members: list[Member]) -> Member:
        """θ_{12} is θ_1 + θ_2, unless the display gives it another value: then it is the document's own name."""
        if not isinstance(member.node, n.Name) or not member.known or len(member.node.sub) > 2:
            return member
        if member.node.key in self.names.state.definitions or self.names.known_symbol(member.node.key) is not None:
            return member
        if self.names.angle_sum(member.node) is None or member.node.key in self.names.quantities:
            return member
        other = next((m for m in members if m is not member and m.known), None)
        if other is None:
            return member
        found = self.equality.compare(member, other, 0, has_branches(other.node))
        return Member(member.node, None, UnboundName(member.node.key)) if found.verdict is Verdict.REFUTED else member

    def other_meaning(self, outcome: Outcome, line: int, define: bool) -> Outcome:
        """A letter that stands for something of another size here: x-dot = J q-dot for a component x, a height z_1."""
        if not outcome.is_mismatch or outcome.true is None or outcome.printed is None:
            return outcome
        sides = (outcome.true, outcome.printed)
        implied, other = outcome.true, outcome.printed
        vector = (
            isinstance(implied.node, n.Name)
            and implied.node.base in "zZ"
            and implied.node.sub != "0"
            and not implied.node.pre_sup
        )
        number = isinstance(other.value, Scalar) and other.value.as_fraction() is None  # a height, not the constant 1
        if (
            define
            and vector
            and number
            and isinstance(implied.value, Matrix)
            and (key := bare_key(implied.node)) not in (*self.names.quantities, *self.names.state.definitions)
        ):
            self.names.define(str(key), self.members.meaning(other.node), line, node=other.node)
            found = (say(Kind.NUMBER_HERE, name=str(key)),)
            return replace(outcome, verdict=Verdict.DEFINED, findings=found, defines=(str(key),))
        rate = next((side.node for side in sides if isinstance(side.node, n.Name) and side.node.dots), None)
        matrices = [side for side in sides if isinstance(side.value, Matrix)]
        if (
            rate is None
            or self.names.is_free(replace(rate, dots=0))  # a free scalar's rate is a scalar
            or len(matrices) != 1
            or any(isinstance(b, n.Matrix) for side in sides for b in n.walk(side.node))
        ):
            return outcome
        return replace(outcome, verdict=Verdict.DEFINED, findings=(say(Kind.VECTOR_HERE, name=rate.key),))

    def of_the_tool(self, chain: n.Chain, outcomes: list[Outcome], settled: Set[str], check: Check) -> list[Outcome]:
        """A Jacobian that names no frame is that of the last one, or of the tool behind it: as the first equation says.

        If that is of neither, it is of the one of which fewer entries are wrong. So is a part of one, J_1 or J_{12}; `settled` are the names that earlier equations have given a meaning.
        """
        arm, state = self.names.arm, self.names.state
        left_open = self._of_last_frame([chain], settled)
        all_open = all(outcome.verdict is Verdict.UNCHECKED for outcome in outcomes)
        if arm is None or not left_open or all_open or self.reads_of_tool:
            return outcomes
        if not any(outcome.verdict is Verdict.REFUTED for outcome in outcomes):
            self._settle(left_open)
            return outcomes
        before = state.shown
        self._read_of_tool(left_open)
        self.reads_of_tool = True  # a name that convention binds is asked anew, and would be read so again
        try:
            tried = check(chain)
        finally:
            self.reads_of_tool = False
        if _count_wrong(tried) < _count_wrong(outcomes):
            self._settle({key: state.inferred[key] for key in left_open})
            return tried
        state.shown = before
        for key in left_open:
            state.inferred.pop(key, None)
        return outcomes

    def of_either_frame(self, chains: Iterable[n.Chain], now: Verdict, again: Callable[[], Verdict]) -> Finding | None:
        """Say of which frame a Jacobian must be for a verdict, where it may be of the tool behind the last one as well."""
        arm, state = self.names.arm, self.names.state
        left_open = self._of_last_frame(chains, frozenset(state.inferred))
        if arm is None or not left_open:
            return None
        with state.unchanged():
            self._read_of_tool(left_open)
            other = again()
        if other is now:
            return None
        key, quantity = min(left_open.items())
        return say(Kind.FRAME_NOT_TOLD, name=key, frame=quantity.frame, tool=arm.frames[-1])

    def _read_of_tool(self, left_open: Mapping[str, Quantity]) -> None:
        """Take Jacobians for those of the tool, in rows that are to be told again."""
        arm, state = self.names.arm, self.names.state
        assert arm is not None
        state.shown = {key: rows for key, rows in state.shown.items() if key not in left_open}
        state.inferred.update({key: replace(each, frame=arm.frames[-1]) for key, each in left_open.items()})

    def _of_last_frame(self, chains: Iterable[n.Chain], settled: Set[str]) -> dict[str, Quantity]:
        """Return the Jacobians that name no frame, of an arm with a tool behind its last one; `settled` have a meaning."""
        arm = self.names.arm
        if arm is None or not self.names.has_tool:
            return {}
        last = numbered_frames(arm)[-1]
        return {
            name.key: quantity
            for below in (each for chain in chains for each in n.walk(chain))
            if (name := self.members.jacobian_name(below, True)) is not None
            and name.key not in settled
            and (name.pre_sup or name.sup or "J" not in settled)
            and (quantity := self.names.quantity(replace(name, dots=0))) is not None
            and quantity.frame == last
            and name.sub != "n"
        }

    def _settle(self, read: Mapping[str, Quantity]) -> None:
        """What one Jacobian in the base frame is of, all are: J_v after J."""
        arm, state = self.names.arm, self.names.state
        state.inferred.update(read)
        if arm is None:
            return
        base = numbered_frames(arm)[0]
        for frame in {quantity.frame for quantity in read.values() if quantity.reference == base}:
            for name in (n.Name("J", index) for index in ("", *LINEAR, *ANGULAR)):
                quantity = self.names.quantity(name)
                if quantity is not None and quantity.kind == "jacobian":
                    state.inferred.setdefault(name.key, replace(quantity, frame=frame))

    def other_direction(self, chains: Iterable[n.Chain], now: bool, holds: Callable[[], bool]) -> Finding | None:
        """Say which index must name the reference for equations to hold, where only one of them may and the author states none.

        Nothing tells, or all names are written the other way round than the link matrices that do: T_0^2 = T_0^1 T_1^2 after T_1^0.
        """
        names = self.names
        below = (each for chain in chains for member in chain.members for each in n.walk(member))
        indexed = [each for each in below if isinstance(each, n.Name) and each.sub and each.sup]
        if names.arm is None or names.stated_transforms or not indexed:
            return None
        before, other = names.state.transforms, "upper" if names.transforms == "lower" else "lower"
        if not all(leads_outwards(name, names.arm, other) for name in indexed):
            return None
        index = names.transforms
        names.state.transforms = other
        try:
            holding = [now, holds()]
        finally:
            names.state.transforms = before
        index = index if holding[0] else other
        return say(Kind.HOLDS_IF_REFERENCE, index=index, name=indexed[0].text) if holding[0] != holding[1] else None


def _product_of_links(name: n.Name, names: Names) -> Quantity | None:
    """Return the product that A_{23} is of A_2 and A_3, where nothing has told what it means; else None."""
    digits = re.fullmatch(r"([1-9])([1-9])", name.sub)
    taken = name.key in names.quantities or name.key in names.state.definitions or name.key in names.state.inferred
    if digits is None or int(digits[2]) != int(digits[1]) + 1 or name != n.Name(name.base, name.sub) or taken:
        return None
    first, last = (names.quantity(n.Name(name.base, digit)) for digit in digits.groups())
    if name.base not in ("A", "H") or first is None or last is None or last.reference != first.frame:
        return None
    return replace(first, frame=last.frame)


def _count_wrong(outcomes: Iterable[Outcome]) -> int:
    """Count the wrong entries of what is refuted."""
    return sum(max(1, len(outcome.wrong)) for outcome in outcomes if outcome.verdict is Verdict.REFUTED)


def counted(chain: n.Chain, names: Names) -> Finding | None:
    """Say that a script above a letter may be no power: θ^{(2)}, θ^1, a θ^2 alone on its side, which may count solutions; a θ° alone."""
    for member in chain.members:
        alone = bare(member)
        if isinstance(alone, n.Postfix) and alone.operator == "deg" and (key := bare_key(alone.base)) is not None:
            return say(Kind.DEGREES_OF_LETTER, name=key)
        for below in n.walk(member):
            if not isinstance(below, n.Power) or not _is_joint(below.base, names):
                continue
            exponent = below.exponent
            one = isinstance(exponent, n.Number) and exponent.value in (0, 1)
            if isinstance(exponent, n.Group) or one or bare(member) is below:
                return say(Kind.INDEX_OR_POWER)
    return None


def without_count(chain: n.Chain, names: Names) -> n.Chain | None:
    """Return a chain without the scripts of its joint variables that count solutions: θ_2^{(1)} = …, q_1^+ = …, θ_{2,I} = … s_3^+.

    A prime may count the second one, θ_2' beside a θ_2 that holds on a branch. None where there is none, where several of one joint are told apart or one from the variable, or where the script may be a power.
    """
    below = [each for member in chain.members for each in n.walk(member)]
    found = [(node, mark) for node in below if (mark := _count(node, names)) is not None]
    alone = {id(bare(member)) for member in chain.members}
    told = any(id(node) in alone or not mark.isdigit() for node, mark in found)
    plain = {id(node): _uncounted(node) for node, _ in found}
    marks = {(_spelt(plain[id(node)]), mark) for node, mark in found}
    keys = {key for key, _ in marks}
    numbers, signs = ({mark for _, mark in marks if (mark in "+-") is is_sign} for is_sign in (False, True))
    if not found or not told or len(marks) != len(keys) or len(numbers) > 1 or len(signs) > 1:
        return None
    inside = {id(each) for node, _ in found for each in n.walk(node)}
    if any(_spelt(each) in keys for each in below if id(each) not in inside):
        return None
    is_new = any(id(node) in alone and bare_key(node) not in names.state.definitions for node, _ in found)
    if not is_new and any(bare_key(node) in names.state.definitions for node, _ in found):
        return None  # a solution that has a name is that one
    return replace(chain, members=tuple(n.substitute_each(member, plain) for member in chain.members))


def _count(node: n.Node, names: Names) -> str | None:
    """Return the script above a joint variable that may count solutions, one in brackets with them."""
    if isinstance(node, n.Name) and node.primes:
        return "'" if may_be_second(node, names) else None
    if isinstance(node, n.Name):
        mark = found[2] if not node.sup and (found := _NUMERAL.fullmatch(node.sub)) else node.sup
        return mark if _COUNT.fullmatch(mark) and _is_joint(_uncounted(node), names) else None
    if isinstance(node, n.Postfix) and node.operator in ("+", "-") and _turns(node.base, names):
        return node.operator
    if not isinstance(node, n.Power) or not _is_joint(node.base, names):
        return None
    number = bare(node.exponent)
    brackets = isinstance(node.exponent, n.Group)
    is_count = isinstance(number, n.Number) and number.text.isdigit()
    return (f"({number.text})" if brackets else number.text) if is_count else None  # type: ignore[attr-defined]


def may_be_second(name: n.Name, names: Names) -> bool:
    """Whether θ_2' may be the second solution for a joint: its section gives θ_2 on a branch, or has shown a θ_3' to be that of its joint."""
    joint = names.known_symbol(_uncounted(name).key) if name.primes == 1 and not (name.sup or name.dots) else None  # type: ignore[attr-defined]
    if joint is None or not names.is_angle(joint):
        return False
    given = (each for key, each in names.state.branches.items() if key == joint or key.endswith("'"))
    return any(each.section == names.state.section for each in given)


def second_solutions(chain: n.Chain, names: Names) -> tuple[str, ...]:
    """Return the joints whose second solutions a chain speaks of."""
    below = (each for member in chain.members for each in n.names(member))
    keys = (names.known_symbol(_uncounted(each).key) for each in below if each.primes and may_be_second(each, names))  # type: ignore[attr-defined]
    return tuple(dict.fromkeys(key for key in keys if key is not None))


def _uncounted(node: n.Node) -> n.Node:
    """Return what stands for a joint without the script that counts its solutions."""
    if not isinstance(node, n.Name):
        return node.base  # type: ignore[attr-defined, no-any-return]
    numeral = _NUMERAL.fullmatch(node.sub)
    if node.primes:
        return replace(node, primes=0, text="")
    return replace(node, sub=numeral[1], text="") if numeral and not node.sup else replace(node, sup="")


def _spelt(node: n.Node) -> str:
    """Return the key of a name, and how the sine or the cosine of a joint is written; "" of anything else."""
    if isinstance(node, n.Call) and all(isinstance(each, n.JointAngles) for each in node.arguments):
        return "".join(f"{node.function}{each.terms}" for each in node.arguments)  # type: ignore[attr-defined]
    return bare_key(node) or "" if isinstance(node, n.Name) else ""


def _turns(node: n.Node, names: Names) -> bool:
    """Whether a node is a joint's angle, or the sine or the cosine of one."""
    angle = node.arguments[0] if n.is_call(node, "sin", "cos") else node
    if not isinstance(angle, n.JointAngles):
        return _is_joint(angle, names)
    return len(angle.terms) == 1 and names.is_angle(names.joint_angle(angle.terms[0][1]))


def side_by_side(chain: n.Chain) -> tuple[n.Chain, ...]:
    """Return A = […] and B = […] of a chain A = […] B = […]; nothing where no name stands behind a matrix in it."""
    if len(chain.members) < 3 or set(chain.relations) != {"="}:
        return ()
    first, *between, last = chain.members
    if bare_key(first) is None or not _is_written(last):
        return ()
    names, values = [first], []
    for member in between:
        factors = member.factors if isinstance(member, n.Product) else ()
        if len(factors) != 2 or not isinstance(factors[1], n.Name) or not isinstance(bare(factors[0]), n.Matrix):
            return ()
        names.append(factors[1])
        values.append(factors[0])
    return tuple(n.Chain(pair, ("=",)) for pair in zip(names, [*values, last], strict=True))


def _is_written(node: n.Node) -> bool:
    factors = map(bare, node.factors) if isinstance(node, n.Product) else (bare(node),)
    return all(isinstance(factor, n.Matrix) for factor in factors)


def _is_joint(node: n.Node, names: Names) -> bool:
    symbol = names.known_symbol(node.key) if isinstance(node, n.Name) and not node.dots else None
    return names.is_angle(symbol)


def _part_of_jacobian(name: n.Name, value: Value, names: Names) -> Quantity | None:
    """Return what an unbound J_k, J_{vk}, J_{ωk} or J_{ik} stands for, told by the size of what it is equated to.

    J_k is the k-th column where a 6×1 or shorter column stands on the other side, J_{ik} an entry where a scalar does
    (of the rows in which the document has shown J); a name with any other value is the document's own.
    """
    told = _told_part(name, names)
    if told is None:
        return None
    part, digits, column = told
    if len(digits) == 1 and isinstance(value, Matrix) and value.shape[1] == 1:
        if part and value.shape[0] == 3:
            return replace(column, rows=_rows_of(part))
        return column if not part and value.shape[0] in (2, 3, 4, 6) else None  # 4: [z; 0]
    if len(digits) == 2 and not part and not isinstance(value, Matrix | list):
        rows = column.rows or names.rows_of("J") or (1, 2, 3, 4, 5, 6)
        row = int(digits[0])
        return replace(column, rows=(rows[row - 1],), scalar=True) if 1 <= row <= len(rows) else None
    return None


def column_of_jacobian(name: n.Name, names: Names) -> Quantity | None:
    """Return the column that a J_k, J_{vk} or J_{ωk} is where it can be nothing else, or None."""
    part, digits, column = _told_part(name, names) or ("", "", None)
    if column is None or len(digits) != 1:
        return None
    return replace(column, rows=_rows_of(part) if part else column.rows or names.rows_of("J"))


def _rows_of(part: str) -> tuple[int, ...]:
    return (1, 2, 3) if part in LINEAR else (4, 5, 6)


def _told_part(name: n.Name, names: Names) -> tuple[str, str, Quantity] | None:
    """Return the letters and the digits of the index of J_{v2}, with the column of J that the last digit counts."""
    found = _PART.fullmatch(name.sub)
    arm = names.arm
    if arm is None or name.base != "J" or found is None or name.sup or name.pre_sub or name.primes or name.dots:
        return None
    part, digits = found.group("part"), found.group("digits").replace(",", "")
    whole = _whole_jacobian(names, name.pre_sup)
    if whole is None or (part and part not in (*LINEAR, *ANGULAR)):
        return None
    column = int(digits[-1])
    if not 1 <= column <= len(whole.columns or arm.joints):
        return None
    return part, digits, replace(whole, columns=(whole.columns[column - 1],) if whole.columns else (column,))


def _whole_jacobian(names: Names, reference: str) -> Quantity | None:
    """The Jacobian of which the parts are: the one the front matter binds or the document has shown, else that of the last frame."""
    for key in () if reference else ("J", "J(q)", "J(theta)"):
        told = names.quantities.get(key) or names.state.inferred.get(key)
        if told is not None:
            return told if told.kind == "jacobian" else None
    assert names.arm is not None
    if reference and reference not in names.arm.frames:
        return None
    frames = numbered_frames(names.arm)
    return Quantity("jacobian", frames[-1], reference or frames[0])
