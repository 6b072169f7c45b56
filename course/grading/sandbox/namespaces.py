"""Namespaces: processes of its own, no network and no shared memory with others, where the system allows it."""

from __future__ import annotations

import os

from armproof.course.grading.sandbox.kernel import IS_LINUX, unshare

_USER, _PROCESSES, _NETWORK, _MEMORY = 0x10000000, 0x20000000, 0x40000000, 0x08000000
_ALL = _PROCESSES | _NETWORK | _MEMORY


def enter_namespaces() -> bool:
    """Let the next child be the first process of namespaces of its own; whether that was allowed.

    Root needs no user namespace; others do, and keep their own user and group in it.
    """
    if not IS_LINUX:
        return False
    if os.geteuid() == 0 and unshare(_ALL):
        return True
    user, group = os.geteuid(), os.getegid()
    if not unshare(_USER | _ALL):
        return False
    try:
        _write("setgroups", "deny")
        _write("uid_map", f"{user} {user} 1")
        _write("gid_map", f"{group} {group} 1")
    except OSError:
        return False
    return True


def _write(name: str, text: str) -> None:
    with open(f"/proc/self/{name}", "w", encoding="ascii") as file:
        file.write(text)
