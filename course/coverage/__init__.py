"""What of the source documents the course asks: each line of theirs that is an exercise, its sheets and its tasks."""
