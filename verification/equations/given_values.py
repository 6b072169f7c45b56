"""What a display gives and does not claim: values of joints and lengths, where the tool is to be, new letters, named signs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import chain as chain_cells
from itertools import pairwise
from typing import TypeGuard

from armproof.verification.algebra.calculus import are_rates, is_rate, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.at_stated_values import is_led_to
from armproof.verification.equations.equality import Equality
from armproof.verification.equations.sides import Member, Members
from armproof.verification.equations.stated_rates import columns_of_numbers
from armproof.verification.errors import UnboundName
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.latex import greek
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, is_number
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Stated, Told
from armproof.verification.verdict import Verdict

Pair = tuple[n.Node, n.Node]
Values = dict[str, n.Node]


class GivenValues:
    """Recognises displays that give data, and keeps the values that they give."""

    def __init__(self, equality: Equality) -> None:
        self.equality = equality
        self.members = equality.members
        self.names = equality.names

    def read(self, chain: n.Chain, line: int, define: bool) -> tuple[str, ...] | None:
        """Return the names that a display gives values, and keep these; None where it claims something."""
        values = self.values_of(chain)
        if define and values:
            self.remember(values, line)
        return None if values is None else tuple(values)

    def values_of(self, chain: n.Chain) -> Values | None:
        """Return the values that a chain gives, to one name or to several: l_1 = l_2 = 1; None where it claims something."""
        first, *others = chain.members
        if len(others) > 1 and all(map(self.members.is_symbol, chain.members[:-1])):
            return self._together((name, others[-1]) for name in chain.members[:-1])
        return self.values(first, others[0]) if others and (len(others) == 1 or all(map(is_number, others))) else None

    def values_of_all(self, chains: Iterable[n.Chain]) -> dict[str, n.Node]:
        """Return the values that chains give together, the last one where a name has several."""
        return {name: node for each in chains for name, node in (self.values_of(each) or {}).items()}

    def places_joints(self, chain: n.Chain) -> bool:
        """Whether a chain gives a joint a value."""
        return not set(self.values_of(chain) or ()).isdisjoint(self.joints)

    def is_condition(self, chain: n.Chain) -> bool:
        """Whether joints, lengths or rates are said to be related: θ_1 = θ_2, θ_2 = −2 θ_1, l_1 = 2 l_2, l_1 = l_2 = l, l_1 = l_2 = L/2."""
        if self._is_course(chain):
            return True
        related = self.related(chain) or self._related_lengths(chain)
        if len(related) < 2 or set(chain.relations) != {"="} or self._is_defined(chain.members[0]):
            return False
        named = [below for member in related for below in n.walk(member) if _is_letter(below)]
        variables = {(self._variable(name), name.dots) for name in named}
        kinds = {(str(symbol)[0], dots) for symbol, dots in variables}  # no rate is related to an angle
        if len(kinds) > 1 or len(variables) < 2:
            return False
        values = [self.members.evaluate(member).value for member in chain.members if member in related]
        scalars = [value for value in values if isinstance(value, Scalar)]
        return len(scalars) == len(values) and all(not (a - b).is_zero() for a, b in pairwise(scalars))

    def related(self, chain: n.Chain) -> list[n.Node]:
        """Return the members of a chain that are sums of variables, where each other one is a letter by itself: l_1 = l_2 = l."""
        if self.names.arm is None:
            return []
        sums = [each for each in chain.members if self._is_linear(each) and self._is_of_variables(each)]
        alone = all(isinstance(each, n.Name) and not each.dots for each in chain.members if each not in sums)
        return sums if alone and not any(self.members.evaluate(m).known for m in chain.members if m not in sums) else []

    def _related_lengths(self, chain: n.Chain) -> list[n.Node]:
        """Return the lengths that stand alone in a chain, where each other member is made of letters without a meaning: l_1 = l_2 = L/2."""
        if self.names.arm is None:
            return []
        lengths: list[n.Node] = [
            m for m in chain.members if isinstance(m, n.Name) and self._variable(m) in {*self.lengths}
        ]
        if len(lengths) < 2:
            return []
        others = [member for member in chain.members if member not in lengths]
        held = [name for member in others for name in n.names(member) if _is_letter(name)]
        unbound = all(
            not self.members.evaluate(name).known and self.names.known_symbol(name.key) is None for name in held
        )
        return lengths if held and unbound and all(any(n.names(m)) for m in others) else []

    def _is_course(self, chain: n.Chain) -> bool:
        """θ_1 = 2 t, θ_1 = 2 θ_2 = 4 t: how joints move in time."""
        *moved, course = chain.members
        in_time = any(isinstance(below, n.Name) and below.key == "t" for below in n.walk(course))
        of_joints = bool(moved) and all(any(map(_is_letter, n.walk(each))) for each in moved)
        is_told = of_joints and all(self._is_linear(each) and self._is_of_variables(each) for each in moved)
        return in_time and is_told and self.names.known_symbol("t") is None

    def _is_defined(self, node: n.Node) -> bool:
        return isinstance(node, n.Name) and node.key in self.names.state.definitions

    def _is_of_variables(self, node: n.Node) -> bool:
        return all(self._variable(below) is not None for below in n.walk(node) if _is_letter(below))

    def _variable(self, name: n.Name) -> str | None:
        """Return the joint or length that a name stands for, by an equation of the document too: l of l = l_1."""
        definition = self.names.state.definitions.get(name.key)
        if definition is not None and isinstance(definition.node, n.Name) and definition.node.base == name.base:
            name = definition.node
        return self.names.known_symbol(name.undotted.key)

    @staticmethod
    def _is_linear(node: n.Node) -> bool:
        """Whether a tree is a sum of names, each with a number, such as π/2 − 2 θ_1, √2 l_2."""
        if n.is_call(node, "sqrt"):
            return is_number(node)
        if isinstance(node, n.Product | n.Quotient) and sum(_is_letter(below) for below in n.walk(node)) > 1:
            return False
        plain = n.Number | n.Sum | n.Product | n.Quotient | n.Group | n.Name
        return isinstance(node, plain) and all(map(GivenValues._is_linear, n.children(node)))

    def remember(self, values: Mapping[str, n.Node], line: int) -> None:
        """Keep values; a joint that had one before begins another configuration, and that of the others is over.

        A length that one display gives two values has neither.
        """
        before, joints = self.names.state.configuration, self.joints
        if any(name in joints and name in before and before[name].line != line for name in values):
            for name in [name for name, stated in before.items() if name not in self.lengths and stated.line != line]:
                del before[name]
        if not set(values).isdisjoint(joints):
            self.names.state.told = Told()
        stated = self.stated(values, line)
        twice = {
            name
            for name, each in stated.items()
            if name in self.lengths
            and name in before
            and (before[name].line, before[name].value != each.value) == (line, True)
        }
        for kept in (before, self.names.state.given_last):
            kept |= stated
            for name in twice:
                kept.pop(name, None)

    def stated(self, values: Mapping[str, n.Node], line: int = 0) -> dict[str, Stated]:
        """Return those of the values that are numbers, as stated under the heading at hand."""
        numbers = {name: (node, self.number(node)) for name, node in values.items()}
        section = self.names.state.section
        return {
            name: Stated(node, value, line, section) for name, (node, value) in numbers.items() if value is not None
        }

    def repeats(self, chain: n.Chain) -> bool:
        """Whether an equation gives a length the value that it has."""
        values = self.values(*chain.members) if chain.relations == ("=",) else None
        stated = self.names.state.configuration
        return bool(values) and all(
            name in self.lengths and name in stated and stated[name].value == self.number(node)
            for name, node in (values or {}).items()
        )

    def rates_of_column(self, chain: n.Chain) -> Values:
        """Return the rates that the column of a side J [0.1; 0.2] gives, where another side holds rates; else nothing.

        A column behind J^{-1} is of velocities, and so is what stands beside the rates themselves.
        """
        products = [each for each in map(bare, chain.members) if isinstance(each, n.Product) and len(each.factors) == 2]
        products = [each for each in products if isinstance(bare(each.factors[0]), n.Matrix | n.Name)]
        columns = (column for each in products for column in columns_of_numbers(each))
        column = next((each for each in columns if len(each) == len(self.joints)), None)
        if column is None:
            return {}
        values = [self.members.evaluate(member).value for member in chain.members]
        cells = [value.cells if isinstance(value, Matrix) else [value] for value in values]
        sides = [[cell for cell in each if isinstance(cell, Scalar)] for each in cells]
        if not any(map(is_rate, symbols_in(chain_cells.from_iterable(sides)))) or any(map(are_rates, sides)):
            return {}
        return {f"dot {joint}": cell for joint, cell in zip(self.joints, column, strict=True)}

    @property
    def joints(self) -> list[str]:
        """The symbols of the arm's joints."""
        return [*self.names.joints]

    @property
    def lengths(self) -> Iterable[str]:
        """The symbols of the arm's lengths."""
        return self.names.lengths

    def values(self, left: n.Node, right: n.Node) -> Values | None:
        """Return the values that an equation gives: none where a determinant is set to zero or a coordinate is asked for."""
        if (pairs := self._entries(left, right)) is not None:
            return self._together(pairs)
        if n.is_call(left, "det") and isinstance(right, n.Number) and right.value == 0:
            at_values = any(isinstance(below, n.At) for below in n.walk(left))  # det J|_{θ_3 = 0} = 0 is a claim
            return None if at_values or self._vanishes(left) else {}
        if self.names.arm is None or not isinstance(left, n.Name):
            return None
        symbol = self.names.known_symbol(left.undotted.key)
        if left.dots:
            rate = "dot" * left.dots + f" {symbol}"
            if symbol is None or not is_number(right):
                return None
            is_turned = self.names.turn_of(symbol, left.undotted.key) == -1
            return {rate: n.Sum((("-", right),), span=right.span) if is_turned else right}
        if symbol is None:
            return {} if self._is_given_coordinate(left, right) else None
        is_value = self._is_joint_value(right) if symbol in self.joints else self._is_length_value(symbol, right)
        return {symbol: self._of_variable(symbol, left, right)} if is_value else None

    def _of_variable(self, symbol: str, name: n.Name, value: n.Node) -> n.Node:
        """Return the value of a joint's variable where θ_i, the angle of the table, has one."""
        row = self.names.table_row(symbol, name.key)
        if row is None or name.key == symbol:
            return value
        halves = n.Product((n.Number(row.theta.pi, str(row.theta.pi)), n.Name("pi")), ("⋅",))
        offset = n.Sum((("+", halves), ("+", n.Number(row.theta.number, str(row.theta.number)))))
        sign, other = ("+", "-") if row.sign == 1 else ("-", "+")
        return n.Sum(((sign, n.Group(value)), (other, n.Group(offset))))

    def _together(self, pairs: Iterable[Pair]) -> Values | None:
        found = [self.values(*pair) for pair in pairs]
        return None if None in found else {name: node for each in found for name, node in (each or {}).items()}

    def _entries(self, left: n.Node, right: n.Node) -> list[Pair] | None:
        """The entries of (θ_1, θ_2) = (0, π/2), of a column of joints, of q: each gives a value."""
        names = self._joints_of(left) if isinstance(left, n.Name) else cells_of(left)
        values = cells_of(right) if names else ()
        return list(zip(names, values, strict=True)) if values and len(names) == len(values) else None

    def _joints_of(self, name: n.Name) -> list[n.Name]:
        """Return the names of the joints where q or θ is all of them, with its dots; none of another name."""
        key = name.undotted.key
        if key not in ("q", "theta") or self.names.known_symbol(key) or key in self.names.state.definitions:
            return []
        return [n.Name(*symbol.partition("_")[::2], dots=name.dots) for symbol in self.joints]

    def _is_joint_value(self, value: n.Node) -> bool:
        names = [below.key for below in n.names(value)]
        calls = any(isinstance(below, n.Call | n.JointAngles | n.Matrix) for below in n.walk(value))
        return (not calls or is_number(value)) and all(key in ("pi", "k", "n") for key in names)

    def _is_given_coordinate(self, name: n.Name, value: n.Node) -> bool:
        """P_x = 0.5 is where the tool is asked to be, when P_x depends on the joints; P_x = 0 would be a claim."""
        quantity = self.names.quantity(name)
        if quantity is None or not quantity.scalar or not is_number(value):
            return False
        numbers = [below for below in n.walk(value) if isinstance(below, n.Number)]
        moving, asked = self.members.evaluate(name), self.members.evaluate(value)
        if not any(number.decimals or number.value >= 2 for number in numbers) or not isinstance(moving.value, Scalar):
            return False
        here = self.equality.compare(moving, asked, 0, False)
        # at the configuration given before it is a claim, and right; where a sentence leads to it from there, it may be wrong
        return bool(symbols_in([moving.value])) and not (
            here.verdict is Verdict.CONFIRMED
            or (here.verdict is Verdict.REFUTED and here.there and is_led_to(self.names))
        )

    def _is_length_value(self, symbol: str, value: n.Node) -> bool:
        """A length set to a number is data: its symbol stands for any."""
        walked = n.walk(value)
        return symbol in self.lengths and not any(isinstance(b, n.Name | n.Call | n.Matrix) for b in walked)

    def number(self, node: n.Node) -> float | None:
        """Return the number that a value is, or None."""
        value = self.members.evaluate(node).value
        return self.members.number(value) if isinstance(value, Scalar) else None

    def _vanishes(self, node: n.Node) -> bool:
        """Whether nothing can be asked of a determinant; that of J Jᵀ vanishes where J has more rows than joints: those are not meant."""
        member = self.members.evaluate(node)
        jacobians = [name for b in n.walk(node) if (name := self.members.jacobian_name(b)) is not None]
        if member.known and any(name.key not in self.names.state.shown for name in jacobians):
            return False
        constant = isinstance(member.value, Scalar) and member.value.as_fraction() is not None
        return member.problem is not None or constant or bool(getattr(member.value, "is_zero", bool)())


