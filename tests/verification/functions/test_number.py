"""Traced numbers compute as floats do, and remember how: with symbols their formula has the value of the computation."""

from __future__ import annotations

import copy
import math
import operator
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from armproof.verification.functions.tracing import arrays
from armproof.verification.functions.tracing.number import (
    FUNCTIONS,
    TracedNumber,
    Untraceable,
    as_traced,
    function,
    symbol,
)

VALUES = {"x": 0.7, "y": -1.3}
X, Y = (symbol(name) for name in VALUES)
SYMBOLS = {"x": X, "y": Y}
PLAIN = [0, 1, -1, 2, 3, 0.5, Fraction(1, 3), np.float64(2.5), np.int64(3), True]
BINARY = [operator.add, operator.sub, operator.mul, operator.truediv]
OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "negative": operator.neg,
    **FUNCTIONS,
}


def worth(node: Any) -> float:
    """Return the value of a formula at VALUES, by an evaluator that knows nothing of the tracing."""
    if not isinstance(node, TracedNumber):
        return float(node)
    if node.operation == "symbol":
        return VALUES[node.arguments[0]]
    if node.operation == "constant":
        return float(node.arguments[0])
    if node.operation == "power":
        return worth(node.arguments[0]) ** node.arguments[1]
    return OPERATIONS[node.operation](*map(worth, node.arguments))


@pytest.mark.parametrize("binary", BINARY)
def test_a_formula_has_the_value_of_what_was_computed(binary: Callable[[Any, Any], Any]):
    others = [*PLAIN, X, Y, X + 1, -Y, function("cos", 0.3), function("sqrt", 2)]
    for other in others:
        for one in (X, -X, function("cos", 0.3), as_traced(2), as_traced(0.5)):
            for left, right in ((one, other), (other, one)):
                if binary is operator.truediv and worth(right) == 0:
                    with pytest.raises(ZeroDivisionError):
                        binary(left, right)
                    continue
                made = binary(left, right)
                assert worth(made) == pytest.approx(binary(worth(left), worth(right)))
                assert made.value is None or made.value == pytest.approx(worth(made))


@pytest.mark.parametrize("exponent", [0, 1, 2, 3, -1, -2, 0.5, 1.5, -0.5, Fraction(1, 2), 32, -32])
def test_a_power_is_one_of_a_whole_number_or_a_half(exponent: float):
    for base in (X, as_traced(2), as_traced(0.25), function("cos", 0.3)):
        made = base**exponent
        assert worth(made) == pytest.approx(worth(base) ** float(exponent))
        assert made.value is None or made.value == pytest.approx(worth(made))
    assert worth(2 ** as_traced(3)) == 8


@pytest.mark.parametrize("exponent", [1 / 3, 0.3, 33, -33, X])
def test_no_other_power_of_a_symbol_is_traced(exponent: Any):
    with pytest.raises(Untraceable):
        X**exponent


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("plain", [0, 1, 0.3, -0.4, math.pi / 2, math.pi, 1e-13])
def test_a_function_of_a_number_is_its_value(name: str, plain: float):
    given = (plain, 0.5) if name == "atan2" else (plain,)
    try:
        expected = FUNCTIONS[name](*given)
    except ValueError:  # the square root of a negative number, the arc sine of π
        with pytest.raises(ValueError):
            function(name, *given)
        return
    made = function(name, *given)
    assert float(made) == pytest.approx(expected, abs=1e-12)
    assert made.is_constant == ((name in ("cos", "sin") and plain not in (0.3, -0.4, 1)) or float(made) in (0, 1, -1))


def test_what_is_simple_stays_what_it_is():
    assert (
        X + 0 is X
        and 0 + X is X
        and X - 0 is X
        and X * 1 is X
        and 1 * X is X
        and X / 1 is X
        and +X is X
        and operator.neg(-X) is X
    )
    assert (X * 0).value == 0 and (X**0).value == 1 and X**1 is X and X**1.0 is X
    assert (as_traced(1) / 3).value == Fraction(1, 3) and (as_traced(1.0) / 4).value == 0.25


