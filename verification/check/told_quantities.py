r"""Definitions that nothing but what follows from themselves uses: \dot\rho, or \rho^2 - l_1^2, follow from whatever \rho is said to be.

Where the text names the quantity, a wrong formula would pass with them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property

from armproof.verification.document import Display
from armproof.verification.document.told_quantities import TOLD_QUANTITY, TOLD_THING
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.naming.settled import Key, rests_through, settle_used
from armproof.verification.verdict import EquationResult, Record, Role, Verdict


def settle_told_quantities(
    records: tuple[Record, ...], displays: Sequence[Display], names: Names
) -> tuple[Record, ...]:
    """Return the records of a document; what follows from a definition alone does not show that its formula is right."""
    meant = {display.place: display.meant for display in displays}
    uses = _Uses(tuple(record for record in records if not record.erratum), names)
    idle = {
        key for key, record in uses.defined.items() if uses.are_idle(key, meant.get((record.cell, record.line), ()))
    }
    if not idle:
        return records
    found = tuple(record if record.erratum else _left_open(record, idle) for record in records)
    return settle_used(found)


@dataclass(frozen=True)
class _Uses:
    """What displays say of the names that others define."""

    records: tuple[Record, ...]
    names: Names
    _read: dict[str, list[n.Chain]] = field(default_factory=dict)

    @cached_property
    def _results(self) -> list[EquationResult]:
        return [each for record in self.records for each in record.outcomes]

    @cached_property
    def defined(self) -> dict[Key, Record]:
        """The displays that define names, by these."""
        return {k: r for r in self.records for each in r.outcomes for k in each.defines if k[1] == r.line}

    def are_idle(self, key: Key, told: Collection[str]) -> bool:
        """Whether what is decided by a definition follows from it alone, so that it would of any other."""
        if not (TOLD_QUANTITY in told or (TOLD_THING in told and self._is_formula(key))):
            return False
        through, using = rests_through(key, self._results)
        decided = [
            record for record in self.records if any(each.is_decided for each in record.outcomes if each in using)
        ]
        if not decided or self.defined[key] in decided:
            return False
        own = {name for name, _ in through}
        said = self._others((self.defined[each] for each in through if each in self.defined), own)
        return all(self._differentiates(each, key[0]) or self._others([each], own) == said for each in decided)

    def _is_formula(self, key: Key) -> bool:
        """Whether a name stands for a scalar made of the arm's joints and lengths alone."""
        record = self.defined[key]
        of_it = [each for each in record.outcomes if key in each.defines]
        is_defined = all(each.verdict is Verdict.DEFINED and each.role is not Role.DATA for each in of_it)
        below = [below for chain in self._chains(record) for below in n.walk(chain)]
        if self.names.arm is None or not is_defined or any(isinstance(each, n.Matrix) for each in below):
            return False
        return not self._others([record], {name for name, _ in self.defined}) and any(map(self._moves, below))

    def _moves(self, node: n.Node) -> bool:
        return isinstance(node, n.JointAngles) or (
            isinstance(node, n.Name) and self.names.known_symbol(node.undotted.key) in self.names.joints
        )

    def _others(self, records: Iterable[Record], own: set[str]) -> set[str]:
        """Return what displays speak of beside some names: no joint variable and no length of the arm."""
        keys = {b.undotted.key for r in records for chain in self._chains(r) for b in n.names(chain)}
        return {key for key in keys - own - {"pi"} if self.names.known_symbol(key) is None}

    def _differentiates(self, record: Record, name: str) -> bool:
        """Whether a display says no more of a name than what its derivatives are."""
        of_it = [each for each in self._chains(record) if name in {below.undotted.key for below in n.names(each)}]
        return bool(of_it) and all(_is_derivative(each, name) for each in of_it)

    def _chains(self, record: Record) -> list[n.Chain]:
        if record.latex not in self._read:
            with suppress(ReadError, RecursionError):
                read = self.names.reader.read(record.latex)
                self._read[record.latex] = [each for each in read if isinstance(each, n.Chain)]
        return self._read.setdefault(record.latex, [])


def _is_derivative(chain: n.Chain, name: str) -> bool:
    first, *others = map(bare, chain.members)
    plain = {below.key for each in others for below in n.names(each)}
    if isinstance(first, n.Derivative):
        return name in {below.key for below in n.names(first.operand)} and name not in plain
    return isinstance(first, n.Name) and first.dots > 0 and first.undotted.key == name and name not in plain


def _left_open(record: Record, idle: set[Key]) -> Record:
    if not any(_rests(each, idle) for each in record.outcomes):
        return record
    return record.with_outcomes(tuple(_open(each) if _rests(each, idle) else each for each in record.outcomes))


def _rests(result: EquationResult, idle: set[Key]) -> bool:
    return result.is_decided and not idle.isdisjoint(result.uses)


def _open(result: EquationResult) -> EquationResult:
    (name, line), *_ = sorted(result.uses)
    return replace(
        result,
        verdict=Verdict.UNCHECKED,
        findings=(say(Kind.FOLLOWS_FROM_DOUBT, name=name, line=line).at(result.index),),
    )