def new_name(names: Names, chain: n.Chain) -> str | None:
    """In a document of general statements, the first letter that stands alone and is new is being defined."""
    if len(chain.members) < 2:
        return None
    for place, member in enumerate(map(bare, chain.members)):
        if isinstance(member, n.Name) and place and member.dots:
            continue  # a rate on the right side is that of a variable, not a new name
        if isinstance(member, n.Name) and names.is_new(member) and member.key not in keys_beside(chain, member):
            return member.key
    return None


def new_angle(names: Names, chain: n.Chain) -> str | None:
    """Return the γ of cos γ = (a² + D² - b²)/(2 a D) where it stands nowhere above, in a document without an arm: it is defined so."""
    for member in map(bare, chain.members) if names.arm is None and chain.relations == ("=",) else ():
        angle = bare(member.arguments[0]) if n.is_call(member, "cos") else None
        if not isinstance(angle, n.Name) or angle.base not in greek.TURNED or angle.sub.isdigit():
            continue
        beside = keys_beside(chain, member)
        if names.is_new(angle) and angle.key not in beside and beside & names.state.definitions.keys():
            return angle.key
    return None


def angle_of_cosine(node: n.Node) -> str | None:
    """Return the key of γ of a cos γ, and of nothing else."""
    node = bare(node)
    return bare_key(node.arguments[0]) if n.is_call(node, "cos") and len(node.arguments) == 1 else None


