"""Enter the sandbox: all protections that the plan names, one after the other; without one of them nothing is run."""

from __future__ import annotations

import os
import signal
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from armproof.course.grading.errors import SandboxError
from armproof.course.grading.limits import Limits
from armproof.course.grading.sandbox.kernel import PR_SET_NO_NEW_PRIVS, PR_SET_PDEATHSIG, prctl
from armproof.course.grading.sandbox.landlock import restrict_files
from armproof.course.grading.sandbox.places import DEVICES
from armproof.course.grading.sandbox.privileges import give_up_privileges
from armproof.course.grading.sandbox.resources import limit_resources
from armproof.course.grading.sandbox.seccomp import refuse_system_calls

_PATH = "/usr/local/bin:/usr/bin:/bin"


@dataclass(frozen=True)
class Plan:
    """The protections of a run; each of them was tried before, and is relied on.

    Attributes:
        namespaces: processes, network and shared memory of its own.
        user: another user, without capabilities.
        keep_reading: that user may read what root may (limited by `files`).
        files: Landlock.
        calls: the filter of system calls.
        readable: files and folders that may be read.
        others: processes of the same user, which the kernel counts as well; None if not known.
    """

    namespaces: bool = False
    user: bool = False
    keep_reading: bool = False
    files: bool = False
    calls: bool = False
    readable: Sequence[Path] = ()
    others: int | None = None
    variables: Mapping[str, str] = field(default_factory=dict)


def enter(plan: Plan, own: Path, user: int | None, limits: Limits) -> None:
    """Put this process into the sandbox for good; `own` is its folder, `user` the one it belongs to.

    Raises:
        SandboxError: a protection of the plan cannot be had.
    """
    os.chdir(own)
    os.environ.clear()
    os.environ.update(environment(own) | dict(plan.variables))
    os.nice(5)  # whoever watches comes first
    limit_resources(limits, 0 if plan.namespaces or plan.user else plan.others)
    prctl(PR_SET_NO_NEW_PRIVS, 1)
    may_drop = give_up_privileges(user if plan.user else None, keep_reading=plan.keep_reading)
    prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # a change of user clears it
    had = {
        "user": may_drop or not plan.user,
        "files": not plan.files or restrict_files(own, plan.readable, DEVICES),
        "calls": not plan.calls or refuse_system_calls(),
    }
    missing = [name for name, is_there in had.items() if not is_there]
    if missing:
        raise SandboxError(f"the sandbox is incomplete: {', '.join(missing)}")


def environment(own: Path) -> dict[str, Any]:
    """Return the environment of a run: nothing of the teacher's."""
    threads = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMEXPR")}
    home = {name: str(own) for name in ("HOME", "TMPDIR", "MPLCONFIGDIR", "XDG_CACHE_HOME", "JUPYTER_DATA_DIR")}
    return home | threads | {"PATH": _PATH, "LANG": "C.UTF-8", "MPLBACKEND": "agg", "ARMPROOF_PROGRESS": ""}
