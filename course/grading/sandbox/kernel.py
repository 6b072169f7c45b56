"""The system calls that Python has no function for (some until 3.12)."""

from __future__ import annotations

import ctypes
import os
import sys
from functools import lru_cache
from typing import Any

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER, PR_SET_NO_NEW_PRIVS = 1, 36, 38
MOUNTS, NAMES, MEMORY, USERS, PROCESSES, NETWORK = 0x20000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
_CAPABILITY_VERSION = 0x20080522


def prctl(option: int, value: int) -> None:
    """Set something of this process; on another system than Linux nothing."""
    if sys.platform.startswith("linux"):
        zero = ctypes.c_ulong(0)
        _libc().prctl(option, ctypes.c_ulong(value), zero, zero, zero)


def join(process: int, namespaces: int) -> None:
    """Join namespaces of a process, which its file descriptor names; of PROCESSES, the next child is the first in it."""
    _call("setns", process, namespaces)


def give_up_capabilities() -> None:
    """Give up everything that root may do, in this user namespace as well."""
    header = (ctypes.c_uint32 * 2)(_CAPABILITY_VERSION, 0)
    _call("capset", ctypes.byref(header), ctypes.byref((ctypes.c_uint32 * 6)()))


def _call(name: str, *arguments: Any) -> None:
    if getattr(_libc(), name)(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


@lru_cache(maxsize=1)
def _libc() -> Any:
    return ctypes.CDLL(None, use_errno=True)
