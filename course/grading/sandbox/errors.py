"""The errors of grading."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class GradingError(ArmproofError):
    """Grading cannot begin, or cannot go on: no folder, no notebooks, no place for the results, no server."""


class SandboxError(GradingError):
    """There is no sandbox: bubblewrap is not installed, cannot be used here, or does not protect."""
