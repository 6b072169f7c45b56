"""Slips and rewrites of the course's proved equations: the first must all be refuted, the second all proved."""