def test_a_number_without_symbols_is_one_for_python_and_numpy():
    for plain in (2, 0.5, -1.75):
        one = as_traced(plain)
        asked = (float, int, complex, bool, round, lambda x: round(x, 1), abs, "{:.2f}".format, str)
        for ask in asked:
            assert ask(one) == ask(plain) if ask is not abs else float(abs(one)) == abs(plain)
        assert one.real is one and one.imag == 0 and one.conjugate() is one and one.item() is one
        assert copy.copy(one) is one and copy.deepcopy(one) is one
        assert (one < 1, one <= 2, one > 0, one >= 2, one == plain, one != plain) == (
            plain < 1, plain <= 2, plain > 0, plain >= 2, True, False
        )  # fmt: skip
    assert as_traced(np.array(1.5)).value == 1.5 and as_traced(True).value == 1 and type(as_traced(True).value) is int
    assert repr(X + 1) == "add(x, 1)" and f"{X}" == "symbol"


@pytest.mark.parametrize("ask", [float, int, complex, bool, round, lambda x: x < 1, lambda x: x == 1, lambda x: x != 1])
def test_a_symbol_has_no_value(ask: Callable[[Any], Any]):
    with pytest.raises(Untraceable):
        ask(X)
    assert X == X and X in (Y, X)[1:]


@pytest.mark.parametrize("value", [math.inf, -math.nan, 1j, "1", None, [1]])
def test_what_is_no_real_number_is_not_traced(value: Any):
    with pytest.raises(Untraceable):
        as_traced(value)


def rows(matrix: Any) -> np.ndarray:
    return np.array([[worth(cell) for cell in row] for row in np.asarray(matrix, dtype=object)])


TURN = arrays.as_objects(np.eye(4))
TURN[:2, :2] = [[function("cos", X), -function("sin", X)], [function("sin", X), function("cos", X)]]
TURN[:3, 3] = [X, Y, 2]
NO_POSES = [TURN + np.outer([0, 0, 0, 1], more) for more in np.eye(4, dtype=int)]  # but for one number of the last row
ODD = np.array([[X, 1, Y], [0, Y, 2], [1, X * Y, 3]], dtype=object)


@pytest.mark.parametrize("matrix", [TURN, ODD, TURN[:3, :3], ODD[:2, :2], ODD[:1, :1], *NO_POSES], ids=range(9))
def test_matrices_of_symbols_are_worth_what_numpy_computes(matrix: np.ndarray):
    plain = rows(matrix)
    np.testing.assert_allclose(rows(arrays.inv(matrix)), np.linalg.inv(plain))
    assert worth(arrays.det(matrix)) == pytest.approx(np.linalg.det(plain))
    for exponent in (-2, -1, 0, 1, 3):
        np.testing.assert_allclose(
            rows(arrays.matrix_power(matrix, exponent)), np.linalg.matrix_power(plain, exponent), atol=1e-12
        )
    np.testing.assert_allclose(rows(arrays.multi_dot([matrix, matrix.T, matrix])), plain @ plain.T @ plain)
    right = matrix[:, 0]
    np.testing.assert_allclose([worth(cell) for cell in arrays.solve(matrix, right)], np.linalg.solve(plain, plain[:, 0]), atol=1e-12)  # fmt: skip
    assert worth(arrays.norm(matrix)) == pytest.approx(np.linalg.norm(plain))


def test_what_holds_symbols():
    yes = [X, [X], (1, [2, X]), np.array([1, X], dtype=object)]
    no = [1, [1], (1, [2]), np.array([1, 2.0]), np.array([1, 2], dtype=object), "x", None]
    assert all(map(arrays.holds_symbols, yes)) and not any(map(arrays.holds_symbols, no))
    assert arrays.as_floats(np.array([1, 2], dtype=object)).dtype == float and arrays.as_floats("x") == "x"
    assert [arrays.is_float(kind) for kind in (float, "f8", np.float32, None, object, int, "?!")] == [
        True, True, True, False, False, False, False
    ]  # fmt: skip


@pytest.mark.parametrize(
    "ask",
    [
        lambda: arrays.norm(ODD, 2),
        lambda: arrays.norm(ODD, axis=0),
        lambda: arrays.norm(ODD, keepdims=True),
        lambda: arrays.norm(ODD, 1),
        lambda: arrays.inv(ODD[:2]),
        lambda: arrays.det(ODD[0]),
    ],
)
def test_what_is_not_traced_is_said(ask: Callable[[], Any]):
    with pytest.raises((Untraceable, np.linalg.LinAlgError)):
        ask()
