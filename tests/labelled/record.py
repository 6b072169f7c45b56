"""What we say of each labelled display and page, on record: whoever changes the engine sees in the diff what that changes.

A label allows several verdicts, so that a right equation that is no longer decided, or a name that is read otherwise, breaks
none. Here it shows. `python -m tests.labelled --update` writes the records anew; each line that it changes is to be looked at.
"""

from __future__ import annotations

import gc
from collections.abc import Iterable, Iterator
from functools import lru_cache

from tests.labelled import bare
from tests.labelled.cases import HERE, Case
from tests.labelled.judging import Judged, said_of_document
from tests.labelled.pages import HEAD, load_pages

RECORD, OF_PAGES = HERE / "verdicts.txt", HERE / "verdicts_of_pages.txt"
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


@lru_cache
def read_record_of_pages() -> dict[str, str]:
    """Return the record of the pages: name of a page → what is said of it."""
    _, *parts = HEAD.split(OF_PAGES.read_text("utf-8"))
    return dict(zip(parts[::2], parts[1::2], strict=True))


def said_of_pages() -> Iterator[tuple[str, str]]:
    """Yield what is said of each attack, of its true twin, of the strangers' pages and of the documents without front matter."""
    gc.freeze()  # what was judged before is no garbage: to look through it would take the time of a page
    for page in load_pages():
        yield page.title, said_of_document(page.result)
    for document in bare.load():
        yield document.path.name, said_of_document(document.verify())


def pages_that_differ() -> list[str]:
    """Return the names of the pages of which another thing is said than is on record."""
    said, record = dict(said_of_pages()), read_record_of_pages()
    return sorted(name for name in {*said, *record} if said.get(name) != record.get(name))


def write_record_of_pages() -> None:
    """Write the record of the pages anew."""
    text = "".join(f"===== {name}\n{said}" for name, said in said_of_pages())
    OF_PAGES.write_text("# What we say of each page; see record.py.\n" + text, "utf-8")
