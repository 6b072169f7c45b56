"""Under which readings two values of different size are compared, and when one is a slip away from the other."""

from __future__ import annotations

import pytest

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import atan2
from armproof.verification.equations.alignment import (
    Pair,
    ShapeMismatch,
    align,
    angle_places,
    different_entries,
    equal_matrices,
    exactly_equal,
    is_constant,
    is_near,
    square_rows,
)
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind

RING = Ring()


def scalar(text: str) -> Scalar:
    """Read 0, 2, a, -a, a+2b."""
    total = RING.zero
    for term in text.replace("-", "+-").split("+"):
        if term:
            sign, term = (-1, term[1:]) if term[0] == "-" else (1, term)
            digits = term.rstrip("abcdefghpqxyz")
            factor = RING.rational(sign * int(digits or 1))
            total = total + (factor * RING.symbol(term[len(digits) :]) if term != digits else factor)
    return total


def matrix(text: str) -> Matrix:
    return Matrix(tuple(tuple(scalar(cell) for cell in row.split()) for row in text.split(";")))


POSE = "a b 0 x; c d 0 y; 0 0 1 0; 0 0 0 1"
FIRST, LINEAR = "a b; c d; 0 0; 0 0; 0 0; 1 1", "a b; c d; e f; 0 0; 0 0; 1 1"


@pytest.mark.parametrize(
    ("true", "printed", "readings"),
    [
        ("a b; c d", "x y; p q", [(None, "a b; c d")]),
        ("a; b; c", "x y z", [(Kind.AS_ROW, "a b c")]),
        ("a b c", "x; y; z", []),
        ("a; b; c", "x y z p", []),
        ("a; b; c", "x; y; z; 1", [(Kind.HOMOGENEOUS, "a; b; c; 1")]),
        ("a; b; c", "x; y; z; 0", [(Kind.HOMOGENEOUS, "a; b; c; 0")]),
        ("a; b; c", "x; y; z; 2", []),
        ("a; b; c", "x; y; z; p", []),
        ("a; b; c; 1", "x; y; z", [(None, "a; b; c")]),
        ("a; b; c; 0", "x; y; z", [(None, "a; b; c")]),
        ("a; b; c; 2", "x; y; z", []),
        (POSE, "a b 0 x; c d 0 y; 0 0 1 0", [(Kind.UPPER_ROWS, "a b 0 x; c d 0 y; 0 0 1 0")]),
        (POSE, "a b x; c d y; 0 0 1", [(Kind.PLANAR_TRANSFORM, "a b x; c d y; 0 0 1")]),
        (POSE.replace("1 0;", "1 z;"), "a b x; c d y; 0 0 1", []),
        (POSE.replace("b 0", "b e"), "a b x; c d y; 0 0 1", []),
        (POSE.replace("0 0 1", "0 e 1"), "a b x; c d y; 0 0 1", []),
        ("a b c 0; d e f 0; g h p 0; 0 0 0 1", "1 0 0; 0 1 0; 0 0 1", [(Kind.ROTATION_ALONE, "a b c; d e f; g h p")]),
        ("a b 0; c d 0; 0 0 1", "x y; p q", [(Kind.PLANAR_ROTATION, "a b; c d")]),
        ("a b 0; c d 0; 0 0 2", "x y; p q", []),
        ("a b e; c d 0; 0 0 1", "x y; p q", []),
        ("a b 0; c d 0; e 0 1", "x y; p q", []),
        ("a b c; d e f; g h p", "x 0 0 0; 0 x 0 0; 0 0 x 0; 0 0 0 1", [(Kind.ROTATION_ALONE, "a b c 0; d e f 0; g h p 0; 0 0 0 1")]),
        ("a b c; d e f; g h p", "x 0 0 0; 0 x 0 0; 0 0 x 0; 0 0 0 2", []),
        (FIRST, "x y; p q", [(Kind.JACOBIAN_ROWS, "a b; c d")]),
        (FIRST, "x y; p q; 1 1", [(Kind.JACOBIAN_ROWS, "a b; c d; 0 0"), (Kind.JACOBIAN_ROWS, "a b; c d; 1 1"), (Kind.JACOBIAN_ROWS, "0 0; 0 0; 1 1")]),
        (LINEAR, "x y; p q; 1 1; 0 0", [(Kind.JACOBIAN_ROWS, "a b; c d; e f; 1 1")]),
        (LINEAR, "x y", [(Kind.JACOBIAN_ROWS, "a b"), (Kind.JACOBIAN_ROWS, "1 1")]),
        ("a b; 0 0; e f; 0 0; 0 0; 0 0", "x y; p q", [(Kind.JACOBIAN_ROWS, "a b; 0 0"), (Kind.JACOBIAN_ROWS, "a b; e f")]),
        ("0 0; c d; e f; 0 0; 1 1; 0 0", "x y; p q", [(Kind.JACOBIAN_ROWS, "0 0; c d"), (Kind.JACOBIAN_ROWS, "c d; e f")]),
        (FIRST, "x; y", []),
        ("a; b; 0", "x; y", [(Kind.PLANAR_VECTOR, "a; b")]),
        ("a; b; 0", "x y", [(Kind.PLANAR_VECTOR, "a; b")]),
        ("a; b; c", "x; y", []),
        ("a b; c d; 0 0", "x y; p q", [(Kind.PLANAR_ROWS, "a b; c d")]),
        ("a b; c d; 0 e", "x y; p q", []),
    ],
)  # fmt: skip
def test_a_size_is_read_as_what_it_usually_leaves_out(
    true: str, printed: str, readings: list[tuple[Kind | None, str]]
) -> None:
    algebra = ExactAlgebra(None, RING)
    if not readings:
        with pytest.raises(ShapeMismatch):
            list(align(matrix(true), matrix(printed), algebra))
        return
    found = list(align(matrix(true), matrix(printed), algebra))
    assert [pair.note.kind if pair.note else None for pair in found] == [kind for kind, _ in readings]
    for pair, (_, text) in zip(found, readings, strict=True):
        assert equal_matrices(pair.true, matrix(text)) and pair.true.shape == pair.printed.shape