def new_letters(names: Names, chain: n.Chain) -> frozenset[str]:
    """The letters of the first matrix that holds nothing but new letters and numbers: a value defines them, R = [r_ij]."""
    named = {key for node in chain.members if (key := bare_key(node)) is not None}
    are_told = (
        len(chain.members) > len(named) + 1 or named <= names.state.definitions.keys()
    )  # p = [x; y; z] tells no x
    for member in chain.members if are_told else ():
        letters = names_alone(member)
        if (
            letters
            and all(names.is_new(letter) for letter in letters)
            and not keys_alone(member) & keys_beside(chain, member)
        ):
            return keys_alone(member)
    return frozenset()


def adopts_letters(sides: Members, members: list[Member]) -> bool:
    """The letters of the transform to a frame that the document adds (a tool of length L_3), and of a point in one of the arm's, become free symbols.

    So do those of the transform from a frame that it adds to the arm's base, where that stands: any letter is a length there.
    """
    names = sides.names
    alone = [m.node for m in members if isinstance(m.node, n.Name)]
    stands = any(map(names.adds_base, alone))
    if not stands and not any(names.adds_frame(each) or _is_point_beyond(each, names) for each in alone):
        return False
    new: set[str] = set()
    for member in members:
        if isinstance(member.node, n.Matrix) and isinstance(member.problem, UnboundName):
            for below in n.walk(member.node):
                if (
                    isinstance(below, n.Name)
                    and not sides.evaluate(below).known
                    and (below.base[:1] in "aldhLDrRkGge" or (stands and len(below.base) == 1))
                    and not below.dots
                ):
                    new.add(below.key)
    new -= names.state.adopted
    names.state.adopted |= new
    return bool(new)


