"""Errors of the verification room; every one carries a message a teacher can act on.

Each is raised with a finding, or with a text that is said under the kind of its class (`finding_of`).
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path
from types import TracebackType

from armproof.models.errors import ArmproofError
from armproof.verification.findings import Finding, Kind, say


def located(path: Path | str | None, line: int | None, reason: str) -> str:
    """Return a reason behind its file and line, as far as they are known: "handout.md:3: no arm 'skara'"."""
    return ": ".join([f"{path}:{line}" if line is not None else str(path), reason]) if path is not None else reason


class ReadError(ArmproofError):
    """A formula cannot be read: says what was met, where in the LaTeX, and what was expected."""

    kind = Kind.NOT_READ

    def __init__(self, message: str | Finding, offset: int = 0) -> None:
        super().__init__(message)
        self.offset = offset


class DocumentError(ArmproofError):
    """A document as a whole cannot be checked (front matter, encoding, unknown arm).

    `key` is the front-matter key at fault; `path` and `line`, as far as they are known, say where it is.
    """

    kind = Kind.DOCUMENT_AT_FAULT

    def __init__(
        self, reason: str | Finding, key: str = "", *, path: Path | None = None, line: int | None = None
    ) -> None:
        super().__init__(reason)
        self.key, self.path, self.line = key, path, line

    def __str__(self) -> str:
        return located(self.path, self.line, str(self.args[0]))


class EvaluationError(ArmproofError):
    """A formula was read but has no value: shapes that do not fit, a singular matrix, too many terms."""

    kind = Kind.NOT_EVALUATED


class UnboundName(EvaluationError):
    """A formula holds a name that nothing in the document or on the arm gives a meaning."""

    def __init__(self, name: str, reason: str | Finding = "") -> None:
        because = say(Kind.NOT_BOUND_BECAUSE, name=name, reason=reason)
        super().__init__(because if reason else say(Kind.NOT_BOUND, name=name))
        self.name = name


class NoValue(EvaluationError):
    """A formula that has no value at any configuration, such as 1/0: it is wrong as it stands."""

    kind = Kind.NO_VALUE


class ShapeError(NoValue):
    """Sizes that can never fit."""

    kind = Kind.SIZES_DO_NOT_FIT


class NotSampled(ArmproofError):
    """A formula is decided on samples, and the check takes none; no other reading of it may be tried instead."""

    kind = Kind.NOT_SAMPLED


class TooComplex(EvaluationError):
    """A formula exceeds the bounds on terms or time that keep every display under two seconds."""

    kind = Kind.MORE_THAN_IS_COMPUTED


class WhereDefined(AbstractContextManager[None]):
    """Leaves its block at what has no value; what takes too long is no answer, and goes on."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        return isinstance(error, EvaluationError) and not isinstance(error, TooComplex)


class ClusterError(ArmproofError):
    """A Dask cluster cannot be used: there is none at the address, others read along, or its workers run something else."""
