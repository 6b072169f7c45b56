"""A filter of system calls: no sockets, no change of modes and owners, no limits or priorities of other processes.

Landlock does not speak of these: a process may still change the mode of any file of its user, and open UDP or Unix sockets.
"""

from __future__ import annotations

import ctypes
import os
import struct

from armproof.course.grading.sandbox.kernel import IS_LINUX, PR_SET_SECCOMP, prctl

_MODE_FILTER = 2
_ALLOW, _REFUSE, _KILL = 0x7FFF0000, 0x00050001, 0x80000000  # refused with EPERM
_LOAD, _EQUAL, _AT_LEAST, _RETURN = 0x20, 0x15, 0x35, 0x06
_X32 = 0x40000000
_ARCHITECTURES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
_PRLIMIT = {"x86_64": 302, "aarch64": 261}
_EVERYWHERE = (425, 438, 440, 447, 452, 463, 466, 469)  # io_uring, pidfd_getfd, process_madvise, memfd_secret, …
_REFUSED = {
    "x86_64": (
        41, 319, 29, 64, 68, 240,                     # socket, memfd_create, shmget, semget, msgget, mq_open
        90, 91, 92, 93, 94, 268, 260,                 # chmod, fchmod, chown, fchown, lchown, fchmodat, fchownat
        132, 235, 261, 280,                           # utime, utimes, futimesat, utimensat
        188, 189, 190, 197, 198, 199,                 # setxattr, removexattr and their like
        141, 142, 144, 203, 314, 251, 256, 279,       # setpriority, sched_set…, ioprio_set, migrate_pages, move_pages
        101, 310, 311, 304,                           # ptrace, process_vm_readv, process_vm_writev, open_by_handle_at
        321, 323, 298, 248, 249, 250, 272, 308,       # bpf, userfaultfd, perf_event_open, keys, unshare, setns
    ),
    "aarch64": (
        198, 279, 194, 190, 186, 180, 52, 53, 54, 55, 88, 5, 6, 7, 14, 15, 16, 140, 118, 119, 122, 274, 30, 238, 239,
        117, 270, 271, 265, 280, 282, 241, 217, 218, 219, 97, 268,
    ),
}  # fmt: skip


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


def refuse_system_calls() -> bool:
    """Filter the system calls of this process for good; whether that was allowed (it needs PR_SET_NO_NEW_PRIVS)."""
    machine = os.uname().machine if IS_LINUX else ""
    if machine not in _ARCHITECTURES:
        return False
    code = program(machine)
    return prctl(PR_SET_SECCOMP, _MODE_FILTER, ctypes.byref(_Program(len(code) // 8, code)))


def program(machine: str) -> bytes:
    """Return the filter for a kind of processor."""
    numbers = (*_REFUSED[machine], *_EVERYWHERE)
    refuse, allow = len(numbers) + 4, len(numbers) + 3  # places of the two answers, counted from the first number
    parts = [_step(_LOAD, 4), _step(_EQUAL, _ARCHITECTURES[machine], 1), _step(_RETURN, _KILL), _step(_LOAD, 0)]
    parts.append(_step(_AT_LEAST, _X32, len(numbers) + 4))
    parts += [_step(_EQUAL, number, refuse - place - 1) for place, number in enumerate(numbers)]
    parts += [_step(_EQUAL, _PRLIMIT[machine], 0, 2), _step(_LOAD, 16), _step(_EQUAL, 0, 0, 1)]  # prlimit of itself
    assert len(parts) == 5 + allow  # the places above
    return b"".join([*parts, _step(_RETURN, _ALLOW), _step(_RETURN, _REFUSE)])


def _step(code: int, value: int, if_so: int = 0, if_not: int = 0) -> bytes:
    return struct.pack("=HBBI", code, if_so, if_not, value)
