"""Formulas out of functions: what a Python function computes, with symbols for its arguments."""

# Gives the traced numbers the methods that NumPy's functions look for.
from armproof.verification.functions.tracing import replacements as replacements
