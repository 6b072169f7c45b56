"""Print the labelled displays with our verdicts beside the labels: `python -m tests.labelled`.

Exit code 1 if a verdict is wrong that is not on the list of what is not yet right (not_yet.txt), or one on it is mended, or
another thing is said of a display than is on record (verdicts.txt).
"""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from collections.abc import Sequence

from tests.labelled.cases import DECIDED, FALSE_PASS, FALSE_REFUTATION, FILES, UNDECIDED, load_cases
from tests.labelled.faults import (
    Fault,
    faults_of_cases,
    faults_of_pages,
    judged_cases,
    mended,
    read_not_yet,
    unexpected,
)
from tests.labelled.faults import write_not_yet as rewrite
from tests.labelled.judging import Judged, judge_all
from tests.labelled.pages import STRICT, load_pages
from tests.labelled.record import differences, pages_that_differ, read_record, write_record, write_record_of_pages


def main() -> int:
    """Print the table and the totals; return the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tests.labelled", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--faults", action="store_true", help="only the verdicts that the labels do not allow")
    parser.add_argument("--totals", action="store_true", help="only the totals")
    parser.add_argument("--about", default="", help="judge only the groups whose name holds this: no pages, no totals")
    parser.add_argument("--page", default="", help="print a page of that name, the attack and its true twin")
    parser.add_argument(
        "--update", action="store_true", help="take out of not_yet.txt what is mended, and write verdicts.txt anew"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes")
    options = parser.parse_args()
    if options.page:
        return print_page(options.page)
    if options.about:
        return print_about(options.about, options.faults, options.jobs)
    cases = judged_cases(options.jobs)
    faults = (*faults_of_cases(options.jobs), *faults_of_pages())
    if not options.totals:
        print_cases(cases, options.faults)
        print_pages(faults_of_pages())
    print_totals(cases)
    return max(compare(faults, options.update), compare_record(cases, options.update))


def print_about(about: str, only_faults: bool, jobs: int) -> int:
    """Print the displays of the groups of that name; return 1 where one has a fault, or another thing is said than is on record."""
    cases = judge_all([case for case in load_cases() if about in case.about], jobs)
    print_cases(cases, only_faults)
    found = differences(cases, read_record())
    print("".join(f"\nanother thing is said than is on record: {line}" for line in found), end="\n" * bool(found))
    return 1 if found or any(judged.fault for judged in cases) else 0


def print_cases(cases: Sequence[Judged], only_faults: bool) -> None:
    """Print one line a display: label, our verdict, the fault if there is one, the display."""
    about = ""
    for judged in cases:
        if only_faults and not judged.fault:
            continue
        if judged.case.about != about:
            about = judged.case.about
            print(f"\n{about}")
        print(
            f"  {judged.case.label:7} {judged.verdict:11} {judged.fault:17} {judged.case.reads}: {judged.case.one_line}"
        )


def print_pages(faults: Sequence[Fault]) -> None:
    """Print the faults of whole pages."""
    print(f"\npages: {len(faults)} faults")
    for fault in faults:
        print(f"  {fault.where:45} {fault.kind:17} {fault.said}")


def print_totals(cases: Sequence[Judged]) -> None:
    """Print false passes, false refutations and what was decided, for each file and for the pages."""
    print(f"\n{'':16}{'displays':>9}{FALSE_PASS:>13}{FALSE_REFUTATION:>18}{'right, decided':>16}{'other':>7}")
    for file in FILES:
        judged = [j for j in cases if j.case.file == file]
        kinds = Counter(j.fault for j in judged)
        right = [j for j in judged if j.case.label == "right"]
        decided = sum(j.verdict in DECIDED for j in right)
        other = len(judged) - kinds[""] - kinds[FALSE_PASS] - kinds[FALSE_REFUTATION] - kinds[UNDECIDED]
        share = f"{decided} of {len(right)}"
        print(f"{file:16}{len(judged):9}{kinds[FALSE_PASS]:13}{kinds[FALSE_REFUTATION]:18}{share:>16}{other:7}")
    pages, found = load_pages(), Counter((f.where.rpartition("(")[2][:-1], f.kind) for f in faults_of_pages())
    count = Counter(page.kind for page in pages)
    false = sum(len(page.false) for page in pages)
    print(f"{count['attack']} attacks: {found['attack', STRICT]} pass --strict; ", end="")
    print(f"{found['attack', FALSE_PASS]} of {false} false displays pass")
    print(f"{count['twin']} true twins: {found['twin', FALSE_REFUTATION]} displays refuted")
    refuted, unread = found["stranger", FALSE_REFUTATION], found["stranger", "unread"]
    print(f"{count['stranger']} pages of strangers: {refuted} displays refuted, {unread} unreadable")


def compare(faults: Sequence[Fault], update: bool) -> int:
    """Hold the faults against the list; return the exit code."""
    listed = read_not_yet()
    new, gone = unexpected(faults, listed), mended(faults, listed)
    print(f"{len(listed)} are not yet right; {len(gone)} of them are mended, {len(new)} are new")
    for fault in new:
        print(f"  {fault.line}")
    if update and not new:
        rewrite(faults)
    return 1 if new or (gone and not update) else 0


def compare_record(judged: Sequence[Judged], update: bool) -> int:
    """Hold what is said against the record, or write it anew; return the exit code."""
    found, pages = differences(judged, read_record()), pages_that_differ()
    print(f"of {len(found)} displays and {len(pages)} pages another thing is said than is on record")
    for line in (*found, *pages):
        print(f"  {line}")
    if update:
        write_record(judged)
        write_record_of_pages()
    return 1 if (found or pages) and not update else 0


def print_page(name: str) -> int:
    """Print the pages of that name; return 1 where there is none."""
    pages = [page for page in load_pages() if page.name == name]
    for page in pages:
        print(f"===== {page.kind}\n{page.text}")
    return 0 if pages else 1


if __name__ == "__main__":
    sys.exit(main())
