"""Exact scalars with one normal form, and matrices of them; knows no document and no arm."""
