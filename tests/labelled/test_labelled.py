"""Our verdicts against the labels; what is not yet right stands in not_yet.txt, which can only shrink.

Of the displays every twelfth one of each kind and label is judged, the rest in `make test-rest`; `python -m tests.labelled` judges them all.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache

import pytest

from tests.labelled import bare
from tests.labelled.cases import ALLOWED, FALSE_PASS, FALSE_REFUTATION, UNDECIDED, Case, drawn, load_cases
from tests.labelled.faults import Fault, faults_among, faults_of_pages, mended, read_not_yet, unexpected
from tests.labelled.judging import Judged, judge_all, said_of_document
from tests.labelled.pages import Page, load_pages
from tests.labelled.record import differences, is_kept, read_record, read_record_of_pages
from tests.laws import SWEEP

DRAWN = drawn(load_cases("displays.yaml"), 12)


@cache
def judged() -> list[Judged]:
    """Return our verdicts on the displays; the spellings have a file of their own, for another worker."""
    return judge_all(DRAWN)


@cache
def all_faults() -> tuple[Fault, ...]:
    """Return those of the displays and pages."""
    return (*faults_among(judged()), *faults_of_pages())


def test_what_is_said_is_what_is_on_record():
    found = differences(judged(), read_record())
    assert not found, "\n".join(["look at each, then write the record anew: python -m tests.labelled --update", *found])


@pytest.mark.parametrize("page", load_pages(), ids=lambda page: page.title)
def test_what_is_said_of_a_page_is_what_is_on_record(page: Page):
    assert said_of_document(page.result) == read_record_of_pages()[page.title]


def test_a_case_that_left_is_no_more_on_record():
    assert set(read_record()) == {case.key for case in load_cases() if is_kept(case)}
    names = [*(page.title for page in load_pages()), *(document.path.name for document in bare.load())]
    assert sorted(read_record_of_pages()) == sorted(names)


def test_another_reading_and_another_verdict_are_noticed():
    one = judged()[0]
    record = {one.case.key: one.said}
    assert not differences([one], record)
    assert differences([replace(one, said=f"{one.said} of frame 1")], record)
    assert differences([one], {})


def test_no_verdict_is_wrong_that_is_not_on_the_list():
    found = unexpected(all_faults(), read_not_yet())
    assert not found, "\n".join(f"{fault.line} ({fault.message})" for fault in found)


def test_what_is_mended_has_left_the_list():
    left = {case.key for case in load_cases()} - {case.key for case in DRAWN}
    found = mended(all_faults(), {key: kind for key, kind in read_not_yet().items() if key not in left})
    assert not found, f"mended: {', '.join(found)}; `python -m tests.labelled --update` takes them out"


def test_what_is_drawn_has_each_label_of_each_kind_of_trap():
    cases = load_cases("displays.yaml")
    some, rest = (drawn(cases, 12, part) for part in ("some", "rest"))
    kinds = [{(case.about, case.front, case.label) for case in chosen} for chosen in (some, cases)]
    assert kinds[0] == kinds[1] and len(kinds[0]) > 100
    assert len(some) >= 500 and (SWEEP or len(some) + len(rest) == len(cases))


def test_a_fault_that_is_not_listed_or_worse_than_listed_is_noticed():
    fault = Fault("00000000", FALSE_REFUTATION, "", "")
    assert unexpected([fault], {}) == [fault]
    assert unexpected([fault], {fault.key: UNDECIDED}) == [fault]
    assert not unexpected([fault], {fault.key: FALSE_REFUTATION})
    assert mended([fault], {fault.key: UNDECIDED, "ffffffff": FALSE_PASS}) == ["ffffffff"]


@pytest.mark.parametrize(
    ("label", "verdict", "fault"),
    [
        ("right", "proved", ""),
        ("right", "defined", UNDECIDED),
        ("right", "refuted", FALSE_REFUTATION),
        ("right?", "unchecked", ""),
        ("wrong", "refuted", ""),
        ("wrong", "defined", FALSE_PASS),
        ("open", "confirmed", FALSE_PASS),
        ("open", "refuted", FALSE_REFUTATION),
        ("remark", "defined", FALSE_PASS),
        ("data", "defined", ""),
        ("data", "proved", FALSE_PASS),
    ],
)
def test_a_label_allows_its_verdicts_only(label: str, verdict: str, fault: str):
    assert Case("", "", label, "", "x = 1", (), "").fault(verdict) == fault


def test_the_set_is_large_and_each_case_stands_in_it_once():
    cases, pages = load_cases(), Counter(page.kind for page in load_pages())
    assert set(ALLOWED) == {case.label for case in cases}
    assert min(Counter(case.file for case in cases).values()) >= 200
    assert len({case.key for case in cases}) == len(cases)
    assert pages["attack"] == pages["twin"] >= 40 and pages["stranger"] >= 12
    assert all(page.false for page in load_pages() if page.kind == "attack")
