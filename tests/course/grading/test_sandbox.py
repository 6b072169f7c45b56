"""The sandbox without a server: what it prevents, tried on things that nobody needs, and what is said where there is none."""

import contextlib
import ctypes
import encodings.idna  # noqa: F401 - which a user who cannot read Python's own files cannot import later
import json
import os
import signal
import socket
import sys
import tempfile
import time
from pathlib import Path

import pytest

from armproof.course.errors import SandboxError
from armproof.course.grading.running import keeper
from armproof.course.grading.running.keeper import keep
from armproof.course.grading.running.own_folder import remove, size_of
from armproof.course.grading.running.protections import ATTEMPTS, describe, try_out
from armproof.course.grading.sandbox import bubblewrap
from armproof.course.grading.sandbox.bubblewrap import choose_user, find_bubblewrap, lies_in_readable, readable_places
from armproof.course.grading.sandbox.limits import Limits

ALL = dict.fromkeys(ATTEMPTS, True)
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux")


@pytest.fixture
def base():
    with tempfile.TemporaryDirectory() as folder:  # not pytest's, which is closed to other users
        os.chmod(folder, 0o711)
        yield folder


def apart(function):
    """Return what a function returns in a process of its own: a keeper joins namespaces, and ends all that descends from it."""
    ours, theirs = socket.socketpair()
    child = os.fork()
    if child == 0:
        try:
            theirs.sendall(json.dumps(function()).encode())
        finally:
            os._exit(0)
    theirs.close()
    with ours.makefile("rb") as answer:
        found = json.loads(answer.read())
    os.waitpid(child, 0)
    ours.close()
    return found


def kept(run, program: str, base: str) -> dict[str, object]:
    return apart(lambda: keep(run, program, Limits(seconds=10), base, choose_user(0)).__dict__)


def without(*dropped: str):
    """Return what bubblewrap is called with, less some of it."""
    arguments = bubblewrap._arguments
    return lambda own: (each for each in arguments(own) if each not in dropped)


def test_bubblewrap_prevents_every_attempt(base, bwrap):
    assert try_out(bwrap, base) == ALL
    assert os.listdir(base) == []


def test_bubblewrap_protects_whoever_is_not_root_too(base, bwrap, monkeypatch):
    if os.geteuid() != 0:
        pytest.skip("all other tests are of somebody who is not root")
    system = tuple(Path(place) for place in ("/usr", "/bin", "/lib", "/lib64") if os.path.exists(place))
    monkeypatch.setattr(bubblewrap, "readable_places", lambda: system)
    os.chown(base, 65_534, 65_534)

    def as_nobody():
        os.setgroups([])
        os.setresgid(65_534, 65_534, 65_534)
        os.setresuid(65_534, 65_534, 65_534)
        return try_out(bwrap, base)

    assert apart(as_nobody) == ALL


def test_without_a_sandbox_nothing_is_claimed(base):
    held = try_out("", base)
    assert held["own"] and not any(held[name] for name in ("write", "read", "mode", "signal", "network", "unix"))
    assert [each.held for each in describe({})] == [False] * len(ATTEMPTS)


@pytest.mark.parametrize(("dropped", "failing"), [("--unshare-net", "network"), ("--remount-ro", "write")])
def test_a_sandbox_that_does_not_protect_is_refused(base, bwrap, monkeypatch, dropped, failing):
    monkeypatch.setattr(bubblewrap, "_arguments", without(dropped))
    if dropped == "--remount-ro":  # the whole system, and nothing of it read-only
        monkeypatch.setattr(bubblewrap, "_arguments", lambda own: ["--unshare-pid", "--unshare-ipc", "--unshare-uts",
                                                                   "--unshare-net", "--bind", "/", "/"])  # fmt: skip
        monkeypatch.setattr(bubblewrap.Sandbox, "enter", lambda sandbox: None)
    with pytest.raises(
        SandboxError, match=rf"does not protect on this system; not so: .*{ATTEMPTS[failing]}.*--unprotected"
    ):
        try_out(bwrap, base)


