"""A plugin of pytest: each labelled display and page, and each document found by search, as a test of its own, that of it is said what is on record.

`make test` and `make test-rest` judge many of them in one test; a mutant meets one at a time, those that reach it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import pytest

from tests.labelled import bare
from tests.labelled.cases import Case, load_cases
from tests.labelled.faults import read_not_yet
from tests.labelled.judging import judge, said_of_document, verify_text
from tests.labelled.pages import Page, load_pages
from tests.labelled.record import differences, is_kept, read_record, read_record_of_pages
from tests.mutation.source.reach import DERIVED, LABELLED
from tests.reached import derived, documents, heard, in_full, kinds


class Labelled(pytest.Item):
    """Fails if another thing is said than is on record."""

    said_as_ever: Callable[[], bool]

    def runtest(self) -> None:
        assert self.said_as_ever()


def pytest_collection_modifyitems(session: pytest.Session, items: list[pytest.Item]) -> None:
    in_full.load()  # once, before any copy of this process
    for name, said_as_ever in labelled():
        item = Labelled.from_parent(session, name=name, nodeid=f"{LABELLED}::{name}")
        item.said_as_ever = said_as_ever
        items.append(item)


def labelled() -> Iterator[tuple[str, Callable[[], bool]]]:
    """Yield each labelled display, page and document, and sentences: a name, and whether the same is said of it as ever."""
    yield from ((case.key, partial(_case, case)) for case in load_cases())
    yield from ((page.title, partial(_page, page)) for page in load_pages())
    yield from ((document.path.name, partial(_bare, document)) for document in bare.load())
    yield from ((document.name, partial(_reached, document)) for document in documents.load())
    yield from ((f"{DERIVED}{name}", partial(_reached, document)) for name, document in derived.load().items())
    yield from ((f"in full {name}", partial(in_full.is_said_as_ever, name)) for name in in_full.read_record())
    yield from ((sentence, partial(heard.is_heard_as_ever, sentence)) for sentence in heard.read_record())
    yield from ((f"kinds {kind}", partial(kinds.is_heard_as_ever, kind)) for kind in kinds.words())


def _case(case: Case) -> bool:
    judged = judge(case)
    if is_kept(case):
        return not differences([judged], read_record())
    return bool(judged.fault) == (case.key in read_not_yet())


def _page(page: Page) -> bool:
    return said_of_document(verify_text(page.text)) == read_record_of_pages()[page.title]


def _bare(document: bare.Bare) -> bool:
    return said_of_document(document.verify()) == read_record_of_pages()[document.path.name]


def _reached(document: documents.Reached) -> bool:
    return document.is_said_as_ever
