"""Put every erratum of the handouts back in place of the right equation, correct the copy, and count what verifies.

    python -m tests.sweeps.correct

Of each handout: one copy with all its errata put back, and one for each of them. An erratum takes the place of the right
equation above it with the same left side; where there is none it becomes an equation of the text where it stands.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import armproof.course
from armproof.verification.document import Display, Document, find_documents, parse_document
from armproof.verification.document.rewriting import Change, change_of, rewrite
from armproof.verification.running.corrected_copy import CorrectedCopy, correct_text
from armproof.verification.verdict import Record, Verdict

HANDOUTS = Path(armproof.course.__path__[0]) / "handouts"
CELL = re.compile(r"&|\\\\")


@dataclass
class Count:
    """What came of the copies."""

    copies: int = 0
    clean: int = 0
    put_back: int = 0
    refuted: int = 0  # displays of the copies before correction
    corrected: int = 0
    as_before: int = 0  # the erratum's display is the right one again, to the letter
    cells_changed: int = 0
    cells_right: int = 0  # changed though nothing was wrong in them
    failures: list[str] = field(default_factory=list)


def main() -> int:
    """Sweep the handouts, print the numbers; 0 if every copy verifies clean."""
    count = Count()
    for path in find_documents([HANDOUTS]):
        for name, text, number in copies(path):
            examine(path, name, text, number, count)
    print(
        f"{count.put_back} errata put back in {count.copies} copies; {count.put_back - count.refuted} define a name anew there"
    )
    print(f"{count.clean} of {count.copies} copies verify clean after `armproof correct`")
    print(
        f"{count.corrected} of {count.refuted} refuted displays corrected, {count.as_before} to the letter of the right one"
    )
    print(f"{count.cells_changed} cells changed, {count.cells_right} of them right before")
    for failure in count.failures:
        print(failure)
    return 0 if count.clean == count.copies and not count.cells_right else 1


def copies(path: Path) -> Iterator[tuple[str, str, int]]:
    """Yield the copies of a handout with its errata put back, all of them, then one at a time: name, text, how many."""
    text = path.read_text(encoding="utf-8")
    document = parse_document(path, text)
    errata = [k for k, display in enumerate(document.displays) if display.erratum]
    if errata:
        yield "all", with_errata(document, text, errata), len(errata)
    if len(errata) > 1:
        for erratum in errata:
            yield f"line {document.displays[erratum].line}", with_errata(document, text, errata, erratum), 1


def with_errata(document: Document, text: str, errata: Sequence[int], only: int | None = None) -> str:
    """Return a handout's text with its errata, or only one of them, in the place of the right equations."""
    taken: set[int] = set()
    changes: list[Change] = []
    lines = text.split("\n")
    for erratum in errata:
        wrong = document.displays[erratum]
        right = right_display(document.displays, erratum, taken)
        first, last = quote_around(lines, wrong.line - 1)
        if only not in (None, erratum):
            put = ""  # the quote goes in any case: it may rest on what the right equation defines
        elif right is None:
            put = f"$$ {' '.join(wrong.latex.split())} $$"
        else:
            taken.add(right)
            put = ""
            display = document.displays[right]
            change = change_of(display, *edges(display.latex), wrong.latex.strip(), in_notebook=False)
            assert change is not None
            changes.append(change)
        changes.append(Change((first + 1, 0), (last + 1, len(lines[last])), put))
    return rewrite(".md", text, changes)


def edges(latex: str) -> tuple[int, int]:
    """Return where a display's LaTeX begins and ends without the blanks around it."""
    return len(latex) - len(latex.lstrip()), len(latex.rstrip())


def right_display(displays: Sequence[Display], erratum: int, taken: set[int]) -> int | None:
    """Return the nearest equation above an erratum that is about the same: their left sides are one."""
    wanted = left_side(displays[erratum].latex)
    for k in range(erratum - 1, -1, -1):
        if not displays[k].erratum and k not in taken and left_side(displays[k].latex) == wanted:
            return k
    return None


def left_side(latex: str) -> str:
    return re.sub(r"\\math\w+|[\s{}]|\\left|\\right", "", re.split(r"=|\\neq", latex)[0])


def quote_around(lines: Sequence[str], row: int) -> tuple[int, int]:
    """Return the first and the last row of the block quote that holds a row."""
    first = last = row
    while first > 0 and lines[first - 1].lstrip().startswith(">"):
        first -= 1
    while last + 1 < len(lines) and lines[last + 1].lstrip().startswith(">"):
        last += 1
    return first, last


def examine(path: Path, name: str, text: str, number: int, count: Count) -> None:
    """Correct one copy and count what came of it."""
    before = parse_document(path, text)
    copy = correct_text(path, text)
    refuted = [record for record in copy.first.equations if record.verdict is Verdict.REFUTED]
    after = parse_document(path, copy.after)
    original = [display.latex.split() for display in parse_document(path, path.read_text(encoding="utf-8")).displays]
    pairs = {
        k: (old, new)
        for k, (old, new) in enumerate(zip(before.displays, after.displays, strict=True))
        if old.latex != new.latex
    }
    count.copies += 1
    count.put_back += number
    count.refuted += len(refuted)
    count.corrected += len(pairs)
    count.as_before += sum(new.latex.split() in original for _, new in pairs.values())
    records = {record.line: record for record in refuted}
    for old, new in pairs.values():
        changed, right = cells(old, new, records.get(old.line))
        count.cells_changed += changed
        count.cells_right += right
        if right:
            count.failures.append(f"  {path.name} ({name}): line {old.line}: {right} right cells changed")
    if copy.remaining or text_outside(copy, before, after):
        count.failures.extend(
            f"  {path.name} ({name}): line {record.line}: {record.verdict.value}: {record.message}\n      {record.latex}"
            for record in copy.remaining
        )
    else:
        count.clean += 1


def cells(old: Display, new: Display, record: Record | None) -> tuple[int, int]:
    """Return how many cells a correction changed, and how many of them nothing was wrong in."""
    a, b = CELL.split(old.latex), CELL.split(new.latex)
    if len(a) != len(b):
        return 1, 0  # a whole matrix, of another size
    changed = [k for k in range(len(a)) if a[k].split() != b[k].split()]
    if record is None or not all(entry.span for entry in record.entries) or not record.entries:
        return len(changed), 0
    wrong = {len(CELL.findall(old.latex, 0, entry.span[0])) for entry in record.entries if entry.span}
    return len(changed), sum(k not in wrong for k in changed)


def text_outside(copy: CorrectedCopy, before: Document, after: Document) -> bool:
    """Whether anything but the displays was changed."""
    texts = []
    for text, document in ((copy.before, before), (copy.after, after)):
        for display in sorted(document.displays, key=lambda display: -len(display.latex)):
            text = text.replace(display.latex, "")
        texts.append(text)
    return texts[0].split() != texts[1].split()


if __name__ == "__main__":
    sys.exit(main())
