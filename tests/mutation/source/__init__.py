"""Mutants of our own source code: what decides a verdict must not change without a test that fails."""
