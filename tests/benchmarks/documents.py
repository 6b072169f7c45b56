"""How long documents take: the course in a cold process, each handout, a synthetic document of growing length."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.check import verify
from armproof.verification.latex import reader
from armproof.verification.verdict import Role, Verdict

ROOT = Path(__file__).resolve().parents[2]
HANDOUTS = ROOT / "course" / "handouts"
POLL = 0.02  # seconds between two looks at the memory


@dataclass(frozen=True)
class ColdRun:
    """Wall-clock seconds of a command; its memory in bytes: the largest process, and all together (shared pages once)."""

    seconds: float
    largest: int
    together: int
    code: int


def run_cold() -> ColdRun:
    """Run `armproof verify course/handouts` and watch its processes."""
    beside = Path(sys.executable).with_name("armproof")
    command = [str(beside) if beside.exists() else shutil.which("armproof") or "armproof", "verify", str(HANDOUTS)]
    started = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT)
    largest = together = 0
    while process.poll() is None:
        memory = [_memory(pid) for pid in _family(process.pid)]
        largest = max([largest, *(resident for resident, _ in memory)])
        together = max(together, sum(share for _, share in memory))
        time.sleep(POLL)
    return ColdRun(time.perf_counter() - started, largest, together, process.returncode)


def run_unwatched() -> float:
    """Return the wall-clock seconds of the same command, with nobody looking at its memory."""
    beside = Path(sys.executable).with_name("armproof")
    command = [str(beside) if beside.exists() else "armproof", "verify", str(HANDOUTS)]
    started = time.perf_counter()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT, check=False)
    return time.perf_counter() - started


def _family(pid: int) -> list[int]:
    """Return a process and all below it."""
    try:
        tasks = list(Path(f"/proc/{pid}/task").iterdir())
        children = [int(child) for task in tasks for child in (task / "children").read_text().split()]
    except OSError:
        return [pid]
    return [pid, *(below for child in children for below in _family(child))]


def _memory(pid: int) -> tuple[int, int]:
    """Return the resident and the proportional set size of a process, in bytes."""
    try:
        lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0, 0
    sizes = {line.split(":")[0]: int(line.split()[1]) * 1024 for line in lines[1:] if ":" in line}
    return sizes.get("Rss", 0), sizes.get("Pss", 0)


@dataclass(frozen=True)
class HandoutTime:
    """How long one handout takes in a warm process."""

    name: str
    displays: int
    seconds: float


def time_handouts() -> list[HandoutTime]:
    """Check each handout once to warm up and once by the clock."""
    found = []
    for path in sorted(HANDOUTS.glob("*.md")):
        if "$$" in path.read_text(encoding="utf-8"):
            verify(path)
            reader._known_readings.cache_clear()  # warm is what documents share, not what this one says
            started = time.perf_counter()
            result = verify(path)
            found.append(HandoutTime(path.name, len(result.equations), time.perf_counter() - started))
    return found


SYNTHETIC = (
    r"{{}}^0T_{j} = \begin{{bmatrix}} C_{{{angles}}} & -S_{{{angles}}} & 0 & {x} \\ S_{{{angles}}} & C_{{{angles}}} & 0 & {y} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}",
    r"\frac{{\partial}}{{\partial \theta_1}} ({y}) = {x}",
    r"\frac{{\partial}}{{\partial \theta_1}} ({x}) = -({y})",
    r"\sin(\theta_1 + \theta_2 + {k}\theta_3) = S_{{12}} \cos({k}\theta_3) + C_{{12}} \sin({k}\theta_3)",
    r"({x})^2 + ({y})^2 = ({x})^2 + ({y})^2 + {k} - {k}",
)
REACH = (("1", "l_1 C_1", "l_1 S_1"), ("12", "l_1 C_1 + l_2 C_{12}", "l_1 S_1 + l_2 S_{12}"),
         ("123", "l_1 C_1 + l_2 C_{12} + l_3 C_{123}", "l_1 S_1 + l_2 S_{12} + l_3 S_{123}"))  # fmt: skip


def synthetic(displays: int, first: int = 2) -> str:
    """Return a document of so many displays about the planar 3R, all of them true; their numbers are seven from `first` on."""
    lines = ["---", "title: Synthetic", "arm: planar_3r", "---", ""]
    for index in range(displays):
        angles, x, y = REACH[index % 3]
        form = SYNTHETIC[index % len(SYNTHETIC)]
        lines += [f"$$ {form.format(j=len(angles), angles=angles, x=x, y=y, k=index % 7 + first)} $$", ""]
    return "\n".join(lines)


def time_synthetic(displays: int) -> float:
    """Return the seconds for a synthetic document of so many displays."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "synthetic.md"
        path.write_text(synthetic(displays), encoding="utf-8")
        started = time.perf_counter()
        result = verify(path)
        seconds = time.perf_counter() - started
    bad = [
        record
        for record in result.equations
        if record.verdict is not Verdict.PROVED  # a coordinate that no later display uses is unchecked
        and any(each.role is not Role.DEFINITION for each in record.outcomes)
    ]
    if bad or len(result.equations) != displays:
        raise SystemExit(f"the synthetic document is not true: {bad[:1]}")
    return seconds