def _is_point_beyond(name: n.Name, names: Names) -> bool:
    """Whether a name is that of a point seen from a frame that moves, and of no frame itself: {}^2P_{tip}."""
    frames = names.arm.frames if names.arm is not None else ()
    return name.base in ("P", "p") and name.pre_sup in frames[1:] and bool(name.sub) and name.sub not in frames


def names_alone(node: n.Node) -> list[n.Name]:
    """Return the names that a matrix, or a tuple, of nothing but names and numbers holds."""
    node = bare(node)
    is_tuple = isinstance(node, n.Sequence) and node.brackets == "()"
    cells = node.cells if isinstance(node, n.Matrix) else cells_of(node) if is_tuple else ()
    return [c for c in cells if isinstance(c, n.Name)] if all(isinstance(c, n.Name | n.Number) for c in cells) else []


def keys_alone(node: n.Node) -> frozenset[str]:
    """Return the keys of the names that a matrix of nothing but names and numbers holds."""
    return frozenset(name.key for name in names_alone(node))


def keys_beside(chain: n.Chain, member: n.Node) -> set[str]:
    """The names that the other members of a chain hold."""
    return {b.key for other in chain.members if member not in (other, bare(other)) for b in n.names(other)}


def named_sign(chain: n.Chain) -> str | None:
    """Return the name to which a display gives both signs, σ = ±1 or σ ∈ {−1, 1}, or None."""
    if len(chain.members) != 2:
        return None
    left, right = chain.members
    key = bare_key(left)
    if chain.relations == ("=",) and _sign(right) == 0:
        return key
    right = bare(right)
    is_set = isinstance(right, n.Sequence) and right.brackets == "{}"  # [-1, 1] is an interval
    if chain.relations == ("∈",) and is_set and sorted(map(_value, right.items)) == [-1, 1]:  # type: ignore[attr-defined]
        return key
    return None


def _value(node: n.Node) -> int:
    sign = _sign(node)
    return 2 if sign is None else sign


def _sign(node: n.Node) -> int | None:
    """Return 1 or −1 for that number, 0 for ±1, None for anything else."""
    node, sign = bare(node), 1
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        mark, node = node.terms[0]
        sign = {"+": 1, "-": -1}.get(mark, 0)
    node = bare(node)
    return sign if isinstance(node, n.Number) and node.value == 1 else None


def _is_letter(node: n.Node) -> TypeGuard[n.Name]:
    return isinstance(node, n.Name) and node.key != "pi"
