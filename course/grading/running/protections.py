"""Which protections are in force: each is tried by a run that does what it is to prevent, to things that nobody needs."""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armproof.course.errors import SandboxError
from armproof.course.grading.running.keeper import Ended, Send, keep
from armproof.course.grading.sandbox.bubblewrap import WITHOUT, choose_user
from armproof.course.grading.sandbox.limits import Limits
from armproof.models.language import look_up, noted

ATTEMPTS = {
    "own": noted("has a folder of its own, and can write there"),
    "write": noted("cannot write, change or delete files of anybody else"),
    "read": noted("cannot read other submissions, the results, or the teacher's files"),
    "mode": noted("cannot change the mode of a file"),
    "signal": noted("cannot signal, stop or end a process that is not its own"),
    "network": noted("has no network"),
    "unix": noted("cannot reach services of this computer (Unix sockets)"),
    "processes": noted("has a limited number of processes"),
}
_SECONDS = 10.0


@dataclass(frozen=True)
class Protection:
    """A protection in words, and whether a trial showed it in force."""

    text: str
    held: bool


def describe(held: Mapping[str, bool]) -> list[Protection]:
    """Return every protection in words."""
    return [Protection(look_up(text), held.get(name, False)) for name, text in ATTEMPTS.items()]


def try_out(bubblewrap: str, base: str) -> dict[str, bool]:
    """Return which of the attempts a run cannot do.

    Args:
        bubblewrap: the program; "" for a run without a sandbox, of which nothing is demanded.
        base: a folder for the folders of runs.

    Raises:
        SandboxError: bubblewrap makes no sandbox here, or one that does not prevent everything.
    """
    ended, reached = _try(bubblewrap, base)
    tried = json.loads(ended.lines[0]) if ended.lines else {}
    held = {name: bool(tried.get(name)) and name not in reached for name in ATTEMPTS}
    if bubblewrap and not tried:
        raise SandboxError("grading needs bubblewrap, which does not work on this system: {reason}; {without}",
            reason=ended.output.strip(), without=WITHOUT)  # fmt: skip
    if bubblewrap and not all(held.values()):
        failing = "; ".join(text for name, text in ATTEMPTS.items() if not held[name])
        raise SandboxError("bubblewrap does not protect on this system; not so: a submission {failing}; {without}",
            failing=failing, without=WITHOUT)  # fmt: skip
    return held


def _try(bubblewrap: str, base: str) -> tuple[Ended, set[str]]:
    """Return what became of the attempts, and which of them left a trace, whatever the run says."""
    with _canaries(base) as canaries, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp:
        udp.bind(("127.0.0.1", canaries["port"]))
        udp.setblocking(False)
        process = os.fork()
        if process == 0:
            _be_the_keeper(bubblewrap, base, canaries)
        os.waitpid(process, 0)
        ended = Ended(**json.loads(Path(canaries["answer"]).read_text(encoding="utf-8")))
        reached = set() if Path(canaries["file"]).read_text(encoding="utf-8") == "untouched" else {"write"}
        with contextlib.suppress(BlockingIOError):
            udp.recv(1)
            reached.add("network")
        return ended, reached


def _be_the_keeper(bubblewrap: str, base: str, canaries: dict[str, Any]) -> None:
    def run(send: Send, own: Path) -> None:
        send(_attempt(canaries, own))

    try:
        try:
            ended = keep(run, bubblewrap, Limits(seconds=_SECONDS), base, choose_user(255))
        except OSError as problem:
            ended = Ended("sandbox", output=str(problem))
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
            udp.sendto(b"x", ("127.0.0.1", canaries["port"]))

    def connect_unix() -> None:
        with socket.socket(socket.AF_UNIX) as unix:
            unix.connect(canaries["unix"])

    def write_own() -> None:
        (own / "file").write_text("own", encoding="utf-8")
        (own / "file").unlink()

    fails(send_udp)  # whether it arrived, the other side knows
    return {
        "own": not fails(write_own),
        "write": fails(write),
        "read": fails(lambda: Path(canaries["file"]).read_text(encoding="utf-8")),
        "mode": fails(os.chmod, canaries["file"], 0o644),
        "signal": fails(os.kill, canaries["process"], 0),
        "network": fails(socket.create_connection, ("127.0.0.1", canaries["port"]), 1.0),
        "unix": fails(connect_unix),
        "processes": resource.getrlimit(resource.RLIMIT_NPROC)[0] != resource.RLIM_INFINITY and os.geteuid() != 0,
    }
