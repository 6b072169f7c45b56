"""Work shared out to the workers of a Dask cluster, as `processes` shares it out to processes of this machine.

Encryption is Dask's own: with its settings distributed.comm.tls (or the variables DASK_DISTRIBUTED__COMM__TLS__…) an address
tls:// is reached, and each side shows its certificate to the other.
"""

from __future__ import annotations

import logging
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from ipaddress import ip_address
from typing import TYPE_CHECKING, Any, TypeVar

from armproof.verification.errors import ClusterError
from armproof.verification.patterns import regex
from armproof.verification.running import on_worker
from armproof.verification.running.versions import versions

if TYPE_CHECKING:
    from distributed import Client, Future

AHEAD = 3  # tasks a thread of the workers that are sent before their results are taken
CONNECTING = 5.0  # s
PATIENCE = 60.0  # s without any worker
LOOK = 2.0  # s between two looks at whether anybody works
_ADDRESS = regex(r"(?:(?:tcp|tls)://)?(?:[\w.-]+|\[[0-9a-fA-F:.]+\]):\d{1,5}")
_CERTIFICATES = ("CA_FILE", "CLIENT__CERT", "CLIENT__KEY")
Task = TypeVar("Task")
Result = TypeVar("Result")


def is_private(address: str) -> bool:
    """Whether nobody else can read what is sent to an address: it is encrypted, or does not leave this machine."""
    scheme, _, place = address.rpartition("://")
    host = place.rpartition(":")[0].strip("[]")
    if scheme == "tls" or host == "localhost":
        return True
    with suppress(ValueError):
        return ip_address(host).is_loopback
    return False


class TaskEnded(Exception):
    """A task ended every worker that it was given to."""


