"""A tree to its value: exact, or sampled at many configurations."""
