"""Give up what root may do: the run of a submission is no user of the system, and has no capabilities."""

from __future__ import annotations

import os

from armproof.course.grading.sandbox.kernel import (
    CAP_DAC_READ_SEARCH,
    IS_LINUX,
    PR_SET_KEEPCAPS,
    keep_capabilities,
    prctl,
)

_FIRST, _NOBODY = 2_000_000_000, 65_534


def choose_user(place: int) -> int | None:
    """Return a user id that nothing of this system belongs to, another for each place; None if we are not root."""
    if os.geteuid() != 0:
        return None
    return _FIRST + os.getpid() % 1_000_000 * 256 + place


def give_folder(folder: str, user: int | None) -> int | None:
    """Give a folder to a user; returns the user whom it belongs to: nobody, where there are no such ids."""
    for each in (user, _NOBODY):
        if user is not None and each is not None:
            try:
                os.chown(folder, each, each)
            except OSError:
                continue
            return each
    return None


def give_up_privileges(user: int | None, *, keep_reading: bool) -> bool:
    """Become another user without capabilities; whether this process may do no more than that.

    Args:
        user: its id; None to stay the same one.
        keep_reading: keep the right to read all files. Where Python itself is installed in a private folder of root, nothing
            could be imported otherwise; what is read is then limited by Landlock.
    """
    if user is not None:
        try:
            if keep_reading:
                prctl(PR_SET_KEEPCAPS, 1)
            os.setgroups([])
            os.setresgid(user, user, user)
            os.setresuid(user, user, user)
        except OSError:
            return False
    if not IS_LINUX:
        return os.geteuid() != 0
    return keep_capabilities(*([CAP_DAC_READ_SEARCH] if keep_reading and user is not None else []))


def is_readable_by(user: int, paths: list[str]) -> bool:
    """Whether a user could read all these files and folders; decided in a process of its own."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.setgroups([])
            os.setresgid(user, user, user)
            os.setresuid(user, user, user)
            code = 0 if all(os.access(path, os.R_OK) for path in paths) else 1
        finally:
            os._exit(code)
    return os.waitpid(child, 0)[1] == 0
