"""The text of a file: UTF-8, of a bounded size, and of one moment."""

from __future__ import annotations

import os
import time
from pathlib import Path

from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say

MAX_BYTES = 20_000_000
ATTEMPTS = 5  # at a file that changes while it is read
PAUSE = 0.02


def read_text(path: Path) -> str:
    """Return the text of a file; raises DocumentError where it is none, is too large, or never stays as it is."""
    try:
        return read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise DocumentError(say(Kind.NOT_UTF8, byte=error.start), path=path, line=line) from None


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file as they were at one moment; raises DocumentError."""
    try:
        for _ in range(ATTEMPTS):
            if path.stat().st_size > MAX_BYTES:
                raise DocumentError(say(Kind.FILE_TOO_LARGE, megabytes=MAX_BYTES // 1_000_000), path=path)
            if (data := _read_unchanged(path)) is not None:
                return data
            time.sleep(PAUSE)
    except OSError as error:
        raise DocumentError(say(Kind.FILE_UNREADABLE, reason=str(error.strerror)), path=path) from None
    raise DocumentError(say(Kind.FILE_CHANGES), path=path)


def _read_unchanged(path: Path) -> bytes | None:
    """Return the bytes of a file, or None where it changed meanwhile."""
    with path.open("rb") as file:
        before = os.fstat(file.fileno())
        data = file.read(MAX_BYTES + 1)
        after = os.fstat(file.fileno())
    same = (before.st_mtime_ns, before.st_size) == (after.st_mtime_ns, after.st_size)
    return data if same and len(data) == after.st_size else None
