"""The sources of lessons, and the notebooks that are made from them: each edition, and a kernel that runs it."""
