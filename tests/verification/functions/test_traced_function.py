"""The formula of a function is what the function computes, whatever it is written in; the function stays as it was."""

from __future__ import annotations

import functools
import importlib
import math
from collections.abc import Callable
from math import atan2, cos, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
import pydrake.symbolic
import pytest
import sympy
from numpy import array, linalg, zeros

from armproof.verification.functions.traced_function import trace_function
from armproof.verification.functions.tracing.expressions import FromSympy
from armproof.verification.functions.tracing.number import FUNCTIONS, TracedNumber, Untraceable
from armproof.verification.functions.tracing.number import function as function_of
from armproof.verification.functions.tracing.rebuild import is_library

TABLE = [(0.45, 0.0, 0.1, pi / 2), (0.3, -pi / 2, 0.0, 0.0)]
LENGTHS = np.array([0.45, 0.3])
CALLS = 0


def call(function: Callable[..., Any], make: Callable[[str], Any]) -> Any:
    return function(np.array([make("a"), make("b")], dtype=object))


def value(node: Any, values: dict[str, float]) -> float:
    """Evaluate a formula by what its nodes say, and by nothing of the tracer's own."""
    if not isinstance(node, TracedNumber):
        return float(node)
    if node.operation == "symbol":
        return values[node.arguments[0]]
    if node.operation == "constant":
        return float(node.arguments[0])
    if node.operation == "power":
        return value(node.arguments[0], values) ** node.arguments[1]
    parts = [value(argument, values) for argument in node.arguments]
    operations: dict[str, Callable[..., float]] = {
        "add": lambda x, y: x + y, "subtract": lambda x, y: x - y, "multiply": lambda x, y: x * y,
        "divide": lambda x, y: x / y, "negative": lambda x: -x, **FUNCTIONS,
    }  # fmt: skip
    return operations[node.operation](*parts)


def in_math(q):
    a, b = q
    return [0.45 * math.cos(a) + 0.3 * cos(a + b), 0.45 * sin(a) + 0.3 * math.sin(a + b), math.hypot(0.2, 0.1)]


def link(a, alpha, d, theta):
    return np.array(
        [
            [cos(theta), -sin(theta) * cos(alpha), sin(theta) * sin(alpha), a * cos(theta)],
            [sin(theta), cos(theta) * cos(alpha), -cos(theta) * sin(alpha), a * sin(theta)],
            [0, sin(alpha), cos(alpha), d],
            [0, 0, 0, 1],
        ],
        dtype=float,
    )


def by_table(q):
    T = np.eye(4)
    for (a, alpha, d, theta), angle in zip(TABLE, q, strict=True):
        T = T @ link(a, alpha, d, float(angle) + theta)
    return T


def by_assignment(q):
    T = zeros((4, 4))
    T[:2, :2] = array([[np.cos(q[0]), -np.sin(q[0])], [np.sin(q[0]), np.cos(q[0])]])
    T[2, 2] = T[3, 3] = 1.0
    T[:3, 3] += LENGTHS[0] * np.array([np.cos(q[1]), np.sin(q[1]), 0.0])
    return linalg.inv(T)


def by_linear_algebra(q):
    R = np.identity(3)
    R[:2, :2] = [[cos(q[0]), -sin(q[0])], [sin(q[0]), cos(q[0])]]
    p = np.asarray(q, dtype=float).astype(np.float64)[:2] * 2
    v = np.cross(R[:, 0], np.array([p[0], p[1], 1.0]))
    return np.vstack([v, R @ v, np.linalg.solve(R, v), [np.linalg.norm(v), np.linalg.det(R), np.trace(R)]])


def by_functions(q):
    return [np.tan(q[0]), np.arctan2(q[0], q[1]), atan2(q[1], 2), np.arccos(q[0] / 9), np.arcsin(q[1] / 9),
            math.atan(q[0]), np.sqrt(q[0] ** 2 + 1), (1 + q[1] ** 2) ** 0.5, abs(-q[0]), np.deg2rad(q[0]),
            math.degrees(q[1]), q[0] ** -2, np.square(q[1]), np.power(q[0], 3), sum(q), np.hypot(q[0], q[1]),
            math.prod(q), math.prod([q[0], 3], start=0.5), math.dist([q[0], 1], [2, q[1]])]  # fmt: skip


