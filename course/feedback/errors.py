"""Errors of lessons and tasks: what a teacher declared wrongly, or a student asked for that there is not."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class LessonError(ArmproofError):
    """There is no such lesson or task, or it is declared wrongly."""


class AnswerError(ArmproofError):
    """An answer that cannot be judged: it is no formula, or of names that the task does not have."""
