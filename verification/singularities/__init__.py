"""Singular configurations of an arm, exactly: families, ranks, lost and kept directions, boundary or inside."""

from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.families import Family, Position, SingularityAnalysis

__all__ = ["Family", "Position", "SingularityAnalysis", "analyse_singularities"]
