"""The errors of grading."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class GradingError(ArmproofError):
    """Grading cannot begin, or cannot go on: no folder, no notebooks, no place for the results, no server."""


class SandboxError(ArmproofError):
    """A protection that was in force when grading began could not be had again: nothing is run without it."""
