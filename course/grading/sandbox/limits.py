"""What one submission may use."""

from __future__ import annotations

from dataclasses import asdict, dataclass

MEGABYTE = 1 << 20
LIBRARIES = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMEXPR")} | {
    "MPLBACKEND": "agg",
    "ARMPROOF_PROGRESS": "",
}  # environment variables: one thread, no window


@dataclass(frozen=True)
class Limits:
    """The limits of one submission's run.

    Attributes:
        seconds: of wall clock; the processor's time is limited to a little more.
        memory: bytes, beyond what the libraries take.
        output: bytes of what is printed that are kept; the run is ended at `flood` bytes.
        disk: bytes of files in the run's own folder; one file may take a quarter of it.
        processes: processes and threads.
        files: open files.
        results: bytes that the run may report.
    """

    seconds: float = 60.0
    memory: int = 1024 * MEGABYTE
    output: int = 200_000
    flood: int = 20_000_000
    disk: int = 200 * MEGABYTE
    processes: int = 32
    files: int = 64
    results: int = 2_000_000

    def as_json(self) -> dict[str, float]:
        """Return the limits as JSON writes them."""
        return asdict(self)
