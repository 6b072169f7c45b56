"""Mutants of the trusted base against the tests that speak of it: `python -m tests.mutation.source [--sample N] [FILE…]`.

The trusted base is what can make a false equation pass. A mutant that no test kills is either harmless (the same verdicts,
a slower way) or a missing test. Exit code 1 if fewer are killed than wanted, 2 if the selection fails without a mutant.
"""

from __future__ import annotations

import argparse
import math
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from random import Random

from tests.mutation.source.mutants import Mutant, mutants_of
from tests.mutation.source.reach import record
from tests.mutation.source.run import KILLED, SURVIVED, UNCHANGED
from tests.mutation.source.trusted import ROOT, trusted_files

WANTED, SECONDS = 0.95, 90
IDLE = 20  # so many times its processor time, a mutant waits for what never comes
OUT_OF_TIME = -signal.SIGXCPU
FATES = {
    SURVIVED: "survived",
    KILLED: "killed",
    OUT_OF_TIME: "timeout",
    -signal.SIGKILL: "timeout",
    -signal.SIGSEGV: "killed",
    -signal.SIGABRT: "killed",
}


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
    parser.add_argument("--seconds", type=int, default=SECONDS, help="processor time for one mutant")
    parser.add_argument("--minutes", type=float, default=24 * 60, help="start no mutant after so many minutes")
    parser.add_argument(
        "--record", action="store_true", help="first record which tests reach which line: later runs are quicker"
    )
    parser.add_argument("files", nargs="*", help="files or patterns, from the project's folder; none: the trusted base")
    options = parser.parse_args()
    if options.record and (code := record()):
        return code
    drawn = draw(options.files, options.sample, options.seed)
    if not drawn:
        print("no mutant of these files", file=sys.stderr)
        return 2
    file = drawn[0][0]
    if (fate := fate_of((file, Mutant(UNCHANGED, 0, "", "")), options.seconds).fate) != "survived":
        print(f"{file}: the selection fails without a mutant ({fate}; --seconds {options.seconds})", file=sys.stderr)
        return 2
    until = time.monotonic() + 60 * options.minutes
    with ThreadPoolExecutor(options.jobs) as pool:
        fates = [
            tell(fate) for fate in pool.map(lambda pair: fate_of(pair, options.seconds, until), drawn) if fate.fate
        ]
    return report(fates)


def tell(fate: Fate) -> Fate:
    """Print a survivor as soon as it is known."""
    if fate.fate == "survived":
        mutant = fate.mutant
        print(f"{fate.file}:{mutant.line}: {mutant.kind} (mutant {mutant.index}): {mutant.words}", flush=True)
    return fate


def draw(patterns: list[str], sample: int, seed: int) -> list[tuple[str, Mutant]]:
    """Return the mutants of the files that are named, or a sample of them in a random order."""
    named = sorted({str(path.relative_to(ROOT)) for pattern in patterns for path in ROOT.glob(pattern)})
    files = named if patterns else trusted_files()
    found = [(file, mutant) for file in files for mutant in mutants_of((ROOT / file).read_text("utf-8"))]
    return Random(seed).sample(found, min(sample, len(found))) if sample else found


def fate_of(drawn: tuple[str, Mutant], seconds: int, until: float = math.inf) -> Fate:
    """Return what becomes of a mutant in a process of its own; nothing where the time is up."""
    file, mutant = drawn
    if time.monotonic() > until:
        return Fate(file, mutant, "")
    command = [sys.executable, "-m", "tests.mutation.source.run", file, str(mutant.index), str(seconds)]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        code = subprocess.run(
            command, cwd=ROOT, env=environment, capture_output=True, timeout=IDLE * seconds
        ).returncode
    except subprocess.TimeoutExpired:
        code = OUT_OF_TIME
    return Fate(file, mutant, FATES[code])


def report(fates: list[Fate]) -> int:
    """Print the share that is killed by file and in all; return 1 where it is less than wanted."""
    print(f"\n{'file':50}{'mutants':>8}{'killed':>8}{'timeout':>9}{'survived':>10}")
    for file in sorted({fate.file for fate in fates}):
        counts = Counter(fate.fate for fate in fates if fate.file == file)
        print(f"{file:50}{counts.total():8}{counts['killed']:8}{counts['timeout']:9}{counts['survived']:10}")
    share = sum(fate.fate != "survived" for fate in fates) / len(fates)
    print(f"{len(fates)} mutants, {100 * share:.1f} % killed")
    return 0 if share >= WANTED else 1


if __name__ == "__main__":
    sys.exit(main())
