"""What figures show of an arm: its task, its poses, its lengths, its motions, what it loses."""