def with_an_import(q):
    import json
    from math import sin as sine

    import numpy as numerical
    from numpy.linalg import norm as length

    return [numerical.cos(q[0]), sine(q[1]), json.loads("0.5") * q[0], length(numerical.array([q[0], q[1]]))]


class Arm:
    def __init__(self, length: float) -> None:
        self.length = length

    def point(self, angle: float) -> Any:
        return self.length * math.cos(angle)

    def __call__(self, q: Any) -> Any:
        return [self.point(q[0]), Arm(2.0).point(q[1]), self.fixed(q[0])]

    @staticmethod
    def fixed(angle: float) -> float:
        return math.sin(angle)


@functools.lru_cache
def remembered(angle):
    return math.cos(angle)


def recursive(q, k=2):
    return [0.0] if k == 0 else [math.sin(k * q[0]), *recursive(q, k - 1)]


def in_sympy(q):
    return sympy.Matrix([[sympy.cos(q[0]) * sympy.Rational(1, 3), sympy.sqrt(1 + q[1] ** 2)], [sympy.pi / 2, 0.25]])


def in_drake(q):
    c = pydrake.symbolic.cos
    return [c(q[0]) * c(q[0] + q[1]), pydrake.symbolic.sqrt(2.0 + q[0] * q[0]), q[0] / (2.0 + q[1])]


class Tool:
    def __init__(self, offset: Any) -> None:
        self.offset = offset

    @property
    def reach(self) -> Any:
        return math.sin(self.offset)

    @reach.setter
    def reach(self, angle: Any) -> None:
        self.offset = math.cos(angle)

    @classmethod
    def straight(cls, angle: Any) -> Any:
        return cls(math.sin(angle)).offset

    def turned(self, angle: Any) -> Any:
        return math.cos(angle)


class Gripper(Tool):
    def turned(self, angle: Any) -> Any:
        return math.sin(angle) + self.offset


GRIPPER, TURNED = Gripper(0.3), Gripper(0.2).turned


def by_members(q):
    tool = Gripper(0.3)
    tool.reach = q[0]
    return [tool.reach, Gripper.straight(q[1]), tool.turned(q[1]), GRIPPER.turned(q[0]), TURNED(q[1]), GRIPPER.reach]


def by_defaults(q, cosine=math.cos, *, sine=math.sin, lengths=LENGTHS):
    return lengths * [cosine(q[0]), sine(q[1])]


def by_types(q):
    alone = np.array(math.sin(q[1]), dtype=object)
    return [
        float(alone),
        np.cos(float(alone)),
        1.0 * isinstance(q[0], float),
        1.0 * isinstance("q", float),
        float(2),
    ]


def closed() -> Callable[..., Any]:
    cosine = math.cos

    def function(q):
        return [cosine(q[0]) if len(q) == 2 else late, float(np.array([math.sin(q[1])], dtype=object)[0])]

    if not cosine:
        late = 1
    return function


RIGHT = (in_math, by_table, by_assignment, by_linear_algebra, by_functions, with_an_import, Arm(0.5),
         Arm(0.7).__call__, functools.partial(recursive, k=3), lambda q: [remembered(q[0]), remembered(q[1])],
         by_members, by_defaults, by_types, closed())  # fmt: skip


@pytest.mark.parametrize("function", [*RIGHT, in_sympy, in_drake])
def test_the_formula_has_the_values_of_the_function(function: Callable[..., Any]) -> None:
    traced = np.array(trace_function(function, call), dtype=object)
    for a, b in ((0.7, -1.3), (2.9, 0.4), (-1.1, 0.2)):
        if function is in_drake:
            true = np.array([e.Evaluate() if hasattr(e, "Evaluate") else e for e in in_drake([pydrake.symbolic.Expression(a), pydrake.symbolic.Expression(b)])])  # fmt: skip
        else:
            true = np.array(np.array(function(np.array([a, b])), dtype=object), dtype=float)
        obtained = np.array([value(node, {"a": a, "b": b}) for node in traced.ravel()]).reshape(traced.shape)
        assert obtained.shape == true.shape
        assert np.allclose(obtained, true, rtol=0, atol=1e-12)


def test_right_angles_are_exact() -> None:
    traced = np.array(trace_function(by_table, call), dtype=object)
    assert traced[2, 0].operation in ("sin", "cos", "constant", "negative")  # no 6.1e-17 beside it


