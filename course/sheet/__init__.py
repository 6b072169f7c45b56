"""A sheet: the blocks and the words of a checked document, read with their verdicts, and written as HTML."""
