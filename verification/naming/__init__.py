"""What a name of the document means on the arm."""
