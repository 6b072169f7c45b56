"""The sandbox without a server: what each plan prevents, tried on things that nobody needs."""

import json
import os
import socket
import struct
import sys
import tempfile
import time
from dataclasses import replace

import pytest

from armproof.course.grading.keeper import keep
from armproof.course.grading.limits import Limits
from armproof.course.grading.own_folder import remove, size_of
from armproof.course.grading.protections import ATTEMPTS, describe, make_plan, try_plan
from armproof.course.grading.sandbox.landlock import landlock_version
from armproof.course.grading.sandbox.places import lies_in_readable, readable_places
from armproof.course.grading.sandbox.plan import Plan
from armproof.course.grading.sandbox.seccomp import program

linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux")


@pytest.fixture
def base():
    with tempfile.TemporaryDirectory() as folder:  # not pytest's, which is closed to other users
        os.chmod(folder, 0o711)
        yield folder


def kept(run, plan: Plan, base: str, limits: Limits = Limits(seconds=10)) -> dict[str, object]:  # noqa: B008 - frozen
    """Keep a run in a process of its own: a keeper ends all that descends from it."""
    ours, theirs = socket.socketpair()
    child = os.fork()
    if child == 0:
        try:
            theirs.sendall(json.dumps(keep(run, plan, limits, base, None).__dict__).encode())
        finally:
            os._exit(0)
    theirs.close()
    with ours.makefile("rb") as answer:
        found = json.loads(answer.read())
    os.waitpid(child, 0)
    ours.close()
    return found


def test_the_strongest_plan_that_works_is_taken(base):
    plan, held = make_plan(base)
    assert held["own"] and set(held) == set(ATTEMPTS)
    assert plan.files == (landlock_version() > 0)
    assert not plan.files or (
        held["write"] and held["read"] and held["signal"] == (landlock_version() >= 6 or plan.namespaces)
    )
    assert os.listdir(base) == []


def test_without_a_sandbox_nothing_is_claimed(base):
    held = try_plan(Plan(), base)
    assert held["own"] and not any(held[name] for name in ("write", "read", "mode", "signal", "network", "unix"))
    assert [each.held for each in describe({})] == [False] * len(ATTEMPTS)


def test_a_run_is_refused_where_a_protection_cannot_be_had_again(base, monkeypatch):
    monkeypatch.setattr("armproof.course.grading.sandbox.plan.restrict_files", lambda *_: False)
    ended = kept(lambda send, own: send({"ran": True}), Plan(files=True), base)
    assert ended["lines"] == [] and ended["code"] == 1 and "the sandbox is incomplete: files" in str(ended["output"])
    assert kept(lambda send, own: send({"ran": True}), Plan(), base)["lines"] == ['{"ran": true}']


@linux
@pytest.mark.parametrize("namespaces", [False, True])
def test_a_process_that_left_its_group_is_ended_with_its_run(base, namespaces):
    strongest, _ = make_plan(base)
    if namespaces and not strongest.namespaces:
        pytest.skip("this system gives no namespaces")
    plan = Plan(namespaces=namespaces)

    def leave(send, own):
        if not os.fork():
            os.setsid()
            if not os.fork():
                time.sleep(60)
            os._exit(0)
        time.sleep(0.1)

    before = set(os.listdir("/proc"))
    ended = kept(leave, plan, base)
    assert ended["why"] == ""  # else it had been waited for until the time was up
    children = [name for name in set(os.listdir("/proc")) - before if name.isdigit() and _waits(name)]
    assert children == [] and os.listdir(base) == []


def _waits(process: str) -> bool:
    """Whether a process is a copy of this one that is still there."""
    try:
        with open(f"/proc/{process}/cmdline", "rb") as theirs, open("/proc/self/cmdline", "rb") as ours:
            return theirs.read() == ours.read()
    except OSError:
        return False


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


def test_the_filter_sends_each_call_to_its_answer():
    for machine in ("x86_64", "aarch64"):
        steps = [
            struct.unpack("=HBBI", program(machine)[start : start + 8]) for start in range(0, len(program(machine)), 8)
        ]
        socket_call, read_call = {"x86_64": (41, 0), "aarch64": (198, 63)}[machine]
        architecture = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}[machine]
        prlimit = {"x86_64": 302, "aarch64": 261}[machine]
        refused, allowed = 0x00050001, 0x7FFF0000
        assert _answer(steps, architecture, socket_call, 0) == refused
        assert _answer(steps, architecture, read_call, 0) == allowed
        assert _answer(steps, architecture, prlimit, 0) == allowed
        assert _answer(steps, architecture, prlimit, 17) == refused
        assert _answer(steps, architecture, 0x40000000, 0) == refused
        assert _answer(steps, 0x40000003, read_call, 0) == 0x80000000


def _answer(steps: list[tuple[int, int, int, int]], architecture: int, number: int, argument: int) -> int:
    """Run a filter as the kernel does."""
    loaded, place = 0, 0
    while True:
        code, if_so, if_not, value = steps[place]
        place += 1
        if code == 0x20:
            loaded = {4: architecture, 0: number, 16: argument}[value]
        elif code == 0x06:
            return value
        else:
            place += if_so if (loaded == value if code == 0x15 else loaded >= value) else if_not


def test_the_class_may_not_lie_where_every_submission_reads(tmp_path):
    assert lies_in_readable(tmp_path) is None
    place = readable_places()[0]
    assert lies_in_readable(place / "class") == place


def test_the_plan_of_another_user_changes_nothing_else():
    assert replace(Plan(), user=True).readable == Plan().readable
