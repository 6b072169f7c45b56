"""A model file and its convention card to an arm."""
