"""What a student gave as an answer: nothing yet, a function, or a formula in LaTeX, SymPy or numbers."""

from __future__ import annotations

import ast
import keyword
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.spelling import parts_of, with_decimal_points, with_indices, with_powers
from armproof.models.errors import ArmproofError
from armproof.verification.functions.latex import write_matrix
from armproof.verification.functions.tracing.expressions import FromSympy, is_sympy
from armproof.verification.functions.tracing.number import TracedNumber, as_traced, constant, function, symbol
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import GREEK, NAMES, one_of
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.unicode import normalise_unicode

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
MOST_CHARACTERS = 20_000
_DOLLARS = re.compile(r"^\s*(\$\$?|\\\[|\\\()(.*?)(\$\$?|\\\]|\\\))\s*$", re.DOTALL)
_GREEK = re.compile("|".join(NAMES))


@dataclass(frozen=True)
class WithSympy:
    """An answer that a task declares in SymPy, which is loaded only when the answer is needed: `WithSympy(lambda sp: …)`."""

    build: Callable[[Any], Any]

    def value(self) -> Any:
        """Return the SymPy expression or matrix."""
        import importlib

        return self.build(importlib.import_module("sympy"))


def is_missing(answer: Any) -> bool:
    """Whether there is no answer yet: None, an ellipsis, an empty text, or a list of such."""
    if answer is None or answer is Ellipsis or answer is NotImplemented:
        return True
    if isinstance(answer, str):
        return not answer.strip(" .…")
    return isinstance(answer, list | tuple | dict) and all(
        is_missing(item) for item in (answer.values() if isinstance(answer, dict) else answer)
    )


def is_function(answer: Any) -> bool:
    """Whether an answer is to be called."""
    return callable(answer) and not is_sympy(answer) and not hasattr(answer, "shape")


def as_latex(answer: Any) -> str:
    """Return a formula as LaTeX: a text, a SymPy expression or matrix, a number, an array, a nested list of these.

    A text is LaTeX, between dollars or not, or typed as in Python; of an equation the last side counts.

    Raises:
        AnswerError: it is none of these.
    """
    if isinstance(answer, WithSympy):
        answer = answer.value()
    if isinstance(answer, str):
        return _read_text(answer)
    rows = answer.tolist() if hasattr(answer, "tolist") else answer
    if not isinstance(rows, list | tuple):
        return _cell(rows)
    if not rows or any(isinstance(row, list | tuple) and len(row) != len(rows[0]) for row in rows):
        raise AnswerError("a matrix is a list of rows of one length")
    lines = [[_cell(cell) for cell in (row if isinstance(row, list | tuple) else [row])] for row in rows]
    return r"\begin{bmatrix} " + r" \\ ".join(" & ".join(line) for line in lines) + r" \end{bmatrix}"


def is_number(answer: Any) -> bool:
    """Whether an answer is made of plain numbers alone."""
    if hasattr(answer, "tolist"):
        answer = answer.tolist()
    if isinstance(answer, list | tuple):
        return bool(answer) and all(is_number(item) for item in answer)
    return isinstance(answer, int | float)


def _cell(value: Any) -> str:
    """Return one entry as LaTeX."""
    if isinstance(value, str):
        return _read_text(value)
    if isinstance(value, list | tuple):
        raise AnswerError("a formula is a number, a column or a matrix, not an array of more dimensions")
    try:
        traced = FromSympy(_with_underscore).convert(value)
        return write_matrix(np.array(traced, dtype=object))
    except ArmproofError as problem:
        raise AnswerError("the answer is no formula: {reason}", reason=problem) from None


