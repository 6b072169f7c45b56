"""Run the mutation sweep, the equivalent rewrites and the test of the diagnosis: `python -m tests.mutation`.

Exit code 1 if a mutant survives, too many are left open, a rewrite is not proved, or there are too few of either.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

from armproof.verification.running.processes import cores
from tests.mutation import diagnosis, rewrites, sweep
from tests.mutation.place import handouts

FEWEST_MUTANTS = 5000
FEWEST_REWRITES = 2000
MOST_CAUSES = 10  # that are printed
MOST_OPEN = (
    0.15  # of the mutants: beside words that suppose, ask or name a posture, and where a name means something else
)
Results = tuple[list[sweep.Trial], list[rewrites.Answer], list[diagnosis.Diagnosis]]


def main() -> int:
    """Print the counts by kind and every failure; return the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutation", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seed", type=int, default=2019, help="another seed changes other cells")
    parser.add_argument("--jobs", type=int, default=cores(), help="processes")
    parser.add_argument("documents", nargs="*", type=Path, help="documents; by default all handouts")
    options = parser.parse_args()
    paths = sorted(options.documents or handouts(), key=lambda path: -path.stat().st_size)  # the largest first
    started = time.perf_counter()
    with ProcessPoolExecutor(options.jobs) as pool:
        parts = list(pool.map(partial(_examine, seed=options.seed), [path.resolve() for path in paths]))
    trials = [trial for part in parts for trial in part[0]]
    answers = [answer for part in parts for answer in part[1]]
    diagnoses = [found for part in parts for found in part[2]]
    enough = bool(options.documents) or (len(trials) >= FEWEST_MUTANTS and len(answers) >= FEWEST_REWRITES)
    passed = [report_mutants(trials), report_rewrites(answers), enough]
    report_diagnoses(diagnoses)
    print(f"\n{len(paths)} documents, seed {options.seed}, {time.perf_counter() - started:.0f} s")
    if not enough:
        print(f"too few: at least {FEWEST_MUTANTS} mutants and {FEWEST_REWRITES} rewrites are wanted")
    return 0 if all(passed) else 1


def _examine(path: Path, seed: int) -> Results:
    return list(sweep.sweep(path, seed)), list(rewrites.answers(path, seed)), list(diagnosis.diagnoses(path, seed))


def report_mutants(trials: list[sweep.Trial]) -> bool:
    """Print what became of the mutants, and why some are left open; return whether none survived and few are open."""
    fates = (sweep.REFUTED, sweep.IDENTICAL, sweep.OPEN, sweep.UNTOLD, sweep.SURVIVED, sweep.FALSE_ALARM)
    _table(
        f"{len(trials)} mutants of proved equations",
        "kind of slip",
        [t.kind for t in trials],
        {f: [t.kind for t in trials if t.fate == f] for f in fates},
    )
    _failures(
        [trial for trial in trials if trial.fate in (sweep.UNTOLD, sweep.SURVIVED, sweep.FALSE_ALARM)],
        lambda t: f"{t.where}: {t.fate}, {t.verdict}: {t.kind}, {t.words}: {t.text} ({t.message})",
    )
    left_open = [trial for trial in trials if trial.fate == sweep.OPEN]
    for cause, count in Counter(trial.message for trial in left_open).most_common(MOST_CAUSES):
        print(f"  left open, {count}: {cause[:200]}")
    refuted, wrong = (
        sum(trial.fate in those for trial in trials)
        for those in ((sweep.REFUTED,), (sweep.REFUTED, sweep.OPEN, sweep.SURVIVED))
    )
    print(f"refuted: {_percent(refuted, wrong)} of those that are not proved identical")
    failed = any(trial.fate in (sweep.SURVIVED, sweep.FALSE_ALARM) for trial in trials)
    return not failed and len(left_open) <= MOST_OPEN * wrong


def report_rewrites(answers: list[rewrites.Answer]) -> bool:
    """Print the verdicts of the rewrites; return whether all are proved."""
    kinds = {"proved": [a.kind for a in answers if a.proved], "not proved": [a.kind for a in answers if not a.proved]}
    _table(
        f"\n{len(answers)} equivalent rewrites of proved equations", "kind of rewrite", [a.kind for a in answers], kinds
    )
    failures = [answer for answer in answers if not answer.proved]
    _failures(failures, lambda a: f"{a.where}: {a.verdict}: {a.kind}: {' '.join(a.latex.split())} ({a.message})")
    print(f"proved: {_percent(len(answers) - len(failures), len(answers))}")
    return not failures


def report_diagnoses(found: list[diagnosis.Diagnosis]) -> None:
    """Print how many slips the report located, put into words and mended."""
    marks = {
        "located": [d.kind for d in found if d.located],
        "in words": [d.kind for d in found if d.named],
        "mended": [d.kind for d in found if d.mended],
    }
    _table(
        f"\n{len(found)} slips of one cell, as the report tells them", "kind of slip", [d.kind for d in found], marks
    )
    failures = [d for d in found if not (d.located and d.mended)]
    _failures(failures, lambda d: f"{d.where}: {d.kind}, {d.words}: {' '.join(d.text.split())} ({d.message})")
    print(f"located and mended: {_percent(len(found) - len(failures), len(found))}")


def _table(title: str, first: str, all_kinds: list[str], columns: dict[str, list[str]]) -> None:
    counts = {name: Counter(kinds) for name, kinds in columns.items()}
    total = Counter(all_kinds)
    width = max(map(len, [first, *total]))
    print(f"{title}\n  {first:<{width}}  {'all':>6}" + "".join(f"  {name:>{max(8, len(name))}}" for name in counts))
    for kind in [*sorted(total), ""]:
        row = [sum(count.values()) if not kind else count[kind] for count in (total, *counts.values())]
        cells = "".join(f"  {number:>{max(8, len(name))}}" for name, number in zip(counts, row[1:], strict=True))
        print(f"  {kind or 'together':<{width}}  {row[0]:>6}{cells}")


def _failures(failures: list, describe: Callable[..., str]) -> None:
    for failure in failures:
        print(f"  {describe(failure)[:400]}")


def _percent(part: int, whole: int) -> str:
    return f"{part} of {whole}, {100 * part / max(whole, 1):.2f} %"


if __name__ == "__main__":
    sys.exit(main())
