"""Figures as files: the command, formats, films, many on several cores."""
