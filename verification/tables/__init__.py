"""DH tables as claims: read in the usual spellings, each row checked against the arm's frames."""

from armproof.verification.tables.check import TWIST, check_array_table, check_table

__all__ = ["TWIST", "check_array_table", "check_table"]