def _read_text(text: str) -> str:
    if len(text) > MOST_CHARACTERS:
        raise AnswerError("the answer is too long: {length:,} characters, at most {most_characters:,}",
            length=len(text), most_characters=MOST_CHARACTERS)  # fmt: skip
    if any(character in text for character in "\a\b\f\v\t\r"):
        raise AnswerError(
            'write r"…" with an r before the quotes: without it Python takes \\b, \\t, \\f, \\r for control characters'
        )
    found = _DOLLARS.match(text)
    text = found.group(2) if found else text
    text = with_decimal_points(with_indices(with_powers(text)))
    if (parts := parts_of(text)) is not None:
        return as_latex([part.rsplit("=", 1)[-1] for part in parts])
    plain = read_plain(text)
    if plain is None and text.count("=") == 1 and (side := text.partition("=")[2]).strip() != "0":
        plain = read_plain(side)
    if plain is None:
        return _last_side(text)
    if isinstance(plain, list):
        return as_latex(plain)
    return write_matrix(np.array(plain, dtype=object))


def _last_side(text: str) -> str:
    """Return what stands behind the last = of a formula, a list as a column; a text that cannot be read as it is."""
    latex = normalise_unicode(text)
    try:
        statements = Reader().read(latex)
    except ArmproofError:
        return latex.partition("=")[2] if latex.count("=") == 1 else latex
    if len(statements) != 1 or not isinstance(statements[0], n.Chain):
        return latex
    chain = statements[0]
    if any(relation != "=" for relation in chain.relations):
        return latex
    if len(chain.members) < 2:
        return _as_column(latex, chain.members[0]) or latex
    start, end = chain.members[-1].span
    if latex[start:end].strip() == "0":
        raise AnswerError("give the expression alone, without = 0")
    return _as_column(latex, chain.members[-1]) or latex[start:end]


def _as_column(latex: str, node: n.Node) -> str:
    """Return a list in square brackets as a column, as everybody means it; empty where a node is none."""
    if not isinstance(node, n.Sequence) or node.brackets != "[]":
        return ""
    cells = [latex[item.span[0] : item.span[1]] for item in node.items]
    return r"\begin{bmatrix} " + r" \\ ".join(cells) + r" \end{bmatrix}"


def _with_underscore(name: str) -> str:
    """Return theta1 as theta_1, as the arms write their symbols; SymPy calls its λ lamda."""
    return re.sub(r"^([A-Za-z]+)(\d+)$", r"\1_\2", "lambda" if name == "lamda" else name)


def read_plain(text: str) -> Any:
    """Return a traced number, or nested lists of such; None where the text is no Python expression of numbers and letters."""
    if re.search(r"[\\{]|\d_\d", text):  # LaTeX; T^1_2 is no power 12 of T
        return None
    text = text.strip().replace("−", "-").replace("^", "**")  # in Python ^ binds less than +
    text = _GREEK.sub(lambda found: NAMES[found.group()], text)
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
        raise AnswerError("the answer is no formula: {reason}", reason=problem) from None


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
        if name == "hypot" and len(node.args) == 2:
            one, other = map(_number, node.args)
            return function("sqrt", one * one + other * other)
        if name in _FUNCTIONS:
            return function(_FUNCTIONS[name], *(_number(argument) for argument in node.args))
    raise _NoPlainText


def _combine(node: ast.BinOp) -> Any:
    if type(node.op) in (ast.Mult, ast.Div) and (rows := _scaled(node)) is not None:
        return rows
    left, right = _number(node.left), _number(node.right)
    if isinstance(node.op, ast.Pow) and not (right.is_constant and abs(float(right)) <= 16):
        raise _NoPlainText
    if isinstance(node.op, ast.Div) and all(isinstance(side.value, int | Fraction) for side in (left, right)):
        return constant(Fraction(left.value) / Fraction(right.value))  # type: ignore[arg-type]
    result: TracedNumber = _OPERATORS[type(node.op)](left, right)
    return result


def _scaled(node: ast.BinOp) -> list[Any] | None:
    """Return a list of numbers or rows times a number, or divided by one; None where neither side is a list."""
    sides = (node.left, node.right) if isinstance(node.op, ast.Div) else (node.left, node.right, node.right, node.left)
    for rows, number in zip(sides[::2], sides[1::2], strict=True):
        if isinstance(rows, ast.List):
            return [_read(ast.BinOp(item, node.op, number)) for item in rows.elts]
    return None


def _number(node: ast.expr) -> TracedNumber:
    value = _read(node)
    if not isinstance(value, TracedNumber):
        raise _NoPlainText
    return value