def test_only_a_right_angle_has_a_cosine_without_a_trace() -> None:
    for quarter in range(-4, 5):
        cosine, sine = (function_of(name, quarter * math.pi / 2) for name in ("cos", "sin"))
        assert (cosine.operation, sine.operation) == ("constant", "constant")
        assert (cosine.value, sine.value) == (round(math.cos(quarter * pi / 2)), round(math.sin(quarter * pi / 2)))
    assert function_of("cos", 0.3).operation == "cos"


def counts(q):
    global CALLS
    CALLS += 1
    return [math.cos(q[0])]


def test_no_module_and_no_function_is_changed() -> None:
    before = (math.cos, np.zeros, np.linalg.inv, cos, zeros, dict(globals()), in_math.__globals__)
    for function in RIGHT:
        trace_function(function, call)
    after = (math.cos, np.zeros, np.linalg.inv, cos, zeros, dict(globals()), in_math.__globals__)
    assert all(a is b or a == b for a, b in zip(before, after, strict=True))
    trace_function(counts, call)
    assert CALLS == 0  # what it counts, it counts in a namespace of its own
    assert np.zeros(2).dtype == float and math.cos(0.0) == 1.0
    assert LENGTHS.dtype == float


def test_a_library_is_what_no_user_writes() -> None:
    libraries = ("<frozen os>", functools.__file__, np.__file__, trace_function.__code__.co_filename)
    assert all(map(is_library, libraries))
    assert not any(map(is_library, ("<string>", "<ipython-input-1>", __file__, "/home/me/models/arm.py")))


def branches(q):
    return [math.cos(q[0]) if q[1] > 0 else 0.0]


def equals(q):
    return [1.0 if q[0] == 0 else math.sin(q[0])]


def integers(q):
    T = np.array([[1, 0], [0, 1]])
    T[0, 0] = np.cos(q[0])
    return T


def rounds(q):
    return np.round(np.cos(q), 3)


def indexes(q):
    return [1.0, 2.0][int(q[0])]


def complexes(q):
    return [np.exp(1j * q[0]).real]


@pytest.mark.filterwarnings("ignore:invalid value")
def test_symbols_of_sympy_have_the_names_that_they_are_given() -> None:
    q1, l1 = sympy.symbols("q1 l1")
    formula = FromSympy(lambda name: f"{name[0]}_{name[1:]}").convert(l1 * sympy.cos(q1) + q1)
    assert value(formula, {"q_1": 0.5, "l_1": 2.0}) == pytest.approx(2 * math.cos(0.5) + 0.5)


@pytest.mark.parametrize(
    "function", [branches, equals, integers, rounds, indexes, complexes, lambda q: np.where(q > 0, q, -q),
                 lambda q: max(q), lambda q: q % 3, lambda q: "text", lambda q: q.nothing, lambda: 1]
)  # fmt: skip
def test_what_needs_values_is_not_traced(function: Callable[..., Any]) -> None:
    with pytest.raises(Untraceable):
        trace_function(function, call)


def test_a_branch_on_a_number_is_taken() -> None:
    def function(q, tool=0.2):
        offset = math.cos(pi / 3)
        return [q[0] + offset if tool > 0.1 and offset > 0 else 0.0]

    [node] = trace_function(function, call)
    assert value(node, {"a": 1.0}) == pytest.approx(1.5)


def test_functions_of_a_module_of_ones_own_are_traced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "my_arm.py").write_text("import math\n\ndef reach(a):\n    return 0.3 * math.cos(a)\n", "utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    mine = importlib.import_module("my_arm")
    before = dict(vars(mine))
    traced = trace_function(lambda q: [mine.reach(q[0] + q[1])], call)
    assert value(traced[0], {"a": 0.2, "b": 0.5}) == pytest.approx(0.3 * math.cos(0.7))
    assert vars(mine) == before


def test_a_number_and_an_array_make_an_array() -> None:
    x = TracedNumber("symbol", ("x",))
    for made in (x * array([1.0, 2.0]), array([1.0, 2.0]) * x, x - array([1.0, 2.0])):
        assert isinstance(made, np.ndarray) and made.shape == (2,)
    with pytest.raises(TypeError):
        x + "1"
