"""Grading: a class's notebooks, each run in a process of its own that can touch nothing else."""
