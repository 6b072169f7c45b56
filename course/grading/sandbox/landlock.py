"""Landlock: this process may write in its own folder only, and read only what Python needs (Linux 5.13 and later).

From ABI 4 on it may open no TCP connection either, from ABI 6 on it may signal no process but its own children.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterable
from pathlib import Path

from armproof.course.grading.sandbox.kernel import IS_LINUX, syscall

_CREATE, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
_VERSION, _PATH_BENEATH = 1, 1
_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
_TRUNCATE = 1 << 14
_OF_A_FILE = _EXECUTE | _WRITE_FILE | _READ_FILE | _TRUNCATE
_MAKE_DEVICES = 1 << 6 | 1 << 11
_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}  # how many rights over files each ABI knows
_TCP, _SCOPES = 0b11, 0b11
READ, WRITE, USE = "read", "write", "use"


class _Ruleset(ctypes.Structure):
    _fields_ = (("fs", ctypes.c_uint64), ("net", ctypes.c_uint64), ("scoped", ctypes.c_uint64))


class _PathBeneath(ctypes.Structure):
    _pack_ = 1
    _layout_ = "ms"
    _fields_ = (("allowed", ctypes.c_uint64), ("folder", ctypes.c_int32))


def landlock_version() -> int:
    """Return the ABI of the kernel's Landlock; 0 where there is none."""
    return max(syscall(_CREATE, None, ctypes.c_size_t(0), ctypes.c_uint32(_VERSION)), 0) if IS_LINUX else 0


def restrict_files(own: Path, readable: Iterable[Path], devices: Iterable[Path]) -> bool:
    """Restrict this process for good; whether it is restricted.

    Args:
        own: the folder that may be written.
        readable: files and folders that may be read and executed.
        devices: files that may be read and written, such as /dev/null.
    """
    version = landlock_version()
    if not version:
        return False
    handled = (1 << _RIGHTS[min(version, 5)]) - 1
    attributes = _Ruleset(handled, _TCP if version >= 4 else 0, _SCOPES if version >= 6 else 0)
    size = 24 if version >= 6 else 16 if version >= 4 else 8
    ruleset = syscall(_CREATE, ctypes.byref(attributes), ctypes.c_size_t(size), ctypes.c_uint32(0))
    if ruleset < 0:
        return False
    try:
        rules = [(own, handled & ~_MAKE_DEVICES)]
        rules += [(path, _EXECUTE | _READ_FILE | _READ_DIR) for path in readable]
        rules += [(path, _READ_FILE | _WRITE_FILE) for path in devices]
        written = all(_allow(ruleset, path, rights & handled) for path, rights in rules)
        return written and syscall(_RESTRICT_SELF, ctypes.c_int(ruleset), ctypes.c_uint32(0)) == 0
    finally:
        os.close(ruleset)


def _allow(ruleset: int, path: Path, rights: int) -> bool:
    """Allow what is beneath a path; one that is not there needs no rule."""
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return True
    try:
        rule = _PathBeneath(rights if os.path.isdir(path) else rights & _OF_A_FILE, place)
        beneath = ctypes.c_int(_PATH_BENEATH)
        return syscall(_ADD_RULE, ctypes.c_int(ruleset), beneath, ctypes.byref(rule), ctypes.c_uint32(0)) == 0
    finally:
        os.close(place)
