"""The text of a file: UTF-8, of a bounded size, and of one moment."""

from __future__ import annotations

import os
import time
from pathlib import Path

from armproof.verification.errors import DocumentError

MAX_BYTES = 20_000_000
ATTEMPTS = 5  # at a file that changes while it is read
PAUSE = 0.02


def read_text(path: Path) -> str:
    """Return the text of a file; raises DocumentError where it is none, is too large, or never stays as it is."""
    try:
        return read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise DocumentError(f"{path}:{line}: not a text file in UTF-8 (byte {error.start})") from None


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file as they were at one moment; raises DocumentError."""
    try:
        for _ in range(ATTEMPTS):
            if path.stat().st_size > MAX_BYTES:
                raise DocumentError(f"{path}: larger than {MAX_BYTES // 1_000_000} MB")
            if (data := _read_unchanged(path)) is not None:
                return data
            time.sleep(PAUSE)
    except OSError as error:
        raise DocumentError(f"{path}: cannot be read: {error.strerror}") from None
    raise DocumentError(f"{path}: it changes while it is read; save it and verify it again")


def _read_unchanged(path: Path) -> bytes | None:
    """Return the bytes of a file, or None where it changed meanwhile."""
    with path.open("rb") as file:
        before = os.fstat(file.fileno())
        data = file.read(MAX_BYTES + 1)
        after = os.fstat(file.fileno())
    same = (before.st_mtime_ns, before.st_size) == (after.st_mtime_ns, after.st_size)
    return data if same and len(data) == after.st_size else None
