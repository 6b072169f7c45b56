"""A Dask cluster for the tests: a scheduler and its workers in processes of their own, that speak TLS to each other and to us."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROLES = ("scheduler", "worker", "client")
SECONDS = 60


@dataclass(frozen=True)
class Running:
    """The cluster: its scheduler's address and process, and the processes of its workers."""

    address: str
    scheduler: subprocess.Popen[bytes]
    workers: tuple[subprocess.Popen[bytes], ...]


@contextmanager
def run_cluster(folder: Path, workers: int = 2) -> Iterator[Running]:
    """Run a cluster of so many workers of one thread each, with the settings of this process that reach it."""
    import dask
    import distributed  # noqa: F401 - its settings come with it, and would be lost with ours

    settings = write_certificate(folder)
    place = ["--host", "tls://127.0.0.1", "--no-dashboard", "--scheduler-file", str(folder / "scheduler.json")]
    own = ["--no-nanny", "--nthreads", "1", "--memory-limit", "0", "--local-directory"]
    with (
        ExitStack() as ending,
        dask.config.set({f"distributed.comm.tls.{name}": value for name, value in settings.items()}),
    ):

        def begin(what: str, *arguments: str) -> subprocess.Popen[bytes]:
            process = ending.enter_context(start(what, *place, *arguments, folder=folder, settings=settings))
            ending.callback(process.kill)
            return process

        scheduler = begin("scheduler", "--port", "0")
        some = tuple(begin("worker", *own, str(folder / f"{number}")) for number in range(workers))
        yield Running(address_in(folder / "scheduler.json"), scheduler, some)


def write_certificate(folder: Path) -> dict[str, str]:
    """Write a certificate of an hour that everybody shows and trusts; returns Dask's settings of it."""
    key, certificate = str(folder / "key.pem"), str(folder / "certificate.pem")
    kind = ["-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-subj", "/CN=armproof"]
    subprocess.run(
        ["openssl", "req", "-x509", *kind, "-days", "1", "-keyout", key, "-out", certificate],
        check=True,
        capture_output=True,
    )
    own = {f"{role}.{name}": path for role in ROLES for name, path in (("key", key), ("cert", certificate))}
    return {"ca-file": certificate, **own}


def start(what: str, *arguments: str, folder: Path, settings: dict[str, str]) -> subprocess.Popen[bytes]:
    """Start a scheduler or a worker; what it says stands in a file."""
    variables = {f"DASK_DISTRIBUTED__COMM__TLS__{name.upper().replace('.', '__').replace('-', '_')}": value
                 for name, value in settings.items()}  # fmt: skip
    with (folder / f"{what}.log").open("ab") as log:
        return subprocess.Popen(
            [sys.executable, "-m", "dask", what, *arguments],
            env=os.environ | variables,
            cwd=ROOT,
            stdout=log,
            stderr=log,
        )


def address_in(file: Path) -> str:
    """Return the address that a scheduler writes when it is there."""
    until = time.monotonic() + SECONDS
    while time.monotonic() < until:
        if file.exists() and (text := file.read_text(encoding="utf-8")).endswith("}"):
            return str(json.loads(text)["address"])
        time.sleep(0.02)
    raise TimeoutError(f"no scheduler has written {file}")
