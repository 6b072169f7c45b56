"""Functions checked against an arm: what a student's Python computes, proved, confirmed or refuted."""

from verification.python.check import check_function
from verification.python.function_check import FunctionCheck, FunctionVerdict, TableRow

__all__ = ["FunctionCheck", "FunctionVerdict", "TableRow", "check_function"]
