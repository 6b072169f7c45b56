"""Run a lesson's notebook from top to bottom in a kernel of its own, and read what became of its tasks."""

from __future__ import annotations

import json
import os
import re
import sys
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from subprocess import DEVNULL
from typing import Any

from armproof.course.errors import AuthoringError
from armproof.course.sources.editions import as_bytes, as_notebook
from armproof.course.sources.places import COURSE, Place
from armproof.verification.document.cells import Cell

NEEDED = ("nbclient", "nbformat", "ipykernel")
SECONDS_A_CELL = 60
_REPORT = "print(__import__('json').dumps({k: v.as_json() for k, v in lesson.results().items()}, default=str))"
_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
_AT_LINE = re.compile(r"Cell In\[\d+\], line (\d+)")


@dataclass(frozen=True)
class Fault:
    """Where a notebook stopped: the cell (from 0), the line in it (from 1) if known, and what was raised."""

    cell: int
    line: int | None
    message: str


@dataclass(frozen=True)
class Run:
    """What became of a notebook: seconds from the start of its kernel, results as JSON by task, the fault if any.

    `outputs` are those of each cell, as a notebook holds them.
    """

    seconds: float
    results: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    fault: Fault | None = None
    outputs: tuple[tuple[Mapping[str, Any], ...], ...] = ()


def require_jupyter() -> None:
    """Raise AuthoringError where what runs notebooks is not installed."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        raise AuthoringError("{missing}: not installed; lessons run with: pip install 'armproof[lab]'", missing=list(missing))  # fmt: skip


def run_cells(name: str, cells: list[Cell], place: Place = COURSE, settings: Mapping[str, str] | None = None) -> Run:
    """Run cells in a kernel, in an empty folder and with an empty record of progress.

    Args:
        name: of the lesson.
        cells: its cells; one of them gives `lesson` its value.
        place: where the lesson is. The folder has what stands beside the notebooks of a teacher's own.
        settings: environment variables of the kernel beside its own.
    """
    import nbformat
    from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

    data = as_bytes(as_notebook(name, [*cells, Cell("code", _REPORT)]))
    notebook = nbformat.reads(data, as_version=4)  # type: ignore[no-untyped-call]
    started = time.perf_counter()
    with tempfile.TemporaryDirectory(prefix="armproof-", ignore_cleanup_errors=True) as folder:
        home = _home(Path(folder), place)
        client = _client(notebook, home, Path(folder))
        fault = None
        try:
            client.execute(
                cleanup_kc=True, env={**_environment(Path(folder)), **(settings or {})}, stdout=DEVNULL, stderr=DEVNULL
            )
        except CellExecutionError as error:
            fault = _fault_of(notebook, f"{error.ename}: {error.evalue}")
        except CellTimeoutError:
            fault = _unfinished(notebook, f"still running after {SECONDS_A_CELL} s")
        except DeadKernelError:
            fault = _unfinished(notebook, "the kernel died")
    seconds = time.perf_counter() - started
    outputs = tuple(tuple(dict(output) for output in cell.get("outputs", ())) for cell in notebook.cells[:-1])
    return Run(seconds, {} if fault else _results(notebook), fault or _traceback_shown(notebook), outputs)


def _home(folder: Path, place: Place) -> Path:
    """Return an empty folder for the notebook, beside which `../tasks` is what it is in a teacher's folder."""
    home = folder / place.notebooks.name
    home.mkdir()
    if not place.is_course:
        for beside in place.root.iterdir():
            if beside.name != home.name:
                (folder / beside.name).symlink_to(beside.resolve())
    return home


def _client(notebook: Any, home: Path, folder: Path) -> Any:
    from jupyter_client.kernelspec import KernelSpec
    from jupyter_client.manager import AsyncKernelManager
    from nbclient import NotebookClient

    # Sockets in the folder instead of ports: nothing listens on the network.
    manager = AsyncKernelManager(
        transport="ipc", ip=str(folder / "socket"), connection_file=str(folder / "kernel.json")
    )
    # This Python's own kernel, whatever else is installed under the name python3.
    command = [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    manager._kernel_spec = KernelSpec(argv=command, display_name="Python 3", language="python")
    resources = {"metadata": {"path": str(home)}}
    # Nothing of a kernel is wanted after its last cell: asked politely, it would take most of a second to end.
    return NotebookClient(
        notebook, km=manager, timeout=SECONDS_A_CELL, shutdown_kernel="immediate", resources=resources
    )


def _environment(folder: Path) -> dict[str, str]:
    """Return the environment of a kernel: nothing of the user's is read, nothing is left behind."""
    from armproof.course.feedback.progress import VARIABLE

    environment = {name: value for name, value in os.environ.items() if name not in ("MPLBACKEND", "PYTHONSTARTUP")}
    paths = [str(COURSE.root.parent), environment.get("PYTHONPATH", "")]
    environment["PYTHONPATH"] = os.pathsep.join(path for path in paths if path)
    environment["IPYTHONDIR"] = str(folder / ".ipython")
    environment[VARIABLE] = str(folder / ".progress.json")
    return environment


def _fault_of(notebook: Any, message: str) -> Fault:
    """Return where a cell raised: the line of the cell itself, where the traceback names one."""
    for index, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", ()):
            if output.output_type == "error":
                text = _COLOURS.sub("", "\n".join(output.traceback))
                lines = [int(number) for number in _AT_LINE.findall(text)]
                return Fault(index, lines[0] if lines else None, message)
    return _unfinished(notebook, message)


def _unfinished(notebook: Any, message: str) -> Fault:
    """Return the fault of the first cell that has not ended."""
    code = [index for index, cell in enumerate(notebook.cells) if cell.cell_type == "code"]
    begun = [index for index in code if "iopub.execute_input" in notebook.cells[index].metadata.get("execution", {})]
    return Fault(begun[-1] if begun else code[0], None, message)


def _traceback_shown(notebook: Any) -> Fault | None:
    """Return the cell whose output shows a traceback that nobody raised."""
    for index, cell in enumerate(notebook.cells[:-1]):
        for output in cell.get("outputs", ()):
            if "Traceback (most recent call last)" in str(output.get("text", "")):
                return Fault(index, None, "its output shows a traceback")
    return None


def _results(notebook: Any) -> Mapping[str, Mapping[str, Any]]:
    outputs = notebook.cells[-1].outputs
    text = "".join(output.text for output in outputs if output.get("name") == "stdout")
    found: Mapping[str, Mapping[str, Any]] = json.loads(text.strip().rpartition("\n")[2] or "{}")
    return found