def test_a_number_is_no_matrix_but_zero_is() -> None:
    algebra = ExactAlgebra(None, RING)
    (pair,) = align(matrix("a b; c d"), scalar("0"), algebra)
    assert is_constant(pair.printed) and equal_matrices(pair.true, matrix("a b; c d")) and not pair.is_scalar
    (pair,) = align(scalar("0"), matrix("a b; c d"), algebra)
    assert is_constant(pair.true) and equal_matrices(pair.printed, matrix("a b; c d"))
    (pair,) = align(scalar("a"), scalar("b"), algebra)
    assert pair.is_scalar
    for number in ("1", "a"):
        with pytest.raises(ShapeMismatch):
            list(align(matrix("a b; c d"), scalar(number), algebra))


@pytest.mark.parametrize(
    ("true", "rows"),
    [
        (FIRST, (0, 1)),
        ("0 0; c d; e f; 0 0; 1 1; 0 0", (1, 2)),
        ("a b; c d; 0 0", (0, 1)),
        ("a b c; d e f; 0 0 0; 0 0 0; 0 0 0; 1 1 1", (0, 1, 5)),
        ("0 0 0; 0 0 0; 0 0 0; a b c; d e f; 1 1 1", (3, 4, 5)),
        ("0 0 0; 0 0 0; a b c; 0 0 0; 0 0 0; 1 1 1", None),
        ("0; 0; 0; 0; 0; 1", (5,)),
    ],
)
def test_the_rows_that_make_a_jacobian_square_are_not_zero(true: str, rows: tuple[int, ...] | None) -> None:
    assert square_rows(matrix(true)) == rows


@pytest.mark.parametrize(
    ("true", "printed", "near"),
    [
        ("a; b; c", "a; b; d", True),
        ("a; b; 0", "a; d; 0", True),  # half of what is no constant
        ("a; b; c", "a; d; e", False),
        ("1; 2", "1; 2", False),
        ("1; a", "1; b", False),
        ("a+b", "a-b", True),
        ("a+b+c", "a+d+e", True),  # as many terms, a third in common
        ("a+b+c+d", "a+e+f+g", False),
        ("a+b+c", "a+b", True),  # two thirds of the longer one
        ("a+b+c", "a", False),
        ("a+b", "c+d", False),
        ("2a", "3a", True),
        ("2a", "2b", False),
        ("a", "a+b", False),
    ],
)
def test_a_slip_away_is_half_of_the_entries_or_a_third_of_the_terms(true: str, printed: str, near: bool) -> None:
    assert is_near(Pair(matrix(true), matrix(printed))) is near
    assert is_near(Pair(matrix(printed), matrix(true))) is near


def test_sums_of_hundreds_of_terms_are_near_where_they_are_and_are_no_slip_in_a_short_one() -> None:
    long, one = scalar("a+b+c+d+e"), scalar("a+b")
    for _ in range(5):
        long = long * scalar("a+b+c+d+e")  # 210 terms
    assert is_near(Pair(Matrix(((long,),)), Matrix(((long + scalar("x"),),))))
    cosine = power = RING.generator(("cos", "q"))
    turned = scalar("a")
    for _ in range(21):
        turned, power = turned + scalar("b") * power, power * cosine
    assert is_near(
        Pair(Matrix(((one,),)), Matrix(((turned,),)))
    )  # the same lengths, and half of them have the same factor
    assert not is_near(Pair(Matrix(((one,),)), Matrix(((long * turned,),))))


def test_quotients_are_near_where_an_entry_is_the_same() -> None:
    a, b = scalar("a"), scalar("b")
    assert not is_near(Pair(Matrix(((a / (a + b),),)), Matrix(((b / (a + b),),))))
    assert is_near(Pair(Matrix(((a / b, a),)), Matrix(((a / b, b),))))


def test_angles_are_equal_modulo_whole_turns_and_nothing_else_is() -> None:
    angle, turn = atan2(scalar("a"), scalar("b")), RING.generator(("pi", "")) * 2
    assert exactly_equal(angle + turn, angle) and not exactly_equal(angle + turn * RING.rational(2) / 4, angle)
    assert not exactly_equal(turn, scalar("0")) and not exactly_equal(angle, scalar("a"))
    pair = Pair(Matrix(((angle, scalar("a")), (scalar("b"), scalar("b")))), matrix("a a; b c"))
    assert angle_places(pair) == {(0, 0)} and different_entries(pair, exactly_equal) == [(0, 0), (1, 1)]


def test_only_numbers_are_constant_and_a_size_is_part_of_a_matrix() -> None:
    assert is_constant(matrix("1 0; 2 3")) and not is_constant(matrix("1 0; a 3"))
    assert not equal_matrices(matrix("a b"), matrix("a; b")) and not equal_matrices(matrix("a b"), matrix("a c"))
