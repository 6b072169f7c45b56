"""Mutants of the trusted base against the tests that speak of it: `python -m tests.mutation.source [--sample N] [FILE…]`.

The trusted base is what can make a false equation pass. A mutant that no test kills is either harmless (the same verdicts,
a slower way) or a missing test. Exit code 1 if fewer are killed than wanted, 2 if the selection fails without a mutant.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections import Counter
from functools import partial
from random import Random

import pytest

from tests.mutation.source.exchange import load
from tests.mutation.source.fates import SURVIVED, Fate
from tests.mutation.source.mutants import Mutant, mutants_of
from tests.mutation.source.reach import QUIETLY, TESTS, record
from tests.mutation.source.trials import Trials
from tests.mutation.source.trusted import ROOT, trusted_files

WANTED, SECONDS = 0.95, 30


def main() -> int:
    """Print what survives and the share of each file that is killed; return the exit code."""
    options = _parser().parse_args()
    if options.record and (code := record(options.jobs)):
        return code
    drawn = draw(options.files, options.sample, options.seed)
    if not drawn:
        print("no mutant of these files", file=sys.stderr)
        return 2
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # a copy has no threads, and would wait for them
    until = time.monotonic() + 60 * options.minutes
    trials = Trials(load(), drawn, options.seconds, options.jobs, until, partial(tell, every=options.verbose))
    code = pytest.main([*QUIETLY, *TESTS], plugins=[trials])
    return report(trials.fates) if code == pytest.ExitCode.OK else 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m tests.mutation.source", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--sample", type=int, default=0, help="so many mutants, drawn at random; 0: all")
    parser.add_argument("--seed", type=int, default=2019)
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--seconds", type=int, default=SECONDS, help="processor time of a test that meets a mutant")
    parser.add_argument("--minutes", type=float, default=24 * 60, help="start no mutant after so many minutes")
    parser.add_argument("--verbose", action="store_true", help="tell what is killed, too, and by which test")
    parser.add_argument(
        "--record", action="store_true", help="first record which tests reach which line: later runs are quicker"
    )
    parser.add_argument("files", nargs="*", help="files or patterns, from the project's folder; none: the trusted base")
    return parser


def tell(fate: Fate, every: bool = False) -> Fate:
    """Print a survivor as soon as it is known, or every mutant."""
    if every or fate.fate == SURVIVED:
        mutant, way = fate.mutant, " (imported)" * fate.imported
        by = f"{fate.fate}{way} {fate.by} " * every
        print(f"{by}{fate.file}:{mutant.line}: {mutant.kind} (mutant {mutant.index}): {mutant.words}", flush=True)
    return fate


def draw(patterns: list[str], sample: int, seed: int) -> list[tuple[str, Mutant]]:
    """Return the mutants of the files that are named, or a sample of them in a random order."""
    named = sorted({str(path.relative_to(ROOT)) for pattern in patterns for path in ROOT.glob(pattern)})
    files = named if patterns else trusted_files()
    found = [(file, mutant) for file in files for mutant in mutants_of((ROOT / file).read_text("utf-8"))]
    return Random(seed).sample(found, min(sample, len(found))) if sample else found


def report(fates: list[Fate]) -> int:
    """Print the share that is killed by file and in all; return 1 where it is less than wanted."""
    print(f"\n{'file':50}{'mutants':>8}{'killed':>8}{'timeout':>9}{'survived':>10}{'imported':>10}")
    for file in sorted({fate.file for fate in fates}):
        counts = Counter(fate.fate for fate in fates if fate.file == file)
        slow = sum(fate.imported for fate in fates if fate.file == file)
        print(f"{file:50}{counts.total():8}{counts['killed']:8}{counts['timeout']:9}{counts['survived']:10}{slow:10}")
    share = sum(fate.fate != SURVIVED for fate in fates) / len(fates)
    print(f"{len(fates)} mutants, {100 * share:.1f} % killed")
    return 0 if share >= WANTED else 1


if __name__ == "__main__":
    sys.exit(main())
