"""The error of the figures."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class FigureError(ArmproofError):
    """A figure cannot be drawn or written: an unknown figure, language, format or size, or a folder that takes no file."""
