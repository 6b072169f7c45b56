"""Conditions and implications: det J = 0 ⇔ …, ranks, what follows from what."""
