"""The tasks of the lessons: what each asks, its hints, right answers and known mistakes; one module a lesson."""
