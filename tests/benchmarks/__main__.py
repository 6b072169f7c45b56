"""Print the benchmarks: `python -m tests.benchmarks`. Times depend on the machine, ratios are measured in one run."""

from __future__ import annotations

import argparse
import platform
import statistics
from importlib.metadata import version

from armproof.verification.running.processes import cores
from tests.benchmarks import bulk, cluster, documents, editing, functions, hands_on, rx90, with_sympy

MEGABYTE = 1_000_000
ROUNDS = 7
Row = tuple[str, str, str]


def main() -> None:
    """Print every figure with its target."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--sympy-seconds", type=float, default=120.0, help="how long each simplification may take")
    parser.add_argument("--no-sympy", action="store_true", help="leave SymPy out")
    parser.add_argument("--documents", type=int, default=1000, help="how many a Dask cluster checks")
    options = parser.parse_args()
    print(f"Python {platform.python_version()}, Drake {version('drake')}, {cores()} cores\n")
    ours = time_rx90()
    print_rx90(ours)
    if not options.no_sympy:
        print_sympy(ours, options.sympy_seconds)
    print_bulk()
    _print("Functions checked, after the first check", functions.rows())
    _print("Hands on: from a slider's value to the new picture, median", hands_on.rows())
    print_course()
    print_growth()
    print_handouts()
    print_editing()
    print_cluster(options.documents)


def time_rx90() -> rx90.Times:
    """Return the median of several rounds, each with the arm loaded afresh, after one that warms up."""
    claims = rx90.read_claims()
    rx90.measure(claims)
    rounds = [rx90.measure(claims) for _ in range(ROUNDS)]
    return rx90.Times(
        *(statistics.median(getattr(one, name) for one in rounds) for name in rx90.Times.__dataclass_fields__)
    )


def print_rx90(times: rx90.Times) -> None:
    """Print what the RX-90 takes, step by step."""
    rows = [
        ("load the URDF and its card", _ms(times.load), ""),
        ("read the LaTeX of the claims", _ms(times.read), ""),
        ("trace pose and Jacobian", _ms(times.trace), ""),
        ("prove 12 entries of the pose", _ms(times.pose), ""),
        ("prove 36 entries of the Jacobian", _ms(times.jacobian), ""),
        ("read, trace and prove 12 + 36 entries", _ms(times.trace_and_prove), "<= 100 ms"),
        ("prove det J", _ms(times.determinant), ""),
        ("evaluate them at 1,000 configurations", _ms(times.samples), ""),
    ]
    _print("RX-90, after imports (median)", rows)


def print_sympy(ours: rx90.Times, timeout: float) -> None:
    """Print the same against sympy.simplify; neither clock holds the reading of the printed formulas."""
    results = {part: with_sympy.simplify_in_subprocess(part, timeout) for part in with_sympy.PARTS}
    traced = ours.trace
    mine = {
        "pose": traced + ours.pose,
        "jacobian": traced + ours.jacobian,
        "determinant": traced + ours.jacobian + ours.determinant,
    }
    rows: list[Row] = []
    for part, result in results.items():
        at_least = "> " if result.stopped else ""
        told = "stopped" if result.stopped else f"{result.equal} of {result.entries} equal"
        rows.append(
            (
                f"{part}: {_ms(mine[part])} against {at_least}{result.seconds:.2f} s ({told})",
                f"{at_least}{result.seconds / mine[part]:,.0f}x",
                "",
            )
        )
    whole = ours.trace + ours.pose + ours.jacobian + ours.determinant
    total = sum(result.seconds for result in results.values())
    at_least = "> " if any(result.stopped for result in results.values()) else ""
    rows.append(
        (f"all three: {_ms(whole)} against {at_least}{total:.2f} s", f"{at_least}{total / whole:,.0f}x", ">= 100x")
    )
    _print(f"RX-90, against sympy.simplify {version('sympy')}", rows)


def print_bulk() -> None:
    """Print what many configurations take, against loops in Python over Drake and Pinocchio."""
    rows: list[Row] = []
    for arm, frame, drake_target, pinocchio_target in (("rx90", "6", ">= 16x", ">= 6x"), ("scara", "4", ">= 35x", "")):
        times = bulk.measure(arm, frame)
        rows.append((f"{arm}: pose and Jacobian of a configuration", f"{1e9 * times.bulk:.0f} ns", ""))
        rows.append((f"  Drake's loop, {1e6 * times.drake:.1f} us", f"{times.drake / times.bulk:.0f}x", drake_target))
        if times.pinocchio is None:
            rows.append(("  Pinocchio's loop: pip install 'armproof[benchmark]'", "", pinocchio_target))
        else:
            ratio = f"{times.pinocchio / times.bulk:.1f}x"
            rows.append((f"  Pinocchio's loop, {1e6 * times.pinocchio:.1f} us", ratio, pinocchio_target))
    rows.append(("rx90: manipulability of 1,000,000 configurations", f"{bulk.time_map():.2f} s", "<= 2 s"))
    _print(f"In bulk ({bulk.BULK:,} configurations), least of {bulk.ROUNDS} rounds on one core", rows)


def print_course() -> None:
    """Print what the command takes on the handouts."""
    documents.run_unwatched()
    seconds = statistics.median(documents.run_unwatched() for _ in range(5))
    watched = documents.run_cold()
    rows = [
        (f"wall clock (exit code {watched.code})", f"{seconds:.2f} s", "<= 2.5 s"),
        ("memory, largest process (RSS)", f"{watched.largest / MEGABYTE:.0f} MB", "<= 400 MB"),
        ("memory, all processes (PSS)", f"{watched.together / MEGABYTE:.0f} MB", ""),
    ]
    _print("armproof verify course/handouts, a cold process", rows)


def print_growth() -> None:
    """Print how the time grows with the length of a document."""
    documents.time_synthetic(50)
    short = statistics.median(documents.time_synthetic(200) for _ in range(3))
    long = documents.time_synthetic(2000)
    rows = [
        ("200 displays", f"{short:.2f} s", ""),
        ("2,000 displays", f"{long:.2f} s", ""),
        ("ratio", f"{long / short:.1f}x", "<= 11x"),
    ]
    _print("A synthetic document", rows)


def print_handouts() -> None:
    """Print what each handout takes in a warm process."""
    times = documents.time_handouts()
    rows = [
        (f"{one.name}, {one.displays} displays", _ms(one.seconds), "")
        for one in sorted(times, key=lambda one: -one.seconds)
    ]
    rows.append(
        (f"together, {sum(one.displays for one in times)} displays", _ms(sum(one.seconds for one in times)), "")
    )
    _print("The handouts, one by one, in a warm process", rows)


def print_editing() -> None:
    """Print how soon the language server answers."""
    times = editing.measure()
    rows = [
        ("the display that is edited", _ms(times.own), "<= 200 ms"),
        ("what depends on it", _ms(times.all), "<= 1000 ms"),
    ]
    _print(f"armproof lsp, display {editing.EDITED} of {editing.DISPLAYS} edited", rows)


def print_cluster(number: int) -> None:
    """Print how a Dask cluster's second worker pays, and what a larger one would have to carry (CONTRIBUTING.md)."""
    found = cluster.measure(number)
    rows = [
        ("one worker", f"{found.one:.1f} s", ""),
        ("two workers", f"{found.two:.1f} s", ""),
        ("efficiency: one / (2 x two)", f"{found.efficiency:.2f}", ">= 0.85"),
        ("a worker's time for a document", _ms(found.one / number), ""),
        ("this process's", _ms(found.client), ""),
        (f"the scheduler's for a task of {cluster.MOST_AT_ONCE}", _ms(found.scheduler), ""),
        ("a document, sent", f"{found.sent:.0f} bytes", ""),
        ("its result", f"{found.received:.0f} bytes", ""),
    ]
    _print(f"armproof verify --scheduler, {number:,} documents of {cluster.DISPLAYS} displays", rows)


def _ms(seconds: float) -> str:
    return f"{1000 * seconds:.1f} ms"


def _print(title: str, rows: list[Row]) -> None:
    width = max(len(row[0]) for row in rows)
    print(title)
    for what, value, target in rows:
        print(f"  {what:<{width}}  {value:>10}" + (f"   target {target}" if target else ""))
    print()


if __name__ == "__main__":
    main()
