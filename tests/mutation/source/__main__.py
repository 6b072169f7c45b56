"""Mutants of the trusted base against a fast selection of tests: `python -m tests.mutation.source [--sample N] [FILE…]`.

The trusted base is what can make a false equation pass. A mutant that no test kills is either harmless (the same verdicts,
a slower way) or a missing test. Exit code 1 if fewer are killed than wanted, 2 if the selection fails without a mutant.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from random import Random

from tests.mutation.source.mutants import Mutant, mutants_of
from tests.mutation.source.run import SURVIVED, UNCHANGED

ROOT = Path(__file__).resolve().parents[3]
TRUSTED = ["models/exact/*.py", "verification/algebra/*.py", "verification/evaluation/*.py", "verification/equations/alignment.py",
           "verification/equations/equality.py", "verification/equations/second_route.py"]  # fmt: skip
TESTS = ["tests/verification/test_soundness.py", "tests/verification/algebra", "tests/verification/evaluation",
         "tests/verification/equations", "tests/models/exact"]  # fmt: skip
WANTED, SECONDS = 0.95, 180


@dataclass(frozen=True)
class Fate:
    """What became of a mutant: killed, killed by the clock, or survived."""

    file: str
    mutant: Mutant
    fate: str


def main() -> int:
    """Print what survives and the share of each file that is killed; return the exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.mutation.source", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--sample", type=int, default=0, help="so many mutants, drawn at random; 0: all")
    parser.add_argument("--seed", type=int, default=2019)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes")
    parser.add_argument("--timeout", type=float, default=SECONDS, help="seconds for one mutant")
    parser.add_argument(
        "--tests", nargs="*", default=[t for t in TESTS if (ROOT / t).exists()], help="what pytest runs"
    )
    parser.add_argument("files", nargs="*", default=TRUSTED, help="files or patterns, from the project's folder")
    options = parser.parse_args()
    drawn = draw(options.files, options.sample, options.seed)
    if (
        not drawn
        or fate_of((drawn[0][0], Mutant(UNCHANGED, 0, "", "")), options.tests, options.timeout * 3).fate != "survived"
    ):
        print("no mutant, or the selection fails without one", file=sys.stderr)
        return 2
    started = time.perf_counter()
    with ThreadPoolExecutor(options.jobs) as pool:
        fates = list(pool.map(partial(fate_of, tests=options.tests, timeout=options.timeout), drawn))
    print(f"{time.perf_counter() - started:.0f} s")
    return report(fates)


def draw(patterns: list[str], sample: int, seed: int) -> list[tuple[str, Mutant]]:
    """Return the mutants of the files that are named, or a sample of them."""
    files = sorted({path for pattern in patterns for path in ROOT.glob(pattern)})
    found = [(str(path.relative_to(ROOT)), m) for path in files for m in mutants_of(path.read_text("utf-8"))]
    return Random(seed).sample(found, sample) if 0 < sample < len(found) else found


def fate_of(drawn: tuple[str, Mutant], tests: list[str], timeout: float) -> Fate:
    """Return what becomes of a mutant in a process of its own."""
    file, mutant = drawn
    command = [sys.executable, "-m", "tests.mutation.source.run", file, str(mutant.index), *tests]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        run = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return Fate(file, mutant, "timeout")
    return Fate(file, mutant, "survived" if run.returncode == SURVIVED else "killed")


def report(fates: list[Fate]) -> int:
    """Print the survivors, and the share that is killed by file and in all; return 1 where it is less than wanted."""
    for fate in fates:
        if fate.fate == "survived":
            print(
                f"{fate.file}:{fate.mutant.line}: {fate.mutant.kind} (mutant {fate.mutant.index}): {fate.mutant.words}"
            )
    print(f"\n{'file':50}{'mutants':>8}{'killed':>8}{'timeout':>9}{'survived':>10}")
    for file in sorted({fate.file for fate in fates}):
        counts = Counter(fate.fate for fate in fates if fate.file == file)
        print(f"{file:50}{counts.total():8}{counts['killed']:8}{counts['timeout']:9}{counts['survived']:10}")
    share = sum(fate.fate != "survived" for fate in fates) / len(fates)
    print(f"{len(fates)} mutants, {100 * share:.1f} % killed")
    return 0 if share >= WANTED else 1


if __name__ == "__main__":
    sys.exit(main())
