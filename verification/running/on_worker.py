"""What happens on a worker of a cluster: documents are checked in a process beside it, which ends with it.

A process of its own, because Drake may abort on a model, and because the worker answers its scheduler meanwhile.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from queue import Empty, SimpleQueue
from typing import Any

from armproof.models.language import speak
from armproof.verification.errors import ClusterError
from armproof.verification.running.parcels import NOT_THERE, Parcel, check_parcel
from armproof.verification.running.servant import Servant, ServantEnded
from armproof.verification.running.versions import versions

_idle: SimpleQueue[Servant] = SimpleQueue()  # one a thread of the worker at most


def guarded(expected: Mapping[str, str], work: Callable[..., Any], *arguments: Any) -> Any:
    """Return what a function returns, where this worker runs what the machine runs that asks.

    Raises:
        ClusterError: it does not, so that it might answer otherwise.
    """
    refuse_others(expected, versions())
    return work(*arguments)


def refuse_others(expected: Mapping[str, str], found: Mapping[str, str], worker: str = "") -> None:
    """Refuse a worker that runs anything else; raises ClusterError."""
    for name, value in expected.items():
        if found.get(name) != value:
            raise ClusterError("worker {worker}: {name} {found} there, {expected} here; install the same on all machines",
                worker=worker, name=name, found=found.get(name), expected=value)  # fmt: skip


def check_batch(correct: bool, asked: str, spoken: str, parcels: Sequence[Parcel | None]) -> list[bytes]:
    """Return the results of documents as they travel back; `NOT_THERE` for one that cannot be checked here.

    Args:
        correct: whether to seek what mends each refuted display.
        asked, spoken: the languages of the machine that asks.
        parcels: the documents; None stands for one that did not travel.
    """
    speak(asked, spoken)
    servant = _hire()
    try:
        return [_checked(servant, parcel, correct) if parcel else NOT_THERE for parcel in parcels]
    finally:
        _idle.put(servant)


def dismiss() -> None:
    """End the processes that wait for documents."""
    while not _idle.empty():
        _hire().end()


def _hire() -> Servant:
    try:
        return _idle.get_nowait()
    except Empty:
        return Servant()


def _checked(servant: Servant, parcel: Parcel, correct: bool) -> bytes:
    try:
        found: bytes = servant.ask(check_parcel, parcel, correct)
        return found
    except ServantEnded:
        return NOT_THERE
