"""What decides a verdict on a machine: Armproof to the last byte, Python, and the libraries that compute."""

from __future__ import annotations

import platform
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path

_ROOMS = ("models", "verification", "course")
_READ = (".py", ".lark", ".urdf", ".yaml", ".po", ".toml", ".csv")  # what is run, or read by what runs
_LIBRARIES = ("drake", "numpy", "python-flint", "lark")


@cache
def versions() -> dict[str, str]:
    """Return what runs in this process, by name: two that are equal here give the same verdicts."""
    libraries = {name: version(name) for name in _LIBRARIES}
    python = ".".join(platform.python_version_tuple()[:2])
    return {"Armproof": f"{version('armproof')} ({_digest()[:12]})", "Python": python, **libraries}


def _digest() -> str:
    """Return a digest of Armproof's own files: a version has as many forms as its authors have machines."""
    root = Path(__file__).resolve().parents[2]
    files = (file for room in _ROOMS for file in (root / room).rglob("*") if file.suffix in _READ)
    found = sha256()
    for name, file in sorted((str(file.relative_to(root)), file) for file in files):
        found.update(name.encode() + b"\0" + sha256(file.read_bytes()).digest())
    return found.hexdigest()
