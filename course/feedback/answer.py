"""What a student gave as an answer: nothing yet, a function, or a formula in LaTeX, SymPy or numbers."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from course.feedback.errors import AnswerError
from models.errors import ArmproofError
from models.tracing.from_sympy import FromSympy, is_expression
from models.tracing.number import as_traced
from verification.latex import nodes as n
from verification.latex.reader import Reader
from verification.latex.tokens import normalise_unicode
from verification.python.latex import write_matrix

MOST_CHARACTERS = 20_000
_DOLLARS = re.compile(r"^\s*(\$\$?|\\\[|\\\()(.*?)(\$\$?|\\\]|\\\))\s*$", re.DOTALL)


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
    return callable(answer) and not is_expression(answer) and not hasattr(answer, "shape")


def as_latex(answer: Any) -> str:
    """Return a formula as LaTeX: a text, a SymPy expression or matrix, a number, an array, a nested list of these.

    A text may stand between dollars, and may be an equation, of which the last side counts.

    Raises:
        AnswerError: it is none of these.
    """
    if isinstance(answer, WithSympy):
        answer = answer.value()
    if isinstance(answer, str):
        return _last_side(answer)
    convert = FromSympy(_with_underscore).convert
    if isinstance(answer, list | tuple) or hasattr(answer, "tolist"):
        values = np.array(answer.tolist() if hasattr(answer, "tolist") else answer, dtype=object)
    else:
        values = np.array(answer, dtype=object)
    if values.ndim > 2 or not values.size:
        raise AnswerError(f"a formula is a number, a column or a matrix, not an array of shape {values.shape}")
    try:
        flat = [convert(item) if is_expression(item) else as_traced(item) for item in values.ravel()]
    except ArmproofError as problem:
        raise AnswerError(f"the answer is no formula: {problem}") from None
    cells = np.empty(values.size, dtype=object)
    cells[:] = flat
    return write_matrix(cells.reshape(values.shape))


def _last_side(text: str) -> str:
    """Return what stands behind the last = of a formula; a text that cannot be read is returned as it is."""
    if len(text) > MOST_CHARACTERS:
        raise AnswerError(f"the answer is too long: {len(text):,} characters, at most {MOST_CHARACTERS:,}")
    found = _DOLLARS.match(text)
    latex = normalise_unicode(found.group(2) if found else text)
    try:
        statements = Reader().read(latex)
    except ArmproofError:
        return latex
    if len(statements) != 1 or not isinstance(statements[0], n.Chain):
        return latex
    chain = statements[0]
    if len(chain.members) < 2 or any(relation != "=" for relation in chain.relations):
        return latex
    start, end = chain.members[-1].span
    return latex[start:end]


def _with_underscore(name: str) -> str:
    """Return theta1 as theta_1, as the arms write their symbols."""
    return re.sub(r"^([A-Za-z]+)(\d+)$", r"\1_\2", name)
