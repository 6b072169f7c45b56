"""The errors of Armproof: one base class, so that a caller can catch them all."""


class ArmproofError(Exception):
    """Base of every error that Armproof raises for a user's input."""


class ModelError(ArmproofError):
    """An arm cannot be loaded or asked for what it does not have."""
