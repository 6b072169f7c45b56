"""A lesson begun: tasks, text and wrong answers drafted for an arm or from a document."""
