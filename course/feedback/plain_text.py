"""Read an answer that is typed as in Python: `-a_1*sin(theta_2)**2`, `[x, y, 0]`. It is parsed, never executed."""

from __future__ import annotations

import ast
import keyword
import math
import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from armproof.course.feedback.errors import AnswerError
from armproof.models.errors import ArmproofError
from armproof.verification.functions.tracing.number import TracedNumber, as_traced, constant, function, symbol
from armproof.verification.latex.greek import GREEK, one_of

_OPERATORS: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
    ast.Pow: lambda a, b: a**b,
}
_FUNCTIONS = {
    "cos": "cos", "sin": "sin", "tan": "tan", "sqrt": "sqrt", "abs": "abs", "acos": "acos", "arccos": "acos", "asin": "asin",
    "arcsin": "asin", "atan": "atan", "arctan": "atan", "atan2": "atan2", "arctan2": "atan2",
}  # fmt: skip
_MODULES = ("np", "numpy", "math", "sp", "sympy")
_LETTER = re.compile(rf"(?:[A-Za-z]|{one_of(GREEK)})(?:_[A-Za-z0-9]+|\d*)")
MOST_NODES = 2000


def read_plain(text: str) -> Any:
    """Return a traced number, or nested lists of such; None where the text is no Python expression of numbers and letters."""
    if re.search(r"[\\{]|\d_\d", text):  # LaTeX; T^1_2 is no power 12 of T
        return None
    text = text.strip().replace("−", "-").replace("^", "**")  # in Python ^ binds less than +
    safe = re.sub(r"\b(\w+)\b", lambda found: found[1] + "__" * keyword.iskeyword(found[1]), text)
    if (rows := re.fullmatch(r"\[([^\[\]]*;[^\[\]]*)\]", safe)) is not None:  # rows as in MATLAB, [v; w]
        safe = "[" + ", ".join(f"[{row}]" for row in rows[1].split(";")) + "]"
    try:
        tree = ast.parse(safe, mode="eval").body
        if sum(1 for _ in ast.walk(tree)) > MOST_NODES:
            return None
        return _read(tree)
    except (SyntaxError, ValueError, RecursionError, MemoryError, ArithmeticError, _NoPlainText):
        return None
    except ArmproofError as problem:
        raise AnswerError(f"the answer is no formula: {problem}") from None


class _NoPlainText(Exception):
    pass


def _read(node: ast.expr) -> Any:
    if isinstance(node, ast.List | ast.Tuple):
        return [_read(item) for item in node.elts]
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return as_traced(node.value)
    if isinstance(node, ast.Name):
        name = node.id.removesuffix("__")
        if not _LETTER.fullmatch(name):  # l_1l_2 and xy are products in LaTeX
            raise _NoPlainText
        return constant(math.pi) if name == "pi" else symbol(name)
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in _MODULES:
        if node.attr == "pi":
            return constant(math.pi)
        raise _NoPlainText
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
        value = _number(node.operand)
        return -value if isinstance(node.op, ast.USub) else value
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        return _combine(node)
    if isinstance(node, ast.Call) and not node.keywords:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in _FUNCTIONS:
            return function(_FUNCTIONS[name], *(_number(argument) for argument in node.args))
    raise _NoPlainText


def _combine(node: ast.BinOp) -> TracedNumber:
    left, right = _number(node.left), _number(node.right)
    if isinstance(node.op, ast.Pow) and not (right.is_constant and abs(float(right)) <= 16):
        raise _NoPlainText
    if isinstance(node.op, ast.Div) and all(isinstance(side.value, int | Fraction) for side in (left, right)):
        return constant(Fraction(left.value) / Fraction(right.value))  # type: ignore[arg-type]
    result: TracedNumber = _OPERATORS[type(node.op)](left, right)
    return result


def _number(node: ast.expr) -> TracedNumber:
    value = _read(node)
    if not isinstance(value, TracedNumber):
        raise _NoPlainText
    return value
