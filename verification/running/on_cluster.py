"""Many documents checked on the workers of a Dask cluster, with the results that `processes.check_each` gives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.models.language import asked, spoken
from armproof.verification.running.cluster import Cluster
from armproof.verification.running.on_worker import check_batch
from armproof.verification.running.parcels import NOT_THERE, Parcel, pack, result_of
from armproof.verification.running.processes import check_one, process_ended
from armproof.verification.running.servant import Servant, ServantEnded
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from armproof.verification.running.processes import After

MOST_AT_ONCE = 64  # documents a task: of the time that a scheduler takes for one, next to nothing is for what is in it
ROUNDS = 4  # a task holds one part in so many of what is left for each thread, so that all end together


def check_each_on(
    cluster: Cluster, paths: Sequence[Path], *, after: After | None = None, correct: bool = False
) -> Iterator[DocumentResult | Failure]:
    """Yield the result of each document in the order given, or why it could not be checked; none is kept.

    Args:
        cluster: where they are checked; what a worker cannot decide is checked here, one after the other.
        paths: the documents.
        after: called here with each document and its result.
        correct: whether to seek what mends each refuted display.
    """
    batches = list(share(paths, cluster.threads))
    work = partial(check_batch, correct, asked(), spoken())
    sent = ([pack(path) for path in batch] for batch in batches)
    with Servant() as here:
        for batch, found in zip(batches, cluster.share_out(work, sent, _none), strict=True):
            for path, data in zip(batch, found, strict=True):
                result = result_of(data) if data != NOT_THERE else _checked_here(here, path, correct)
                yield check_one(path, after, found=result) if isinstance(result, DocumentResult) else result


def share(paths: Sequence[Path], threads: int) -> Iterator[Sequence[Path]]:
    """Yield the documents in the portions that are sent: large ones first, single ones at the end."""
    begin = 0
    while begin < len(paths):
        size = (len(paths) - begin) // (ROUNDS * max(threads, 1))
        size = min(max(size, 1), MOST_AT_ONCE)
        yield paths[begin : begin + size]
        begin += size


def _none(parcels: Sequence[Parcel | None]) -> list[bytes]:
    return [NOT_THERE] * len(parcels)


def _checked_here(here: Servant, path: Path, correct: bool) -> DocumentResult | Failure:
    try:
        found: DocumentResult | Failure = here.ask(check_one, path, None, correct)
        return found
    except ServantEnded:
        return process_ended(path)