class Cluster:
    """A context in which the workers of a scheduler take tasks, from as many threads of this process as one likes.

    Attributes:
        address: the scheduler's.
        threads: how many tasks its workers do at once.
    """

    def __init__(self, address: str, *, private: bool = False) -> None:
        """Take the address of a scheduler.

        Args:
            address: as Dask writes it, tcp://host:8786 or tls://host:8786.
            private: whether what is sent may be read by nobody else.

        Raises:
            ClusterError: it is to be private and the address is not.
        """
        self.address, self._private = address, private
        self._seen = 0.0
        self.threads = 0
        self._refuse_public([address])
        self._versions = versions()

    def __enter__(self) -> Cluster:
        self._client = _connected(self.address)
        try:
            self._begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *problem: object) -> None:
        self.on_each(on_worker.dismiss)
        self._client.close(timeout=CONNECTING)

    def submit(self, work: Callable[..., Any], *arguments: Any) -> Future:
        """Send a task: a function that can be imported there, and values that can be pickled."""
        return self._client.submit(on_worker.guarded, self._versions, work, *arguments, pure=False)

    def result(self, future: Future) -> Any:
        """Return the result of a task, or raise what it raised. A task whose worker is lost is done by another.

        Raises:
            TaskEnded: each worker that did it was lost.
            ClusterError: the scheduler is lost, or all workers are.
        """
        from distributed import CancelledError, KilledWorker

        self._seen = time.monotonic()
        while True:
            try:
                return future.result(timeout=LOOK)
            except TimeoutError:
                self._look()
            except KilledWorker:
                raise TaskEnded from None
            except (CancelledError, OSError):
                if future.status == "error":  # the task's own
                    raise
                raise self._lost() from None

    def share_out(
        self, work: Callable[[Task], Result], tasks: Iterable[Task], ended: Callable[[Task], Result]
    ) -> Iterator[Result]:
        """Yield the result of each task in the order given; none is kept, and no more tasks are taken than are soon sent.

        Args:
            work: what is done with a task; it must be picklable.
            tasks: the tasks.
            ended: the result of a task that ended each worker that it was given to.
        """
        sent: deque[tuple[Task, Future]] = deque()
        for task in tasks:
            sent.append((task, self.submit(work, task)))
            if len(sent) >= AHEAD * self.threads:
                yield self._taken(*sent.popleft(), ended)
        while sent:
            yield self._taken(*sent.popleft(), ended)

    def workers(self) -> Mapping[str, int]:
        """Return the workers that there are now, and how many tasks each does at once."""
        found: dict[str, int] = self._client.nthreads()
        return found

    def on_each(self, work: Callable[..., Any], *arguments: Any) -> dict[str, Any]:
        """Return what a quick function, or a coroutine, returns or raises on each worker; of one that is lost, nothing."""
        try:
            found: dict[str, Any] = self._client.run(work, *arguments, on_error="return")
        except (OSError, ValueError):  # the scheduler is lost, and with it all workers
            return {}
        return {worker: each for worker, each in found.items() if not isinstance(each, OSError)}

    def _taken(self, task: Task, future: Future, ended: Callable[[Task], Result]) -> Result:
        try:
            found: Result = self.result(future)
            return found
        except TaskEnded:
            return ended(task)

    def _begin(self) -> None:
        """Refuse a cluster without workers, one that others can read along, and workers that might answer otherwise."""
        try:
            self._client.wait_for_workers(1, timeout=CONNECTING)
        except TimeoutError:
            raise self._without_workers() from None
        workers = self.workers()
        self._refuse_public([self._client.scheduler_info()["address"], *workers])
        for worker, there in self.on_each(versions).items():
            if not isinstance(there, dict):
                raise ClusterError("worker {worker} cannot run Armproof ({reason}); install it on all machines",
                    worker=worker, reason=f"{type(there).__name__}: {there}")  # fmt: skip
            on_worker.refuse_others(self._versions, there, worker)
        self.threads = sum(workers.values())

    def _refuse_public(self, addresses: Iterable[str]) -> None:
        if self._private and (public := [each for each in addresses if not is_private(each)]):
            raise ClusterError("{address}: students' work is sent only to an encrypted address (tls://) or within this machine",
                address=public[0])  # fmt: skip

    def _look(self) -> None:
        """Raise ClusterError where nobody will ever do what was sent."""
        if self._client.status != "running":
            raise self._lost()
        if time.monotonic() - self._seen < LOOK:  # another thread has looked
            return
        with suppress(OSError):
            if self.workers():
                self._seen = time.monotonic()
        if time.monotonic() - self._seen > PATIENCE:
            raise self._without_workers()

    def _lost(self) -> ClusterError:
        return ClusterError("the Dask scheduler at {address} does not answer any more", address=self.address)

    def _without_workers(self) -> ClusterError:
        return ClusterError("the Dask scheduler at {address} has no workers", address=self.address)


def _connected(address: str) -> Client:
    """Return a client of the scheduler; raises ClusterError where Dask is not installed or nobody answers."""
    try:
        from distributed import Client
    except ImportError:
        raise ClusterError("--scheduler needs Dask: pip install 'armproof[cluster]'") from None
    if not _ADDRESS.fullmatch(address):
        raise ClusterError("the address of a Dask scheduler is tcp://host:8786 or tls://host:8786, not {given}", given=address)  # fmt: skip
    if address.startswith("tls:"):
        _find_certificates()
    _silence()
    try:
        return Client(address, timeout=CONNECTING, set_as_default=False)
    except OSError as error:
        raise ClusterError("no Dask scheduler at {address}: {reason}", address=address, reason=str(error)) from None


def _find_certificates() -> None:
    """Refuse to go on without what an encrypted connection needs."""
    from distributed.security import Security

    try:
        found, reason = Security().get_connection_args("client").get("ssl_context"), ""
    except OSError as error:
        found, reason = None, f" ({error})"
    if not found:
        raise ClusterError("tls:// needs certificates{reason}: name them in {variables}, or in distributed.comm.tls of Dask's configuration",
            reason=reason, variables=[f"DASK_DISTRIBUTED__COMM__TLS__{name}" for name in _CERTIFICATES])  # fmt: skip


def _silence() -> None:
    """Let Dask log nothing: what matters is said by our errors."""
    for name in list(logging.root.manager.loggerDict):
        if name.partition(".")[0] == "distributed":
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
