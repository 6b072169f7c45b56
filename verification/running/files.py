"""Correct a file: read it as it is, byte order mark and line ends included, and write it as a whole."""

from __future__ import annotations

from codecs import BOM_UTF8
from pathlib import Path

from armproof.verification.document import SUFFIXES
from armproof.verification.document.text import read_bytes, read_text
from armproof.verification.errors import DocumentError
from armproof.verification.running.atomic import write_atomically
from armproof.verification.running.copy import CorrectedCopy, correct_text


def correct_file(path: Path) -> CorrectedCopy:
    """Return the corrected copy of a document file; raises DocumentError where it is none."""
    if not path.exists():
        raise DocumentError(f"{path}: no such file")
    if not path.is_file():
        raise DocumentError(f"{path}: not a file; one document is corrected at a time")
    if path.suffix not in SUFFIXES:
        raise DocumentError(f"{path}: '{path.suffix}' files are not read; those that are: {', '.join(SUFFIXES)}")
    return correct_text(path, read_text(path))


def save(copy: CorrectedCopy, target: Path) -> None:
    """Write a corrected copy; raises DocumentError where the document has changed since it was read, OSError as usual."""
    original = read_bytes(copy.path)
    mark = BOM_UTF8 if original.startswith(BOM_UTF8) else b""
    if original != mark + copy.before.encode("utf-8"):
        raise DocumentError(f"{copy.path}: it has changed since it was read; correct it again")
    data = mark + copy.after.encode("utf-8")
    if not (target.exists() and target.read_bytes() == data):
        write_atomically(target, data)
