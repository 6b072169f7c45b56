"""The formats of documents: which reader takes which file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from armproof.verification.document.markdown import read_markdown_file
from armproof.verification.document.model import Document
from armproof.verification.document.notebook import read_notebook, read_percent
from armproof.verification.document.rst import read_rst
from armproof.verification.document.tex import ENVIRONMENTS, read_tex
from armproof.verification.document.text import read_text
from armproof.verification.errors import DocumentError

_READERS: dict[str, Callable[[Path, str], Document]] = {
    ".md": read_markdown_file,
    ".ipynb": read_notebook,
    ".py": read_percent,
    ".qmd": read_markdown_file,
    ".tex": read_tex,
    ".rst": read_rst,
}
_MARKS = {
    ".py": ("# %% [markdown]",),
    ".tex": ("$$", "\\[", *(f"\\begin{{{name}" for name in ENVIRONMENTS)),
    ".rst": (".. math::",),
}
SUFFIXES = tuple(_READERS)


def read_document(path: Path) -> Document:
    """Return the document of a file; raises DocumentError with file and line where it is not one."""
    return parse_document(path, read_text(path))


def parse_document(path: Path, text: str, format: str = "") -> Document:
    """Return the document of a text, read as its format or else the name of `path` says; raises DocumentError."""
    if format and f".{format}" not in _READERS:
        formats = ", ".join(suffix.removeprefix(".") for suffix in SUFFIXES)
        raise DocumentError(f"{path}: no format '{format}'; the formats are {formats}")
    return _READERS.get(f".{format}" if format else path.suffix, read_markdown_file)(path, text)


def has_displays(suffix: str, text: str) -> bool:
    """Whether a file's text is likely to hold displays."""
    return any(mark in text for mark in _MARKS.get(suffix, ("$$", "{math}")))
