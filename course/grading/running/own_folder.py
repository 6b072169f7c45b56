"""The folder of one run: how much is in it, and its removal, whatever was made of it."""

from __future__ import annotations

import contextlib
import os
import stat
from itertools import count

_ENTRIES = 10_000


def size_of(folder: str) -> float:
    """Return the bytes of disk that a folder takes; infinite if it holds very many entries or cannot be surveyed."""
    total, seen, waiting = 0, 0, [folder]
    while waiting:
        try:
            with os.scandir(waiting.pop()) as entries:
                for entry in entries:
                    seen += 1
                    if seen > _ENTRIES:
                        return float("inf")
                    state = entry.stat(follow_symlinks=False)
                    total += state.st_blocks * 512
                    if stat.S_ISDIR(state.st_mode):
                        waiting.append(entry.path)
        except FileNotFoundError:
            continue
        except PermissionError:  # it closed a folder of its own
            continue
        except OSError:  # a path that is too long
            return float("inf")
    return total


def remove(folder: str) -> None:
    """Remove a folder that no process writes to any more; folders within folders are lifted first, so that none is deep."""
    numbers = count()
    with contextlib.suppress(OSError):
        while entries := _entries(folder):
            for entry in entries:
                if not entry.is_dir(follow_symlinks=False):
                    os.unlink(entry.path)
                    continue
                os.chmod(entry.path, 0o700)
                for inner in _entries(entry.path):
                    if inner.is_dir(follow_symlinks=False):
                        os.chmod(inner.path, 0o700)
                        os.rename(inner.path, os.path.join(folder, f"lifted-{next(numbers)}-{os.urandom(8).hex()}"))
                    else:
                        os.unlink(inner.path)
                os.rmdir(entry.path)
        os.rmdir(folder)


def _entries(folder: str) -> list[os.DirEntry[str]]:
    with os.scandir(folder) as entries:
        return list(entries)
