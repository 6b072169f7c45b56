"""A traced formula, written as LaTeX and read again, has the values of the function."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import TooComplex
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.functions.latex import write_matrix
from armproof.verification.functions.tracing.number import TracedNumber, as_traced, symbol
from armproof.verification.naming.reading import read_names

X, Y = 0.7, 1.3
NAMES = {"symbols": {"x": "free", "y": "free"}}
STEPS: dict[str, Callable[[Any, Any], Any]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "subtract more": lambda a, b: b - (a - b) - (-a),
    "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / (b * b + 1),
    "power": lambda a, b: (a + b) ** 2 - a**3 / 4,
    "inverse power": lambda a, b: (a * a + 1) ** -2 * b,
    "root": lambda a, b: np.sqrt(a * a + b * b + 1),
    "cosine": lambda a, b: np.cos(a - b) * np.sin(b) ** 2,
    "arcs": lambda a, b: np.arctan2(a, b * b + 1) - np.arccos(a / np.sqrt(a * a + 1)) + np.arctan(b),
    "constants": lambda a, b: -0.25 * a + math.pi * b / 3 - math.sqrt(2) * a + Fraction(-2, 7),
}


def value(latex: str) -> float:
    exact = ExactAlgebra(Ring(), None)
    sampled = SampledAlgebra(exact, np.zeros((1, 0)), 0, {"x": np.array([X]), "y": np.array([Y])})
    names = read_names(None, NAMES)
    return float(np.ravel(Evaluator(names, sampled).evaluate(names.reader.read_expression(latex)))[0])


def write(node: Any) -> str:
    return write_matrix(np.array(as_traced(node), dtype=object))


@given(st.lists(st.sampled_from(sorted(STEPS)), min_size=1, max_size=3))
def test_it_is_read_back_as_it_was(steps: list[str]) -> None:
    traced: tuple[Any, Any] = (symbol("x"), symbol("y"))
    plain: tuple[Any, Any] = (X, Y)
    for step in steps:
        traced = (STEPS[step](*traced), traced[0])
        plain = (STEPS[step](*plain), plain[0])
    assert value(write(traced[0])) == pytest.approx(float(plain[0]), rel=1e-9, abs=1e-9)


def test_another_formula_has_another_value() -> None:
    x, y = symbol("x"), symbol("y")
    assert value(write(x - (y - x))) != pytest.approx(value(write(x - y - x)))


def test_arrays_are_columns_and_matrices() -> None:
    cells = np.array([[symbol("theta_1"), as_traced(0)]], dtype=object)
    assert write_matrix(cells) == r"\begin{bmatrix} \theta_1 & 0 \end{bmatrix}"
    assert write_matrix(cells[0]) == r"\begin{bmatrix} \theta_1 \\ 0 \end{bmatrix}"


def test_a_formula_that_doubles_at_each_step_is_refused_and_does_not_hang() -> None:
    node: TracedNumber = symbol("x")
    for _ in range(60):
        node = (node + 1) * (node - 1)
    with pytest.raises(TooComplex, match="too long"):
        write(node)
