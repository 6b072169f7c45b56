"""Random arms with claims about them, and what is true of them by Drake's plant alone."""
