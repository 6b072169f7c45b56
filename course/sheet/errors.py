"""The error of printing."""

from __future__ import annotations

from armproof.models.errors import ArmproofError


class PrintError(ArmproofError):
    """A sheet cannot be printed: a format or language that is none, a missing extra, a document without its verdicts."""
