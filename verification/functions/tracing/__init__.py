"""Formulas out of functions: what a Python function computes, with symbols for its arguments."""
