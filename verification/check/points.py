"""Names that only convention binds, over a section: what each display takes for another point than the one before is left open."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import is_planar
from armproof.verification.check.limits import SECONDS_TO_DECIDE
from armproof.verification.equations.alignment import equal_matrices
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.conventions import AXES, WRIST
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.naming.shown import letters_of_point
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, HOLDS, EquationResult, Record

_OF_WRIST = regex(rf"(?:.+_(?:{'|'.join(sorted(WRIST))})|WC|wc)(?:[_,]?[{AXES}])?")
_HAND = {3: 1, 5: 2, 6: 3}  # joints behind the wrist: of a planar arm with three, of arms with five and six
Usual = Callable[[str], Sequence[Quantity]]
Point = tuple[str, str]  # a frame and the one in which it is seen


@dataclass(frozen=True)
class _Shown:
    """What an equation that holds shows a name to be; the points of its section that it may be as well."""

    line: int
    key: str
    quantity: Quantity
    points: frozenset[Point]


class Points:
    """Tells of which points the usual names of a document are."""

    def __init__(self, exact: ExactAlgebra, usual: Usual) -> None:
        self.exact = exact
        self.usual = usual

    def settle(self, records: Iterable[Record]) -> tuple[Record, ...]:
        """Return the records of a document; what rests on a usual name that is another point elsewhere in its section is left open.

        The point that convention says first is kept where it stands first.
        """
        records = tuple(self._of_wrist(each) for each in records)
        named = {
            (record.section, letters_of_point(key))
            for record in records
            for each in record.outcomes
            if each.verdict in HOLDS
            for key in each.usual
        }
        for section, letters in sorted(named):
            shown = [*self._shown(records, section, letters)]
            if shown and not frozenset.intersection(*(each.points for each in shown)):
                kept = self._first(shown[0].key)
                kept = kept if kept in shown[0].points else None
                other = next(each for each in shown if kept is None or kept not in each.points)
                doubt = say(Kind.SECOND_MEANING, name=key_as_latex(other.key), line=shown[0].line)
                is_meant = partial(self._is_of_other, letters, kept)
                records = tuple(
                    each.left_open(doubt, is_meant) if each.section == section and not each.erratum else each
                    for each in records
                )
        return records

    def _shown(self, records: Sequence[Record], section: str, letters: str) -> Iterator[_Shown]:
        """Yield what the equations of a section that hold show a name, or the other coordinates of its point, to be."""
        found = [
            (record.line, key, quantity)
            for record in records
            if record.section == section and not record.erratum
            for each in record.outcomes
            if each.verdict in HOLDS
            for key, quantity in each.usual.items()
            if letters_of_point(key) == letters and isinstance(quantity, Quantity)
        ]
        points = {_point(quantity) for _, _, quantity in found}
        for line, key, quantity in found if len(points) > 1 else ():
            yield _Shown(line, key, quantity, frozenset(each for each in points if self._is_same(quantity, each)))

    def _is_same(self, quantity: Quantity, point: Point) -> bool:
        """Whether a quantity of another point has the same value."""
        if _point(quantity) == point:
            return True
        other = replace(quantity, frame=point[0], reference=point[1])
        try:
            with self.exact.ring.budget.of(SECONDS_TO_DECIDE):
                one, two = (as_matrix(self.exact.quantity(each)) for each in (quantity, other))
                return equal_matrices(one, two)
        except (ArmproofError, RecursionError):  # nobody can tell
            return False

    def _is_of_other(self, letters: str, kept: Point | None, outcome: EquationResult) -> bool:
        """Whether what is decided rests on a name for another point than the one that is kept."""
        meant = [
            quantity
            for key, quantity in outcome.usual.items()
            if letters_of_point(key) == letters and isinstance(quantity, Quantity)
        ]
        return outcome.verdict in DECIDED and any(kept is None or not self._is_same(each, kept) for each in meant)

    def _first(self, key: str) -> Point | None:
        """Return the point that convention says first of a name."""
        return next((_point(each) for each in self.usual(key)), None)

    def _of_wrist(self, record: Record) -> Record:
        """Return a record with what is decided of a wrist left open that is none of the arm."""
        keys = {key for each in record.outcomes for key in each.usual if _OF_WRIST.fullmatch(key)}
        if not keys or record.erratum or (wrist := self._wrist) is None:
            return record
        return record.left_open(self._doubt_of_wrist(keys), partial(self._is_of_no_wrist, wrist))

    def _doubt_of_wrist(self, keys: Iterable[str]) -> Finding:
        return say(Kind.NOT_BOUND, name=key_as_latex(min(keys)))

    def _is_of_no_wrist(self, wrist: str, outcome: EquationResult) -> bool:
        meant = (quantity for key, quantity in outcome.usual.items() if _OF_WRIST.fullmatch(key))
        return outcome.verdict in DECIDED and any(
            isinstance(each, Quantity) and not self._is_same(each, (wrist, each.reference)) for each in meant
        )

    @cached_property
    def _wrist(self) -> str | None:
        """Return the last frame whose origin the joints of the hand do not move; None of an arm whose hand nobody can tell."""
        arm = self.exact.arm
        if arm is None or len(arm.joints) not in _HAND or (len(arm.joints) == 3 and not is_planar(arm)):
            return None
        hand = _HAND[len(arm.joints)]
        for frame in reversed(numbered_frames(arm)):
            rows = self.exact.jacobian(frame, arm.frames[0]).rows[:3]
            if all(cell.is_zero() for row in rows for cell in row[-hand:]):
                return frame
        return None


def _point(quantity: Quantity) -> Point:
    return quantity.frame, quantity.reference
