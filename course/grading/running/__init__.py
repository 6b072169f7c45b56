"""A submission run: the server that has loaded the course, the keeper of one run, and what happens in it."""
