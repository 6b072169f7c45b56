"""From a refuted display to one that verifies: what mends it, and the corrected copy of its document."""

from armproof.verification.correction.record import applied, corrected, corrected_latex, edits

__all__ = ["applied", "corrected", "corrected_latex", "edits"]
