"""Which protections are in force: each is tried by a run that does what it is to prevent, to things that nobody needs."""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from armproof.course.grading.keeper import Ended, keep
from armproof.course.grading.limits import Limits
from armproof.course.grading.sandbox.landlock import landlock_version
from armproof.course.grading.sandbox.places import readable_places
from armproof.course.grading.sandbox.plan import Plan
from armproof.course.grading.sandbox.privileges import choose_user, is_readable_by
from armproof.course.grading.sandbox.resources import count_threads

ATTEMPTS = {
    "own": "has a folder of its own, and can write there",
    "write": "cannot write, change or delete files of anybody else",
    "read": "cannot read other submissions, the results, or the teacher's files",
    "mode": "cannot change the mode of a file",
    "signal": "cannot signal, stop or end a process that is not its own",
    "network": "has no network",
    "unix": "cannot reach services of this computer (Unix sockets)",
    "processes": "has a limited number of processes",
}
_SECONDS = 10.0


@dataclass(frozen=True)
class Protection:
    """A protection in words, and whether a trial showed it in force."""

    text: str
    held: bool


def describe(held: Mapping[str, bool]) -> list[Protection]:
    """Return every protection in words."""
    return [Protection(text, held.get(name, False)) for name, text in ATTEMPTS.items()]


def make_plan(base: str) -> tuple[Plan, dict[str, bool]]:
    """Return the strongest plan under which a run works, and which of the attempts it prevents.

    Args:
        base: a folder for the folders of runs.
    """
    found = Plan(), dict.fromkeys(ATTEMPTS, False)
    for plan in _plans():
        held = try_plan(plan, base)
        if held["own"]:
            return plan, held
    return found


def _plans() -> Iterator[Plan]:
    readable = readable_places()
    others = count_threads(os.geteuid())
    as_root = os.geteuid() == 0
    files = landlock_version() > 0
    user = choose_user(0)
    bare = user is not None and files and not is_readable_by(user, [str(place) for place in readable[:8]])
    full = Plan(True, as_root, bare, files, True, readable, others)
    yield full
    yield replace(full, namespaces=False)
    yield replace(full, calls=False)
    yield replace(full, namespaces=False, calls=False)
    yield replace(full, namespaces=False, calls=False, files=False, keep_reading=False)
    yield replace(full, namespaces=False, calls=False, files=False, keep_reading=False, user=False)


def try_plan(plan: Plan, base: str) -> dict[str, bool]:
    """Return what a plan prevents; all False where a run does not work under it."""
    with _canaries(base) as canaries:
        process = os.fork()
        if process == 0:
            _be_the_keeper(plan, base, canaries)
        os.waitpid(process, 0)
        answer = canaries["answer"]
        try:
            ended = Ended(**json.loads(Path(answer).read_text(encoding="utf-8")))
            held = {name: bool(value) for name, value in json.loads(ended.lines[0]).items() if name in ATTEMPTS}
        except (OSError, ValueError, IndexError):
            return dict.fromkeys(ATTEMPTS, False)
        untouched = Path(canaries["file"]).read_text(encoding="utf-8") == "untouched"
        return {**dict.fromkeys(ATTEMPTS, False), **held, "write": held.get("write", False) and untouched}


def _be_the_keeper(plan: Plan, base: str, canaries: dict[str, Any]) -> None:
    try:
        ended = keep(
            lambda send, own: send(_attempt(canaries, own)), plan, Limits(seconds=_SECONDS), base, choose_user(255)
        )
        Path(canaries["answer"]).write_text(json.dumps(ended.__dict__), encoding="utf-8")
    finally:
        os._exit(0)


@contextlib.contextmanager
def _canaries(base: str) -> Iterator[dict[str, Any]]:
    """Put up what a run is to leave alone: a file, a listener of TCP and one of a Unix socket, and this process."""
    file, path = Path(base) / "canary", Path(base) / "canary.socket"
    answer = Path(base) / "canary.answer"
    file.write_text("untouched", encoding="utf-8")
    with socket.socket() as tcp, socket.socket(socket.AF_UNIX) as unix:
        tcp.bind(("127.0.0.1", 0))
        tcp.listen()
        unix.bind(str(path))
        unix.listen()
        try:
            yield {"file": str(file), "port": tcp.getsockname()[1], "unix": str(path), "process": os.getpid(),
                   "answer": str(answer)}  # fmt: skip
        finally:
            for each in (file, path, answer):
                each.unlink(missing_ok=True)


def _attempt(canaries: dict[str, Any], own: Path) -> dict[str, bool]:
    """Try each thing; whether it was prevented (of `own`: whether it works)."""
    import resource

    def fails(attempt: Any, *arguments: Any) -> bool:
        try:
            attempt(*arguments)
        except OSError:
            return True
        return False

    def write() -> None:
        with open(canaries["file"], "a", encoding="utf-8") as file:
            file.write("touched")

    def send_udp() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp:
            udp.sendto(b"", ("127.0.0.1", canaries["port"]))

    def connect_unix() -> None:
        with socket.socket(socket.AF_UNIX) as unix:
            unix.connect(canaries["unix"])

    def write_own() -> None:
        (own / "file").write_text("own", encoding="utf-8")
        (own / "file").unlink()

    return {
        "own": not fails(write_own),
        "write": fails(write),
        "read": fails(lambda: Path(canaries["file"]).read_text(encoding="utf-8")),
        "mode": fails(os.chmod, canaries["file"], 0o644),
        "signal": fails(os.kill, canaries["process"], 0),
        "network": fails(socket.create_connection, ("127.0.0.1", canaries["port"]), 1.0) and fails(send_udp),
        "unix": fails(connect_unix),
        "processes": resource.getrlimit(resource.RLIMIT_NPROC)[0] != resource.RLIM_INFINITY and os.geteuid() != 0,
    }
