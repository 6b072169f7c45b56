"""Errors of the verification room; every one carries a message a teacher can act on."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class ReadError(ArmproofError):
    """A formula cannot be read: says what was met, where in the LaTeX, and what was expected."""

    def __init__(self, message: str, offset: int = 0) -> None:
        super().__init__(message)
        self.offset = offset


class DocumentError(ArmproofError):
    """A document as a whole cannot be checked (front matter, encoding, unknown arm); `key` is the front-matter key at fault."""

    def __init__(self, message: str, key: str = "") -> None:
        super().__init__(message)
        self.key = key


class EvaluationError(ArmproofError):
    """A formula was read but has no value: shapes that do not fit, a singular matrix, too many terms."""


class UnboundName(EvaluationError):
    """A formula holds a name that nothing in the document or on the arm gives a meaning."""

    def __init__(self, name: str, reason: str = "") -> None:
        super().__init__(f"'{name}' is not bound" + (f": {reason}" if reason else ""))
        self.name = name


class NoValue(EvaluationError):
    """A formula that has no value at any configuration, such as 1/0: it is wrong as it stands."""


class ShapeError(NoValue):
    """Sizes that can never fit."""


class TooComplex(EvaluationError):
    """A formula exceeds the bounds on terms or time that keep every display under two seconds."""
