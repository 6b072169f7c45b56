"""Bubblewrap: a sandbox for each submission, which its run joins.

Bubblewrap makes the namespaces and waits in them. The run itself is forked from the server, so that Drake, which takes
seconds to import, is imported once for a class; it then joins what bubblewrap has made, and gives up every privilege.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

from armproof.course.errors import SandboxError
from armproof.course.grading.sandbox import kernel

PROGRAM = "bwrap"
SEARCHED = "/usr/local/bin:/usr/bin:/bin"
WITHOUT = "with --unprotected each submission runs with limits of time and memory only, and can read and change whatever you can"
_FIRST_USER, _NOBODY = 2_000_000_000, 65_534
_SYSTEM = (
    "/usr/lib", "/usr/lib64", "/usr/libexec", "/usr/local/lib", "/lib", "/lib64", "/bin", "/usr/bin", "/usr/share/fonts",
    "/usr/share/zoneinfo", "/etc/ld.so.cache", "/etc/localtime", "/etc/mime.types", "/etc/fonts", "/nix/store",
    "/sys/devices/system/cpu",
)  # fmt: skip
_PACKAGES = ("site-packages", "dist-packages")
DEVICES = tuple(Path("/dev") / name for name in ("null", "zero", "random", "urandom"))


def find_bubblewrap() -> str:
    """Return where bubblewrap is installed.

    Raises:
        SandboxError: it is not.
    """
    if (found := shutil.which(PROGRAM)) is None:
        raise SandboxError("grading needs bubblewrap, and there is no program '{program}' (of Linux; Debian and Ubuntu: apt install bubblewrap); {without}",
            program=PROGRAM, without=WITHOUT)  # fmt: skip
    return found


def choose_user(place: int) -> int | None:
    """Return a user id that nothing of this system belongs to, another for each place; None if we are not root."""
    return _FIRST_USER + os.getpid() % 1_000_000 * 256 + place if os.geteuid() == 0 else None


class Sandbox:
    """A sandbox for one run: no network, no processes but its own, no file but what Python needs and its own folder.

    The process that makes it is from then on the parent of the sandbox: what it forks is in it.
    """

    def __init__(self, program: str, own: str, user: int | None) -> None:
        """Have a sandbox made.

        Args:
            program: bubblewrap.
            own: the folder that may be written.
            user: for root, who the run is to be.

        Raises:
            SandboxError: bubblewrap cannot make one here.
        """
        self._user = None if user is None else _give_folder(own, user)
        info, told = os.pipe()
        self._process = subprocess.Popen(
            [program, *_arguments(own), "--info-fd", str(told), "--", "cat"],
            pass_fds=(told,), stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={"PATH": SEARCHED},
        )  # fmt: skip
        os.close(told)
        with open(info, encoding="utf-8") as file:
            self._wait_until_made()
            self._first = os.pidfd_open(json.load(file)["child-pid"])
        try:
            kernel.join(self._first, kernel.PROCESSES | (kernel.USERS if user is None else 0))
        except OSError as problem:
            self.end()
            raise SandboxError("its sandbox cannot be joined ({reason})", reason=problem) from None

    def enter(self) -> None:
        """Shut this process in, for good and without privileges: one that was forked since the sandbox was made."""
        kernel.join(self._first, kernel.MOUNTS | kernel.NETWORK | kernel.MEMORY | kernel.NAMES)
        if self._user is not None:
            os.setgroups([])
            os.setresgid(self._user, self._user, self._user)
            os.setresuid(self._user, self._user, self._user)
        kernel.give_up_capabilities()
        kernel.prctl(kernel.PR_SET_NO_NEW_PRIVS, 1)

    def end(self) -> None:
        """End every process in the sandbox; they are gone when the children of this process have been waited for."""
        with contextlib.suppress(ProcessLookupError):
            signal.pidfd_send_signal(self._first, signal.SIGKILL)  # the kernel ends the others with the first one

    def _wait_until_made(self) -> None:
        """Wait until the program that waits in the sandbox gives back what it is given."""
        assert self._process.stdin and self._process.stdout and self._process.stderr
        try:
            os.write(self._process.stdin.fileno(), b"\n")
            made = os.read(self._process.stdout.fileno(), 1)
        except BrokenPipeError:
            made = b""
        if not made:
            said = self._process.communicate()[1].decode("utf-8", errors="replace").strip()
            raise SandboxError(said or "it says nothing")


def _arguments(own: str) -> Iterator[str]:
    yield from "--unshare-pid --unshare-net --unshare-ipc --unshare-uts --die-with-parent --new-session".split()
    if os.geteuid() != 0:
        yield "--unshare-user"
    readable = readable_places()
    for folder in sorted({parent for place in (*readable, *DEVICES, Path(own)) for parent in place.parents}):
        yield from ("--dir", str(folder))  # bubblewrap's own would be closed to another user
    for place in readable:
        yield from ("--ro-bind", str(place), str(place))
    for device in DEVICES:
        yield from ("--dev-bind", str(device), str(device))
    yield from ("--bind", own, own, "--remount-ro", "/")


def _give_folder(folder: str, user: int) -> int:
    """Give a folder to a user; returns whom it belongs to: nobody, where there are no such ids."""
    try:
        os.chown(folder, user, user)
    except OSError:
        os.chown(folder, _NOBODY, _NOBODY)
        return _NOBODY
    return user


def readable_places() -> tuple[Path, ...]:
    """Return the files and folders that are needed, each once; never the working folder, nor the whole of a home."""
    paths = sysconfig.get_paths()
    found = [paths[name] for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    found += [str(Path(prefix) / part) for prefix in (sys.prefix, sys.base_prefix) for part in ("lib", "bin")]
    found += [str(Path(sys.prefix) / "pyvenv.cfg"), *(each for each in sys.path if Path(each).name in _PACKAGES)]
    for room in ("models", "verification", "course"):
        spec = find_spec(f"armproof.{room}")
        found += spec.submodule_search_locations or [] if spec is not None else []
    places = dict.fromkeys(Path(each).absolute() for each in (*found, *_SYSTEM) if Path(each).exists())
    return tuple(each for each in places if each.resolve() != Path("/"))


def lies_in_readable(path: Path) -> Path | None:
    """Return the readable place that a path lies in, which would show it to every submission; None if there is none."""
    real = path.resolve()
    return next((place for place in readable_places() if real.is_relative_to(place.resolve())), None)
