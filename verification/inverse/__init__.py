"""Closed-form inverse kinematics of a document: read as a derivation, proved by substitution, evaluated in bulk."""

from armproof.verification.inverse.document import read_inverse
from armproof.verification.inverse.kinematics import InverseKinematics
from armproof.verification.inverse.proof import Proof
from armproof.verification.inverse.reading import InverseError
from armproof.verification.inverse.solutions import Mark, Solutions

__all__ = ["InverseError", "InverseKinematics", "Mark", "Proof", "Solutions", "read_inverse"]
