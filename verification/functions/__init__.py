"""Functions checked against an arm: what a student's Python computes, proved, confirmed or refuted."""

from armproof.verification.functions.check import check_function
from armproof.verification.functions.function_check import FunctionCheck, FunctionVerdict, TableRow

__all__ = ["FunctionCheck", "FunctionVerdict", "TableRow", "check_function"]
