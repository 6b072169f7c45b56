"""The errors of this room: what is asked for and cannot be had, or declared wrongly; each says what it is and what there is."""

from __future__ import annotations

from pathlib import Path

from armproof.models.errors import ArmproofError, written


class FigureError(ArmproofError):
    """A figure cannot be drawn or written: an unknown figure, language, format or size, or a folder that takes no file."""


class PrintError(ArmproofError):
    """A sheet cannot be printed: a format or language that is none, a missing extra, a document without its verdicts."""


class LessonError(ArmproofError):
    """There is no such lesson or task, or it is declared wrongly."""


class AnswerError(ArmproofError):
    """An answer that cannot be judged: it is no formula, or of names that the task does not have."""


class AuthoringError(ArmproofError):
    """A lesson cannot be built, checked or begun: no such lesson, a bad name, a folder that cannot be written."""


class SourceError(AuthoringError):
    """A lesson's source is malformed: says where, what stands there, and what was expected."""

    def __init__(self, path: Path, line: int, message: str, /, **terms: object) -> None:
        super().__init__("{path}:{line}: {reason}", path=path, line=line, reason=written(message, **terms))
        self.line = line


class SiteError(ArmproofError):
    """The site cannot be built: an unknown lesson, one that does not pass or does not run, a folder that cannot be written."""


class GradingError(ArmproofError):
    """Grading cannot begin, or cannot go on: no folder, no notebooks, no place for the results, no server."""


class SandboxError(GradingError):
    """There is no sandbox: bubblewrap is not installed, cannot be used here, or does not protect."""
