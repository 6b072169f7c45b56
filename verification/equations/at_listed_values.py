"""Numbers that a document prints for formulas at the values of its code, or of what it works out above.

A number is wrong there only where all that it depends on is confirmed by others: code may have other values than the text.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import remainder, tau
from typing import Any

from armproof.verification.algebra.calculus import derivative, substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.model import Listing
from armproof.verification.equations.alignment import Pair, angle_places
from armproof.verification.equations.decimals import roundings_of
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.errors import ReadError, WhereDefined
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.verdict import Verdict

Values = Mapping[str, Any]
Place = tuple[int, int]
_AT_VALUES = (Kind.AT_LISTED_VALUES, Kind.AT_WORKED_VALUES, Kind.AT_ZERO)
STEEP = 1e-3
FEWEST = 9  # entries of a matrix of 0 and 1 alone that tell something


@dataclass
class _Compared:
    """The differences of a pair's entries, those that are wrong at the values, and the largest error of the others."""

    differences: dict[Place, Scalar] = field(default_factory=dict)
    wrong: list[Place] = field(default_factory=list)
    largest: float = 0.0


@dataclass(frozen=True)
class ListedValues:
    """Judges numbers that may be those of a formula at the values that a listing in reach gives."""

    members: Members

    def judge(self, outcome: Outcome, pairs: Sequence[Pair], numbers: n.Node, stated: Values) -> Outcome | None:
        """Return the outcome where the numbers of a pair are right for one of the listings, or all but one; else None.

        What displays and the text have `stated` holds, whatever code says.
        """
        nearly = None
        is_printed = not any(n.names(numbers))  # d_4 of a table of numbers is so everywhere, and at zero as well
        for listing in (*self.members.names.state.listed, *(self._at_zero() if is_printed else ())):
            for values in self._readings(listing):
                known = {**values, **stated}
                for pair in pairs:
                    found = self._compared(pair, numbers, known, listing)
                    if found is not None and not found.wrong:
                        return self._confirmed(outcome, pair, listing, found.largest)
                    if found is not None and (_breaks_rotation(pair, found) or self._is_slip(found, known)):
                        return self._refuted(outcome, pair, found, known)
                    if nearly is None and listing.line and found is not None and len(found.wrong) == 1:
                        nearly = self._doubted(outcome, pair, found, known, listing)
        return nearly

    def _doubted(
        self, outcome: Outcome, pair: Pair, found: _Compared, values: Values, listing: Listing
    ) -> Outcome | None:
        """Return the outcome left open where one number is not that of the values, and others are."""
        [(row, column)] = found.wrong
        if not any(
            _tells(pair, each) and symbols_in([found.differences[each]])
            for each in found.differences
            if each != (row, column)
        ):
            return None
        sides = [self._at(side.rows[row][column], values) for side in (pair.true, pair.printed)]
        correct, printed = (
            f"{self.members.number(each):.4f}".rstrip("0").rstrip(".") for each in sides if each is not None
        )
        if not symbols_in([pair.true.rows[row][column]]):
            correct, printed = printed, correct
        said = say(Kind.LISTED_OTHERWISE, printed=printed, correct=correct, line=listing.line)
        return outcome.left_open(said.at(row=row + 1, column=column + 1))

    @staticmethod
    def _confirmed(outcome: Outcome, pair: Pair, listing: Listing, largest: float) -> Outcome:
        kind = Kind.AT_LISTED_VALUES if listing.off is None else Kind.AT_WORKED_VALUES
        found = say(kind, line=listing.line) if listing.line else say(Kind.AT_ZERO)
        found = say(Kind.TO_DECIMALS_THERE) if listing.in_text else found
        return replace(
            outcome, verdict=Verdict.CONFIRMED, findings=(found,), pair=pair, wrong=[], samples=1, max_error=largest
        )

    def _at_zero(self) -> Iterator[Listing]:
        """Yield the configuration in which no joint is moved, which nobody needs to state for an arm of numbers."""
        arm = self.members.names.arm
        if arm is not None and arm.joints and not arm.lengths:
            yield Listing(0, tuple(f"{key_as_latex(joint.symbol)} = 0" for joint in arm.joints))

    def _is_slip(self, found: _Compared, values: Values) -> bool:
        """Whether each value that the one wrong number depends on there is confirmed by right ones that depend on it.

        These are as many as the values, or more: one number may be right for other values, too.
        """
        if len(found.wrong) != 1:
            return False
        wrong = found.differences[found.wrong[0]]
        moving = [name for name in symbols_in([wrong]) if self._moves(wrong, name, values)]
        right = [each for place, each in found.differences.items() if place not in found.wrong]
        confirmed = [{name for name in moving if self._moves(each, name, values)} for each in right]
        return bool(moving) and sum(map(bool, confirmed)) >= len(moving) and set(moving) == set().union(*confirmed)

    def _moves(self, difference: Scalar, name: str, values: Values) -> bool:
        """Whether a difference depends on a symbol at the values."""
        if name not in symbols_in([difference]):
            return False
        slope = self._at(derivative(difference, difference.ring.symbol(name)), values)
        return slope is not None and abs(self.members.number(slope)) > STEEP

    def _refuted(self, outcome: Outcome, pair: Pair, found: _Compared, values: Values) -> Outcome:
        names = symbols_in(found.differences.values())
        sides = [
            side.map(lambda cell: substitute(cell, {k: values[k] for k in symbols_in([cell])}))
            for side in (pair.true, pair.printed)
        ]
        there = {name: self.members.number(values[name]) for name in sorted(names)}
        return replace(
            outcome, pair=replace(pair, true=sides[0], printed=sides[1]), wrong=found.wrong, there=there, findings=()
        )

    def _readings(self, listing: Listing) -> Iterator[dict[str, Any]]:
        """Yield what a listing gives symbols; a joint's letter is its variable, or else the angle of the DH table."""
        names, exact = self.members.names, self.members.exact
        given = [
            (key, value) for latex in listing.values if (read := self._read(latex)) is not None for key, value in [read]
        ]
        symbols = {(names.known_symbol(key) or key): (key, value) for key, value in given}
        yield {symbol: value for symbol, (_, value) in symbols.items()}
        if names.offset_joints.keys() & symbols.keys():
            yield {symbol: names.variable_at(symbol, value, exact, key) for symbol, (key, value) in symbols.items()}

    def _read(self, latex: str) -> tuple[str, Any] | None:
        try:
            [chain] = self.members.names.reader.read(latex)
        except (ReadError, ValueError):
            return None
        if not isinstance(chain, n.Chain) or not isinstance(name := chain.members[0], n.Name):
            return None
        value = self.members.evaluate(chain.members[1]).value
        return (name.key, value) if isinstance(value, Scalar) else None

    def _compared(self, pair: Pair, numbers: n.Node, values: Values, listing: Listing) -> _Compared | None:
        """Compare entry by entry; None where one depends on what has no value, or where nothing is told."""
        allowed, angles = roundings_of(self.members, numbers, pair.true.shape), angle_places(pair)
        if len(allowed) < len(pair.true.cells) or not (
            len(allowed) >= FEWEST or any(_tells(pair, each) for each in allowed)
        ):
            return None
        found = _Compared()
        for (row, column), rounding in allowed.items():
            difference = pair.true.rows[row][column] - pair.printed.rows[row][column]
            value = self._at(difference, values)
            if value is None:
                return None
            found.differences[row, column] = difference
            slack = (listing.off or 0.0) * len(symbols_in([difference]))
            size = self.members.number(value)
            error = abs(remainder(size, tau) if (row, column) in angles else size)
            if error > rounding.far + slack:
                found.wrong.append((row, column))
            elif error > rounding.near + slack:
                return None
            else:
                found.largest = max(found.largest, error)
        return found

    def _at(self, difference: Scalar, values: Values) -> Scalar | None:
        used = symbols_in([difference])
        if not used <= values.keys():
            return None
        with WhereDefined():
            return substitute(difference, {name: values[name] for name in used})
        return None


def holds_at_listed_values(outcome: Outcome) -> bool:
    """Whether an equation holds as one of numbers at the values of code, at those worked out above, or where no joint is moved."""
    return outcome.verdict is Verdict.CONFIRMED and any(each.kind in _AT_VALUES for each in outcome.findings)


def _breaks_rotation(pair: Pair, found: _Compared) -> bool:
    """Whether one entry alone of a pose's rotation is wrong: the others leave it one value, in whatever configuration."""
    if pair.true.shape != (4, 4) or len(found.wrong) != 1 or len(found.differences) < len(pair.true.cells) - 4:
        return False
    last = [[cell.as_fraction() for cell in side.rows[3]] for side in (pair.true, pair.printed)]
    return last == [[0, 0, 0, 1]] * 2 and max(found.wrong[0]) < 3


def _tells(pair: Pair, place: Place) -> bool:
    """Whether a number is hardly right by chance: it is neither 0 nor ±1."""
    cells = [side.rows[place[0]][place[1]] for side in (pair.true, pair.printed)]
    number = next((cell.as_fraction() for cell in cells if not symbols_in([cell])), None)
    return number is not None and number not in (0, 1, -1)
