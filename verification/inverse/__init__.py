"""Closed-form inverse kinematics of a document: read as a derivation, proved by substitution, evaluated in bulk."""

from verification.inverse.document import read_inverse
from verification.inverse.kinematics import InverseKinematics
from verification.inverse.proof import Proof
from verification.inverse.reading import InverseError
from verification.inverse.solutions import Mark, Solutions

__all__ = ["InverseError", "InverseKinematics", "Mark", "Proof", "Solutions", "read_inverse"]
