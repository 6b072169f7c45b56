"""Chains of =, ≤ and ≈: what is claimed, which side is true, equal or not, by two routes."""
