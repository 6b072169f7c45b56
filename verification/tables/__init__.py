"""DH tables as claims: read in the usual spellings, each row checked against the arm's frames."""

from armproof.verification.tables.check import check_array_table, check_table

__all__ = ["check_array_table", "check_table"]
