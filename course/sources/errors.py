"""Errors of lesson sources."""

from __future__ import annotations

from pathlib import Path

from armproof.models.errors import ArmproofError, written


class AuthoringError(ArmproofError):
    """A lesson cannot be built, checked or begun: no such lesson, a bad name, a folder that cannot be written."""


class SourceError(AuthoringError):
    """A lesson's source is malformed: says where, what stands there, and what was expected."""

    def __init__(self, path: Path, line: int, message: str, /, **terms: object) -> None:
        super().__init__("{path}:{line}: {reason}", path=path, line=line, reason=written(message, **terms))
        self.line = line