def test_reports_arrive_whatever_number_their_pipe_has(base, monkeypatch):
    spare = [os.dup(1)]
    while spare[-1] < 20:  # the pipes get numbers among which that of the reports is drawn
        spare.append(os.dup(1))
    for drawn in range(0, 15, 3):
        monkeypatch.setattr(keeper.secrets, "randbelow", lambda _, drawn=drawn: drawn)
        ended = kept(lambda send, own: send({"arrived": True}), "", base)
        assert (ended["lines"], ended["code"], ended["foreign"]) == (['{"arrived": true}'], 0, False)
    for each in spare:
        os.close(each)


@linux
def test_a_bubblewrap_that_does_not_work_is_said_with_its_reason(base, tmp_path):
    program = tmp_path / "bwrap"
    program.write_text(
        "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n", encoding="utf-8"
    )
    program.chmod(0o755)
    with pytest.raises(SandboxError, match=r"does not work on this system: bwrap: No permissions .*--unprotected"):
        try_out(str(program), base)
    assert os.listdir(base) == []


def test_a_bubblewrap_that_is_not_installed_is_asked_for(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SandboxError, match=r"there is no program 'bwrap' .*apt install bubblewrap.*--unprotected"):
        find_bubblewrap()
    (tmp_path / "bwrap").touch(mode=0o755)
    assert find_bubblewrap() == str(tmp_path / "bwrap")


@linux
@pytest.mark.parametrize("protected", [False, True])
def test_a_process_that_left_its_group_is_ended_with_its_run(base, protected, request):
    program = request.getfixturevalue("bwrap") if protected else ""

    def leave(send, own):
        _rename(name)
        if not os.fork():
            os.setsid()
            if not os.fork():
                time.sleep(60)
            os._exit(0)
        time.sleep(0.1)

    name = f"left-{os.getpid()}"
    ended = kept(leave, program, base)
    assert (ended["why"], ended["code"]) == ("", 0)  # else it had been waited for until the time was up
    assert _alive(name) == [] and os.listdir(base) == []


@linux
def test_a_process_that_is_left_is_found_by_its_name():
    name, child = f"kept-{os.getpid()}", os.fork()
    if child == 0:
        _rename(name)
        time.sleep(60)
        os._exit(0)
    try:
        until = time.monotonic() + 10
        while not _alive(name) and time.monotonic() < until:
            time.sleep(0.01)
        assert _alive(name) == [str(child)]
    finally:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    assert _alive(name) == []


def _rename(name: str) -> None:
    """Name this process, and all that it forks, as no process of a test beside it is."""
    ctypes.CDLL(None).prctl(15, name.encode())  # PR_SET_NAME: up to 15 characters


def _alive(name: str) -> list[str]:
    """Return the processes of a name that run or wait."""
    found = []
    for process in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            called, state = Path("/proc", process, "stat").read_text(errors="replace").split("(", 1)[1].rsplit(") ", 1)
            if called == name and state[0] not in "ZX":
                found.append(process)
    return found


def test_the_folder_of_a_run_is_removed_whatever_is_in_it(tmp_path):
    own = tmp_path / "own"
    place = own
    for _ in range(200):
        place = place / "deep"
        place.mkdir(parents=True)
    (place / "file").touch()
    (own / "closed").mkdir(mode=0o000)
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside" / "precious").touch()
    (own / "link").symlink_to(tmp_path / "outside")
    assert 0 < size_of(str(own)) < float("inf")
    remove(str(own))
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["outside", "precious"]


def test_the_class_may_not_lie_where_every_submission_reads(tmp_path):
    assert lies_in_readable(tmp_path) is None
    place = readable_places()[0]
    assert lies_in_readable(place / "class") is not None
