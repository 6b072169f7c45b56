"""Singular configurations of an arm, exactly: families, ranks, lost and kept directions, boundary or inside."""
