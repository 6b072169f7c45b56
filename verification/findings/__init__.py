"""Reasons as data: what a verdict rests on, by kind and terms, and the one place where it is put in words."""

from armproof.verification.findings.finding import Finding, finding_of, say
from armproof.verification.findings.kinds import MISPRINTS, OTHER_ANGLES, Kind

__all__ = ["MISPRINTS", "OTHER_ANGLES", "Finding", "Kind", "finding_of", "say"]
