"""Bring a printed value and the true one to one shape, and find the entries in which they differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from armproof.verification.algebra.angles import cos_sin, has_arcs
from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar, column, is_zero
from armproof.verification.algebra.protocol import Algebra, Value, identity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.findings import Finding, Kind, say


@dataclass(frozen=True)
class Pair:
    """A true and a printed value of one shape; `note` says what was taken for granted to bring them there.

    `rows` and `columns` lead from the pair's entries back to the printed matrix.
    """

    true: Matrix
    printed: Matrix
    note: Finding | None = None
    is_scalar: bool = False
    true_rows: tuple[int, ...] | None = None
    true_columns: tuple[int, ...] | None = None  # of a Jacobian printed without the columns of its last joints

    def entries(self) -> Iterator[tuple[tuple[int, int], Any, Any]]:
        """Yield each place (from 0) with the true entry and the printed one."""
        return zip(self.true.places, self.true.cells, self.printed.cells, strict=True)

    def differences(self) -> list[Scalar]:
        """Return by how much the entries differ, of those that are exact."""
        cells = zip(self.true.cells, self.printed.cells, strict=False)
        return [a - b for a, b in cells if isinstance(a, Scalar) and isinstance(b, Scalar)]


MOST_TERMS, TIMES_AS_MANY = 200, 10  # a slip makes no sum of hundreds of terms out of one of a few
ROTATION = say(Kind.ROTATION_ALONE)
HOMOGENEOUS = say(Kind.HOMOGENEOUS)


class ShapeMismatch(ShapeError):
    """The printed value has another size than the true one."""


def align(true: Value, printed: Value, algebra: Algebra) -> Iterator[Pair]:
    """Yield the readings under which the two can be compared, the plainest first; raises ShapeMismatch if none."""
    true, printed = _plain(true, printed, algebra)
    if not isinstance(true, Matrix) and not isinstance(printed, Matrix):
        yield Pair(Matrix(((true,),)), Matrix(((printed,),)), is_scalar=True)
        return
    if not isinstance(true, Matrix) or not isinstance(printed, Matrix):
        matrix, scalar = (true, printed) if isinstance(true, Matrix) else (printed, true)
        if not is_zero(scalar):
            sizes = [v.size if isinstance(v, Matrix) else "a scalar" for v in (printed, true)]
            raise ShapeMismatch(say(Kind.WRONG_SIZE_OF_VALUE, printed=sizes[0], correct=sizes[1]))
        zeros = matrix.map(lambda cell: scalar)
        yield Pair(matrix, zeros) if isinstance(true, Matrix) else Pair(zeros, matrix)
        return
    if true.shape == printed.shape:
        yield Pair(true, printed)
        return
    found = False
    for pair in _reshaped(true, printed):
        found = True
        yield pair
    if not found:
        raise ShapeMismatch(say(Kind.WRONG_SIZE, printed=printed.size, correct=true.size))


def _plain(true: Value, printed: Value, algebra: Algebra) -> tuple[Value, Value]:
    def plain(value: Value, other: Value) -> Value:
        if isinstance(value, Identity):
            if isinstance(other, Matrix):
                return identity(algebra, other.shape[0], value.scale)
            if isinstance(other, Identity) or is_zero(value.scale):
                return value.scale
            raise ShapeMismatch(say(Kind.IDENTITY_FOR_SCALAR))
        if isinstance(value, list):
            other_is_row = isinstance(other, Matrix) and other.shape[0] == 1
            if any(isinstance(cell, Matrix | Identity | list) for cell in value):
                raise EvaluationError(say(Kind.LIST_OF_MATRICES))
            return Matrix((tuple(value),)) if other_is_row else column(value)
        return as_scalar(value)

    return plain(true, printed), plain(printed, true)


def _reshaped(true: Matrix, printed: Matrix) -> Iterator[Pair]:
    (m, k), (r, c) = true.shape, printed.shape
    if (m, k) == (c, r) and 1 in (m, k) and r == 1:  # a vector printed as a row
        yield Pair(true.transpose, printed, say(Kind.AS_ROW))
    if (m, k, r, c) == (3, 1, 4, 1):  # homogeneous coordinates of a point or a direction
        last = printed.rows[3][0]
        if _is_constant(last, 1) or _is_constant(last, 0):
            yield Pair(Matrix((*true.rows, (last,))), printed, HOMOGENEOUS)
    if (m, k, r, c) == (4, 1, 3, 1) and (_is_constant(true.rows[3][0], 1) or _is_constant(true.rows[3][0], 0)):
        yield Pair(true.block(range(3), [0]), printed)
    if (m, k) == (4, 4):
        if (r, c) == (3, 4):
            yield Pair(true.block(range(3), range(4)), printed, say(Kind.UPPER_ROWS))
        if (r, c) == (3, 3):
            if all(is_zero(true.rows[i][3]) for i in range(3)):
                yield Pair(true.block(range(3), range(3)), printed, ROTATION)
            elif _is_planar(true):
                yield Pair(true.block([0, 1, 3], [0, 1, 3]), printed, say(Kind.PLANAR_TRANSFORM))
            elif equal_matrices(true.block(range(3), range(3)), printed):  # T_{03} = R: right, or no claim about a pose
                yield Pair(true.block(range(3), range(3)), printed, ROTATION)
    if (m, k, r, c) == (3, 3, 2, 2) and _is_constant(true.rows[2][2], 1) and _is_planar_rotation(true):
        yield Pair(true.block([0, 1], [0, 1]), printed, say(Kind.PLANAR_ROTATION))
    if (m, k, r, c) == (3, 3, 4, 4) and _is_constant(printed.rows[3][3], 1):
        zero = printed.rows[3][3] * 0
        padded = (*((*row, zero) for row in true.rows), (zero, zero, zero, zero + 1))
        yield Pair(Matrix(padded), printed, ROTATION)
    if m == 6 and c == k and r < 6:
        for rows in _jacobian_rows(true, r):
            note = say(Kind.JACOBIAN_ROWS, rows=[i + 1 for i in rows])
            yield Pair(true.block(rows, range(k)), printed, note, true_rows=rows)
    if m in (3, 6) and 1 < c < k:
        yield from _without_last_joints(true, printed)
    if (m, k) == (3, 1) and (r, c) in ((2, 1), (1, 2)) and is_zero(true.rows[2][0]):
        yield Pair(true.block([0, 1], [0]), printed if c == 1 else printed.transpose, say(Kind.PLANAR_VECTOR))
    if (m, k, r, c) == (4, 1, 3, 1) and is_zero(true.rows[2][0]):  # [v; ω] of the plane
        yield Pair(true.block([0, 1, 3], [0]), printed, say(Kind.PLANAR_VECTOR))
    if m == 3 and r == 2 and k == c and k > 1 and all(is_zero(cell) for cell in true.rows[2]):
        yield Pair(true.block([0, 1], range(k)), printed, say(Kind.PLANAR_ROWS))
    if m == 2 and r == 3 and k == c and k > 1 and all(is_zero(cell) for cell in printed.rows[2]):  # J = ∂p/∂q = […]
        yield Pair(true, printed.block([0, 1], range(k)), say(Kind.PLANAR_ROWS))


def _without_last_joints(true: Matrix, printed: Matrix) -> Iterator[Pair]:
    """Yield a Jacobian without the columns of the last joints, where these are zero: a wrist turns about the point and does not move it."""
    (m, k), (r, c) = true.shape, printed.shape
    for rows in [tuple(range(m))] if r == m else _jacobian_rows(true, r) if m == 6 and r < m else ():
        if all(is_zero(cell) for cell in true.block(rows, range(c, k)).cells):
            note = say(Kind.WITHOUT_LAST_JOINTS, rows=[i + 1 for i in rows])
            read = rows if m == 6 else None
            pair = Pair(true.block(rows, range(c)), printed, note, true_rows=read, true_columns=tuple(range(c)))
            if is_near(pair):  # else it may be that of another point, and of all joints
                yield pair


def _jacobian_rows(true: Matrix, count: int) -> Iterator[tuple[int, ...]]:
    """The rows a shorter Jacobian is likely to hold: linear, then those that are not zero, then angular, planar."""
    tried: list[tuple[int, ...]] = []
    nonzero = tuple(i for i in range(len(true.rows)) if not all(is_zero(cell) for cell in true.rows[i]))
    candidates: list[tuple[int, ...]] = [tuple(range(count))] if count <= 3 else []
    candidates.append(nonzero)
    if count == 3 and len(true.rows) == 6:
        candidates += [(3, 4, 5)] if {3, 4, 5} & {*nonzero} else []
        candidates += (
            [(0, 1, 5)] if 5 in nonzero or 2 not in nonzero else []
        )  # what never turns, and lifts, is in no plane
    if count == 2:  # motion in the plane x, z or y, z
        candidates += [(i, 2) for i in (0, 1) if 1 - i not in nonzero]
    if count == 1 and len(true.rows) == 6:
        candidates += [(5,)]
    for rows in candidates:
        if len(rows) == count and rows not in tried and max(rows, default=0) < len(true.rows):
            tried.append(rows)
            yield rows


def square_rows(true: Matrix) -> tuple[int, ...] | None:
    """Return the rows (from 0) that make a Jacobian, or its rows of v, square and hold no row of zeros, or None.

    Of several, those whose determinant does not vanish everywhere: of a wrist that turns about one point, those of ω.
    """
    columns = range(true.shape[1])
    possible = [
        rows
        for rows in _jacobian_rows(true, len(columns))
        if not any(all(is_zero(cell) for cell in true.rows[row]) for row in rows)
    ]
    if len(possible) < 2:
        return next(iter(possible), None)
    regular = (rows for rows in possible if not is_zero(true.block(rows, columns).determinant()))
    return next(regular, possible[0])


def _is_planar(true: Matrix) -> bool:
    return _is_planar_rotation(true) and is_zero(true.rows[2][3])


def _is_planar_rotation(true: Matrix) -> bool:
    return all(is_zero(true.rows[2][k]) and is_zero(true.rows[k][2]) for k in (0, 1))


def _is_constant(value: Any, number: int) -> bool:
    return is_zero(value - number) if isinstance(value, Scalar) else _all(value == number)


def exactly_equal(a: Scalar, b: Scalar) -> bool:
    """Decide a = b by normal form; angles of arc functions are compared modulo whole turns."""
    difference = a - b
    if difference.is_zero():
        return True
    if not (has_arcs(a) or has_arcs(b)):
        return False
    try:
        cosine, sine = cos_sin(difference)
    except EvaluationError:
        return False
    return (cosine - 1).is_zero() and sine.is_zero()


def equal_matrices(a: Matrix, b: Matrix) -> bool:
    """Decide whether two matrices of one size are equal, entry by entry."""
    return a.shape == b.shape and all(
        isinstance(y, Scalar) and exactly_equal(x, y) for x, y in zip(a.cells, b.cells, strict=True)
    )


def different_entries(pair: Pair, equal: Callable[[Any, Any], bool]) -> list[tuple[int, int]]:
    """Return the places (from 0) of the entries that differ."""
    return [place for place, a, b in pair.entries() if not equal(a, b)]


def agree_exactly(pair: Pair) -> bool:
    """Whether all entries of a pair are exactly equal."""
    return not different_entries(pair, exactly_equal)


def angle_places(pair: Pair) -> set[tuple[int, int]]:
    """Return the places (from 0) whose exact values hold an arc function: angles, equal up to whole turns."""
    return {place for place, a, b in pair.entries() if has_arcs(a) or has_arcs(b)}


def _all(equal: Any) -> bool:
    """Whether a comparison holds, of numbers or of arrays of samples."""
    return equal if isinstance(equal, bool) else bool(equal.all())


def is_near(pair: Pair) -> bool:
    """Whether a value is a slip away from another: half of the entries that are no constants agree, or half of the terms."""
    cells = [
        (a, b)
        for _, a, b in pair.entries()
        if isinstance(a, Scalar) and isinstance(b, Scalar) and not (_is_number(a) and _is_number(b))
    ]
    if len(cells) == 1:
        return _shares_terms(*cells[0])
    agreeing = sum(exactly_equal(a, b) for a, b in cells)
    return agreeing > 0 and 2 * agreeing >= len(cells)


def _shares_terms(true: Scalar, printed: Scalar) -> bool:
    """Whether two sums have as many terms and a third of them in common, or two thirds of the longer one's.

    Two values of opposite sign are near, two single terms that differ in their number alone, and sums of the same lengths of which half have the same factor.
    """
    a, b = true.normal(), printed.normal()
    if (a + b).is_zero():
        return True
    if not (a.denominator.is_one() and b.denominator.is_one()):
        return False
    few, many = sorted(len(x.numerator) for x in (a, b))
    if many > MOST_TERMS and many > TIMES_AS_MANY * few:
        return False
    terms, others = ([(tuple(sorted(p.items())), k) for p, k in a.ring.terms(x.numerator)] for x in (a, b))
    if len(terms) == len(others) == 1:
        return terms[0][0] == others[0][0]
    by_length, by_other = _by_length(terms), _by_length(others)
    alike = sum(by_length[length] == by_other[length] for length in by_length.keys() & by_other.keys())
    if by_length.keys() == by_other.keys() and alike and 2 * alike >= len(by_length):
        return True
    common, longer = len({*terms} & {*others}), max(len(terms), len(others))
    return longer > 1 and 3 * common >= (1 if len(terms) == len(others) else 2) * longer


def _by_length(terms: Sequence[tuple[Any, Any]]) -> dict[Any, set[Any]]:
    """Return the terms of a sum by the letters in them that are no angles."""
    found: dict[Any, set[Any]] = {}
    for powers, factor in terms:
        found.setdefault(tuple(each for each in powers if each[0][0] == "symbol"), set()).add((powers, factor))
    return found


def _is_number(value: Scalar) -> bool:
    return value.as_fraction() is not None


def is_constant(value: Matrix) -> bool:
    """Whether a value holds nothing but numbers."""
    return all(isinstance(cell, Scalar) and _is_number(cell) for cell in value.cells)
