"""The grading server: loads Drake and the course once, then forks a keeper for each submission.

It is a process of its own, with nothing of the class in its memory: a keeper reads its submission from the socket itself.
"""

from __future__ import annotations

import contextlib
import gc
import json
import os
import selectors
import signal
import socket
import sys
from collections.abc import Callable
from dataclasses import asdict
from typing import Any, NoReturn

from armproof.course.errors import GradingError
from armproof.course.grading.running.keeper import keep
from armproof.course.grading.running.own_folder import remove
from armproof.course.grading.running.protections import try_out
from armproof.course.grading.sandbox.bubblewrap import choose_user
from armproof.course.grading.sandbox.kernel import PR_SET_PDEATHSIG, prctl
from armproof.course.grading.sandbox.limits import Limits
from armproof.models.errors import ArmproofError

Results = Callable[[], list[dict[str, Any]]]


def main(base: str, bubblewrap: str, used: list[str], own: str, sockets: list[int]) -> None:
    """Serve the sockets until the other end closes them; each carries one submission at a time.

    Args:
        base: the folder for the folders of runs.
        bubblewrap: the program that makes their sandboxes; "" for none.
        used: the lessons that will be asked for.
        own: the folder of a teacher's own lessons, or nothing.
        sockets: their file descriptors.
    """
    prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    slots = [socket.socket(fileno=number) for number in sockets]
    try:
        held = try_out(bubblewrap, base)
        catalogue, results = _load(used, own, base)
    except (ArmproofError, OSError) as error:
        _tell(slots, {"error": str(error)})
        return
    gc.collect()
    gc.freeze()  # a collection in a child would copy every page that is shared with it
    _tell(slots, {"catalogue": catalogue, "held": held})
    server = _Server(base, slots, bubblewrap, results)
    signal.signal(signal.SIGTERM, _end)
    try:
        server.serve()
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        server.end_keepers()
        remove(base)  # the other side may be gone
        os._exit(0)


def _load(used: list[str], own: str, base: str) -> tuple[list[dict[str, Any]], Results]:
    from armproof.course.grading.running.checker import load_course, preload

    preload()
    try:
        return load_course(used, own, base)
    except (ArmproofError, OSError) as error:
        raise GradingError("the course cannot be loaded: {reason}", reason=str(error)) from None


def _tell(slots: list[socket.socket], message: dict[str, Any]) -> None:
    for slot in slots:
        slot.sendall(json.dumps(message).encode() + b"\n")


class _Server:
    """Forks a keeper for each slot that has something to read, and takes the slot back when the keeper has ended."""

    def __init__(self, base: str, slots: list[socket.socket], bubblewrap: str, results: Results) -> None:
        self._base, self._slots, self._bubblewrap, self._results = base, slots, bubblewrap, results
        self._busy: dict[int, int] = {}  # keeper: slot
        self._selector = selectors.DefaultSelector()
        self._wake = os.pipe()
        self._users = [choose_user(place) for place in range(len(slots))]

    def serve(self) -> None:
        """Serve until a slot is closed."""
        for end in self._wake:
            os.set_blocking(end, False)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        signal.set_wakeup_fd(self._wake[1], warn_on_full_buffer=False)
        self._selector.register(self._wake[0], selectors.EVENT_READ, None)
        for place, slot in enumerate(self._slots):
            self._selector.register(slot, selectors.EVENT_READ, place)
        while True:
            for key, _ in self._selector.select():
                if key.data is None:
                    self._take_back()
                elif not self._begin(key.data):
                    return

    def end_keepers(self) -> None:
        """Have every keeper end what it keeps, and wait for them."""
        for keeper in self._busy:
            with contextlib.suppress(ProcessLookupError):
                os.kill(keeper, signal.SIGTERM)
        for keeper in self._busy:
            with contextlib.suppress(ChildProcessError):
                os.waitpid(keeper, 0)

    def _begin(self, place: int) -> bool:
        """Fork the keeper of a slot; False if nothing will come any more."""
        slot = self._slots[place]
        if not slot.recv(1, socket.MSG_PEEK):
            return False
        self._selector.unregister(slot)
        keeper = os.fork()
        if keeper == 0:
            self._be_the_keeper(slot, self._users[place])
        self._busy[keeper] = place
        return True

    def _take_back(self) -> None:
        with contextlib.suppress(BlockingIOError):
            os.read(self._wake[0], 4096)
        for keeper in list(self._busy):
            if os.waitpid(keeper, os.WNOHANG)[0]:
                place = self._busy.pop(keeper)
                self._selector.register(self._slots[place], selectors.EVENT_READ, place)

    def _be_the_keeper(self, slot: socket.socket, user: int | None) -> NoReturn:
        """Be the keeper of one submission, and answer how it ended."""
        code = 1
        try:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            signal.signal(signal.SIGTERM, _end)
            prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
            answer = asdict(keep(*self._task(slot), self._base, user))
            slot.sendall(json.dumps(answer).encode() + b"\n")
            code = 0
        except SystemExit:
            pass
        except BaseException as problem:
            with contextlib.suppress(OSError):
                slot.sendall(json.dumps({"why": "sandbox", "output": f"{problem}"}).encode() + b"\n")
        finally:
            os._exit(code)

    def _task(self, slot: socket.socket) -> tuple[Any, str, Limits]:
        from armproof.course.grading.running.runner import run_cells

        with slot.makefile("rb") as file:
            task = json.loads(file.readline())
        results = self._results

        def run(send: Any, own: Any) -> None:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)
            run_cells(task["cells"], results, send)

        return run, self._bubblewrap, Limits(**task["limits"])


def _end(*_: Any) -> NoReturn:
    """End this process by way of its `finally` clauses, which a second signal does not interrupt."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3].split(), sys.argv[4], [int(number) for number in sys.argv[5:]])
