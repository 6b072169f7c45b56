"""Names of which a document says one thing once, and their usual one ever after: with that all the rest holds, and what it says once is a slip.

y = cos θ_1 (…) beside x = cos θ_1 (…), before r = √(x² + y²), a Jacobian and an inverse that hold of the arm: convention is a
witness beside these lines, and so is the coordinate along another axis, which has it too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import yaml

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import as_front_matter
from armproof.verification.findings import MISPRINTS, OTHER_ANGLES, Kind
from armproof.verification.naming.shown import point_of
from armproof.verification.patterns import regex
from armproof.verification.verdict import HOLDS, EquationResult, Record, Verdict

_COORDINATE = regex(r"[xyzXYZ]|[pP]_[xyz]")
# slips by which a coordinate is not counted from another origin
_OF_ALL_TERMS = MISPRINTS - OTHER_ANGLES | {Kind.WRONG_SIGNS_OF_TERMS, Kind.WRONG_POWER}
_NAME = regex(r"\w+")  # what front matter can bind as it is
MOST_TRIALS = 4  # each judges the document again
SEVERAL = 2  # displays that hold
Bound = Mapping[str, Any]  # names, each with the quantity that it stands for as front matter writes it
Place = tuple[int, int]  # which display, and which of its equations


def bound_as_usual(
    records: Sequence[Record], judge: Callable[[Bound], Sequence[Record]], usual: Callable[[str], Sequence[Quantity]]
) -> dict[str, Any]:
    """Return the names that are what they usually are wherever it matters, each with its quantity.

    `judge` takes names as bound by front matter; `usual` tells what a key may stand for by convention.
    """
    found: dict[str, Any] = {}
    for key, quantity, at in [*_said_otherwise(records), *_contradicted(records, usual)][:MOST_TRIALS]:
        if key in found or not _NAME.fullmatch(key):
            continue
        trial = {**found, key: quantity}
        if _Trial(quantity, at, records, again := judge(trial)).shows_slip:
            found, records = trial, again
    return found


def _said_otherwise(records: Sequence[Record]) -> Iterator[tuple[str, Any, int]]:
    """Yield the names to which one display alone gives another meaning than the usual one, with that and the number of the display."""
    told = [
        (str(finding.terms["name"]), str(finding.terms["line"]), at)
        for at, each in _outcomes(records)
        for finding in each.findings
        if finding.kind is Kind.NOT_AS_USUAL_BOUND and any(key == finding.terms["name"] for key, _ in each.defines)
    ]
    for key, line, at in told:
        if sum(key == other for other, _, _ in told) == 1:
            quantities = yaml.safe_load(line).get("quantities", {})
            if key in quantities:
                yield key, quantities[key], at


def _contradicted(
    records: Sequence[Record], usual: Callable[[str], Sequence[Quantity]]
) -> Iterator[tuple[str, Any, int]]:
    """Yield the coordinates that a display defines, and that displays behind it do not hold with, with what they usually are: y = r² sin θ."""
    wrong = {key for _, each in _outcomes(records) if each.verdict is Verdict.REFUTED for key in each.uses}
    defined = [(key, at) for at, each in _outcomes(records) if each.verdict is Verdict.DEFINED for key in each.defines]
    for (key, line), at in defined:
        names = [name for (name, _), _ in defined]
        if (key, line) in wrong and names.count(key) == 1 and _COORDINATE.fullmatch(key):
            yield from ((key, as_front_matter(quantity), at) for quantity in usual(key)[:1])


@dataclass(frozen=True)
class _Trial:
    """A document as it is, and with a name bound to what it usually is; a display gives it another meaning."""

    quantity: Mapping[str, Any]
    defining: int
    before: Sequence[Record]
    after: Sequence[Record]

    @property
    def shows_slip(self) -> bool:
        """Whether several displays hold only so, or one that no other reading explains, none that held fails, and fewer do that fail."""
        gained, lost = (
            self._held(self.after) - self._held(self.before),
            self._held(self.before) - self._held(self.after),
        )
        others = {at for at, _ in gained} - {self.defining}
        is_refuted = self.after[self.defining].verdict is Verdict.REFUTED
        is_told = is_refuted and not lost and len(self._failing) < len(others)
        if self.before[self.defining].if_shown is not None:  # one slip parts the two meanings
            return is_told
        is_alone = len(others) < SEVERAL
        return is_told and self._has_point_beside and (not is_alone or (not self._failing and self._is_no_other_origin))

    def _held(self, records: Sequence[Record]) -> set[Place]:
        return {(at, each.index) for at, each in _outcomes(records) if each.verdict in HOLDS}

    @property
    def _failing(self) -> set[int]:
        """The displays that are refuted only so, but for the one that gives the name another meaning."""
        wrong = {at for at, each in _outcomes(self.after) if each.verdict is Verdict.REFUTED}
        return {at for at in wrong if not _fails(self.before[at])} - {self.defining}

    @property
    def _is_no_other_origin(self) -> bool:
        """Whether what is wrong is more than a term too many or too few, with which a coordinate is counted from elsewhere."""
        found = [entry.finding for entry in self.after[self.defining].entries]
        return bool(found) and all(each is None or each.kind in _OF_ALL_TERMS for each in found)

    @property
    def _has_point_beside(self) -> bool:
        """Whether the section has another coordinate of the same point, and that is what it usually is."""
        section = self.before[self.defining].section
        held = [
            each for at, each in _outcomes(self.after) if each.verdict in HOLDS and self.after[at].section == section
        ]
        points = {point_of(quantity) for each in held for quantity in each.usual.values()}
        wrong = [each.row for each in self.after[self.defining].entries]
        if len(wrong) == 1 and wrong[0]:  # all others of a column hold
            return True
        frame = str(self.quantity.get("origin", "")) if "component" in self.quantity else ""
        return frame in {each.frame for each in points if each is not None}


def _fails(record: Record) -> bool:
    """Whether a display does not hold with another meaning either."""
    fails = (each.verdict is Verdict.REFUTED or record.says(Kind.RESTS_ON_DOUBT) for each in record.outcomes)
    return any(fails)


def _outcomes(records: Sequence[Record]) -> Iterator[tuple[int, EquationResult]]:
    """Yield the equations of all displays that are no errata, each with the number of its display."""
    for at, record in enumerate(records):
        yield from ((at, each) for each in (() if record.erratum else record.outcomes))
