"""Course documents as A4 sheets: typeset mathematics, figures, and the verdicts behind every equation."""
