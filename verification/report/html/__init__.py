"""The report as web pages: one a document and an index, each a file of its own that needs nothing else."""
