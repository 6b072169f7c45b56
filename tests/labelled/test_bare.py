"""Documents without front matter: nothing true is refuted, nothing false passes, and most of them is decided."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache

import pytest

from armproof.verification.verdict import DocumentResult
from tests.labelled.bare import Bare, load
from tests.labelled.cases import DECIDED, PASSES
from tests.labelled.judging import said_of_document
from tests.labelled.record import read_record_of_pages
from tests.laws import SWEEP

DOCUMENTS = load()
TRUE = DOCUMENTS if SWEEP else DOCUMENTS[::2]  # `python -m tests.labelled.bare` reads all documents
MISTAKEN = DOCUMENTS if SWEEP else DOCUMENTS[::4]  # and makes all their mistakes


@lru_cache
def result(document: Bare) -> DocumentResult:
    return document.verify()


def verdicts(document: Bare) -> list[tuple[int, str]]:
    return [(record.line, record.verdict.value) for record in result(document).equations]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda one: one.path.name)
def test_what_is_said_of_a_document_is_what_is_on_record(document: Bare):
    assert said_of_document(result(document)) == read_record_of_pages()[document.path.name]


@pytest.mark.parametrize("document", TRUE, ids=lambda one: one.path.name)
def test_nothing_true_is_refuted(document: Bare):
    assert "refuted" not in [verdict for _, verdict in verdicts(document)]


@pytest.mark.parametrize("document", MISTAKEN, ids=lambda one: one.path.name)
def test_a_mistake_does_not_pass(document: Bare):
    number, line, _ = list(document.mistakes)[-1]
    found = {record.verdict.value for record in document.verify(number).equations if record.line == line}
    assert found and not found & set(PASSES)


def test_most_claims_are_decided():
    claims = [v for document in TRUE for line, v in verdicts(document) if line not in document.data]
    decided = sum(Counter(claims)[verdict] for verdict in DECIDED)
    assert decided >= 0.9 * len(claims) > 90


def test_a_mistake_stands_where_its_marks_are():
    document = next(one for one in DOCUMENTS if one.path.name == "planar.md")
    first, *_ = document.mistakes
    assert first == (0, 9, (1, 2))
    assert "«" not in document.text() and document.text(0) != document.text()
