"""What we say of each labelled display, on record: whoever changes the engine sees in the diff what that changes.

A label allows several verdicts, so that a right equation that is no longer decided, or a name that is read otherwise, breaks
none. Here it shows. `python -m tests.labelled --update` writes the record anew; each line that it changes is to be looked at.
"""

from __future__ import annotations

from collections.abc import Iterable

from tests.labelled.cases import HERE, Case
from tests.labelled.judging import Judged

RECORD = HERE / "verdicts.txt"
HEADER = (
    "# What we say of each display of displays.yaml; see record.py. Written by `python -m tests.labelled --update`.\n"
)


def read_record() -> dict[str, str]:
    """Return the record: key of a display → what is said of it."""
    lines = [line for line in RECORD.read_text("utf-8").splitlines() if not line.startswith("#")]
    return {line[:8]: line[10:] for line in lines}


def write_record(judged: Iterable[Judged]) -> None:
    """Write the record anew."""
    RECORD.write_text(HEADER + "".join(f"{j.case.key}  {j.said}\n" for j in judged if is_kept(j.case)), "utf-8")


def is_kept(case: Case) -> bool:
    """Whether what is said of a display is kept; of the spellings, which are many and alike, it is not."""
    return case.file == "displays.yaml"


def differences(judged: Iterable[Judged], record: dict[str, str]) -> list[str]:
    """Return a line for each display of which another thing is said than is on record."""
    return [
        f"{j.case.one_line}: {j.said}; on record: {record.get(j.case.key, 'nothing')}"
        for j in judged
        if is_kept(j.case) and record.get(j.case.key) != j.said
    ]
