"""The system calls that Python has no function for; on another system than Linux none of them is there."""

from __future__ import annotations

import ctypes
import os
import sys
from functools import lru_cache
from typing import Any

IS_LINUX = sys.platform.startswith("linux")
PR_SET_PDEATHSIG, PR_SET_KEEPCAPS, PR_SET_SECCOMP, PR_SET_CHILD_SUBREAPER, PR_SET_NO_NEW_PRIVS = 1, 8, 22, 36, 38
_CAPSET = {"x86_64": 126, "aarch64": 91}
_CAPABILITY_VERSION = 0x20080522
CAP_DAC_READ_SEARCH = 2


def prctl(option: int, value: int, pointer: Any = None) -> bool:
    """Set something of this process; whether it was set."""
    if not IS_LINUX:
        return False
    third = ctypes.c_void_p(0) if pointer is None else pointer
    return bool(_libc().prctl(option, ctypes.c_ulong(value), third, ctypes.c_ulong(0), ctypes.c_ulong(0)) == 0)


def syscall(number: int, *arguments: Any) -> int:
    """Make a system call; -1 where it is refused or unknown."""
    if not IS_LINUX:
        return -1
    return int(_libc().syscall(ctypes.c_long(number), *arguments))


def unshare(flags: int) -> bool:
    """Leave namespaces for new ones; whether that was allowed."""
    return IS_LINUX and bool(_libc().unshare(ctypes.c_int(flags)) == 0)


def keep_capabilities(*kept: int) -> bool:
    """Give all capabilities up but those named; whether that was done."""
    number = _CAPSET.get(os.uname().machine)
    if number is None:
        return False
    header = (ctypes.c_uint32 * 2)(_CAPABILITY_VERSION, 0)
    mask = sum(1 << each for each in kept)
    words = (mask & 0xFFFFFFFF, mask >> 32)
    data = (ctypes.c_uint32 * 6)(words[0], words[0], 0, words[1], words[1], 0)  # effective, permitted, inheritable
    return syscall(number, ctypes.byref(header), ctypes.byref(data)) == 0


@lru_cache(maxsize=1)
def _libc() -> Any:
    return ctypes.CDLL(None, use_errno=True)
