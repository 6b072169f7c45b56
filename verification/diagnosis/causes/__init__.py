"""The likely mistake behind a matrix that is wrong as a whole."""

from armproof.verification.diagnosis.causes.find import find_cause

__all__ = ["find_cause"]
