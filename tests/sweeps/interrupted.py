"""Kill what writes at a random moment, a hundred times each: no file may ever be half-written.

    python -m tests.sweeps.interrupted [TIMES]

Three things are killed: a process that does nothing but write a large file again and again, `armproof correct --in-place`,
and `armproof verify --report`. After each kill the document is the old one or the corrected one, byte for byte, and the
report's folder holds a whole report or none.
"""

from __future__ import annotations

import random
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import armproof.course
from armproof.verification.running.corrected_copy import correct_text
from tests.sweeps.correct import copies

HANDOUT = Path(armproof.course.__path__[0]) / "handouts" / "spherical-wrist-001.md"
TIMES = 100
WRITE = """
import sys
from pathlib import Path
from armproof.verification.running.atomic import write_atomically
path = Path(sys.argv[1])
print("begun", flush=True)
while True:
    for letter in b"ab":
        write_atomically(path, bytes([letter]) * 3_000_000)
"""
COMMAND = [sys.executable, "-c", "from armproof.verification.cli import main; main()"]


def main(times: int) -> int:
    """Kill each of the three so many times; 0 if nothing was ever half-written."""
    rng = random.Random(2019)
    faults = 0
    for what in (write, correct, report):
        with tempfile.TemporaryDirectory() as folder:
            found, changed = what(Path(folder), times, rng)
        print(
            f"{what.__name__:8} killed {times} times: {found} half-written, {changed} kills after the change was made"
        )
        faults += found
    return 0 if not faults else 1


def write(folder: Path, times: int, rng: random.Random) -> tuple[int, int]:
    """Kill a process that writes one file after the other; return how often it was neither the old nor the new one."""
    path = folder / "page.md"
    path.write_bytes(b"a" * 3_000_000)
    faults = new = 0
    for _ in range(times):
        _killed([sys.executable, "-c", WRITE, str(path)], rng.uniform(0, 0.05), begun="begun")
        data = path.read_bytes()
        faults += len(data) != 3_000_000 or len(set(data)) != 1
        new += data[:1] == b"b"
        for left in folder.glob(".page.md.*.tmp"):  # nobody is left to take it away
            left.unlink()
    return faults, new


def correct(folder: Path, times: int, rng: random.Random) -> tuple[int, int]:
    """Kill `armproof correct --in-place`; the document is the one before or the one after."""
    _, before, _ = next(copies(HANDOUT))
    after = correct_text(HANDOUT, before).after
    path = folder / HANDOUT.name

    def begin() -> None:
        path.write_text(before, encoding="utf-8")

    def state() -> str:
        text = path.read_text(encoding="utf-8")
        return "new" if text == after else "old" if text == before else "broken"

    return _many([*COMMAND, "correct", "--in-place", str(path)], begin, state, times, rng)


def report(folder: Path, times: int, rng: random.Random) -> tuple[int, int]:
    """Kill `armproof verify --report`; the folder holds every page that its index names, or there is none."""
    out = folder / "report"
    page = folder / HANDOUT.name
    page.write_text(HANDOUT.read_text(encoding="utf-8"), encoding="utf-8")

    def state() -> str:
        if not out.exists():
            return "old"
        index = out / "index.html"
        pages = (
            re.findall(r'href="([^"#:]+\\.html)', index.read_text(encoding="utf-8"))
            if index.exists()
            else ["index.html"]
        )
        whole = all((out / name).exists() and "</html>" in (out / name).read_text(encoding="utf-8") for name in pages)
        return "new" if whole and index.exists() and "</html>" in index.read_text(encoding="utf-8") else "broken"

    return _many([*COMMAND, "verify", "--report", str(out), str(page)], lambda: None, state, times, rng)


def _many(
    command: list[str], begin: Callable[[], None], state: Callable[[], str], times: int, rng: random.Random
) -> tuple[int, int]:
    begin()
    started = time.perf_counter()
    subprocess.run(command, capture_output=True, check=False)
    length = time.perf_counter() - started
    faults = new = 0
    for _ in range(times):
        begin()
        # near the end, where it writes, half of the time
        _killed(command, rng.uniform(0, length) if rng.random() < 0.5 else rng.uniform(0.8, 1.4) * length)
        found = state()
        faults += found == "broken"
        new += found == "new"
    return faults, new


def _killed(command: list[str], after: float, begun: str = "") -> None:
    """Run a command and kill it some seconds after it began."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        if begun and process.stdout is not None:
            process.stdout.readline()
        try:
            process.wait(after)
        except subprocess.TimeoutExpired:
            process.kill()


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else TIMES))
