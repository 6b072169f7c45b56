r"""Equations under the rates, or the velocity of the tool, that the text before gives: what these make of \dot x, and of \dot\theta_1."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.alignment import square_rows
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.rates import row_of
from armproof.verification.equations.sides import Members
from armproof.verification.equations.stated_rates import columns_of_numbers
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import LINEAR_VELOCITIES
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Told

_MOTIONS = ("x", "X", "p", "P", "r", "xi")
JACOBIAN = n.Name("J", sup="of the velocity given")  # which no document writes
_ONE, _ZERO = n.Number(Fraction(1)), n.Number(Fraction(0))

Velocity = dict[int, n.Node]  # the row of the Jacobian → how fast the tool is to move


@dataclass(frozen=True)
class UnderRates:
    """Writes equations as they are to be decided under given rates or velocities.

    Attributes:
        told: what the text before the display says.
    """

    members: Members
    told: Told

    @property
    def names(self) -> Names:
        """The names of the document."""
        return self.members.names

    def concerns(self, chain: n.Chain) -> bool:
        """Whether rates may be given for an equation of an arm that has some."""
        is_told = bool(self.told.velocities) or any(map(n.has_rates, self.told.conditions))
        is_told = is_told or any(column for member in chain.members for column in columns_of_numbers(member))
        return is_told and set(chain.relations) == {"="}

    def unless_data(self, outcome: Outcome) -> Outcome:
        """Return an outcome, left open where it says no more than which rates the velocity asks for: q̇ = J^{-1} (0.1, 0.2)^T."""
        named = [{b.base for b in n.names(each)} for each in outcome.nodes]
        is_data = len(named) == 2 and all("J" in bases for bases in named)
        return outcome.left_open(say(Kind.GIVES_RATES)) if is_data else outcome

    @property
    def told_besides(self) -> Told:
        """What the text says beside rates and velocities."""
        conditions = tuple(each for each in self.told.conditions if not n.has_rates(each))
        return replace(self.told, conditions=conditions, velocities=())

    def readings(self, chain: n.Chain) -> Iterator[tuple[n.Chain, dict[str, Quantity]]]:
        """Yield a chain with the velocities that given rates make, and with the rates that a given velocity asks for; with what its new names mean."""
        given = [pair for each in self.told.conditions for pair in self._rates_in(each)]
        members = tuple(self._moved(member, given) for member in chain.members)
        if given and members != chain.members and not any(map(self._joints, chain.members)):
            yield replace(chain, members=members), {}
        if (velocity := self._velocity_for(chain)) is not None:
            asked = (self._asked(own, velocity, m) if (own := self._joints(m)) else m for m in chain.members)
            yield replace(chain, members=tuple(asked)), {JACOBIAN.key: self.jacobian(sorted(velocity))}

    def _rates_in(self, chain: n.Chain) -> Iterator[tuple[n.Node, n.Node]]:
        if chain.relations == ("=",) and self._rate(chain.members[0]) and not n.has_rates(chain.members[1]):
            yield chain.members[0], chain.members[1]

    def _moved(self, member: n.Node, given: Sequence[tuple[n.Node, n.Node]]) -> n.Node:
        """Return a side at the rates given, unless it is a formula of other rates, or of none."""
        of_rates = {b.key for b in n.names(member) if self._rate(b)}
        names = {name.key for name, _ in given if isinstance(name, n.Name)}
        moves = any(isinstance(b, n.Name) and (b.dots or b.base in ("v", "V", "omega", "J")) for b in n.walk(member))
        apart = of_rates and of_rates.isdisjoint(names)
        return n.At(member, tuple(given), span=member.span) if moves and not apart else member

    def _velocity_for(self, chain: n.Chain) -> Velocity | None:
        """Return the velocity of the tool that is given for an equation of rates alone, and of no rate on its other sides."""
        alone = [bool(self._joints(member)) for member in chain.members]
        others = (member for member, is_alone in zip(chain.members, alone, strict=True) if not is_alone)
        if not any(alone) or any(map(n.has_rates, others)):
            return None
        told: Velocity = {}
        for each in self.told.velocities:
            told |= self.velocity_in(each)
        velocity = self._of_column(chain) or told
        return velocity if len(velocity) == self._count else None

    @property
    def _count(self) -> int:
        return len(self.names.arm.joints) if self.names.arm is not None else 0

    def jacobian(self, rows: Sequence[int]) -> Quantity:
        """Return the rows of the tool's Jacobian that a velocity has."""
        assert self.names.arm is not None
        return Quantity("jacobian", self.names.arm.frames[-1], self.names.arm.frames[0], rows=tuple(rows))

    def _asked(self, joints: Sequence[int], velocity: Velocity, node: n.Node) -> n.Node:
        r"""Return J^{-1} v, or the entry of it that one rate is."""
        rows = tuple(sorted(velocity))
        factors: list[n.Node] = [
            n.Postfix(JACOBIAN, "-1"),
            n.Matrix(tuple((n.Group(velocity[row]),) for row in rows)),
        ]
        if len(joints) == 1:
            factors.insert(0, n.Matrix((tuple(_ONE if k == joints[0] else _ZERO for k in range(self._count)),)))
        return n.Product(tuple(factors), ("",) * (len(factors) - 1), span=node.span)

    def _joints(self, member: n.Node) -> list[int]:
        """Return the joints (from 0) whose rates a side is: one, or all of them in their order."""
        node = bare(member)
        if isinstance(node, n.Name) and node.dots == 1 and node.key in ("dot q", "dot theta", "dot Theta"):
            return [*range(self._count)]
        named = [*cells_of(node)] or [node]
        symbols = [self._rate(each) for each in named]
        own = [*self.names.joints]
        places = [own.index(symbol) for symbol in symbols if symbol in own]
        return places if len(places) == len(named) and (len(named) == 1 or places == [*range(self._count)]) else []

    def _rate(self, node: n.Node) -> str | None:
        name = bare(node)
        return (
            self.names.known_symbol(replace(name, dots=0).key) if isinstance(name, n.Name) and name.dots == 1 else None
        )

    def velocity_in(self, chain: n.Chain) -> Velocity:
        r"""Return how fast an equation says that the tool moves: \dot x = 1, \dot p = (1, 0)^T."""
        if chain.relations != ("=",) or n.has_rates(chain.members[1]):
            return {}
        first, value = map(bare, chain.members)
        values = [*cells_of(value)] or [value]
        if isinstance(first, n.Name) and len(values) in (2, 3) and self._is_motion(first):
            return dict(enumerate(values, 1))
        rows = [row_of(each, self.names) for each in [*cells_of(first)] or [first]]
        return {} if None in rows or len(rows) != len(values) else dict(zip(rows, values, strict=True))  # type: ignore[arg-type]

    @staticmethod
    def _is_motion(name: n.Name) -> bool:
        is_rate = name.dots == 1 and name.base in _MOTIONS and not name.sub
        return is_rate or (not name.dots and name.base in LINEAR_VELOCITIES and name.sub in ("", "e"))

    def _of_column(self, chain: n.Chain) -> Velocity:
        """Return the velocity that stands as a column of numbers behind the inverse of J, where nothing tells its rows."""
        assert self.names.arm is not None
        factors = (bare(each) for each in chain.members if isinstance(bare(each), n.Product))
        column = next((found for each in factors for found in columns_of_numbers(each)), ())
        whole = self.members.exact.jacobian(self.names.arm.frames[-1], self.names.arm.frames[0])
        square = square_rows(whole)
        rows = self.names.rows_of("J") or (tuple(row + 1 for row in square) if square is not None else ())
        return dict(zip(rows, column, strict=True)) if len(rows) == len(column) == self._count else {}
